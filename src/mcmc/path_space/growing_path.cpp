#include "mcmc/path_space/growing_path.h"

#include <algorithm>

#include "path/measure.h"
#include "path/visibility.h"

namespace ajar {

void GrowingPath::begin(const Path& x, int light_vertices, int camera_vertices) {
  light.keep(x, light_vertices);
  camera.keep(x, camera_vertices);
  raster_ = x.raster;
  into_light_.reset();
  if (camera_vertices != 1) return;
  const auto numbers = scene_.camera().invert_connection(x.position(x.depth() - 1), x.camera_point,
                                                         {0.F, Vec2(0.5F, 0.5F)});
  on_lens_ = numbers ? numbers->position : Vec2(0.5F, 0.5F);
}

bool GrowingPath::emit(SampleSource& source) {
  if (scene_.light_sampler().empty()) return false;
  const auto address = [](Slot slot) { return SampleAddress(Stream::Light, 0, slot); };
  const Light& source_light =
      *scene_.light_sampler().choose_emitter(source.get(address(kEmitterChoice))).light;
  const auto emission = source_light.sample_emission(
      {source.get(address(kEmissionPrimitive)), source.get_pair(address(kEmissionPosition)),
       source.get_pair(address(kEmissionDirection))});
  if (!emission) return false;
  const Vec3 origin =
      source_light.at_infinity()
          ? emission->origin
          : offset_ray_origin(emission->origin, emission->point.surface.ng, emission->w);
  light.start(source_light, emission->point, {origin, emission->w}, source_light.medium);
  return true;
}

bool GrowingPath::choose_light(SampleSource& source) {
  if (scene_.light_sampler().empty()) return false;
  const Vec3& reference = camera.position();
  const auto address = [&](Slot slot) {
    return SampleAddress(Stream::Camera, static_cast<int>(camera.vertices.size()), slot);
  };
  const Light& chosen =
      *scene_.light_sampler().choose(reference, source.get(address(Slot::LightChoice))).light;
  // Where it does not shine straight to the camera end it may do so by a chain.
  if (chosen.discrete_position()) {
    light.start(chosen, chosen.only_point());
    return true;
  }
  const auto sample = chosen.sample_connection(
      reference,
      {source.get(address(Slot::LightPrimitive)), source.get_pair(address(Slot::LightPositionX))});
  if (!sample) return false;
  light.start(chosen, sample->point);
  return true;
}

void GrowingPath::choose_lens(SampleSource& source) {
  on_lens_ = source.get_pair({Stream::Camera, 0, kEmissionPosition});
  camera.start(scene_.camera(), EndpointPoint::at(Vec3(0.F)));
}

bool GrowingPath::look(const Vec2& raster) {
  const Camera& eye = scene_.camera();
  const auto ray = eye.sample_emission({0.F, on_lens_, raster / Vec2(eye.resolution())});
  if (!ray) return false;
  raster_ = raster;
  camera.start(eye, ray->point, {ray->origin, ray->w}, eye.medium);
  return true;
}

bool GrowingPath::run_into_light(SampleSource& source) {
  const SegmentEnd end = camera.trace(source);
  into_light_ = end.segment;
  if (end.hit) {
    if (end.hit->light == nullptr) return false;
    light.start(*end.hit->light, {end.hit->point, Vec3(0.F)});
    return true;
  }
  const auto lights = scene_.infinite_lights();
  if (end.scattered || end.lost || lights.empty()) return false;
  const float u =
      source.get({Stream::Camera, static_cast<int>(camera.vertices.size()), Slot::LightChoice});
  const auto number = static_cast<std::size_t>(u * static_cast<float>(lights.size()));
  const Light& chosen = *lights[std::min(number, lights.size() - 1)];
  light.start(chosen, chosen.at_direction(camera.direction()));
  return true;
}

bool GrowingPath::look_at_light_end() {
  const auto sample = scene_.camera().sample_connection(light.position(), {0.F, on_lens_});
  if (sample) camera.start(scene_.camera(), sample->point);
  return sample.has_value();
}

void GrowingPath::assemble(Path& path) const {
  path.light = static_cast<const Light*>(light.endpoint);
  path.light_point = light.point;
  path.camera_point = camera.point;
  path.raster = raster_;
  path.vertices.assign(light.vertices.begin(), light.vertices.end());
  path.vertices.insert(path.vertices.end(), camera.vertices.rbegin(), camera.vertices.rend());
  path.segments.assign(light.segments.begin(), light.segments.end());
  path.segments.emplace_back(into_light_.value_or(Segment{}));
  path.segments.insert(path.segments.end(), camera.segments.rbegin(), camera.segments.rend());
}

bool GrowingPath::stop_ends() {
  for (GrowingEnd* end : {&light, &camera}) {
    if (end->vertices.empty()) continue;
    if (!end->vertices.back().connectible()) return false;
    end->vertices.back().event = {};
  }
  return true;
}

bool GrowingPath::finish(Path& path) {
  const bool joined = !into_light_;
  const bool from_lens = joined && camera.vertices.empty();
  if (from_lens && !look_at_light_end()) return false;
  const int s = joined ? light.size() : 0;
  if (joined && !stop_ends()) return false;
  assemble(path);
  if (from_lens) {
    const auto raster =
        scene_.camera().raster(path.camera_point, path.toward_light(scene_, path.depth()));
    if (!raster || !inside_image(scene_, *raster)) return false;
    path.raster = *raster;
  }
  if (!area_.contains(path.raster)) return false;
  mark_sides(scene_, path);
  if (!joined) return true;
  const auto segment = look_along(scene_, path, s - 1, joints_);
  if (!segment) return false;
  path.segments[static_cast<std::size_t>(s - 1)] = *segment;
  return true;
}

bool GrowingPath::finish_through(std::span<const InnerVertex> chain, Path& path) {
  if (!stop_ends()) return false;
  assemble(path);
  const auto light_vertices = static_cast<std::ptrdiff_t>(light.vertices.size());
  path.vertices.insert(path.vertices.begin() + light_vertices, chain.begin(), chain.end());
  path.segments.insert(path.segments.begin() + light_vertices, chain.size(), Segment{});
  if (!area_.contains(path.raster)) return false;
  mark_sides(scene_, path);
  const int first = light.size() - 1;
  for (int edge = first + static_cast<int>(chain.size()); edge >= first; --edge) {
    const auto segment = look_along(scene_, path, edge, joints_);
    if (!segment) return false;
    path.segments[static_cast<std::size_t>(edge)] = *segment;
  }
  return true;
}

RayCounts GrowingPath::ray_counts() const {
  RayCounts all = joints_;
  all.add_rays(light.ray_counts());
  all.add_rays(camera.ray_counts());
  return all;
}

}  // namespace ajar
