#include "integrator/montecarlo/blind_spots.h"

#include <algorithm>
#include <string>

#include "core/number_text.h"
#include "integrator/montecarlo/clear_vertex.h"
#include "integrator/montecarlo/heuristics.h"
#include "integrator/montecarlo/small_lamps.h"
#include "transport/sources.h"

namespace ajar {

namespace {

constexpr WarningKind kUnseenMirrors{Effect::Light, "methods do not see mirrors and clear glass"};
constexpr WarningKind kMissingDepths{Effect::Light, "methods do not make paths of all lengths"};
constexpr WarningKind kUnseenLamps{Effect::Light, "methods do not see point lamps behind glass"};
constexpr WarningKind kUnseenThrough{
    Effect::Light, "methods do not see, through glass, what point lamps light through glass"};
constexpr WarningKind kRareLamps{Effect::Light,
                                 "methods find small lamps behind glass by chance alone"};
constexpr WarningKind kRareThrough{
    Effect::Light, "methods find by chance, through glass, what small lamps light through glass"};

constexpr std::uint32_t kSamples = MonteCarloHeuristics::kLookingAround;

/// Counts subpaths of either end, and those whose first vertex is clear; light subpaths only of
/// lamps that no ray runs into. For other lamps it records where their light leaves clear surfaces.
class ClearSink final : public PathSink {
 public:
  void add(const Contribution& /*contribution*/) override {}
  bool reaches(const Vec2& /*raster*/) const override { return false; }
  void started(Stream stream, const Endpoint& endpoint, const EndpointPoint& /*point*/) override {
    vertices_ = 0;
    all_clear_ = true;
    if (stream != Stream::Light) return;
    lamp_ = &endpoint;
    ++light_paths;
  }
  void vertex(Stream stream, const PathVertex& vertex, const Hit* /*hit*/) override {
    ++vertices_;
    const bool was_clear = all_clear_ && vertices_ > 1;
    all_clear_ = all_clear_ && is_clear(vertex);
    if (stream == Stream::Light) {
      if (lamp_->discrete_position()) {
        if (vertices_ == 1 && all_clear_) ++lit;
      } else if (was_clear && vertex.connectible()) {
        landings.push_back({lamp_, vertex});
      }
    } else {
      if (vertices_ == 1 && all_clear_) ++seen;
      if (was_clear && vertex.connectible()) ++seen_through;
    }
  }

  int seen = 0;
  int seen_through = 0;  ///< something else, after vertices that were all clear
  int light_paths = 0;
  std::size_t lit = 0;
  std::vector<Landing> landings;

 private:
  int vertices_ = 0;  ///< length of the current subpath
  bool all_clear_ = true;
  const Endpoint* lamp_ = nullptr;
};

ClearSink look_around(const Scene& scene, const RenderSettings& settings,
                      PathSamplerSettings sampler_settings) {
  // No shadow rays from camera paths: vertices alone are looked at.
  sampler_settings.techniques = TechniqueSet::parse("implicit,light");
  sampler_settings.max_depth =
      std::min(sampler_settings.max_depth, MonteCarloHeuristics::kLookingAroundEdges);
  PathSampler sampler(scene, sampler_settings);
  ClearSink sink;
  const Vec2 low(settings.crop.min);
  const Vec2 size(settings.crop.size() + Vec2i(1, 1));
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    SobolSource source({settings.seed, i, settings.seed, i});
    sampler.sample(source, low + source.get_pair({Stream::Camera, 0, kEmissionDirection}) * size,
                   sink);
    sampler.sample_light(source, sink);
  }
  return sink;
}

/// Names the depths of which no technique makes paths; empty if there are none.
std::string missing_depths(const PathSamplerSettings& sampler) {
  constexpr int kEnough = MonteCarloHeuristics::kDepthsNamed;
  std::string missing;
  bool made = true;
  for (int depth = sampler.min_depth; depth <= std::min(sampler.max_depth, kEnough); ++depth) {
    made = false;
    for (int s = 0; s <= depth; ++s) made = made || sampler.techniques.enabled({s, depth + 1 - s});
    if (!made) missing += (missing.empty() ? "" : ", ") + std::to_string(depth);
  }
  const bool more = !made && sampler.max_depth > kEnough;
  return missing + (more ? ", …" : "");
}

}  // namespace

