#include <cstring>
#include <limits>

#include "import/mitsuba/import_test_support.h"

namespace ajar::mitsuba {
namespace {

template <typename T>
std::string bytes_of(std::initializer_list<T> numbers) {
  std::string bytes;
  for (const T& number : numbers) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof(T));
  }
  return bytes;
}

/// A `.vol` file between (0, 0, 0) and (4, 1, 1).
std::string grid_file(std::int32_t encoding, desc::Vec3i size, std::int32_t channels,
                      const std::string& data) {
  return "VOL\x03" + bytes_of<std::int32_t>({encoding, size.x, size.y, size.z, channels}) +
         bytes_of<float>({0, 0, 0, 4, 1, 1}) + data;
}

std::string floats(std::initializer_list<float> values) { return bytes_of<float>(values); }

const std::string kTwoByTwo = grid_file(1, {2, 2, 2}, 1, floats({0, 1, 2, 3, 4, 5, 6, 7}));

std::string medium_of(const std::string& parts) {
  return "<shape type=\"cube\"><medium type=\"heterogeneous\" name=\"interior\">" + parts +
         "</medium></shape>";
}

std::string grid_named(const std::string& name, const std::string& more = "") {
  return "<volume type=\"gridvolume\" name=\"" + name +
         "\"><string name=\"filename\" value=\"a.vol\"/>" + more + "</volume>";
}

desc::Medium imported(const std::string& version, const std::string& parts,
                      const std::string& file) {
  const Files files = {{"a.vol", file}};
  Warnings warnings;
  const desc::SceneDesc scene =
      import_with("<scene version=\"" + version + "\">" + medium_of(parts) +
                      "<sensor type=\"perspective\"/></scene>",
                  warnings, files);
  expect_none(warnings);
  return scene.media.at(0);
}

/// All warnings of a medium of Mitsuba 3 with `file` as its density.
std::string remarks(const std::string& file, const std::string& parts = grid_named("sigma_t")) {
  return warnings_of(medium_of(parts), {{"a.vol", file}});
}

