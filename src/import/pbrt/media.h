#pragma once
#include <optional>
#include <string>

#include "import/pbrt/context.h"
#include "import/pbrt/parameter_list.h"

namespace ajar::pbrt {

/// `MakeNamedMedium "name" parameters`. Heterogeneous media become homogeneous ones of their mean
/// density, with a warning.
desc::Medium make_medium(Context& context, const SourceLocation& where, const std::string& name,
                         const ParameterList& parameters);

}  // namespace ajar::pbrt
