#include "transport/path_sampler.h"

namespace ajar {

namespace {
class Nobody final : public PathSink {
 public:
  void add(const Contribution& /*contribution*/) override {}
};

template <typename Work>
auto observe(PathSink* observer, const Work& work) {
  if (observer != nullptr) return work(*observer);
  Nobody nobody;
  return work(nobody);
}
}  // namespace

template <typename Observer>
bool PathSampler::light_half(SampleSource& source, int vertices, PathVertex& end,
                             Observer& observer) {
  LightStart start;
  if (!start_light(source, 0, observer, start)) return false;
  while (true) {
    if (!next_light_vertex(start, source, observer, end)) return false;
    if (end.edges == vertices - 1) return end.connectible();
    if (!scatter(light_walk_, end, source, start.flight)) return false;
    observer.scattered(Stream::Light, end, start.flight);
  }
}

template <typename Observer>
bool PathSampler::camera_half(SampleSource& source, const Vec2& raster, int vertices,
                              PathVertex& end, Observer& observer) {
  Flight flight;
  if (!start_camera(source, raster, observer, flight)) return false;
  while (true) {
    const SegmentEnd segment = trace(camera_walk_, flight, source);
    if (!segment.hit && !segment.scattered) return false;
    arrive(camera_walk_, flight, segment, camera_side_coefficient(flight.edges + 1), end);
    if (end.throughput.is_black()) return false;
    observer.vertex(Stream::Camera, end, segment.hit ? &*segment.hit : nullptr);
    if (end.edges == vertices - 1) return end.connectible();
    if (!scatter(camera_walk_, end, source, flight)) return false;
    observer.scattered(Stream::Camera, end, flight);
  }
}

template <typename Observer>
void PathSampler::implicit(SampleSource& source, const Vec2& raster, int vertices, PathSink& sink,
                           Observer& observer) {
  Flight flight;
  if (!start_camera(source, raster, observer, flight)) return;
  while (true) {
    const SegmentEnd segment = trace(camera_walk_, flight, source);
    const bool last = flight.edges + 1 == vertices - 1;
    if (!segment.hit && !segment.scattered) {
      if (last) leave_scene(flight, segment, sink);
      return;
    }
    PathVertex vertex;
    arrive(camera_walk_, flight, segment, camera_side_coefficient(flight.edges + 1), vertex);
    if (last) {
      if (!segment.hit || segment.hit->light == nullptr) return;
      hit_light(flight, segment, camera_mis(vertex, vertex.edges, {}), *segment.hit->light,
                {segment.hit->point, Vec3(0.F)}, sink);
      return;
    }
    observer.vertex(Stream::Camera, vertex, segment.hit ? &*segment.hit : nullptr);
    if (vertex.throughput.is_black() || !scatter(camera_walk_, vertex, source, flight)) return;
    observer.scattered(Stream::Camera, vertex, flight);
  }
}

bool PathSampler::trace_light_half(SampleSource& source, int vertices, PathVertex& end,
                                   PathSink* observer) {
  return observe(observer, [&](auto& each) { return light_half(source, vertices, end, each); });
}

bool PathSampler::trace_camera_half(SampleSource& source, const Vec2& raster, int vertices,
                                    PathVertex& end, PathSink* observer) {
  return observe(observer,
                 [&](auto& each) { return camera_half(source, raster, vertices, end, each); });
}

void PathSampler::sample_implicit(SampleSource& source, const Vec2& raster, int vertices,
                                  PathSink& sink, PathSink* observer) {
  observe(observer, [&](auto& each) { implicit(source, raster, vertices, sink, each); });
}

void PathSampler::connect_halves(Technique technique, const PathVertex& light_end,
                                 const PathVertex& camera_end, SampleSource& source,
                                 PathSink& sink) {
  if (technique.t == 1) {
    connect_to_camera(light_end, source, sink);
  } else if (technique.s == 1) {
    connect_to_lights(camera_end, source, sink);
  } else {
    connect_inner(camera_end, light_end, source, sink);
  }
}

}  // namespace ajar
