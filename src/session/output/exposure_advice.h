#pragma once
#include <string>

#include "post/display.h"

namespace ajar {

/// An exposure as `--exposure` takes it, such as "+4" or "-2.5".
std::string stops_text(float stops);

/// Advice on `--exposure`, in one sentence, if a tenth of a displayed picture is white or nine
/// tenths are black, and another exposure suits it better by a stop (`fitting_exposure`); empty
/// otherwise, so also where the white part is a lamp and the black part the night around it.
std::string exposure_advice(const Picture& picture, const DisplayOptions& display);

}  // namespace ajar
