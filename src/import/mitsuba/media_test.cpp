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

TEST(MitsubaMedia, WhatVariesBesideAConstantDensityIsItsMeanWithAWarning) {
  const Files files = {
      {"a.vol", grid_file(1, {2, 1, 1}, 3, floats({0, 0, 0.25F, 0.5F, 0.5F, 0.25F}))}};
  Warnings warnings;
  const desc::Medium medium =
      import_with(world(medium_of("<float name=\"sigma_t\" value=\"2\"/>" + grid_named("albedo"))),
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
