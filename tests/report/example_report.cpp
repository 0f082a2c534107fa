// Writes a report to look at: `ajar_report_example FOLDER [IMAGE.exr…]`. The first image is the
// reference; without images it makes some. `--count N` repeats the last image until there are N,
// for measuring.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "imageio/image_file.h"
#include "report/example_content.h"
#include "study/report/report.h"

namespace ajar {
namespace {

ReportImage read(const std::string& path) {
  const Image file = read_image(path);
  ReportImage image{
      std::filesystem::path(path).stem().string(), file.width, file.height, {}, {}, {}};
  image.metadata = {{"file", path}};
  for (const char* layer : {"", "direct", "indirect", "albedo", "normal", "depth"}) {
    std::vector<float> pixels = file.rgb(layer);
    if (!pixels.empty()) image.layers.push_back({layer, 3, std::move(pixels)});
  }
  return image;
}

int run(const std::vector<std::string>& arguments) {
  if (arguments.empty()) {
    std::cerr << "usage: ajar_report_example FOLDER [--count N] [IMAGE.exr...]\n";
    return 2;
  }
  std::vector<ReportImage> images;
  std::size_t count = 0;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    if (arguments[i] == "--count" && i + 1 < arguments.size()) {
      count = std::stoul(arguments[++i]);
    } else {
      images.push_back(read(arguments[i]));
    }
  }
  Report report = images.empty() ? example_report() : example_report_of(std::move(images));
  while (report.images.size() < count) {
    report.images.push_back(report.images.back());
    report.images.back().name = fmt::format("copy {}", report.images.size());
  }
  const auto begin = std::chrono::steady_clock::now();
  const ReportSize size = write_report(report, arguments[0]);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  fmt::print("{} images, page {} bytes, data {} bytes, written in {:.2f} s\n", report.images.size(),
             size.page, size.data, time.count());
  return 0;
}

}  // namespace
}  // namespace ajar

int main(int argc, char** argv) {
  try {
    return ajar::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "ajar_report_example: " << error.what() << '\n';
    return 1;
  }
}
