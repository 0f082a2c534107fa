#include "import/tungsten/lights.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "import/common/clear_sky.h"
#include "import/tungsten/transforms.h"
#include "scene/desc/models.h"

namespace ajar::tungsten {
namespace {

constexpr WarningKind kCap{Effect::Light,
                           "suns of some size are not supported: parallel light stands in"};
constexpr WarningKind kSky{Effect::Light,
                           "skies are those of Preetham et al., not of Hosek and Wilkie"};
constexpr WarningKind kNight{Effect::Light, "suns are below the horizon: skies are left out"};
constexpr WarningKind kTextured{Effect::Light,
                                "lights have textures that are not supported: even ones stand in"};
constexpr WarningKind kUnknownPivot{Effect::Light, "lights refer to primitives that are unknown"};
constexpr WarningKind kSeam{Effect::Slight,
                            "images of lights are to end at their edges: both sides join"};

constexpr WarningKind kSunTemperature{Effect::Light,
                                      "suns of skies have a temperature of their own: ignored"};

constexpr float kUsualCapAngle = 10.F;  // degrees
constexpr float kRadiansPerDegree = kPi / 180.F;
constexpr float kUsualTemperature = 5777.F;  // temperature of the sun, in kelvin

struct Source {
  Context& context;
  TextureReader& textures;
  const ObjectReader& object;
  Mat4 transform;

  void add(desc::Node node, const Mat4& to_world) const {
    context.scene.lights.push_back({object.where(), to_world, std::move(node)});
  }
  /// "emission", or "power" times `per_power`, as a colour; nothing if it gives none. `image` takes
  /// the place of a texture, if the light can have one.
  std::optional<Vec3> strength(float per_power, std::optional<Bitmap>* image = nullptr) const;
};

std::optional<Vec3> Source::strength(float per_power, std::optional<Bitmap>* image) const {
  const auto power = object.find("power");
  const auto emission = object.find("emission");
  const auto json = power ? power : emission;
  if (!json) return std::nullopt;
  const float factor = power ? per_power : 1.F;
  if (image != nullptr) {
    if ((*image = textures.bitmap(*json))) {
      if ((*image)->clamp) {
        context.warnings.add(kSeam, json->where(),
                             "\"clamp\" is not supported here: the left and the right edge of the "
                             "image join");
      }
      return not_negative(context, json->where(), Vec3((*image)->scale * factor));
    }
  }
  const desc::Value value = textures.color(*json);
  const Vec3* constant = std::get_if<Vec3>(&value);
  if (constant == nullptr) {
    context.warnings.add(kTextured, json->where(),
                         "this light cannot have a texture: an even light of 0.5 stands in");
  }
  const Vec3 color = not_negative(context, json->where(), constant_or(value, Vec3(0.5F)) * factor);
  if (color == Vec3(0.F)) return std::nullopt;
  return color;
}

void infinite_sphere(const Source& source) {
  source.object.accept({"sample", "bsdf"});
  std::optional<Bitmap> image;
  const std::optional<Vec3> radiance = source.strength(1.F / (4.F * kPi), &image);
  if (!radiance) return;
  // Tungsten's image has its upper edge at +y and begins at −x, going by −z; ours at +z and +x, by
  // +y.
  const Mat4 turn = from_axes({-1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, Vec3d(0.0));
  desc::Node node = desc::light_node("environment", {{"radiance", *radiance}});
  if (image) {
    node.set("image", image->file);
    node.set("decoding_exponent", image->decoding_exponent());
    node.set("nearest", !image->interpolate);
  }
  source.add(std::move(node), turn * without_scale(source.transform, false));
}

void infinite_sphere_cap(const Source& source, const PrimitivePlaces& places) {
  source.object.accept({"sample", "bsdf"});
  Mat4 transform = source.transform;
  if (const std::optional<std::string> dome = source.object.text("skydome");
      dome && !dome->empty()) {
    const auto found = places.find(*dome);
    if (found != places.end()) {
      transform = found->second;
    } else {
      source.context.warnings.add(
          kUnknownPivot, source.object.where(),
          "there is no primitive \"" + printable(*dome) + "\": the light's own place is used");
    }
  }
  const float angle =
      std::clamp(source.object.number("cap_angle").value_or(kUsualCapAngle), 0.01F, 90.F);
  const float sine = std::sin(angle * kRadiansPerDegree);
  const std::optional<Vec3> radiance =
      source.strength(1.F / (2.F * kPi * (1.F - std::cos(angle * kRadiansPerDegree))));
  if (!radiance) return;
  source.context.warnings.add(kCap, source.object.where(),
                              "lights from a part of the sky are not supported: parallel light of "
                              "the same strength stands in");
  // ∫ L cosθ over the cap, on a surface that faces it.
  const Vec3 irradiance = *radiance * (kPi * sine * sine);
  const Mat4 frame = without_scale(transform, false);
  source.add(desc::light_node("distant", {{"irradiance", irradiance}}),
             from_axes(axis_of(frame, 2), axis_of(frame, 0), axis_of(frame, 1), Vec3d(0.0)));
}

void skydome(const Source& source) {
  // Tungsten reads "gamma_scale", and uses 1.
  source.object.accept({"gamma_scale", "sample", "bsdf", "emission", "power"});
  if (source.object.number("temperature").value_or(kUsualTemperature) != kUsualTemperature) {
    source.context.warnings.add(
        kSunTemperature, source.object.where(),
        "\"temperature\" is not supported: the sky is that of our sun, of 5777 kelvin");
  }
  const Daylight daylight{.turbidity = source.object.number("turbidity").value_or(3.F),
                          .to_sun = axis_of(source.transform, 1)};
  const double intensity = std::max(source.object.number("intensity").value_or(2.F), 0.F);
  if (!(daylight.to_sun.length() > 0.0) || daylight.elevation() < 0.0) {
    source.context.warnings.add(kNight, source.object.where(),
                                "the sun is below the horizon: the sky is left out");
    return;
  }
  source.context.warnings.add(
      kSky, source.object.where(),
      "the sky is that of Preetham et al. 1999, of turbidity 2 to 10, under our sun and without "
      "light from the ground: near that of Hosek and Wilkie");
  source.context.scene.lights.push_back(*sky_light(source.object.where(), daylight, intensity));
}

void point(const Source& source) {
  source.object.accept({"bsdf"});
  const std::optional<Vec3> intensity = source.strength(1.F / (4.F * kPi));
  if (!intensity) return;
  Mat4 place;
  place.setTranslation(origin_of(source.transform));
  source.add(desc::light_node("point", {{"intensity", *intensity}}), place);
}

}  // namespace

void add_default_light(Context& context, const SourceLocation& where) {
  context.scene.lights.push_back(
      {where, Mat4(), desc::light_node("environment", {{"radiance", Vec3(1.F)}})});
}

bool read_light(Context& context, TextureReader& textures, const ObjectReader& object,
                const std::string& type, const Mat4& transform, const PrimitivePlaces& places) {
  const Source source{context, textures, object, transform};
  if (type == "infinite_sphere") {
    infinite_sphere(source);
  } else if (type == "infinite_sphere_cap") {
    infinite_sphere_cap(source, places);
  } else if (type == "skydome") {
    skydome(source);
  } else if (type == "point") {
    point(source);
  } else {
    return false;
  }
  return true;
}

}  // namespace ajar::tungsten
