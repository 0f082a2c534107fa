#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/vector.h"

namespace ajar::bench {

/// The picture that the shared folder's `references/index.json` has of a scene at exactly this
/// resolution and depth (box filter of one pixel, RGB); empty if it has none. Raises IoError if
/// the index or the picture cannot be read.
std::optional<std::vector<float>> shared_reference(const std::filesystem::path& shared,
                                                   const std::string& scene, Vec2i resolution,
                                                   int depth);

}  // namespace ajar::bench
