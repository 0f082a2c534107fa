#include "report/example_content.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include "image/metrics.h"

namespace ajar {

namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 180;

/// Smooth, with a bright spot far above white.
std::vector<float> clean_pixels(int width, int height) {
  std::vector<float> pixels;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float u = static_cast<float>(x) / static_cast<float>(width);
      const float v = static_cast<float>(y) / static_cast<float>(height);
      const float spot =
          20.F * std::exp(-200.F * ((u - 0.7F) * (u - 0.7F) + (v - 0.3F) * (v - 0.3F)));
      pixels.push_back(0.5F * u + spot);
      pixels.push_back(0.3F + 0.2F * std::sin(12.F * u) * std::cos(9.F * v) + spot);
      pixels.push_back(0.5F * v + 0.8F * spot);
    }
  }
  return pixels;
}

/// Multiplies by gamma-distributed factors of mean one: noise as of `samples` samples.
std::vector<float> noisy(std::vector<float> pixels, double samples, unsigned seed) {
  std::mt19937 random(seed);
  std::gamma_distribution<float> factor(static_cast<float>(samples),
                                        static_cast<float>(1 / samples));
  for (float& value : pixels) value *= factor(random);
  return pixels;
}

ReportImage computed(const std::string& name, std::vector<float> pixels) {
  ReportImage image{name, kWidth, kHeight, {}, {}, {}};
  std::vector<float> depth;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) depth.push_back(2.F + static_cast<float>(x + y) / 100.F);
  }
  image.layers = {{"", 3, std::move(pixels)}, {"depth", 1, std::move(depth)}};
  return image;
}

void measure(ReportImage& image, const ReportImage& reference) {
  const std::vector<float>& pixels = image.layers.front().pixels;
  const std::vector<float>& truth = reference.layers.front().pixels;
  if (pixels.size() != truth.size()) return;
  image.metrics = {{"relMSE", relative_mse(pixels, truth)},
                   {"MSE", mse(pixels, truth)},
                   {"MAE", mae(pixels, truth)},
                   {"PSNR", psnr(pixels, truth)}};
}

std::vector<PlotPoint> convergence(double start, double slope, double spread) {
  std::vector<PlotPoint> points;
  for (int i = 0; i < 14; ++i) {
    const double seconds = 0.5 * std::pow(1.5, i);
    const double mean = start * std::pow(seconds, slope) * (1 + 0.05 * std::sin(9 * seconds));
    points.push_back({seconds, mean, mean / spread, mean * spread});
  }
  return points;
}

/// Tables that `ajar study` makes of all metrics.
ReportTable study_table() {
  return {"Equal time: 20s",
          {"method", "runs", "seconds", "CPU seconds", "samples per pixel",
           "acceptance (small / large steps)", "mse [radiance^2]", "rmse [radiance]",
           "mae [radiance]", "relmse", "relmse-trimmed", "smape", "psnr [dB]", "ssim", "flip",
           "hdr-flip", "relative-error", "estimated error", "efficiency"},
          {{"pt", "5", "19.99 ± 0.0028", "39.66 ± 0.22", "3106 ± 11", "-", "0.08903 ± 0.00021",
            "0.2962 ± 0.00036", "0.06138 ± 0.00094", "0.1961 ± 0.012", "0.1766 ± 0.0079",
            "0.2003 ± 0.0011", "18.78 ± 0.011", "0.3362 ± 0.0015", "0.1568 ± 0.0014",
            "0.3453 ± 0.00088", "0.443 ± 0.013", "0.43 ± 0.02 (0.97×) (≥ 1/5)", "1"},
           {"mmlt large-step=0.3 sigma=0.003", "5", "19.97 ± 0.0069", "26.78 ± 0.0012 († 2/5)",
            "1204 ± 3", "0.55 (0.62 / 0.03)", "0.08424 ± 0.00021", "0.2879 ± 0.00036",
            "0.04984 ± 0.0016", "0.07345 ± 0.00013", "0.06741 ± 0.00069", "0.1102 ± 0.0013",
            "22.08 ± 0.078", "0.4258 ± 0.0023", "0.1202 ± 0.0016", "0.2427 ± 0.00012",
            "0.271 ± 0.0002", "0.273 ± 0.004 (1.01×)", "0.245 [0.109, 0.551] *"}}};
}

}  // namespace

