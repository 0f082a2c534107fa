#pragma once
#include <filesystem>
#include <string>

/// One small room, as files of every format that can say it: walls of colours and of an image, a
/// lamp that shines downward, a point light, and a camera that sees a picture of 4 to 3.
namespace ajar::test {

/// Material of its surfaces: some formats have no principled reflection. Its parameters are
/// such that all others mean the same by them.
enum class RoomSurface { Diffuse, Principled };

/// Each writes the room into `folder` and returns the path of the scene.
std::string write_pbrt3_room(const std::filesystem::path& folder, RoomSurface surface);
/// Diffuse.
std::string write_pbrt4_room(const std::filesystem::path& folder);
/// `version`: "0.6.0" or "3.0.0".
std::string write_mitsuba_room(const std::filesystem::path& folder, const std::string& version,
                               RoomSurface surface);
/// Diffuse.
std::string write_tungsten_room(const std::filesystem::path& folder);
/// Diffuse: without gloss.
std::string write_gltf_room(const std::filesystem::path& folder);
/// The room in one file, with the image inside as a JPEG, whose colors are not quite the same.
std::string write_glb_room(const std::filesystem::path& folder);

}  // namespace ajar::test
