#pragma once
#include <optional>
#include <string>

#include "scene/direction_map.h"
#include "scene/light/aim.h"
#include "scene/light/make_light.h"
#include "scene/light/map.h"
#include "scene/light/registry.h"
#include "scene/light/sphere_map.h"

namespace ajar {

/// Where a light stands and how it is turned.
struct LightPlacement {
  Vec3 position;
  DirectionMap directions;
};

/// Treatment of the texels of a map.
struct TexelTreatment {
  bool gray = false;     ///< each is the mean of its colours
  bool nearest = false;  ///< no interpolation, whatever the projection
  std::optional<float> decoding_exponent = std::nullopt;  ///< exponent for integers; without one:
                                                          ///< sRGB
  bool rows_at_edges = false;  ///< the first and the last row, as `Map::put_rows_at_edges`
};

/// The description of one light, with the data of the scene that it needs.
class LightInputs {
 public:
  /// Warns of a transform that cannot be inverted: it counts as no rotation.
  LightInputs(const desc::Light& description, const LightSurroundings& surroundings,
              Warnings& warnings);

  const desc::Node& node() const { return description_.node; }
  const LightPlacement& at() const { return at_; }
  const BoundingSphere& bounds() const { return surroundings_.bounds; }
  Aim aim() const { return Aim(surroundings_.receivers); }
  Spectrum color(std::string_view name) const { return rgb_spectrum(node().color(name)); }
  /// The map of a file, as `load_map` reads it; nothing if the light has none.
  std::optional<Map> map(std::string_view name, MapEdge edge,
                         MapFilter filter = MapFilter::Bilinear,
                         std::optional<float> decoding_exponent = std::nullopt) const;
  /// The map "image" of all directions, spread as "projection" says; nothing if the light has none.
  /// An equal-area map that is not square counts as one of latitudes, with a warning.
  std::optional<SphereMap> sphere_map(const TexelTreatment& texels = {}) const;
  /// Exponent that decodes integers of the image; nothing if they are sRGB.
  std::optional<float> decoding_exponent() const;
  /// Scale of a light of luminance `actual` to the value of the parameter `name`; 1 if it is not
  /// given.
  float scale_to(std::string_view name, float actual) const;

 private:
  const desc::Light& description_;
  const LightSurroundings& surroundings_;
  Warnings& warnings_;
  LightPlacement at_;
};

}  // namespace ajar

namespace ajar::declare {

/// A luminance that a light is scaled to, whatever its image; none by default.
ParameterSpec target(std::string name, std::string unit, std::string help);
/// The parameter of `LightInputs::decoding_exponent`.
ParameterSpec decoding();

}  // namespace ajar::declare
