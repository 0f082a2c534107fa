#pragma once
#include <vector>

#include "transport/path_vertex.h"
#include "transport/sample_source.h"

namespace ajar {

/// The directions, in world space, in which a camera subpath left its vertices. A chain's step that
/// moves nothing but the place on the picture keeps them: the numbers of a direction are relative
/// to the surface, and the same numbers mean another direction where the surface is curved, or
/// where the next triangle has other axes. Light that comes through glass from a small lamp would
/// be lost. (After Veach 1997, section 11.4.2, and Pantaleoni 2017.)
///
/// At each vertex that both the current subpath and the proposed one leave by an invertible lobe,
/// the proposal gets the numbers of the current direction. Which vertices these are is the same for
/// the step back, and so is what it does to the numbers; with du = p dω, the volume of the numbers
/// changes by p_proposal/p_current.
class KeptDirections {
 public:
  explicit KeptDirections(int max_vertices) : current_(size(max_vertices)), proposal_(current_) {}

  /// Before each evaluation.
  void begin() { traced_ = false; }
  /// A camera subpath is going to be traced; with `follow`, in the current one's directions.
  void trace(bool follow);
  /// Before a direction is drawn at `vertex`. Where the one to be kept is not possible, the step is
  /// not either.
  void place(const PathVertex& vertex, float u_lobe, SampleAddress address,
             SampleSource& source) const;
  /// It was drawn.
  void note(const PathVertex& vertex, float u_lobe, const Vec3& wi);
  /// The subpath traced last is the current one; `moved`: if none was traced, it is not known.
  void accept(bool moved);

 private:
  struct Direction {
    float pdf = 0.F;  ///< 0: not to be kept
    Vec3 wi{0.F, 0.F, 0.F};
  };
  static std::size_t size(int max_vertices) { return static_cast<std::size_t>(max_vertices); }

  std::vector<Direction> current_;  ///< by the vertex's edges
  std::vector<Direction> proposal_;
  bool traced_ = false;
  bool follow_ = false;
};

}  // namespace ajar
