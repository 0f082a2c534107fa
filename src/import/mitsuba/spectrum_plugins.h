#pragma once
#include "import/mitsuba/context.h"

namespace ajar::mitsuba {

/// The colour of `<spectrum type="…">`. Raises SceneError for unknown types.
desc::Rgb evaluate_spectrum(Context& context, const Element& element);

}  // namespace ajar::mitsuba
