#include "scene/desc/scene_desc.h"

#include <bit>
#include <cstdint>
#include <map>
#include <type_traits>

#include "core/content_hash.h"

namespace ajar::desc {
namespace {

/// Accumulates a hash of values.
class Hasher : public ContentHash {
 public:
  // -0 and 0 describe the same scene.
  void add(float value) { word(std::bit_cast<std::uint32_t>(value + 0.F)); }
  void add(double value) { word(std::bit_cast<std::uint64_t>(value + 0.0)); }
  void add(int value) { word(static_cast<std::uint64_t>(value)); }
  void add(bool value) { word(value ? 1 : 0); }
  void add(const std::string& value) { bytes(value.data(), value.size()); }
  template <typename Enum>
  requires std::is_enum_v<Enum>
  void add(Enum value) { add(static_cast<int>(value)); }
  template <typename T>
  void add(const Imath::Vec3<T>& v) {
    add(v.x);
    add(v.y);
    add(v.z);
  }
  template <typename T>
  void add(const Imath::Vec2<T>& v) {
    add(v.x);
    add(v.y);
  }
  void add(const Mat4& m) {
    for (const auto& row : m.x) {
      for (const double value : row) add(value);
    }
  }
  template <typename T>
  void add(const std::optional<T>& value) {
    add(value.has_value());
    if (value) add(*value);
  }
  /// Memory as it is, for large arrays.
  template <typename T>
  void array(const std::vector<T>& values) {
    bytes(values.data(), values.size() * sizeof(T));
  }
  template <typename First, typename... Rest>
  requires(sizeof...(Rest) > 0) void add(const First& first, const Rest&... rest) {
    add(first);
    add(rest...);
  }
};

/// Hashes a scene. Things that are referred to count by their contents, not by their index.
class SceneHasher {
 public:
  explicit SceneHasher(const SceneDesc& scene) : scene_(scene) {
    for (const Texture& texture : scene.textures) textures_.push_back(hash_texture(texture));
    for (const Material& material : scene.materials) materials_.push_back(hash_material(material));
    for (const Medium& medium : scene.media) {
      media_.push_back(hash_medium(medium));
    }
  }

  std::uint64_t run() {
    Hasher h;
    h.word(scene_.shapes.size());
    for (const Shape& shape : scene_.shapes) hash_shape(h, shape);
    h.word(scene_.objects.size());
    for (const Object& object : scene_.objects) {
      h.word(object.shapes.size());
      for (const Shape& shape : object.shapes) hash_shape(h, shape);
    }
    h.word(scene_.instances.size());
    for (const Instance& instance : scene_.instances) h.add(instance.object, instance.to_world);
    h.word(scene_.lights.size());
    for (const Light& light : scene_.lights) hash_light(h, light);
    hash_camera(h);
    hash_film(h);
    return h.result();
  }

 private:
  static std::uint64_t find(const std::vector<std::uint64_t>& hashes, int id) {
    return id < 0 || static_cast<std::size_t>(id) >= hashes.size()
               ? 0
               : hashes[static_cast<std::size_t>(id)];
  }
  void texture(Hasher& h, TextureId id) const { h.word(find(textures_, id)); }
  void material(Hasher& h, MaterialId id) const { h.word(find(materials_, id)); }
  void medium(Hasher& h, MediumId id) const { h.word(find(media_, id)); }
  template <typename... Ids>
  void textures(Hasher& h, Ids... ids) const {
    (texture(h, ids), ...);
  }

  void value(Hasher& h, std::monostate) { h.word(0); }
  void value(Hasher& h, const TextureRef& v) { texture(h, v.id); }
  void value(Hasher& h, const MaterialRef& v) { material(h, v.id); }
  void value(Hasher& h, const TransformPointer& v) { h.add(*v); }
  void value(Hasher& h, const MeshPointer& v) { h.word(v ? hash_mesh(*v) : 0); }
  void value(Hasher& h, const CurvesPointer& v) {
    if (!v) return;
    h.array(v->control_points);
    h.array(v->widths);
    h.array(v->normals);
  }
  template <typename Plain>
  void value(Hasher& h, const Plain& v) {
    h.add(v);
  }
  void node(Hasher& h, const Node& n) {
    if (!n.has_model()) return;
    h.add(n.model().name);
    for (std::size_t i = 0; i < n.values().size(); ++i) {
      if (!n.matters(n.model().parameters[i])) continue;
      const Value& v = n.values()[i];
      h.word(v.index());
      std::visit([&](const auto& held) { value(h, held); }, v);
    }
  }

