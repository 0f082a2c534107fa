#pragma once
#include <span>

#include "core/parameters.h"

namespace ajar {

/// Raises UsageError if one of `specs` was given that has no effect because of the value of
/// another.
void refuse_inactive(std::span<const ParameterSpec> specs, const Parameters& parameters);

}  // namespace ajar
