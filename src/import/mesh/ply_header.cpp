#include "import/mesh/ply_header.h"

#include <array>
#include <charconv>
#include <memory>
#include <optional>
#include <utility>

#include "core/error.h"

namespace ajar {
namespace {

constexpr int kMaxLines = 10000;
constexpr std::size_t kMaxProperties = 1000;

std::optional<PlyType> type_of(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, PlyType>, 16> kNames = {
      {{"char", PlyType::Int8},
       {"int8", PlyType::Int8},
       {"uchar", PlyType::UInt8},
       {"uint8", PlyType::UInt8},
       {"short", PlyType::Int16},
       {"int16", PlyType::Int16},
       {"ushort", PlyType::UInt16},
       {"uint16", PlyType::UInt16},
       {"int", PlyType::Int32},
       {"int32", PlyType::Int32},
       {"uint", PlyType::UInt32},
       {"uint32", PlyType::UInt32},
       {"float", PlyType::Float32},
       {"float32", PlyType::Float32},
       {"double", PlyType::Float64},
       {"float64", PlyType::Float64}}};
  for (const auto& entry : kNames) {
    if (entry.first == name) return entry.second;
  }
  return std::nullopt;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  std::size_t i = 0;
  while (i < line.size() && words.size() < 8) {
    while (i < line.size() && (line[i] == ' ' || line[i] == '\t')) ++i;
    const std::size_t begin = i;
    while (i < line.size() && line[i] != ' ' && line[i] != '\t') ++i;
    if (i > begin) words.push_back(line.substr(begin, i - begin));
  }
  return words;
}

/// The header, line by line.
class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::string& name)
      : bytes_(bytes), file_(std::make_shared<const std::string>(name)) {}

  std::string_view next_line() {
    ++line_;
    const std::size_t end = bytes_.find('\n', position_);
    if (end == std::string_view::npos || line_ > kMaxLines) {
      fail(line_ == 1 ? "this is not a PLY file" : "the PLY header has no end");
    }
    std::string_view line = bytes_.substr(position_, end - position_);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    position_ = end + 1;
    return line;
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw SceneError({file_, line_, 0}, message);
  }
  std::size_t position() const { return position_; }
  int line() const { return line_; }

 private:
  std::string_view bytes_;
  std::shared_ptr<const std::string> file_;
  std::size_t position_ = 0;
  int line_ = 0;
};

PlyProperty parse_property(const HeaderReader& reader, const std::vector<std::string_view>& words) {
  PlyProperty property;
  const auto type = [&](std::string_view word) {
    const std::optional<PlyType> found = type_of(word);
    if (!found) reader.fail("unknown PLY type \"" + std::string(word.substr(0, 40)) + "\"");
    return *found;
  };
  if (words.size() == 5 && words[1] == "list") {
    property.is_list = true;
    property.count_type = type(words[2]);
    if (property.count_type == PlyType::Float32 || property.count_type == PlyType::Float64) {
      reader.fail("the length of a PLY list must be an integer");
    }
    property.type = type(words[3]);
    property.name = words[4];
  } else if (words.size() == 3) {
    property.type = type(words[1]);
    property.name = words[2];
  } else {
    reader.fail("malformed PLY property");
  }
  return property;
}

}  // namespace

std::size_t ply_size(PlyType type) {
  static constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

PlyHeader parse_ply_header(std::string_view bytes, const std::string& name) {
  HeaderReader reader(bytes, name);
  if (bytes.substr(0, 3) != "ply") reader.fail("this is not a PLY file");
  if (reader.next_line() != "ply") reader.fail("this is not a PLY file");
  PlyHeader header;
  bool has_format = false;
  std::size_t properties = 0;
  while (true) {
    const std::string_view line = reader.next_line();
    const std::vector<std::string_view> words = words_of(line);
    if (words.size() > 2 && words[0] == "comment" && words[1] == "TextureFile") {
      // All of the rest: names may have spaces.
      const auto begin = static_cast<std::size_t>(words[2].data() - line.data());
      const std::size_t end = line.find_last_not_of(" \t") + 1;
      header.images.push_back({std::string(line.substr(begin, end - begin)), reader.line()});
    }
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header") break;
    if (words[0] == "format" && words.size() >= 2) {
      has_format = true;
      if (words[1] == "ascii") {
        header.format = PlyFormat::Ascii;
      } else if (words[1] == "binary_little_endian") {
        header.format = PlyFormat::BinaryLittleEndian;
      } else if (words[1] == "binary_big_endian") {
        header.format = PlyFormat::BinaryBigEndian;
      } else {
        reader.fail("unknown PLY format \"" + std::string(words[1].substr(0, 40)) + "\"");
      }
    } else if (words[0] == "element" && words.size() == 3) {
      PlyElement element;
      element.name = words[1];
      const auto [end, error] =
          std::from_chars(words[2].data(), words[2].data() + words[2].size(), element.count);
      if (error != std::errc() || end != words[2].data() + words[2].size()) {
        reader.fail("malformed PLY element count");
      }
      header.elements.push_back(std::move(element));
    } else if (words[0] == "property") {
      if (header.elements.empty()) reader.fail("PLY property before any element");
      if (++properties > kMaxProperties) reader.fail("too many PLY properties");
      header.elements.back().properties.push_back(parse_property(reader, words));
    } else {
      reader.fail("unknown PLY header line \"" + std::string(words[0].substr(0, 40)) + "\"");
    }
  }
  if (!has_format) reader.fail("the PLY header has no format");
  header.size = reader.position();
  header.lines = reader.line();
  return header;
}

}  // namespace ajar
