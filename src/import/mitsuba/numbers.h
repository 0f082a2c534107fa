#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/desc/scene_desc.h"

/// The spelling of values in attributes.
namespace ajar::mitsuba {

/// Words between spaces, tabs, line ends and commas.
std::vector<std::string_view> words_of(std::string_view text);
/// A number alone, but for spaces around it; "nan" and "inf" are none.
std::optional<double> parse_number(std::string_view text);
std::optional<long long> parse_integer(std::string_view text);
std::optional<bool> parse_boolean(std::string_view text);
/// Numbers of `words_of`; nothing if one of them is no number.
std::optional<std::vector<double>> parse_numbers(std::string_view text);
/// One number for all lanes, three numbers, or "#rrggbb", of which each lane is from 0 to 1.
std::optional<Vec3d> parse_triple(std::string_view text);
/// Linear value of a colour coded by IEC 61966-2-1.
Vec3d srgb_to_linear(const Vec3d& srgb);

}  // namespace ajar::mitsuba
