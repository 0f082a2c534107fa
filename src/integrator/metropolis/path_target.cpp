#include "integrator/metropolis/path_target.h"

#include <algorithm>
#include <cmath>

namespace ajar {

namespace {

/// Turns contributions into splats: those of the camera ray's own place into one per layer.
class SplatSink final : public PathSink {
 public:
  /// A light subpath stands for so many that ordinary Monte Carlo has per camera sample.
  SplatSink(const ChainView& view, const ChainWeight* part, PathClass paths, double light_subpaths,
            const Vec2& raster, SplatBuffer& splats)
      : view_(view),
        part_(part),
        paths_(paths),
        light_subpaths_(static_cast<float>(light_subpaths)),
        raster_(raster),
        splats_(splats),
        first_(splats.size()) {}

  void add(const Contribution& contribution) override {
    if (!has_paths(paths_, contribution.unidirectional_only)) return;
    const std::int32_t layer = splat_layer(contribution.technique.depth());
    const bool from_light = contribution.technique.t == 1;
    const Vec2& raster = from_light ? contribution.raster : raster_;
    Spectrum value = contribution.value;
    if (part_ != nullptr) value *= part_->weight(contribution, raster);
    if (contribution.technique.s >= 2) value *= light_subpaths_;
    if (from_light) {
      value *= static_cast<float>(view_.pixels / view_.area());
      splats_.push_back({raster, layer, value});
      return;
    }
    for (std::size_t i = first_; i < splats_.size(); ++i) {
      Splat& splat = splats_[i];
      if (splat.layer == layer && splat.raster == raster_) {
        splat.value += value;
        return;
      }
    }
    splats_.push_back({raster_, layer, value});
  }
  bool reaches(const Vec2& raster) const override { return view_.contains(raster); }

