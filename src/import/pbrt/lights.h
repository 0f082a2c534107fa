#pragma once
#include <optional>
#include <string>

#include "import/pbrt/parameter_list.h"
#include "import/pbrt/textures.h"

namespace ajar::pbrt {

/// `LightSource "type" parameters`, without its medium. Empty, after a warning, if the light cannot
/// be used. Raises SceneError for types that pbrt-v3 does not have.
std::optional<desc::Light> make_light(Context& context, TextureTable& textures,
                                      const SourceLocation& where, const std::string& type,
                                      const ParameterList& parameters, const Mat4& ctm);

/// Emission as an `AreaLightSource` directive describes it.
struct AreaEmission {
  desc::Emission emission;
  /// pbrt-v4: luminance of all that each primitive of the shape emits, which decides the scale.
  std::optional<float> power;
};
/// `AreaLightSource "type" parameters`. Ours beyond pbrt: `"texture L"`, which `scale` multiplies.
/// Empty, after a warning, for types that pbrt-v4 does not have.
std::optional<AreaEmission> make_emission(Context& context, TextureTable& textures,
                                          const SourceLocation& where, const std::string& type,
                                          const ParameterList& parameters);

}  // namespace ajar::pbrt
