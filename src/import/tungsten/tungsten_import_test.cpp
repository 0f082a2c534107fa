#include "import/tungsten/tungsten_import.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "import/import.h"
#include "import/shared_scenes_test_support.h"
#include "import/testing/temporary_folder.h"
#include "import/tungsten/import_test_support.h"

namespace ajar::tungsten {
namespace {

namespace fs = std::filesystem;

std::string quoted(std::string text) {
  for (char& c : text) c = c == '\'' ? '"' : c;
  return text;
}

TEST(TungstenImport, RefusesOtherFiles) {
  for (const char* text : {"{}", "[]", "7", R"({"integrator": "pt", "seconds": 4})"}) {
    EXPECT_TRUE(contains(error_of(text), "test.json:1:1: this is no scene of Tungsten")) << text;
  }
  EXPECT_EQ(error_of("{\"camera\": }").find("test.json:1:12: this is no JSON: "), 0U)
      << error_of("{\"camera\": }");
  EXPECT_EQ(error_of(quoted("{'camera': 7}")),
            "test.json:1:12#/camera: must be a camera, which is an object, not 7");
}

TEST(TungstenImport, RefusesScenesOfOtherPrograms) {
  for (
      const auto& [text, says] :
      {std::pair(R"({"asset": {"generator": "Yocto/GL - https://github.com/xelatihy/yocto-gl"},
                      "cameras": [{"name": "c"}], "instances": [{"shape": 0}]})",
                 "one of Yocto/GL"),
       {R"({"asset": {"version": "2.0"}, "nodes": [], "camera": {}})", "one of glTF"},
       {R"({"metadata": {"type": "App"}, "camera": {"object": {}}, "scene": {}})", "three.js"},
       {R"({"camera": {"transform": {"o": [0, 0, 5]}, "vfov": 45}, "surfaces": [],
             "materials": []})",
        "one of Darts or DIRT"},
       {R"({"camera": {"type": "thin_lens", "param": {}}, "shapes": [], "materials": []})",
        "one of Vision"},
       {R"({"version": 2, "active_camera": "c", "camera": {}, "models": [{"file": "a"}]})",
        "one of Falcor"},
       {R"({"camera": {"eye": [0, 0, 5]}, "lights": [], "objects": [{"type": "sphere"}]})",
        "it has no \"bsdfs\", but \"lights\", \"objects\""},
       {R"({"camera": {"fov": 45}, "integrator": {"type": "path"}, "meshes": [{"file": "a.obj"}]})",
        "one of Nori"},
       {R"({"primitives": [{"type": "sphere", "center": [0, 0, 0], "radius": 1}]})",
        "none of its \"primitives\" has what those of Tungsten have"},
       {R"({"camera": {"eye": [0, 0, 5], "target": [0, 0, 0]}})", "its \"camera\" has nothing"},
       {R"({"generator": "My exporter 2", "camera": {}, "entities": []})",
        "it was made by \"My exporter 2\""}}) {
    const std::string error = error_of(text);
    EXPECT_TRUE(contains(error, "test.json:1:1: this is no scene of Tungsten: ")) << error;
    EXPECT_TRUE(contains(error, says)) << error;
  }
  Warnings warnings;
  EXPECT_NO_THROW(import_with(R"({"version": "1", "comment": "mine", "camera": {"fov": 30},
                                  "primitives": [{"type": "quad", "bsdf": {"type": "lambert"}}]})",
                              warnings));
}

TEST(TungstenImport, ReadsTextInUtf16) {
  const std::string text = R"({"camera": {}, "bsdfs": [], "primitives": [{"type": "quad"}]})";
  std::string wide = "\xFE\xFF";
  for (const char c : text) wide += std::string{'\0', c};
  Warnings warnings;
  EXPECT_EQ(import_with(wide, warnings).shapes.size(), 1U);
  EXPECT_EQ(import_with("\xEF\xBB\xBF" + text, warnings).shapes.size(), 1U);
}

