#pragma once
#include <array>
#include <optional>
#include <vector>

#include "path/path.h"
#include "transport/path_sampler.h"

namespace ajar {

/// The primary numbers of one path, by vertex of its two subpaths; all others come from a source of
/// fresh ones.
class PathPrimaries final : public SampleSource {
 public:
  /// Vertices of the technique on either side, all numbers as `fresh`, which must
  /// outlive this, has them.
  PathPrimaries(Technique technique, SampleSource& fresh);

  float get(SampleAddress address) override;
  Vec2 get_pair(SampleAddress address) override;
  void set(SampleAddress address, float number);
  void set_pair(SampleAddress address, const Vec2& numbers);

  /// Primary numbers of vertex `vertex` of a subpath.
  using Block = std::array<float, static_cast<std::size_t>(Slot::kCount)>;
  const std::vector<Block>& blocks(Stream stream) const {
    return stream == Stream::Light ? light_ : camera_;
  }

 private:
  float* find(SampleAddress address);

  std::vector<Block> camera_;
  std::vector<Block> light_;
  std::vector<std::pair<SampleAddress, float>> connections_;
  SampleSource* fresh_;
};

struct Inversion {
  PathPrimaries numbers;
  /// Natural logarithm of the density of the path by these numbers: `technique_pdf`, and the
  /// probabilities to survive roulette and to be tried at all.
  double log_density;
};

/// The numbers by which technique (s, t) of a `PathSampler` with these settings samples `path`, at
/// `path.raster`. Numbers that the technique does not determine are taken from `fresh`, at the same
/// addresses (docs/methods/inverses.md): if these are uniform, the result is distributed as the
/// numbers of all samples that give `path`. Light subpaths and tries of next event estimation are
/// the first of their kind (repeat 0). Weak connections are taken to be traced: `PathSink::worth`
/// is infinite.
///
/// Empty if the technique does not belong to the set or cannot make the path, or not by numbers in
/// single precision.
std::optional<Inversion> invert(const Scene& scene, const PathSamplerSettings& settings,
                                const Path& path, Technique technique, SampleSource& fresh);

}  // namespace ajar
