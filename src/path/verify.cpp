#include "path/verify.h"

#include <stdexcept>
#include <string>

#include "core/number_text.h"
#include "path/heuristics.h"
#include "path/measure.h"

namespace ajar {

namespace {
/// Error of positions in single precision, seen through a few sharp lobes.
constexpr float kDirection = 2e-3F;
constexpr double kRelative = 0.02;

/// Tolerance of positions, in units of the film's longer side. Beside it are roundings of
/// positions.
constexpr float kOnFilm = 1e-4F;

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

[[noreturn]] void fail(const std::string& what, std::string_view of) {
  throw std::logic_error("bug: a path of " + std::string(of) + " " + what);
}

/// Between a direction that an event gives and the one of the path.
double difference(const Scene& scene, const Path& path, int x, std::string_view of) {
  const InnerVertex& vertex = path.vertex(x);
  const auto sample =
      vertex.bsdf.specular(path.toward_camera(scene, x), vertex.event, TransportMode::Radiance);
  if (!sample) fail("scatters by no specular lobe at vertex " + std::to_string(x), of);
  return double{length(sample->wi - path.toward_light(scene, x))};
}

bool has_length(const Scene& scene, const Path& path, int edge) {
  return !(edge == 0 && path.light->at_infinity()) &&
         !(edge == path.depth() - 1 && scene.camera().at_infinity());
}
double length_of(const Path& path, int edge) {
  return double{length(path.position(edge + 1) - path.position(edge))};
}

/// By which an edge may be turned: its ends are rounded, and walks miss theirs by as much.
double turned(const Scene& scene, const Path& path, int edge) {
  if (!has_length(scene, path, edge)) return 0.0;
  double way = 0.0;
  for (int other = 0; other < path.depth(); ++other) {
    if (has_length(scene, path, other)) way += length_of(path, other);
  }
  const double size =
      double{std::max(length(path.position(edge)), length(path.position(edge + 1)))};
  return (PathHeuristics::kWalkTolerance * way + 0x1p-22 * size) /
         std::max(length_of(path, edge), 1e-18);
}
}  // namespace

void verify(const Scene& scene, const Path& path, std::string_view made_by) {
  const int k = path.depth();
  if (path.segments.size() != path.vertices.size() + 1) fail("lacks a segment", made_by);
  for (int x = 1; x < k; ++x) {
    if (!path.vertex(x).event.specular()) continue;
    // Where light leaves at a grazing angle, its direction hangs on the other one the more.
    const double grazing =
        std::max(double{path.vertex(x).cosine(path.toward_light(scene, x))}, 1e-3);
    const double tolerance =
        double{kDirection} + 4.0 * (turned(scene, path, x - 1) + turned(scene, path, x)) / grazing;
    if (!(difference(scene, path, x, made_by) < tolerance)) {
      fail("goes elsewhere at specular vertex " + std::to_string(x), made_by);
    }
  }
  const auto raster = scene.camera().raster(path.camera_point, path.toward_light(scene, k));
  if (!raster) return;  // beyond the image, where wide filters look
  const Vec2i pixels = scene.camera().resolution();
  const double tolerance = (double{kOnFilm} + 4.0 * turned(scene, path, k - 1)) *
                           static_cast<double>(std::max(pixels.x, pixels.y));
  if (!(static_cast<double>((*raster - path.raster).length()) < tolerance)) {
    fail("is not seen where it lands on the film", made_by);
  }
}

void verify(const Scene& scene, const PathSamplerSettings& settings, const Path& path,
            const Contribution& contribution) {
  const Technique technique = contribution.technique;
  const std::string made_by = "technique (" + std::to_string(technique.s) + "," +
                              std::to_string(technique.t) + "), as recorded,";
  if (path.depth() != technique.depth()) fail("has another depth", made_by);
  if (path.segments.size() != path.vertices.size() + 1) fail("lacks a segment", made_by);
  for (int x = 1; x < path.depth(); ++x) {
    if (!path.vertex(x).event.specular()) continue;
    if (!(difference(scene, path, x, made_by) < double{kDirection})) {
      fail("goes elsewhere at specular vertex " + std::to_string(x), made_by);
    }
  }
  const Spectrum expected = throughput(scene, path, technique);
  const double recorded =
      tries(settings, technique) / (contribution.mis_weight * double{contribution.roulette_weight});
  const double tolerance =
      kRelative + rounding_of_lengths(scene, path) + rounding_of_cosines(scene, path);
  for (int lane = 0; lane < 3; ++lane) {
    const double value = double{contribution.value[lane]} * recorded;
    const double largest = std::max(value, double{expected[lane]});
    if (!(std::abs(value - double{expected[lane]}) <= tolerance * largest + 1e-30)) {
      fail("is worth " + number_text(double{expected[lane]}) + ", not " + number_text(value) +
               " in lane " + std::to_string(lane),
           made_by);
    }
  }
}

}  // namespace ajar
