#include "image/tone_curve.h"

#include <array>
#include <string>

#include "core/error.h"

namespace ajar {

ToneMap tone_map_by_name(std::string_view name) {
  if (name == "srgb") return ToneMap::Srgb;
  if (name == "filmic") return ToneMap::Filmic;
  throw UsageError(
      unknown_name_message("tone map", name, std::array<std::string, 2>{"srgb", "filmic"}));
}

std::vector<float> to_ldr(std::span<const float> linear) {
  std::vector<float> display(linear.size());
  std::transform(linear.begin(), linear.end(), display.begin(),
                 [](float x) { return tone_map(x, ToneMap::Srgb, 0.F); });
  return display;
}

}  // namespace ajar
