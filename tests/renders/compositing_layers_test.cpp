#include <gtest/gtest.h>

#include "imageio/image_file.h"
#include "imageio/read_picture.h"
#include "session/output/output.h"
#include "session/output/write_picture.h"
#include "support/render.h"
#include "support/temporary_file.h"

/// Layers for putting pictures together: how opaque a pixel is, and surfaces that are not mixed
/// with nothing at their edges.
namespace ajar::test {
namespace {

Picture picture_of(const std::string& world, std::vector<std::string> aovs) {
  const auto scene = scene_from(
      pbrt_scene("Camera \"orthographic\" \"float screenwindow\" [-1 1 -1 1]", 8, 8, world));
  const Render made = render(*scene, {.samples = 64, .replicates = 2, .aovs = aovs});
  return develop(*made.film, *made.integrator, made.samples, 1.0, aovs);
}

const std::vector<float>& pixels_of(const Picture& picture, const std::string& layer) {
  const Picture::Layer* const found = layer_named(picture, layer);
  if (found == nullptr) throw std::logic_error("there is no layer " + layer);
  return found->pixels;
}

/// A disk that shines, at a distance of 3, whose edge crosses pixels.
const std::string kDisk = R"(Material "matte" "rgb Kd" [.4 .4 .4]
AreaLightSource "diffuse" "rgb L" [.5 .5 .5]
Translate 0 0 3 Scale 1 1 -1 Shape "disk" "float radius" .8)";

TEST(CompositingLayers, AlphaIsTheCoverageBySurfaces) {
  const Picture picture = picture_of(kDisk, {"alpha", "coverage"});
  const std::vector<float>& alpha = pixels_of(picture, "A");
  EXPECT_EQ(alpha, pixels_of(picture, "coverage"));
  EXPECT_EQ(alpha[0], 0.F);
  EXPECT_NEAR(alpha[8 * 4 + 4], 1.F, 1e-5F);
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    // An even light is multiplied by it.
    EXPECT_NEAR(picture.layers.front().pixels[3 * i], 0.5F * alpha[i], 1e-5F) << i;
  }
}

TEST(CompositingLayers, AlphaOfFogIsItsScattering) {
  const std::string fog = R"(MakeNamedMedium "fog" "string type" "homogeneous"
"rgb sigma_a" [.5 .5 .5] "rgb sigma_s" [1 1 1] MediumInterface "fog" "" Material ""
Translate 0 0 3 Scale 3 3 1 Shape "sphere"
LightSource "infinite" "rgb L" [1 1 1])";
  const Picture picture = picture_of(fog, {"alpha", "coverage", "depth", "divided"});
  double alpha = 0.0;
  for (const std::size_t i : {27U, 28U}) alpha += 0.5 * pixels_of(picture, "A")[i];
  EXPECT_NEAR(alpha, 1.0 - std::exp(-2.0), 0.1) << "the way is 2 long";
  EXPECT_EQ(pixels_of(picture, "coverage"), std::vector<float>(64, 0.F));
  EXPECT_NEAR(pixels_of(picture, "depth.divided")[27], 2.7F, 0.4F);
}

TEST(CompositingLayers, DividedOnesAreOfTheSurfaceAlone) {
  const Picture picture = picture_of(kDisk, {"albedo", "depth", "normal", "divided"});
  int at_edges = 0;
  for (std::size_t i = 0; i < 64; ++i) {
    const float depth = pixels_of(picture, "depth")[i];
    const float divided = pixels_of(picture, "depth.divided")[i];
    if (depth == 0.F) {
      EXPECT_EQ(divided, 0.F);
      continue;
    }
    at_edges += depth < 2.99F ? 1 : 0;
    EXPECT_NEAR(divided, 3.F, 1e-3F);
    EXPECT_NEAR(pixels_of(picture, "albedo.divided")[3 * i], 0.4F, 1e-3F);
    EXPECT_NEAR(pixels_of(picture, "normal.divided")[3 * i + 2], -1.F, 1e-3F);
  }
  EXPECT_GT(at_edges, 8);
  EXPECT_EQ(layer_named(picture, "coverage"), nullptr) << "nobody asked for it";
  EXPECT_EQ(layer_named(picture, "A"), nullptr);
}

TEST(CompositingLayers, StayInFiles) {
  const Picture picture = picture_of(kDisk, {"alpha"});
  const TemporaryFile exr("a.exr");
  write_picture(exr.path(), picture);
  EXPECT_EQ(read_image(exr.path()).names.at(3), "A");
  EXPECT_EQ(pixels_of(read_picture(exr.path()), "A"), pixels_of(picture, "A"));
  const TemporaryFile png("a.png");
  write_picture(png.path(), picture);
  const Image shown = read_image(png.path());
  ASSERT_EQ(shown.channels, 4);
  for (int i = 0; i < 64; ++i) {
    const float alpha = pixels_of(picture, "A")[static_cast<std::size_t>(i)];
    EXPECT_NEAR(shown.at(i % 8, i / 8, 3), alpha, 0.003F);
    if (alpha > 0.5F) {
      // The colour itself, sRGB of 0.5; files are read multiplied by alpha.
      EXPECT_NEAR(shown.at(i % 8, i / 8, 0) / alpha, 0.735F, 0.01F);
    }
  }
}

}  // namespace
}  // namespace ajar::test
