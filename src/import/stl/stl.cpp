#include "import/stl/stl.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>

#include "core/error.h"
#include "core/printable_text.h"
#include "import/mesh/display_color.h"

namespace ajar {
namespace {

using Triangle = Imath::Vec3<unsigned>;

constexpr std::size_t kHeaderSize = 80;
constexpr std::size_t kFirstRecord = kHeaderSize + 4;
constexpr std::size_t kRecordSize = 50;  // normal, three corners, two bytes of anything

void add_triangle(desc::Mesh& mesh, const Vec3 (&corners)[3]) {
  const auto first = static_cast<unsigned>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), std::begin(corners), std::end(corners));
  mesh.indices.emplace_back(first, first + 1, first + 2);
}

/// Number of triangles in the header of a binary file.
std::uint32_t count_of(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeaderSize, sizeof(count));
  return count;
}

/// True if the records that the header counts are there. Headers may begin with "solid", too.
bool is_complete_binary(std::string_view bytes) {
  if (bytes.size() < kFirstRecord) return false;
  return (bytes.size() - kFirstRecord) / kRecordSize >= count_of(bytes);
}

/// Colour of a triangle, from the two bytes behind it.
class FacetColors {
 public:
  explicit FacetColors(std::string_view header) {
    constexpr std::string_view kWord = "COLOR=";
    const std::size_t place = header.find(kWord);
    if (place == header.npos || place + kWord.size() + 3 > header.size()) return;
    red_is_first_ = true;
    for (int lane = 0; lane < 3; ++lane) {
      const auto byte =
          static_cast<unsigned char>(header[place + kWord.size() + static_cast<std::size_t>(lane)]);
      usual_[lane] = static_cast<float>(byte) / 255.F;
    }
    has_some_ = true;
  }

  void add(std::uint16_t bits) {
    constexpr unsigned kFlag = 1U << 15U;
    const bool counts = ((bits & kFlag) != 0) != red_is_first_;
    has_some_ |= counts;
    Vec3 color = usual_;
    for (int i = 0; counts && i < 3; ++i) {
      constexpr float kFull = 31.F;
      color[red_is_first_ ? i : 2 - i] =
          static_cast<float>(bits >> (5U * static_cast<unsigned>(i)) & 31U) / kFull;
    }
    colors_.insert(colors_.end(), 3, from_display(color));
  }
  std::vector<Vec3> take() { return has_some_ ? std::move(colors_) : std::vector<Vec3>(); }

 private:
  bool red_is_first_ = false;
  bool has_some_ = false;
  Vec3 usual_{1.F};
  std::vector<Vec3> colors_;  ///< colours of three vertices for each triangle
};

StlContents read_binary(std::string_view bytes) {
  desc::Mesh mesh;
  FacetColors colors(bytes.substr(0, kHeaderSize));
  const std::uint32_t count = count_of(bytes);
  mesh.positions.reserve(std::size_t{3} * count);
  mesh.indices.reserve(count);
  const char* record = bytes.data() + kFirstRecord;
  for (std::uint32_t i = 0; i < count; ++i, record += kRecordSize) {
    float numbers[9];
    std::memcpy(numbers, record + 3 * sizeof(float), sizeof(numbers));
    const Vec3 corners[3] = {{numbers[0], numbers[1], numbers[2]},
                             {numbers[3], numbers[4], numbers[5]},
                             {numbers[6], numbers[7], numbers[8]}};
    add_triangle(mesh, corners);
    std::uint16_t bits = 0;
    std::memcpy(&bits, record + kRecordSize - sizeof(bits), sizeof(bits));
    colors.add(bits);
  }
  return {std::move(mesh), colors.take()};
}

/// Reads the words of an ASCII file.
class AsciiReader {
 public:
  AsciiReader(std::string_view text, const std::string& name)
      : text_(text), name_(std::make_shared<const std::string>(name)) {}

  bool begins_with_solid() {
    next();
    return is("solid");
  }
  desc::Mesh read() {
    desc::Mesh mesh;
    end_ = 0;
    next();
    while (!word_.empty()) {
      expect("solid");
      skip_line();
      next();
      while (is("facet")) read_facet(mesh);
      expect("endsolid");
      skip_line();
      next();
    }
    return mesh;
  }

 private:
  void read_facet(desc::Mesh& mesh) {
    expect("facet");
    next();
    expect("normal");
    for (int i = 0; i < 3; ++i) next();
    next();
    expect("outer");
    next();
    expect("loop");
    next();
    Vec3 corners[3];
    for (Vec3& corner : corners) {
      expect("vertex");
      for (int lane = 0; lane < 3; ++lane) {
        next();
        corner[lane] = number();
      }
      next();
    }
    expect("endloop");
    next();
    expect("endfacet");
    next();
    add_triangle(mesh, corners);
  }

  /// Takes the next word; none at the end of the text.
  void next() {
    constexpr std::string_view kSpace = " \t\r\n\v\f";
    std::size_t begin = text_.find_first_not_of(kSpace, end_);
    if (begin == text_.npos) begin = text_.size();
    begin_ = begin;
    end_ = std::min(text_.find_first_of(kSpace, begin), text_.size());
    word_ = text_.substr(begin_, end_ - begin_);
  }
  void skip_line() { end_ = std::min(text_.find('\n', end_), text_.size()); }

  /// Words may be in capitals.
  bool is(std::string_view keyword) const {
    return std::ranges::equal(word_, keyword, {}, [](char c) {
      return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
  }
  void expect(std::string_view keyword) const {
    if (!is(keyword)) fail("\"" + std::string(keyword) + "\"");
  }
  float number() const {
    // std::from_chars takes no sign in front but a minus.
    const std::string_view digits = word_.starts_with('+') ? word_.substr(1) : word_;
    float value = 0.F;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size()) fail("a number");
    return value;
  }

  [[noreturn]] void fail(const std::string& expected) const {
    const std::string_view before = text_.substr(0, begin_);
    int line = 1;
    for (const char c : before) line += c == '\n' ? 1 : 0;
    const auto column = static_cast<int>(before.size() - (before.rfind('\n') + 1)) + 1;
    constexpr std::size_t kLongest = 40;
    const std::string found = word_.empty()
                                  ? "the end of the file"
                                  : "\"" + printable_line(word_.substr(0, kLongest)) + "\"";
    throw SceneError({name_, line, column}, "expected " + expected + ", found " + found);
  }

  std::string_view text_;
  std::shared_ptr<const std::string> name_;
  std::size_t begin_ = 0, end_ = 0;  ///< bounds of the word
  std::string_view word_;
};

}  // namespace

StlContents read_stl(std::string_view bytes, const std::string& name) {
  if (is_complete_binary(bytes)) return read_binary(bytes);
  if (AsciiReader text(bytes, name); text.begins_with_solid()) return {text.read(), {}};
  const SourceLocation where{std::make_shared<const std::string>(name), 0, 0};
  if (bytes.size() < kFirstRecord) {
    throw SceneError(where,
                     "this is no STL file: it neither begins with \"solid\" nor is as long "
                     "as the header of a binary one");
  }
  throw SceneError(where, "the file ends early: " + std::to_string(count_of(bytes)) +
                              " triangles need " +
                              std::to_string(kFirstRecord + kRecordSize * count_of(bytes)) +
                              " bytes, and there are " + std::to_string(bytes.size()));
}

}  // namespace ajar
