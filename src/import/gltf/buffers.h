#pragma once
#include <map>
#include <memory>
#include <string_view>
#include <vector>

#include "import/gltf/context.h"

namespace ajar::gltf {

/// Part of a buffer.
struct BufferView {
  std::string_view bytes;
  std::size_t stride = 0;  ///< from element to element, bytes; 0 if they follow each other
};

/// The buffers of a file, each read when it is first asked for, and each file once.
class Buffers {
 public:
  explicit Buffers(const Context& context);

  /// The view that the member `name` of `user` refers to; nothing if there is no such member.
  /// Raises SceneError if it reaches beyond its buffer, or the buffer cannot be read.
  std::optional<BufferView> find_view(const Element& user, std::string_view name);
  /// Sum over all buffers, as the file says.
  std::uint64_t total_bytes() const { return total_bytes_; }

 private:
  std::string_view bytes_of(std::size_t i);
  std::string_view load(const Element& buffer);

  const Context& context_;
  std::vector<Element> buffers_;
  std::vector<Element> views_;
  std::vector<std::optional<std::string_view>> loaded_;
  std::vector<std::unique_ptr<const std::string>> decoded_;
  std::map<std::string, FileBytes> files_;
  std::uint64_t total_bytes_ = 0;
};

}  // namespace ajar::gltf
