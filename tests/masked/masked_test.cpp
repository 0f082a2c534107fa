#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/error.h"
#include "imageio/image_file.h"
#include "support/mean_over_seeds.h"
#include "support/render.h"
#include "support/same_picture.h"
#include "support/small_scenes.h"
#include "support/temporary_file.h"

/// Selective Metropolis as published. The expectations of its pairs of methods are compared with
/// others' in chain_agreement_test.cpp.
namespace ajar {
namespace {

using test::TemporaryFile;

std::unique_ptr<Scene> small_scene(const std::string& name) {
  return test::scene_from(test::small_scene(name).text);
}

test::RenderOptions options_for(std::uint64_t samples) {
  test::RenderOptions options;
  options.integrator = "masked";
  options.replicates = 4;
  options.samples = samples;
  options.max_depth = 5;
  options.parameters = {{"bootstrap", "4000"}};
  return options;
}

/// Writes a map of one weight for all pixels.
void write_map(const std::string& path, Vec2i size, float weight) {
  const std::vector<float> pixels(
      3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), weight);
  write_image(path, {size, Box2i(Vec2i(0, 0), size - Vec2i(1, 1)), {{"", 3, pixels}}, {}});
}

std::map<std::string, std::vector<float>> maps_of(const test::Render& render) {
  std::map<std::string, std::vector<float>> maps;
  for (auto& [name, plane] : render.integrator->findings().maps) maps[name] = plane.values;
  return maps;
}

/// Light that few samples find, on many things: a small lamp in a glass ball above a field of
/// balls.
std::unique_ptr<Scene> scene_of_fireflies() {
  std::string world =
      "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [400 400 400] Translate 0 1.6 0 Shape "
      "\"sphere\" \"float radius\" [0.05] AttributeEnd\n"
      "AttributeBegin Material \"glass\" Translate 0 1.6 0 Shape \"sphere\" \"float radius\" "
      "[0.3] AttributeEnd\nMaterial \"matte\" \"rgb Kd\" [0.7 0.7 0.7]\n";
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 8; ++column) {
      world += "AttributeBegin Translate " + std::to_string(0.5 * column - 1.75) + " 0 " +
               std::to_string(0.5 * row - 1.25) +
               " Shape \"sphere\" \"float radius\" [0.25] AttributeEnd\n";
    }
  }
  return test::scene_from(test::pbrt_scene(
      "LookAt 0 5 0  0 0 0  0 0 1 Camera \"perspective\" \"float fov\" [35]", 24, 18, world));
}

TEST(Masked, IsBiasedByAPilotThatIsKeptOnly) {
  const auto scene = scene_of_fireflies();
  test::RenderOptions options;
  options.max_depth = 5;
  options.integrator = "bdpt";
  options.samples = 256;
  options.replicates = 4;
  const Moments truth = test::means_of_other_seeds(*scene, options, 8);
  options.replicates = 4;
  options.samples = 4;
  options.integrator = "masked";
  // Few techniques, so that it is mostly fireflies that tell the map anything.
  options.parameters = {{"omc", "pt"}, {"pilot", "discard"}, {"bootstrap", "8000"}};
  test::expect_mean_over_seeds({truth.mean(), truth.standard_error(), 0.25 * truth.mean()}, 80,
                               test::mean_of_seed(*scene, options), "discard");
  options.parameters["pilot"] = "keep";
  const Moments kept = test::means_of_other_seeds(*scene, options, 80);
  EXPECT_LT(
      (kept.mean() - truth.mean()) / std::hypot(kept.standard_error(), truth.standard_error()),
      -5.0)
      << "where the pilot found no light, it stays dark";
}

