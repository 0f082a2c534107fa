#include "transport/path_sampler.h"

namespace ajar {

namespace {
class Nobody final : public PathSink {
 public:
  void add(const Contribution& /*contribution*/) override {}
};

template <typename Work>
auto telling(PathSink* told, const Work& work) {
  if (told != nullptr) return work(*told);
  Nobody nobody;
  return work(nobody);
}
}  // namespace

template <typename Told>
bool PathSampler::light_half(SampleSource& source, int vertices, PathVertex& end, Told& told) {
  LightStart start;
  if (!start_light(source, 0, told, start)) return false;
  while (true) {
    if (!next_light_vertex(start, source, told, end)) return false;
    if (end.edges == vertices - 1) return end.connectible();
    if (!scatter(light_walk_, end, source, start.flight)) return false;
    told.scattered(Stream::Light, end, start.flight);
  }
}

template <typename Told>
bool PathSampler::camera_half(SampleSource& source, const Vec2& raster, int vertices,
                              PathVertex& end, Told& told) {
  Flight flight;
  if (!start_camera(source, raster, told, flight)) return false;
  while (true) {
    const SegmentEnd segment = trace(camera_walk_, flight, source);
    if (!segment.hit && !segment.scattered) return false;
    arrive(camera_walk_, flight, segment, camera_side_coefficient(flight.edges + 1), end);
    if (end.throughput.is_black()) return false;
    told.vertex(Stream::Camera, end, segment.hit ? &*segment.hit : nullptr);
    if (end.edges == vertices - 1) return end.connectible();
    if (!scatter(camera_walk_, end, source, flight)) return false;
    told.scattered(Stream::Camera, end, flight);
  }
}

template <typename Told>
void PathSampler::implicit(SampleSource& source, const Vec2& raster, int vertices, PathSink& sink,
                           Told& told) {
  Flight flight;
  if (!start_camera(source, raster, told, flight)) return;
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
    told.vertex(Stream::Camera, vertex, segment.hit ? &*segment.hit : nullptr);
    if (vertex.throughput.is_black() || !scatter(camera_walk_, vertex, source, flight)) return;
    told.scattered(Stream::Camera, vertex, flight);
  }
}

bool PathSampler::trace_light_half(SampleSource& source, int vertices, PathVertex& end,
                                   PathSink* told) {
  return telling(told, [&](auto& who) { return light_half(source, vertices, end, who); });
}

bool PathSampler::trace_camera_half(SampleSource& source, const Vec2& raster, int vertices,
                                    PathVertex& end, PathSink* told) {
  return telling(told, [&](auto& who) { return camera_half(source, raster, vertices, end, who); });
}

void PathSampler::sample_implicit(SampleSource& source, const Vec2& raster, int vertices,
                                  PathSink& sink, PathSink* told) {
  telling(told, [&](auto& who) { implicit(source, raster, vertices, sink, who); });
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
