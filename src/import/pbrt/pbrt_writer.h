#pragma once
#include <string>

#include "scene/desc/scene_desc.h"

namespace ajar {

/// Writes a scene as one pbrt-v3 file and, in the folder "<stem>_meshes" beside it, its meshes as
/// binary PLY, named by their contents so that an earlier version of the scene stays whole.
/// Importing the file gives a description of equal `desc::hash`. Images are not copied, but
/// referred to relative to the file where possible. Those that pbrt-v3 would not see as they are
/// meant, and embedded ones, are written into the folder "<stem>_images". Each file is written as a
/// whole or not at all, the pbrt file last. Returns what pbrt-v3 does not know of it, for people;
/// empty if it knows all. Raises IoError.
std::string write_pbrt(const desc::SceneDesc& scene, const std::string& out_path);

}  // namespace ajar
