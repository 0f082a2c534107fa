#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "measuring/bench_scenes.h"
#include "measuring/variant.h"
#include "session/job/resources.h"
#include "session/render.h"

/// Accuracy of time limits: the time taken less the limit, and the length of passes. A pass that is
/// begun is finished, so a limit cannot be kept more closely than that.
namespace ajar::bench {
namespace {

constexpr Vec2i kSize(320, 240);

struct TimeKept {
  double seconds = 0.0;
  double longest_pass = 0.0;
};

class PassClock final : public RenderEvents {
 public:
  void work_begun(const std::function<RenderSnapshot()>& /*snapshot*/) override {
    last_ = clock_.seconds();
  }
  void progress(const RenderSnapshot& /*snapshot*/) override {
    const double now = clock_.seconds();
    longest_ = std::max(longest_, now - last_);
    last_ = now;
  }
  double seconds() const { return clock_.seconds(); }
  double longest() const { return longest_; }

 private:
  Stopwatch clock_;
  double last_ = 0.0;
  double longest_ = 0.0;
};

TimeKept render_for(double seconds, const desc::SceneDesc& scene, const Variant& variant) {
  RenderSettings settings;
  settings.resolution = kSize;
  settings.max_depth = 16;
  PassClock passes;
  Render(order_of(variant, scene, settings, seconds), passes).run();
  return {passes.seconds(), passes.longest()};
}

/// Measures all integrators, or those named.
void measure_time_limits(const std::vector<std::string>& names) {
  fmt::print("{:<12} {:>8} {:>10} {:>12} {:>14}\n", "integrator", "asked, s", "taken, s",
             "difference", "longest pass");
  const BenchScene scene = choose_scenes(bench_scenes(), {"cornell"}).front();
  Warnings warnings;
  const desc::SceneDesc description = scene.load(warnings);
  for (const IntegratorInfo& info : integrators()) {
    if (!names.empty() && std::find(names.begin(), names.end(), info.name) == names.end()) continue;
    for (const double asked : {5.0, 20.0}) {
      const TimeKept kept = render_for(asked, description, parse_variant(info.name));
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
