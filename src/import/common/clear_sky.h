#pragma once
#include <optional>

#include "core/error.h"
#include "scene/desc/scene_desc.h"

namespace ajar {

/// The sky and the sun of a scene, in world space.
struct Daylight {
  double turbidity = 3.0;
  Vec3d up{0.0, 1.0, 0.0};
  Vec3d to_sun{0.0, 1.0, 0.0};

  /// Height of the sun over the horizon, degrees; negative at night. The vectors must have a
  /// direction.
  double elevation() const;
};

/// Radiance, in W/(m² sr nm), of an even spectrum of 1 kcd/m², for renderers whose skies are per
/// nanometre.
extern const double kRadiancePerKilocandela;

/// A light of the model `sky`, where the sun is not below the horizon; `scale` multiplies physical
/// values in units per nanometre. Turbidities that the model does not have are the nearest that it
/// has.
std::optional<desc::Light> sky_light(const SourceLocation& where, const Daylight& daylight,
                                     double scale);
/// The sun: parallel light.
std::optional<desc::Light> sun_light(const SourceLocation& where, const Daylight& daylight,
                                     double scale);

}  // namespace ajar
