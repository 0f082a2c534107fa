#pragma once
#include <optional>
#include <string>

#include "import/pbrt/parameter_list.h"
#include "import/pbrt/textures.h"

namespace ajar::pbrt {

/// `LightSource "type" parameters`, without its medium. Empty, after a warning, if the light cannot
/// be used. Raises SceneError for unknown types.
std::optional<desc::Light> make_light(Context& context, TextureTable& textures,
                                      const SourceLocation& where, const std::string& type,
                                      const ParameterList& parameters, const Mat4& ctm);

/// `AreaLightSource "type" parameters`. Ours beyond pbrt-v3: `"texture L"`, which `scale`
/// multiplies.
desc::Emission make_emission(Context& context, TextureTable& textures, const SourceLocation& where,
                             const std::string& type, const ParameterList& parameters);

}  // namespace ajar::pbrt
