#pragma once
#include <cereal/archives/portable_binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/map.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <sstream>
#include <string>
#include <type_traits>

#include "core/archive_forward.h"

namespace ajar {

/// State on its way into a checkpoint and back: the same bytes on every machine, floats by their
/// bits. A type takes part by a function template `serialize(archive, value)` beside it. Reading
/// more than there is raises a std::exception.
template <typename Value>
concept Archive = std::is_same_v<Value, OutputArchive> || std::is_same_v<Value, InputArchive>;

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

/// Lets `load(InputArchive&)` read `bytes`.
template <typename Load>
void unarchive(const std::string& bytes, const Load& load) {
  std::istringstream stream(bytes, std::ios::binary);
  InputArchive archive(stream);
  load(archive);
}

}  // namespace ajar
