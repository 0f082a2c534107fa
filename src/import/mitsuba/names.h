#pragma once
#include <string>
#include <string_view>

namespace ajar::mitsuba {

/// "toWorld" and "to_world" as "to_world", "intIOR" as "int_ior": Mitsuba 0.x wrote names in one
/// way, 2 and 3 write them in the other.
std::string snake_case(std::string_view name);
/// The way back, for messages about files of Mitsuba 0.x.
std::string camel_case(std::string_view name);
/// In small letters.
std::string lower_case(std::string_view text);

}  // namespace ajar::mitsuba
