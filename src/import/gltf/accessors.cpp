#include "import/gltf/accessors.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

#include "core/printable_text.h"
#include "os/available_memory.h"

namespace ajar::gltf {
namespace {

constexpr int kMatrix = 16;

/// Runs `body` with a value of the C++ type of a component.
template <typename Body>
auto with_type(ComponentType type, const Body& body) {
  switch (type) {
    case ComponentType::Byte:
      return body(std::int8_t{});
    case ComponentType::UnsignedByte:
      return body(std::uint8_t{});
    case ComponentType::Short:
      return body(std::int16_t{});
    case ComponentType::UnsignedShort:
      return body(std::uint16_t{});
    case ComponentType::UnsignedInt:
      return body(std::uint32_t{});
    case ComponentType::Float:
      break;
  }
  return body(float{});
}

std::size_t size_of(ComponentType type) {
  return with_type(type, [](auto value) { return sizeof(value); });
}

/// Elements of an accessor.
std::size_t count_of(const Element& accessor) {
  const Element count = accessor.at("count");
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (count.as<std::uint64_t>() > kMost) {
    count.fail("these are " + std::to_string(count.as<std::uint64_t>()) +
               " elements, of which at most " + std::to_string(kMost) + " can be read");
  }
  return static_cast<std::size_t>(count.as<std::uint64_t>());
}

ComponentType component_type_of(const Element& element) {
  const Element type = element.at("componentType");
  switch (type.as<std::uint64_t>()) {
    case 5120:
      return ComponentType::Byte;
    case 5121:
      return ComponentType::UnsignedByte;
    case 5122:
      return ComponentType::Short;
    case 5123:
      return ComponentType::UnsignedShort;
    case 5125:
      return ComponentType::UnsignedInt;
    case 5126:
      return ComponentType::Float;
    default:
      type.fail(std::to_string(type.as<std::uint64_t>()) +
                " is no component type. Valid: 5120, 5121, 5122, 5123, 5125, 5126");
  }
}

void check_type(const Element& accessor, int components) {
  static const std::vector<std::string> kTypes = {"SCALAR", "VEC2", "VEC3", "VEC4",
                                                  "MAT2",   "MAT3", "MAT4"};
  const Element type = accessor.at("type");
  const std::string name = type.text();
  const auto found = std::find(kTypes.begin(), kTypes.end(), name);
  if (found == kTypes.end()) {
    type.fail(unknown_name_message("type of accessor", printable_line(name), kTypes));
  }
  const std::string& expected =
      components == kMatrix ? kTypes.back() : kTypes[static_cast<std::size_t>(components) - 1];
  if (name != expected) type.fail("a " + expected + " is needed here, not a " + name);
}

/// Source: glTF 2.0, section 3.6.2.2.
template <typename T>
float as_float(T value, bool normalized) {
  if (std::is_same_v<T, float> || !normalized) return static_cast<float>(value);
  const float scaled =
      static_cast<float>(value) / static_cast<float>(std::numeric_limits<T>::max());
  return std::max(scaled, -1.F);
}

unsigned& component(unsigned& value, int /*c*/) { return value; }
float& component(Imath::M44f& matrix, int c) { return matrix[c / 4][c % 4]; }
template <typename Vector>
float& component(Vector& vector, int c) {
  return vector[c];
}

/// Reads one element of the stored type `T`.
template <typename T, typename Value>
void read_element(const char* bytes, int components, bool normalized, Value& value) {
  for (int c = 0; c < components; ++c) {
    T stored{};
    std::memcpy(&stored, bytes + static_cast<std::size_t>(c) * sizeof(T), sizeof(T));
    if constexpr (std::is_same_v<Value, unsigned>) {
      component(value, c) = static_cast<unsigned>(stored);
    } else {
      component(value, c) = as_float(stored, normalized);
    }
  }
}

}  // namespace

Accessors::Accessors(const Context& context, Buffers& buffers)
    : buffers_(buffers), all_(context.document.root.items("accessors")) {}

std::size_t Accessors::count(std::size_t accessor) const { return count_of(all_[accessor]); }

std::vector<Vec3> Accessors::read_vec3(std::size_t accessor) { return read<Vec3>(accessor, 3); }
std::vector<Vec2> Accessors::read_vec2(std::size_t accessor) { return read<Vec2>(accessor, 2); }

std::vector<Imath::V4f> Accessors::read_vec4(std::size_t accessor) {
  return read<Imath::V4f>(accessor, 4);
}
std::vector<Imath::M44f> Accessors::read_matrices(std::size_t accessor) {
  // Columns of glTF are the rows of Imath, which multiplies vectors from the left.
  return read<Imath::M44f>(accessor, kMatrix);
}

bool Accessors::are_plain_integers(std::size_t accessor) const {
  return component_type_of(all_[accessor]) != ComponentType::Float &&
         !all_[accessor].value_or("normalized", false);
}

std::vector<Imath::V4f> Accessors::read_colors(std::size_t accessor) {
  constexpr bool kAsShares = true;
  if (all_[accessor].at("type").text() == "VEC4") return read<Imath::V4f>(accessor, 4, kAsShares);
  std::vector<Imath::V4f> colors;
  for (const Vec3& color : read<Vec3>(accessor, 3, kAsShares)) {
    colors.emplace_back(color.x, color.y, color.z, 1.F);
  }
  return colors;
}

void Accessors::read_tangents(std::size_t accessor, desc::Mesh& mesh) {
  for (const Imath::V4f& t : read<Imath::V4f>(accessor, 4)) {
    mesh.tangents.emplace_back(t.x, t.y, t.z);
    mesh.handedness.push_back(static_cast<std::int8_t>(t.w > 0.F ? 1 : t.w < 0.F ? -1 : 0));
  }
}

std::vector<unsigned> Accessors::read_indices(std::size_t accessor) {
  const Element type = all_[accessor].at("componentType");
  const ComponentType component = component_type_of(all_[accessor]);
  if (component != ComponentType::UnsignedByte && component != ComponentType::UnsignedShort &&
      component != ComponentType::UnsignedInt) {
    type.fail("indices are of the type 5121, 5123 or 5125, not " +
              std::to_string(type.as<std::uint64_t>()));
  }
  return read<unsigned>(accessor, 1);
}

template <typename Value>
std::vector<Value> Accessors::read(std::size_t i, int components, bool as_shares) {
  const Element& accessor = all_[i];
  Layout layout = layout_of(accessor, components);
  layout.normalized |= as_shares;
  take_memory(accessor, layout.count * sizeof(Value));
  // Zeros where the accessor has no bytes (section 5.1.1); vectors would be left as they are.
  std::vector<Value> values(layout.count, static_cast<Value>(0.F));
  if (layout.bytes != nullptr) {
    with_type(layout.type, [&]<typename T>(T) {
      const char* bytes = layout.bytes;
      for (Value& value : values) {
        read_element<T>(bytes, components, layout.normalized, value);
        bytes += layout.stride;
      }
    });
  }
  read_sparse(accessor, layout, components, values);
  return values;
}

template <typename Value>
void Accessors::read_sparse(const Element& accessor, const Layout& base, int components,
                            std::vector<Value>& values) {
  const std::optional<Element> sparse = accessor.find("sparse");
  if (!sparse) return;
  const std::uint64_t count = sparse->at("count").as<std::uint64_t>();
  if (count > values.size()) {
    sparse->at("count").fail("more elements are replaced than there are: " + std::to_string(count) +
                             " of " + std::to_string(values.size()));
  }
  const Element indices = sparse->at("indices");
  const ComponentType index_type = component_type_of(indices);
  const auto n = static_cast<std::size_t>(count);
  const Layout places = elements_of(indices, n, size_of(index_type));
  const Layout replaced = elements_of(sparse->at("values"), n,
                                      static_cast<std::size_t>(components) * size_of(base.type));
  if (places.bytes == nullptr || replaced.bytes == nullptr) {
    sparse->fail("its \"indices\" and \"values\" need a \"bufferView\" each");
  }
  for (std::size_t i = 0; i < n; ++i) {
    unsigned place = 0;
    with_type(index_type, [&]<typename T>(T) {
      read_element<T>(places.bytes + i * places.stride, 1, false, place);
    });
    if (place >= values.size()) {
      indices.fail("index " + std::to_string(i) + " is " + std::to_string(place) +
                   ", but there are " + std::to_string(values.size()) + " elements");
    }
    with_type(base.type, [&]<typename T>(T) {
      read_element<T>(replaced.bytes + i * replaced.stride, components, base.normalized,
                      values[place]);
    });
  }
}

Accessors::Layout Accessors::layout_of(const Element& accessor, int components) {
  check_type(accessor, components);
  const ComponentType type = component_type_of(accessor);
  const std::size_t size = static_cast<std::size_t>(components) * size_of(type);
  const std::size_t elements = count_of(accessor);
  Layout layout = elements_of(accessor, elements, size);
  // Zeros need no bytes in the file; but drawn elements have at least an index each.
  if (layout.bytes == nullptr && elements > buffers_.total_bytes()) {
    accessor.at("count").fail("these " + std::to_string(elements) +
                              " elements have no bytes of their own, and are more than the file "
                              "has bytes");
  }
  layout.type = type;
  layout.normalized = accessor.value_or("normalized", false);
  return layout;
}

Accessors::Layout Accessors::elements_of(const Element& user, std::size_t count, std::size_t size) {
  Layout layout;
  layout.count = count;
  const std::optional<BufferView> view = buffers_.find_view(user, "bufferView");
  if (!view || count == 0) return layout;
  layout.stride = view->stride > 0 ? view->stride : size;
  const std::uint64_t offset = user.value_or<std::uint64_t>("byteOffset", 0);
  const std::size_t available = view->bytes.size();
  const bool fits = offset <= available && size <= available - offset &&
                    count - 1 <= (available - offset - size) / layout.stride;
  if (!fits) {
    user.fail(std::to_string(count) + " elements of " + std::to_string(size) + " bytes, every " +
              std::to_string(layout.stride) + " from " + std::to_string(offset) +
              ", reach beyond their buffer view, which has " + std::to_string(available) +
              " bytes");
  }
  layout.bytes = view->bytes.data() + offset;
  return layout;
}

void Accessors::take_memory(const Element& user, std::uint64_t bytes) {
  constexpr std::uint64_t kAskEvery = std::uint64_t{1} << 26U;
  unasked_bytes_ += bytes;
  if (unasked_bytes_ < kAskEvery) return;
  if (const std::string preparation_cut = memory_shortage(unasked_bytes_);
      !preparation_cut.empty()) {
    user.fail("this " + preparation_cut);
  }
  unasked_bytes_ = 0;
}

}  // namespace ajar::gltf
