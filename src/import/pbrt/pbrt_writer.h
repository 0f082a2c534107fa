#pragma once
#include <string>

#include "scene/desc/scene_desc.h"

namespace ajar {

/// Writes a scene as one pbrt-v3 file. Beside it, in the folder "<stem>_meshes", are its meshes as
/// binary PLY, and in "<stem>_images" the images that pbrt-v3 would not see as they are meant, and
/// embedded ones. Others are referred to relative to the file where possible. Files in these
/// folders are named by their contents and never replaced. Importing the file gives a description
/// of equal `desc::hash`. Each file is written as a whole or not at all, the pbrt file last.
/// Returns what pbrt-v3 does not know of the scene and which images cannot be read, for people;
/// empty if there is nothing to say. Raises IoError.
std::string write_pbrt(const desc::SceneDesc& scene, const std::string& out_path);

}  // namespace ajar
