#include "path/recorder.h"

#include "path/verify.h"
#include "path/visibility.h"

namespace ajar {

void PathRecorder::begin(const Vec2& raster) {
  raster_ = raster;
  light_count_ = 0;
}

void PathRecorder::started(Stream stream, const Endpoint& endpoint, const EndpointPoint& point) {
  if (stream == Stream::Light) ++light_count_;
  Subpath& subpath = current(stream);
  subpath.endpoint = &endpoint;
  subpath.point = point;
  subpath.vertices.clear();
}

void PathRecorder::vertex(Stream stream, const PathVertex& vertex, const Hit* hit) {
  InnerVertex& to = current(stream).vertices.emplace_back();
  to.hit = hit != nullptr ? *hit : bare_hit(vertex.p);
  to.medium = vertex.medium;
  to.in_medium = vertex.in_medium;
  if (!vertex.in_medium) to.bsdf = vertex.bsdf;
}

void PathRecorder::scattered(Stream stream, const PathVertex& /*vertex*/, const Flight& flight) {
  current(stream).vertices.back().event = flight.event;
}

void PathRecorder::add(const Contribution& contribution) {
  if (!wants(contribution)) return;
  assemble(contribution);
  if (!look_along_all(scene_, path_, rays_)) {
    ++lost_;
    return;
  }
#ifndef NDEBUG
  verify(scene_, settings_, path_, contribution);
#endif
  record(path_, contribution);
}

void PathRecorder::assemble(const Contribution& contribution) {
  const auto [s, t] = contribution.technique;
  const Subpath* light =
      s >= 2 ? &light_[static_cast<std::size_t>(contribution.light_subpath)] : nullptr;
  path_.light = light != nullptr ? static_cast<const Light*>(light->endpoint) : contribution.light;
  path_.light_point = light != nullptr ? light->point : *contribution.light_point;
  path_.camera_point = t >= 2 ? camera_.point : *contribution.camera_point;
  path_.raster = t >= 2 ? raster_ : contribution.raster;

  path_.vertices.clear();
  if (light != nullptr) {
    path_.vertices.insert(path_.vertices.end(), light->vertices.begin(),
                          light->vertices.begin() + (s - 1));
  }
  // The last camera vertex of technique (0, t) is the light.
  const int of_camera = s == 0 ? t - 2 : t - 1;
  for (int i = of_camera - 1; i >= 0; --i) {
    path_.vertices.push_back(camera_.vertices[static_cast<std::size_t>(i)]);
  }
  // The connection scatters at both of its ends by all rough lobes, however the subpath went on.
  for (const int x : {s - 1, s}) {
    if (s > 0 && x >= 1 && x < path_.depth()) {
      path_.vertices[static_cast<std::size_t>(x - 1)].event = {};
    }
  }
  mark_sides(scene_, path_);
}

}  // namespace ajar
