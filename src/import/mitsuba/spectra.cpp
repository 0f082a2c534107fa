#include "import/mitsuba/spectra.h"

#include <memory>

#include "color/color.h"
#include "core/error.h"
#include "core/printable_text.h"
#include "import/common/metals.h"
#include "import/mitsuba/numbers.h"

namespace ajar::mitsuba {

namespace {

constexpr WarningKind kOddNumbers{Effect::Slight,
                                  "spectra have numbers that are in no pair, which are ignored"};

Vec3d color_of(const std::vector<double>& wavelengths, const std::vector<double>& values,
               Seen seen) {
  return seen == Seen::InDaylight ? sampled_to_rgb_in_daylight(wavelengths, values)
                                  : sampled_to_rgb(wavelengths, values);
}

}  // namespace

std::optional<Vec3d> parse_spectrum(std::string_view pairs, Seen seen) {
  std::vector<double> wavelengths;
  std::vector<double> values;
  for (const std::string_view pair : words_of(pairs)) {
    const std::size_t colon = pair.find(':');
    if (colon == std::string_view::npos) return std::nullopt;
    const std::optional<double> wavelength = parse_number(pair.substr(0, colon));
    const std::optional<double> value = parse_number(pair.substr(colon + 1));
    if (!wavelength || !value) return std::nullopt;
    wavelengths.push_back(*wavelength);
    values.push_back(*value);
  }
  return color_of(wavelengths, values, seen);
}

Vec3d blackbody(double kelvin) {
  if (!(kelvin > 0.0)) return Vec3d(0.0);
  constexpr double kMetersPerNanometer = 1e-9;
  std::vector<double> wavelengths;
  std::vector<double> values;
  for (double nm = 360.0; nm <= 830.0; nm += 5.0) {
    wavelengths.push_back(nm);
    values.push_back(blackbody_radiance(nm, kelvin) * kMetersPerNanometer);
  }
  const Vec3d rgb = sampled_to_rgb(wavelengths, values);
  return {std::max(rgb.x, 0.0), std::max(rgb.y, 0.0), std::max(rgb.z, 0.0)};
}

Vec3d read_spectrum_of(const SearchPath& files, const std::string& name, Seen seen,
                       const SourceLocation& where, Warnings& warnings) {
  const std::string path = files.files().resolve(files.find(name), where);
  if (!files.files().exists(path)) {
    if (const std::optional<Vec3d> metal = metal_rgb_by_file_name(name)) return *metal;
  }
  const FileBytes bytes = files.files().load_text(path);
  std::string_view text = bytes.view();
  std::vector<double> wavelengths;
  std::vector<double> values;
  std::vector<SourceLocation> odd;      // lines with numbers that are in no pair
  std::optional<SourceLocation> alone;  // one with a single number, which must be the last
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t end = text.find('\n');
    const std::string_view whole = text.substr(0, end);
    const std::vector<std::string_view> words = words_of(whole.substr(0, whole.find('#')));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (words.empty()) continue;
    const SourceLocation here{std::make_shared<const std::string>(name), line, 0};
    const auto fail = [](const SourceLocation& at) {
      throw SceneError(at, "a wavelength and a value are expected");
    };
    const std::optional<double> wavelength = parse_number(words[0]);
    if (alone || !wavelength) fail(alone.value_or(here));
    if (words.size() != 2) odd.push_back(here);
    if (words.size() == 1) {
      alone = here;
      continue;
    }
    const std::optional<double> value = parse_number(words[1]);
    if (!value) fail(here);
    wavelengths.push_back(*wavelength);
    values.push_back(*value);
  }
  if (wavelengths.empty()) {
    throw SceneError({std::make_shared<const std::string>(name), 0, 0},
                     "there is no spectrum in this file");
  }
  for (const SourceLocation& line : odd) {
    warnings.add(kOddNumbers, line,
                 "numbers that are in no pair of a wavelength and a value are ignored",
                 printable(name));
  }
  return color_of(wavelengths, values, seen);
}

}  // namespace ajar::mitsuba
