// Clouds of NanoVDB files, written by NanoVDB's own writer.
#include "import/pbrt/nanovdb_file.h"

#define NANOVDB_USE_ZIP
#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/IO.h>

#include <cstring>
#include <sstream>

#include "import/pbrt/v4_test_support.h"

namespace ajar {
namespace {

using nanovdb::io::Codec;
using Handle = nanovdb::GridHandle<>;

struct Voxel {
  nanovdb::Coord at;
  float density;
};

/// Voxels 0.5 wide, the one at (0, 0, 0) at (1, 2, 3).
template <typename Number = float>
Handle grid_of(const std::vector<Voxel>& voxels, const std::string& name = "density") {
  nanovdb::GridBuilder<Number> builder(Number(0));
  auto accessor = builder.getAccessor();
  for (const Voxel& voxel : voxels) accessor.setValue(voxel.at, Number(voxel.density));
  return builder.template getHandle<>(0.5, nanovdb::Vec3d(1, 2, 3), name,
                                      nanovdb::GridClass::FogVolume);
}

std::string file_of(std::vector<Handle> grids, Codec codec = Codec::NONE) {
  // The writer goes beyond the end before it writes, which a string must have room for.
  std::ostringstream stream(std::string(4096, '\0'), std::ios::binary);
  nanovdb::io::writeGrids(stream, grids, codec);
  return stream.str().substr(0, static_cast<std::size_t>(stream.tellp()));
}
std::string file_of(Handle grid, Codec codec = Codec::NONE) {
  std::vector<Handle> grids;
  grids.push_back(std::move(grid));
  return file_of(std::move(grids), codec);
}

std::string medium(const std::string& more = "") {
  return "MakeNamedMedium \"m\" \"string type\" \"nanovdb\" \"string filename\" \"a.nvdb\" " + more;
}

/// Warnings of the medium with this file.
std::string remarks(const std::string& file, const std::string& more = "") {
  return v4_warnings(medium(more), {{"a.nvdb", file}});
}

const std::vector<Voxel> kTwo = {{{-1, 0, 0}, 0.25F}, {{1, 0, 0}, 0.75F}};

TEST(NanoVdb, VoxelsArePointsUpToTheOneBehindTheLast) {
  for (const Codec codec : {Codec::NONE, Codec::ZIP}) {
    const Files files = {{"a.nvdb", file_of(grid_of(kTwo), codec)}};
    const desc::SceneDesc scene =
        v4_scene("Translate 10 0 0 " + medium("\"rgb sigma_a\" [1 2 3] \"float scale\" 2"), files);
    const desc::Density& density = *scene.media.at(0).density;
    EXPECT_EQ(density.grid->points, desc::DensityGrid::Points::Corners);
    EXPECT_EQ(density.grid->resolution, desc::Vec3i(4, 2, 2));
    const std::vector<float>& values = density.grid->values;
    EXPECT_EQ(std::vector<float>(values.begin(), values.begin() + 4),
              (std::vector<float>{0.25F, 0, 0.75F, 0}));
    EXPECT_EQ(std::count(values.begin() + 4, values.end(), 0.F), 12);
    expect_near(transform_point(density.to_world, {0, 0, 0}), {10.5F, 2, 3});
    expect_near(transform_point(density.to_world, {1, 1, 1}), {12, 2.5F, 3.5F});
    EXPECT_EQ(scene.media[0].sigma_a, desc::Rgb(2, 4, 6));
  }
}

TEST(NanoVdb, NodesOfAllLevelsAreFound) {
  // In leaves, lower, upper nodes and tiles of the root of their own.
  const std::vector<Voxel> far = {
      {{-3, 5, 7}, 1}, {{9, 5, 7}, 2}, {{150, 5, 7}, 3}, {{4100, 5, 7}, 4}, {{-4097, 5, 7}, 5}};
  const auto read = pbrt::read_nanovdb(file_of(grid_of(far)), "density", {});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->grid.resolution, desc::Vec3i(4100 + 4097 + 2, 2, 2));
  for (const Voxel& voxel : far) {
    EXPECT_EQ(read->grid.values[static_cast<std::size_t>(voxel.at[0] + 4097)], voxel.density);
  }
  EXPECT_EQ(std::count(read->grid.values.begin(), read->grid.values.end(), 0.F),
            static_cast<std::ptrdiff_t>(read->grid.values.size() - far.size()));
}

TEST(NanoVdb, TilesAreFilled) {
  nanovdb::GridBuilder<float> builder(0.F);
  builder([](const nanovdb::Coord&) { return 0.5F; },
          nanovdb::CoordBBox(nanovdb::Coord(0), nanovdb::Coord(31)));
  const auto read = pbrt::read_nanovdb(
      file_of(builder.getHandle<>(1.0, nanovdb::Vec3d(0), "density")), "density", {});
  EXPECT_EQ(read->grid.resolution, desc::Vec3i(33));
  EXPECT_EQ(std::count(read->grid.values.begin(), read->grid.values.end(), 0.5F), 32 * 32 * 32);
}

/// Four values of one leaf, to the steps that each type has between 0 and 0.75.
template <typename Number>
void expect_quantized(float step) {
  nanovdb::GridBuilder<float, Number> builder(0.F);
  auto accessor = builder.getAccessor();
  const std::vector<Voxel> voxels = {
      {{0, 0, 0}, 0.75F}, {{1, 0, 0}, 0.3F}, {{2, 0, 0}, 0.1F}, {{3, 0, 0}, 0.6F}};
  for (const Voxel& voxel : voxels) accessor.setValue(voxel.at, voxel.density);
  const auto read = pbrt::read_nanovdb(
      file_of(builder.template getHandle<>(1.0, nanovdb::Vec3d(0), "density")), "density", {});
  ASSERT_TRUE(read);
  ASSERT_EQ(read->grid.resolution, desc::Vec3i(5, 2, 2));
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    EXPECT_NEAR(read->grid.values[i], voxels[i].density, step) << i;
  }
}

