#pragma once
#include "core/located_json.h"
#include "core/warnings.h"

namespace ajar {

/// Warns of members of a file that stand twice in their objects; `which` counts, "first" or "last".
void warn_of_repeated_members(const LocatedJson& root, const std::string& which,
                              Warnings& warnings);

}  // namespace ajar