TEST(MitsubaMedia, GridsOfVersion0HaveTheirCornersWhereTheFileSays) {
  const desc::Medium medium = imported(
      "0.6.0",
      grid_named("density", "<transform name=\"toWorld\"><translate x=\"10\"/></transform>") +
          "<volume name=\"albedo\" type=\"constvolume\"><spectrum name=\"value\" value=\"0.9\"/>"
          "</volume><float name=\"scale\" value=\"100\"/><string name=\"method\" "
          "value=\"woodcock\"/>",
      kTwoByTwo);
  ASSERT_TRUE(medium.density);
  const desc::DensityGrid& grid = *medium.density->grid;
  EXPECT_EQ(grid.values, (std::vector<float>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(grid.points, desc::DensityGrid::Points::Corners);
  expect_near(transform_point(medium.density->to_world, {0, 0, 0}), {10, 0, 0});
  expect_near(transform_point(medium.density->to_world, {1, 1, 1}), {14, 1, 1});
  expect_near(medium.sigma_s, Vec3(90.F));
  expect_near(medium.sigma_a, Vec3(10.F), 1e-4F);
}

/// Its bounds are those of the volume: Mitsuba 3.9 shows a sphere of 1.5 with such a medium in one
/// of its eight parts alone.
TEST(MitsubaMedia, ConstantHeterogeneousOnesFillACubeSinceVersion2) {
  const std::string half = "<float name=\"value\" value=\"0.5\"/>";
  const auto volume = [](const std::string& content) {
    return "<volume name=\"sigma_t\" type=\"constvolume\">" + content + "</volume>";
  };
  for (const std::string& parts :
       {volume(half), std::string("<float name=\"sigma_t\" value=\"0.5\"/>")}) {
    const desc::Medium medium =
        imported("3.0.0", parts + "<float name=\"albedo\" value=\"0.25\"/>", "");
    ASSERT_TRUE(medium.density) << parts;
    EXPECT_EQ(medium.density->grid->values, std::vector<float>{1.F});
    expect_near(transform_point(medium.density->to_world, {1, 1, 1}), {1, 1, 1});
    expect_near(medium.sigma_s, Vec3(0.125F));
    expect_near(medium.sigma_a, Vec3(0.375F));
  }
  const desc::Medium moved =
      imported("2.0.0",
               volume(half + "<transform name=\"to_world\"><scale value=\"3\"/><translate "
                             "x=\"1\"/></transform>"),
               "");
  expect_near(transform_point(moved.density->to_world, {1, 1, 1}), {4, 3, 3});
  EXPECT_FALSE(
      imported("0.6.0", "<volume name=\"density\" type=\"constvolume\">" + half + "</volume>", "")
          .density);
  // An albedo that varies in it is looked up at points of its own.
  const desc::Medium varied = imported("3.0.0", volume(half) + grid_named("albedo"),
                                       grid_file(1, {2, 1, 1}, 1, floats({0, 1})));
  ASSERT_TRUE(varied.density && varied.density->grid->is_colored());
  EXPECT_EQ(varied.density->grid->scattering,
            (std::vector<desc::Rgb>{desc::Rgb(0.F), desc::Rgb(0.5F)}));
}

TEST(MitsubaMedia, ScenesOfVersion0PlaceGridsInABoxOfTheirOwn) {
  const desc::Medium medium =
      imported("0.5.0",
               grid_named("density",
                          "<point name=\"min\" x=\"-1\" y=\"-1\" z=\"-1\"/><point name=\"max\" "
                          "x=\"1\" y=\"1\" z=\"1\"/><boolean name=\"sendData\" value=\"true\"/>"),
               kTwoByTwo);
  expect_near(transform_point(medium.density->to_world, {0, 0, 0}), {-1, -1, -1});
  expect_near(transform_point(medium.density->to_world, {1, 1, 1}), {1, 1, 1});
}

TEST(MitsubaMedia, GridsOfLaterVersionsFillTheUnitCubeAndClamp) {
  const std::string albedo = "<rgb name=\"albedo\" value=\"0.5\"/>";
  const desc::Medium medium = imported("3.0.0", grid_named("sigma_t") + albedo, kTwoByTwo);
  EXPECT_EQ(medium.density->grid->points, desc::DensityGrid::Points::Centers);
  EXPECT_EQ(medium.density->grid->border, desc::DensityGrid::Border::Clamp);
  expect_near(transform_point(medium.density->to_world, {1, 1, 1}), {1, 1, 1});
  const desc::Medium placed =
      imported("3.0.0",
               grid_named("sigma_t",
                          "<boolean name=\"use_grid_bbox\" value=\"true\"/><transform "
                          "name=\"to_world\"><scale value=\"2\"/></transform>") +
                   albedo,
               kTwoByTwo);
  expect_near(transform_point(placed.density->to_world, {1, 1, 1}), {8, 2, 2});
}

TEST(MitsubaMedia, BytesAreFractionsOf255) {
  const desc::Medium medium = imported("3.0.0", grid_named("sigma_t"),
                                       grid_file(3, {1, 1, 2}, 1, std::string("\x00\xff", 2)));
  EXPECT_EQ(medium.density->grid->values, (std::vector<float>{0, 1}));
  EXPECT_EQ(medium.density->grid->resolution, desc::Vec3i(1, 1, 2));
}

TEST(MitsubaMedia, ColorsOfGridsVary) {
  const std::string colors = grid_file(1, {2, 1, 1}, 3, floats({0, 0, 0.25F, 0, 0.5F, 0.25F}));
  const std::string scale = "<float name=\"scale\" value=\"3\"/>";
  for (const char* version : {"0.6.0", "3.0.0"}) {
    // Version 0 has grids with points at corners: none of one point.
    const bool is_0 = version[0] == '0';
    const std::string file =
        is_0 ? grid_file(1, {2, 2, 2}, 3,
                         floats({0, 0, 0.25F, 0, 0.5F, 0.25F, 0, 0, 0.25F, 0, 0.5F, 0.25F,
                                 0, 0, 0.25F, 0, 0.5F, 0.25F, 0, 0, 0.25F, 0, 0.5F, 0.25F}))
             : colors;
    const desc::Medium medium = imported(
        version, grid_named(is_0 ? "density" : "sigma_t") + grid_named("albedo") + scale, file);
    const desc::DensityGrid& grid = *medium.density->grid;
    EXPECT_TRUE(grid.values.empty());
    EXPECT_EQ(grid.border, desc::DensityGrid::Border::Clamp);
    expect_near(medium.sigma_a, Vec3(3.F));
    expect_near(medium.sigma_s, Vec3(3.F));
    expect_near(grid.scattering.at(0), {0, 0, 0.0625F});
    expect_near(grid.scattering.at(1), {0, 0.25F, 0.0625F});
    expect_near(grid.absorption.at(0), {0, 0, 0.1875F});
    expect_near(grid.absorption.at(1), {0, 0.25F, 0.1875F});
  }
  const desc::Medium of_constant_albedo =
      imported("3.0.0", grid_named("sigma_t") + "<rgb name=\"albedo\" value=\"0.5 0 1\"/>", colors);
  expect_near(of_constant_albedo.density->grid->scattering.at(1), {0, 0, 0.25F});
  expect_near(of_constant_albedo.density->grid->absorption.at(1), {0, 0.5F, 0});
}

TEST(MitsubaMedia, AlbedosOfAnotherGridAreLookedUpAtThePointsOfTheDensity) {
  const std::string albedo =
      "<volume type=\"gridvolume\" name=\"albedo\"><string name=\"filename\" value=\"b.vol\"/>"
      "<transform name=\"to_world\"><translate x=\"0.25\"/></transform></volume>";
  const Files files = {
      {"a.vol", grid_file(1, {4, 1, 1}, 1, floats({1, 1, 1, 2}))},
      {"b.vol", grid_file(1, {2, 1, 1}, 3, floats({0.25F, 0, 0, 0.75F, 1, 0.5F}))}};
  Warnings warnings;
  const desc::Medium medium =
      import_with(world(medium_of(grid_named("sigma_t") + albedo)), warnings, files).media.at(0);
  // Points of the density are at 1/8, 3/8 …; those of the albedo at 1/2 and 1.
  const std::vector<Vec3>& scattering = medium.density->grid->scattering;
  expect_near(scattering.at(0), {0.25F, 0, 0});
  expect_near(scattering.at(1), {0.25F, 0, 0});
  expect_near(scattering.at(2), {0.375F, 0.25F, 0.125F});
  expect_near(scattering.at(3), {1.25F, 1.5F, 0.75F});
  const std::string text = lines_of(warnings);
  EXPECT_TRUE(contains(text, "test.xml:2:") && contains(text, "in another grid")) << text;
}

TEST(MitsubaMedia, VaryingAlbedoOfAConstantDensityIsItsMeanWithAWarning) {
  const Files files = {
      {"a.vol", grid_file(1, {2, 1, 1}, 3, floats({0, 0, 0.25F, 0.5F, 0.5F, 0.25F}))}};
  Warnings warnings;
  const desc::Medium medium =
      import_with(world("<shape type=\"cube\"><medium type=\"homogeneous\" name=\"interior\">"
                        "<float name=\"sigma_t\" value=\"2\"/>" +
                        grid_named("albedo") + "</medium></shape>"),
                  warnings, files)
          .media.at(0);
  EXPECT_FALSE(medium.density);
  expect_near(medium.sigma_s, {0.5F, 0.5F, 0.5F});
  expect_near(medium.sigma_a, {1.5F, 1.5F, 1.5F});
  const std::string text = lines_of(warnings);
  EXPECT_TRUE(contains(text, "test.xml:2:") && contains(text, "the mean of the grid")) << text;
  const std::string two = remarks(grid_file(1, {1, 1, 1}, 2, floats({0, 1})));
  EXPECT_TRUE(contains(two, "grids of 2 channels are not supported")) << two;
}

TEST(MitsubaMedia, GridsThatCannotBeReadCountAsEmpty) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::int32_t huge = std::numeric_limits<std::int32_t>::max();
  const auto expect_remark = [](const std::string& file, const std::string& reason) {
    const std::string text = remarks(file);
    EXPECT_TRUE(contains(text, "test.xml:2:") && contains(text, reason)) << text;
  };
  expect_remark("", "this is no grid of a volume");
  expect_remark(std::string(100, 'x'), "this is no grid of a volume");
  expect_remark("VOL\x02" + std::string(100, 'x'), "only version 3");
  expect_remark(grid_file(2, {1, 1, 1}, 1, floats({1})), "encoding 2 is not supported");
  expect_remark(grid_file(1, {2, 1, 1}, 1, floats({1})), "damaged or ends early");
  expect_remark(grid_file(1, {huge, huge, huge}, 6, floats({1})), "damaged or ends early");
  expect_remark(grid_file(1, {1, -1, 1}, 1, floats({1})), "no cells");
  expect_remark(grid_file(1, {1, 1, 1}, huge, floats({1})), "channels");
  expect_remark(grid_file(1, {2, 1, 1}, 1, floats({nan, -1})), "2 densities of this medium");
  const std::string missing = warnings_of(medium_of(grid_named("sigma_t")));
  EXPECT_TRUE(contains(missing, "it counts as empty")) << missing;
}

desc::Medium homogeneous(const std::string& parts) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      "<scene version=\"0.6.0\"><shape type=\"cube\"><medium type=\"homogeneous\" "
      "name=\"interior\">" +
          parts + "</medium></shape><sensor type=\"perspective\"/></scene>",
      warnings);
  expect_none(warnings);
  return scene.media.at(0);
}

