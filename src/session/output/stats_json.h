#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/warnings.h"
#include "session/checkpoint/checkpoint.h"
#include "session/job/render_job.h"

namespace ajar {

/// Wall clock of the steps before rendering and after it, seconds.
struct StepTimes {
  double load = 0.0;     ///< files → description
  double build = 0.0;    ///< description → scene, acceleration structures
  double prepare = 0.0;  ///< integrator, film
  double denoise = 0.0;  ///< time of denoising the last picture; after rendering
};

/// Everything that `--stats` says about a render.
struct RenderStatistics {
  RenderRecord render;  ///< its scene as the user calls it
  StepTimes times;
  RenderResult result;
  Counters preparation;                        ///< counts before the first pass
  bool prepared = true;                        ///< false: there was no time for it
  std::string resumed_from;                    ///< file; empty: this run began anew
  std::uint32_t resumptions = 0;               ///< count over the whole render
  std::uint32_t interruptions = 0;             ///< by signals
  int ranks = 1;                               ///< processes that rendered together
  std::shared_ptr<const MethodReport> report;  ///< null: nothing is told
  std::uint64_t peak_memory_bytes = 0;
  std::size_t warning_count = 0;
  std::vector<std::string> warnings;  ///< texts, at most `Warnings::kMaxKept`
  std::vector<std::string> outputs;
  std::optional<double> denoised_error;         ///< see `denoised_error`
  std::vector<ErrorAtScale> errors_by_scale{};  ///< estimated; empty: unknown
  std::string denoiser;                         ///< name and version; empty: nothing was filtered
  Exposure exposure;  ///< exposure of displayed pictures: `stops` are those used, manual or
                      ///< automatic
};

/// Statistics as JSON with the keys of the manual (docs/command-line.md), those of the method's own
/// report among them. What is not known is null.
nlohmann::ordered_json to_json(const RenderStatistics& statistics);

/// Text for the metadata of images: flat, one entry per parameter and number, keys begin with
/// "ajar:".
std::map<std::string, std::string> to_metadata(const RenderStatistics& statistics);

/// Writes a file in one step (`write_file_atomically`). Raises IoError.
void write_json(const nlohmann::ordered_json& json, const std::string& path);

}  // namespace ajar
