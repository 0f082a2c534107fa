#pragma once
#include <string_view>
#include <vector>

#include "core/error.h"
#include "scene/desc/density_grid.h"

namespace ajar::mitsuba {

/// The numbers of a `.vol` file.
struct VolumeFile {
  desc::Vec3i resolution{0, 0, 0};
  int channels = 1;           ///< 1 to 6
  Vec3 low{0.F}, high{0.F};   ///< where the file says it is
  std::vector<float> values;  ///< channels vary fastest, then x, then y; of bytes, 255 is 1
};

/// Reads version 3 of the format with numbers of 32 bits or bytes. Raises SceneError, at `where`,
/// for other encodings and for damaged files. Source: the documentation of "gridvolume" of Mitsuba
/// 0.6 and 3.
VolumeFile read_volume_file(std::string_view bytes, const SourceLocation& where);

}  // namespace ajar::mitsuba
