#pragma once
#include "core/archive_forward.h"
#include "path/path.h"

namespace ajar {

/// Writes a path of `scene` into an archive (core/archive.h), floats by their bits.
void save_path(OutputArchive& archive, const Scene& scene, const Path& path);

/// Reads it for the same scene: equal in every bit, the BSDFs made anew by the materials. Raises
/// std::runtime_error for paths that are impossible in this scene (lights, shapes and media that it
/// does not have, invalid numbers).
Path load_path(InputArchive& archive, const Scene& scene);

}  // namespace ajar
