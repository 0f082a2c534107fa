#include "ajar/compare.h"

#include "api/contents.h"
#include "image/flip.h"
#include "session/options/limits.h"
#include "study/comparison.h"
#include "study/comparison_output.h"

namespace ajar::v0 {

std::string compare(const std::string& reference, const std::vector<std::string>& pictures,
                    const std::vector<std::string>& metrics,
                    std::optional<double> pixels_per_degree) {
  return with_public_errors([&] {
    const double density = pixels_per_degree.value_or(kFlipPixelsPerDegree);
    check_within(limits::kPixelsPerDegree, density, "pixels_per_degree");
    const study::Comparison comparison =
        study::compare_files(reference, pictures, study::metrics_by_name(metrics), density);
    return json_text(study::to_json(comparison));
  });
}

}  // namespace ajar::v0
