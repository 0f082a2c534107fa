#include "import/pbrt/lights.h"

#include "import/common/transforms.h"
#include "import/pbrt/light_names.h"
#include "import/pbrt/node_reader.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kLeftOut{Effect::Light, "lights are left out"};

/// A colour times the parameter "scale".
desc::Rgb scaled(Context& context, const SourceLocation& where, const ParameterList& parameters,
                 const desc::Rgb& color) {
  const desc::Rgb result =
      color * context.spectra.get_positive(parameters, "scale", desc::Rgb(1.F));
  if (!is_finite(result))
    throw SceneError(where, "the light is too strong: it is not a finite number");
  return result;
}

/// Where a light is; nothing if its parameters say no direction.
std::optional<Mat4> place_of(const desc::Node& node, const ParameterList& p, const Mat4& ctm) {
  // pbrt-v3 moves points in world space, after the current transform.
  if (node.is("point")) return ctm * translation(Vec3d(p.get_point("from", {0.F, 0.F, 0.F})));
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

}  // namespace

std::optional<desc::Light> make_light(Context& context, TextureTable& textures,
                                      const SourceLocation& where, const std::string& type,
                                      const ParameterList& p, const Mat4& ctm) {
  const desc::Model* model = model_of_type(desc::ModelKind::Light, light_names(), type);
  if (model == nullptr) {
    fail_unknown(where, "light", type, types_of(desc::ModelKind::Light, light_names()));
  }
  const auto skip = [&](const std::string& reason) -> std::optional<desc::Light> {
    context.warnings.add(kLeftOut, where, reason + ": light left out", reason);
    return std::nullopt;
  };
  desc::Light light;
  light.where = where;
  light.node = NodeReader(where, TextureParameters(context, textures, p))
                   .read(*model, find_theirs(light_names(), type));
  for (const ParameterSpec& spec : model->parameters) {
    if (spec.type != ParameterType::Color) continue;
    light.node.set(spec.name, scaled(context, where, p, light.node.color(spec.name)));
  }
  if (light.node.is("spot")) set_falloff(light.node, p);
  const std::optional<Mat4> place = place_of(light.node, p, ctm);
  if (!place) return skip("\"from\" and \"to\" of this light are the same point");
  light.to_world = *place;
  p.accept({"samples", "nsamples"});
  p.report_unused(context.warnings);
  if (!is_finite(light.to_world) || !inverse(light.to_world)) {
    return skip("the transform of this light cannot be inverted");
  }
  return light;
}

desc::Emission make_emission(Context& context, TextureTable& textures, const SourceLocation& where,
                             const std::string& type, const ParameterList& p) {
  const desc::Model* model = model_of_type(desc::ModelKind::Emission, emission_names(), type);
  if (model == nullptr) {
    fail_unknown(where, "area light", type, types_of(desc::ModelKind::Emission, emission_names()));
  }
  const TextureParameters lookup(context, textures, p);
  desc::Emission emission{
      where, NodeReader(where, lookup).read(*model, find_theirs(emission_names(), type))};
  p.accept({"samples", "nsamples"});
  p.report_unused(context.warnings);
  return emission;
}

}  // namespace ajar::pbrt