Report example_report_of(std::vector<ReportImage> images) {
  Report report;
  report.title = "Floor lamps, equal time";
  report.images = std::move(images);
  report.reference = 0;
  for (ReportImage& image : report.images) measure(image, report.images.front());
  report.metrics = {
      {"relMSE", "Mean of (a − r)² / (r² + 0.01).", false},
      {"MSE", "Mean of (a − r)².", false},
      {"PSNR", "10·log10(1 / MSE) in dB.", true},
  };
  report.plots = {
      {"floor lamps",
       "seconds",
       "relMSE",
       {{"pt", convergence(0.9, -0.93, 1.15)},
        {"ibpt", convergence(0.2, -0.98, 1.12)},
        {"bdpt", convergence(0.15, -1.0, 1.1)},
        {"mmlt", convergence(0.3, -0.9, 1.6)}},
       "Mean of (a − r)² / (r² + 0.01).",
       ""},
      {"floor lamps",
       "seconds",
       "MAE",
       {{"pt", convergence(0.5, -0.47, 1.1)}, {"mmlt", convergence(0.25, -0.45, 1.3)}},
       "",
       ""},
      // Few values close to each other: axes of less than a decade.
      {"floor lamps, 20s",
       "sigma",
       "PSNR",
       {{"mmlt", {{0.003, 30.1, 29.8, 30.4}, {0.01, 31.2, 31, 31.4}, {0.03, 30.7, 30.1, 31.3}}},
        {"pt", {{0.003, 29.9, 29.8, 30}, {0.03, 29.9, 29.8, 30}}}},
       "10·log10(1 / MSE) in dB.",
       ""}};
  report.plots[0].curves[3].points.push_back({200, std::nan(""), 0, 0});
  number_styles(report.plots);
  report.tables = {{"Rays per second",
                    {"Method", "Samples per pixel", "Rays, M/s", "Remark"},
                    {{"pt", "412", "5.2", "loses the caustics"},
                     {"ibpt", "230", "4.9", ""},
                     {"bdpt", "96", "4.1", "slowest per sample, best per second here"}}},
                   study_table()};
  report.notes = {
      "Five runs of each method with different seeds; bands are the lowest and highest of them.",
      "All methods had the same two threads."};
  return report;
}

Report example_report() {
  const std::vector<float> clean = clean_pixels(kWidth, kHeight);
  std::vector<float> faulty = noisy(clean, 30, 3);
  for (std::size_t i = 0; i < 12; ++i) {
    faulty[3 * (20 * kWidth + 40 + i)] = std::nanf("");
    faulty[3 * (22 * kWidth + 40 + i) + 1] = std::numeric_limits<float>::infinity();
  }
  std::vector<ReportImage> images;
  images.push_back(computed("reference", clean));
  images.push_back(computed("path tracing", noisy(clean, 4, 1)));
  images.push_back(computed("bidirectional", noisy(clean, 20, 2)));
  images.push_back(computed("faulty", std::move(faulty)));
  images.push_back(
      computed("<img src=x onerror=\"throw 1\">\\ '\"` </script> \xe2\x80\xa8 Größe 日本", clean));
  images.push_back({"smaller", 100, 80, {{"", 3, clean_pixels(100, 80)}}, {}, {}});
  Report report = example_report_of(std::move(images));
  report.title = "Example & <b>test</b>";
  report.images[1].metadata = {
      {"integrator", "pt"}, {"samples", "4"}, {"<i>key</i>", "<script>throw 2</script>"}};
  report.plots[0].curves.push_back({"<svg onload=throw(3)>", convergence(0.4, -0.8, 1.2)});
  number_styles(report.plots);
  return report;
}

}  // namespace ajar
