#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "image/relative_error.h"
#include "measuring/bench_main.h"
#include "measuring/measured_scene.h"
#include "measuring/variant.h"
#include "session/job/interrupts.h"
#include "session/render.h"

/// Benefit of time: for each scene and time limit, the time of preparing, the time of the first
/// picture, and the error in the end.
namespace ajar::bench {
namespace {

struct Arguments {
  std::vector<double> seconds = {1, 2, 5, 10, 20, 40};
  int seeds = 4;
  std::string integrator = "selective";
  std::vector<std::string> scenes;
  MeasureOptions measure;
};

/// Notes when the first pass was over.
class FirstPicture final : public RenderEvents {
 public:
  void progress(const RenderSnapshot& /*snapshot*/) override {
    if (!seconds_) seconds_ = clock_.seconds();
  }
  double seconds() const { return seconds_.value_or(clock_.seconds()); }

 private:
  Stopwatch clock_;
  std::optional<double> seconds_;
};

struct Found {
  double preparing = 0.0;
  double first_picture = 0.0;
  double samples = 0.0;
  double squared_error = 0.0;
};

Found render_for(double seconds, const MeasuredScene& measured, const Variant& variant,
                 std::uint64_t seed) {
  RenderSettings settings = measured.settings;
  settings.seed = seed;
  RenderRequest order = order_of(variant, measured.description, settings, seconds);
  order.interrupts = &interrupt_count();
  FirstPicture first;
  Render render(std::move(order), first);
  const RenderOutcome& outcome = render.run();
  Found found;
  if (!outcome.picture) return found;  // interrupted
  found.preparing = outcome.statistics.times.prepare;
  found.first_picture = first.seconds();
  found.samples = static_cast<double>(outcome.statistics.result.samples_per_pixel);
  const double error =
      relative_error(outcome.picture->layers.front().pixels, measured.references.mean)
          .value_or(0.0);
  found.squared_error =
      std::max(0.0, error * error - measured.references.error * measured.references.error);
  return found;
}

void measure(const BenchScene& scene, const Arguments& arguments) {
  const Variant variant = parse_variant(arguments.integrator);
  const auto measured = measure_scene(scene, arguments.measure);
  if (!measured) return;
  for (const double seconds : arguments.seconds) {
    Found mean;
    for (int seed = 1; seed <= arguments.seeds; ++seed) {
      const Found found = render_for(seconds, *measured, variant, static_cast<std::uint64_t>(seed));
      if (interrupt_count() > 0) return;
      mean.preparing += found.preparing / arguments.seeds;
      mean.first_picture += found.first_picture / arguments.seeds;
      mean.samples += found.samples / arguments.seeds;
      mean.squared_error += found.squared_error / arguments.seeds;
    }
    fmt::print("| {} | {:g} | {:.2f} | {:.2f} | {:.0f} | {:.3g} |\n", scene.name, seconds,
               mean.preparing, mean.first_picture, mean.samples, std::sqrt(mean.squared_error));
    std::fflush(stdout);
  }
}

int run(int count, char** texts) {
  Arguments arguments;
  CLI::App app("Renders scenes for several times, and tells what more time brings.");
  app.add_option("--seconds", arguments.seconds, "Time limits, wall clock")->delimiter(',');
  app.add_option("--seeds", arguments.seeds, "Seeds, from 1");
  app.add_option("--integrator", arguments.integrator, "Method, as in mmlt:split=100");
  add_measure_options(app, arguments.scenes, arguments.measure);
  CLI11_PARSE(app, count, texts);
  fmt::print(
      "| scene | time, s | preparing, s | first picture, s | samples per pixel | error |\n"
      "|---|---|---|---|---|---|\n");
  return measure_each(scenes_of(arguments.scenes),
                      [&](const BenchScene& scene) { measure(scene, arguments); });
}

}  // namespace
}  // namespace ajar::bench

int main(int argc, char** argv) {
  return ajar::bench::bench_main("ajar_budget_bench", [&] { return ajar::bench::run(argc, argv); });
}
