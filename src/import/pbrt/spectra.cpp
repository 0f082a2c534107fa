#include "import/pbrt/spectra.h"

#include <vector>

#include "core/color.h"
#include "import/common/metals.h"
#include "import/common/printable.h"
#include "import/pbrt/lexer.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kUnusable{Effect::Surface,
                                "spectra cannot be used: what they are of has its default"};
constexpr WarningKind kNegative{Effect::Slight, "colours are negative: taken as 0"};

/// Wavelengths and values of an .spd file: pairs of numbers, # comments.
desc::Rgb parse_spd(std::string_view text, const std::string& name) {
  Lexer lexer(std::make_shared<const std::string>(name), text);
  std::vector<double> wavelengths;
  std::vector<double> values;
  for (Token token = lexer.next(); token.kind != TokenKind::End; token = lexer.next()) {
    wavelengths.push_back(lexer.double_value(token));
    values.push_back(lexer.double_value(lexer.next()));
  }
  if (wavelengths.empty())
    throw SceneError(lexer.where(lexer.peek()), "there is no spectrum in this file");
  return desc::Rgb(sampled_to_rgb(wavelengths, values));
}

desc::Rgb from_samples(const std::vector<float>& pairs) {
  std::vector<double> wavelengths;
  std::vector<double> values;
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
    wavelengths.push_back(pairs[i]);
    values.push_back(pairs[i + 1]);
  }
  return desc::Rgb(sampled_to_rgb(wavelengths, values));
}

}  // namespace

std::optional<desc::Rgb> SpectrumReader::value(const Parameter& parameter) {
  std::optional<desc::Rgb> rgb = unchecked_value(parameter);
  if (rgb && !is_finite(*rgb))
    throw SceneError(parameter.where, "\"" + parameter.name + "\" is too large");
  return rgb;
}

std::optional<desc::Rgb> SpectrumReader::unchecked_value(const Parameter& parameter) {
  const std::vector<float>& n = parameter.numbers;
  switch (parameter.kind) {
    case ParameterKind::Rgb:
      return desc::Rgb(n[0], n[1], n[2]);
    case ParameterKind::Xyz:
      return desc::Rgb(xyz_to_rgb(Vec3d(n[0], n[1], n[2])));
    case ParameterKind::Blackbody:
      return desc::Rgb(blackbody_rgb(n[0]) * static_cast<double>(n[1]));
    default:
      return parameter.strings.empty() ? from_samples(n) : from_file(parameter);
  }
}

std::optional<desc::Rgb> SpectrumReader::from_file(const Parameter& parameter) {
  const std::string& name = parameter.strings.front();
  try {
    const std::string path = files_.resolve(name);
    const auto known = files_read_.find(path);
    if (known != files_read_.end()) return known->second;
    if (!files_.exists(path)) {
      if (const std::optional<Vec3d> metal = metal_rgb_by_file_name(name)) return desc::Rgb(*metal);
    }
    const FileBytes bytes = files_.load(path);
    return files_read_.emplace(path, parse_spd(bytes.view(), path)).first->second;
  } catch (const Error& error) {
    warnings_.add(kUnusable, parameter.where,
                  "spectrum \"" + printable(name) + "\" cannot be used (" + error.what() + "): \"" +
                      parameter.name + "\" has its default",
                  printable(name));
    return std::nullopt;
  }
}

std::optional<desc::Rgb> SpectrumReader::positive_value(const Parameter& parameter) {
  std::optional<desc::Rgb> rgb = value(parameter);
  if (!rgb || (rgb->x >= 0.F && rgb->y >= 0.F && rgb->z >= 0.F)) return rgb;
  if (parameter.kind == ParameterKind::Rgb) {
    warnings_.add(kNegative, parameter.where, "\"" + parameter.name + "\" is negative: taken as 0",
                  parameter.name);
  }
  for (int i = 0; i < 3; ++i) (*rgb)[i] = std::max((*rgb)[i], 0.F);
  return rgb;
}

desc::Rgb SpectrumReader::get_positive(const ParameterList& parameters, std::string_view name,
                                       const desc::Rgb& fallback) {
  const Parameter* p = parameters.find_one(name, kSpectrumKinds);
  return p == nullptr ? fallback : positive_value(*p).value_or(fallback);
}

}  // namespace ajar::pbrt
