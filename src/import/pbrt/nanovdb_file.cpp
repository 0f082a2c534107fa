#include "import/pbrt/nanovdb_file.h"

#include <nanovdb/NanoVDB.h>
#include <nanovdb/util/IO.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <set>
#include <tuple>
#include <vector>

#include "core/printable_text.h"
#include "import/common/transforms.h"
#include "import/mesh/inflate.h"
#include "os/available_memory.h"

namespace ajar::pbrt {
namespace {

using Index = Imath::Vec3<std::int64_t>;

constexpr std::string_view kDamaged = "the file is damaged or ends early";

[[noreturn]] void fail(const SourceLocation& where, std::string_view message) {
  throw SceneError(where, std::string(message));
}

/// Reads values from the beginning of the rest of a file.
class Cursor {
 public:
  Cursor(std::string_view bytes, const SourceLocation& where) : bytes_(bytes), where_(where) {}
  bool is_at_end() const { return bytes_.empty(); }
  std::string_view take(std::uint64_t size) {
    if (size > bytes_.size()) fail(where_, kDamaged);
    const std::string_view taken = bytes_.substr(0, static_cast<std::size_t>(size));
    bytes_.remove_prefix(static_cast<std::size_t>(size));
    return taken;
  }
  template <typename T>
  T take() {
    T value;
    std::memcpy(static_cast<void*>(&value), take(sizeof(T)).data(), sizeof(T));
    return value;
  }

 private:
  std::string_view bytes_;
  const SourceLocation& where_;
};

/// A grid as it is in the file.
struct PackedGrid {
  nanovdb::io::MetaData meta{};
  nanovdb::io::Codec codec = nanovdb::io::Codec::NONE;
  std::string_view data;
};

/// The first grid of this name.
std::optional<PackedGrid> find_grid(std::string_view bytes, std::string_view grid_name,
                                    const SourceLocation& where) {
  Cursor file(bytes, where);
  if (file.is_at_end()) fail(where, kDamaged);
  while (!file.is_at_end()) {
    const auto header = file.take<nanovdb::io::Header>();
    if (header.magic != NANOVDB_MAGIC_NUMBER) fail(where, "this is no NanoVDB file");
    if (header.version.getMajor() != NANOVDB_MAJOR_VERSION_NUMBER) {
      fail(where, "only version " + std::to_string(NANOVDB_MAJOR_VERSION_NUMBER) +
                      " of NanoVDB can be read, not " + std::to_string(header.version.getMajor()));
    }
    std::vector<std::pair<std::string_view, nanovdb::io::MetaData>> grids;
    for (int i = 0; i < header.gridCount; ++i) {
      const auto meta = file.take<nanovdb::io::MetaData>();
      const std::string_view name = file.take(meta.nameSize);
      grids.emplace_back(name.substr(0, name.find('\0')), meta);
    }
    for (const auto& [name, meta] : grids) {
      const std::string_view data = file.take(meta.fileSize);
      if (name == grid_name) return PackedGrid{meta, header.codec, data};
    }
  }
  return std::nullopt;
}

/// Memory that is aligned as the structures of NanoVDB need it.
class AlignedBytes {
 public:
  explicit AlignedBytes(std::string_view bytes)
      : blocks_(bytes.size() / sizeof(Block) + 1), size_(bytes.size()) {
    std::copy_n(reinterpret_cast<const std::byte*>(bytes.data()), bytes.size(),
                reinterpret_cast<std::byte*>(blocks_.data()));
  }
  const std::byte* data() const { return reinterpret_cast<const std::byte*>(blocks_.data()); }
  std::uint64_t size() const { return size_; }

 private:
  struct alignas(NANOVDB_DATA_ALIGNMENT) Block {
    std::array<std::byte, NANOVDB_DATA_ALIGNMENT> bytes;
  };
  std::vector<Block> blocks_;
  std::uint64_t size_;
};

AlignedBytes unpack(const PackedGrid& packed, const SourceLocation& where) {
  using nanovdb::io::Codec;
  if (packed.codec == Codec::NONE) return AlignedBytes(packed.data);
  if (packed.codec != Codec::ZIP) {
    fail(where, packed.codec == Codec::BLOSC ? "compression by Blosc is not supported, only by zip"
                                             : kDamaged);
  }
  Cursor file(packed.data, where);
  const std::string_view stream = file.take(file.take<std::uint64_t>());
  const std::optional<std::string> bytes =
      inflate_stream(stream, StreamKind::Zlib, static_cast<std::size_t>(packed.meta.gridSize));
  if (!bytes || bytes->size() != packed.meta.gridSize) {
    fail(where, "the compressed data is damaged or ends early");
  }
  return AlignedBytes(*bytes);
}

/// Reads the tree of a grid. NanoVDB's own functions follow the offsets in a file wherever they
/// lead; here every one is checked before.
class TreeReader {
 public:
  TreeReader(const AlignedBytes& bytes, const SourceLocation& where, std::uint64_t most_voxels)
      : bytes_(bytes), where_(where), most_voxels_(most_voxels) {}

