#include "import/mitsuba/lights.h"

#include <algorithm>
#include <cmath>

#include "core/printable_text.h"
#include "import/common/transforms.h"
#include "import/mitsuba/node_maker.h"
#include "import/mitsuba/plugin_types.h"
#include "import/mitsuba/textures.h"
#include "import/mitsuba/view.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kLightsLeftOut{Effect::Light, "lights are left out"};
constexpr WarningKind kNoMapFile{Effect::Light, "environment maps have no \"filename\": left out"};
constexpr WarningKind kSpotTexture{Effect::Surface,
                                   "spot lights have a texture, which is not supported"};
constexpr WarningKind kGamma{Effect::Slight, "environment maps have a gamma: not supported"};
constexpr WarningKind kSlide{Effect::Surface,
                             "images of projectors are changed, which is not supported"};
constexpr WarningKind kNoSlide{Effect::Light, "projectors have no image: white light stands in"};
constexpr WarningKind kBeam{Effect::Light,
                            "collimated beams are not supported: narrow spots stand in"};

struct Source {
  Context& context;
  Arguments& arguments;

  desc::Node node(std::string_view model, desc::Node::Given given) const {
    return make_node(context, arguments.where(), desc::ModelKind::Light, model, given);
  }
  Vec3 color(std::string_view name, float fallback) const {
    return arguments.color(name).value_or(desc::Rgb(fallback));
  }
  Mat4 to_world() const { return arguments.transform("to_world").value_or(Mat4()); }
  std::optional<desc::Light> skip(const WarningKind& kind, const std::string& reason) const {
    context.warnings.add(kind, arguments.where(), reason + ": light left out",
                         printable(arguments.element().type));
    return std::nullopt;
  }
  desc::Light light(desc::Node node, const Mat4& to_world) const {
    return {arguments.where(), to_world, std::move(node)};
  }
};

std::optional<desc::Light> constant(const Source& in) {
  return in.light(in.node("environment", {{"radiance", in.color("radiance", 1.F)}}), Mat4());
}

std::optional<desc::Light> environment(const Source& in) {
  const std::optional<std::string> name = in.arguments.text("filename");
  const float gamma = in.arguments.number("gamma", 1.F);
  if (gamma > 0.F && gamma != 1.F) {
    in.context.warnings.add(kGamma, in.arguments.where(),
                            "\"gamma\" is not supported: the image is decoded as its format says");
  }
  in.arguments.accept({"cache", "mis_compensation"});
  if (!name || name->empty()) return in.skip(kNoMapFile, "this envmap has no \"filename\"");
  const Vec3 scale(in.arguments.number("scale", 1.F));
  desc::Node node = in.node("environment", {{"radiance", scale}});
  node.set("image",
           in.context.files.files().resolve(in.context.files.find(*name), in.arguments.where()));
  // Since version 2 the first and the last row are the poles.
  node.set("rows_at_poles", in.context.document.major_version >= 2);
  // Mitsuba's map has its pole at +y and begins at -z toward +x; ours has its pole at +z and begins
  // at +x toward +y.
  const Mat4 to_mitsuba(0.0, 0.0, -1.0, 0.0,  //
                        1.0, 0.0, 0.0, 0.0,   //
                        0.0, 1.0, 0.0, 0.0,   //
                        0.0, 0.0, 0.0, 1.0);
  return in.light(std::move(node), to_mitsuba * in.to_world());
}

std::optional<desc::Light> point(const Source& in) {
  Mat4 to_world = in.to_world();
  if (const std::optional<Vec3d> position = in.arguments.vector("position")) {
    to_world = translation(*position);
  }
  return in.light(in.node("point", {{"intensity", in.color("intensity", 1.F)}}), to_world);
}

std::optional<desc::Light> spot(const Source& in) {
  const float cutoff = in.arguments.number("cutoff_angle", 20.F);
  const float beam = std::min(in.arguments.number("beam_width", 0.75F * cutoff), cutoff);
  if (in.arguments.child("texture", "texture") != nullptr ||
      !in.arguments.children("texture").empty()) {
    in.context.warnings.add(kSpotTexture, in.arguments.where(),
                            "the texture of a spot light is not supported: left out");
  }
  return in.light(in.node("spot", {{"intensity", in.color("intensity", 1.F)},
                                   {"cone_angle", cutoff},
                                   {"falloff_start", beam},
                                   {"falloff", std::string("angle")}}),
                  in.to_world());
}

std::optional<desc::Light> directional(const Source& in) {
  Vec3d travels(0.0);
  in.to_world().multDirMatrix(Vec3d(0.0, 0.0, 1.0), travels);
  if (const std::optional<Vec3d> direction = in.arguments.vector("direction")) {
    travels = *direction;
  }
  // Ours says where the light comes from.
  const std::optional<Mat4> turn = z_to(-travels);
  if (!turn) return in.skip(kLightsLeftOut, "this light has no direction");
  return in.light(in.node("distant", {{"irradiance", in.color("irradiance", 1.F)}}), *turn);
}

