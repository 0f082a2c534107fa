#pragma once
#include <cstdint>
#include <memory>

#include "image/film.h"
#include "integrator/integrator.h"
#include "transport/path_sampler.h"

namespace ajar {

/// What ordinary Monte Carlo leaves to chains of one path that it found.
struct StrongPath {
  Technique technique;
  Vec2 raster;
  int replicate;
  Spectrum value;     ///< the chains' share, as it would be splatted
  double energy;      ///< luminance · importance of it; below 0 in negative lobes of a filter
  std::uint64_t key;  ///< names the randomness of what is done with it
};

/// Does something with such paths, on one thread.
class StrongPathSink {
 public:
  virtual ~StrongPathSink() = default;
  /// `numbers`: those that the path was made of.
  virtual void spread(SampleSource& numbers, const StrongPath& path) = 0;
};

/// Makes the sinks of work items.
class StrongPathSinks {
 public:
  virtual ~StrongPathSinks() = default;
  /// Whether what becomes of the paths is put into the layer "indirect" at a scale of its own,
  /// apart from what ordinary Monte Carlo makes.
  virtual bool apart() const = 0;
  /// For a film; film and counters must outlive the sink.
  virtual std::unique_ptr<StrongPathSink> make(Film& film, Counters& counters) const = 0;
};

}  // namespace ajar
