#include "path/manifold_walk.h"

#include <algorithm>
#include <cmath>

#include "path/heuristics.h"

namespace ajar {

namespace {

/// Numbers by which rays cross every medium: the way is given, and scattering on it is no choice.
class Unscattered final : public SampleSource {
 public:
  float get(SampleAddress /*address*/) override { return 1.F; }
  Vec2 get_pair(SampleAddress /*address*/) override { return Vec2(1.F); }
};

}  // namespace

double way_in(const Scene& scene, const ChainEnd& start, const Vec3d& place) {
  const Vec3d toward = start.at_infinity ? start.toward : (start.p - place).normalized();
  const BoundingSphere& sphere = scene.bounding_sphere();
  const double beyond_all =
      (Vec3d(sphere.center) - place).dot(toward) + 1.001 * double{sphere.radius};
  return start.at_infinity ? beyond_all : std::min(beyond_all, (start.p - place).length());
}

ChainStart chain_start(const Light& light, const EndpointPoint& point) {
  if (light.at_infinity()) {
    return {{Vec3d(0.0), Vec3d(point.toward), true}, nullptr, point.surface.ng, light.medium};
  }
  return {{Vec3d(point.surface.p), Vec3d(0.0), false}, nullptr, point.surface.ng, light.medium};
}

ChainStart chain_start(const Path& path, int x) {
  if (x == 0) return chain_start(*path.light, path.light_point);
  return {chain_end(path, x), &path.vertex(x), Vec3(0.F), nullptr};
}

std::optional<Vec3d> ManifoldWalk::onward(const InnerVertex& vertex, std::size_t i,
                                          const Vec3d& back) const {
  if (!vertex.event.specular()) {
    return offsets_.empty() ? std::nullopt
                            : turn(vertex, vertex.event.transmission, offsets_[i], back);
  }
  const auto sample = vertex.bsdf.specular(Vec3(back), vertex.event, TransportMode::Radiance);
  return sample ? std::optional(Vec3d(sample->wi)) : std::nullopt;
}

void ManifoldWalk::leave(const ChainStart& start, const Vec3d& through) {
  traced_.clear();
  const ChainEnd& end = start.end;
  const Vec3d toward = end.at_infinity ? end.toward : (end.p - through).normalized();
  const Vec3 w(-toward);
  medium_ = start.vertex != nullptr ? start.vertex->medium_toward(w) : start.medium;
  const double way = way_in(scene_, end, through);
  if (end.at_infinity || way < (end.p - through).length()) {
    ray_ = {Vec3(through + toward * way), w};
    return;
  }
  ray_.origin = start.vertex != nullptr ? start.vertex->ray_origin(w)
                                        : offset_ray_origin(Vec3(end.p), start.ng, w);
  // Rays set off beside the start: parallel ones would miss the place by as much, at every step.
  ray_.direction = Vec3((through - Vec3d(ray_.origin)).normalized());
}

void ManifoldWalk::leave(const Vec3& direction) {
  const InnerVertex& vertex = traced_.back();
  ray_ = {vertex.ray_origin(direction), direction};
  medium_ = vertex.medium_toward(direction);
}

InnerVertex* ManifoldWalk::arrive() {
  Unscattered numbers;
  const SegmentEnd end =
      trace_segment(scene_, ray_, medium_, kAnyLane, {numbers, Stream::Light, 0, 0}, rays_);
  if (!end.hit) return nullptr;
  InnerVertex& vertex = traced_.emplace_back();
  vertex.hit = *end.hit;
  vertex.medium = end.medium;
  vertex.hit.material->bsdf(vertex.hit.point, vertex.bsdf);
  return &vertex;
}

bool ManifoldWalk::trace(const ChainStart& start, const Vec3d& through,
                         std::span<const InnerVertex> events) {
  leave(start, through);
  for (std::size_t i = 0; i < events.size(); ++i) {
    InnerVertex* const vertex = arrive();
    if (vertex == nullptr) return false;
    vertex->event = events[i].event;
    if (i + 1 == events.size()) break;
    const auto way = onward(*vertex, i, Vec3d(-ray_.direction));
    if (!way) return false;
    leave(Vec3(*way));
  }
  return true;
}

bool ManifoldWalk::set_off(const ChainStart& start, const Vec3d& through, int most,
                           SampleSource& source) {
  leave(start, through);
  vertices_.clear();
  landing_.reset();
  for (int i = 0; i <= most; ++i) {
    InnerVertex* const vertex = arrive();
    if (vertex == nullptr) break;
    const auto address = [&](Slot slot) { return SampleAddress(Stream::Light, i + 1, slot); };
    const auto sample = vertex->bsdf.sample(
        -ray_.direction,
        {source.get(address(Slot::BsdfLobe)), source.get_pair(address(Slot::BsdfDirectionX))},
        TransportMode::Importance, Reverse::Skip);
    if (!sample || !sample->event().specular()) {
      landing_ = vertex->p();
      break;
    }
    if (i == most) break;
    vertex->event = sample->event();
    vertices_.push_back(*vertex);
    leave(sample->wi);
  }
  return !vertices_.empty();
}

bool ManifoldWalk::measure(const ChainStart& start, std::span<const InnerVertex> vertices,
                           const Vec3d& target) {
  const InnerVertex& last = vertices.back();
  const Vec3d p(last.p());
  Vec3d back = start.end.toward;
  if (vertices.size() > 1) {
    back = (Vec3d(vertices[vertices.size() - 2].p()) - p).normalized();
  } else if (!start.end.at_infinity) {
    back = (start.end.p - p).normalized();
  }
  const auto way = onward(last, vertices.size() - 1, back);
  if (!way) return false;
  const Vec3d w = way->normalized();
  const double ahead = (target - p).dot(w);
  if (!(ahead > 0.0)) return false;
  miss_ = target - p - w * ahead;
  length_ = ahead;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    length_ += (Vec3d(vertices[i].p()) - Vec3d(vertices[i - 1].p())).length();
  }
  if (!start.end.at_infinity) length_ += way_in(scene_, start.end, Vec3d(vertices.front().p()));
  return true;
}

bool ManifoldWalk::walk(const ChainStart& start, std::span<const InnerVertex> vertices,
                        const Vec3& target, std::span<const OffsetNormal> offsets) {
  const Vec3d goal(target);
  offsets_ = offsets;
  vertices_.assign(vertices.begin(), vertices.end());
  if (vertices_.empty()) return false;
  if (!offsets_.empty()) {
    if (!trace(start, Vec3d(vertices_.front().p()), vertices)) return false;
    std::swap(vertices_, traced_);
  }
  if (!measure(start, vertices_, goal)) return false;
  double step = 1.0;
  bool moved = true;
  for (int i = 0; i < PathHeuristics::kMostWalkSteps; ++i) {
    if (moved && !linear_.set(start.end, vertices_, {goal - miss_, Vec3d(0.0), false}, offsets_)) {
      return false;
    }
    const double tolerance = PathHeuristics::kWalkTolerance * length_;
    const Vec3d miss = miss_;
    const double length = length_;
    if (miss.length() <= tolerance) {
      uncertainty_ = tolerance * linear_.largest_move();
      return true;
    }
    const Vec3d through = Vec3d(vertices_.front().p()) + linear_.moved(0, miss) * step;
    moved = trace(start, through, vertices_) && measure(start, traced_, goal) &&
            miss_.length() < miss.length();
    if (moved) {
      std::swap(vertices_, traced_);
      step = std::min(1.0, 2.0 * step);
    } else {
      miss_ = miss;
      length_ = length;
      step *= 0.5;
    }
  }
  return false;
}

}  // namespace ajar
