#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "api/contents.h"
#include "core/located_json.h"

/// JSON in and out of the C face.
namespace ajar::c {

using Json = nlohmann::ordered_json;
using v0::json_text;

/// An object of a program. Raises UsageError, also for what is wrong with its values, and for
/// members that are not among `names`: one of what `kind` says. A member that is null is as if it
/// were not there.
inline LocatedJson parsed_object(std::string_view text, const std::string& kind,
                                 const std::vector<std::string>& names) {
  const LocatedJson object =
      LocatedJson::parse(std::string(text), {.raise = raise_error<UsageError>,
                                             .deepest = 64,
                                             .null_is_absent = true,
                                             .may_have_zeros = false});
  object.check_members(kind, names);
  return object;
}

}  // namespace ajar::c
