#pragma once
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ajar/settings.h"
#include "core/work_slice.h"
#include "session/job/budget.h"
#include "session/options/display.h"
#include "session/options/option_values.h"

namespace ajar {

/// Specification of a render, as asked for: the settings of programs, and options of the command
/// line alone. An empty member comes from the checkpoint that is gone on with, from the scene, or
/// has a default. Each member has a row in `render_options`.
struct RenderSpec : v0::Settings {
  RenderSpec() { denoise.clear(); }
  explicit RenderSpec(v0::Settings settings) : v0::Settings(std::move(settings)) {}

  std::map<std::string, std::string> definitions;  ///< for `load_scene`
  std::optional<CropWindow> crop_window;           ///< instead of `crop`
  WorkSlice share;

  // Files that are written, and how pictures for the eye are shown: none of it decides the bits.
  std::vector<std::string> outputs;    ///< pictures
  std::optional<double> output_every;  ///< seconds, while rendering; empty: in the end
  std::string tone_map;
  std::optional<Exposure> exposure;
  std::string preview;      ///< as `parse_viewer` reads it
  std::string statistics;   ///< JSON
  std::string resume_from;  ///< a checkpoint, if there is such a file
  bool force = false;       ///< go on with checkpoints of other versions or scenes

  Budget budget() const { return {samples_per_pixel, seconds, target_error, denoised_target}; }
  void set_budget(const Budget& budget);
  std::string tone_map_name() const { return tone_map.empty() ? "srgb" : tone_map; }
  std::string denoiser_name() const { return denoise.empty() ? "none" : denoise; }
  /// Raises UsageError for a curve that is none.
  Display display() const;
  /// Pictures, statistics and checkpoint.
  std::vector<std::string> files() const;
  /// True if "all" layers were asked for: those that the method can make.
  bool wants_all_layers() const { return layers == std::vector<std::string>{"all"}; }
  /// True if the user chose the size of the picture: else a picture too large is the scene's fault.
  bool has_size() const { return resolution || scale; }
};

}  // namespace ajar
