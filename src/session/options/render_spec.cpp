#include "session/options/render_spec.h"

#include "image/tone_curve.h"

namespace ajar {

void RenderSpec::set_budget(const Budget& budget) {
  samples_per_pixel = budget.samples_per_pixel;
  seconds = budget.seconds;
  target_error = budget.target_error;
  denoised_target = budget.denoised_target;
}

Display RenderSpec::display() const {
  return {tone_map_by_name(tone_map_name()), exposure.value_or(Exposure())};
}

std::vector<std::string> RenderSpec::files() const {
  std::vector<std::string> paths = outputs;
  for (const std::string& path : {statistics, checkpoint}) {
    if (!path.empty()) paths.push_back(path);
  }
  return paths;
}

}  // namespace ajar
