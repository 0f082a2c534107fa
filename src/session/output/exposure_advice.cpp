#include "session/output/exposure_advice.h"

#include <fmt/format.h>

#include <vector>

#include "post/exposure.h"
#include "session/heuristics.h"

namespace ajar {

namespace {
constexpr double kMuchWhite = SessionHeuristics::kMuchWhite;
constexpr double kNearlyAllBlack = SessionHeuristics::kNearlyAllBlack;
constexpr float kWorthIt = SessionHeuristics::kWorthIt;
}  // namespace

std::string stops_text(float stops) { return stops == 0.F ? "0" : fmt::format("{:+.4g}", stops); }

std::string exposure_advice(const Picture& picture, const DisplayOptions& display) {
  const std::vector<float>& rgb = shown_layer(picture).pixels;
  const Clipping lost = clipping(rgb, display.tone_map, display.exposure);
  if (lost.white < kMuchWhite && lost.black < kNearlyAllBlack) return {};
  // Nothing helps a picture without light.
  if (std::none_of(rgb.begin(), rgb.end(), [](float value) { return value > 0.F; })) return {};
  const float fitting = fitting_exposure(rgb, picture.crop.size() + Vec2i(1, 1));
  const auto advice = [&](double share, const char* what) {
    return fmt::format("{:.0f} % of the picture is {}: try --exposure {}", 100.0 * share, what,
                       stops_text(fitting));
  };
  if (lost.white >= kMuchWhite && fitting <= display.exposure - kWorthIt) {
    return advice(lost.white, "white");
  }
  if (lost.black >= kNearlyAllBlack && fitting >= display.exposure + kWorthIt) {
    return advice(lost.black, "black");
  }
  return {};
}

}  // namespace ajar