TEST(MitsubaMedia, PresetsOfVersion0AreAHundredTimesTheirSources) {
  const auto preset = [](const std::string& name) {
    return homogeneous("<string name=\"material\" value=\"" + name + "\"/>");
  };
  expect_near(preset("Apple").sigma_s, {229, 239, 197}, 1e-3F);
  expect_near(preset("apple").sigma_a, {0.3F, 0.34F, 4.6F});
  expect_near(preset("Chicken1").sigma_a, {0.15F, 7.7F, 19});
  expect_near(preset("Chicken2").sigma_a, {0.18F, 8.8F, 20});
  // 7.78262 (1 - 0.907) and so on: the reduced scattering, which is isotropic.
  expect_near(preset("Espresso").sigma_s, {72.378F, 84.557F, 102.47F}, 1e-2F);
  EXPECT_EQ(preset("Espresso").g, 0.F);
  expect_near(preset("Orange Juice Powder").sigma_a, preset("orange powder").sigma_a);
  expect_near(
      homogeneous(
          "<string name=\"material\" value=\"Apple\"/><float name=\"scale\" value=\"0.01\"/>")
          .sigma_s,
      {2.29F, 2.39F, 1.97F});
}

TEST(MitsubaMedia, DefaultOfVersion0IsSkin) {
  const Vec3 skin_s(74, 88, 101);
  const Vec3 skin_a(3.2F, 17, 48);
  expect_near(homogeneous("").sigma_s, skin_s, 1e-3F);
  expect_near(homogeneous("").sigma_a, skin_a, 1e-4F);
  const desc::Medium scattering = homogeneous("<rgb name=\"sigmaS\" value=\"1 2 3\"/>");
  expect_near(scattering.sigma_s, {1, 2, 3});
  expect_near(scattering.sigma_a, skin_a, 1e-4F);
  const desc::Medium absorbing = homogeneous("<rgb name=\"sigmaA\" value=\"1 2 3\"/>");
  expect_near(absorbing.sigma_s, skin_s, 1e-3F);
  const desc::Medium thin = homogeneous("<float name=\"sigmaT\" value=\"2\"/>");
  expect_near(thin.sigma_s, skin_s / (skin_s + skin_a) * 2.F, 1e-5F);
  const desc::Medium white = homogeneous("<float name=\"albedo\" value=\"1\"/>");
  expect_near(white.sigma_s, skin_s + skin_a, 1e-3F);
  const desc::Medium forward =
      homogeneous("<float name=\"sigmaS\" value=\"4\"/><float name=\"g\" value=\"0.25\"/>");
  expect_near(forward.sigma_s, Vec3(3.F));
  EXPECT_EQ(forward.g, 0.F);
}