/// σ is 1 in regions whose noise reaches T, and ε elsewhere.
TEST(Masked, MakesABinaryMaskOfRegions) {
  const auto scene = scene_of_fireflies();
  test::RenderOptions options = options_for(4);
  options.aovs = {"noise", "regions", "importance"};
  options.parameters["epsilon"] = "0.25";
  const test::Render render = test::render(*scene, options);
  const auto maps = maps_of(render);
  ASSERT_EQ(maps.size(), 3U);
  std::map<float, bool> is_noisy;
  for (std::size_t i = 0; i < maps.at("noise").size(); ++i) {
    is_noisy[maps.at("regions")[i]] |= maps.at("noise")[i] >= 0.5F;
  }
  int masked = 0;
  for (std::size_t i = 0; i < maps.at("noise").size(); ++i) {
    const bool noisy = is_noisy.at(maps.at("regions")[i]);
    ASSERT_EQ(maps.at("importance")[i], noisy ? 1.F : 0.25F) << "pixel " << i;
    masked += noisy ? 1 : 0;
  }
  EXPECT_GT(masked, 0);
  EXPECT_LT(masked, static_cast<int>(maps.at("noise").size()));
}

TEST(Masked, LeavesLambertianRegionsToMonteCarloIfAsked) {
  const auto scene = small_scene("GlassAndMetal");
  test::RenderOptions options = options_for(4);
  options.parameters.insert({{"omc", "lt"}, {"lambertian", "omc"}, {"epsilon", "0.125"}});
  const MethodReport report = test::render(*scene, options).integrator->report().at("masked");
  int lambertian = 0;
  for (const auto& region : report.at("regions")) {
    const std::string material = region.at("material");
    if (material.empty()) continue;
    const auto& names = scene->material_names();
    const auto number =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), material) - names.begin());
    if (!scene->material(static_cast<desc::MaterialId>(number)).is_diffuse()) continue;
    EXPECT_EQ(region.at("importance"), 0.125) << material;
    ++lambertian;
  }
  EXPECT_GT(lambertian, 0);
}

TEST(Masked, TakesTheUsersRegions) {
  const auto scene = small_scene("GlassAndMetal");
  const TemporaryFile rules("rules.txt");
  std::ofstream(rules.path()) << "object * omc\nmaterial material-2 0.25\n";
  test::RenderOptions options = options_for(4);
  options.parameters.insert({{"regions", rules.path()}, {"epsilon", "0.125"}});
  const MethodReport report = test::render(*scene, options).integrator->report().at("masked");
  int quarter = 0;
  for (const auto& region : report.at("regions")) {
    if (region.at("object") == "") continue;
    const bool named = region.at("material") == "material-2";
    quarter += named ? 1 : 0;
    EXPECT_EQ(region.at("importance"), named ? 0.25 : 0.125) << region.at("material");
  }
  EXPECT_GT(quarter, 0);
}

/// Chains have a fraction of the light of each pixel in their target, and the picture takes all of
/// it from them.
TEST(Masked, HasTheSameExpectationWherePixelsAreOfChainsAlone) {
  const auto scene = small_scene("Room");
  const TemporaryFile map("map.pfm");
  write_map(map.path(), scene->camera().resolution(), 0.6F);
  test::RenderOptions options;
  options.replicates = 16;
  options.max_depth = 6;
  options.samples = 256;
  options.integrator = "bdpt";
  const test::Render truth = test::render(*scene, options);
  options.integrator = "masked";
  options.seed = 2;
  options.samples = 96;
  for (const char* chain : {"mmlt", "mlt"}) {
    options.parameters = {{"choice", "exclusive"}, {"chain", chain},
                          {"pilot-samples", "1"},  {"mutations", "4"},
                          {"bootstrap", "120000"}, {"regions", map.path()}};
    const test::Render render = test::render(*scene, options);
    test::expect_same(test::replicates_of(render), test::replicates_of(truth), *render.film, 0.25,
                      chain);
  }
}

TEST(Masked, RefusesParametersOfOtherChains) {
  const auto scene = small_scene("Room");
  using Settings = std::map<std::string, std::string>;
  for (const Settings& settings :
       {Settings{{"chain", "mlt"}, {"large-step", "0.2"}}, Settings{{"chain-length", "5"}},
        Settings{{"chain", "erpt"}, {"chains", "10"}}, Settings{{"window", "4"}},
        Settings{{"mutation", "slemmlt"}}}) {
    test::RenderOptions options = options_for(1);
    options.parameters.insert(settings.begin(), settings.end());
    EXPECT_THROW(test::render(*scene, options), UsageError) << settings.begin()->first;
  }
}

}  // namespace
}  // namespace ajar
