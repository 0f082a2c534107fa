#include "import/gltf/pose.h"

#include <algorithm>
#include <cmath>

namespace ajar::gltf {
namespace {

constexpr WarningKind kUnbound{
    Effect::Geometry, "meshes are not bound to their skeletons, and are shown as they are"};
constexpr WarningKind kMorphs{Effect::Surface,
                              "morph targets change colours or texture coordinates: ignored"};

/// A weighted sum of transforms, and of those of normals; the latter exists for transforms that
/// flatten the mesh, too.
struct Blend {
  Mat4 matrix =
      Mat4(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
  double weight = 0.0;

  void add(const Mat4& joint, double w) {
    matrix += joint * w;
    weight += w;
  }
  Mat4 mean() const { return matrix * (1.0 / weight); }
};

/// By the cofactors: they are the inverse transpose times the determinant, of which the sign
/// counts.
Vec3 turned_normal(const Mat4& m, const Vec3& normal) {
  const Vec3d x(m[0][0], m[0][1], m[0][2]);
  const Vec3d y(m[1][0], m[1][1], m[1][2]);
  const Vec3d z(m[2][0], m[2][1], m[2][2]);
  const double sign = x.dot(y.cross(z)) < 0.0 ? -1.0 : 1.0;
  const Vec3d n(normal);
  return Vec3((y.cross(z) * n.x + z.cross(x) * n.y + x.cross(y) * n.z) * sign);
}

void check_count(const Element& place, std::size_t count, std::size_t vertices) {
  if (count == vertices) return;
  place.fail("there are " + std::to_string(count) + " values for " + std::to_string(vertices) +
             " vertices");
}

void add_displacements(const Element& target, const char* attribute, double weight,
                       Accessors& accessors, std::vector<Vec3>& values) {
  const std::optional<Element> reference = target.find(attribute);
  if (!reference || values.empty()) return;
  const std::vector<Vec3> displacements = accessors.read_vec3(accessors.index_of(*reference));
  check_count(*reference, displacements.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] += displacements[i] * static_cast<float>(weight);
  }
}

void morph(const std::vector<double>& weights, const Element& primitive, Context& context,
           Accessors& accessors, desc::Mesh& mesh) {
  const std::vector<Element> targets = primitive.items("targets");
  for (std::size_t t = 0; t < std::min(weights.size(), targets.size()); ++t) {
    if (weights[t] == 0.0) continue;
    const Element& target = targets[t];
    add_displacements(target, "POSITION", weights[t], accessors, mesh.positions);
    add_displacements(target, "NORMAL", weights[t], accessors, mesh.normals);
    add_displacements(target, "TANGENT", weights[t], accessors, mesh.tangents);
    for (const auto& [name, key, value] : target.members()) {
      if (!name.starts_with("TEXCOORD_") && !name.starts_with("COLOR_")) continue;
      context.warnings.add(kMorphs, target.where(),
                           "this target changes colours or texture coordinates, which is ignored");
      break;
    }
  }
}

/// The sum of its joints' transforms that each vertex has.
std::vector<Blend> blends_of(const std::vector<Mat4>& joints, const Element& attributes,
                             Accessors& accessors, std::size_t vertices) {
  std::vector<Blend> blends(vertices);
  for (std::size_t set = 0;; ++set) {
    const std::optional<Element> numbers = attributes.find("JOINTS_" + std::to_string(set));
    const std::optional<Element> shares = attributes.find("WEIGHTS_" + std::to_string(set));
    if (!numbers || !shares) break;
    const std::vector<Imath::V4f> of = accessors.read_vec4(accessors.index_of(*numbers));
    const std::vector<Imath::V4f> weights = accessors.read_vec4(accessors.index_of(*shares));
    check_count(*numbers, of.size(), vertices);
    check_count(*shares, weights.size(), vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
      for (int lane = 0; lane < 4; ++lane) {
        const auto weight = static_cast<double>(weights[i][lane]);
        if (!(weight > 0.0)) continue;
        const float joint = of[i][lane];
        if (!(joint >= 0.F && joint < static_cast<float>(joints.size()))) {
          numbers->fail("vertex " + std::to_string(i) + " is bound to a joint that its skin, of " +
                        std::to_string(joints.size()) + ", does not have");
        }
        blends[i].add(joints[static_cast<std::size_t>(joint)], weight);
      }
    }
  }
  return blends;
}

void bend(const std::vector<Mat4>& joints, const Element& primitive, Context& context,
          Accessors& accessors, desc::Mesh& mesh) {
  const Element attributes = primitive.at("attributes");
  if (!attributes.has("JOINTS_0") || !attributes.has("WEIGHTS_0")) {
    context.warnings.add(kUnbound, primitive.where(),
                         "this primitive has a skin, but not both JOINTS_0 and WEIGHTS_0: it is "
                         "shown as it is");
    return;
  }
  const std::vector<Blend> blends = blends_of(joints, attributes, accessors, mesh.positions.size());
  for (std::size_t i = 0; i < blends.size(); ++i) {
    if (!(blends[i].weight > 0.0)) continue;
    const Mat4 to_world = blends[i].mean();
    mesh.positions[i] = transform_point(to_world, mesh.positions[i]);
    if (i < mesh.normals.size()) mesh.normals[i] = turned_normal(to_world, mesh.normals[i]);
    if (i < mesh.tangents.size()) mesh.tangents[i] = transform_vector(to_world, mesh.tangents[i]);
  }
}

}  // namespace

Poses::Poses(Context& context, Accessors& accessors, const std::vector<PlacedNode>& nodes)
    : context_(context), accessors_(accessors) {
  for (const PlacedNode& placed : nodes) places_.emplace(placed.node.pointer(), placed.to_world);
}

Pose Poses::of(const PlacedNode& placed, const Element& mesh) {
  Pose pose;
  const bool has_own = placed.node.has("weights");
  pose.weights = weights_of(has_own ? placed.node : mesh);
  if (pose.weights != nullptr) pose.name = has_own ? placed.node.pointer() : "/weights";
  if (const std::optional<Element> reference = placed.node.find("skin")) {
    const Element skin = referred(*reference, context_.document.root, "skins");
    pose.joints = joints_of(skin);
    if (pose.joints != nullptr) pose.name += skin.pointer();
  }
  return pose;
}

const std::vector<double>* Poses::weights_of(const Element& holder) {
  const auto [place, is_new] = weights_.try_emplace(holder.pointer());
  std::vector<double>& weights = place->second;
  if (is_new) {
    for (const Element& weight : holder.items("weights")) weights.push_back(weight.number());
    if (std::all_of(weights.begin(), weights.end(), [](double w) { return w == 0.0; })) {
      weights.clear();
    }
  }
  return weights.empty() ? nullptr : &weights;
}

const std::vector<Mat4>* Poses::joints_of(const Element& skin) {
  const auto [place, is_new] = skins_.try_emplace(skin.pointer());
  if (is_new) place->second = read_joints(skin);
  return place->second.empty() ? nullptr : &place->second;
}

std::vector<Mat4> Poses::read_joints(const Element& skin) {
  const Element root = context_.document.root;
  const std::vector<Element> joints = skin.items("joints");
  std::vector<Mat4> inverse_binds(joints.size());
  if (const std::optional<Element> reference = skin.find("inverseBindMatrices")) {
    const std::vector<Imath::M44f> read = accessors_.read_matrices(accessors_.index_of(*reference));
    if (read.size() < joints.size()) {
      reference->fail("there are " + std::to_string(read.size()) + " matrices for " +
                      std::to_string(joints.size()) + " joints");
    }
    for (std::size_t i = 0; i < joints.size(); ++i) inverse_binds[i] = Mat4(read[i]);
  }
  std::vector<Mat4> transforms;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto place = places_.find(referred(joints[i], root, "nodes").pointer());
    if (place == places_.end()) {
      context_.warnings.add(kUnbound, joints[i].where(),
                            "this joint is not in the scene: meshes of this skin are shown as they "
                            "were bound to it");
      return {};
    }
    transforms.push_back(inverse_binds[i] * place->second);
  }
  return transforms;
}

void apply(const Pose& pose, const Element& primitive, Context& context, Accessors& accessors,
           desc::Mesh& mesh) {
  if (pose.weights != nullptr) morph(*pose.weights, primitive, context, accessors, mesh);
  if (pose.joints != nullptr) bend(*pose.joints, primitive, context, accessors, mesh);
}

}  // namespace ajar::gltf
