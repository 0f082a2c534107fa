#include "import/gltf/document.h"

#include <bit>
#include <cstring>

#include "core/printable_text.h"

namespace ajar::gltf {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

/// Source: glTF 2.0, section 4.
constexpr std::string_view kMagic = "glTF";
constexpr std::size_t kHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

struct Chunks {
  std::string_view json;
  std::string_view binary;
};

/// Reads a .glb, whose numbers are little-endian.
class Container {
 public:
  Container(std::string_view bytes, std::shared_ptr<const std::string> name)
      : bytes_(bytes), name_(std::move(name)) {}

  Chunks read() const {
    if (bytes_.size() < kHeaderSize) fail("the file ends in its header");
    if (const std::uint32_t version = number_at(4); version != 2) {
      fail("this is a container of version " + std::to_string(version) +
           "; only version 2 can be read");
    }
    const std::uint32_t length = number_at(8);
    if (length > bytes_.size()) {
      fail("the file ends early: it should have " + std::to_string(length) + " bytes, not " +
           std::to_string(bytes_.size()));
    }
    Chunks chunks;
    for (std::size_t place = kHeaderSize; place < length;) {
      if (length - place < kChunkHeaderSize) fail("the header of a chunk is not complete");
      const std::uint32_t size = number_at(place);
      const std::uint32_t type = number_at(place + 4);
      place += kChunkHeaderSize;
      if (size > length - place) fail("a chunk reaches beyond the end of the file");
      const std::string_view content = bytes_.substr(place, size);
      if (type == kJsonChunk && chunks.json.empty()) chunks.json = content;
      if (type == kBinaryChunk && chunks.binary.empty()) chunks.binary = content;
      place += size;
    }
    if (chunks.json.empty()) fail("there is no chunk of JSON");
    return chunks;
  }

 private:
  std::uint32_t number_at(std::size_t place) const {
    std::uint32_t number = 0;
    std::memcpy(&number, bytes_.data() + place, sizeof(number));
    return number;
  }
  [[noreturn]] void fail(const std::string& message) const {
    throw SceneError({name_, 0, 0}, message);
  }

  std::string_view bytes_;
  std::shared_ptr<const std::string> name_;
};

void check_version(const Element& root) {
  const Element version = root.at("asset").at("version");
  const std::string text = version.text();
  if (text.starts_with("2.")) return;
  version.fail("this is glTF " + printable_line(text) + "; only glTF 2 can be read");
}

}  // namespace

Document parse_document(std::string_view bytes, const std::string& name) {
  const auto shared_name = std::make_shared<const std::string>(name);
  Chunks chunks{bytes, {}};
  if (bytes.starts_with(kMagic)) chunks = Container(bytes, shared_name).read();
  const Element root = Element::parse(std::string(chunks.json), {.name = name});
  check_version(root);
  return {root, chunks.binary};
}

std::optional<Element> extension_of(const Element& element, std::string_view name) {
  const std::optional<Element> extensions = element.find("extensions");
  return extensions ? extensions->find(name) : std::nullopt;
}

Element referred(const Element& number, const Element& root, std::string_view name) {
  const std::optional<Element> array = root.find(name);
  const std::size_t i = number.index(array ? array->size() : 0);
  return (*array)[i];
}

}  // namespace ajar::gltf
