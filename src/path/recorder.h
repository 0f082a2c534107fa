#pragma once
#include <array>
#include <utility>

#include "path/path.h"
#include "transport/path_sampler.h"

namespace ajar {

/// Makes a `Path` of everything that a `PathSampler` finds by `sample` or `sample_light`, whatever
/// the technique. Traces each edge again, so it is for seeds, records and tests, not for the loop
/// of a render. Debug builds verify each path (verify.h).
class PathRecorder : public PathSink {
 public:
  /// For samplers with these settings. The scene must outlive it.
  PathRecorder(const Scene& scene, PathSamplerSettings settings)
      : scene_(scene), settings_(std::move(settings)) {}

  /// Before each call of the sampler, with what it is told of the film. Light subpaths stay: so
  /// `sample_light` and `sample` may follow each other.
  void begin(const Vec2& raster);

  void started(Stream stream, const Endpoint& endpoint, const EndpointPoint& point) final;
  void vertex(Stream stream, const PathVertex& vertex, const Hit* hit) final;
  void scattered(Stream stream, const PathVertex& vertex, const Flight& flight) final;
  void add(const Contribution& contribution) final;

  /// Paths whose edges were interrupted when traced again (roundings at grazing angles), which were
  /// not recorded.
  std::uint64_t lost() const { return lost_; }

 protected:
  /// `path` is overwritten by the next one.
  virtual void record(const Path& path, const Contribution& contribution) = 0;
  const Scene& scene() const { return scene_; }
  const PathSamplerSettings& settings() const { return settings_; }

 private:
  struct Subpath {
    const Endpoint* endpoint = nullptr;
    EndpointPoint point = EndpointPoint::at(Vec3(0.F));
    std::vector<InnerVertex> vertices;  ///< with the event by which the subpath left them
  };
  Subpath& current(Stream stream) {
    return stream == Stream::Light ? light_[light_count_ - 1] : camera_;
  }
  void assemble(const Contribution& contribution);

  const Scene& scene_;
  PathSamplerSettings settings_;
  Vec2 raster_{0.F, 0.F};
  Subpath camera_;
  std::array<Subpath, PathSampler::kMaxLightSubpaths> light_;
  std::size_t light_count_ = 0;
  Path path_;
  RayCounts rays_;
  std::uint64_t lost_ = 0;
};

}  // namespace ajar
