#include "support/selective.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/random.h"
#include "image/metrics.h"
#include "imageio/image_file.h"
#include "support/mean_over_seeds.h"
#include "support/render.h"
#include "support/same_picture.h"
#include "support/small_scenes.h"
#include "support/stripes.h"
#include "support/temporary_file.h"

/// The maps of `selective`. The expectation of all of its modes is compared with that of other
/// chains in chain_agreement_test.cpp.
namespace ajar {
namespace {

using test::expect_mean_over_seeds;
using test::expect_same;
using test::prepared_render;
using test::replicates_of;
using test::report_of;
using test::selective_options;
using test::TemporaryFile;

std::unique_ptr<Scene> small_scene(const std::string& name) {
  return test::scene_from(test::small_scene(name).text);
}

/// `weight(i)`: of pixel i, row by row.
void write_map(const std::string& path, Vec2i size,
               const std::function<float(std::uint64_t)>& weight) {
  std::vector<float> pixels;
  for (std::uint64_t i = 0;
       i < static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y); ++i) {
    pixels.insert(pixels.end(), 3, weight(i));
  }
  write_image(path, {size, Box2i(Vec2i(0, 0), size - Vec2i(1, 1)), {{"", 3, pixels}}, {}});
}

/// Renders with each set of parameters, and compares the pictures with one of bidirectional path
/// tracing.
void expect_same_as_bdpt(const Scene& scene, test::RenderOptions options,
                         const std::vector<std::map<std::string, std::string>>& settings,
                         const std::string& what) {
  options.integrator = "bdpt";
  const test::Render truth = test::render(scene, options);
  options.integrator = "selective";
  options.seed = 2;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    options.parameters = settings[i];
    const test::Render render = test::render(scene, options);
    expect_same(replicates_of(render), replicates_of(truth), *render.film, 0.1,
                what + ", setting " + std::to_string(i));
  }
}

test::RenderOptions options_for_maps() {
  test::RenderOptions options;
  options.replicates = 16;
  options.max_depth = 6;
  options.samples = 64;
  return options;
}

TEST(Selective, HasTheSameExpectationForAnyMap) {
  for (const char* name : {"Room", "CroppedMitchell"}) {
    const auto scene = small_scene(name);
    const TemporaryFile map("map.pfm");
    write_map(map.path(), scene->camera().resolution(), [](std::uint64_t i) {
      const float u = to_unit_float(static_cast<std::uint32_t>(hash_numbers(5, i) >> 32U));
      // A third of the pixels has no chains at all, a third nothing else.
      return u < 0.33F ? 0.F : u > 0.67F ? 1.F : u;
    });
    std::vector<std::map<std::string, std::string>> settings;
    for (const char* techniques : {"bdpt", "ibpt"}) {
      settings.push_back({{"techniques", techniques}, {"regions", map.path()}, {"split", "0.5"}});
    }
    expect_same_as_bdpt(*scene, options_for_maps(), settings, name);
  }
}

/// Settings with chains of explicit paths.
std::vector<std::map<std::string, std::string>> settings_with_paths() {
  return {{{"techniques", "bdpt"}, {"split", "0.5"}},
          {{"techniques", "ibpt"}, {"split", "0.3"}},
          {{"techniques", "pt"}, {"split", "0.5"}},
          {{"techniques", "bdpt"}, {"light-paths-per-pixel", "3"}, {"split", "0.2"}}};
}

TEST(Selective, HasTheSameExpectationForAnyMapWithChainsOfPaths) {
  bool first_is_random = true;
  for (const char* name : {"Room", "GlassAndMetal", "CroppedMitchell"}) {
    const auto scene = small_scene(name);
    const Vec2i size = scene->camera().resolution();
    const TemporaryFile random("random.pfm");
    const auto width = static_cast<std::uint64_t>(size.x);
    // Cells as wide as blocks that are compared, so that light that chains take elsewhere shows.
    write_map(random.path(), size, [&](std::uint64_t i) {
      const std::uint64_t cell = i % width / 6 + 100 * (i / width / 6);
      const float u = to_unit_float(static_cast<std::uint32_t>(hash_numbers(6, cell) >> 32U));
      return u < 0.33F ? 0.F : u > 0.67F ? 1.F : u;
    });
    const TemporaryFile binary("binary.pfm");
    write_map(binary.path(), size,
              [&](std::uint64_t i) { return i % width < width / 2 ? 1.F : 0.F; });
    std::vector<std::map<std::string, std::string>> settings = settings_with_paths();
    for (std::size_t i = 0; i < settings.size(); ++i) {
      // Each pair has both of them in one scene or another.
      const TemporaryFile& map = (i % 2 == 0) == first_is_random ? random : binary;
      settings[i].insert({{"chain", "mlt"}, {"regions", map.path()}});
    }
    first_is_random = !first_is_random;
    expect_same_as_bdpt(*scene, options_for_maps(), settings, name);
  }
}

