#pragma once
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

#include "import/mesh/ply_header.h"

namespace ajar {

/// Reads the values of a PLY body one after the other; empty when the data ends or is malformed.
class PlyBinaryCursor {
 public:
  PlyBinaryCursor(std::string_view body, bool big_endian)
      : position_(body.data()),
        end_(body.data() + body.size()),
        swap_(big_endian != (std::endian::native == std::endian::big)) {}

  std::optional<double> read(PlyType type) {
    const std::size_t size = ply_size(type);
    if (left() < size) return std::nullopt;
    const double value = at(position_, type);
    position_ += size;
    return value;
  }
  bool skip(PlyType type, std::uint64_t count) {
    if (count > left() / ply_size(type)) return false;
    position_ += count * ply_size(type);
    return true;
  }
  /// Fewest bytes that a record with these properties takes.
  static std::size_t record_size(const PlyElement& element) {
    std::size_t size = 0;
    for (const PlyProperty& p : element.properties)
      size += ply_size(p.is_list ? p.count_type : p.type);
    return size;
  }

  /// The value at any place of the body.
  double at(const char* place, PlyType type) const {
    switch (type) {
      case PlyType::Int8:
        return load<std::int8_t>(place);
      case PlyType::UInt8:
        return load<std::uint8_t>(place);
      case PlyType::Int16:
        return load<std::int16_t>(place);
      case PlyType::UInt16:
        return load<std::uint16_t>(place);
      case PlyType::Int32:
        return load<std::int32_t>(place);
      case PlyType::UInt32:
        return load<std::uint32_t>(place);
      case PlyType::Float32:
        return load<float>(place);
      case PlyType::Float64:
        return load<double>(place);
    }
    return 0.0;
  }
  std::size_t left() const { return static_cast<std::size_t>(end_ - position_); }
  const char* position() const { return position_; }
  void advance(std::size_t bytes) { position_ += bytes; }
  bool native_order() const { return !swap_; }

 private:
  template <typename T>
  T load(const char* place) const {
    char bytes[sizeof(T)];
    std::memcpy(bytes, place, sizeof(T));
    if (swap_) {
      for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(bytes[i], bytes[sizeof(T) - 1 - i]);
    }
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }

  const char* position_;
  const char* end_;
  bool swap_;
};

/// Cursor for ascii bodies.
class PlyAsciiCursor {
 public:
  explicit PlyAsciiCursor(std::string_view body)
      : position_(body.data()), end_(body.data() + body.size()) {}

  std::optional<double> read(PlyType type) {
    while (position_ < end_ && is_space(*position_)) ++position_;
    if (position_ < end_ && *position_ == '+') ++position_;
    if (type == PlyType::Float32) return parse<float>();
    return parse<double>();
  }
  bool skip(PlyType type, std::uint64_t count) {
    if (count > left()) return false;
    for (std::uint64_t i = 0; i < count; ++i) {
      if (!read(type)) return false;
    }
    return true;
  }
  static std::size_t record_size(const PlyElement& element) {
    return 2 * element.properties.size() - 1;
  }
  std::size_t left() const { return static_cast<std::size_t>(end_ - position_); }
  const char* position() const { return position_; }

 private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  /// Values that a float cannot hold become 0 or infinity, which `validate_mesh` judges.
  template <typename T>
  std::optional<double> parse() {
    T value = 0;
    const auto [end, error] = std::from_chars(position_, end_, value);
    if (error == std::errc::invalid_argument) return std::nullopt;
    if (error == std::errc::result_out_of_range) {
      const std::string_view text(position_, static_cast<std::size_t>(end - position_));
      value = text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos
                  ? T(0)
                  : std::numeric_limits<T>::infinity();
    }
    if (end < end_ && !is_space(*end)) return std::nullopt;
    position_ = end;
    return static_cast<double>(value);
  }

  const char* position_;
  const char* end_;
};

}  // namespace ajar
