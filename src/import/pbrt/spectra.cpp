#include "import/pbrt/spectra.h"

#include <algorithm>

#include "color/color.h"
#include "core/printable_text.h"
#include "import/common/metals.h"
#include "import/pbrt/color_space.h"
#include "import/pbrt/lexer.h"
#include "import/pbrt/named_spectra.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kUnusable{Effect::Surface,
                                "spectra cannot be used: what they are of has its default"};
constexpr WarningKind kOddNumbers{Effect::Slight,
                                  "spectra have numbers that are in no pair, which are ignored"};
constexpr WarningKind kNegative{Effect::Slight, "colours are negative: taken as 0"};
constexpr WarningKind kOutOfGamut{Effect::Slight,
                                  "colours are more saturated than sRGB can show: clipped"};

/// Light of luminance 1.
desc::Rgb light_of(const Vec3d& xyz) {
  return xyz.y > 0.0 ? desc::Rgb(xyz_to_rgb(xyz / xyz.y)) : desc::Rgb(0.F);
}

desc::Rgb rec709(const ColorSpace* space, const float* rgb, ColorRole role) {
  if (space == nullptr) return {rgb[0], rgb[1], rgb[2]};
  const Vec3d given(rgb[0], rgb[1], rgb[2]);
  return desc::Rgb(role == ColorRole::Light ? space->light_to_rec709(given)
                                            : space->reflectance_to_rec709(given));
}

}  // namespace

SpectrumReader::Samples SpectrumReader::samples_of(const std::vector<float>& pairs) {
  Samples samples;
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
    samples.wavelengths.push_back(pairs[i]);
    samples.values.push_back(pairs[i + 1]);
  }
  return samples;
}

/// An .spd file: pairs of numbers, # comments. The last of an odd number is ignored, as pbrt does.
SpectrumReader::Samples SpectrumReader::parse_file(std::string_view text,
                                                   const std::string& name) const {
  Lexer lexer(std::make_shared<const std::string>(name), text);
  Samples samples;
  for (Token token = lexer.next(); token.kind != TokenKind::End; token = lexer.next()) {
    const double wavelength = lexer.double_value(token);
    if (lexer.peek().kind == TokenKind::End && !samples.wavelengths.empty()) {
      warnings_.add(kOddNumbers, lexer.where(token),
                    "this spectrum has a number more than pairs of a wavelength and a value: "
                    "ignored",
                    printable(name));
      break;
    }
    samples.wavelengths.push_back(wavelength);
    samples.values.push_back(lexer.double_value(lexer.next()));
  }
  if (samples.wavelengths.empty())
    throw SceneError(lexer.where(lexer.peek()), "there is no spectrum in this file");
  return samples;
}

std::optional<desc::Rgb> SpectrumReader::value(const Parameter& parameter, ColorRole role) {
  std::optional<desc::Rgb> rgb = unchecked_value(parameter, role);
  if (rgb && !is_finite(*rgb))
    throw SceneError(parameter.where, "\"" + parameter.name + "\" is too large");
  return rgb;
}

std::optional<desc::Rgb> SpectrumReader::unchecked_value(const Parameter& parameter,
                                                         ColorRole role) {
  const std::vector<float>& n = parameter.numbers;
  switch (parameter.kind) {
    case ParameterKind::Rgb:
      return rec709(parameter.color_space, n.data(), role);
    case ParameterKind::Xyz:
      return desc::Rgb(xyz_to_rgb(Vec3d(n[0], n[1], n[2])));
    case ParameterKind::Blackbody:
      if (dialect_ == Dialect::V4) return light_of(blackbody_xyz(n[0]));
      return desc::Rgb(blackbody_rgb(n[0]) * static_cast<double>(n[1]));
    default:
      if (!parameter.strings.empty()) return from_file(parameter, role);
      return from_samples(samples_of(n), role);
  }
}

desc::Rgb SpectrumReader::from_samples(const Samples& samples, ColorRole role) const {
  if (dialect_ == Dialect::V3) {
    return desc::Rgb(sampled_to_rgb(samples.wavelengths, samples.values));
  }
  if (role == ColorRole::Light)
    return light_of(sampled_to_xyz(samples.wavelengths, samples.values));
  return desc::Rgb(sampled_to_rgb_in_daylight(samples.wavelengths, samples.values));
}

