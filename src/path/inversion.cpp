#include "path/inversion.h"

#include <algorithm>
#include <cmath>

#include "core/unit_interval.h"
#include "path/measure.h"
#include "scene/medium/phase.h"
#include "transport/heuristics.h"

namespace ajar {

PathPrimaries::PathPrimaries(Technique technique, SampleSource& fresh) : fresh_(&fresh) {
  const auto fill = [&](Stream stream, int vertices, std::vector<Block>& blocks) {
    blocks.resize(static_cast<std::size_t>(vertices));
    for (int vertex = 0; vertex < vertices; ++vertex) {
      Block& block = blocks[static_cast<std::size_t>(vertex)];
      for (std::size_t slot = 0; slot < block.size(); slot += 2) {
        const Vec2 pair = fresh.get_pair({stream, vertex, static_cast<Slot>(slot)});
        block[slot] = pair.x;
        block[slot + 1] = pair.y;
      }
    }
  };
  fill(Stream::Camera, technique.t, camera_);
  fill(Stream::Light, technique.s, light_);
}

float* PathPrimaries::find(SampleAddress address) {
  if (address.stream() == Stream::Connection) {
    for (auto& [at, number] : connections_) {
      if (at == address) return &number;
    }
    return nullptr;
  }
  std::vector<Block>& blocks = address.stream() == Stream::Light ? light_ : camera_;
  const auto vertex = static_cast<std::size_t>(address.vertex());
  if (address.repeat() != 0 || vertex >= blocks.size()) return nullptr;
  return &blocks[vertex][static_cast<std::size_t>(address.slot())];
}

float PathPrimaries::get(SampleAddress address) {
  const float* number = find(address);
  return number != nullptr ? *number : fresh_->get(address);
}

Vec2 PathPrimaries::get_pair(SampleAddress address) {
  const float* number = address.stream() == Stream::Connection ? nullptr : find(address);
  return number != nullptr ? Vec2(number[0], number[1]) : fresh_->get_pair(address);
}

void PathPrimaries::set(SampleAddress address, float number) {
  if (float* place = find(address)) {
    *place = number;
  } else {
    connections_.emplace_back(address, number);
  }
}

void PathPrimaries::set_pair(SampleAddress address, const Vec2& numbers) {
  float* place = find(address);
  place[0] = numbers.x;
  place[1] = numbers.y;
}

namespace {

/// Goes along a path as the sampler does, one subpath after the other.
class Inverter {
 public:
  Inverter(const Scene& scene, const PathSamplerSettings& settings, const Path& path,
           Technique technique, SampleSource& fresh)
      : scene_(scene),
        settings_(settings),
        path_(path),
        technique_(technique),
        result_{PathPrimaries(technique, fresh), 0.0} {}

  std::optional<Inversion> run() {
    const ByLane pdf = technique_pdf_by_lane(scene_, path_, technique_);
    const double count = settings_.techniques.count(technique_);
    if (!(mean(pdf) > 0.0) || !(count > 0.0)) return std::nullopt;
    result_.log_density = std::log(mean(pdf));
    const auto lane = invert_lane(pdf, result_.numbers.get(kLaneChoice));
    if (!lane) return std::nullopt;
    result_.numbers.set(kLaneChoice, *lane);
    const auto [s, t] = technique_;
    if (s >= 2 && !light_subpath()) return std::nullopt;
    if (t >= 2 && !camera_subpath()) return std::nullopt;
    if (s == 1 && !next_event()) return std::nullopt;
    if (t == 1 && !lens()) return std::nullopt;
    if (s > 0) try_with((s - 1) % 256 * 256 + (t - 1) % 256, count);
    // `sample` traces light subpaths for these sets, for others `sample_light` does.
    if (s >= 2 && settings_.techniques.any(TechniqueClass::Inner)) {
      try_with(0, settings_.light_subpaths);
    }
    return std::move(result_);
  }