/// Sets the image that a projector shows; white, after a warning, if it is not one of a file.
void set_slide(Context& context, const Element& texture, desc::Node& projector) {
  Arguments image(context, texture);
  const std::optional<std::string> name =
      texture.type == "bitmap" ? image.text("filename") : std::nullopt;
  if (!name || name->empty()) {
    image.accept_all();
    context.warnings.add(kNoSlide, texture.where,
                         "projectors show files of bitmaps only: white light stands in",
                         printable(texture.type));
    return;
  }
  projector.set("image", context.files.files().resolve(context.files.find(*name), texture.where));
  if (const std::optional<float> exponent = decoding_exponent(image)) {
    projector.set("decoding_exponent", *exponent);
  }
  for (const char* ignored : {"channel", "to_uv", "uscale", "vscale", "uoffset", "voffset"}) {
    if (!image.has(ignored)) continue;
    context.warnings.add(kSlide, texture.where,
                         "\"" + std::string(ignored) +
                             "\" of the image of a projector is not supported: the image is whole",
                         ignored);
    image.accept({ignored});
  }
  image.accept({"filter_type", "wrap_mode", "wrap_mode_u", "wrap_mode_v", "cache", "max_anisotropy",
                "format", "accel"});
}

std::optional<desc::Light> projector(const Source& in) {
  const GivenView view = read_view(in.arguments);
  desc::Node node = in.node("projection", {{"fov", static_cast<float>(view.fov)},
                                           {"fov_axis", view.axis},
                                           {"image_is", std::string("irradiance")}});
  // A plane at z = 1 receives π times the irradiance, which a scale of the space moves.
  // Source: Mitsuba 3, projector.cpp.
  const Mat4 to_world = in.to_world();
  Vec3d axis;
  to_world.multDirMatrix(Vec3d(0.0, 0.0, 1.0), axis);
  const float factor = kPi * in.arguments.number("scale", 1.F) * static_cast<float>(axis.length());
  if (const Element* texture = in.arguments.texture("irradiance")) {
    set_slide(in.context, *texture, node);
    node.set("intensity", Vec3(factor));
  } else {
    node.set("intensity", in.color("irradiance", 1.F) * factor);
  }
  in.arguments.accept({"near_clip", "far_clip"});
  // The image begins at +x and +y in Mitsuba, at -x and -y here.
  return in.light(std::move(node), scaling({-1.0, -1.0, 1.0}) * to_world);
}

std::optional<desc::Light> collimated(const Source& in) {
  constexpr float kHalfAngle = 0.5F;  // degrees
  in.context.warnings.add(kBeam, in.arguments.where(),
                          "a collimated beam is not supported: a spot of half a degree and the "
                          "same power stands in");
  const float solid_angle = 2.F * kPi * (1.F - std::cos(kHalfAngle * (kPi / 180.F)));
  return in.light(in.node("spot", {{"intensity", in.color("power", 1.F) / solid_angle},
                                   {"cone_angle", kHalfAngle},
                                   {"falloff_start", kHalfAngle}}),
                  in.to_world());
}

std::optional<desc::Light> make_light(const Source& in) {
  const std::string& type = in.arguments.element().type;
  if (type == "constant") return constant(in);
  if (type == "envmap") return environment(in);
  if (type == "point") return point(in);
  if (type == "spot") return spot(in);
  if (type == "directional") return directional(in);
  if (type == "projector") return projector(in);
  if (type == "collimated") return collimated(in);
  in.arguments.accept_all();
  if (type == "area") return in.skip(kLightsLeftOut, "an area light must be in a shape");
  return in.skip(kLightsLeftOut, unknown_type_message(in.arguments.element()));
}

}  // namespace

void add_lights(Context& context, MediumTable& media, const Element& emitter) {
  Arguments arguments(context, emitter);
  if (emitter.type == "sun" || emitter.type == "sky" || emitter.type == "sunsky") {
    return add_sun_and_sky(context, arguments);
  }
  const Source source{context, arguments};
  std::optional<desc::Light> light = make_light(source);
  const Element* around = arguments.only_child("medium");
  arguments.accept({"sampling_weight", "to_world"});
  if (!light) return;
  if (around != nullptr) light->medium = media.make(*around);
  if (!inverse(light->to_world)) {
    source.skip(kLightsLeftOut, "the transform of this light cannot be inverted");
    return;
  }
  context.scene.lights.push_back(std::move(*light));
}

}  // namespace ajar::mitsuba
