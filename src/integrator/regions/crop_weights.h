#pragma once
#include <string>
#include <vector>

#include "integrator/integrator.h"

namespace ajar {

/// Luminance of an image file that is as large as the picture or as its crop: a value for each
/// pixel of the crop, row by row. `parameter` is whose value `path` is, for messages. Raises
/// IoError for the file and UsageError for its size.
std::vector<float> read_crop_weights(const std::string& parameter, const std::string& path,
                                     const RenderSettings& settings);

}  // namespace ajar
