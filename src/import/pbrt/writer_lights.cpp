#include <cmath>
#include <limits>

#include "import/pbrt/light_names.h"
#include "import/pbrt/writer_context.h"
#include "scene/desc/models.h"

namespace ajar::pbrt {
namespace {

/// The "conedeltaangle" that the importer turns into exactly this start of the falloff.
float cone_delta(const desc::Node& spot) {
  const float cone_angle = spot.number("cone_angle");
  const float falloff_start = spot.number("falloff_start");
  const auto falloff = [&](float d) {
    return static_cast<float>(static_cast<double>(cone_angle) - static_cast<double>(d));
  };
  const auto delta =
      static_cast<float>(static_cast<double>(cone_angle) - static_cast<double>(falloff_start));
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float d :
       {delta, std::nextafter(delta, kInfinity), std::nextafter(delta, -kInfinity)}) {
    if (falloff(d) == falloff_start) return d;
  }
  return delta;
}

/// Images as pbrt shows them, and the strength of a sky without any.
Substitutes substitutes_of_light(WriterContext& context, const desc::Node& light) {
  Substitutes result;
  if (!light.has("image")) return result;
  const ImageWriter::LightImage image = context.images.for_light(light);
  if (image.file) {
    result["image"] = *image.file;
    result["gray"] = result["decoding_exponent"] = result["projection"] = desc::Value();
  }
  if (image.factor) {
    const char* strength = light.has("radiance") ? "radiance" : "intensity";
    result[strength] = light.color(strength) * *image.factor;
    result["irradiance"] = result["power"] = desc::Value();
  }
  if (light.is("environment") && light.text("image").empty()) {
    if (const float* irradiance = std::get_if<float>(&light.get("irradiance"))) {
      result["radiance"] = light.color("radiance") * (*irradiance / kPi);
      result["irradiance"] = desc::Value();
    }
  }
  return result;
}

/// The light that pbrt has for one that it does not have: of a clear sky, its image.
desc::Node in_pbrt(WriterContext& context, const desc::Node& light) {
  if (!light.is("sky")) return light;
  return desc::light_node("environment", {{"image", context.images.sky(light)}});
}

void write_light(WriterContext& context, const desc::Light& light) {
  const desc::Node node = in_pbrt(context, light.node);
  const ModelName* names = find_ours(light_names(), node.model().name);
  context.out.line("AttributeBegin").line("Transform").matrix(light.to_world);
  context.medium_outside(light.medium);
  context.out.line("LightSource").quoted(names == nullptr ? node.model().name : names->theirs);
  write_parameters(context, node, names, false, substitutes_of_light(context, node));
  if (!(node == light.node)) write_own_words(context, light.node);
  if (node.is("spot")) context.out.parameter("float conedeltaangle", cone_delta(node));
  if (node.is("distant")) {
    context.out.point("from", {0.F, 0.F, 1.F}).point("to", {0.F, 0.F, 0.F});
  }
  context.out.line("AttributeEnd");
}

}  // namespace

void write_lights(WriterContext& context) {
  for (const desc::Light& light : context.scene.lights) write_light(context, light);
}

}  // namespace ajar::pbrt
