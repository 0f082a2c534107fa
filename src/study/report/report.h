#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "study/report/log_plot.h"

namespace ajar {

/// One layer of an image: colours or single numbers.
struct ReportLayer {
  std::string name;           ///< "" for the picture itself
  int channels = 3;           ///< 3 (RGB, interleaved) or 1
  std::vector<float> pixels;  ///< scene-linear, row by row from the top
};

struct ReportImage {
  std::string name;
  int width = 0;
  int height = 0;
  std::vector<ReportLayer> layers;                            ///< at least one; the first is shown
  std::vector<std::pair<std::string, std::string>> metadata;  ///< in the order to be shown
  std::map<std::string, double> metrics;                      ///< by name; any value, also NaN
};

/// Description of a metric in the page. Others are shown too: less is better then.
struct ReportMetric {
  std::string name;
  std::string description;  ///< a sentence or a formula, may be empty
  bool more_is_better = false;
};

struct ReportTable {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  ///< each as long as the header
};

/// Content of a report. Texts are UTF-8 and are shown literally, whatever they contain; bytes that
/// are no UTF-8 show as U+FFFD.
struct Report {
  std::string title;
  std::vector<ReportImage> images;
  std::optional<std::size_t> reference;  ///< index into `images`
  std::vector<ReportMetric> metrics;     ///< gives the order of the columns
  std::vector<LogPlot> plots;  ///< a name has one colour in all of them: see `number_styles`
  std::vector<ReportTable> tables;
  std::vector<std::string> notes;  ///< paragraphs
};

/// Bytes that a report takes on disk.
struct ReportSize {
  std::size_t page = 0;  ///< HTML with the plots, CSS and JavaScript
  std::size_t data = 0;  ///< pixels, thumbnails, numbers
};

/// Writes a page that opens from disk in any current browser: `folder/index.html`, `folder/page/`,
/// `folder/data/`. Pixels are stored as half floats (finite values beyond ±65504 become ±65504).
///
/// `folder` may be absent, empty, or an earlier report, which is replaced; the folder around it
/// must exist. It changes in one step, when everything is on disk; after an error it is as it was.
/// Raises IoError with the reason: files cannot be made, or `folder` holds something else. Raises
/// std::invalid_argument for a report that contradicts itself (sizes, indices).
ReportSize write_report(const Report& report, const std::filesystem::path& folder);

}  // namespace ajar