 private:
  const ChainView& view_;
  const ChainWeight* part_;
  PathClass paths_;
  float light_subpaths_;
  Vec2 raster_;
  SplatBuffer& splats_;
  std::size_t first_;
};

Vec2 raster_of(SampleSource& numbers, const ChainView& view) {
  return view.raster(numbers.get_pair({Stream::Camera, 0, kEmissionDirection}));
}

}  // namespace

float TechniqueChoice::number_of(Technique technique, float u) const {
  // Off the ends, where rounding would choose a neighbour.
  constexpr float kEnd = 0x1p-12F;
  const auto place = std::find(techniques_.begin(), techniques_.end(), technique);
  return (static_cast<float>(place - techniques_.begin()) + std::clamp(u, kEnd, 1.F - kEnd)) /
         static_cast<float>(techniques_.size());
}

double contribution(std::span<const Splat> splats, const ImportanceMap& importance) {
  double sum = 0.0;
  for (const Splat& splat : splats) {
    // One lane below zero must not hide behind the others.
    if (splat.value.min() < 0.F) return -1.0;
    sum +=
        static_cast<double>(luminance(splat.value)) * static_cast<double>(importance(splat.raster));
  }
  return sum;
}

bool traces_light_alone(const PathSamplerSettings& settings) {
  return settings.techniques.any(TechniqueClass::Light) &&
         !settings.techniques.any(TechniqueClass::Inner);
}

WholePathTarget::WholePathTarget(const Scene& scene, const PathSamplerSettings& settings,
                                 const ChainView& view, const ChainWeight* part, PathClass paths)
    : view_(view),
      part_(part),
      paths_(paths),
      light_alone_(traces_light_alone(settings)),
      sampler_(scene, settings),
      directions_(settings.max_depth + 1) {
  sampler_.keep_directions(&directions_);
}

double WholePathTarget::evaluate(SampleSource& numbers, const Change& change, SplatBuffer& splats) {
  directions_.begin();
  directions_.trace(change.raster);
  const Vec2 raster = raster_of(numbers, view_);
  SplatSink sink(view_, part_, paths_, 1.0, raster, splats);
  if (light_alone_) sampler_.sample_light(numbers, sink);
  sampler_.sample(numbers, raster, sink);
  return contribution(splats, view_.importance);
}

TechniqueChoice::TechniqueChoice(const TechniqueSet& set, int depth) {
  for (int s = 0; s <= depth; ++s) {
    if (set.enabled({s, depth + 1 - s})) techniques_.push_back({s, depth + 1 - s});
  }
}

TechniqueChoice::Chosen TechniqueChoice::choose(float u) const {
  const auto count = static_cast<float>(techniques_.size());
  const auto i = std::min(static_cast<std::size_t>(u * count), techniques_.size() - 1);
  return {i, techniques_[i], 1.F / count};
}

OnePathTarget::OnePathTarget(const Scene& scene, const PathSamplerSettings& settings,
                             const TechniqueChoice& choice, const ChainView& view,
                             const ChainWeight* part, PathClass paths)
    : view_(view),
      part_(part),
      paths_(paths),
      light_subpaths_(settings.light_subpaths),
      uses_lane_(std::ranges::any_of(scene.media(),
                                     [](const auto& medium) { return medium->scatters(); })),
      sampler_(scene, settings),
      choice_(choice),
      directions_(settings.max_depth + 1) {
  sampler_.keep_directions(&directions_);
}

template <typename Trace>
const PathVertex* OnePathTarget::half(Halves& halves, int vertices, int lane, bool moved,
                                      const Trace& trace) {
  const Half& current = halves.current();
  if (!moved && current.vertices == vertices && current.lane == lane) {
    return current.complete ? &current.end : nullptr;
  }
  Half& proposal = halves.proposal();
  proposal.vertices = vertices;
  proposal.lane = lane;
  proposal.complete = trace(proposal.end);
  return proposal.complete ? &proposal.end : nullptr;
}

double OnePathTarget::evaluate(SampleSource& numbers, const Change& change, SplatBuffer& splats) {
  change_ = change;
  light_.proposal().vertices = 0;
  camera_.proposal().vertices = 0;
  directions_.begin();
  chosen_ = choice_.choose(numbers.get({Stream::Connection, 0, kTechniqueChoice}));
  const int s = chosen_.technique.s;
  const int t = chosen_.technique.t;
  const Vec2 raster = t >= 2 ? raster_of(numbers, view_) : Vec2(0.F, 0.F);
  SplatSink sink(view_, part_, paths_, light_subpaths_, raster, splats);
  if (s == 0) {
    directions_.trace(change.raster);
    sampler_.sample_implicit(numbers, raster, t, sink, nullptr);
  } else {
    static const PathVertex kEndpointAlone{};
    const int lane = uses_lane_ ? lane_of(numbers.get(kLaneChoice)) : 0;
    const PathVertex* camera_end = &kEndpointAlone;
    const PathVertex* light_end = &kEndpointAlone;
    if (t >= 2) {
      camera_end = half(camera_, t, lane, change.moves_camera_half(), [&](PathVertex& end) {
        directions_.trace(change.raster);
        return sampler_.trace_camera_half(numbers, raster, t, end, nullptr);
      });
      if (camera_end == nullptr) return 0.0;
    }
    if (s >= 2) {
      light_end = half(light_, s, lane, change.light, [&](PathVertex& end) {
        return sampler_.trace_light_half(numbers, s, end, nullptr);
      });
      if (light_end == nullptr) return 0.0;
    }
    sampler_.connect_halves(chosen_.technique, *light_end, *camera_end, numbers, sink);
  }
  for (Splat& splat : splats) splat.value /= chosen_.probability;
  return contribution(splats, view_.importance);
}

void OnePathTarget::keep(Halves& halves, bool moved) {
  if (halves.proposal().vertices > 0) {
    halves.now = 1 - halves.now;
  } else if (moved) {
    halves.current().vertices = 0;  // its numbers have changed, unseen
  }
}

void OnePathTarget::accepted() {
  keep(light_, change_.light);
  keep(camera_, change_.moves_camera_half());
  directions_.accept();
}

void OnePathTarget::rejected() {}

}  // namespace ajar
