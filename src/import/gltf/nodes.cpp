#include "import/gltf/nodes.h"

#include <ImathQuat.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ajar::gltf {
namespace {

/// Columns of glTF are the rows of Imath, which multiplies vectors from the left.
Mat4 matrix_of(const std::array<double, 16>& numbers) {
  Mat4 matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      matrix[row][column] = numbers[static_cast<std::size_t>(4 * row + column)];
    }
  }
  return matrix;
}

/// Rotation of a quaternion; identity for 0.
Mat4 rotation_of(double x, double y, double z, double w) {
  const Imath::Quatd rotation(w, x, y, z);
  return rotation.length() > 0.0 ? rotation.normalized().toMatrix44() : Mat4();
}

/// Scale, then rotation, then translation (glTF 2.0, section 3.5.3).
Mat4 local_transform(const Element& node) {
  if (const auto numbers = node.find<std::array<double, 16>>("matrix")) return matrix_of(*numbers);
  Mat4 matrix;
  if (const auto s = node.find<std::array<double, 3>>("scale")) {
    matrix.setScale(Vec3d((*s)[0], (*s)[1], (*s)[2]));
  }
  if (const auto r = node.find<std::array<double, 4>>("rotation")) {
    matrix = matrix * rotation_of((*r)[0], (*r)[1], (*r)[2], (*r)[3]);
  }
  if (const auto t = node.find<std::array<double, 3>>("translation")) {
    matrix[3][0] = (*t)[0];
    matrix[3][1] = (*t)[1];
    matrix[3][2] = (*t)[2];
  }
  return matrix;
}

bool says_visible(const Element& node) {
  const std::optional<Element> visibility = extension_of(node, "KHR_node_visibility");
  return !visibility || visibility->value_or("visible", true);
}

class Forest {
 public:
  explicit Forest(const Element& root)
      : root_(root), nodes_(root.items("nodes")), is_placed_(nodes_.size()) {}

  std::vector<PlacedNode> place() {
    for (const std::size_t i : roots()) waiting_.push_back({i, Mat4(), true});
    std::reverse(waiting_.begin(), waiting_.end());
    while (!waiting_.empty()) {
      const auto [i, parent, parent_is_visible] = waiting_.back();
      waiting_.pop_back();
      if (is_placed_[i]) {
        nodes_[i].fail(
            "this node is reached in two ways, or is its own ancestor: nodes must be "
            "trees");
      }
      is_placed_[i] = true;
      const Mat4 to_world = local_transform(nodes_[i]) * parent;
      const bool is_visible = parent_is_visible && says_visible(nodes_[i]);
      placed_.push_back({nodes_[i], to_world, is_visible});
      const std::vector<Element> children = nodes_[i].items("children");
      for (auto child = children.rbegin(); child != children.rend(); ++child) {
        waiting_.push_back({child->index(nodes_.size()), to_world, is_visible});
      }
    }
    return std::move(placed_);
  }

 private:
  /// Roots of the scene that is shown; without scenes, all nodes without a parent.
  std::vector<std::size_t> roots() const {
    std::vector<std::size_t> roots;
    const std::vector<Element> scenes = root_.items("scenes");
    if (!scenes.empty()) {
      const std::size_t shown = root_.find_index("scene", scenes.size()).value_or(0);
      for (const Element& node : scenes[shown].items("nodes")) {
        roots.push_back(node.index(nodes_.size()));
      }
      return roots;
    }
    std::vector<bool> is_child(nodes_.size());
    for (const Element& node : nodes_) {
      for (const Element& child : node.items("children")) {
        is_child[child.index(nodes_.size())] = true;
      }
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!is_child[i]) roots.push_back(i);
    }
    return roots;
  }

  struct Waiting {
    std::size_t node;
    Mat4 parent;
    bool parent_is_visible;
  };
  Element root_;
  std::vector<Element> nodes_;
  std::vector<bool> is_placed_;
  std::vector<Waiting> waiting_;
  std::vector<PlacedNode> placed_;
};

}  // namespace

std::vector<PlacedNode> place_nodes(const Element& root) { return Forest(root).place(); }

std::vector<Mat4> places_of_mesh(const PlacedNode& placed, Accessors& accessors) {
  const std::optional<Element> extension = extension_of(placed.node, "EXT_mesh_gpu_instancing");
  if (!extension) return {placed.to_world};
  const Element attributes = extension->at("attributes");
  std::vector<Mat4> places;
  // In the order in which they are applied.
  for (const char* name : {"SCALE", "ROTATION", "TRANSLATION"}) {
    const std::optional<Element> reference = attributes.find(name);
    if (!reference) continue;
    const std::size_t accessor = accessors.index_of(*reference);
    const bool is_rotation = std::string_view(name) == "ROTATION";
    std::vector<Mat4> steps;
    if (is_rotation) {
      for (const Imath::V4f& r : accessors.read_vec4(accessor)) {
        steps.push_back(rotation_of(r.x, r.y, r.z, r.w));
      }
    } else {
      for (const Vec3& v : accessors.read_vec3(accessor)) {
        Mat4& step = steps.emplace_back();
        if (std::string_view(name) == "SCALE") {
          step.setScale(Vec3d(v));
        } else {
          step.setTranslation(Vec3d(v));
        }
      }
    }
    if (places.empty()) places.resize(steps.size());
    if (places.size() != steps.size()) {
      reference->fail("there are " + std::to_string(steps.size()) + " values for " +
                      std::to_string(places.size()) + " instances");
    }
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = places[i] * steps[i];
  }
  for (Mat4& place : places) place = place * placed.to_world;
  return places;
}

Mat4 without_scale(const Mat4& to_world) {
  const auto axis = [&](int i) { return Vec3d(to_world[i][0], to_world[i][1], to_world[i][2]); };
  const Vec3d z = axis(2).normalized();
  const Vec3d y = (axis(1) - z * axis(1).dot(z)).normalized();
  const Vec3d axes[3] = {y.cross(z), y, z};
  constexpr double kRounding = 1e-6;
  double change = 0.0;
  for (int i = 0; i < 3; ++i) {
    if (!(axes[i].length2() > 0.5)) return to_world;
    change = std::max(change, (axes[i] - axis(i)).length());
  }
  if (change < kRounding) return to_world;
  Mat4 rigid = to_world;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) rigid[i][j] = axes[i][j];
  }
  return rigid;
}

Mat4 turned_around(const Mat4& to_world) {
  Mat4 mirror;
  mirror.setScale(Vec3d(1.0, 1.0, -1.0));
  return mirror * to_world;
}

}  // namespace ajar::gltf
