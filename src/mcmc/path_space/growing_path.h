#pragma once
#include <optional>
#include <span>

#include "mcmc/path_space/growing_end.h"
#include "path/raster_area.h"

namespace ajar {

/// A path in the making: its two ends, how they start anew, and how they are joined. Holds the
/// scratch memory of one thread.
class GrowingPath {
 public:
  /// Both must outlive it.
  GrowingPath(const Scene& scene, const RasterArea& area)
      : light(scene, Stream::Light), camera(scene, Stream::Camera), scene_(scene), area_(area) {}

  /// Takes over so many vertices of `x` at each end. A camera end of one vertex keeps the place on
  /// the lens.
  void begin(const Path& x, int light_vertices, int camera_vertices);

  // All return false if there is no such thing.

  /// A new light end, which has set off.
  bool emit(SampleSource& source);
  /// A new light end of one vertex, as seen from the camera end.
  bool choose_light(SampleSource& source);
  /// A new place on the lens.
  void choose_lens(SampleSource& source);
  /// The camera end sets off, from its place on the lens, through a place on the film.
  bool look(const Vec2& raster);
  /// The camera end runs into a light: there is nothing left to be joined.
  bool run_into_light(SampleSource& source);

  /// Joins the ends, and gives the path away, if they see each other within the area and every
  /// vertex can scatter as it should. A camera end of one vertex is seen from its place on the
  /// lens; then only the image itself can be looked at.
  bool finish(Path& path);

  /// Joins the ends by a specular chain, in the order from the light; both have vertices of the
  /// scene, or an endpoint at the light. All edges of the chain have to be open.
  bool finish_through(std::span<const InnerVertex> chain, Path& path);

  RayCounts ray_counts() const;

  GrowingEnd light;
  GrowingEnd camera;

 private:
  /// Where on the camera it is seen from; the light end has vertices.
  bool look_at_light_end();
  /// Leaves the scattering events of the last vertices open; false if one cannot be joined there.
  bool stop_ends();
  void assemble(Path& path) const;

  const Scene& scene_;
  const RasterArea& area_;
  Vec2 on_lens_{0.F, 0.F};  ///< numbers of the place
  Vec2 raster_{0.F, 0.F};
  std::optional<Segment> into_light_;  ///< the last one of a path without a joint
  RayCounts joints_;
};

}  // namespace ajar
