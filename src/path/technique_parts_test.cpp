#include "path/technique_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "path/measure.h"
#include "path/testing/plain_scene.h"

namespace ajar {
namespace {

/// Straight from the definitions, technique by technique.
TechniqueParts::Part slow_part(const Scene& scene, const PathSamplerSettings& settings,
                               const Path& path, Technique technique) {
  TechniqueParts::Part part;
  part.weight = mis_weight(scene, settings, path, technique);
  if (part.weight > 0.0) {
    part.light = part.weight * static_cast<double>(luminance(throughput(scene, path, technique))) /
                 tries(settings, technique);
  }
  return part;
}

TEST(TechniqueParts, AreThoseOfTheTechniquesOneByOne) {
  const auto scene = testing::plain_scene();
  const testing::RecordedPaths paths = testing::recorded(*scene, testing::all_techniques(), 2000);
  ASSERT_GT(paths.size(), 1000U);
  for (const char* techniques : {"pt", "lt", "ibpt", "bdpt", "(0,*),(2,2),(*,1)*0.5"}) {
    for (const Heuristic heuristic : {Heuristic::Balance, Heuristic::Power}) {
      PathSamplerSettings settings = testing::all_techniques();
      settings.techniques = TechniqueSet::parse(techniques);
      settings.heuristic = heuristic;
      settings.light_subpaths = 3.0;
      settings.light_paths_per_pixel = 1.5;
      TechniqueParts parts(*scene, settings);
      for (const auto& [path, found_by] : paths) {
        const auto found = parts.of(path, contribution(*scene, path).log_luminance());
        ASSERT_EQ(found.size(), static_cast<std::size_t>(path.depth()) + 1);
        for (int s = 0; s <= path.depth(); ++s) {
          const TechniqueParts::Part& own = found[static_cast<std::size_t>(s)];
          const auto slow = slow_part(*scene, settings, path, {s, path.depth() + 1 - s});
          const double weight = std::isnan(slow.weight) ? 0.0 : slow.weight;
          EXPECT_NEAR(own.weight, weight, 1e-9) << techniques << ", s = " << s;
          EXPECT_NEAR(own.light, slow.light, 1e-5 * slow.light) << techniques << ", s = " << s;
        }
      }
    }
  }
}

}  // namespace
}  // namespace ajar