  static void window(Hasher& h, const std::optional<ScreenWindow>& w) {
    h.add(w.has_value());
    if (w) h.add(w->x_min, w->x_max, w->y_min, w->y_max);
  }
  void node(Hasher& h, const PerspectiveCamera& c) const {
    h.add(c.fov, c.lens_radius, c.focal_distance, c.aspect);
    window(h, c.window);
  }
  void node(Hasher& h, const OrthographicCamera& c) const {
    h.add(c.lens_radius, c.focal_distance, c.aspect);
    window(h, c.window);
  }
  void node(Hasher&, const EnvironmentCamera&) const {}

  void node(Hasher&, const BoxFilter&) const {}
  void node(Hasher&, const TriangleFilter&) const {}
  void node(Hasher& h, const GaussianFilter& f) const { h.add(f.falloff); }
  void node(Hasher& h, const MitchellFilter& f) const { h.add(f.b, f.c); }
  void node(Hasher& h, const SincFilter& f) const { h.add(f.lobes); }

  template <typename Variant>
  void variant(Hasher& h, const Variant& v) {
    h.word(v.index());
    std::visit([&](const auto& alternative) { node(h, alternative); }, v);
  }

  std::uint64_t hash_texture(const Texture& t) {
    Hasher h;
    node(h, t.node);
    return h.result();
  }
  std::uint64_t hash_material(const Material& m) {
    Hasher h;
    node(h, m.node);
    texture(h, m.bump);
    texture(h, m.normal_map.texture);
    if (m.normal_map.texture != kNone) h.add(m.normal_map.strength, m.normal_map.right_handed);
    return h.result();
  }
  std::uint64_t hash_medium(const Medium& medium) const {
    Hasher h;
    h.add(medium.sigma_a, medium.sigma_s, medium.g);
    if (medium.density && medium.density->grid) {
      const DensityGrid& grid = *medium.density->grid;
      h.add(medium.density->to_world, grid.resolution, grid.points, grid.border);
      h.array(grid.values);
      if (grid.is_colored()) {
        h.array(grid.absorption);
        h.array(grid.scattering);
      }
    }
    return h.result();
  }
  std::uint64_t hash_mesh(const Mesh& mesh) {
    const auto known = meshes_.find(&mesh);
    if (known != meshes_.end()) return known->second;
    Hasher h;
    h.array(mesh.positions);
    h.array(mesh.normals);
    h.array(mesh.tangents);
    h.array(mesh.handedness);
    h.array(mesh.uvs);
    h.array(mesh.indices);
    return meshes_[&mesh] = h.result();
  }

  void hash_shape(Hasher& h, const Shape& shape) {
    node(h, shape.node);
    h.add(shape.to_world, shape.reverse_orientation);
    material(h, shape.material);
    textures(h, shape.alpha, shape.shadow_alpha);
    if (shape.alpha_counted) h.word(1);
    h.add(shape.emission.has_value());
    if (shape.emission) node(h, shape.emission->node);
    h.add(shape.has_medium_interface);
    if (shape.has_medium_interface) {
      medium(h, shape.inside);
      medium(h, shape.outside);
    }
  }
  void hash_light(Hasher& h, const Light& light) {
    h.add(light.to_world);
    node(h, light.node);
    medium(h, light.medium);
  }
  void hash_camera(Hasher& h) {
    h.add(scene_.camera.to_world);
    variant(h, scene_.camera.node);
    medium(h, scene_.camera.medium);
    if (scene_.camera.hides_lights) h.word(1);
  }
  void hash_film(Hasher& h) {
    const Film& film = scene_.film;
    h.add(film.resolution, film.scale, film.filter.radius);
    for (const float edge : film.crop) h.add(edge);
    variant(h, film.filter.node);
  }

  const SceneDesc& scene_;
  std::vector<std::uint64_t> textures_, materials_, media_;
  std::map<const Mesh*, std::uint64_t> meshes_;
};

}  // namespace

std::uint64_t hash(const SceneDesc& scene) { return SceneHasher(scene).run(); }

}  // namespace ajar::desc