TEST(TungstenImport, FilesMayHaveCommentsAndTrailingCommas) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      quoted("{'camera': {}, // where we are\n'primitives': [{'type': 'quad'}, /* no more */],}"),
      warnings);
  EXPECT_EQ(warnings.count(), 0U);
  EXPECT_EQ(scene.shapes.size(), 1U);
  EXPECT_EQ(error_of(quoted("/* a */ {'camera':\n// b\n NaN}")).find("test.json:3:2: this is no"),
            0U)
      << error_of(quoted("/* a */ {'camera':\n// b\n NaN}"));
}

TEST(TungstenImport, UnknownMembersAreWarningsWithTheNearestName) {
  const std::string warnings = warnings_of(
      quoted("{'camera': {'fow': 30},\n'bsdfs': [{'name': 'a', 'type': 'lambert', 'albdo': 1}],\n"
             "'primitives': [{'type': 'quad', 'bsdf': 'a', 'bsdf': 'b'}], 'rendrer': {}}"));
  EXPECT_TRUE(contains(warnings,
                       "test.json:1:13#/camera: unknown member of a camera \"fow\"; did you mean "
                       "\"fov\"?"))
      << warnings;
  EXPECT_TRUE(contains(warnings,
                       "test.json:2:44#/bsdfs/0: unknown member of a bsdf \"albdo\"; did you mean "
                       "\"albedo\"?"))
      << warnings;
  EXPECT_TRUE(
      contains(warnings, "test.json:3:46: \"bsdf\" stands twice in this object: the first counts"))
      << warnings;
  EXPECT_TRUE(contains(warnings,
                       "unknown member of a scene \"rendrer\"; did you mean "
                       "\"renderer\"?"))
      << warnings;
}

TEST(TungstenImport, ReadsRenderSettings) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      quoted("{'primitives': [{'type': 'quad'}], 'camera': {}, 'integrator': {'type': "
             "'multiplexed_mlt', 'max_bounces': 8}, 'renderer': {'spp': 12, 'stratified_sampler': "
             "false, 'output_file': 'a.png', 'hdr_output_file': 'a.exr'}}"),
      warnings);
  EXPECT_EQ(warnings.count(), 0U);
  EXPECT_EQ(scene.hints.integrator, "mmlt");
  EXPECT_EQ(scene.hints.max_depth, 8);
  EXPECT_EQ(scene.hints.samples_per_pixel, 12);
  EXPECT_EQ(scene.hints.sampler, "independent");
  EXPECT_EQ(scene.film.filename, "a.exr");
}

TEST(TungstenImport, SettingsThatHaveNoCounterpartAreWarnings) {
  const auto with = [](const std::string& members) {
    return warnings_of(quoted("{'primitives': [{'type': 'quad'}], 'camera': {}, 'integrator': {" +
                              members + "}, 'renderer': {'spp': 0}}"));
  };
  EXPECT_TRUE(contains(with("'type': 'path_trcer'"), "did you mean \"path_tracer\"?"));
  EXPECT_TRUE(contains(with("'min_bounces': 1"), "\"min_bounces\" is not supported"));
  EXPECT_TRUE(contains(with("'enable_two_sided_shading': false"), "cannot be false"));
  EXPECT_TRUE(contains(with("'include_surfaces': false"), "all light is rendered"));
  EXPECT_TRUE(contains(with(""), "the number of samples must be 1 or more"));
  EXPECT_TRUE(contains(error_of(quoted("{'camera': {}, 'integrator': {'max_bounces': -1}}")),
                       "makes no sense"));
}

