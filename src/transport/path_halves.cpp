#include "transport/path_sampler.h"

namespace ajar {

namespace {
class NoSink final : public PathSink {
 public:
  void add(const Contribution& /*contribution*/) override {}
};
}  // namespace

bool PathSampler::trace_light_half(SampleSource& source, int vertices, PathVertex& end) {
  NoSink sink;
  LightStart start;
  if (!start_light(source, 0, sink, start)) return false;
  while (true) {
    if (!next_light_vertex(start, source, sink, end)) return false;
    if (end.edges == vertices - 1) return end.connectible();
    if (!scatter(light_walk_, end, source, start.flight)) return false;
  }
}

bool PathSampler::trace_camera_half(SampleSource& source, const Vec2& raster, int vertices,
                                    PathVertex& end) {
  NoSink sink;
  Flight flight;
  if (!start_camera(source, raster, sink, flight)) return false;
  while (true) {
    const SegmentEnd segment = trace(camera_walk_, flight, source);
    if (!segment.hit && !segment.scattered) return false;
    arrive(camera_walk_, flight, segment, camera_side_coefficient(flight.edges + 1), end);
    if (end.throughput.is_black()) return false;
    if (end.edges == vertices - 1) return end.connectible();
    if (!scatter(camera_walk_, end, source, flight)) return false;
  }
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

void PathSampler::sample_implicit(SampleSource& source, const Vec2& raster, int vertices,
                                  PathSink& sink) {
  Flight flight;
  if (!start_camera(source, raster, sink, flight)) return;
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
      hit_light(flight, segment, camera_mis(vertex, vertex.edges), *segment.hit->light,
                {segment.hit->point, Vec3(0.F)}, sink);
      return;
    }
    if (vertex.throughput.is_black() || !scatter(camera_walk_, vertex, source, flight)) return;
  }
}

}  // namespace ajar
