#include "study/comparison.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace ajar::study {

namespace {
void check_finite(const LoadedPicture& picture) {
  const NonFinitePixels bad = find_non_finite(picture);
  if (bad.count == 0) return;
  throw UsageError(
      fmt::format("{}: {} of {} pixels are infinite or not a number, the first at {},{}; such "
                  "pictures are not compared",
                  picture.path, bad.count, picture.linear.size() / 3, bad.first.x, bad.first.y));
}

void check_fits(const LoadedPicture& picture, const LoadedPicture& reference) {
  if (picture.size != reference.size) {
    throw UsageError(fmt::format("{} has {}x{} pixels, but the reference {} has {}x{}",
                                 picture.path, picture.size.x, picture.size.y, reference.path,
                                 reference.size.x, reference.size.y));
  }
  if (picture.origin && reference.origin && *picture.origin != *reference.origin) {
    throw UsageError(
        fmt::format("{} begins at pixel {},{} of the whole picture, but the reference {} at {},{}",
                    picture.path, picture.origin->x, picture.origin->y, reference.path,
                    reference.origin->x, reference.origin->y));
  }
}

void warn_of_reference(const Comparison& comparison, std::vector<std::string>& warnings) {
  const std::vector<float>& values = comparison.reference.linear;
  if (std::all_of(values.begin(), values.end(), [](float v) { return v <= 0.F; })) {
    warnings.push_back("the reference " + comparison.reference.path +
                       " is black: relative metrics only measure against their constant, and "
                       "hdr-flip has no exposures");
  }
}

void warn_of_encoding(const Comparison& comparison, std::vector<std::string>& warnings) {
  const auto warn = [&](const LoadedPicture& picture) {
    if (!picture.is_display_encoded) return;
    warnings.push_back(picture.path +
                       " holds display values in steps of 1/255 or so, clamped at white: they were "
                       "decoded by sRGB, and metrics of radiance see only what is left");
  };
  warn(comparison.reference);
  for (const ComparedPicture& compared : comparison.pictures) warn(compared.picture);
}
}  // namespace

Comparison compare_files(const std::string& reference, const std::vector<std::string>& pictures,
                         const std::vector<const Metric*>& metrics, double pixels_per_degree) {
  Comparison comparison;
  comparison.metrics = metrics;
  comparison.reference = load_picture(reference);
  check_finite(comparison.reference);
  for (const std::string& path : pictures) {
    comparison.pictures.push_back({load_picture(path), {}, {}});
    check_fits(comparison.pictures.back().picture, comparison.reference);
    check_finite(comparison.pictures.back().picture);
  }
  comparison.conditions.pixels_per_degree = pixels_per_degree;
  comparison.conditions.exposures = hdr_flip_exposures(comparison.reference.linear);
  warn_of_reference(comparison, comparison.warnings);
  warn_of_encoding(comparison, comparison.warnings);
  for (ComparedPicture& compared : comparison.pictures) {
    for (const Metric* metric : metrics) {
      compared.values.push_back(
          metric->measure(compared.picture, comparison.reference, comparison.conditions));
    }
    compared.bias = test_bias(compared.picture, comparison.reference);
  }
  return comparison;
}

}  // namespace ajar::study