TEST(NanoVdb, NumbersMayHaveFewBitsOrMany) {
  expect_quantized<nanovdb::Fp4>(0.75F / 15);
  expect_quantized<nanovdb::Fp8>(0.75F / 255);
  expect_quantized<nanovdb::Fp16>(0.75F / 65535);
  expect_quantized<nanovdb::FpN>(0.02F);
  const auto doubles = pbrt::read_nanovdb(file_of(grid_of<double>(kTwo)), "density", {});
  EXPECT_EQ(doubles->grid.values[2], 0.75F);
}

TEST(NanoVdb, TemperaturesAreNotSeenWithAWarning) {
  std::vector<Handle> grids;
  grids.push_back(grid_of(kTwo, "temperature"));
  grids.push_back(grid_of(kTwo));
  const std::string file = file_of(std::move(grids));
  EXPECT_TRUE(contains(remarks(file), "test.pbrt:2:1: media that emit light"));
  EXPECT_EQ(remarks(file, "\"float LeScale\" 0"), "");
}

TEST(NanoVdb, FilesThatCannotBeReadCountAsEmpty) {
  const auto expect_remark = [](const std::string& file, const std::string& reason) {
    const std::string text = remarks(file);
    EXPECT_TRUE(contains(text, "test.pbrt:2:1: the grid of this medium cannot be read (a.nvdb: ") &&
                contains(text, reason))
        << text;
  };
  expect_remark("", "damaged or ends early");
  expect_remark(std::string(1000, 'x'), "this is no NanoVDB file");
  expect_remark(file_of(grid_of<std::int32_t>({{{0, 0, 0}, 1}})),
                "type \"int32\" are not supported");
  expect_remark(file_of(grid_of({})), "no voxel of the grid is active");
  expect_remark(file_of(grid_of({{{-100000, 0, 0}, 1}, {{100000, 100000, 0}, 1}})),
                "voxels, which are more than");
  const std::string good = file_of(grid_of(kTwo));
  expect_remark(good.substr(0, good.size() - 1), "damaged or ends early");
  std::string blosc = good;
  blosc[14] = static_cast<char>(Codec::BLOSC);
  expect_remark(blosc, "Blosc is not supported");
  std::string old = good;
  old[11] = 1;
  expect_remark(old, "only version 32 of NanoVDB");
  EXPECT_TRUE(contains(remarks(file_of(grid_of(kTwo, "smoke"))), "no grid \"density\""));
  EXPECT_TRUE(contains(v4_warnings(medium()), "it counts as empty"));
}

TEST(NanoVdb, DamageIsFoundWhereverItIs) {
  const std::string good = file_of(grid_of(kTwo));
  // Every number of the file in turn; the table of a node is long and all the same.
  std::size_t refused = 0;
  for (std::size_t place = 0; place + 8 <= good.size(); place += place < 4096 ? 4 : 1004) {
    for (const std::uint64_t number :
         {~std::uint64_t{0}, std::uint64_t{1} << 40, std::uint64_t{32}}) {
      std::string bad = good;
      std::memcpy(bad.data() + place, &number, sizeof(number));
      try {
        pbrt::read_nanovdb(bad, "density", {}, 1 << 20);
      } catch (const Error&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 50U);
}

}  // namespace
}  // namespace ajar