Moments truth_of(const Scene& scene, test::RenderOptions options) {
  options.replicates = 4;
  options.integrator = "bdpt";
  options.samples = 128;
  return test::means_of_other_seeds(scene, options, 8);
}

// Pixels that show two objects count as one of them, independently of the picture's own samples:
// when those voted, the ones that saw the brighter object were weighed by its map, and the picture
// was 0.11 too bright.
TEST(Selective, RegionsAreIndependentOfKeptSamples) {
  const auto scene = test::stripes(
      16, 12,
      "LightSource \"point\" \"point from\" [0 12 -6] \"rgb I\" [100 100 100]\n"
      "AttributeBegin Material \"matte\" \"rgb Kd\" [0.7 0.7 0.7] ReverseOrientation\n"
      "Shape \"sphere\" \"float radius\" [30] AttributeEnd\n",
      0.5F);
  const TemporaryFile rules("rules.txt");
  std::ofstream(rules.path()) << "material bright chain\nmaterial dark omc\n";
  test::RenderOptions options;
  options.min_depth = 3;
  options.max_depth = 6;
  const Moments truth = truth_of(*scene, options);
  options.replicates = 4;
  options.samples = 4;
  options.integrator = "selective";
  for (const char* pilot : {"cross", "discard"}) {
    options.parameters = {{"regions", rules.path()}, {"techniques", "bdpt"}, {"pilot", pilot}};
    expect_mean_over_seeds({truth.mean(), truth.standard_error(), 0.04 * truth.mean()}, 100,
                           test::mean_of_seed(*scene, options), pilot);
  }
}

std::string quad(const std::string& points) {
  return "Shape \"trianglemesh\" \"point P\" [" + points + "] \"integer indices\" [0 2 1 0 3 2]\n";
}

/// Two boxes without lids, side by side, in the left one a wide lamp; and `rest`.
std::unique_ptr<Scene> scene_of_two_boxes(const std::string& lamps, const std::string& rest) {
  return test::scene_from(test::pbrt_scene(
      "LookAt 0 3.5 -4.5  0 0.3 0.4  0 1 0 Camera \"perspective\" \"float fov\" [40]", 24, 12,
      "Material \"matte\" \"rgb Kd\" [0.7 0.7 0.7]\n" + quad("-2 0 -1  2 0 -1  2 0 1  -2 0 1") +
          quad("-2 0 1  2 0 1  2 1.5 1  -2 1.5 1") + quad("0 0 -1  0 0 1  0 1.5 1  0 1.5 -1") +
          "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [2 2 2]\n" +
          quad("-2 0 -1  -2 0 1  -2 1.5 1  -2 1.5 -1") + lamps + "AttributeEnd\n" + rest));
}

/// The wide lamp is one that rays run into; in the right box is a small one, which they have to be
/// sent to.
std::unique_ptr<Scene> scene_of_two_lamps() {
  return scene_of_two_boxes(
      "",
      "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [900 900 900]\n"
      "Translate 1 0.7 0 Shape \"sphere\" \"float radius\" [0.02] AttributeEnd\n");
}

/// Means of the left and the right half of the indirect light.
std::pair<double, double> halves_of(const test::Render& render) {
  const std::vector<float> pixels = render.layer("indirect");
  std::pair<double, double> means;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const bool is_left = i / 3 % 24 < 12;
    (is_left ? means.first : means.second) += static_cast<double>(pixels[i]);
  }
  return means;
}

// b comes from independent samples, so chains with a wrong part of each path only move light about.
// With what rays into the lamp leave alone, or with their strength for all techniques, a fifth of
// the light went from the right half of the picture to the left.
TEST(Selective, LeavesLightWhereItIsWhicheverTechniquesFindIt) {
  const auto scene = scene_of_two_lamps();
  test::RenderOptions options;
  options.min_depth = 3;
  options.max_depth = 3;
  options.samples = 4096;
  options.replicates = 4;
  options.integrator = "bdpt";
  const auto [left, right] = halves_of(test::render(*scene, options));
  options.samples = 64;
  options.integrator = "selective";
  for (const char* split : {"0.3", "3"}) {
    options.parameters = {
        {"chain", "mlt"}, {"techniques", "pt"}, {"split", split}, {"importance", "uniform"}};
    Moments shares;
    for (std::uint64_t i = 0; i < 24; ++i) {
      options.seed = 300 + i;
      const auto [own_left, own_right] = halves_of(test::render(*scene, options));
      shares.add(own_left / (own_left + own_right));
    }
    const double truth = left / (left + right);
    EXPECT_LT(5.0 * shares.standard_error(), 0.13) << split << ": too noisy to notice a bias";
    EXPECT_LT(std::abs(shares.mean() - truth), 5.0 * shares.standard_error()) << split;
  }
}

