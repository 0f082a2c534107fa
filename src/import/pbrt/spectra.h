#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/warnings.h"
#include "import/common/file_access.h"
#include "import/pbrt/dialect.h"
#include "import/pbrt/parameter_list.h"
#include "scene/desc/scene_desc.h"

namespace ajar::pbrt {

/// The ways to write a colour.
inline constexpr std::array kSpectrumKinds = {ParameterKind::Rgb, ParameterKind::Xyz,
                                              ParameterKind::Blackbody, ParameterKind::Spectrum};

/// Role of a colour, which only pbrt-v4 distinguishes.
///
/// Light: pbrt-v4 divides every light by the luminance of its spectrum; of an RGB colour, by that
/// of its colour space's white. So rgb (1, 1, 1) is the white with luminance 1, black bodies and
/// spectra keep nothing but their chromaticity, and an ideal film with its default exposure shows
/// rgb (r, g, b) as just that.
///
/// Other: reflectances, indices of refraction, scattering. Spectra are converted in daylight:
/// constant ones are grey.
enum class ColorRole { Light, Other };

/// Colours of parameters, whichever way they are written, as linear RGB.
class SpectrumReader {
 public:
  SpectrumReader(FileAccess& files, Dialect dialect, Warnings& warnings)
      : files_(files), dialect_(dialect), warnings_(warnings) {}

  /// Value of a parameter of one of `kSpectrumKinds` with one value. Empty, after a warning, if it
  /// refers to a file that cannot be used. Raises SceneError if it is not finite.
  std::optional<desc::Rgb> value(const Parameter& parameter, ColorRole role = ColorRole::Other);
  /// Values that cannot be negative (light, scattering): negative lanes become 0, with a warning if
  /// the file says so itself or in a wider colour space than ours.
  std::optional<desc::Rgb> positive_value(const Parameter& parameter,
                                          ColorRole role = ColorRole::Other);
  desc::Rgb get_positive(const ParameterList& parameters, std::string_view name,
                         const desc::Rgb& fallback, ColorRole role = ColorRole::Other);
  /// All values of an RGB parameter. Lanes are negative only where the file says so itself.
  std::vector<desc::Rgb> colors(const Parameter& parameter, ColorRole role = ColorRole::Other);

 private:
  /// Wavelengths, nm, and values.
  struct Samples {
    std::vector<double> wavelengths, values;
  };
  static Samples samples_of(const std::vector<float>& pairs);
  Samples parse_file(std::string_view text, const std::string& name) const;

  std::optional<desc::Rgb> unchecked_value(const Parameter& parameter, ColorRole role);
  std::optional<desc::Rgb> from_file(const Parameter& parameter, ColorRole role);
  /// Empty for names that pbrt-v4 does not have.
  std::optional<desc::Rgb> from_name(const Parameter& parameter, ColorRole role);
  /// Warns of a colour of a wider space, which `color` is in ours; false if it fits.
  bool warn_of_gamut(const Parameter& parameter, const desc::Rgb& color);
  desc::Rgb from_samples(const Samples& samples, ColorRole role) const;

  FileAccess& files_;
  Dialect dialect_;
  Warnings& warnings_;
  std::map<std::string, Samples> files_read_;
};

}  // namespace ajar::pbrt
