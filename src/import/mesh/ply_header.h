#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ajar {

enum class PlyFormat { Ascii, BinaryLittleEndian, BinaryBigEndian };
enum class PlyType : std::uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };
/// Size of a value in bytes.
std::size_t ply_size(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;
  bool is_list = false;
  PlyType count_type = PlyType::UInt8;  ///< type of the length of lists
};
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};
/// An image that a remark names, as MeshLab and scanners write it.
struct PlyImage {
  std::string file;
  int line = 0;
};
struct PlyHeader {
  PlyFormat format = PlyFormat::Ascii;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  ///< bytes up to and including the line break after end_header
  int lines = 0;
  std::vector<PlyImage> images;
};

/// Raises SceneError with file and line.
PlyHeader parse_ply_header(std::string_view bytes, const std::string& name);

}  // namespace ajar
