#include "path/verify.h"

#include <stdexcept>
#include <string>

#include "path/measure.h"

namespace ajar {

namespace {
/// What single precision makes of positions, seen through a few sharp lobes.
constexpr float kDirection = 2e-3F;
constexpr double kRelative = 0.02;

/// Relative error of the squares of lengths: positions are rounded in their last digits, and events
/// of a medium may be close together.
double rounding_of_lengths(const Scene& scene, const Path& path) {
  double sum = 0.0;
  for (int edge = 0; edge < path.depth(); ++edge) {
    if ((edge == 0 && path.light->at_infinity()) ||
        (edge == path.depth() - 1 && scene.camera().at_infinity())) {
      continue;
    }
    const Vec3& from = path.position(edge);
    const Vec3& to = path.position(edge + 1);
    const float size = std::max(length(from), length(to));
    sum += 2.0 * 0x1p-22 * double{size} / std::max(double{length(to - from)}, 1e-18);
  }
  return sum;
}

/// Relative error of cosines: directions and normals are rounded in their last digits, which is
/// much of a cosine where a path grazes.
double rounding_of_cosines(const Scene& scene, const Path& path) {
  double sum = 0.0;
  for (int x = 1; x < path.depth(); ++x) {
    for (const Vec3& w : {path.toward_light(scene, x), path.toward_camera(scene, x)}) {
      sum += 0x1p-18 / std::max(double{path.vertex(x).cosine(w)}, 1e-18);
    }
  }
  return sum;
}

[[noreturn]] void fail(const std::string& what, Technique technique) {
  throw std::logic_error("bug: a recorded path of technique (" + std::to_string(technique.s) + "," +
                         std::to_string(technique.t) + ") " + what);
}
}  // namespace

void verify(const Scene& scene, const PathSamplerSettings& settings, const Path& path,
            const Contribution& contribution) {
  const Technique technique = contribution.technique;
  if (path.depth() != technique.depth()) fail("has another depth", technique);
  if (path.segments.size() != path.vertices.size() + 1) fail("lacks a segment", technique);
  for (int x = 1; x < path.depth(); ++x) {
    const InnerVertex& vertex = path.vertex(x);
    if (!vertex.event.specular()) continue;
    const auto sample =
        vertex.bsdf.specular(path.toward_camera(scene, x), vertex.event, TransportMode::Radiance);
    if (!sample) fail("scatters by no specular lobe at vertex " + std::to_string(x), technique);
    if (!(length(sample->wi - path.toward_light(scene, x)) < kDirection)) {
      fail("goes elsewhere at specular vertex " + std::to_string(x), technique);
    }
  }
  const Spectrum expected = throughput(scene, path, technique);
  const double recorded =
      tries(settings, technique) / (contribution.mis_weight * double{contribution.chance});
  const double tolerance =
      kRelative + rounding_of_lengths(scene, path) + rounding_of_cosines(scene, path);
  for (int lane = 0; lane < 3; ++lane) {
    const double value = double{contribution.value[lane]} * recorded;
    const double largest = std::max(value, double{expected[lane]});
    if (!(std::abs(value - double{expected[lane]}) <= tolerance * largest + 1e-30)) {
      fail("is worth " + std::to_string(expected[lane]) + ", not " + std::to_string(value) +
               " in lane " + std::to_string(lane),
           technique);
    }
  }
}

}  // namespace ajar
