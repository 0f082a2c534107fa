#pragma once
#include <optional>
#include <string_view>

#include "import/mitsuba/arguments.h"
#include "scene/desc/density_grid.h"

namespace ajar::mitsuba {

/// What a medium has of a `<volume>`.
struct VolumeValue {
  desc::Rgb color{0, 0, 0};                ///< the same everywhere, or the mean
  std::optional<desc::Density> density{};  ///< factors of `color`
};

/// The density that a medium calls `name`: a colour, a number, or a volume. Volumes that are not
/// supported become the same everywhere, and those whose file cannot be read 0, with a warning.
/// Nothing if the medium does not say it.
std::optional<VolumeValue> find_density(Arguments& medium, std::string_view name);

/// A coefficient that may not vary in space: the mean of a volume that does stands in, with a
/// warning.
std::optional<desc::Rgb> find_coefficient(Arguments& medium, std::string_view name);

}  // namespace ajar::mitsuba
