#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "image/make_filter.h"
#include "measuring/bench_scenes.h"
#include "measuring/variant.h"
#include "session/output.h"
#include "session/preparation.h"
#include "session/render_job.h"

/// How well renders keep to a time limit: what they take less what was asked for, and how long
/// their passes are. A pass that is begun is finished, so a limit cannot be kept more closely than
/// that.
namespace ajar::bench {
namespace {

constexpr Vec2i kSize(320, 240);

struct TimeKept {
  double seconds = 0.0;
  double longest_pass = 0.0;
};

/// Is asked after each pass whether it wants the picture, and looks at the clock instead.
class PassClock final : public PassObserver {
 public:
  bool wants_picture(const JobState& state) override {
    const double now = clock_.seconds();
    if (state.passes > 0) longest_ = std::max(longest_, now - last_);
    last_ = now;
    return false;
  }
  void see_picture(const Film& /*film*/, const JobState& /*state*/) override {}
  double longest() const { return longest_; }

 private:
  Stopwatch clock_;
  double last_ = 0.0;
  double longest_ = 0.0;
};

/// As `ajar render --time` does it: the limit covers the preparation, too.
TimeKept render_for(double seconds, const Scene& scene, const Variant& variant) {
  const Stopwatch clock;
  RenderSettings settings;
  settings.resolution = kSize;
  settings.crop = Box2i(Vec2i(0, 0), kSize - Vec2i(1, 1));
  settings.max_depth = 16;
  const auto integrator = variant.make(scene, settings);
  prepare(*integrator);
  Film film(kSize, settings.crop, make_filter(scene.film().filter), settings.replicates,
            integrator->layers());
  PassClock passes;
  RenderJobOptions options;
  options.budget.seconds = seconds - clock.seconds();
  options.estimate_error = [&](const Film& now, std::uint64_t samples) {
    return estimate_error(now, *integrator, samples);
  };
  options.observers = {&passes};
  RenderJob(*integrator, film, std::move(options)).run();
  return {clock.seconds(), passes.longest()};
}

/// Of all integrators, or of those named.
void measure_time_limits(const std::vector<std::string>& names) {
  fmt::print("{:<12} {:>8} {:>10} {:>12} {:>14}\n", "integrator", "asked, s", "taken, s",
             "difference", "longest pass");
  const BenchScene scene = choose_scenes(bench_scenes(), {"cornell"}).front();
  Warnings warnings;
  const Scene built(scene.load(warnings), BuildOptions{kSize}, warnings);
  for (const IntegratorInfo& info : integrators()) {
    if (!names.empty() && std::find(names.begin(), names.end(), info.name) == names.end()) continue;
    for (const double asked : {5.0, 20.0}) {
      const TimeKept kept = render_for(asked, built, parse_variant(info.name));
      fmt::print("{:<12} {:>8.0f} {:>10.2f} {:>10.1f} % {:>12.2f} s\n", info.name, asked,
                 kept.seconds, 100.0 * (kept.seconds / asked - 1.0), kept.longest_pass);
    }
  }
}

}  // namespace
}  // namespace ajar::bench

int main(int argc, char** argv) {
  ajar::bench::measure_time_limits({argv + 1, argv + argc});
  return 0;
}
