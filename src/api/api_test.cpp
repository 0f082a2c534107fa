#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <thread>

#include "ajar/ajar.h"

// The library as a program of others sees it: no header but its own.
namespace {

ajar::Settings small_settings() {
  ajar::Settings settings;
  settings.integrator = "pt";
  settings.resolution = {24, 18};
  settings.samples_per_pixel = 8;
  return settings;
}

bool has(const std::vector<ajar::Choice>& choices, const std::string& name) {
  return std::any_of(choices.begin(), choices.end(), [&](const ajar::Choice& choice) {
    return choice.name == name && !choice.summary.empty();
  });
}

/// Kind of the error that it raises, if any.
std::optional<ajar::Error::Kind> raised(const std::function<void()>& work) {
  try {
    work();
  } catch (const ajar::Error& error) {
    EXPECT_FALSE(std::string(error.what()).empty());
    return error.kind();
  }
  return std::nullopt;
}

TEST(Interface, ListsWhatThereIs) {
  EXPECT_FALSE(ajar::version().empty());
  EXPECT_TRUE(has(ajar::integrators(), "selective"));
  EXPECT_TRUE(has(ajar::builtin_scenes(), "builtin:cornell"));
}

TEST(Interface, RendersAScene) {
  const ajar::Scene scene = ajar::Scene::load("builtin:cornell");
  EXPECT_EQ(scene.name(), "builtin:cornell");
  EXPECT_GT(scene.width(), 24);
  EXPECT_TRUE(scene.warnings().empty());
  ajar::Settings settings = small_settings();
  settings.layers = {"depth"};
  const ajar::Picture picture = ajar::render(scene, settings);
  EXPECT_EQ(picture.width(), 24);
  EXPECT_EQ(picture.height(), 18);
  EXPECT_EQ(picture.layers().front(), "");
  EXPECT_EQ(picture.channels(), 3);
  EXPECT_EQ(picture.pixels().size(), 3U * 24U * 18U);
  EXPECT_EQ(picture.pixels("depth").size(),
            static_cast<std::size_t>(picture.channels("depth")) * 24U * 18U);
  EXPECT_GT(*std::max_element(picture.pixels().begin(), picture.pixels().end()), 0.F);
  EXPECT_EQ(picture.metadata().at("ajar:samples_per_pixel"), "8");
  EXPECT_EQ(raised([&] { picture.pixels("no-such-layer"); }), ajar::Error::Kind::Usage);
}

TEST(Interface, BuildsASceneOnceForRendersOfItsSize) {
  const ajar::Scene scene = ajar::Scene::load("builtin:cornell");
  // Error of a render that takes the scene as it is.
  const auto builds = [&](const ajar::Settings& settings) {
    ajar::Render render(scene, settings);
    const ajar::Picture picture = render.run();
    const ajar::Picture alone = ajar::render(ajar::Scene::load("builtin:cornell"), settings);
    EXPECT_TRUE(std::ranges::equal(picture.pixels(), alone.pixels()));
    return render.statistics().find("\"build\": 0.0,") == std::string::npos;
  };
  ajar::Settings settings = small_settings();
  EXPECT_TRUE(builds(settings));
  settings.seed = 3;
  settings.max_depth = 4;
  EXPECT_FALSE(builds(settings));
  settings.integrator = "bdpt";
  EXPECT_FALSE(builds(settings));
  settings.resolution = {20, 18};
  EXPECT_TRUE(builds(settings));
}

TEST(Interface, TakesTheNoiseOutOfPictures) {
  ajar::Settings settings = small_settings();
  settings.denoise = "outo";
  const ajar::Scene scene = ajar::Scene::load("builtin:cornell");
  EXPECT_THROW(ajar::render(scene, settings), ajar::Error);
  settings.denoise = "auto";
  const ajar::Picture picture = ajar::render(scene, settings);
  const ajar::Picture without = ajar::render(scene, small_settings());
  EXPECT_TRUE(std::ranges::equal(picture.pixels(), without.pixels()));
  const auto has_it = [](const ajar::Picture& of) {
    const auto layers = of.layers();
    return std::ranges::find(layers, "denoised") != layers.end();
  };
  EXPECT_FALSE(has_it(without));
  EXPECT_TRUE(has_it(picture)) << "the built-in filter is on every machine";
}

TEST(Interface, RendersASceneTwiceAtOnce) {
  const ajar::Scene scene = ajar::Scene::load("builtin:cornell");
  const ajar::Picture alone = ajar::render(scene, small_settings());
  std::optional<ajar::Picture> other;
  std::thread thread([&] { other = ajar::render(scene, small_settings()); });
  const ajar::Picture one = ajar::render(scene, small_settings());
  thread.join();
  EXPECT_TRUE(std::ranges::equal(one.pixels(), alone.pixels()));
  EXPECT_TRUE(std::ranges::equal(other->pixels(), alone.pixels()));
}

TEST(Interface, SavesPictures) {
  const ajar::Picture picture =
      ajar::render(ajar::Scene::load("builtin:cornell"), small_settings());
  const auto path = std::filesystem::temp_directory_path() /
                    ("ajar-interface-" + std::to_string(getpid()) + ".png");
  picture.save(path.string(), {.exposure = 1.F, .tone_map = "filmic"});
  EXPECT_GT(std::filesystem::file_size(path), 0U);
  std::filesystem::remove(path);
  EXPECT_EQ(raised([&] { picture.save("picture.nothing"); }), ajar::Error::Kind::Usage);
  EXPECT_EQ(raised([&] { picture.save("/no/such/folder/picture.png"); }), ajar::Error::Kind::File);
}

TEST(Interface, RendersAWindowThroughAnotherFilter) {
  const ajar::Scene scene = ajar::Scene::load("builtin:cornell");
  ajar::Settings settings = small_settings();
  settings.filter = "box";
  settings.layers = {"depth"};
  const ajar::Picture whole = ajar::render(scene, settings);
  settings.crop = {5, 3, 15, 9};
  const ajar::Picture part = ajar::render(scene, settings);
  ASSERT_EQ(part.width(), 10);
  ASSERT_EQ(part.height(), 6);
  // Difference of its depths from those of a window of the whole picture.
  const auto difference = [&](std::size_t left, std::size_t top) {
    float sum = 0.F;
    for (std::size_t y = 0; y < 6; ++y) {
      for (std::size_t x = 0; x < 10; ++x) {
        sum += std::abs(part.pixels("depth")[y * 10 + x] -
                        whole.pixels("depth")[(y + top) * 24 + x + left]);
      }
    }
    return sum;
  };
  for (const std::size_t other : {4U, 6U}) EXPECT_LT(4.F * difference(5, 3), difference(other, 3));
  for (const std::size_t other : {2U, 4U}) EXPECT_LT(4.F * difference(5, 3), difference(5, other));
  settings.filter = "gaussian:2";
  EXPECT_FALSE(std::ranges::equal(ajar::render(scene, settings).pixels(), part.pixels()));
  settings.filter = "round";
  EXPECT_EQ(raised([&] { ajar::render(scene, settings); }), ajar::Error::Kind::Usage);
  settings.filter.clear();
  for (const std::array<int, 4>& crop :
       {std::array{30, 0, 40, 10}, {-1, 0, 10, 10}, {0, -1, 10, 10}, {5, 0, 5, 10}, {0, 9, 9, 3}}) {
    settings.crop = crop;
    EXPECT_EQ(raised([&] { ajar::render(scene, settings); }), ajar::Error::Kind::Usage);
  }
}

TEST(Interface, GoesOnFromACheckpoint) {
  const ajar::Scene scene = ajar::Scene::load("builtin:cornell");
  ajar::Settings settings = small_settings();
  settings.samples_per_pixel = 16;
  const ajar::Picture in_one = ajar::render(scene, settings);
  settings.resume = true;
  EXPECT_EQ(raised([&] { ajar::render(scene, settings); }), ajar::Error::Kind::Usage);
  const auto path = std::filesystem::temp_directory_path() /
                    ("ajar-interface-" + std::to_string(getpid()) + ".checkpoint");
  settings.checkpoint = path.string();
  settings.samples_per_pixel = 8;
  ajar::render(scene, settings);
  ASSERT_TRUE(std::filesystem::exists(path));
  settings.samples_per_pixel = 16;
  EXPECT_TRUE(std::ranges::equal(ajar::render(scene, settings).pixels(), in_one.pixels()));
  settings.checkpoint_every = std::nan("");
  EXPECT_EQ(raised([&] { ajar::render(scene, settings); }), ajar::Error::Kind::Usage);
  settings.checkpoint_every = 60.0;
  settings.seed = 1;
  EXPECT_NE(raised([&] { ajar::render(scene, settings); }), std::nullopt) << "another render";
  std::filesystem::remove(path);
}

TEST(Interface, RefusesNumbersThatTheCommandLineRefuses) {
  const ajar::Scene scene = ajar::Scene::load("builtin:cornell");
  const auto expect_refused = [&](const std::function<void(ajar::Settings&)>& change) {
    ajar::Settings settings = small_settings();
    change(settings);
    EXPECT_EQ(raised([&] { ajar::Render render(scene, settings); }), ajar::Error::Kind::Usage);
  };
  using Settings = ajar::Settings;
  for (const int threads : {-1, 4097, 1000000}) {
    expect_refused([=](Settings& settings) { settings.threads = threads; });
  }
  for (const std::uint64_t samples : {std::uint64_t{0}, std::uint64_t{1} << 32U}) {
    expect_refused([=](Settings& settings) { settings.samples_per_pixel = samples; });
  }
  for (const double number : {std::nan(""), -1.0, 0.0, 1e300, HUGE_VAL}) {
    expect_refused([=](Settings& settings) { settings.seconds = number; });
    expect_refused([=](Settings& settings) { settings.target_error = number; });
    expect_refused([=](Settings& settings) { settings.checkpoint_every = number; });
    expect_refused([=](Settings& settings) {
      settings.resolution.reset();
      settings.scale = number;
    });
  }
  for (const std::array<int, 2>& size : {std::array{0, 1}, {1, 65537}, {-1, 1}}) {
    expect_refused([=](Settings& settings) { settings.resolution = size; });
  }
  for (const int depth : {0, -1, 1001}) {
    expect_refused([=](Settings& settings) { settings.min_depth = depth; });
    expect_refused([=](Settings& settings) { settings.max_depth = depth; });
  }
  expect_refused([](Settings& settings) {
    settings.min_depth = 4;
    settings.max_depth = 3;
  });
  const ajar::Picture picture = ajar::render(scene, small_settings());
  for (const float exposure : {65.F, -65.F, std::nanf(""), HUGE_VALF}) {
    EXPECT_EQ(raised([&] { picture.save("never-written.png", {.exposure = exposure}); }),
              ajar::Error::Kind::Usage);
  }
}

TEST(Interface, TellsWhereACheckpointWentThatCouldNotBeWritten) {
  namespace fs = std::filesystem;
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no device that is full";
  const fs::path folder =
      fs::temp_directory_path() / ("ajar-interface-full-" + std::to_string(getpid()));
  fs::create_directories(folder);
  const fs::path before = fs::current_path();
  fs::current_path(folder);  // where it is rescued
  fs::create_symlink("/dev/full", "room.checkpoint");
  ajar::Settings settings = small_settings();
  settings.checkpoint = "room.checkpoint";
  std::vector<std::string> troubles;
  std::vector<std::string> warnings;
  ajar::Callbacks callbacks;
  callbacks.warning = [&](const std::string& text) { warnings.push_back(text); };
  const ajar::Scene scene = ajar::Scene::load("builtin:cornell");
  ajar::Render(scene, settings, callbacks).run();
  ASSERT_EQ(warnings.size(), 1U) << "who asks for warnings alone is told, too";
  callbacks.trouble = [&](const std::string& text) { troubles.push_back(text); };
  fs::remove(folder / ("room-rescued-" + std::to_string(getpid()) + ".checkpoint"));
  ajar::Render(scene, settings, callbacks).run();
  EXPECT_EQ(warnings.size(), 1U);
  ASSERT_EQ(troubles.size(), 1U);
  EXPECT_NE(troubles[0].find(folder.string() + "/room-rescued-"), std::string::npos) << troubles[0];
  fs::current_path(before);
  fs::remove_all(folder);
}

TEST(Interface, DescribesChangesAndComparesScenes) {
  const std::vector<float> corners = {-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1};
  const std::vector<std::uint32_t> triangles = {0, 2, 1, 0, 3, 2};
  const std::vector<ajar::Array> arrays = {{corners.data(), ajar::Array::Type::Float32, {4, 3}},
                                           {triangles.data(), ajar::Array::Type::UInt32, {2, 3}}};
  const ajar::Scene grey = ajar::Scene::describe(R"({
      "source": "floor", "film": {"resolution": [24, 18]},
      "camera": {"model": "perspective", "fov": 40,
                 "to_world": [1,0,0,0, 0,0,-1,4, 0,-1,0,0, 0,0,0,1]},
      "materials": [{"name": "matt", "model": "diffuse", "parameters": {"reflectance": 0.5}}],
      "shapes": [{"model": "mesh", "parameters": {"mesh": {"positions": 0, "indices": 1}},
                  "material": 0}],
      "lights": [{"model": "environment", "parameters": {"radiance": 1}}]})",
                                                 arrays);
  EXPECT_EQ(grey.name(), "floor");
  EXPECT_NE(grey.parts().find("\"matt\""), std::string::npos);
  const ajar::Scene dark = grey.changed(R"({"edits": [
      {"kind": "material", "which": "matt", "parameters": {"reflectance": 0.25}}]})");
  namespace fs = std::filesystem;
  const fs::path folder =
      fs::temp_directory_path() / ("ajar-api-compare-" + std::to_string(getpid()));
  fs::create_directories(folder);
  const auto saved = [&](const ajar::Scene& scene, const char* name) {
    const std::string path = (folder / name).string();
    ajar::render(scene, small_settings()).save(path);
    return path;
  };
  const std::string reference = saved(grey, "grey.exr");
  const std::string picture = saved(dark, "dark.exr");
  const std::string same = ajar::compare(reference, {reference}, {"mse"});
  EXPECT_NE(same.find("\"mse\":0.0"), std::string::npos) << same;
  const std::string other = ajar::compare(reference, {picture}, {"mse"});
  EXPECT_EQ(other.find("\"mse\":0.0,"), std::string::npos) << other;
  EXPECT_EQ(ajar::Picture::load(reference).width(), 24);
  fs::remove_all(folder);

  ajar::check_node("material", R"({"model": "diffuse"})");
  EXPECT_NE(ajar::catalog("materials").find("\"diffuse\""), std::string::npos);
  using Kind = ajar::Error::Kind;
  EXPECT_EQ(raised([&] { grey.changed("{}", std::vector<ajar::Array>(1)); }), Kind::Usage);
  EXPECT_EQ(raised([&] { grey.changed(R"({"edits": [{"kind": "light", "which": 7}]})"); }),
            Kind::Scene);
  EXPECT_EQ(raised([] { ajar::check_node("material", R"({"model": "difuse"})"); }), Kind::Scene);
  EXPECT_EQ(raised([] { ajar::catalog("material"); }), Kind::Usage);
  EXPECT_EQ(raised([] { ajar::Picture::load("/no/such.exr"); }), Kind::File);
  EXPECT_EQ(raised([&] { ajar::compare("/no/such.exr", {"/no/such.exr"}); }), Kind::File);
}

