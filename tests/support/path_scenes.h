#pragma once
#include <string>

namespace ajar::test {

/// A square lamp over a matt floor, in the words of pbrt-v3.
std::string lamp_over_floor();

/// The text, in the words of pbrt-v3, of a scene for mutations of paths: light through water and
/// lenses, on gloss, at grazing angles; else the small scene of that name. Raises std::logic_error
/// if there is none.
std::string path_scene(const std::string& name);

}  // namespace ajar::test
