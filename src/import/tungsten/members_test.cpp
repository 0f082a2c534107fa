#include <gtest/gtest.h>

#include "import/tungsten/bsdf_models.h"
#include "import/tungsten/import_test_support.h"

namespace ajar::tungsten {
namespace {

/// Warnings of a scene in which `object`, which stands where `$` is, has `members`.
std::size_t warnings_with(std::string scene, const std::string& object,
                          const std::string& members) {
  const std::size_t place = scene.find('$');
  scene.replace(place, 1, object.substr(0, object.size() - 1) + members + "}");
  for (char& c : scene) c = c == '\'' ? '"' : c;
  Warnings warnings;
  import_with(scene, warnings, {{"m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}});
  return warnings.count();
}

/// A member that nothing has is one warning more.
void expect_one_more(const std::string& scene, const std::string& object) {
  EXPECT_EQ(warnings_with(scene, object, ", 'bogus': 1"), warnings_with(scene, object, "") + 1)
      << object;
}

std::vector<std::string> objects_of(const std::vector<std::string>& types,
                                    const std::string& members = "") {
  std::vector<std::string> objects;
  objects.reserve(types.size());
  for (const std::string& type : types) {
    std::string& object = objects.emplace_back("{'type': '");
    object.append(type).append("'").append(members).append("}");
  }
  return objects;
}

TEST(TungstenMembers, UnknownOnesOfBsdfsAreWarnings) {
  const std::string scene = "{'camera': {}, 'primitives': [{'type': 'quad', 'bsdf': $}]}";
  for (const std::string& object : objects_of(bsdf_types())) expect_one_more(scene, object);
  const std::string part =
      "{'camera': {}, 'primitives': [{'type': 'quad', 'bsdf': {'type': 'mixed', 'bsdf0': $, "
      "'bsdf1': {'type': 'null'}}}]}";
  for (const std::string& object : objects_of(bsdf_types())) expect_one_more(part, object);
}

TEST(TungstenMembers, UnknownOnesOfPrimitivesAreWarnings) {
  const std::vector<std::string> types = {
      "mesh",         "cube",      "sphere",          "quad",
      "disk",         "curves",    "point",           "skydome",
      "cylinder",     "instances", "infinite_sphere", "infinite_sphere_cap",
      "minecraft_map"};
  const std::string scene = "{'camera': {}, 'primitives': [$]}";
  for (const std::string& object : objects_of(types, ", 'emission': 1")) {
    expect_one_more(scene, object);
  }
  expect_one_more(scene, "{'type': 'mesh', 'file': 'm.obj'}");
  expect_one_more("{'camera': {}, 'primitives': [{'type': 'quad', 'transform': $}]}",
                  "{'scale': 1}");
  const std::string copies = "{'camera': {}, 'primitives': [{'type': 'instances', 'masters': [";
  for (const std::string& object : objects_of(types)) {
    expect_one_more(copies + "$], 'instances': []}]}", object);
  }
  expect_one_more(copies + "{'type': 'cube'}], 'instances': [$]}]}", "{'id': 0}");
}

TEST(TungstenMembers, UnknownOnesOfTexturesAreWarnings) {
  const std::vector<std::string> textures =
      objects_of({"constant", "bitmap", "checker", "disk", "blade", "ies", "wireframe"});
  for (const std::string& object : textures) {
    expect_one_more(
        "{'camera': {}, 'primitives': [{'type': 'quad', 'bsdf': {'type': 'lambert', 'albedo': "
        "$}}]}",
        object);
    expect_one_more("{'primitives': [], 'camera': {'type': 'thinlens', 'aperture': $}}", object);
  }
}

TEST(TungstenMembers, UnknownOnesOfMediaAreWarnings) {
  const std::string scene = "{'camera': {'medium': $}}";
  for (const std::string& object :
       objects_of({"homogeneous", "atmosphere", "exponential", "voxel"})) {
    expect_one_more(scene, object);
  }
  expect_one_more("{'camera': {'medium': {'type': 'voxel', 'grid': $}}}", "{'type': 'vdb'}");
  for (const std::string& object : objects_of({"isotropic", "henyey_greenstein", "rayleigh"})) {
    expect_one_more("{'camera': {'medium': {'type': 'homogeneous', 'phase_function': $}}}", object);
  }
  for (const std::string& object :
       objects_of({"exponential", "double_exponential", "quadratic", "linear", "erlang", "davis",
                   "davis_weinstein", "pulse", "interpolated"})) {
    expect_one_more("{'camera': {'medium': {'type': 'homogeneous', 'transmittance': $}}}", object);
    expect_one_more(
        "{'camera': {'medium': {'type': 'homogeneous', 'transmittance': {'type': 'interpolated', "
        "'tr_b': $}}}}",
        object);
  }
}

TEST(TungstenMembers, UnknownOnesOfCamerasAndSettingsAreWarnings) {
  for (const std::string& object :
       objects_of({"pinhole", "thinlens", "equirectangular", "cubemap"})) {
    expect_one_more("{'camera': $}", object);
  }
  expect_one_more("$", "{'camera': {}}");
  expect_one_more("{'camera': {}, 'integrator': $}", "{'type': 'path_tracer'}");
  expect_one_more("{'camera': {}, 'renderer': $}", "{'spp': 1}");
}

}  // namespace
}  // namespace ajar::tungsten
