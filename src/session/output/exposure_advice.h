#pragma once
#include <string>

#include "post/display.h"

namespace ajar {

/// An exposure as `--exposure` takes it, such as "+4" or "-2.5".
std::string stops_text(float stops);

/// What `--exposure` would help, in one sentence, if a tenth of a picture for the eye is white or
/// nine tenths are black, and another exposure suits it better by a stop (`fitting_exposure`);
/// empty otherwise, so also where what is white is a lamp and what is black the night around it.
std::string exposure_advice(const Picture& picture, const DisplayOptions& display);

}  // namespace ajar
