#include "import/tungsten/strands.h"

#include "import/tungsten/import_test_support.h"
#include "import/tungsten/wo3_test_support.h"

namespace ajar::tungsten {
namespace {

template <typename Value>
std::string bytes_of(const std::vector<Value>& values) {
  std::string bytes;
  for (const Value& value : values) append(bytes, value);
  return bytes;
}

/// An attribute of a `.fiber` file.
std::string attribute(const std::string& name, bool of_curves, int type, int lanes,
                      const std::string& values) {
  std::string bytes;
  append<std::uint64_t>(bytes, 20 + name.size() + 1);
  append<std::uint64_t>(bytes, values.size());
  append<std::uint16_t>(bytes, of_curves ? 1 : 0);
  append<std::uint8_t>(bytes, static_cast<std::uint8_t>(type));
  append<std::uint8_t>(bytes, static_cast<std::uint8_t>(lanes));
  return bytes + name + std::string(1, '\0') + values;
}
std::string fiber_of(std::uint64_t nodes, std::uint64_t curves, const std::string& attributes) {
  std::string bytes =
      "\x80\xBF\x80"
      "FIBER";
  append<std::uint16_t>(bytes, 1);
  append<std::uint16_t>(bytes, 0);
  append<std::uint32_t>(bytes, 0);
  append<std::uint64_t>(bytes, 40);
  append(bytes, nodes);
  append(bytes, curves);
  bytes += attributes;
  append<std::uint64_t>(bytes, 0);
  return bytes;
}

/// A curve of four nodes and one of three, along x, all of the radius 0.25.
const std::vector<float> kPlaces = {0, 0, 0, 2, 0, 0, 4, 0, 0, 6, 0, 0, 0, 5, 0, 3, 5, 0, 6, 5, 0};
std::string two_curves() {
  return fiber_of(7, 2,
                  attribute("num_vertices", true, 3, 1, bytes_of<std::uint16_t>({4, 3})) +
                      attribute("temperature", false, 9, 1, bytes_of<double>({1, 2, 3})) +
                      attribute("position", false, 8, 3, bytes_of(kPlaces)) +
                      attribute("width", false, 8, 1, bytes_of<float>({0.25F})));
}
std::string hair_of(std::uint32_t bits, const std::string& arrays) {
  std::string bytes = "HAIR";
  for (const std::uint32_t value : {2U, 7U, bits, 2U}) append(bytes, value);
  append(bytes, 0.125F);
  bytes.resize(128);
  return bytes + arrays;
}

std::string fiber_error_in(std::string_view bytes, const std::string& name = "a.fiber") {
  try {
    read_strands(bytes, name);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Strands, OfFiberFilesAreQuadraticSplines) {
  const Strands strands = read_strands(two_curves(), "a.fiber");
  EXPECT_EQ(strands.counts, (std::vector<std::uint32_t>{4, 3}));
  EXPECT_EQ(strands.radii, std::vector<float>(7, 0.25F)) << "the last value goes on";
  const desc::Curves curves = curves_of(strands, {});
  ASSERT_EQ(curves.control_points.size(), 12U) << "two segments and one";
  // Curves begin and end in the middle between two nodes, and have the speed of the polygon.
  for (std::size_t i = 0; i < 4; ++i) {
    const auto t = static_cast<float>(i) / 3.F;
    EXPECT_LT(length(curves.control_points[i] - Vec3(1.F + 2.F * t, 0, 0)), 1e-6F);
    EXPECT_LT(length(curves.control_points[8 + i] - Vec3(1.5F + 3.F * t, 5, 0)), 1e-6F);
    EXPECT_NEAR(curves.widths[i], 0.5F, 1e-6F) << "widths of files are radii";
  }
}

TEST(Strands, OfHairFilesMayHaveUsualValues) {
  const Strands usual = read_strands(hair_of(2, bytes_of(kPlaces)), "a.hair");
  EXPECT_EQ(usual.counts, (std::vector<std::uint32_t>{3, 3}));
  EXPECT_EQ(usual.radii[6], 0.125F);
  const Strands all = read_strands(hair_of(7, bytes_of<std::uint16_t>({3, 2}) + bytes_of(kPlaces) +
                                                  bytes_of<float>({1, 2, 3, 4, 5, 6, 7})),
                                   "a.hair");
  EXPECT_EQ(all.counts, (std::vector<std::uint32_t>{4, 3}));
  EXPECT_EQ(all.nodes[4], Vec3(0, 5, 0));
  EXPECT_EQ(all.radii[6], 7.F);
}

TEST(Strands, TaperToTheirEnd) {
  const desc::Curves curves =
      curves_of(read_strands(two_curves(), "a.fiber"), {.radius = 1.F, .tapers = true});
  // The second curve's nodes have 5/4, 3/4 and 1/4: it begins with their mean.
  EXPECT_NEAR(curves.widths[8], 2.F, 1e-6F);
  EXPECT_NEAR(curves.widths[11], 1.F, 1e-6F);
}

TEST(Strands, DamagedFilesAreErrors) {
  const std::string whole = two_curves();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(fiber_error_in(whole.substr(0, size)), "no error") << size;
  }
  const std::string hair = hair_of(2, bytes_of(kPlaces));
  for (std::size_t size = 0; size < hair.size(); ++size) {
    EXPECT_NE(fiber_error_in(hair.substr(0, size), "a.hair"), "no error") << size;
  }
  const std::string places = attribute("position", false, 8, 3, bytes_of(kPlaces));
  const std::string many = attribute("num_vertices", true, 3, 1, bytes_of<std::uint16_t>({4}));
  EXPECT_TRUE(contains(fiber_error_in(fiber_of(7, 2, places + many)),
                       "they have 8 nodes, but there are 7"));
  EXPECT_TRUE(
      contains(fiber_error_in(fiber_of(1ULL << 60U, 2, places)), "there are 7 positions of"));
  EXPECT_TRUE(contains(fiber_error_in(fiber_of(7, 1ULL << 60U, places)), "more curves than nodes"));
  std::string promising = hair;
  for (std::size_t i = 4; i < 12; ++i) promising[i] = '\xff';
  EXPECT_TRUE(contains(fiber_error_in(promising, "a.hair"), "the file ends too early"));
  EXPECT_TRUE(contains(fiber_error_in("HAIR", "a.obj"), "unknown kind of file of curves"));
}

TEST(Strands, OfPrimitivesAreTubesInTheirPlace) {
  const Files files = {{"a.fiber", two_curves()}};
  const desc::SceneDesc scene =
      scene_of("{'name': 'm', 'type': 'lambert'}",
               "{'type': 'curves', 'file': 'a.fiber', 'bsdf': 'm', 'curve_thickness': 0.5, "
               "'transform': {'position': [1, 2, 3]}},"
               "{'type': 'curves', 'file': 'a.fiber', 'bsdf': 'm', 'mode': 'bcsdf_cylinder'}",
               "{}", files);
  ASSERT_EQ(scene.shapes.size(), 2U);
  EXPECT_EQ(scene.shapes[0].node.text("type"), "cylinder");
  EXPECT_EQ(scene.shapes[0].node.curves("curves")->widths[0], 1.F);
  EXPECT_EQ(moved(scene.shapes[0].to_world, Vec3(0.F)), Vec3(1, 2, 3));
  EXPECT_EQ(scene.shapes[1].node.text("type"), "flat");
}

TEST(Strands, UnsupportedOptionsOfPrimitivesAreWarnings) {
  const Files files = {{"a.fiber", two_curves()}, {"b.fiber", "short"}};
  const std::string warnings = warnings_of(
      scene_text("",
                 "{'type': 'curves', 'file': 'a.fiber', 'mode': 'ribbon', 'subsample': 0.5, "
                 "'emission': 1},"
                 "{'type': 'curves', 'file': 'b.fiber'}"),
      files);
  for (const char* part : {"ribbons that turn at random", "\"subsample\" is not supported",
                           "test.json:3:102#/primitives/0/emission: curves cannot shine",
                           "curves without a \"bsdf\" are hair",
                           "cannot use these curves: b.fiber: these curves cannot be read"}) {
    EXPECT_TRUE(contains(warnings, part)) << part << "\n" << warnings;
  }
  EXPECT_TRUE(contains(error_of(scene_text("", "{'type': 'curves', 'mode': 'ribon'}")),
                       "did you mean \"ribbon\""));
}

}  // namespace
}  // namespace ajar::tungsten
