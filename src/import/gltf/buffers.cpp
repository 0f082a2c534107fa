#include "import/gltf/buffers.h"

#include <limits>

#include "import/gltf/uri.h"

namespace ajar::gltf {
namespace {

std::uint64_t added(std::uint64_t a, std::uint64_t b) {
  return a > std::numeric_limits<std::uint64_t>::max() - b
             ? std::numeric_limits<std::uint64_t>::max()
             : a + b;
}

}  // namespace

Buffers::Buffers(const Context& context)
    : context_(context),
      buffers_(context.document.root.items("buffers")),
      views_(context.document.root.items("bufferViews")),
      loaded_(buffers_.size()) {
  for (const Element& buffer : buffers_) {
    total_bytes_ = added(total_bytes_, buffer.at("byteLength").as<std::uint64_t>());
  }
}

std::optional<BufferView> Buffers::find_view(const Element& user, std::string_view name) {
  const std::optional<std::size_t> i = user.find_index(name, views_.size());
  if (!i) return std::nullopt;
  const Element& view = views_[*i];
  const std::string_view buffer = bytes_of(view.at("buffer").index(buffers_.size()));
  const std::uint64_t offset = view.value_or<std::uint64_t>("byteOffset", 0);
  const std::uint64_t length = view.at("byteLength").as<std::uint64_t>();
  if (offset > buffer.size() || length > buffer.size() - offset) {
    view.fail("this reaches beyond its buffer, which has " + std::to_string(buffer.size()) +
              " bytes: " + std::to_string(length) + " from " + std::to_string(offset));
  }
  constexpr std::uint64_t kMostStride = 252;  // glTF 2.0, section 5.11.4
  const std::uint64_t stride = view.value_or<std::uint64_t>("byteStride", 0);
  if (stride > kMostStride) {
    view.at("byteStride")
        .fail("a stride is at most " + std::to_string(kMostStride) + ", not " +
              std::to_string(stride));
  }
  return BufferView{
      buffer.substr(static_cast<std::size_t>(offset), static_cast<std::size_t>(length)),
      static_cast<std::size_t>(stride)};
}

std::string_view Buffers::bytes_of(std::size_t i) {
  if (loaded_[i]) return *loaded_[i];
  const Element& buffer = buffers_[i];
  const std::string_view bytes = load(buffer);
  const std::uint64_t length = buffer.at("byteLength").as<std::uint64_t>();
  if (length > bytes.size()) {
    buffer.fail("this buffer should have " + std::to_string(length) + " bytes, but there are " +
                std::to_string(bytes.size()));
  }
  loaded_[i] = bytes.substr(0, static_cast<std::size_t>(length));
  return *loaded_[i];
}

std::string_view Buffers::load(const Element& buffer) {
  const std::optional<Element> uri = buffer.find("uri");
  if (!uri) {
    if (context_.document.binary.empty()) {
      buffer.fail("this buffer has no \"uri\", and the file has no binary chunk");
    }
    return context_.document.binary;
  }
  try {
    UriTarget target = target_of(*uri);
    if (target.data) {
      decoded_.push_back(std::make_unique<const std::string>(std::move(*target.data)));
      return *decoded_.back();
    }
    const std::string path = context_.files.resolve_inside(target.file, uri->where());
    auto file = files_.find(path);
    if (file == files_.end()) file = files_.emplace(path, context_.files.load(path)).first;
    return file->second.view();
  } catch (const IoError& error) {
    uri->fail(std::string("cannot read this buffer: ") + error.what());
  }
}

}  // namespace ajar::gltf
