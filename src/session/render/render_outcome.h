#pragma once
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "post/display.h"
#include "session/output/final_files.h"
#include "session/output/stats_json.h"

namespace ajar {

/// Result of a render.
struct RenderOutcome {
  bool interrupted = false;
  /// All layers, with metadata. Null if it was interrupted before there was one, and on ranks that
  /// only help another: then there is nothing else but part of the statistics.
  std::shared_ptr<const Picture> picture;
  DisplayOptions display;  ///< display options of its files
  RenderStatistics statistics;
  std::vector<WrittenFile> files;  ///< pictures, and the checkpoint
  std::string statistics_error;    ///< why they could not be written; empty if they could

  /// True if each file is where it should be.
  bool all_written() const {
    return statistics_error.empty() &&
           std::all_of(files.begin(), files.end(),
                       [](const WrittenFile& file) { return file.error.empty(); });
  }
};

}  // namespace ajar