std::vector<Warning> blind_spots(const Scene& scene, const RenderSettings& settings,
                                 const PathSamplerSettings& widened, bool joins_by_manifolds) {
  // Limits of edges may be wider than the depths that count.
  PathSamplerSettings sampler = widened;
  sampler.min_depth = std::max(sampler.min_depth, sampler.counted.minimum);
  sampler.max_depth = std::min(sampler.max_depth, sampler.counted.maximum);
  if (const std::string depths = missing_depths(sampler); !depths.empty()) {
    return {{kMissingDepths,
             {},
             "none of the techniques makes paths of " + depths + " edges: their light is missing"}};
  }
  const TechniqueSet& set = sampler.techniques;
  // Mirror and lamp; glass, what it lights, and the lens.
  constexpr int kSeenMirror = 2;
  constexpr int kCaustic = 3;
  const bool to_lens_only = sampler.max_depth >= kSeenMirror && set.any(TechniqueClass::Light) &&
                            !set.any(TechniqueClass::Implicit) &&
                            !set.any(TechniqueClass::NextEvent) && !set.any(TechniqueClass::Inner);
  const bool has_caustics = sampler.max_depth >= kCaustic && !scene.light_sampler().empty();
  const bool from_camera_only =
      has_caustics && !set.any(TechniqueClass::Light) && !set.any(TechniqueClass::Inner);
  // With one more edge there is glass before the lens, too.
  const bool through = has_caustics && sampler.max_depth > kCaustic && !joins_by_manifolds;
  if (!to_lens_only && !from_camera_only && !through) return {};
  const ClearSink found = look_around(scene, settings, sampler);
  std::vector<Warning> spots;
  if (to_lens_only && found.seen > 0) {
    spots.push_back(
        {kUnseenMirrors,
         {},
         percent_text(static_cast<double>(found.seen) / kSamples) +
             " of the picture shows mirrors or clear glass, which light tracing cannot see: its "
             "light is missing there; bdpt and ibpt see them"});
  }
  const bool sees_through = through && found.seen_through > 0;
  if (!from_camera_only && !sees_through) return spots;
  const auto of_light = [&](std::size_t paths) {
    return percent_text(static_cast<double>(paths) / std::max(found.light_paths, 1)) +
           " of the light goes from ";
  };
  const std::string seen_through =
      ", and " + percent_text(static_cast<double>(found.seen_through) / kSamples) +
      " of the picture looks through them: what is lit in this way and seen in this way is ";
  constexpr const char* kWhoSees =
      "; mlt finds it, and selective and erpt unless they are told otherwise";
  if (found.lit > 0) {
    const std::string lit =
        of_light(found.lit) + "a point or distant lamp straight to mirrors or clear glass";
    if (sees_through) {
      spots.push_back(
          {kUnseenThrough,
           {},
           lit + seen_through + "too dark, since no technique makes such paths" + kWhoSees});
    }
    if (from_camera_only) {
      spots.push_back(
          {kUnseenLamps,
           {},
           lit +
               ": what they throw on other things is missing, since no camera path runs into such "
               "a lamp; bdpt and ibpt see it, unless through mirrors or clear glass again"});
    }
  }
  const std::size_t small = landings_of_small_lamps(scene, found.landings, found.light_paths,
                                                    sampler.max_depth, settings.seed);
  if (small > 0) {
    const std::string lit =
        of_light(small) +
        "lamps so small that hardly a ray runs into them through mirrors or clear glass";
    if (sees_through) {
      spots.push_back({kRareThrough,
                       {},
                       lit + seen_through +
                           "found by chance, and may be missing where the error "
                           "is small" +
                           kWhoSees});
    }
    if (from_camera_only) {
      spots.push_back({kRareLamps,
                       {},
                       lit +
                           ": what they throw on other things is found by chance, and may be "
                           "missing where the error is small; bdpt and ibpt see it, unless through "
                           "mirrors or clear glass again"});
    }
  }
  return spots;
}

}  // namespace ajar
