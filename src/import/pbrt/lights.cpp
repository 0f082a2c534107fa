#include "import/pbrt/lights.h"

#include <algorithm>
#include <cmath>

#include "import/common/transforms.h"
#include "import/pbrt/light_names.h"
#include "import/pbrt/node_reader.h"
#include "import/pbrt/own_words.h"
#include "os/file_extension.h"
#include "scene/desc/models.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kLightsLeftOut{Effect::Light, "lights are left out"};

constexpr WarningKind kDecoded{
    Effect::Light, "lights have images of integers, which are decoded as sRGB: pbrt-v3 does not"};
constexpr WarningKind kUnknownLight{Effect::Light, "lights are unknown and left out"};
constexpr WarningKind kNoPortal{Effect::Slight, "lights have portals, which are ignored"};
constexpr WarningKind kNegativeScale{Effect::Light, "lights have a negative \"scale\": dark"};
constexpr WarningKind kTwoSources{Effect::Light,
                                  "lights have both a colour and an image, which pbrt-v4 refuses"};
constexpr WarningKind kNoPower{
    Effect::Light, "lights on surfaces have both an image and \"power\", which is ignored"};

/// Total power or illuminance that pbrt-v4 asks for; empty if none.
std::optional<float> target(const ParameterList& parameters, std::string_view name) {
  const std::optional<float> value = parameters.get_float(name);
  return value && *value > 0.F ? value : std::nullopt;
}

float cosine(float degrees) {
  return static_cast<float>(std::cos(static_cast<double>(degrees) * 3.14159265358979323846 / 180));
}

/// Scale of a light by pbrt-v4's "power" and "illuminance". Lights with images are scaled when the
/// images are known: those have a parameter of their own for it.
float target_scale(const ParameterList& p, desc::Node& node) {
  if (node.is("distant")) return target(p, "illuminance").value_or(1.F);
  if (node.is("environment")) {
    if (const auto illuminance = target(p, "illuminance")) node.set("irradiance", *illuminance);
    return 1.F;
  }
  const std::optional<float> power = target(p, "power");
  if (!power) return 1.F;
  if (node.has("power")) {
    node.set("power", *power);
    return 1.F;
  }
  if (node.is("point")) return *power / (4.F * kPi);
  // The smooth step is a half in the mean.
  const float edge = cosine(node.number("cone_angle"));
  const float start = cosine(node.number("falloff_start"));
  const float solid_angle = 2.F * kPi * ((1.F - start) + 0.5F * (start - edge));
  return solid_angle > 0.F ? *power / solid_angle : 1.F;
}

/// pbrt-v4's "scale".
float number_scale(Context& context, const ParameterList& parameters) {
  const Parameter* scale = parameters.find_one("scale", ParameterKind::Float);
  const float value = scale == nullptr ? 1.F : scale->numbers.front();
  if (value < 0.F) {
    context.warnings.add(kNegativeScale, scale->where,
                         "\"scale\" of a light is negative: taken as 0, which is dark");
  }
  return std::max(value, 0.F);
}

/// pbrt-v4 refuses lights with a colour and an image.
void warn_of_two_sources(Context& context, const ParameterList& parameters,
                         const char* what_is_done) {
  const Parameter* color = parameters.find("L", kSpectrumKinds);
  if (color == nullptr) return;
  context.warnings.add(kTwoSources, color->where,
                       std::string("pbrt-v4 refuses \"L\" beside an image: here ") + what_is_done);
}

/// A colour times the parameter "scale" and a factor.
desc::Rgb scaled(Context& context, const SourceLocation& where, const ParameterList& parameters,
                 const desc::Rgb& color, float target_scale) {
  const desc::Rgb scale = context.is_v4()
                              ? desc::Rgb(number_scale(context, parameters))
                              : context.spectra.get_positive(parameters, "scale", desc::Rgb(1.F));
  const desc::Rgb result = color * scale * target_scale;
  if (!is_finite(result))
    throw SceneError(where, "the light is too strong: it is not a finite number");
  return result;
}

/// Where a light is; nothing if its parameters say no direction.
std::optional<Mat4> place_of(const desc::Node& node, const ParameterList& p, const Mat4& ctm,
                             bool is_v4) {
  if (node.is("point")) {
    const Mat4 move = translation(Vec3d(p.get_point("from", {0.F, 0.F, 0.F})));
    // pbrt-v3 moves points in world space, after the current transform.
    return is_v4 ? move * ctm : ctm * move;
  }
  // Row 0 of a slide is at the upper edge in pbrt-v4.
  if (node.is("projection") && is_v4) return scaling({1.0, -1.0, 1.0}) * ctm;
  if (!node.is("spot") && !node.is("distant")) return ctm;
  const Vec3d from(p.get_point("from", {0.F, 0.F, 0.F}));
  const Vec3d to(p.get_point("to", {0.F, 0.F, 1.F}));
  const std::optional<Mat4> turn = z_to(node.is("spot") ? to - from : from - to);
  if (!turn) return std::nullopt;
  return node.is("spot") ? *turn * translation(from) * ctm : *turn * ctm;
}

