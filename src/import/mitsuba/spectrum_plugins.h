#pragma once
#include <span>
#include <string_view>

#include "import/mitsuba/context.h"

namespace ajar::mitsuba {

/// The types of textures that are the same everywhere. Mitsuba 2 and 3 have textures and spectra
/// for one, by whichever tag.
std::span<const std::string_view> spectrum_types();
bool is_spectrum(const Element& element);

/// The colour of a texture of one of these types; of others, with a warning, its "value". Raises
/// SceneError if a required property is missing.
desc::Rgb evaluate_spectrum(Context& context, const Element& element);

}  // namespace ajar::mitsuba
