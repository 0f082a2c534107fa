#include <algorithm>
#include <array>
#include <atomic>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "core/error.h"
#include "core/parallel_for.h"
#include "imageio/image_file.h"
#include "os/atomic_file.h"
#include "post/display.h"
#include "study/report/page_files.h"
#include "study/report/pixel_code.h"
#include "study/report/replaced_folder.h"
#include "study/report/report.h"
#include "study/report/report_script.h"
#include "study/report/thumbnail.h"

namespace ajar {

namespace {
namespace fs = std::filesystem;

void require(bool holds, const std::string& claim) {
  if (!holds) throw std::invalid_argument("report: " + claim);
}

void check(const Report& report) {
  for (const ReportImage& image : report.images) {
    require(image.width > 0 && image.height > 0, "image \"" + image.name + "\" has no pixels");
    require(!image.layers.empty(), "image \"" + image.name + "\" has no layers");
    for (const ReportLayer& layer : image.layers) {
      require(layer.channels == 1 || layer.channels == 3, "a layer has 1 or 3 channels");
      require(layer.pixels.size() == static_cast<std::size_t>(image.width) *
                                         static_cast<std::size_t>(image.height) *
                                         static_cast<std::size_t>(layer.channels),
              "layer \"" + layer.name + "\" of \"" + image.name + "\" has not the image's size");
    }
  }
  require(!report.reference || *report.reference < report.images.size(),
          "the reference is not one of the images");
  for (const ReportTable& table : report.tables) {
    for (const auto& row : table.rows) {
      require(row.size() == table.header.size(),
              "a row of \"" + table.title + "\" is not as long as its header");
    }
  }
}

/// A user's files must not vanish: only a report, and nothing beside it, may be replaced.
void check_replaceable(const fs::path& folder) {
  constexpr std::array<std::string_view, 3> kOurs{"index.html", "page", "data"};
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status)) {
    throw IoError("cannot write a report to \"" + folder.string() + "\": it is not a folder");
  }
  bool empty = true;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    empty = false;
    const std::string name = entry->path().filename().string();
    if (std::find(kOurs.begin(), kOurs.end(), name) == kOurs.end()) {
      throw IoError("cannot write a report to \"" + folder.string() + "\": it holds \"" + name +
                    "\", which is no part of a report; name another folder or remove that");
    }
  }
  if (error) {
    throw IoError("cannot read the folder \"" + folder.string() + "\": " + error.message());
  }
  if (!empty && !fs::is_regular_file(folder / "data" / "report.js", error)) {
    throw IoError("cannot write a report to \"" + folder.string() +
                  "\": it is neither empty nor a report");
  }
}

std::size_t write_text(const fs::path& path, std::string_view text) {
  write_file_atomically(path, text);
  return text.size();
}

void make_folder(const fs::path& path) {
  std::error_code error;
  if (!fs::create_directory(path, error)) {
    throw IoError("cannot make the folder \"" + path.string() + "\": " + error.message());
  }
}

/// The page with the plots in it, which so are seen without JavaScript, too.
std::size_t write_page(const fs::path& folder, const std::vector<LogPlot>& plots) {
  constexpr std::string_view kPlace = "<!-- plots -->\n";
  make_folder(folder / "page");
  std::size_t bytes = 0;
  for (const PageFile& file : page_files()) {
    std::string content(file.content);
    const bool is_entry = file.name == "index.html";
    if (is_entry) content.replace(content.find(kPlace), kPlace.size(), to_html(plots));
    bytes += write_text((is_entry ? folder : folder / "page") / file.name, content);
  }
  return bytes;
}

std::size_t write_thumbnail(const fs::path& path, const ReportImage& image) {
  Thumbnail small = make_thumbnail(image);
  Picture file;
  file.resolution = {small.width, small.height};
  file.crop = Box2i({0, 0}, {small.width - 1, small.height - 1});
  file.layers.push_back({"", 3, std::move(small.pixels)});
  write_image(path.string(), displayed(file, {}));
  return fs::file_size(path);
}

std::size_t write_image_data(const fs::path& folder, const ReportImage& image, std::size_t index) {
  std::size_t bytes = write_thumbnail(folder / thumbnail_file(index), image);
  for (std::size_t i = 0; i < image.layers.size(); ++i) {
    const ReportLayer& layer = image.layers[i];
    bytes += write_text(folder / layer_file(index, i),
                        layer_script(index, i, pack_pixels(layer.pixels, layer.channels)));
  }
  return bytes;
}

std::size_t write_data(const fs::path& folder, const Report& report, std::size_t page) {
  make_folder(folder);
  std::atomic<std::size_t> bytes{0};
  parallel_for(report.images.size(),
               [&](std::size_t i) { bytes += write_image_data(folder, report.images[i], i); });
  // The script states the size of the whole, its own included: its length without that is near.
  const std::size_t numbers = report_script(report, {page, bytes}).size();
  write_text(folder / "report.js", report_script(report, {page, bytes + numbers}));
  return bytes + numbers;
}

}  // namespace

ReportSize write_report(const Report& report, const fs::path& folder) {
  check(report);
  check_replaceable(folder);
  ReplacedFolder replaced(folder);
  ReportSize size;
  size.page = write_page(replaced.path(), report.plots);
  size.data = write_data(replaced.path() / "data", report, size.page);
  replaced.commit();
  return size;
}

}  // namespace ajar