  VoxelGrid read() {
    const auto& grid = at<nanovdb::GridData>(0);
    if (grid.mMagic != NANOVDB_MAGIC_NUMBER) fail(where_, kDamaged);
    switch (grid.mGridType) {
      case nanovdb::GridType::Float:
        return read_tree<float>(grid);
      case nanovdb::GridType::Double:
        return read_tree<double>(grid);
      case nanovdb::GridType::Fp4:
        return read_tree<nanovdb::Fp4>(grid);
      case nanovdb::GridType::Fp8:
        return read_tree<nanovdb::Fp8>(grid);
      case nanovdb::GridType::Fp16:
        return read_tree<nanovdb::Fp16>(grid);
      case nanovdb::GridType::FpN:
        return read_tree<nanovdb::FpN>(grid);
      default:
        break;
    }
    fail(where_,
         std::string("grids of numbers of the type \"") +
             (grid.mGridType < nanovdb::GridType::End ? nanovdb::toStr(grid.mGridType) : "?") +
             "\" are not supported");
  }

 private:
  /// Object at an offset in the grid.
  template <typename T>
  const T& at(std::int64_t place) const {
    const auto size = static_cast<std::int64_t>(bytes_.size());
    if (place < 0 || place % static_cast<std::int64_t>(alignof(T)) != 0 ||
        place > size - static_cast<std::int64_t>(sizeof(T))) {
      fail(where_, kDamaged);
    }
    return *reinterpret_cast<const T*>(bytes_.data() + place);
  }
  template <typename Offset>
  std::int64_t behind(std::int64_t place, Offset offset) const {
    const auto distance = static_cast<std::int64_t>(offset);
    const auto size = static_cast<std::int64_t>(bytes_.size());
    if (distance < -size || distance > size) fail(where_, kDamaged);
    return place + distance;
  }

  /// `Number`: NanoVDB's type of the build, which is also that of leaves.
  template <typename Number>
  VoxelGrid read_tree(const nanovdb::GridData& grid) {
    using Root = nanovdb::NanoRoot<Number>;
    const std::int64_t tree_place = sizeof(nanovdb::GridData);
    const std::int64_t root_place =
        behind(tree_place, at<nanovdb::TreeData<3>>(tree_place).mNodeOffset[3]);
    const auto& root = at<typename Root::DataType>(root_place);
    set_box(root.mBBox);
    values_.assign(static_cast<std::size_t>(count_), static_cast<float>(root.mBackground));
    read_tiles<Root>(root_place, root.mTableSize);

    VoxelGrid result;
    result.grid.points = desc::DensityGrid::Points::Corners;
    result.grid.border = desc::DensityGrid::Border::Clamp;
    for (int i = 0; i < 3; ++i) result.grid.resolution[i] = static_cast<int>(high_[i] - low_[i]);
    result.grid.values = std::move(values_);
    const Index size = high_ - low_ - Index(1);
    result.to_world = scaling(Vec3d(size)) * translation(Vec3d(low_)) * matrix_of(grid.mMap);
    return result;
  }

  /// Points from the first active voxel to the one behind the last, which is where pbrt-v4's box
  /// ends.
  void set_box(const nanovdb::CoordBBox& active) {
    double count = 1;
    for (int i = 0; i < 3; ++i) {
      low_[i] = active.min()[i];
      high_[i] = std::int64_t{active.max()[i]} + 2;
      if (active.max()[i] < active.min()[i]) fail(where_, "no voxel of the grid is active");
      count *= static_cast<double>(high_[i] - low_[i]);
    }
    if (count > static_cast<double>(most_voxels_)) {
      fail(where_, "the grid has " + std::to_string(high_.x - low_.x) + " × " +
                       std::to_string(high_.y - low_.y) + " × " + std::to_string(high_.z - low_.z) +
                       " voxels, which are more than " + std::to_string(most_voxels_));
    }
    count_ = static_cast<std::uint64_t>(count);
    const std::string preparation_cut = memory_shortage(count_ * sizeof(float));
    if (!preparation_cut.empty()) fail(where_, "the grid " + preparation_cut);
  }

  template <typename Root>
  void read_tiles(std::int64_t root_place, std::uint32_t count) {
    using Data = typename Root::DataType;
    const std::int64_t first = root_place + static_cast<std::int64_t>(sizeof(Data));
    std::set<std::tuple<int, int, int>> places;
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto& tile = at<typename Data::Tile>(
          first + std::int64_t{i} * static_cast<std::int64_t>(sizeof(typename Data::Tile)));
      const nanovdb::Coord corner = Data::KeyToCoord(tile.key);
      // No file of use has two in one place, and work would have no bound.
      if (!places.emplace(corner[0], corner[1], corner[2]).second) fail(where_, kDamaged);
      const Index origin(corner[0], corner[1], corner[2]);
      if (tile.child == 0) {
        fill(origin, Root::ChildNodeType::DIM, static_cast<float>(tile.value));
      } else {
        read_node<typename Root::ChildNodeType>(behind(root_place, tile.child), origin);
      }
    }
  }

