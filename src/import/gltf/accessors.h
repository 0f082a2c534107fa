#pragma once
#include <cstdint>
#include <vector>

#include "import/gltf/buffers.h"

namespace ajar::gltf {

enum class ComponentType { Byte, UnsignedByte, Short, UnsignedShort, UnsignedInt, Float };

/// The arrays of numbers that meshes are made of.
class Accessors {
 public:
  Accessors(const Context& context, Buffers& buffers);

  /// The accessor that the value `reference` is the number of.
  std::size_t index_of(const Element& reference) const { return reference.index(all_.size()); }
  std::size_t count(std::size_t accessor) const;

  /// Positions, normals, … of any component type; normalised integers become fractions. Raises
  /// SceneError for other than three (two) components, and for bytes that are not there.
  std::vector<Vec3> read_vec3(std::size_t accessor);
  std::vector<Vec2> read_vec2(std::size_t accessor);
  std::vector<Imath::V4f> read_vec4(std::size_t accessor);
  /// 4 × 4 matrices, for vectors that are multiplied from the left.
  std::vector<Imath::M44f> read_matrices(std::size_t accessor);
  /// Colours of three components or four; the fourth is 1 if there is none. Integers are shares of
  /// the largest in any case, as colours are nothing else (glTF 2.0, section 3.7.2.1).
  std::vector<Imath::V4f> read_colors(std::size_t accessor);
  /// True if the elements are integers that the file does not call normalised.
  bool are_plain_integers(std::size_t accessor) const;
  /// Tangents of four components, the last of which becomes the handedness of the mesh.
  void read_tangents(std::size_t accessor, desc::Mesh& mesh);
  /// Scalars of an unsigned type. Raises as the others.
  std::vector<unsigned> read_indices(std::size_t accessor);

 private:
  /// Elements in memory that has been checked.
  struct Layout {
    const char* bytes = nullptr;  ///< null: all are zero
    std::size_t stride = 0;
    std::size_t count = 0;
    ComponentType type = ComponentType::Float;
    bool normalized = false;
  };

  Layout layout_of(const Element& accessor, int components);
  /// Where `count` elements of `size` bytes are, checked.
  Layout elements_of(const Element& user, std::size_t count, std::size_t size);
  template <typename Value>
  std::vector<Value> read(std::size_t accessor, int components, bool as_shares = false);
  template <typename Value>
  void read_sparse(const Element& accessor, const Layout& base, int components,
                   std::vector<Value>& values);
  void take_memory(const Element& user, std::uint64_t bytes);

  Buffers& buffers_;
  std::vector<Element> all_;
  std::uint64_t unasked_bytes_ = 0;
};

}  // namespace ajar::gltf
