// Any bytes must either be a grid or curves of Mitsuba's or raise one of our errors.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "import/mitsuba/curve_file.h"
#include "import/mitsuba/volume_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const ajar::mitsuba::VolumeFile file =
        ajar::mitsuba::read_volume_file({reinterpret_cast<const char*>(data), size}, {});
    const auto& n = file.resolution;
    const std::size_t count = static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) *
                              static_cast<std::size_t>(n.z) *
                              static_cast<std::size_t>(file.channels);
    if (count != file.values.size()) std::abort();
  } catch (const ajar::SceneError&) {
  }
  for (const bool has_radii : {false, true}) {
    using namespace ajar::mitsuba;
    try {
      curves_of(read_curve_file({reinterpret_cast<const char*>(data), size}, "a", has_radii),
                has_radii ? CurveKind::CubicSpline : CurveKind::Corners);
    } catch (const ajar::SceneError&) {
    }
  }
  return 0;
}