TEST(Interface, TellsWhatIsWrong) {
  EXPECT_EQ(raised([] { ajar::Scene::load("/no/such/scene.pbrt"); }), ajar::Error::Kind::File);
  EXPECT_EQ(raised([] { ajar::Scene::load("builtin:none"); }), ajar::Error::Kind::Usage);
  ajar::Settings settings = small_settings();
  settings.integrator = "none";
  const ajar::Scene scene = ajar::Scene::load("builtin:cornell");
  EXPECT_EQ(raised([&] { ajar::Render render(scene, settings); }), ajar::Error::Kind::Usage);
  settings = small_settings();
  settings.parameters["none"] = "1";
  EXPECT_EQ(raised([&] { ajar::render(scene, settings); }), ajar::Error::Kind::Usage);
  settings = small_settings();
  settings.integrator = "mmlt";
  ajar::Render stopped(scene, settings);
  stopped.stop();
  stopped.stop();
  EXPECT_EQ(raised([&] { stopped.run(); }), ajar::Error::Kind::Stopped);
}

TEST(Interface, CallsBackAndIsAskedByOtherThreads) {
  ajar::Settings settings = small_settings();
  settings.samples_per_pixel.reset();
  settings.seconds = 86400.0;  // no test waits for it
  int passes = 0;
  int pictures = 0;
  ajar::Callbacks callbacks;
  callbacks.progress = [&](const ajar::Progress& progress) {
    ++passes;
    EXPECT_FALSE(progress.preparing);
    EXPECT_GT(progress.samples_per_pixel, 0.0);
  };
  callbacks.picture = [&](const ajar::Picture& picture) {
    ++pictures;
    EXPECT_EQ(picture.width(), 24);
  };
  callbacks.picture_every = 0.0;
  ajar::Render render(ajar::Scene::load("builtin:cornell"), settings, callbacks);
  EXPECT_FALSE(render.picture());
  std::thread viewer([&] {
    while (!render.picture()) std::this_thread::yield();
    EXPECT_NE(render.statistics().find("\"not yet\""), std::string::npos);
    EXPECT_GT(render.progress().samples_per_pixel, 0.0);
    render.stop();
  });
  const ajar::Picture picture = render.run();
  viewer.join();
  EXPECT_GT(passes, 0);
  EXPECT_GT(pictures, 0);
  ASSERT_TRUE(render.picture());
  EXPECT_TRUE(std::equal(picture.pixels().begin(), picture.pixels().end(),
                         render.picture()->pixels().begin()));
}

}  // namespace
