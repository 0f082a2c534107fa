#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "measuring/bench_scenes.h"
#include "measuring/measured_scene.h"

/// Common parts of the main programs of studies.
namespace ajar::bench {

/// `run`, with signals counted and errors reported as those of `name`. Returns its result, or the
/// error's exit code.
int bench_main(const std::string& name, const std::function<int()>& run);

/// Scenes of these names; the built-in ones if there are none. Raises UsageError.
std::vector<BenchScene> scenes_of(const std::vector<std::string>& names);

/// `measure` for each scene. Returns the exit code: that of an interruption, which ends it.
int measure_each(const std::vector<BenchScene>& scenes,
                 const std::function<void(const BenchScene&)>& measure);

/// The options by which scenes are chosen and measured.
void add_measure_options(CLI::App& app, std::vector<std::string>& scenes, MeasureOptions& options);

}  // namespace ajar::bench
