#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "core/vector.h"
#include "core/warnings.h"
#include "import/mitsuba/search_path.h"

/// Colours of spectra as linear RGB.
namespace ajar::mitsuba {

/// Conversion of a spectrum to a colour: as light, or as a reflectance in daylight (CIE D65).
/// Mitsuba 3 converts all but emitters in daylight, so that even spectra are grey; 0.x and 2
/// convert all as light. A single number is grey, but an even spectrum as emitters of 2 and 3 have
/// it. Source: `Properties::get_texture_impl`, `spectrum_list_to_srgb` of Mitsuba 3.
enum class Seen { AsLight, InDaylight, Emitted };

/// Parses "400:0.1, 500:0.5, 700:1": wavelengths in nm and values. Nothing if it is not that.
std::optional<Vec3d> parse_spectrum(std::string_view pairs, Seen seen);
/// Radiance of a black body, W·sr⁻¹·m⁻² per nm, which are Mitsuba's units.
Vec3d blackbody(double kelvin);
/// Reads a file of lines with a wavelength and a value each; a file that is missing but has the
/// name of a metal we know is that metal. Numbers behind them, and one that is alone at the end,
/// are ignored, with a warning. `where` names the file. Raises SceneError and IoError.
Vec3d read_spectrum_of(const SearchPath& files, const std::string& name, Seen seen,
                       const SourceLocation& where, Warnings& warnings);

}  // namespace ajar::mitsuba
