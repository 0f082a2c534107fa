#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>

#include "core/warnings.h"
#include "import/common/file_access.h"
#include "import/pbrt/parameter_list.h"
#include "scene/desc/scene_desc.h"

namespace ajar::pbrt {

/// The ways to write a colour.
inline constexpr std::array kSpectrumKinds = {ParameterKind::Rgb, ParameterKind::Xyz,
                                              ParameterKind::Blackbody, ParameterKind::Spectrum};

/// Colours of parameters, whichever way they are written, as linear RGB.
class SpectrumReader {
 public:
  SpectrumReader(FileAccess& files, Warnings& warnings) : files_(files), warnings_(warnings) {}

  /// Value of a parameter of one of `kSpectrumKinds` with one value. Empty, after a warning, if it
  /// refers to a file that cannot be used. Raises SceneError if it is not finite.
  std::optional<desc::Rgb> value(const Parameter& parameter);
  /// The same for what cannot be negative (light, scattering): such lanes become 0, with a warning
  /// if the file says so itself.
  std::optional<desc::Rgb> positive_value(const Parameter& parameter);
  desc::Rgb get_positive(const ParameterList& parameters, std::string_view name,
                         const desc::Rgb& fallback);

 private:
  std::optional<desc::Rgb> unchecked_value(const Parameter& parameter);
  std::optional<desc::Rgb> from_file(const Parameter& parameter);

  FileAccess& files_;
  Warnings& warnings_;
  std::map<std::string, desc::Rgb> files_read_;
};

}  // namespace ajar::pbrt