TEST(MitsubaMedia, UnknownPresetsAreSkinWithAWarning) {
  const std::string medium =
      "<scene version=\"0.6.0\"><shape type=\"cube\"><medium type=\"homogeneous\" "
      "name=\"interior\"><string name=\"material\" value=\"skin3\"/></medium></shape><sensor "
      "type=\"perspective\"/></scene>";
  const std::string text = warnings_in([&](Warnings& remarks) { import_with(medium, remarks); });
  EXPECT_TRUE(contains(text, "unknown medium preset \"skin3\"")) << text;
  EXPECT_TRUE(contains(text, "Skin1 stands in")) << text;
}

TEST(MitsubaMedia, OtherVolumesAndLookupsAreWarnings) {
  const std::string other = remarks(kTwoByTwo, "<volume type=\"hgridvolume\" name=\"sigma_t\"/>");
  EXPECT_TRUE(contains(other, "unknown volume \"hgridvolume\"")) << other;
  const std::string nearest =
      remarks(kTwoByTwo, grid_named("sigma_t", "<string name=\"filter_type\" value=\"nearest\"/>"));
  EXPECT_TRUE(contains(nearest, "trilinear")) << nearest;
  const std::string misspelt =
      remarks(kTwoByTwo, grid_named("sigma_t", "<float name=\"filtre_type\" value=\"1\"/>"));
  EXPECT_TRUE(contains(misspelt, "did you mean \"filter_type\"")) << misspelt;
}

}  // namespace
}  // namespace ajar::mitsuba
