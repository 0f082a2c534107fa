#include "path/path_archive.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "core/archive.h"

namespace ajar {

namespace {

/// Applies `each` to every float of a value.
template <typename Each>
void for_floats(Vec2& v, const Each& each) {
  each(v.x);
  each(v.y);
}
template <typename Each>
void for_floats(Vec3& v, const Each& each) {
  each(v.x);
  each(v.y);
  each(v.z);
}
template <typename Each>
void for_floats(SurfacePoint& point, const Each& each) {
  for (Vec3* v :
       {&point.p, &point.ng, &point.ns, &point.dpdu, &point.dpdv, &point.dndu, &point.dndv}) {
    for_floats(*v, each);
  }
  for_floats(point.uv, each);
}
template <typename Each>
void for_floats(Spectrum& spectrum, const Each& each) {
  for (int lane = 0; lane < 3; ++lane) {
    float value = spectrum[lane];
    each(value);
    spectrum.set(lane, value);
  }
}

void refuse(bool impossible, const char* what) {
  if (impossible) throw std::runtime_error(what);
}

struct Writer {
  OutputArchive& archive;
  template <typename Value>
  void floats(Value value) const {
    for_floats(value, [&](float& x) { archive(x); });
  }
  void point(const SurfacePoint& value) const {
    floats(value);
    archive(value.primitive);
  }
  void point(const EndpointPoint& value) const {
    point(value.surface);
    floats(value.toward);
  }
};

struct Reader {
  InputArchive& archive;
  template <typename Value>
  void floats(Value& value) const {
    for_floats(value, [&](float& x) {
      archive(x);
      refuse(!std::isfinite(x), "a path has what is no number");
    });
  }
  void point(SurfacePoint& value) const {
    floats(value);
    archive(value.primitive);
  }
  void point(EndpointPoint& value) const {
    point(value.surface);
    floats(value.toward);
  }
};

std::uint32_t number_of(const Scene& scene, const Medium* medium) {
  std::uint32_t number = 0;  // none
  for (std::uint32_t i = 0; i < scene.media().size(); ++i) {
    if (scene.media()[i].get() == medium) number = i + 1;
  }
  return number;
}

void save_vertex(const Writer& to, const Scene& scene, const InnerVertex& vertex) {
  to.archive(vertex.in_medium, number_of(scene, vertex.medium), vertex.event.lobe,
             vertex.event.transmission);
  if (vertex.in_medium) {
    to.floats(vertex.p());
    return;
  }
  to.archive(vertex.hit.shape, vertex.hit.instance_id);
  to.point(vertex.hit.point);
}

void load_vertex(const Reader& from, const Scene& scene, InnerVertex& vertex) {
  std::uint32_t medium = 0;
  from.archive(vertex.in_medium, medium, vertex.event.lobe, vertex.event.transmission);
  refuse(medium > scene.media().size() || (vertex.in_medium && medium == 0),
         "a path is in a medium that is not there");
  refuse(vertex.event.lobe < ScatterEvent::kRough || vertex.event.lobe >= Bsdf::kMaxLobes,
         "a path scatters by a lobe that is not there");
  vertex.medium = medium == 0 ? nullptr : scene.media()[medium - 1].get();
  if (vertex.in_medium) {
    Vec3 p(0.F);
    from.floats(p);
    vertex.hit = bare_hit(p);
    return;
  }
  GeometryHit hit = bare_hit(Vec3(0.F));
  from.archive(hit.shape, hit.instance_id);
  from.point(hit.point);
  const std::optional<Hit> recalled = scene.recall(hit);
  refuse(!recalled || recalled->is_interface(), "a path hits a shape that is not there");
  vertex.hit = *recalled;
  vertex.hit.material->bsdf(vertex.hit.point, vertex.bsdf);
}

}  // namespace

void save_path(OutputArchive& archive, const Scene& scene, const Path& path) {
  const Writer to{archive};
  archive(path.light->index, static_cast<std::uint32_t>(path.vertices.size()));
  to.point(path.light_point);
  to.point(path.camera_point);
  to.floats(path.raster);
  for (const InnerVertex& vertex : path.vertices) save_vertex(to, scene, vertex);
  for (const Segment& segment : path.segments) {
    to.floats(segment.transmittance);
    to.floats(segment.scattering_depth);
    archive(segment.counted_interfaces);
  }
}

Path load_path(InputArchive& archive, const Scene& scene) {
  const Reader from{archive};
  Path path;
  std::uint32_t light = 0;
  std::uint32_t inner = 0;
  archive(light, inner);
  refuse(light >= scene.lights().size(), "a path has a light that is not there");
  path.light = scene.lights()[light].get();
  from.point(path.light_point);
  refuse(path.light_point.surface.primitive >= path.light->primitives(),
         "a path has a point of a light that is not there");
  from.point(path.camera_point);
  from.floats(path.raster);
  // One by one: the memory grows with what has been read.
  for (std::uint32_t i = 0; i < inner; ++i) {
    load_vertex(from, scene, path.vertices.emplace_back());
  }
  for (std::uint32_t i = 0; i <= inner; ++i) {
    Segment& segment = path.segments.emplace_back();
    from.floats(segment.transmittance);
    from.floats(segment.scattering_depth);
    archive(segment.counted_interfaces);
    refuse(segment.counted_interfaces < 0 ||
               segment.counted_interfaces > std::numeric_limits<std::int16_t>::max(),
           "an edge of a path crosses what it cannot");
  }
  return path;
}

}  // namespace ajar