 private:
  /// A subpath that has left vertex `x`, the `edges`th of its own.
  struct Walk {
    Stream stream;
    TransportMode mode;
    int x;
    int step;  ///< from one vertex to the next
    int edges = 0;
    Spectrum throughput;
    float roulette_scale;
    ByLane lanes = kAnyLane;
  };

  SampleAddress address(Stream stream, int vertex, Slot slot) const {
    return {stream, vertex, slot};
  }
  /// A decision at random that went in favour of the path: with probability `chance`.
  void survive(SampleAddress where, double chance) {
    if (chance >= 1.0) return;
    PathPrimaries& numbers = result_.numbers;
    numbers.set(where, UnitInterval{0.0, chance}.at(numbers.get(where)));
    result_.log_density += std::log(chance);
  }
  void try_with(int vertex, double count) {
    survive({Stream::Connection, vertex, kConnectionTry}, count);
  }

  bool light_subpath() {
    PathPrimaries& numbers = result_.numbers;
    const Light& light = *path_.light;
    const SampleAddress choice = address(Stream::Light, 0, kEmitterChoice);
    const auto emitter = scene_.light_sampler().invert_emitter(light, numbers.get(choice));
    if (!emitter) return false;
    numbers.set(choice, *emitter);
    const auto emission =
        light.invert_emission(path_.light_point, path_.vertex(1).p(),
                              path_.toward_camera(scene_, 0), emission_numbers(Stream::Light));
    if (!emission) return false;
    numbers.set(address(Stream::Light, 0, kEmissionPrimitive), emission->primitive);
    numbers.set_pair(address(Stream::Light, 0, kEmissionPosition), emission->position);
    numbers.set_pair(address(Stream::Light, 0, kEmissionDirection), emission->direction);
    const auto sample = light.sample_emission(*emission);
    if (!sample) return false;
    Walk walk{Stream::Light, TransportMode::Importance, 0, 1, 0, {}, 1.F};
    walk.throughput = sample->weight / scene_.light_sampler().emitter_probability(light).value();
    walk.roulette_scale = 1.F / walk.throughput.max();
    return follow(walk, technique_.s - 1);
  }

  bool camera_subpath() {
    PathPrimaries& numbers = result_.numbers;
    const Camera& camera = scene_.camera();
    const int k = path_.depth();
    const Vec2 size(camera.resolution());
    const SampleAddress position = address(Stream::Camera, 0, kEmissionPosition);
    const auto lens =
        camera.invert_emission(path_.camera_point, path_.position(k), path_.toward_light(scene_, k),
                               emission_numbers(Stream::Camera));
    if (lens) {
      numbers.set_pair(position, lens->position);
    } else if (!camera.discrete_position()) {
      return false;
    }
    const auto unit = [](float u) { return std::clamp(u, 0.F, kOneMinusEpsilon); };
    numbers.set_pair(address(Stream::Camera, 0, kEmissionDirection),
                     {unit(path_.raster.x / size.x), unit(path_.raster.y / size.y)});
    Walk walk{Stream::Camera, TransportMode::Radiance, k, -1, 0, Spectrum(1.F), 1.F};
    return follow(walk, technique_.t - 1);
  }

  EmissionUniforms emission_numbers(Stream stream) {
    PathPrimaries& numbers = result_.numbers;
    return {numbers.get(address(stream, 0, kEmissionPrimitive)),
            numbers.get_pair(address(stream, 0, kEmissionPosition)),
            numbers.get_pair(address(stream, 0, kEmissionDirection))};
  }

  /// All of the `edges` edges of a subpath.
  bool follow(Walk& walk, int edges) {
    while (true) {
      fly(walk);
      if (walk.edges == edges) return true;
      if (!scatter(walk)) return false;
    }
  }

