#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "support/render.h"
#include "support/same_picture.h"
#include "support/small_scenes.h"

/// Markov chains with their options against ordinary Monte Carlo, block by block, indirect light
/// apart. (Every integrator as it is: agreement_test.cpp.) Chains of different replicates share
/// nothing, so replicates are independent.
namespace ajar {
namespace {

using test::expect_same;
using test::replicates_of;

constexpr int kReplicates = 16;

struct Variant {
  std::string name;
  std::string integrator;
  std::map<std::string, std::string> parameters;
  std::vector<std::string> scenes = {};  ///< empty: all
};

const std::vector<Variant>& variants() {
  static const std::vector<Variant> kVariants = {
      {"mmlt, ibpt, gaussian",
       "mmlt",
       {{"techniques", "ibpt"}, {"mutation", "gaussian"}, {"large-step", "0.1"}},
       {"GlassAndMetal", "ThinLens"}},
      {"mmlt, single techniques",
       "mmlt",
       {{"techniques", "(0,*),(1,2),(1,3),(3,*),(*,1)"}, {"heuristic", "balance"}},
       {"Room", "PointAndSpot", "CroppedMitchell"}},
      {"mmlt, half moves",
       "mmlt",
       {{"camera-steps", "0.3"}, {"light-steps", "0.3"}},
       {"Room", "ThinLens", "Fog", "NestedDielectrics"}},
      {"mmlt, half moves only",
       "mmlt",
       {{"camera-steps", "0.5"}, {"light-steps", "0.5"}, {"mutation", "gaussian"}},
       {"GlassAndMetal", "Distant", "Orthographic"}},
      {"mmlt, MIS of large steps",
       "mmlt",
       {{"mis-large-steps", "true"}},
       {"Mirror", "RoughGlass", "ManyLamps"}},
      // Adapting after the first of four passes. So small thresholds that most pixels pass them.
      {"mmlt, adaptive, half moves",
       "mmlt",
       {{"step", "adaptive"},
        {"m1", "20"},
        {"k1", "60"},
        {"k2", "50"},
        {"camera-steps", "0.2"},
        {"light-steps", "0.2"}},
       {"Room", "GlassAndMetal", "CroppedMitchell"}},
      {"mmlt, slemmlt",
       "mmlt",
       {{"mutation", "slemmlt"}, {"w", "20"}, {"camera-steps", "0.3"}},
       {"GlassAndMetal", "CroppedMitchell", "Fog"}},
      {"mmlt, fusion",
       "mmlt",
       {{"mutation", "fusion"}, {"w", "60"}, {"m1", "20"}, {"large-step", "0.05"}},
       {"CroppedMitchell", "Environment", "Orthographic"}},
      {"mmlt, three tries, filtered seeds",
       "mmlt",
       {{"multi-try", "3"}, {"camera-steps", "0.3"}, {"seeds", "filtered"}},
       {"Room", "CroppedMitchell"}},
      {"pssmlt, pt",
       "pssmlt",
       {{"techniques", "pt"}},
       {"Room", "Fog", "Environment", "CroppedMitchell"}},
      {"pssmlt, ibpt, MIS of large steps, gaussian",
       "pssmlt",
       {{"techniques", "ibpt"}, {"mis-large-steps", "true"}, {"mutation", "gaussian"}},
       {"Mirror", "ThinLens", "Orthographic", "MilkBall"}},
      // So low that most of the light starts chains, and is divided about evenly: what one side
      // forgets or counts twice would show.
      {"selective, low split",
       "selective",
       {{"split", "0.5"}},
       {"Room", "GlassAndMetal", "Fog", "ThinLens", "CroppedMitchell", "NestedDielectrics"}},
      {"selective, ibpt, pilot discarded",
       "selective",
       {{"techniques", "ibpt"}, {"split", "1"}, {"pilot", "discard"}},
       {"Environment", "PointAndSpot", "ThinLens"}},
      {"selective, nothing adaptive",
       "selective",
       {{"split", "0.5"}, {"importance", "uniform"}, {"roulette", "usual"}, {"objective", "raw"}},
       {"Mirror", "MilkBall", "RoughGlass"}},
      {"selective, chains of numbers, few light subpaths",
       "selective",
       {{"chain", "mmlt"},
        {"techniques", "ibpt"},
        {"light-paths-per-pixel", "0.33"},
        {"split", "0.3"}},
       {"Room", "Orthographic", "CroppedMitchell", "Fog"}},
      {"selective, many light subpaths",
       "selective",
       {{"light-paths-per-pixel", "3"}, {"split", "0.3"}},
       {"Room", "CroppedMitchell", "ThinLens"}},
      {"selective, paths",
       "selective",
       {{"chain", "mlt"}, {"roulette", "usual"}},
       {"GlassAndMetal", "Distant", "ManyLamps", "ShadingNormals", "CroppedMitchell"}},
      {"selective, paths, low split",
       "selective",
       {{"chain", "mlt"}, {"techniques", "bdpt"}, {"split", "0.3"}, {"roulette", "usual"}},
       {"Room", "GlassAndMetal", "RoughGlass", "Fog", "ColoredSmoke", "ThinLens", "Environment",
        "PointAndSpot", "NestedDielectrics", "EnvironmentCamera", "CroppedMitchell"}},
      {"masked, light tracing and pssmlt",
       "masked",
       {{"omc", "lt"}, {"chain", "pssmlt"}},
       {"Room", "ManyLamps"}},
      {"masked, path tracing and mlt",
       "masked",
       {{"omc", "pt"}, {"chain", "mlt"}},
       {"Room", "Environment", "MilkBall"}},
      {"masked, erpt, exclusive",
       "masked",
       {{"chain", "erpt"}, {"choice", "exclusive"}},
       {"Room", "RoughGlass", "CroppedMitchell"}},
      {"masked, exclusive",
       "masked",
       {{"choice", "exclusive"}},
       {"Mirror", "CroppedMitchell", "Environment"}},
  };
  return kVariants;
}

/// Samples that bring the mean's error to a half or so of the tolerance. Light that is divided
/// needs fewer, and chains of one path at a time most.
int samples_of(const Variant& variant) {
  if (variant.integrator == "mmlt") return 512;
  if (variant.integrator == "pssmlt") return 256;
  return variant.integrator == "masked" ? 96 : 80;
}

class ChainAgreement : public ::testing::TestWithParam<test::SmallScene> {};

TEST_P(ChainAgreement, ChainsHaveTheExpectationOfBidirectionalPathTracing) {
  const test::SmallScene& small = GetParam();
  const auto scene = test::scene_from(small.text);
  test::RenderOptions options;
  options.replicates = kReplicates;
  options.max_depth = 6;
  options.crop = small.crop;
  options.samples = 160;
  options.integrator = "bdpt";
  const test::Render truth = test::render(*scene, options);
  options.seed = 2;
  for (const Variant& variant : variants()) {
    const auto& scenes = variant.scenes;
    if (!scenes.empty() && std::find(scenes.begin(), scenes.end(), small.name) == scenes.end()) {
      continue;
    }
    options.integrator = variant.integrator;
    options.parameters = variant.parameters;
    if (variant.integrator.ends_with("mlt")) options.parameters.emplace("bootstrap", "240000");
    if (variant.integrator == "masked") {
      options.parameters.insert(
          {{"pilot-samples", "8"}, {"mutations", "4"}, {"bootstrap", "120000"}});
    }
    options.samples = samples_of(variant);
    const test::Render render = test::render(*scene, options);
    const bool is_divided = variant.integrator == "selective" || variant.integrator == "masked";
    expect_same(replicates_of(render, "indirect"), replicates_of(truth, "indirect"), *render.film,
                is_divided ? 0.15 : 0.3, variant.name + ", indirect");
    expect_same(replicates_of(render), replicates_of(truth), *render.film, is_divided ? 0.12 : 0.2,
                variant.name);
  }
}

TEST(ChainAgreementInARangeOfDepths, HoldsForPathsOfFourAndFiveEdges) {
  for (const test::SmallScene& small : test::small_scenes()) {
    if (small.name != "GlassAndMetal" && small.name != "Room") continue;
    const auto scene = test::scene_from(small.text);
    test::RenderOptions options;
    options.replicates = kReplicates;
    options.min_depth = 4;
    options.max_depth = 5;
    options.samples = 320;
    options.integrator = "bdpt";
    const Replicates truth = replicates_of(test::render(*scene, options));
    options.seed = 2;
    options.parameters["bootstrap"] = "800000";
    for (const char* integrator : {"mmlt", "pssmlt"}) {
      options.integrator = integrator;
      const test::Render render = test::render(*scene, options);
      expect_same(replicates_of(render), truth, *render.film, 0.25, small.name + ", " + integrator);
    }
    options.samples = 128;
    options.parameters["bootstrap"] = "64000";
    for (const char* integrator : {"mlt", "erpt"}) {
      options.integrator = integrator;
      const test::Render render = test::render(*scene, options);
      expect_same(replicates_of(render), truth, *render.film, 0.5, small.name + ", " + integrator);
    }
  }
}

/// No method uses chains of numbers by default here.
TEST(ChainAgreementOfEnergyRedistribution, HoldsForChainsOfNumbers) {
  for (const char* name : {"GlassAndMetal", "CroppedMitchell"}) {
    test::KnownPicture known = test::known_picture(name, 160);
    known.options.integrator = "erpt";
    known.options.parameters = {{"chain", "pssmlt"}, {"bootstrap", "30000"}};
    const test::Render render = test::render(*known.scene, known.options);
    expect_same(replicates_of(render), replicates_of(known.truth), *render.film, 0.4, name);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ChainAgreement, ::testing::ValuesIn(test::small_scenes()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace ajar
