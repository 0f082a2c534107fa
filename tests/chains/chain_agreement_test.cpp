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
      // Half of the light or so for chains, and mutations as they pay.
      {"mmlt+, effort shared anew",
       "mmlt+",
       {{"split", "1"}, {"omc-samples", "0"}},
       {"Room", "GlassAndMetal", "ThinLens"}},
      // So low that most of the light starts chains.
      {"selective, low split",
       "selective",
       {{"split", "0.5"}},
       {"Room", "GlassAndMetal", "Fog", "ThinLens", "CroppedMitchell", "NestedDielectrics"}},
      {"selective, ibpt",
       "selective",
       {{"techniques", "ibpt"}, {"omc", "ibpt"}, {"split", "1"}, {"pilot", "discard"}},
       {"Environment", "PointAndSpot", "ThinLens"}},
      {"selective, binary map of paths",
       "selective",
       {{"map", "binary"}, {"split", "0.5"}, {"pilot-samples", "8"}},
       {"Mirror", "CroppedMitchell"}},
      {"selective, by regions alone",
       "selective",
       {{"omc", "ibpt"}, {"map", "binary"}, {"pilot-samples", "8"}, {"bootstrap", "120000"}},
       {"Mirror", "CroppedMitchell", "Environment"}},
      {"selective, light tracing and pssmlt",
       "selective",
       {{"omc", "lt"}, {"chain", "pssmlt"}, {"pilot", "discard"}, {"bootstrap", "120000"}},
       {"Room", "ManyLamps"}},
      {"selective, paths",
       "selective",
       {{"chain", "mlt"}},
       {"GlassAndMetal", "Distant", "ManyLamps", "ShadingNormals", "CroppedMitchell"}},
      {"selective, paths, low split",
       "selective",
       {{"chain", "mlt"}, {"split", "0.3"}},
       {"Room", "GlassAndMetal", "RoughGlass", "Fog", "ColoredSmoke", "ThinLens", "Environment",
        "PointAndSpot", "NestedDielectrics", "EnvironmentCamera", "CroppedMitchell"}},
      {"selective, path tracing and paths, by regions alone",
       "selective",
       {{"omc", "pt"},
        {"chain", "mlt"},
        {"map", "binary"},
        {"pilot-samples", "8"},
        {"bootstrap", "120000"}},
       {"Room", "Environment", "MilkBall"}},
      {"selective, spread paths, low split",
       "selective",
       {{"chain", "erpt"}, {"split", "0.3"}},
       {"Room", "RoughGlass", "Environment", "CroppedMitchell"}},
      {"mmlt+ of paths, ibpt, few light subpaths",
       "mmlt+",
       {{"chain", "mlt"},
        {"techniques", "ibpt"},
        {"light-paths-per-pixel", "0.33"},
        {"split", "0.3"}},
       {"Room", "Orthographic", "CroppedMitchell"}},
      {"mmlt+ of paths, direct light too",
       "mmlt+",
       {{"chain", "mlt"}, {"direct", "chain"}, {"split", "0"}, {"bootstrap", "240000"}},
       {"Room", "Mirror"}},
      {"selective, exclusive",
       "selective",
       {{"choice", "exclusive"},
        {"map", "binary"},
        {"pilot-samples", "8"},
        {"bootstrap", "240000"}},
       {"Room", "RoughGlass", "CroppedMitchell"}},
      {"mmlt+, chains alone", "mmlt+", {{"split", "0"}}},
      {"pssmlt+, chains alone",
       "pssmlt+",
       {{"split", "0"}},
       {"Room", "GlassAndMetal", "Environment", "ThinLens", "Fog", "CroppedMitchell"}},
      // So low that most of the light is divided about evenly: omissions or double counting of one
      // side would show.
      {"mmlt+, low split",
       "mmlt+",
       {{"split", "0.5"}},
       {"Mirror", "RoughGlass", "Environment", "MilkBall", "ThinLens", "CroppedMitchell"}},
      {"pssmlt+, low split",
       "pssmlt+",
       {{"split", "0.5"}, {"importance", "uniform"}},
       {"Room", "GlassAndMetal", "CroppedMitchell", "Fog"}},
      {"mmlt+, ibpt",
       "mmlt+",
       {{"techniques", "ibpt"}},
       {"GlassAndMetal", "Environment", "ThinLens"}},
      {"mmlt+, single techniques",
       "mmlt+",
       {{"techniques", "(0,*),(1,2),(1,3),(3,*),(*,1)"},
        {"heuristic", "balance"},
        {"importance", "uniform"}},
       {"Room", "PointAndSpot", "CroppedMitchell"}},
      {"mmlt+, half moves",
       "mmlt+",
       {{"camera-steps", "0.3"}, {"light-steps", "0.3"}, {"raster-steps", "0"}},
       {"Room", "ThinLens", "Fog", "NestedDielectrics", "CroppedMitchell"}},
      {"mmlt+, half moves only",
       "mmlt+",
       {{"camera-steps", "0.5"}, {"light-steps", "0.5"}, {"raster-steps", "0"}},
       {"GlassAndMetal", "Distant", "Orthographic"}},
      {"mmlt+, relative",
       "mmlt+",
       {{"importance", "relative"}},
       {"Room", "GlassAndMetal", "CroppedMitchell", "MilkBall"}},
      {"mmlt+, few light subpaths",
       "mmlt+",
       {{"light-paths-per-pixel", "0.5"}, {"split", "0.3"}},
       {"Room", "GlassAndMetal", "CroppedMitchell", "Fog"}},
      {"mmlt+, many light subpaths",
       "mmlt+",
       {{"light-paths-per-pixel", "3"}, {"split", "0.3"}},
       {"Room", "CroppedMitchell", "ThinLens"}},
      {"mmlt+, ibpt, few light subpaths",
       "mmlt+",
       {{"techniques", "ibpt"}, {"light-paths-per-pixel", "0.33"}, {"split", "0.3"}},
       {"Room", "CroppedMitchell", "Orthographic"}},
      {"mmlt+, MIS of large steps",
       "mmlt+",
       {{"mis-large-steps", "true"}},
       {"Mirror", "RoughGlass", "ManyLamps"}},
      {"mmlt+, direct light too",
       "mmlt+",
       {{"direct", "chain"},
        {"split", "0"},
        {"bootstrap", "240000"},
        {"fine-steps", "0"},
        {"raster-steps", "0"}},
       {"GlassAndMetal", "Environment", "CroppedMitchell", "ShadingNormals"}},
      {"pssmlt+, pt, relative",
       "pssmlt+",
       {{"techniques", "pt"}, {"importance", "relative"}},
       {"Room", "Fog", "Environment", "CroppedMitchell"}},
      {"pssmlt+, ibpt",
       "pssmlt+",
       {{"techniques", "ibpt"}},
       {"Mirror", "ThinLens", "Orthographic"}},
      {"pssmlt+, MIS of large steps, half moves, gaussian",
       "pssmlt+",
       {{"mis-large-steps", "true"},
        {"camera-steps", "0.2"},
        {"light-steps", "0.2"},
        {"mutation", "gaussian"}},
       {"GlassAndMetal", "EnvironmentCamera", "MilkBall"}},
      // Adapting after the first of four passes. So small thresholds that most pixels pass them.
      {"mmlt+, adaptive",
       "mmlt+",
       {{"step", "adaptive"}, {"m1", "20"}, {"k1", "60"}, {"k2", "50"}, {"split", "0"}},
       {"Room", "GlassAndMetal", "ThinLens"}},
      {"mmlt+, adaptive, half moves",
       "mmlt+",
       {{"step", "adaptive"},
        {"m1", "20"},
        {"k1", "60"},
        {"k2", "50"},
        {"camera-steps", "0.2"},
        {"light-steps", "0.2"},
        {"split", "0"}},
       {"Room", "CroppedMitchell"}},
      {"mmlt+, slemmlt",
       "mmlt+",
       {{"mutation", "slemmlt"}, {"w", "20"}, {"camera-steps", "0.3"}, {"split", "0"}},
       {"GlassAndMetal", "CroppedMitchell", "Fog"}},
      {"mmlt+, fusion",
       "mmlt+",
       {{"mutation", "fusion"}, {"w", "60"}, {"m1", "20"}, {"large-step", "0.05"}, {"split", "0"}},
       {"CroppedMitchell", "Environment", "Orthographic"}},
      {"mmlt+, three tries, filtered seeds",
       "mmlt+",
       {{"multi-try", "3"}, {"camera-steps", "0.3"}, {"seeds", "filtered"}, {"split", "0"}},
       {"Room", "CroppedMitchell"}},
      {"pssmlt+, two tries, MIS of large steps",
       "pssmlt+",
       {{"multi-try", "2"}, {"mis-large-steps", "true"}, {"raster-steps", "0.5"}},
       {"ThinLens", "Orthographic"}},
      {"pssmlt+, fusion",
       "pssmlt+",
       {{"mutation", "fusion"}, {"w", "60"}, {"m1", "20"}, {"split", "0"}},
       {"Room", "CroppedMitchell"}},
      {"pssmlt+, direct light too",
       "pssmlt+",
       {{"direct", "chain"}, {"split", "0"}},
       {"Room", "Environment", "CroppedMitchell"}},
  };
  return kVariants;
}

/// Samples for an error of the mean of about half of the tolerance. Divided light needs fewer, and
/// chains of one path at a time most.
int samples_of(const Variant& variant) {
  const bool one_path = variant.integrator.starts_with("mmlt");
  if (variant.integrator == "mmlt" || variant.parameters.contains("direct")) {
    return one_path ? 768 : 256;
  }
  if (variant.parameters.contains("split")) return one_path ? 384 : 128;
  return 96;
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
    if (variant.integrator.ends_with("+")) {
      options.parameters.emplace("bootstrap", "60000");
      options.parameters.emplace("omc-samples", "1");
    }
    if (variant.integrator == "mmlt") options.parameters.emplace("bootstrap", "240000");
    options.samples = samples_of(variant);
    const test::Render render = test::render(*scene, options);
    expect_same(replicates_of(render, "indirect"), replicates_of(truth, "indirect"), *render.film,
                0.3, variant.name + ", indirect");
    expect_same(replicates_of(render), replicates_of(truth), *render.film, 0.25, variant.name);
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
    for (const char* integrator : {"mmlt+", "pssmlt+"}) {
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
