#pragma once
#include <array>
#include <utility>

#include "path/path.h"
#include "transport/path_sampler.h"

namespace ajar {

/// Makes a `Path` of everything that a `PathSampler` finds, whatever the technique, at once or half
/// by half. Traces each edge again, so it is for seeds, records and tests, not for the loop
/// of a render. Builds with assertions verify each path (verify.h).
class PathRecorder : public PathSink {
 public:
  /// For samplers with these settings. The scene must outlive it.
  PathRecorder(const Scene& scene, PathSamplerSettings settings)
      : scene_(scene), settings_(std::move(settings)) {}

  /// A subpath as it was traced.
  struct Subpath {
    const Endpoint* endpoint = nullptr;
    EndpointPoint point = EndpointPoint::at(Vec3(0.F));
    std::vector<InnerVertex> vertices;  ///< with the event by which the subpath left them
  };

  /// Called before each call of the sampler that traces subpaths, with its raster position. Earlier
  /// subpaths stay until replaced: so `sample_light` and `sample` may follow each other, and one
  /// half of a path may stay while others are traced for the other.
  void begin(const Vec2& raster);
  // For chains, which may go back to a half after another was tried.
  Subpath& light_half() { return light_.front(); }
  Subpath& camera_half() { return camera_; }

  void started(Stream stream, const Endpoint& endpoint, const EndpointPoint& point) final;
  void vertex(Stream stream, const PathVertex& vertex, const Hit* hit) final;
  void scattered(Stream stream, const PathVertex& vertex, const Flight& flight) final;
  void add(const Contribution& contribution) final;

  /// Paths whose edges were interrupted when traced again (roundings at grazing angles), which were
  /// not recorded.
  std::uint64_t lost() const { return lost_; }

 protected:
  /// True if a path is to be recorded; others cost no ray.
  virtual bool wants(const Contribution& /*contribution*/) { return true; }
  /// `path` is overwritten by the next one.
  virtual void record(const Path& path, const Contribution& contribution) = 0;
  const Scene& scene() const { return scene_; }
  const PathSamplerSettings& settings() const { return settings_; }
  /// Raster position of the camera subpath.
  const Vec2& raster() const { return raster_; }

 private:
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
