#pragma once
#include <memory>
#include <string>

#include "image/statistics.h"
#include "support/render.h"

namespace ajar::test {

/// The replicates of a layer, or of the whole picture ("").
Replicates replicates_of(const Render& render, const std::string& layer = "");

/// A small scene and its picture, by `bdpt`.
struct KnownPicture {
  std::unique_ptr<Scene> scene;
  RenderOptions options;  ///< options for renders to compare with it: another seed
  Render truth;
};
KnownPicture known_picture(const std::string& small_scene, int samples);

/// Claims that replicates of two pictures of a film's size have the same expectation: each block of
/// 8×8 pixels and the mean, within 5 standard errors (a right program fails with a chance of 2e-6);
/// and that 5 errors of the mean are less than `power` of it.
void expect_same(const Replicates& a, const Replicates& b, const Film& film, double power,
                 const std::string& name);

}  // namespace ajar::test
