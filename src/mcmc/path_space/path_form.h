#pragma once
#include "path/path.h"

namespace ajar {

/// The first vertex in the scene, from the camera, that is not specular; 0 if there is none.
int first_rough_from_camera(const Path& path);
/// Whether an edge between x − 1 and x could have been made by joining two subpaths.
bool can_join(const Path& path, int x);
/// Whether none could: only light that is hit by chance finds the path.
bool is_hit_only(const Path& path);
/// Whether both scatter by the same specular events at the vertices `first` to `last`.
bool same_events(const Path& a, const Path& b, int first, int last);

}  // namespace ajar