/// Seen through a pane: on the left the wide lamp behind another pane, of which no connection makes
/// the light that has been scattered once; on the right one without, of which connections make all.
std::unique_ptr<Scene> scene_of_panes() {
  return scene_of_two_boxes(quad("2 0 1  2 0 -1  2 1.5 -1  2 1.5 1"),
                            "Material \"glass\" \"float index\" [1.1]\n" +
                                quad("-1.9 0 -1  -1.9 0 1  -1.9 1.5 1  -1.9 1.5 -1") +
                                quad("-2 1 -3  2 1 -3  2 4.5 -3  -2 4.5 -3"));
}

struct OfHalves {
  Moments left;
  Moments right;
};
OfHalves halves_of_seeds(const Scene& scene, test::RenderOptions options, std::uint64_t seeds) {
  OfHalves halves;
  for (std::uint64_t i = 0; i < seeds; ++i) {
    options.seed = 500 + i;
    const auto [left, right] = halves_of(test::render(scene, options));
    halves.left.add(left);
    halves.right.add(right);
  }
  return halves;
}

// Classes of chains partition the paths: none is made twice, and none is left out.
TEST(Selective, DividesPathsAmongChainsByTheirClass) {
  const auto scene = scene_of_panes();
  test::RenderOptions options;
  options.min_depth = 4;
  options.max_depth = 5;
  options.samples = 256;
  options.replicates = 4;
  options.integrator = "bdpt";
  const OfHalves truth = halves_of_seeds(*scene, options, 8);
  options.samples = 16;
  options.integrator = "selective";
  for (const char* chain : {"auto", "mmlt"}) {
    options.parameters = {
        {"chain", chain}, {"techniques", "bdpt"}, {"split", "0.05"}, {"roulette", "usual"}};
    const OfHalves own = halves_of_seeds(*scene, options, 24);
    for (const auto& [mine, right] :
         {std::pair(own.left, truth.left), std::pair(own.right, truth.right)}) {
      const double error = 5.0 * std::hypot(mine.standard_error(), right.standard_error());
      EXPECT_LT(error, 0.1 * right.mean()) << chain << ": too noisy to notice a bias";
      EXPECT_LT(std::abs(mine.mean() - right.mean()), error) << chain;
    }
  }
}

// Either kind moves as it does elsewhere.
TEST(Selective, MovesEachKindOfChainByItsOwnMoves) {
  const auto scene = scene_of_panes();
  test::RenderOptions options;
  options.min_depth = 4;
  options.max_depth = 5;
  options.samples = 8;
  options.replicates = 4;
  options.integrator = "selective";
  options.parameters = {{"techniques", "bdpt"}, {"split", "0.05"}};
  const MethodReport report = test::render(*scene, options).integrator->report();
  std::set<std::string> moves;
  for (const auto& move : report["acceptance"]["by_move"]) moves.insert(move["move"]);
  for (const char* move : {"large", "small", "raster", "bidirectional", "multi-chain"}) {
    EXPECT_TRUE(moves.contains(move)) << move;
  }
  EXPECT_FALSE(moves.contains("caustic")) << "paths that no connection makes have no such form";
}

TEST(Selective, HasTheSameExpectationWithAndWithoutTheSamplesOfThePilot) {
  const auto scene = small_scene("Room");
  test::RenderOptions options;
  options.max_depth = 5;
  const Moments truth = truth_of(*scene, options);
  // Equal samples of the pilot and of the render.
  options.samples = 4;
  options.integrator = "selective";
  // The pilot is kept from four replicates on.
  for (const int replicates : {2, 4}) {
    options.replicates = replicates;
    expect_mean_over_seeds({truth.mean(), truth.standard_error(), 0.04 * truth.mean()}, 80,
                           test::mean_of_seed(*scene, options),
                           std::to_string(replicates) + " replicates");
  }
}

