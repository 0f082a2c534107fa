#pragma once
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "core/vector.h"

namespace ajar::test {

/// A scene for tests of light transport: a lit room with something in it that is easy to get wrong.
struct SmallScene {
  std::string name;
  std::string text;  ///< pbrt-v3
  /// False if the lens sees things through mirrors or glass only, where technique (s, 1) alone
  /// misses light; or if a pinhole is in fog, where its variance is infinite: events close to the
  /// pinhole are unboundedly bright.
  bool light_tracing_works = true;
  int samples = 128;  ///< per pixel, for comparisons of pictures
  std::optional<Box2i> crop = std::nullopt;

  friend void PrintTo(const SmallScene& scene, std::ostream* out) { *out << scene.name; }
};

std::vector<SmallScene> small_scenes();
/// The one of that name. Raises std::logic_error.
SmallScene small_scene(const std::string& name);

}  // namespace ajar::test
