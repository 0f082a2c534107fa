#pragma once
#include <cereal/archives/portable_binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/map.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/archive_forward.h"

namespace ajar {

/// State on its way into a checkpoint and back: the same bytes on every machine, floats by their
/// bits. A type takes part by a function template `serialize(archive, value)` beside it. Invalid
/// input raises a std::exception.
template <typename Value>
concept Archive = std::is_same_v<Value, OutputArchive> || std::is_same_v<Value, InputArchive>;

/// Reads the output of an OutputArchive from untrusted files: no value takes more memory than a few
/// times the bytes that are there for it, whatever size it claims, and invalid bools are refused.
class InputArchive final
    : public cereal::InputArchive<InputArchive, cereal::AllowEmptyClassElision> {
 public:
  /// `bytes` must outlive it.
  explicit InputArchive(std::string_view bytes)
      : cereal::InputArchive<InputArchive, cereal::AllowEmptyClassElision>(this), rest_(bytes) {
    // The archive's byte order: checkpoints are little-endian.
    char is_little_endian = 0;
    take(&is_little_endian, 1);
    if (is_little_endian != 1) throw std::runtime_error("it is no archive");
  }
  std::size_t left() const { return rest_.size(); }
  void take(void* to, std::size_t size) {
    if (size > rest_.size()) throw std::runtime_error("it ends too early");
    if (size > 0) std::memcpy(to, rest_.data(), size);
    rest_.remove_prefix(size);
  }

 private:
  std::string_view rest_;
};

template <typename Number>
requires std::is_arithmetic_v<Number>
void load(InputArchive& archive, Number& number) { archive.take(&number, sizeof(number)); }
inline void load(InputArchive& archive, bool& value) {
  unsigned char byte = 0;
  archive.take(&byte, 1);
  if (byte > 1) throw std::runtime_error("neither true nor false");
  value = byte == 1;
}
template <typename Number>
void load(InputArchive& archive, cereal::BinaryData<Number>& numbers) {
  archive.take(numbers.data, numbers.size);
}
template <typename Value>
void load(InputArchive& archive, cereal::NameValuePair<Value>& pair) {
  archive(pair.value);
}
/// No element of a container is written in less than a byte.
template <typename Size>
void load(InputArchive& archive, cereal::SizeTag<Size>& tag) {
  archive(tag.size);
  if (tag.size > archive.left()) throw std::runtime_error("it ends too early");
}
template <typename Value>
void load(InputArchive& archive, std::vector<Value>& values) {
  cereal::size_type size = 0;
  archive(cereal::make_size_tag(size));
  values.clear();
  if constexpr (std::is_arithmetic_v<Value>) {
    if (size > archive.left() / sizeof(Value)) throw std::runtime_error("it ends too early");
    values.resize(size);
    archive.take(values.data(), size * sizeof(Value));
  } else {
    // One by one: the memory grows with what has been read.
    for (cereal::size_type i = 0; i < size; ++i) archive(values.emplace_back());
  }
}

/// The bytes that `save(OutputArchive&)` writes.
template <typename Save>
std::string archived(const Save& save) {
  std::ostringstream bytes(std::ios::binary);
  {
    OutputArchive archive(bytes);
    save(archive);
  }
  return std::move(bytes).str();
}

/// Lets `load(InputArchive&)` read `bytes`, all of them.
template <typename Load>
void unarchive(std::string_view bytes, const Load& load) {
  InputArchive archive(bytes);
  load(archive);
  if (archive.left() > 0) throw std::runtime_error("it has something added");
}

}  // namespace ajar
