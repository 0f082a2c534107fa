#include "session/render/render_setup.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace ajar {
namespace {

desc::Film film_of(int width, int height) {
  desc::Film film;
  film.resolution = {width, height};
  return film;
}

TEST(RenderSetup, TheSceneSaysWhatTheUserDoesNot) {
  desc::RenderHints hints;
  hints.integrator = "bdpt";
  hints.samples_per_pixel = 12;
  hints.max_depth = 7;
  const RenderSetup setup = make_setup({}, hints, film_of(30, 20));
  EXPECT_EQ(setup.integrator->name, "bdpt");
  EXPECT_EQ(setup.budget.samples_per_pixel, 12U);
  EXPECT_EQ(setup.settings.max_depth, 7);
  EXPECT_EQ(setup.resolution, Vec2i(30, 20));
  EXPECT_EQ(setup.crop.max, Vec2i(29, 19));
}

TEST(RenderSetup, WhoeverGetsTheMethodOfTheSceneIsToldOfTheDefault) {
  desc::RenderHints hints;
  hints.integrator = "bdpt";
  const RenderSetup of_scene = make_setup({}, hints, film_of(3, 2));
  ASSERT_EQ(of_scene.notes.size(), 1U);
  EXPECT_NE(of_scene.notes[0].find("--integrator selective"), std::string::npos);
  RenderRequest request;
  request.integrator = "pt";
  EXPECT_TRUE(make_setup(request, hints, film_of(3, 2)).notes.empty());
}

TEST(RenderSetup, PathTracingIsNoWishOfAScene) {
  desc::RenderHints hints;
  hints.integrator = "pt";
  const RenderSetup setup = make_setup({}, hints, film_of(3, 2));
  EXPECT_EQ(setup.integrator->name, "selective");
  ASSERT_EQ(setup.notes.size(), 1U);
  EXPECT_NE(setup.notes[0].find("--integrator pt"), std::string::npos);
  RenderRequest request;
  request.integrator = "pt";
  EXPECT_EQ(make_setup(request, hints, film_of(3, 2)).integrator->name, "pt");
}

TEST(RenderSetup, DefaultsAreTold) {
  const RenderSetup setup = make_setup({}, {}, film_of(30, 20));
  EXPECT_EQ(setup.integrator->name, "selective");
  EXPECT_EQ(setup.budget.samples_per_pixel, 64U);
  EXPECT_EQ(setup.settings.max_depth, 100);
  ASSERT_EQ(setup.notes.size(), 1U);
  EXPECT_NE(setup.notes[0].find("selective"), std::string::npos);
}

TEST(RenderSetup, AnUnknownIntegratorOfTheSceneIsReplacedOneOfTheUserIsRefused) {
  desc::RenderHints hints;
  hints.integrator = "future";
  EXPECT_NE(make_setup({}, hints, film_of(3, 2)).notes.at(0).find("future"), std::string::npos);
  RenderRequest request;
  request.integrator = "future";
  EXPECT_THROW(make_setup(request, {}, film_of(3, 2)), UsageError);
}

TEST(RenderSetup, AnyLimitOfTheUserReplacesTheSamplesOfTheScene) {
  desc::RenderHints hints;
  hints.samples_per_pixel = 12;
  RenderRequest request;
  request.budget.seconds = 5.0;
  const RenderSetup setup = make_setup(request, hints, film_of(3, 2));
  EXPECT_FALSE(setup.budget.samples_per_pixel.has_value());
  EXPECT_EQ(setup.budget.seconds, 5.0);
}

TEST(RenderSetup, FewSamplesMeanFewReplicates) {
  for (const auto& [samples, replicates] : {std::pair{1, 1}, {2, 2}, {3, 3}, {4, 4}, {64, 4}}) {
    RenderRequest request;
    request.budget.samples_per_pixel = samples;
    EXPECT_EQ(make_setup(request, {}, film_of(3, 2)).settings.replicates, replicates);
  }
}

TEST(RenderSetup, ParametersOfTheUserComeLast) {
  desc::RenderHints hints;
  hints.sampler = "independent";
  RenderRequest request;
  request.integrator = "pt";
  EXPECT_EQ(make_setup(request, hints, film_of(3, 2)).parameters.at("sampler"), "independent");
  request.parameters["sampler"] = "sobol";
  EXPECT_EQ(make_setup(request, hints, film_of(3, 2)).parameters.at("sampler"), "sobol");
}

TEST(RenderSetup, RecordsHaveTheParametersThatMatter) {
  const auto recorded = [](const char* integrator) {
    RenderRequest request;
    request.integrator = integrator;
    const RenderSetup setup = make_setup(request, {}, {});
    const Parameters parameters = setup.integrator->read(setup.parameters);
    return record_of(setup, parameters, "builtin:cornell", {}, {}).parameters;
  };
  const auto masked = recorded("masked");
  for (const char* of_mmlt : {"chain", "omc", "sigma", "chains"}) {
    EXPECT_TRUE(masked.contains(of_mmlt)) << of_mmlt;
  }
  EXPECT_FALSE(masked.contains("chain-length")) << "of erpt";
}

TEST(RenderSetup, ScaleMultipliesTheResolutionOfTheScene) {
  RenderRequest request;
  request.scale = 0.5;
  EXPECT_EQ(make_setup(request, {}, film_of(31, 20)).resolution, Vec2i(16, 10));
  request.scale = 1e-6;
  EXPECT_EQ(make_setup(request, {}, film_of(31, 20)).resolution, Vec2i(1, 1));
  request.scale = 1e6;
  EXPECT_THROW(make_setup(request, {}, film_of(31, 20)), UsageError);
  request.scale = 0.0;
  EXPECT_THROW(make_setup(request, {}, film_of(31, 20)), UsageError);
}

TEST(RenderSetup, CropWindowOfTheSceneIsKeptUnlessTheUserGivesOne) {
  desc::Film film = film_of(40, 20);
  film.crop[0] = 0.5F;
  film.crop[3] = 0.25F;
  const RenderSetup from_scene = make_setup({}, {}, film);
  EXPECT_EQ(from_scene.crop.min, Vec2i(20, 0));
  EXPECT_EQ(from_scene.crop.max, Vec2i(39, 4));
  RenderRequest request;
  request.crop = parse_crop("--crop", "0,0,1,1");
  EXPECT_EQ(make_setup(request, {}, film).crop.min, Vec2i(0, 0));
  film.crop[1] = 0.5F;
  EXPECT_THROW(make_setup({}, {}, film), SceneError);
}

TEST(RenderSetup, DepthAboveTheSceneIsExplained) {
  desc::RenderHints hints;
  hints.max_depth = 5;
  RenderRequest request;
  request.depth.minimum = 6;
  EXPECT_THROW(make_setup(request, hints, film_of(3, 2)), UsageError);
  request.depth.maximum = 9;
  EXPECT_EQ(make_setup(request, hints, film_of(3, 2)).settings.max_depth, 9);
}

TEST(RenderSetup, OnlyGatheredLayersAreAskedOfTheIntegrator) {
  RenderRequest request;
  request.aovs = {"direct", "albedo", "samples", "standard-error"};
  const RenderSetup setup = make_setup(request, {}, film_of(3, 2));
  EXPECT_EQ(setup.settings.aovs, (std::vector<std::string>{"albedo"}));
  EXPECT_EQ(setup.aovs.size(), 4U);
  EXPECT_NO_THROW(check_layers(setup, {LayerSpec{.name = "albedo"}}));
  try {
    check_layers(setup, {LayerSpec{.name = "direct"}});
    FAIL() << "albedo is not made";
  } catch (const UsageError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find(setup.integrator->name + " does not make the AOV \"albedo\""),
              std::string::npos)
        << text;
  }
}

TEST(RenderSetup, TakesTheParametersOfChainsThatScenesOfOtherRenderersHave) {
  desc::RenderHints hints;
  hints.integrator = "mmlt";
  hints.parameters = {{"bootstrapsamples", "5000"},
                      {"largestepprobability", "0.4"},
                      {"sigma", "0.02"},
                      {"chains", "-3"},
                      {"mutationsperpixel", "64"}};
  const RenderSetup setup = make_setup({}, hints, {});
  EXPECT_EQ(setup.parameters.at("bootstrap"), "5000");
  EXPECT_EQ(setup.parameters.at("large-step"), "0.4");
  EXPECT_EQ(setup.parameters.at("sigma"), "0.02");
  EXPECT_EQ(setup.parameters.at("mutation"), "gaussian");
  EXPECT_FALSE(setup.parameters.contains("chains"));
  ASSERT_EQ(setup.notes.size(), 2U);
  EXPECT_NE(setup.notes[1].find("chains"), std::string::npos);
}

}  // namespace
}  // namespace ajar
