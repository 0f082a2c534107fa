#pragma once
#include <optional>
#include <string>

#include "import/pbrt/context.h"
#include "import/pbrt/parameter_list.h"

namespace ajar::pbrt {

/// `MakeNamedMedium "name" parameters` where `to_world` is current. Clouds become grids, and media
/// whose file cannot be read clear ones, with a warning.
desc::Medium make_medium(Context& context, const SourceLocation& where, const std::string& name,
                         const ParameterList& parameters, const Mat4& to_world);

}  // namespace ajar::pbrt