std::optional<desc::Rgb> SpectrumReader::from_name(const Parameter& parameter, ColorRole role) {
  const std::string& name = parameter.strings.front();
  if (dialect_ == Dialect::V3) return std::nullopt;
  if (const std::optional<Vec3d> metal = named_metal(name)) return desc::Rgb(*metal);
  if (const std::optional<float> glass = named_glass(name)) return desc::Rgb(*glass);
  if (const std::optional<Vec3d> illuminant = named_illuminant(name)) {
    return role == ColorRole::Light ? light_of(*illuminant) : desc::Rgb(1.F);
  }
  return std::nullopt;
}

std::optional<desc::Rgb> SpectrumReader::from_file(const Parameter& parameter, ColorRole role) {
  const std::string& name = parameter.strings.front();
  if (const std::optional<desc::Rgb> named = from_name(parameter, role)) return named;
  try {
    const std::string path = files_.resolve(name, parameter.where);
    const auto known = files_read_.find(path);
    if (known != files_read_.end()) return from_samples(known->second, role);
    if (!files_.exists(path)) {
      if (dialect_ == Dialect::V3) {
        if (const std::optional<Vec3d> metal = metal_rgb_by_file_name(name))
          return desc::Rgb(*metal);
      } else if (const std::string near = nearest_name(name, spectrum_names()); !near.empty()) {
        throw IoError("there is no such file, and no spectrum of this name; did you mean \"" +
                      near + "\"?");
      }
    }
    const FileBytes bytes = files_.load_text(path);
    return from_samples(files_read_.emplace(path, parse_file(bytes.view(), path)).first->second,
                        role);
  } catch (const Error& error) {
    warnings_.add(kUnusable, parameter.where,
                  "spectrum \"" + printable(name) + "\" cannot be used (" + error.what() + "): \"" +
                      parameter.name + "\" has its default",
                  printable(name));
    return std::nullopt;
  }
}

std::optional<desc::Rgb> SpectrumReader::positive_value(const Parameter& parameter,
                                                        ColorRole role) {
  std::optional<desc::Rgb> rgb = value(parameter, role);
  if (!rgb || (rgb->x >= 0.F && rgb->y >= 0.F && rgb->z >= 0.F)) return rgb;
  const std::vector<float>& n = parameter.numbers;
  if (parameter.kind == ParameterKind::Rgb && (n[0] < 0.F || n[1] < 0.F || n[2] < 0.F)) {
    warnings_.add(kNegative, parameter.where, "\"" + parameter.name + "\" is negative: taken as 0",
                  parameter.name);
  } else if (parameter.kind == ParameterKind::Rgb) {
    warn_of_gamut(parameter, *rgb);
  }
  for (int i = 0; i < 3; ++i) (*rgb)[i] = std::max((*rgb)[i], 0.F);
  return rgb;
}

bool SpectrumReader::warn_of_gamut(const Parameter& parameter, const desc::Rgb& color) {
  // Less is the rounding of the matrices of colour spaces.
  constexpr float kVisible = 1e-3F;
  const float most = std::max({color.x, color.y, color.z});
  if (std::min({color.x, color.y, color.z}) >= -kVisible * most) return false;
  warnings_.add(kOutOfGamut, parameter.where,
                "\"" + parameter.name + "\" is more saturated than sRGB can show: clipped",
                parameter.name);
  return true;
}

desc::Rgb SpectrumReader::get_positive(const ParameterList& parameters, std::string_view name,
                                       const desc::Rgb& fallback, ColorRole role) {
  const Parameter* p = parameters.find_one(name, kSpectrumKinds);
  return p == nullptr ? fallback : positive_value(*p, role).value_or(fallback);
}

std::vector<desc::Rgb> SpectrumReader::colors(const Parameter& parameter, ColorRole role) {
  std::vector<desc::Rgb> result;
  result.reserve(parameter.size());
  bool is_told = false;
  for (std::size_t i = 0; i < parameter.size(); ++i) {
    const float* given = parameter.numbers.data() + 3 * i;
    desc::Rgb& color = result.emplace_back(rec709(parameter.color_space, given, role));
    if (std::min({given[0], given[1], given[2]}) < 0.F) continue;
    if (!is_told) is_told = warn_of_gamut(parameter, color);
    for (int lane = 0; lane < 3; ++lane) color[lane] = std::max(color[lane], 0.F);
  }
  return result;
}

}  // namespace ajar::pbrt
