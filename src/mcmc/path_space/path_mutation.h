#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "mcmc/kernel.h"
#include "path/path.h"

namespace ajar {

/// Vertices that a mutation keeps at the two ends of a path, endpoints included. A camera end of
/// one vertex keeps the place on the lens: the raster position may change.
struct Kept {
  int light = 0;
  int camera = 0;
};

/// ln of the density of impossible events.
inline constexpr double kNever = -std::numeric_limits<double>::infinity();

/// A way to change paths (docs/methods/mlt.md): vertices in the midst of a path, or at its ends,
/// give way to others. Holds the scratch memory of one thread. Source: Veach 1997, section 11.4.
class PathMutation {
 public:
  virtual ~PathMutation() = default;
  virtual std::string_view name() const = 0;
  /// True for paths in which it finds something to change.
  virtual bool suitable(const Path& path) const = 0;
  /// Makes `y` of `x`, which is another object, by the randomness that `key` names; whether there
  /// is any light on it has not been asked. Empty if the attempt came to nothing: then `y` is
  /// anything.
  virtual std::optional<Kept> propose(const Path& x, std::uint64_t key, Path& y) = 0;
  /// ln T(x → y): of the density with which `propose` puts the vertices of `y` that are not `kept`
  /// in the place of those of `x`, over all ways to come there. In the measure of
  /// `contribution`: the deltas of specular vertices, which are to be those over the direction
  /// toward the light, are left out. `kNever` if it never does.
  virtual double log_density(const Path& x, const Path& y, const Kept& kept) const = 0;
  /// Outcome of the last proposal's walk, for mutations that walk.
  virtual WalkEnd walk_end() const { return WalkEnd::None; }
  /// Rays traced so far.
  virtual const RayCounts& ray_counts() const = 0;
};

}  // namespace ajar