  /// The part of cubes along one axis, each `side` wide, that is in the box: [first, last).
  std::pair<std::int64_t, std::int64_t> overlap(int axis, std::int64_t origin, std::int64_t side,
                                                std::int64_t count) const {
    const std::int64_t before = std::max<std::int64_t>(low_[axis] - origin, 0);
    const std::int64_t until = std::max<std::int64_t>(high_[axis] - origin, 0);
    return {before / side, std::min(count, (until + side - 1) / side)};
  }
  template <typename Visit>
  void for_overlap(const Index& origin, std::int64_t side, std::int64_t count, const Visit& visit) {
    const auto [x0, x1] = overlap(0, origin.x, side, count);
    const auto [y0, y1] = overlap(1, origin.y, side, count);
    const auto [z0, z1] = overlap(2, origin.z, side, count);
    for (std::int64_t z = z0; z < z1; ++z) {
      for (std::int64_t y = y0; y < y1; ++y) {
        for (std::int64_t x = x0; x < x1; ++x) visit(Index(x, y, z));
      }
    }
  }

  template <typename Node>
  void read_node(std::int64_t place, const Index& origin) {
    using Child = typename Node::ChildNodeType;
    constexpr auto kLog = static_cast<int>(Node::LOG2DIM);
    constexpr auto kSide = static_cast<std::int64_t>(Child::DIM);
    const auto& node = at<typename Node::DataType>(place);
    for_overlap(origin, kSide, 1 << kLog, [&](const Index& i) {
      const auto n = static_cast<std::uint32_t>((i.x << (2 * kLog)) | (i.y << kLog) | i.z);
      const Index corner = origin + i * kSide;
      if (!node.mChildMask.isOn(n)) {
        fill(corner, kSide, static_cast<float>(node.mTable[n].value));
      } else if constexpr (Child::LEVEL == 0) {
        read_leaf<Child>(behind(place, node.mTable[n].child), corner);
      } else {
        read_node<Child>(behind(place, node.mTable[n].child), corner);
      }
    });
  }
  template <typename Leaf>
  void read_leaf(std::int64_t place, const Index& origin) {
    constexpr auto kLog = static_cast<int>(Leaf::LOG2DIM);
    using Data = typename Leaf::DataType;
    const auto& leaf = at<Data>(place);
    if constexpr (!Data::FIXED_SIZE) {
      // Values of variable width, up to 16 bits, follow.
      constexpr int kMostBits = 16;
      if (leaf.bitWidth() > kMostBits) fail(where_, kDamaged);
      if (leaf.memUsage() > bytes_.size() - static_cast<std::uint64_t>(place)) {
        fail(where_, kDamaged);
      }
    }
    for_overlap(origin, 1, 1 << kLog, [&](const Index& i) {
      const auto n = static_cast<std::uint32_t>((i.x << (2 * kLog)) | (i.y << kLog) | i.z);
      value(origin + i) = static_cast<float>(leaf.getValue(n));
    });
  }
  void fill(const Index& origin, std::int64_t side, float with) {
    for_overlap(origin, 1, side, [&](const Index& i) { value(origin + i) = with; });
  }
  float& value(const Index& i) {
    const Index at = i - low_;
    const Index size = high_ - low_;
    return values_[static_cast<std::size_t>((at.z * size.y + at.y) * size.x + at.x)];
  }

  static Mat4 matrix_of(const nanovdb::Map& map) {
    Mat4 result;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        result[column][row] = map.mMatD[3 * row + column];
      }
      result[3][row] = map.mVecD[row];
    }
    return result;
  }

  const AlignedBytes& bytes_;
  const SourceLocation& where_;
  const std::uint64_t most_voxels_;
  Index low_{0, 0, 0}, high_{0, 0, 0};  ///< range of the points that are read: [low, high)
  std::uint64_t count_ = 0;
  std::vector<float> values_;
};

}  // namespace

std::optional<VoxelGrid> read_nanovdb(std::string_view bytes, std::string_view grid_name,
                                      const SourceLocation& where, std::uint64_t most_voxels) {
  const std::optional<PackedGrid> packed = find_grid(bytes, grid_name, where);
  if (!packed) return std::nullopt;
  const AlignedBytes unpacked = unpack(*packed, where);
  return TreeReader(unpacked, where, most_voxels).read();
}

bool has_nanovdb_grid(std::string_view bytes, std::string_view grid_name,
                      const SourceLocation& where) {
  return find_grid(bytes, grid_name, where).has_value();
}

}  // namespace ajar::pbrt
