#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/archive_forward.h"
#include "core/vector.h"
#include "transport/path_vertex.h"

namespace ajar {

/// Estimates, place by place, of what a direction brings that a path takes at a vertex, and how
/// many rays that takes: for Russian roulette by efficiency. Source: Rath et al. 2022, "EARS:
/// Efficiency-Aware Russian Roulette and Splitting"; docs/notebook/roulette.md says why paths are
/// not split.
///
/// The product of a picture's variance and rays is smallest if a path of throughput β, seen by a
/// pixel with a ray's price P (`PathSink::rays_per_unit_light` is 1/P), goes on with probability
///
///     β/P · √(M/C)
///
/// M being the second moment of what comes from such directions per unit of throughput, C its rays.
/// β is the throughput behind the vertex. The connection to a lamp has a roulette of its own.
///
/// Light subpaths have cells of their own, and roulette alone. What they bring reaches many pixels,
/// so it is counted in the rays that it is worth there, P being 1; β is the throughput over that
/// with which they set out.
///
/// Cells are those of an octree, times a few kinds of vertices. They are frozen for a round, while
/// sums for the next one are gathered. Sums are integers, so that no order of threads changes a
/// bit.
class EfficiencyCells {
 public:
  /// `magnitude`: of the light of the picture, radiance; the unit of the sums. Positive.
  EfficiencyCells(const Box3& bounds, double magnitude);

  /// √(M/C) of directions drawn by a rough lobe and by a specular one, frozen for a round; 0 where
  /// nothing is known.
  using Worth = std::array<float, 2>;
  /// Number of the cell of a vertex.
  std::uint32_t find(const PathVertex& vertex) const;
  const Worth& worth(std::uint32_t cell) const { return worths_[cell]; }

  /// From any thread. `light`: luminance per unit of throughput.
  void add(std::uint32_t cell, bool specular, double light, std::uint64_t rays);

  /// Between passes: freezes what the sums say, and divides cells that many samples have visited.
  /// The sums of earlier rounds count half in the next.
  void end_round();

  std::size_t cells() const { return worths_.size(); }
  std::uint64_t memory_bytes() const;
  void save_state(OutputArchive& archive) const;
  /// Raises a std::exception if the bytes make no sense.
  void load_state(InputArchive& archive);
  /// All processes have gathered the same sums.
  void agree() { known_ = sums_; }
  /// Sums that this process has gathered since it gave them away last; and takes what one of the
  /// processes has given, which may have been this one.
  void export_delta(OutputArchive& archive);
  void import_delta(InputArchive& archive);

 private:
  /// Sums over samples, in fixed-point numbers.
  struct Moments {
    std::int64_t samples = 0;
    std::int64_t squares = 0;
    std::int64_t rays = 0;

    void add(std::int64_t square_quanta, std::uint64_t own_rays);
    Moments& operator+=(const Moments& other);
    Moments& operator-=(const Moments& other);
    void divide_by(int power_of_two);
    bool empty() const { return samples == 0 && squares == 0 && rays == 0; }
    template <typename AnyArchive>
    void serialize(AnyArchive& archive) {
      archive(samples, squares, rays);
    }
  };
  using Sums = std::array<Moments, 2>;  ///< as in `Worth`
  /// A node of the octree: an inner one, or a leaf with its cells.
  struct Node {
    std::uint32_t children = 0;  ///< index of the first of eight; 0: a leaf
    std::uint32_t cells = 0;     ///< index of a leaf's first cell
    std::uint32_t level = 0;     ///< nodes above it
    template <typename AnyArchive>
    void serialize(AnyArchive& archive) {
      archive(children, cells, level);
    }
  };

  Worth worth_of(const Sums& sums) const;
  /// Fills the table.
  void list_places();
  /// Divides leaves until none of them has too many samples.
  void refine();
  bool is_tree() const;

  Vec3 low_;    ///< corner of the scene
  Vec3 scale_;  ///< from there to places in the octree
  double magnitude_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> table_;  ///< nodes of places, as far as the first levels tell
  std::vector<Worth> worths_;
  std::vector<Sums> sums_;
  std::vector<Sums> known_;  ///< sums that all processes have
};

}  // namespace ajar
