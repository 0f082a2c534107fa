#include "measuring/bench_main.h"

#include <fmt/format.h>

#include "core/error.h"
#include "session/job/interrupts.h"
#include "session/scenes/builtin_scenes.h"

namespace ajar::bench {

namespace {
constexpr int kExitInterrupted = 130;
}  // namespace

int bench_main(const std::string& name, const std::function<int()>& run) {
  try {
    install_interrupt_handlers();
    return run();
  } catch (const Error& error) {
    fmt::print(stderr, "{}: {}\n", name, error.what());
    return error.exit_code();
  }
}

std::vector<BenchScene> scenes_of(const std::vector<std::string>& names) {
  return choose_scenes(bench_scenes(), names.empty() ? builtin_scene_names() : names);
}

int measure_each(const std::vector<BenchScene>& scenes,
                 const std::function<void(const BenchScene&)>& measure) {
  begin_render();
  for (const BenchScene& scene : scenes) {
    measure(scene);
    if (interrupt_count() > 0) return kExitInterrupted;
  }
  return 0;
}

void add_measure_options(CLI::App& app, std::vector<std::string>& scenes, MeasureOptions& options) {
  app.add_option("--scenes", scenes, "Default: the built-in ones")->delimiter(',');
  app.add_option("--references", options.folder, "Folder of references");
  app.add_option("--reference-seconds", options.reference_seconds,
                 "CPU-seconds of a reference that is made");
  app.add_option("--reference-methods", options.reference_methods,
                 "Methods that references are made by, such as bdpt")
      ->delimiter(',');
}

}  // namespace ajar::bench
