#include "support/same_picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "image/compare_blocks.h"
#include "support/small_scenes.h"

namespace ajar::test {

Replicates replicates_of(const Render& render, const std::string& layer) {
  Replicates replicates;
  for (int r = 0; r < render.film->replicates(); ++r) {
    replicates.push_back(layer.empty() ? render.replicate(r) : render.layer(layer, r));
  }
  return replicates;
}

KnownPicture known_picture(const std::string& name, int samples) {
  const SmallScene small = small_scene(name);
  KnownPicture known;
  known.scene = scene_from(small.text);
  known.options.integrator = "bdpt";
  known.options.replicates = 16;
  known.options.max_depth = 6;
  known.options.samples = samples;
  known.options.crop = small.crop;
  known.truth = render(*known.scene, known.options);
  known.options.seed = 2;
  return known;
}

void expect_same(const Replicates& a, const Replicates& b, const Film& film, double power,
                 const std::string& name) {
  const BlockGrid grid{.width = film.width(), .height = film.height(), .block = 8};
  const BlockComparison comparison = compare_blocks(a, b, grid);
  EXPECT_TRUE(comparison.equal()) << name << ": worst block at " << comparison.worst_block.min.x
                                  << ", " << comparison.worst_block.min.y << " by "
                                  << comparison.worst_difference << ", z " << comparison.worst_z
                                  << ", mean z " << comparison.mean_z << ", relative "
                                  << comparison.mean_relative_difference;
  const Estimate mean = image_mean(b);
  const double error = std::hypot(mean.standard_error, image_mean(a).standard_error);
  EXPECT_LT(5.0 * error / mean.value, power) << name << ": too noisy to notice what it should";
}

}  // namespace ajar::test
