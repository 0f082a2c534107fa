#pragma once
#include <vector>

#include "transport/path_vertex.h"
#include "transport/sample_source.h"

namespace ajar {

/// The directions, in world space, in which a camera subpath left its vertices. A chain's step that
/// moves nothing but the place on the picture keeps them: the numbers of a direction are relative
/// to the surface, so the same numbers turn with its normal, where it is curved or has bumps, and a
/// small lamp seen through glass would be lost. Sources: Veach & Guibas 1997 (lens perturbations);
/// Pantaleoni 2017, "Charted Metropolis Light Transport" (inverse maps).
///
/// At each vertex that both the current subpath and the proposed one leave by a diffuse lobe
/// (`Bsdf::inverse` could do it at others, but highlights move when the surface turns), the
/// proposal gets the numbers of the current direction. The set of vertices is the same for the step
/// back, which gives the numbers back as well; and with du = p dω (solid angle), the volume of the
/// numbers changes by p_proposal/p_current, which belongs to the acceptance.
class KeptDirections {
 public:
  /// For subpaths of no more vertices than that, endpoint included.
  explicit KeptDirections(int max_vertices) {
    current_.reserve(static_cast<std::size_t>(max_vertices));
    proposal_.reserve(static_cast<std::size_t>(max_vertices));
  }

  /// Before each evaluation.
  void begin() { traced_ = false; }
  /// A camera subpath is going to be traced; with `follow`, in the current one's directions.
  void trace(bool follow);
  /// Before a direction is drawn at `vertex`. Where the one to be kept is not possible, the step is
  /// not either.
  void place(const PathVertex& vertex, float u_lobe, SampleAddress address,
             SampleSource& source) const;
  /// Records a sampled direction.
  void note(const PathVertex& vertex, float u_lobe, const Vec3& wi);
  /// The subpath traced since `begin`, if there is one, is the current one from now on.
  void accept();

 private:
  struct Direction {
    float pdf = 0.F;  ///< 0: not to be kept
    Vec3 wi{0.F, 0.F, 0.F};
  };

  std::vector<Direction> current_;  ///< by the vertex's edges, as far as there are any
  std::vector<Direction> proposal_;
  bool traced_ = false;
  bool follow_ = false;
};

}  // namespace ajar
