#include "session/render/resolved_render.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace ajar {
namespace {

desc::Film film_of(int width, int height) {
  desc::Film film;
  film.resolution = {width, height};
  return film;
}

TEST(ResolvedRender, TheSceneSaysWhatTheUserDoesNot) {
  desc::RenderHints hints;
  hints.integrator = "bdpt";
  hints.samples_per_pixel = 12;
  hints.max_depth = 7;
  const ResolvedRender setup = resolve_render({}, hints, film_of(30, 20));
  EXPECT_EQ(setup.integrator->name, "bdpt");
  EXPECT_EQ(setup.budget.samples_per_pixel, 12U);
  EXPECT_EQ(setup.settings.max_depth, 7);
  EXPECT_EQ(setup.resolution, Vec2i(30, 20));
  EXPECT_EQ(setup.crop.max, Vec2i(29, 19));
}

TEST(ResolvedRender, WhoeverGetsTheMethodOfTheSceneIsToldOfTheDefault) {
  desc::RenderHints hints;
  hints.integrator = "bdpt";
  const ResolvedRender of_scene = resolve_render({}, hints, film_of(3, 2));
  ASSERT_EQ(of_scene.notes.size(), 1U);
  EXPECT_NE(of_scene.notes[0].find("--integrator selective"), std::string::npos);
  RenderSpec spec;
  spec.integrator = "pt";
  EXPECT_TRUE(resolve_render(spec, hints, film_of(3, 2)).notes.empty());
}

TEST(ResolvedRender, PathTracingIsNoWishOfAScene) {
  desc::RenderHints hints;
  hints.integrator = "pt";
  const ResolvedRender setup = resolve_render({}, hints, film_of(3, 2));
  EXPECT_EQ(setup.integrator->name, "selective");
  ASSERT_EQ(setup.notes.size(), 1U);
  EXPECT_NE(setup.notes[0].find("--integrator pt"), std::string::npos);
  RenderSpec spec;
  spec.integrator = "pt";
  EXPECT_EQ(resolve_render(spec, hints, film_of(3, 2)).integrator->name, "pt");
}

TEST(ResolvedRender, DefaultsAreTold) {
  const ResolvedRender setup = resolve_render({}, {}, film_of(30, 20));
  EXPECT_EQ(setup.integrator->name, "selective");
  EXPECT_EQ(setup.budget.samples_per_pixel, 64U);
  EXPECT_EQ(setup.settings.max_depth, 100);
  ASSERT_EQ(setup.notes.size(), 1U);
  EXPECT_NE(setup.notes[0].find("selective"), std::string::npos);
}

TEST(ResolvedRender, AnUnknownIntegratorOfTheSceneIsReplacedOneOfTheUserIsRefused) {
  desc::RenderHints hints;
  hints.integrator = "future";
  EXPECT_NE(resolve_render({}, hints, film_of(3, 2)).notes.at(0).find("future"), std::string::npos);
  RenderSpec spec;
  spec.integrator = "future";
  EXPECT_THROW(resolve_render(spec, {}, film_of(3, 2)), UsageError);
}

TEST(ResolvedRender, AnyLimitOfTheUserReplacesTheSamplesOfTheScene) {
  desc::RenderHints hints;
  hints.samples_per_pixel = 12;
  RenderSpec spec;
  spec.seconds = 5.0;
  const ResolvedRender setup = resolve_render(spec, hints, film_of(3, 2));
  EXPECT_FALSE(setup.budget.samples_per_pixel.has_value());
  EXPECT_EQ(setup.budget.seconds, 5.0);
}

TEST(ResolvedRender, FewSamplesMeanFewReplicates) {
  for (const auto& [samples, replicates] : {std::pair{1, 1}, {2, 2}, {3, 3}, {4, 4}, {64, 4}}) {
    RenderSpec spec;
    spec.samples_per_pixel = samples;
    EXPECT_EQ(resolve_render(spec, {}, film_of(3, 2)).settings.replicates, replicates);
  }
}

TEST(ResolvedRender, ParametersOfTheUserComeLast) {
  desc::RenderHints hints;
  hints.sampler = "independent";
  RenderSpec spec;
  spec.integrator = "pt";
  EXPECT_EQ(resolve_render(spec, hints, film_of(3, 2)).parameters.at("sampler"), "independent");
  spec.parameters["sampler"] = "sobol";
  EXPECT_EQ(resolve_render(spec, hints, film_of(3, 2)).parameters.at("sampler"), "sobol");
}

TEST(ResolvedRender, RecordsHaveTheParametersThatMatter) {
  const auto recorded = [](const char* integrator) {
    RenderSpec spec;
    spec.integrator = integrator;
    const ResolvedRender setup = resolve_render(spec, {}, {});
    const Parameters parameters = setup.integrator->read(setup.parameters);
    return record_of(setup, parameters, "builtin:cornell", spec).parameters;
  };
  const auto masked = recorded("masked");
  for (const char* of_mmlt : {"chain", "omc", "sigma", "chains"}) {
    EXPECT_TRUE(masked.contains(of_mmlt)) << of_mmlt;
  }
  EXPECT_FALSE(masked.contains("chain-length")) << "of erpt";
}

TEST(ResolvedRender, ScaleMultipliesTheResolutionOfTheScene) {
  RenderSpec spec;
  spec.scale = 0.5;
  EXPECT_EQ(resolve_render(spec, {}, film_of(31, 20)).resolution, Vec2i(16, 10));
  spec.scale = 1e-6;
  EXPECT_EQ(resolve_render(spec, {}, film_of(31, 20)).resolution, Vec2i(1, 1));
  spec.scale = 1e6;
  EXPECT_THROW(resolve_render(spec, {}, film_of(31, 20)), UsageError);
  spec.scale = 0.0;
  EXPECT_THROW(resolve_render(spec, {}, film_of(31, 20)), UsageError);
}

TEST(ResolvedRender, CropWindowOfTheSceneIsKeptUnlessTheUserGivesOne) {
  desc::Film film = film_of(40, 20);
  film.crop[0] = 0.5F;
  film.crop[3] = 0.25F;
  const ResolvedRender from_scene = resolve_render({}, {}, film);
  EXPECT_EQ(from_scene.crop.min, Vec2i(20, 0));
  EXPECT_EQ(from_scene.crop.max, Vec2i(39, 4));
  RenderSpec spec;
  spec.crop_window = parse_crop("--crop", "0,0,1,1");
  EXPECT_EQ(resolve_render(spec, {}, film).crop.min, Vec2i(0, 0));
  film.crop[1] = 0.5F;
  EXPECT_THROW(resolve_render({}, {}, film), SceneError);
}

TEST(ResolvedRender, DepthAboveTheSceneIsExplained) {
  desc::RenderHints hints;
  hints.max_depth = 5;
  RenderSpec spec;
  spec.min_depth = 6;
  EXPECT_THROW(resolve_render(spec, hints, film_of(3, 2)), UsageError);
  spec.max_depth = 9;
  EXPECT_EQ(resolve_render(spec, hints, film_of(3, 2)).settings.max_depth, 9);
}

TEST(ResolvedRender, OnlyGatheredLayersAreAskedOfTheIntegrator) {
  RenderSpec spec;
  spec.layers = {"direct", "albedo", "samples", "standard-error"};
  const ResolvedRender setup = resolve_render(spec, {}, film_of(3, 2));
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

TEST(ResolvedRender, TakesTheParametersOfChainsThatScenesOfOtherRenderersHave) {
  desc::RenderHints hints;
  hints.integrator = "mmlt";
  hints.parameters = {{"bootstrapsamples", "5000"},
                      {"largestepprobability", "0.4"},
                      {"sigma", "0.02"},
                      {"chains", "-3"},
                      {"mutationsperpixel", "64"}};
  const ResolvedRender setup = resolve_render({}, hints, {});
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
