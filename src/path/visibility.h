#pragma once
#include "path/path.h"

namespace ajar {

/// The segment along edge `edge` of `path`, whose ends are set, as are the segments nearer to the
/// camera if that hides lights; empty if the ends do not see each other.
/// `rays` is increased by the number of rays traced.
std::optional<Segment> look_along(const Scene& scene, const Path& path, int edge, RayCounts& rays);

/// Sets all `segments`; false if the path is interrupted somewhere.
bool look_along_all(const Scene& scene, Path& path, RayCounts& rays);

}  // namespace ajar