TEST(TungstenImport, MediaWithoutACounterpartAreWarnings) {
  const auto with = [](const std::string& medium) {
    return quoted("{'camera': {'medium': {" + medium + "}}}");
  };
  const std::string voxels = warnings_of(
      with("'type': 'voxel', 'grid': {'type': 'vdb', 'file': 'a.vdb', 'grid_nam': 'density'}"));
  EXPECT_TRUE(contains(voxels, "needs the grid \"a.vdb\", which is not read: it counts as empty"))
      << voxels;
  EXPECT_TRUE(contains(voxels, "did you mean \"grid_name\"")) << voxels;
  // Grid members of Tungsten are known, though they have no effect.
  EXPECT_FALSE(contains(
      warnings_of(with("'type': 'voxel', 'grid': {'density_name': 'd', 'normalize_size': true}")),
      "density_name"));
  EXPECT_TRUE(contains(warnings_of(with("'type': 'fog'")), "unknown medium type \"fog\""));
  EXPECT_TRUE(
      contains(warnings_of(with("'type': 'homogeneous', 'phase_function': {'type': 'rayleigh'}")),
               "Rayleigh scattering is not supported"));
  EXPECT_TRUE(contains(error_of(with("'type': 'homogeneous', 'sigma_s': -1")), "not negative"));
  EXPECT_TRUE(contains(warnings_of(quoted("{'camera': {'medium': 'x'}}")), "unknown medium \"x\""));
}

TEST(TungstenImport, MediaThatEndPathsEarlierAreWarnings) {
  const auto with = [](const std::string& medium, const std::string& integrator) {
    return warnings_of(
        quoted("{'primitives': [{'type': 'quad'}],\n'camera': {'medium': {'type': "
               "'homogeneous', " +
               medium + "}}, 'integrator': {" + integrator + "}}"));
  };
  EXPECT_TRUE(
      contains(with("'sigma_s': 1, 'max_bounces': 8", ""),
               "test.json:2:75#/camera/medium/max_bounces: paths that scatter more than 8 times"))
      << with("'sigma_s': 1, 'max_bounces': 8", "");
  EXPECT_TRUE(contains(with("'sigma_s': 1", "'max_bounces': 2000"),
                       "test.json:2:22#/camera/medium: paths that scatter more than 1024 times"));
  EXPECT_EQ(with("'sigma_s': 1, 'max_bounces': 8", "'max_bounces': 8"), "");
  EXPECT_EQ(with("'sigma_a': 1, 'max_bounces': 0", ""), "") << "what only absorbs ends no path";
  EXPECT_EQ(with("'sigma_s': 1", ""), "");
}

class OnDisk : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name) << text;
    return (folder_.path() / name).string();
  }
  TemporaryFolder folder_;
};

TEST_F(OnDisk, IsRecognisedByItsExtensionAndListsItsFiles) {
  const std::string path =
      write("room.json", scene_text("", "{'type': 'mesh', 'file': 'sub/m.wo3'}"));
  Warnings warnings;
  const desc::SceneDesc scene = import_scene(path, warnings);
  EXPECT_TRUE(scene.files.contains(path));
  EXPECT_TRUE(scene.files.contains((folder_.path() / "sub/m.wo3").string()));
  EXPECT_THROW(import_scene((folder_.path() / "none.json").string(), warnings), IoError);
}

TEST_F(OnDisk, PipesAndDevicesAreNotRead) {
  ASSERT_EQ(mkfifo((folder_.path() / "pipe.wo3").c_str(), 0600), 0);
  for (const char* file : {"pipe.wo3", "/dev/zero"}) {
    Warnings warnings;
    import_scene(write("a.json", scene_text("", std::string("{'type': 'mesh', 'file': '") + file +
                                                    "'}, {'type': 'instances', 'instances': '" +
                                                    file + "'}")),
                 warnings);
    EXPECT_GE(warnings.count(Effect::Geometry), 2U) << file;
  }
}