void set_falloff(desc::Node& spot, const ParameterList& parameters) {
  const float delta = parameters.get_float("conedeltaangle", 5.F);
  // In double, so that the writer can find a difference that gives these bits again.
  spot.set("falloff_start", static_cast<float>(static_cast<double>(spot.number("cone_angle")) -
                                               static_cast<double>(delta)));
}

/// pbrt-v3 uses integers of such an image undecoded.
void check_codes(Context& context, const SourceLocation& where, const desc::Node& light) {
  if (!light.has("image")) return;
  const std::string extension = file_extension(light.text("image"));
  if (extension != ".png" && extension != ".tga") return;
  context.warnings.add(kDecoded, where,
                       "pbrt-v3 takes the integers of a light's image for light: here they are "
                       "decoded as sRGB, which is darker");
}

}  // namespace

std::optional<desc::Light> make_light(Context& context, TextureTable& textures,
                                      const SourceLocation& where, const std::string& type,
                                      const ParameterList& p, const Mat4& ctm) {
  const std::vector<ModelName>& table = light_names(context.choice.dialect);
  const desc::Model* own =
      own_model(context, where, desc::ModelKind::Light, p.get_string(kOwnModel));
  const desc::Model* model =
      own == nullptr ? model_of_type(desc::ModelKind::Light, table, type) : own;
  if (model == nullptr) {
    report_unknown(context, where, "light", type, types_of(desc::ModelKind::Light, table),
                   kUnknownLight, "It is left out");
    return std::nullopt;
  }
  const auto skip = [&](const std::string& reason) -> std::optional<desc::Light> {
    context.warnings.add(kLightsLeftOut, where, reason + ": light left out", reason);
    return std::nullopt;
  };
  desc::Light light;
  light.where = where;
  light.node = NodeReader(where, TextureParameters::of_light(context, textures, p))
                   .read(*model, own == nullptr ? find_theirs(table, type) : nullptr);
  if (light.node.is("spot")) set_falloff(light.node, p);
  // Where we wrote the image, pbrt has another file, without codes.
  if (!context.is_v4() && !p.has_own_words()) check_codes(context, where, light.node);
  if (context.is_v4() && light.node.is("environment") && !light.node.text("image").empty()) {
    warn_of_two_sources(context, p, "it is a factor of the image");
  }
  const float factor = context.is_v4() ? target_scale(p, light.node) : 1.F;
  for (const ParameterSpec& spec : model->parameters) {
    if (spec.type != ParameterType::Color) continue;
    light.node.set(spec.name, scaled(context, where, p, light.node.color(spec.name), factor));
  }
  const std::optional<Mat4> place = place_of(light.node, p, ctm, context.is_v4());
  if (!place) return skip("\"from\" and \"to\" of this light are the same point");
  light.to_world = *place;
  if (context.is_v4() && p.find("portal", ParameterKind::Point3) != nullptr) {
    context.warnings.add(kNoPortal, where, "the portal of this light is ignored");
  }
  p.accept({"samples", "nsamples"});
  p.report_unused(context.warnings);
  if (!is_finite(light.to_world) || !inverse(light.to_world)) {
    return skip("the transform of this light cannot be inverted");
  }
  return light;
}

namespace {

/// pbrt-v4: an image as the radiance of a surface.
std::optional<desc::TextureRef> emission_image(Context& context, TextureTable& textures,
                                               const SourceLocation& where,
                                               const ParameterList& p) {
  const std::optional<std::string> file = p.get_string("filename");
  if (!file || file->empty()) return std::nullopt;
  const desc::Node image = desc::texture_node(
      "image", {{"file", resolve_file(context, where, *file)}, {"wrap", std::string("clamp")}});
  return desc::TextureRef{textures.add(where, image)};
}

}  // namespace

std::optional<AreaEmission> make_emission(Context& context, TextureTable& textures,
                                          const SourceLocation& where, const std::string& type,
                                          const ParameterList& p) {
  const std::vector<ModelName>& table = emission_names(context.choice.dialect);
  const desc::Model* model = model_of_type(desc::ModelKind::Emission, table, type);
  if (model == nullptr) {
    report_unknown(context, where, "area light", type, types_of(desc::ModelKind::Emission, table),
                   kUnknownLight, "It is left out");
    return std::nullopt;
  }
  const TextureParameters lookup = TextureParameters::of_light(context, textures, p);
  AreaEmission result{{where, NodeReader(where, lookup).read(*model, find_theirs(table, type))},
                      std::nullopt};
  if (context.is_v4()) {
    desc::Node& node = result.emission.node;
    node.set("scale", scaled(context, where, p, desc::Rgb(1.F), 1.F));
    result.power = target(p, "power");
    if (const auto image = emission_image(context, textures, where, p)) {
      node.set("radiance", *image);
      warn_of_two_sources(context, p, "the image counts");
      if (result.power) {
        context.warnings.add(kNoPower, where,
                             "\"power\" of a light with an image is not supported: ignored");
        result.power.reset();
      }
    }
  }
  p.accept({"samples", "nsamples"});
  p.report_unused(context.warnings);
  return result;
}

}  // namespace ajar::pbrt
