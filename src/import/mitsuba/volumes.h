#pragma once
#include <optional>
#include <string_view>

#include "import/mitsuba/arguments.h"
#include "import/mitsuba/volume_grid.h"

namespace ajar::mitsuba {

/// Values that a medium reads from a `<volume>`.
struct VolumeValue {
  desc::Rgb color{0, 0, 0};
  std::optional<VolumeGrid> grid{};  ///< factors of `color`
};

/// The density that a medium calls `name`: a colour, a number, or a volume. Volumes that are not
/// supported become the same everywhere, and those whose file cannot be read 0, with a warning.
/// Nothing if the medium does not say it.
std::optional<VolumeValue> find_density(Arguments& medium, std::string_view name);

/// A density that is the same everywhere in the medium; of a heterogeneous one of Mitsuba 2 and 3,
/// everywhere in the box around the image of the unit cube, and 0 beyond. Source: Mitsuba 3,
/// heterogeneous.cpp, whose bounds are those of the volume.
VolumeValue constant_density(const Arguments& medium, const desc::Rgb& color,
                             const Mat4& cube = Mat4());

/// The albedo of a medium, in the same way. The default replaces unsupported volumes.
std::optional<VolumeValue> find_albedo(Arguments& medium, std::string_view name);

/// A coefficient that may not vary in space: the mean of a volume that does stands in, with a
/// warning.
std::optional<desc::Rgb> find_coefficient(Arguments& medium, std::string_view name);

/// Gives a medium the extinction and the albedo, as densities or colours if they vary. A varying
/// albedo of a constant extinction is replaced by its mean, with a warning.
void set_extinction(Arguments& arguments, desc::Medium& medium, VolumeValue sigma_t,
                    const VolumeValue& albedo);

}  // namespace ajar::mitsuba
