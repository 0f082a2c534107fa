#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "core/warnings.h"
#include "image/film.h"
#include "integrator/montecarlo/scene_features.h"
#include "scene/scene.h"
#include "session/output/picture_filter.h"
#include "session/output/stats_json.h"
#include "session/preview/preview.h"
#include "session/render/render_events.h"
#include "session/render/render_monitor.h"
#include "session/render/render_plan.h"
#include "session/render/render_request.h"

namespace ajar {

/// State of a render, filled in step by step (`render_scene.h`, `render_method.h`,
/// `render_passes.h`). Owned by the thread that renders; others use `monitor`.
struct RenderState {
  RenderRequest request;
  RenderEvents& events;
  const InterruptCount& interrupts;
  RenderMonitor& monitor;

  Warnings warnings{};
  RenderStatistics statistics{};  ///< all that is known beside the passes
  std::optional<RenderPlan> plan{};
  std::shared_ptr<const Scene> scene{};
  std::unique_ptr<Integrator> integrator{};
  std::optional<Film> film{};
  std::shared_ptr<PictureFilter> filter{};  ///< null: pictures are as they were rendered
  std::shared_ptr<FeatureTracer>
      features{};                      ///< for the filter, traced with the passes; may be null
  std::unique_ptr<Preview> preview{};  ///< null: there is none; the writers' once there are passes
  /// False if the user stopped it while it was prepared: what is shown then is another picture, by
  /// ordinary Monte Carlo alone, which no checkpoint must go on with.
  bool has_begun = true;
  std::uint64_t preparation_rounds = 0;
  std::optional<PreparationCut> unprepared{};  ///< why the preparation was cut short, if it was
  double other_seconds = 0.0;       ///< seconds of building and preparing, all runs together
  double kept_seconds = 0.0;        ///< share of samples that stay in the picture
  double filter_seconds = 0.0;      ///< expected time of filtering the finished picture
  std::uint64_t passes_before = 0;  ///< passes of earlier runs

  /// Tells it, and keeps it for the statistics.
  void warn(const Warning& warning);
  /// Statistics of a render with the result `result`.
  RenderStatistics statistics_with(const RenderResult& result) const;
  /// The picture of `film` as it was rendered, with `statistics` as its metadata.
  Picture develop_with(const Film& film, const RenderStatistics& statistics) const;
};

/// While it lives, a render can be seen at work.
class ScopedActivity {
 public:
  ScopedActivity(RenderState& state, std::function<RenderSnapshot()> snapshot);
  ~ScopedActivity();
  ScopedActivity(const ScopedActivity&) = delete;
  ScopedActivity& operator=(const ScopedActivity&) = delete;

 private:
  RenderState& state_;
};

}  // namespace ajar