TEST(TungstenSharedScenes, MaterialTestLoads) {
  const fs::path file = shared_scenes_folder() / "material-testball/materialtest.json";
  if (!fs::exists(file)) GTEST_SKIP() << kNoSharedScenes;
  Warnings warnings;
  const desc::SceneDesc scene = import_scene(file.string(), warnings);
  EXPECT_EQ(scene.shapes.size(), 4U);
  EXPECT_EQ(scene.lights.size(), 1U);
  EXPECT_EQ(scene.film.resolution, Vec2i(1000, 563));
  // The coat, triangles without area, the tone map.
  EXPECT_EQ(warnings.count(), 3U);
  EXPECT_EQ(warnings.count(Effect::Slight), 1U);
  EXPECT_EQ(warnings.count(Effect::Surface), 0U);
  EXPECT_EQ(warnings.count(Effect::Geometry), 0U);
}

/// Where the corners of a mesh are, in an order of their own.
std::vector<Vec3> corners_of(const desc::Shape& shape) {
  std::vector<Vec3> corners;
  for (const Vec3& p : shape.node.mesh("mesh")->positions) {
    corners.push_back(moved(shape.to_world, p));
  }
  return corners;
}

/// Distance of the point of `of` that is farthest from all of `to`.
float farthest(const std::vector<Vec3>& of, const std::vector<Vec3>& to) {
  float result = 0.F;
  for (const Vec3& p : of) {
    float nearest = 1e30F;
    for (const Vec3& q : to) nearest = std::min(nearest, length(p - q));
    result = std::max(result, nearest);
  }
  return result;
}

TEST(TungstenSharedScenes, TheCornellBoxIsWhereOtherFormatsHaveIt) {
  const fs::path file = shared_scenes_folder() / "cornell-box/pbrt/scene.pbrt";
  if (!fs::exists(file)) GTEST_SKIP() << kNoSharedScenes;
  const auto primitive = [](const char* type, const char* place, const char* size,
                            const char* rotation) {
    return std::string("{'type': '") + type + "', 'transform': {'position': " + place +
           ", 'scale': " + size + ", 'rotation': " + rotation + "}}";
  };
  const std::string primitives =
      primitive("quad", "0", "[2, 4, 2]", "[0, 90, 0]") + "," +
      primitive("quad", "[0, 2, 0]", "[2, 4, 2]", "[0, 0, -180]") + "," +
      primitive("quad", "[0, 1, -1]", "[2, 4, 2]", "[0, 90, 90]") + "," +
      primitive("quad", "[1, 1, 0]", "[2, 4, 2]", "[0, 180, 90]") + "," +
      primitive("quad", "[-1, 1, 0]", "[2, 4, 2]", "[0, 0, 90]") + "," +
      primitive("cube", "[0.328631, 0.3, 0.374592]", "[0.594811, 0.604394, 0.6]",
                "[90, 90, -163.36]") +
      "," +
      primitive("cube", "[-0.335439, 0.6, -0.291415]", "[0.607289, 0.597739, 1.2]",
                "[90, 180, 160.812]") +
      "," + primitive("quad", "[-0.005, 1.98, -0.03]", "[0.47, 0.1786, 0.38]", "[0, 180, 180]");
  const desc::SceneDesc ours = scene_of(
      "", primitives,
      "{'fov': 19.5, 'resolution': 1024, 'transform': {'position': [0, 1, 6.8], 'look_at': "
      "[0, 1, 0], 'up': [0, 1, 0]}}");
  Warnings warnings;
  const desc::SceneDesc theirs = import_scene(file.string(), warnings);
  ASSERT_EQ(ours.shapes.size(), theirs.shapes.size());
  for (std::size_t i = 0; i < ours.shapes.size(); ++i) {
    const std::vector<Vec3> a = corners_of(ours.shapes[i]);
    const std::vector<Vec3> b = corners_of(theirs.shapes[i]);
    EXPECT_LT(std::max(farthest(a, b), farthest(b, a)), 2e-5F) << "shape " << i;
  }
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
    expect_near(moved(ours.camera.to_world, p), moved(theirs.camera.to_world, p));
  }
}

}  // namespace
}  // namespace ajar::tungsten
