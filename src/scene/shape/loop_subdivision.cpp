#include "scene/shape/loop_subdivision.h"

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <unordered_map>

namespace ajar {

namespace {

constexpr WarningKind kNotSubdivided{
    Effect::Geometry, "control meshes are not oriented manifolds, and not subdivided"};
constexpr WarningKind kStopped{Effect::Slight,
                               "subdivision surfaces have fewer levels than they should"};

constexpr int kNoEdge = -1;
/// More triangles than this are surely a mistake in the number of levels.
constexpr std::size_t kMaxTriangles = std::size_t{1} << 27;

/// Half edge h = 3 f + k runs from corner k of face f to its next corner.
int next_in_face(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
int previous_in_face(int h) { return h % 3 == 0 ? h + 2 : h - 1; }

/// A triangle mesh with neighbourhoods.
class ControlMesh {
 public:
  ControlMesh(std::vector<Vec3d> points, std::vector<int> corners, std::vector<int> opposite)
      : points_(std::move(points)), corners_(std::move(corners)), opposite_(std::move(opposite)) {
    outgoing_.assign(points_.size(), kNoEdge);
    for (int h = 0; h < static_cast<int>(corners_.size()); ++h) outgoing_[at(corners_[at(h)])] = h;
    for (int& h : outgoing_) h = first_in_ring(h);
  }

  ControlMesh refined() const;
  desc::Mesh limit() const;

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  int origin(int h) const { return corners_[at(h)]; }
  bool on_boundary(int vertex) const { return opposite_[at(outgoing_[at(vertex)])] == kNoEdge; }

  /// The half edge that starts the fan around its origin: clockwise of it there is nothing (or all
  /// of it).
  int first_in_ring(int start) const {
    if (start == kNoEdge) return kNoEdge;
    int h = start;
    do {
      const int across = opposite_[at(h)];
      if (across == kNoEdge) return h;
      h = next_in_face(across);
    } while (h != start);
    return h;
  }
  /// Neighbours of a vertex, counterclockwise; from end to end at a boundary.
  void ring(int vertex, std::vector<int>& neighbours) const {
    neighbours.clear();
    const int start = outgoing_[at(vertex)];
    int h = start;
    do {
      neighbours.push_back(origin(next_in_face(h)));
      const int back = previous_in_face(h);
      h = opposite_[at(back)];
      if (h == kNoEdge) neighbours.push_back(origin(back));
    } while (h != kNoEdge && h != start);
  }
  Vec3d weighted(int vertex, const std::vector<int>& neighbours, double weight) const {
    Vec3d sum(0.0);
    for (const int i : neighbours) sum += points_[at(i)];
    return points_[at(vertex)] * (1.0 - static_cast<double>(neighbours.size()) * weight) +
           sum * weight;
  }
  Vec3d weighted_boundary(int vertex, const std::vector<int>& neighbours, double weight) const {
    return points_[at(vertex)] * (1.0 - 2.0 * weight) +
           (points_[at(neighbours.front())] + points_[at(neighbours.back())]) * weight;
  }
  Vec3d limit_normal(int vertex, const std::vector<int>& neighbours) const;

  std::vector<Vec3d> points_;
  std::vector<int> corners_;
  std::vector<int> opposite_;
  std::vector<int> outgoing_;
};

/// Weight of a neighbour in Warren's simplification of Loop's rule.
double beta(std::size_t valence) {
  return valence == 3 ? 3.0 / 16.0 : 3.0 / (8.0 * static_cast<double>(valence));
}

ControlMesh ControlMesh::refined() const {
  const int faces = static_cast<int>(corners_.size() / 3);
  std::vector<Vec3d> points(points_.size());
  std::vector<int> neighbours;
  for (int v = 0; v < static_cast<int>(points_.size()); ++v) {
    if (outgoing_[at(v)] == kNoEdge) {
      points[at(v)] = points_[at(v)];
      continue;
    }
    ring(v, neighbours);
    points[at(v)] = on_boundary(v) ? weighted_boundary(v, neighbours, 1.0 / 8.0)
                                   : weighted(v, neighbours, beta(neighbours.size()));
  }
  std::vector<int> middle(corners_.size());
  for (int h = 0; h < 3 * faces; ++h) {
    const int across = opposite_[at(h)];
    if (across != kNoEdge && across < h) {
      middle[at(h)] = middle[at(across)];
      continue;
    }
    const Vec3d ends = points_[at(origin(h))] + points_[at(origin(next_in_face(h)))];
    middle[at(h)] = static_cast<int>(points.size());
    points.push_back(across == kNoEdge
                         ? ends * 0.5
                         : ends * (3.0 / 8.0) + (points_[at(origin(previous_in_face(h)))] +
                                                 points_[at(origin(previous_in_face(across)))]) *
                                                    (1.0 / 8.0));
  }
  // Face f becomes the corner faces 4f + k = (v_k, m_k, m_{k+2}) and the centre 4f + 3 = (m_0, m_1,
  // m_2).
  std::vector<int> corners(4 * corners_.size());
  std::vector<int> opposite(4 * corners_.size());
  for (int f = 0; f < faces; ++f) {
    const int center = 3 * (4 * f + 3);
    for (int k = 0; k < 3; ++k) {
      const int h = 3 * f + k;
      const int before = previous_in_face(h);
      const int child = 3 * (4 * f + k);
      corners[at(child)] = origin(h);
      corners[at(child + 1)] = middle[at(h)];
      corners[at(child + 2)] = middle[at(before)];
      corners[at(center + k)] = middle[at(h)];
      opposite[at(child + 1)] = center + (k + 2) % 3;
      opposite[at(center + (k + 2) % 3)] = child + 1;
      const int across = opposite_[at(h)];
      const int across_before = opposite_[at(before)];
      opposite[at(child)] =
          across == kNoEdge ? kNoEdge : 3 * (4 * (across / 3) + (across % 3 + 1) % 3) + 2;
      opposite[at(child + 2)] =
          across_before == kNoEdge ? kNoEdge : 3 * (4 * (across_before / 3) + across_before % 3);
    }
  }
  return {std::move(points), std::move(corners), std::move(opposite)};
}

Vec3d ControlMesh::limit_normal(int vertex, const std::vector<int>& neighbours) const {
  const auto n = static_cast<int>(neighbours.size());
  const auto ring_point = [&](int i) { return points_[at(neighbours[at(i)])]; };
  const Vec3d& center = points_[at(vertex)];
  Vec3d s(0.0);
  Vec3d t(0.0);
  if (!on_boundary(vertex)) {
    for (int i = 0; i < n; ++i) {
      s += ring_point(i) * std::cos(2.0 * std::numbers::pi * i / n);
      t += ring_point(i) * std::sin(2.0 * std::numbers::pi * i / n);
    }
    return t.cross(s);
  }
  s = ring_point(n - 1) - ring_point(0);
  if (n == 2) {
    t = ring_point(0) + ring_point(1) - center * 2.0;
  } else if (n == 3) {
    t = ring_point(1) - center;
  } else if (n == 4) {
    t = (ring_point(1) + ring_point(2) - center) * 2.0 - ring_point(0) - ring_point(3);
  } else {
    const double theta = std::numbers::pi / (n - 1);
    t = (ring_point(0) + ring_point(n - 1)) * -std::sin(theta);
    for (int i = 1; i < n - 1; ++i) {
      t += ring_point(i) * ((2.0 - 2.0 * std::cos(theta)) * std::sin(i * theta));
    }
  }
  return s.cross(t);
}

desc::Mesh ControlMesh::limit() const {
  desc::Mesh mesh;
  mesh.positions.reserve(points_.size() + 1);
  mesh.normals.reserve(points_.size());
  std::vector<int> neighbours;
  for (int v = 0; v < static_cast<int>(points_.size()); ++v) {
    if (outgoing_[at(v)] == kNoEdge) {
      mesh.positions.emplace_back(points_[at(v)]);
      mesh.normals.emplace_back(0.F);
      continue;
    }
    ring(v, neighbours);
    const auto valence = static_cast<double>(neighbours.size());
    const double gamma = 1.0 / (valence + 3.0 / (8.0 * beta(neighbours.size())));
    mesh.positions.emplace_back(on_boundary(v) ? weighted_boundary(v, neighbours, 1.0 / 5.0)
                                               : weighted(v, neighbours, gamma));
    mesh.normals.emplace_back(limit_normal(v, neighbours).normalized());
  }
  for (std::size_t i = 0; i < corners_.size(); i += 3) {
    mesh.indices.emplace_back(static_cast<unsigned>(corners_[i]),
                              static_cast<unsigned>(corners_[i + 1]),
                              static_cast<unsigned>(corners_[i + 2]));
  }
  return mesh;
}

/// Pairs of half edges; empty if an edge has more than two faces or two of the same direction.
std::vector<int> find_opposites(const std::vector<int>& corners) {
  std::unordered_map<std::uint64_t, int> by_ends;
  by_ends.reserve(corners.size());
  const auto key = [](int from, int to) {
    return (static_cast<std::uint64_t>(from) << 32U) | static_cast<std::uint32_t>(to);
  };
  const int count = static_cast<int>(corners.size());
  const auto origin = [&](int h) { return corners[static_cast<std::size_t>(h)]; };
  for (int h = 0; h < count; ++h) {
    const int from = origin(h);
    const int to = origin(next_in_face(h));
    if (from == to || !by_ends.emplace(key(from, to), h).second) return {};
  }
  std::vector<int> opposite(corners.size(), kNoEdge);
  for (int h = 0; h < count; ++h) {
    const auto found = by_ends.find(key(origin(next_in_face(h)), origin(h)));
    if (found != by_ends.end()) opposite[static_cast<std::size_t>(h)] = found->second;
  }
  return opposite;
}

}  // namespace

int possible_levels(const desc::Mesh& control, int wanted) {
  int level = 0;
  std::size_t triangles = control.indices.size();
  while (level < wanted && triangles > 0 && 4 * triangles <= kMaxTriangles) {
    triangles *= 4;
    ++level;
  }
  return level;
}

std::shared_ptr<const desc::Mesh> subdivide(const desc::Mesh& control, int levels,
                                            const SourceLocation& where, Warnings& warnings) {
  std::vector<int> corners;
  for (const auto& triangle : control.indices) {
    for (int k = 0; k < 3; ++k) {
      if (triangle[k] >= control.positions.size()) {
        throw SceneError(where, "a face of the subdivision surface uses vertex " +
                                    std::to_string(triangle[k]) + ", but there are only " +
                                    std::to_string(control.positions.size()));
      }
      corners.push_back(static_cast<int>(triangle[k]));
    }
  }
  std::vector<int> opposite = find_opposites(corners);
  if (opposite.empty()) {
    if (!corners.empty()) {
      warnings.add(kNotSubdivided, where,
                   "the control mesh is not an oriented manifold; it is not subdivided");
    }
    return std::make_shared<desc::Mesh>(control);
  }
  std::vector<Vec3d> points(control.positions.begin(), control.positions.end());
  ControlMesh mesh(std::move(points), std::move(corners), std::move(opposite));
  const int possible = possible_levels(control, levels);
  if (possible < levels) {
    warnings.add(kStopped, where,
                 "subdivision stopped after " + std::to_string(possible) + " levels");
  }
  for (int level = 0; level < possible; ++level) mesh = mesh.refined();
  return std::make_shared<desc::Mesh>(mesh.limit());
}

}  // namespace ajar
