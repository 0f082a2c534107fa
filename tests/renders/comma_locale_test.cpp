#include "support/comma_locale.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/number_text.h"
#include "imageio/pfm.h"
#include "scene/coordinate_limit.h"
#include "session/scenes/scene_file.h"
#include "support/methods.h"
#include "support/render.h"
#include "support/room_formats.h"
#include "support/small_scenes.h"

/// Numbers in files, in parameters and in output have a point, whatever the locale of the program
/// that the library is part of.
namespace ajar::test {
namespace {

/// Text written by `tell`, in the usual locale and with commas.
template <typename Tell>
void expect_same_with_commas(const Tell& tell) {
  const auto usual = tell();
  const CommaLocale locale;
  std::ostringstream shown;
  shown << 1234.5;
  ASSERT_EQ(shown.str(), "1.234,5") << "or nothing is tested";
  EXPECT_EQ(tell(), usual);
  if (!locale.is_whole()) GTEST_SKIP() << "only of streams: localedef makes no locale de_DE here";
}

TEST(CommaLocale, LeavesTheFilesOfAllFormatsAlone) {
  const TemporaryFile folder("room");
  const std::filesystem::path in(folder.path());
  std::filesystem::create_directory(in);
  std::vector<std::string> files;
  const auto add = [&](const char* name, const auto& write) {
    std::filesystem::create_directory(in / name);
    files.push_back(write(in / name));
  };
  using Path = const std::filesystem::path&;
  add("pbrt3", [](Path to) { return write_pbrt3_room(to, RoomSurface::Principled); });
  add("pbrt4", [](Path to) { return write_pbrt4_room(to); });
  add("mitsuba06", [](Path to) { return write_mitsuba_room(to, "0.6.0", RoomSurface::Diffuse); });
  add("mitsuba3", [](Path to) { return write_mitsuba_room(to, "3.0.0", RoomSurface::Diffuse); });
  add("tungsten", [](Path to) { return write_tungsten_room(to); });
  add("gltf", [](Path to) { return write_gltf_room(to); });
  add("glb", [](Path to) { return write_glb_room(to); });
  expect_same_with_commas([&] {
    std::vector<std::uint64_t> hashes;
    for (const std::string& file : files) {
      Warnings warnings;
      hashes.push_back(desc::hash(load_scene(file, warnings)));
    }
    return hashes;
  });
  std::filesystem::remove_all(in);
}

TEST(CommaLocale, LeavesPicturesOfAllMethodsAlone) {
  const auto scene = scene_from(small_scene("GlassAndMetal").text);
  expect_same_with_commas([&] {
    std::vector<std::vector<float>> pictures;
    for (const std::string& method : methods_but({})) {
      RenderOptions options{.integrator = method, .samples = 4, .replicates = 2, .max_depth = 6};
      if (method == "ibpt" || method == "selective") {
        options.parameters = {{"light-paths-per-pixel", "0.33"}};
      }
      pictures.push_back(render(*scene, options).image());
    }
    return pictures;
  });
}

TEST(CommaLocale, LeavesTechniquesImagesAndMessagesAlone) {
  expect_same_with_commas([] {
    std::vector<std::string> told;
    const TechniqueSet techniques = TechniqueSet::parse("explicit*1.5,inner*0.25");
    told.push_back(number_text(techniques.count(TechniqueClass::Inner)));
    told.push_back(number_text(decimal_of(0.1F)));
    const TemporaryFile file("a.pfm");
    std::ofstream(file.path(), std::ios::binary) << "Pf\n1 1\n-1.0\n" << std::string(4, '\0');
    told.push_back(std::to_string(read_pfm(file.path()).width));
    try {
      check_reach({}, "it", 1.5e20);
    } catch (const Error& error) {
      told.emplace_back(error.what());
    }
    return told;
  });
}

}  // namespace
}  // namespace ajar::test