  void fly(Walk& walk) {
    PathPrimaries& numbers = result_.numbers;
    const SampleAddress distance = address(walk.stream, walk.edges, Slot::MediumDistance);
    const Segment& segment = path_.segment(walk.step > 0 ? walk.x : walk.x - 1);
    walk.x += walk.step;
    ++walk.edges;
    const bool is_inner = walk.x > 0 && walk.x < path_.depth();
    const MediumPoint end = is_inner ? path_.vertex(walk.x).scattered_in() : MediumPoint{};
    if (!segment.scattering_depth.is_black()) {
      const int lane = lane_of(numbers.get(kLaneChoice));
      numbers.set(distance, invert_distance(segment, end, lane, numbers.get(distance)));
    }
    const FreeFlight flight(segment, walk.lanes, end);
    walk.throughput *= flight.weight;
    walk.lanes = flight.lanes;
  }

  bool scatter(Walk& walk) {
    PathPrimaries& numbers = result_.numbers;
    const InnerVertex& vertex = path_.vertex(walk.x);
    const SampleAddress lobe = address(walk.stream, walk.edges, Slot::BsdfLobe);
    const SampleAddress direction = address(walk.stream, walk.edges, Slot::BsdfDirectionX);
    const bool to_light = walk.step < 0;
    const Vec3 wo =
        to_light ? path_.toward_camera(scene_, walk.x) : path_.toward_light(scene_, walk.x);
    const Vec3 wi =
        to_light ? path_.toward_light(scene_, walk.x) : path_.toward_camera(scene_, walk.x);
    if (vertex.in_medium) {
      numbers.set_pair(direction, phase::invert_henyey_greenstein(vertex.medium->g(), wo, wi));
    } else {
      const auto u = vertex.bsdf.invert(wo, wi, vertex.event,
                                        {numbers.get(lobe), numbers.get_pair(direction)});
      if (!u) return false;
      numbers.set(lobe, u->lobe);
      numbers.set_pair(direction, u->direction);
      const auto sample = vertex.bsdf.sample(wo, *u, walk.mode, Reverse::Skip);
      if (!sample) return false;
      walk.throughput *= sample->weight;
      if (walk.mode == TransportMode::Radiance) walk.roulette_scale *= sample->eta * sample->eta;
    }
    // Counterpart of transport's `scatter`.
    const bool is_long = walk.edges >= settings_.roulette_start;
    if (!is_long) return true;
    const float survival = std::min(0.95F, walk.throughput.max() * walk.roulette_scale);
    if (!(survival > 0.F)) return false;
    survive(address(walk.stream, walk.edges, Slot::Roulette), double{survival});
    walk.throughput /= survival;
    return true;
  }

  bool next_event() {
    PathPrimaries& numbers = result_.numbers;
    const int edges = technique_.t - 1;
    const Vec3& reference = path_.vertex(1).p();
    const SampleAddress choice = address(Stream::Camera, edges, Slot::LightChoice);
    const SampleAddress primitive = address(Stream::Camera, edges, Slot::LightPrimitive);
    const SampleAddress position = address(Stream::Camera, edges, Slot::LightPositionX);
    const auto chosen = scene_.light_sampler().invert(reference, *path_.light, numbers.get(choice));
    const auto u = path_.light->invert_connection(
        reference, path_.light_point, {numbers.get(primitive), numbers.get_pair(position)});
    if (!chosen || !u) return false;
    numbers.set(choice, *chosen);
    numbers.set(primitive, u->primitive);
    numbers.set_pair(position, u->position);
    return true;
  }

  bool lens() {
    PathPrimaries& numbers = result_.numbers;
    const int edges = technique_.s - 1;
    const SampleAddress position = address(Stream::Light, edges, Slot::LightPositionX);
    const auto u = scene_.camera().invert_connection(path_.vertex(edges).p(), path_.camera_point,
                                                     {0.F, numbers.get_pair(position)});
    if (!u) return false;
    numbers.set_pair(position, u->position);
    return true;
  }

  const Scene& scene_;
  const PathSamplerSettings& settings_;
  const Path& path_;
  Technique technique_;
  Inversion result_;
};

}  // namespace

std::optional<Inversion> invert(const Scene& scene, const PathSamplerSettings& settings,
                                const Path& path, Technique technique, SampleSource& fresh) {
  return Inverter(scene, settings, path, technique, fresh).run();
}

}  // namespace ajar
