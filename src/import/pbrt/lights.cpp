#include "import/pbrt/lights.h"

#include "import/pbrt/transforms.h"

namespace ajar::pbrt {
namespace {

const std::vector<std::string> kTypes = {"point",      "spot",        "distant",   "infinite",
                                         "exinfinite", "goniometric", "projection"};

constexpr WarningKind kLeftOut{Effect::Light, "lights are left out"};

/// Everything that one light directive says.
struct Source {
  Context& context;
  const SourceLocation& where;
  const ParameterList& parameters;

  /// The colour `name` times `scale`.
  desc::Rgb emission(std::string_view name) const {
    const desc::Rgb value = context.spectra.get_positive(parameters, name, desc::Rgb(1.F));
    const desc::Rgb result =
        value * context.spectra.get_positive(parameters, "scale", desc::Rgb(1.F));
    if (!is_finite(result))
      throw SceneError(where, "the light is too strong: it is not a finite number");
    return result;
  }
  std::optional<desc::Light> skip(const std::string& reason) const {
    context.warnings.add(kLeftOut, where, reason + ": light left out", reason);
    return std::nullopt;
  }
  std::string image() const {
    const std::optional<std::string> name = parameters.get_string("mapname");
    if (!name || name->empty()) return {};
    try {
      return context.files.resolve(*name);
    } catch (const IoError& error) {
      throw SceneError(where, error.what());
    }
  }
};

desc::SpotLight spot(const Source& source) {
  desc::SpotLight node;
  node.intensity = source.emission("I");
  node.cone_angle = source.parameters.get_float("coneangle", 30.F);
  const float delta = source.parameters.get_float("conedeltaangle", 5.F);
  // In double, so that the writer can find a difference that gives these bits again.
  node.falloff_start =
      static_cast<float>(static_cast<double>(node.cone_angle) - static_cast<double>(delta));
  return node;
}

}  // namespace

std::optional<desc::Light> make_light(Context& context, const SourceLocation& where,
                                      const std::string& type, const ParameterList& p,
                                      const Mat4& ctm) {
  const Source source{context, where, p};
  desc::Light light;
  light.where = where;
  light.to_world = ctm;
  if (type == "point") {
    light.node = desc::PointLight{source.emission("I")};
    // pbrt-v3 moves the light in world space, after the current transform.
    light.to_world = ctm * translation(Vec3d(p.get_point("from", {0.F, 0.F, 0.F})));
  } else if (type == "spot") {
    const Vec3d from(p.get_point("from", {0.F, 0.F, 0.F}));
    const Vec3d to(p.get_point("to", {0.F, 0.F, 1.F}));
    light.node = spot(source);
    const std::optional<Mat4> turn = z_to(to - from);
    if (!turn) return source.skip("\"from\" and \"to\" of this light are the same point");
    light.to_world = *turn * translation(from) * ctm;
  } else if (type == "distant") {
    const Vec3d from(p.get_point("from", {0.F, 0.F, 0.F}));
    const Vec3d to(p.get_point("to", {0.F, 0.F, 1.F}));
    light.node = desc::DistantLight{source.emission("L")};
    const std::optional<Mat4> turn = z_to(from - to);
    if (!turn) return source.skip("\"from\" and \"to\" of this light are the same point");
    light.to_world = *turn * ctm;
  } else if (type == "infinite" || type == "exinfinite") {
    light.node = desc::InfiniteLight{source.emission("L"), source.image()};
  } else if (type == "goniometric") {
    light.node = desc::GoniometricLight{source.emission("I"), source.image()};
  } else if (type == "projection") {
    const float fov = p.get_float("fov", 45.F);
    if (!(fov > 0.F && fov < 180.F))
      throw SceneError(where, "\"fov\" must be between 0 and 180 degrees");
    light.node = desc::ProjectionLight{source.emission("I"), fov, source.image()};
  } else {
    fail_unknown(where, "light", type, kTypes);
  }
  p.accept({"samples", "nsamples"});
  p.report_unused(context.warnings);
  if (!is_finite(light.to_world) || !inverse(light.to_world)) {
    return source.skip("the transform of this light cannot be inverted");
  }
  return light;
}

desc::AreaLight make_area_light(Context& context, const TextureTable& textures,
                                const SourceLocation& where, const std::string& type,
                                const ParameterList& p) {
  if (type != "diffuse" && type != "area") fail_unknown(where, "area light", type, {"diffuse"});
  const Source source{context, where, p};
  desc::AreaLight light;
  light.where = where;
  if (const Parameter* reference = p.find_one("L", ParameterKind::Texture)) {
    light.texture = textures.find(*reference, TextureClass::Spectrum).value_or(desc::kNone);
  }
  light.radiance = source.emission("L");
  light.two_sided = p.get_bool("twosided", false);
  p.accept({"samples", "nsamples"});
  p.report_unused(context.warnings);
  return light;
}

}  // namespace ajar::pbrt
