// Camera, film and hints: pbrt-v3's defaults and meanings.
#include <gtest/gtest.h>

#include "import/pbrt/import_test_support.h"

namespace ajar {
namespace {

desc::SceneDesc with_v3_options(const std::string& options) {
  Warnings warnings;
  desc::SceneDesc scene =
      import_with(options + (contains(options, "Camera") ? "" : " Camera \"perspective\"") +
                      " WorldBegin Shape \"sphere\" WorldEnd",
                  warnings);
  for (const std::string& message : warnings.messages())
    ADD_FAILURE() << options << "\n" << message;
  return scene;
}

TEST(PbrtOptions, CamerasHaveTheDefaultsOfPbrt) {
  const auto p =
      std::get<desc::PerspectiveCamera>(with_v3_options("Camera \"perspective\"").camera.node);
  EXPECT_EQ(p.fov, 90.F);
  EXPECT_EQ(p.lens_radius, 0.F);
  EXPECT_EQ(p.focal_distance, 1e6F);
  EXPECT_FALSE(p.window);
  const auto half = std::get<desc::PerspectiveCamera>(
      with_v3_options("Camera \"perspective\" \"float halffov\" 20 \"float frameaspectratio\" 2 "
                      "\"float shutteropen\" 0")
          .camera.node);
  EXPECT_EQ(half.fov, 40.F);
  EXPECT_EQ(*half.aspect, 2.F);
  const auto o = std::get<desc::OrthographicCamera>(
      with_v3_options("Camera \"orthographic\" \"float screenwindow\" [-1 1 -2 2]").camera.node);
  EXPECT_EQ(o.window->y_max, 2.F);
  EXPECT_TRUE(std::holds_alternative<desc::EnvironmentCamera>(
      with_v3_options("Camera \"environment\"").camera.node));
}

TEST(PbrtOptions, TheRealisticCameraSeesAboutTheSame) {
  Warnings warnings;
  const desc::SceneDesc s = import_with(
      "Camera \"realistic\" \"string lensfile\" \"lenses/dgauss.50mm.dat\" \"float focusdistance\" "
      "2 "
      "Film \"image\" \"integer xresolution\" 900 \"integer yresolution\" 600 \"float diagonal\" "
      "43.27 WorldBegin Shape \"sphere\" WorldEnd",
      warnings);
  EXPECT_EQ(warnings.count(), 1U);
  const auto camera = std::get<desc::PerspectiveCamera>(s.camera.node);
  EXPECT_NEAR(camera.fov, 27.F, 0.1F);  // a 36 x 24 mm frame behind 50 mm
  EXPECT_EQ(camera.focal_distance, 2.F);
}

TEST(PbrtOptions, FilmAndFilters) {
  const desc::SceneDesc none = with_v3_options("");
  EXPECT_EQ(none.film.resolution, Vec2i(1280, 720));
  EXPECT_TRUE(std::holds_alternative<desc::BoxFilter>(none.film.filter.node));
  EXPECT_EQ(none.film.filter.radius, Vec2(0.5F, 0.5F));
  const desc::SceneDesc s = with_v3_options(
      "PixelFilter \"gaussian\" \"float xwidth\" 3 Film \"image\" \"float cropwindow\" [.7 .3 .4 "
      "1.5] \"float scale\" 1.5 \"float diagonal\" 20");
  EXPECT_EQ(s.film.crop[0], 0.3F);
  EXPECT_EQ(s.film.crop[3], 1.F);
  EXPECT_EQ(s.film.scale, 1.5F);
  EXPECT_EQ(s.film.filter.radius, Vec2(3.F, 2.F));
  EXPECT_EQ(std::get<desc::GaussianFilter>(s.film.filter.node).falloff, 2.F);
  EXPECT_EQ(with_v3_options("PixelFilter \"sinc\"").film.filter.radius, Vec2(4.F, 4.F));
  EXPECT_EQ(with_v3_options("PixelFilter \"mitchell\" \"float B\" 0").film.filter.radius,
            Vec2(2.F, 2.F));
}

TEST(PbrtOptions, FiltersAndFilmsWithoutAFilterAreLocated) {
  const desc::SceneDesc scene = with_v3_options("\nPixelFilter \"gaussian\" \"float alpha\" -1");
  EXPECT_EQ(scene.film.filter.where.to_string(), "test.pbrt:2:1");
  EXPECT_EQ(scene.film.where.to_string(), "test.pbrt:2:96");
  const desc::SceneDesc both = with_v3_options("PixelFilter \"box\"\nFilm \"image\"");
  EXPECT_EQ(both.film.filter.where.to_string(), "test.pbrt:1:1");
  EXPECT_EQ(both.film.where.to_string(), "test.pbrt:2:1");
}

TEST(PbrtOptions, EmptyFilmsAreWarnings) {
  EXPECT_TRUE(contains(warnings_of("Film \"image\" \"float scale\" 0 " + world("")),
                       "test.pbrt:1:1: \"scale\" of the film is 0: the picture is black"));
  EXPECT_TRUE(contains(warnings_of("Film \"image\" \"float scale\" -2 " + world("")),
                       "\"scale\" of the film is negative"));
}

TEST(PbrtOptions, AbsurdOnesAreLocatedErrors) {
  EXPECT_TRUE(contains(error_of("Film \"image\" \"integer xresolution\" -5"),
                       "1:1: the resolution must be 1 to 65536, not -5"));
  EXPECT_TRUE(contains(error_of("Film \"image\" \"integer yresolution\" 70000"), "65536"));
  EXPECT_TRUE(contains(error_of("Film \"image\" \"float cropwindow\" [.5 .5 0 1]"),
                       "1:14: the crop window is empty"));
  EXPECT_TRUE(contains(error_of("Camera \"perspective\" \"float fov\" 180"), "between 0 and 180"));
  EXPECT_TRUE(contains(error_of("PixelFilter \"box\" \"float xwidth\" 1e9"), "at most 64"));
  EXPECT_TRUE(
      contains(error_of("PixelFilter \"bux\""), "unknown filter \"bux\"; did you mean \"box\"?"));
}

TEST(PbrtHints, MapIntegratorsToOurs) {
  EXPECT_EQ(with_v3_options("").hints.integrator, "");
  EXPECT_EQ(with_v3_options("").hints.max_depth, 6);
  const desc::RenderHints path =
      with_v3_options("Integrator \"path\" \"integer maxdepth\" 65 \"float rrthreshold\" 1").hints;
  EXPECT_EQ(path.integrator, "pt");
  EXPECT_EQ(path.max_depth, 66);
  EXPECT_EQ(with_v3_options("Integrator \"volpath\"").hints.max_depth, 6);
  EXPECT_EQ(with_v3_options("Integrator \"bdpt\"").hints.integrator, "bdpt");
  const desc::RenderHints mlt = with_v3_options(
                                    "Integrator \"mlt\" \"integer mutationsperpixel\" 1024 \"float "
                                    "sigma\" .02 Sampler \"random\" \"integer pixelsamples\" 3")
                                    .hints;
  EXPECT_EQ(mlt.integrator, "mmlt");
  EXPECT_EQ(mlt.samples_per_pixel, 1024);
  EXPECT_EQ(mlt.sampler, "independent");
  const std::vector<std::pair<std::string, std::string>> expected = {{"mutationsperpixel", "1024"},
                                                                     {"sigma", "0.02"}};
  EXPECT_EQ(mlt.parameters, expected);
  EXPECT_EQ(with_v3_options("Integrator \"sppm\" \"integer numiterations\" 77 \"float radius\" .1")
                .hints.samples_per_pixel,
            77);
}

TEST(PbrtHints, WarnOfLightThatPbrtsIntegratorOmits) {
  const auto warnings = [](const std::string& options, const std::string& medium = "") {
    return warnings_of(options + " Camera \"perspective\" WorldBegin " + medium +
                       " Shape \"sphere\" WorldEnd");
  };
  const std::string fog =
      "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" MediumInterface \"fog\" \"\"";
  EXPECT_TRUE(contains(warnings("Integrator \"whitted\""),
                       "\"whitted\" of pbrt-v3 leaves out light that diffuse surfaces pass on"));
  EXPECT_TRUE(contains(warnings("Integrator \"path\"", fog),
                       "test.pbrt:1:1: \"path\" of pbrt leaves out media"));
  EXPECT_TRUE(contains(warnings("", fog), "\"path\" of pbrt leaves out media"));
  EXPECT_EQ(warnings("Integrator \"volpath\"", fog), "");
  EXPECT_EQ(warnings("Integrator \"path\""), "");
  EXPECT_EQ(
      warnings("Integrator \"path\"", "MakeNamedMedium \"a\" \"string type\" \"homogeneous\""), "");
  EXPECT_EQ(
      warnings_of("Film \"rgb\" Camera \"perspective\" WorldBegin " + fog + " Shape \"sphere\""),
      "");
}

TEST(PbrtHints, MapSamplersToOurs) {
  const desc::RenderHints halton =
      with_v3_options("Sampler \"halton\" \"integer pixelsamples\" 32").hints;
  EXPECT_EQ(halton.sampler, "sobol");
  EXPECT_EQ(halton.samples_per_pixel, 32);
  EXPECT_EQ(with_v3_options("Sampler \"stratified\" \"integer xsamples\" 3 \"integer ysamples\" 5")
                .hints.samples_per_pixel,
            15);
  EXPECT_EQ(with_v3_options("Sampler \"02sequence\"").hints.samples_per_pixel, 16);
  EXPECT_EQ(
      with_v3_options("Accelerator \"bvh\" \"integer maxnodeprims\" 4").hints.samples_per_pixel,
      std::nullopt);
}

}  // namespace
}  // namespace ajar