TEST(Selective, ShowsItsMaps) {
  const auto scene = small_scene("GlassAndMetal");
  test::RenderOptions options = selective_options(8);
  options.aovs = {"noise", "regions", "importance", "edges", "object-id"};
  const test::Render render = test::render(*scene, options);
  std::map<std::string, std::vector<float>> maps;
  for (auto& [name, plane] : render.integrator->findings().maps) {
    EXPECT_EQ(plane.size, Vec2i(render.film->width(), render.film->height()));
    maps[name] = plane.values;
  }
  ASSERT_EQ(maps.size(), 4U);
  for (const char* name : {"noise", "importance", "edges"}) {
    for (const float value : maps[name]) {
      EXPECT_GE(value, 0.F) << name;
      EXPECT_LE(value, 1.F) << name;
    }
  }
  const MethodReport report = render.integrator->report().at("selective");
  EXPECT_EQ(*std::max_element(maps["regions"].begin(), maps["regions"].end()),
            report.at("region_count").get<float>());
  std::size_t pixels = 0;
  for (const auto& region : report.at("regions")) pixels += region.at("pixels").get<std::size_t>();
  EXPECT_EQ(pixels, maps["regions"].size());
  EXPECT_EQ(report.at("pilot_stays"), true);
}

TEST(Selective, TakesTheUsersRules) {
  const auto scene = small_scene("GlassAndMetal");
  const TemporaryFile rules("rules.txt");
  std::ofstream(rules.path()) << "object * omc\nmaterial material-2 0.25\n";
  test::RenderOptions options = selective_options(4);
  options.parameters = {{"regions", rules.path()}};
  const MethodReport report = test::render(*scene, options).integrator->report().at("selective");
  std::size_t quarter = 0;
  for (const auto& region : report.at("regions")) {
    if (region.at("object") == "") continue;
    const bool named = region.at("material") == "material-2";
    quarter += named ? 1 : 0;
    EXPECT_EQ(region.at("importance"), named ? 0.25 : 0.0) << region.at("material");
  }
  EXPECT_GT(quarter, 0U);
  std::ofstream(rules.path()) << "material chrome chain\n";
  try {
    test::render(*scene, options);
    FAIL() << "a rule that matches nothing must be refused";
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what()).find(":1:10"), std::string::npos) << error.what();
  }
}

TEST(Selective, UpdatesThePriceOfRaysFromItsSamples) {
  const auto scene = small_scene("Room");
  const auto price_after = [&](std::uint64_t samples) {
    test::RenderOptions options = selective_options(samples);
    options.max_depth = 6;
    const MethodReport report = test::render(*scene, options).integrator->report();
    return report.at("selective").at("omc").at("ray_price").get<double>();
  };
  const double of_pilot = price_after(1);
  const double later = price_after(32);
  EXPECT_GT(of_pilot, 0.0);
  EXPECT_NE(later, of_pilot);
  EXPECT_GT(later, 0.1 * of_pilot);
  EXPECT_LT(later, 10.0 * of_pilot);
}

/// A map without chains takes none, and tells what it is.
TEST(Selective, TakesNoChainsWhereTheUserWantsNone) {
  const auto scene = small_scene("GlassAndMetal");
  const TemporaryFile map("map.pfm");
  using Settings = std::map<std::string, std::string>;
  for (const float weight : {0.F, 1.F}) {
    write_map(map.path(), scene->camera().resolution(), [&](std::uint64_t) { return weight; });
    for (const Settings& more : {Settings{{"chain", "mlt"}}, Settings{{"split", "0.1"}}}) {
      Settings settings = more;
      settings["regions"] = map.path();
      const test::Render render = prepared_render(*scene, 1, settings);
      EXPECT_EQ(render.counters.mutations > 0, weight > 0.F) << more.begin()->first;
      if (weight == 0.F) {
        EXPECT_TRUE(render.integrator->findings().concerns.empty());
      }
      const MethodReport report = render.integrator->report().at("selective");
      EXPECT_TRUE(report.at("correlation").is_null()) << "nothing has told yet";
      EXPECT_TRUE(report.at("chains").at("squared_error_share").is_null());
      if (weight > 0.F) continue;
      for (const auto& region : report.at("regions")) EXPECT_EQ(region.at("importance"), 0.0);
    }
  }
}

/// Nothing is divided, and the film has no layer for it.
TEST(Selective, RendersDirectLightAlone) {
  test::RenderOptions options;
  options.replicates = 4;
  options.samples = 64;
  options.max_depth = 2;
  expect_same_as_bdpt(*small_scene("Room"), options, {{}}, "direct light");
}

}  // namespace
}  // namespace ajar
