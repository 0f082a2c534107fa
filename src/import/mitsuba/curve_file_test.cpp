#include "import/mitsuba/curve_file.h"

#include <limits>

#include "import/mitsuba/import_test_support.h"

namespace ajar::mitsuba {
namespace {

std::string bytes_of(const std::vector<float>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(float)};
}
std::string curve_error_in(const std::string& bytes, bool has_radii = false) {
  try {
    read_curve_file(bytes, "h.txt", has_radii);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

const std::string kHair = "0 0 0\n1 0 0\n1 1 0\n\n\n5 0 0 # skipped\n6 0 0\n";

TEST(MitsubaCurves, OfHairAreStraightBetweenTheirPoints) {
  const float mark = std::numeric_limits<float>::infinity();
  const std::string binary = std::string("BINARY_HAIR\5\0\0\0", 15) +
                             bytes_of({0, 0, 0, 1, 0, 0, 1, 1, 0, mark, 5, 0, 0, 6, 0, 0});
  for (const std::string& file : {kHair, binary}) {
    const CurveFile curves = read_curve_file(file, "h.txt", false);
    ASSERT_EQ(curves.size(), 2U);
    EXPECT_EQ(curves[0].size(), 3U);
    EXPECT_EQ(curves[1][1].place, Vec3(6, 0, 0));
    const desc::Curves segments = curves_of(curves, CurveKind::Corners);
    ASSERT_EQ(segments.control_points.size(), 12U);
    EXPECT_LT(length(segments.control_points[5] - Vec3(1, 1.F / 3, 0)), 1e-6F);
  }
}

TEST(MitsubaCurves, OfHairBeginAnewAtARemark) {
  const CurveFile curves =
      read_curve_file("0 0 0\n1 0 0\n# second\n2 0 0\n3 0 0\n", "h.txt", false);
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[1][0].place, Vec3(2, 0, 0));
  EXPECT_EQ(curve_error_in("# none\n", true), "h.txt:1:1: this is no finite number: \"#\"");
}

TEST(MitsubaCurves, OfSplinesHaveRadii) {
  const CurveFile file =
      read_curve_file("0 0 0 1\n3 0 0 1\n6 0 0 4\n9 0 0 1\n12 0 0 1\n", "c.txt", true);
  const desc::Curves curves = curves_of(file, CurveKind::CubicSpline);
  ASSERT_EQ(curves.control_points.size(), 8U) << "two segments";
  // A uniform spline is at (p0 + 4 p1 + p2) / 6 between its segments.
  EXPECT_LT(length(curves.control_points[0] - Vec3(3, 0, 0)), 1e-5F);
  EXPECT_LT(length(curves.control_points[4] - Vec3(6, 0, 0)), 1e-5F);
  EXPECT_NEAR(curves.widths[0], 2.F * (1 + 4 + 4) / 6, 1e-5F);
  EXPECT_NEAR(curves.widths[4], 2.F * (1 + 16 + 1) / 6, 1e-5F);
}

TEST(MitsubaCurves, DamagedFilesAreErrorsWithTheirPlace) {
  EXPECT_EQ(curve_error_in("0 0 0\n0 0 x\n"), "h.txt:2:5: this is no finite number: \"x\"");
  EXPECT_EQ(curve_error_in("0 0 0\n", true), "h.txt:1:6: here a number is missing");
  EXPECT_EQ(curve_error_in("inf 0 0\n"), "h.txt:1:1: this is no finite number: \"inf\"");
  EXPECT_TRUE(contains(curve_error_in("BINARY_HAIR"), "the file ends too early"));
  EXPECT_TRUE(
      contains(curve_error_in(std::string("BINARY_HAIR\xff\xff\xff\xff", 15)), "too early"));
  EXPECT_EQ(curve_error_in(kHair), "no error");
}

TEST(MitsubaCurves, OfHairGrowAsZDoesAndSplinesDoNot) {
  const Files files = {{"h.txt", kHair}, {"c.txt", "0 0 0 1\n3 0 0 1\n"}};
  const auto width = [&](const std::string& type, const std::string& file,
                         const std::string& scale) {
    return scene_of("<shape type=\"" + type + "\"><string name=\"filename\" value=\"" + file +
                        "\"/><transform name=\"to_world\"><scale " + scale +
                        "/></transform></shape>",
                    files)
        .shapes[0]
        .node.curves("curves")
        ->widths[0];
  };
  // Widths in the shape's space grow by the cube root of the volume, 2.
  EXPECT_FLOAT_EQ(width("hair", "h.txt", "z=\"8\""), 2.F * 0.025F * 8.F / 2.F);
  EXPECT_FLOAT_EQ(width("hair", "h.txt", "x=\"8\""), 2.F * 0.025F / 2.F);
  EXPECT_FLOAT_EQ(width("linearcurve", "c.txt", "z=\"8\""), 2.F / 2.F);
}

TEST(MitsubaCurves, OfShapesMoveWithThem) {
  const Files files = {{"h.txt", kHair}};
  const std::string hair = "<shape type=\"hair\"><string name=\"filename\" value=\"h.txt\"/>";
  const desc::SceneDesc scene =
      scene_of(hair +
                   "<float name=\"radius\" value=\"0.5\"/><transform name=\"to_world\">"
                   "<scale value=\"4\"/></transform></shape>",
               files);
  EXPECT_EQ(scene.shapes[0].node.text("type"), "cylinder");
  EXPECT_FLOAT_EQ(scene.shapes[0].node.curves("curves")->widths[0], 1.F);
  expect_near(transform_point(scene.shapes[0].to_world, {1, 0, 0}), {4, 0, 0});
  const std::string warnings = warnings_of(
      hair + "<float name=\"reduction\" value=\"0.5\"/><emitter type=\"area\"/></shape>" +
          "<shape type=\"bsplinecurve\"><string name=\"filename\" value=\"h.txt\"/></shape>",
      files);
  EXPECT_TRUE(contains(warnings, "\"reduction\" is not supported")) << warnings;
  EXPECT_TRUE(contains(warnings, "curves cannot shine")) << warnings;
  EXPECT_TRUE(contains(warnings, "cannot use these curves: h.txt:1:6: here a number is missing"))
      << warnings;
}

}  // namespace
}  // namespace ajar::mitsuba
