#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "import/tungsten/import_test_support.h"

/// Claims of docs/reference/formats-tungsten.md on members, one case for each.
namespace ajar::tungsten {
namespace {

struct PageCase {
  std::string scene;    ///< with ' in place of "
  std::string warning;  ///< a part of the only one; empty: there is none
};

void expect_as_the_page_says(const std::vector<PageCase>& cases) {
  const Files files = {{"m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
                       {"none.bin", std::string(32, '\0')}};
  for (const PageCase& page_case : cases) {
    std::string scene = page_case.scene;
    std::replace(scene.begin(), scene.end(), '\'', '"');
    const std::string warnings = warnings_of(scene, files);
    EXPECT_EQ(std::count(warnings.begin(), warnings.end(), '\n'), page_case.warning.empty() ? 0 : 1)
        << scene << "\n"
        << warnings;
    EXPECT_TRUE(contains(warnings, page_case.warning)) << scene << "\n" << warnings;
  }
}

/// A scene of one primitive.
std::string with_primitive(const std::string& members) {
  return "{'camera': {}, 'primitives': [{" + members + "}]}";
}
std::string with_bsdf(const std::string& members) {
  return with_primitive("'type': 'sphere', 'bsdf': {" + members + "}");
}
std::string with_medium(const std::string& members) {
  return with_primitive("'type': 'sphere', 'int_medium': {" + members + "}");
}
std::string with_camera(const std::string& members) {
  return "{'camera': {" + members + "}, 'primitives': [{'type': 'quad'}]}";
}

TEST(TungstenPage, DescribesPrimitives) {
  expect_as_the_page_says(
      {{with_primitive("'type': 'disk', 'cone_angle': 30"),
        ":1:31#/primitives/0: \"cone_angle\" is not supported: the disk shines in all directions"},
       {with_primitive("'type': 'disk', 'cone_angle': 90"), ""},
       {with_primitive("'type': 'mesh', 'file': 'm.obj', 'backface_culling': true"),
        ":1:31#/primitives/0: \"backface_culling\" is not supported: the mesh is seen from behind, "
        "too"},
       {with_primitive("'type': 'mesh', 'file': 'm.obj', 'backface_culling': false"), ""},
       {with_primitive("'type': 'mesh', 'file': 'm.obj', 'smooth': true, "
                       "'recompute_normals': true"),
        ""},
       {with_primitive("'type': 'quad', 'bump': 'a.png'"), "bumps of primitives are not supported"},
       {with_primitive("'type': 'instances', 'masters': [{'type': 'cube'}, {'type': 'quad', "
                       "'emission': 1}], 'instances': [{'id': 0}]"),
        "what is copied cannot be a light"},
       {with_primitive("'type': 'instances', 'masters': [{'type': 'cube'}], 'emission': 2, "
                       "'instances': [{'id': 0}]"),
        ":1:96#/primitives/0/emission: instances cannot shine: their own emission is left out, and "
        "no even light"},
       {with_primitive("'type': 'instances', 'masters': [{'type': 'cube'}], 'emission': 0, "
                       "'instances': [{'id': 0}]"),
        ""},
       {"{'camera': {}, 'primitives': [{'type': 'quad'}, {'type': 'instances', 'masters': "
        "[{'type': 'cube'}], 'instancesA': 'none.bin', 'instancesB': 'none.bin', 'ratio': 0.5}]}",
        "instances between two files are not supported: the first file counts"}});
}

TEST(TungstenPage, DescribesSkies) {
  const std::string sky = "'type': 'skydome', ";
  EXPECT_TRUE(contains(
      warnings_of(scene_text("", "{" + sky + "'temperature': 4000}")),
      "test.json:3:16#/primitives/0: \"temperature\" is not supported: the sky is that of our "
      "sun"));
  for (const char* of_no_effect : {"'temperature': 5777", "'gamma_scale': 3", "'sample': false"}) {
    Warnings warnings;
    import_with(scene_text("", "{" + sky + of_no_effect + "}, {'type': 'quad'}"), warnings);
    EXPECT_EQ(warnings.count(), 1U) << of_no_effect << "\n" << lines_of(warnings);
  }
}

TEST(TungstenPage, DescribesReplacementsOfBsdfs) {
  expect_as_the_page_says(
      {{with_bsdf("'type': 'lambert', 'bump': 'a.png'"),
        "the height of \"bump\" depends on the number of its pixels: taken as it is"},
       {with_bsdf("'type': 'lambert', 'bump': 0.5"), ""},
       {with_bsdf("'type': 'lambertian_fiber', 'albedo': 0.5"),
        "bsdfs of fibers are not supported: a diffuse one stands in"},
       {with_bsdf("'type': 'rough_wire', 'material': 'Au', 'roughness': 0.1"),
        "bsdfs of fibers are not supported: a diffuse one stands in"},
       {with_bsdf("'type': 'thinsheet', 'enable_interference': true"),
        "interference of thin sheets is not supported: left out"},
       {with_bsdf("'type': 'thinsheet', 'enable_interference': false"), ""}});
}

TEST(TungstenPage, DescribesMedia) {
  expect_as_the_page_says(
      {{with_medium("'type': 'atmosphere', 'density': 2, 'sigma_a': 1, 'radius': 3, "
                    "'falloff_scale': 2, 'center': [0, 0, 0]"),
        "media of type \"atmosphere\" are not supported: a homogeneous one of its \"density\""},
       {with_medium("'type': 'exponential', 'unit_point': [0, 0, 0], 'falloff_direction': "
                    "[0, 1, 0]"),
        "media of type \"exponential\" are not supported: a homogeneous one of its \"density\""},
       {with_medium("'type': 'homogeneous', 'transmittance': {'type': 'exponential'}"), ""},
       {with_medium("'type': 'homogeneous', 'transmittance': {'type': 'linear', 'max_t': 2}"),
        "only exponential transmittance is supported: it stands in"},
       {with_medium("'type': 'homogeneous', 'transmittance': {'type': 'linaer'}"),
        "unknown transmittance \"linaer\"; did you mean \"linear\"?"}});
  std::string text = with_medium("'type': 'exponential', 'density': 2, 'sigma_a': 3");
  std::replace(text.begin(), text.end(), '\'', '"');
  Warnings warnings;
  EXPECT_EQ(import_with(text, warnings).media.at(0).sigma_a, Vec3(6.F));
}

TEST(TungstenPage, DescribesCameras) {
  expect_as_the_page_says(
      {{with_camera("'reconstruction_filter': 'dirac'"),
        "the filter \"dirac\" is not supported: \"box\" stands in"},
       {with_camera("'type': 'thinlens', 'aperture': {'type': 'blade', 'blades': 6, 'angle': 1}"),
        "only round lenses are supported"},
       {with_camera("'type': 'thinlens', 'aperture': {'type': 'disk', 'value': 2}"), ""}});
}

}  // namespace
}  // namespace ajar::tungsten
