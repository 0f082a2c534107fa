#include "mcmc/path_space/specular_photons.h"

#include <algorithm>
#include <utility>

#include "core/random_use.h"
#include "mcmc/path_space/heuristics.h"
#include "mcmc/primary/bootstrap_source.h"
#include "path/manifold_walk.h"

namespace ajar {

namespace {

/// Halvings along each axis in a code.
constexpr int kLevels = 21;

/// Every third bit.
std::uint64_t spread_bits(std::uint32_t bits) {
  std::uint64_t spread = 0;
  for (int i = 0; i < kLevels; ++i) spread |= static_cast<std::uint64_t>(bits >> i & 1U) << 3 * i;
  return spread;
}

}  // namespace

void SpecularPhotons::trace() const {
  std::vector<std::vector<Photon>> by_light(scene_.lights().size());
  ManifoldWalk walk(scene_);
  const std::uint64_t count = scene_.light_sampler().empty() ? 0 : PathSpaceHeuristics::kPhotons;
  for (std::uint64_t i = 0; i < count; ++i) {
    BootstrapSource source(static_cast<std::uint64_t>(RandomUse::SpecularPhotons), i);
    const auto address = [](Slot slot) { return SampleAddress(Stream::Light, 0, slot); };
    const Light& light =
        *scene_.light_sampler().choose_emitter(source.get(address(kEmitterChoice))).light;
    const auto emission = light.sample_emission({source.get(address(kEmissionPrimitive)),
                                                 source.get_pair(address(kEmissionPosition)),
                                                 source.get_pair(address(kEmissionDirection))});
    if (!emission) continue;
    const Vec3d through = Vec3d(emission->origin) + Vec3d(emission->w);
    const ChainStart start = chain_start(light, emission->point);
    if (walk.set_off(start, through, PathSpaceHeuristics::kLongestOfPhotons, source) &&
        walk.landing()) {
      by_light[light.index].push_back({code(*walk.landing()), walk.vertices().front().p()});
    }
  }
  for (std::vector<Photon>& photons : by_light) {
    std::stable_sort(photons.begin(), photons.end(),
                     [](const Photon& a, const Photon& b) { return a.place < b.place; });
  }
  by_light_ = std::move(by_light);
}

std::uint64_t SpecularPhotons::code(const Vec3& p) const {
  constexpr float kCells = 1U << kLevels;
  const BoundingSphere& bounds = scene_.bounding_sphere();
  const auto along = [&](float x, float center) {
    const float share = 0.5F + 0.5F * (x - center) / bounds.radius;
    // NaN is put at the border.
    return spread_bits(
        share > 0.F ? static_cast<std::uint32_t>(std::min(share * kCells, kCells - 1.F)) : 0U);
  };
  return along(p.x, bounds.center.x) | along(p.y, bounds.center.y) << 1U |
         along(p.z, bounds.center.z) << 2U;
}

std::optional<Vec3> SpecularPhotons::near(const Light& light, const Vec3& p, float u) const {
  std::call_once(traced_, [this] { trace(); });
  constexpr std::ptrdiff_t kFewest = PathSpaceHeuristics::kFewestPhotons;
  const std::vector<Photon>& photons = by_light_[light.index];
  auto first = photons.begin();
  auto last = photons.end();
  if (last - first < kFewest) return std::nullopt;
  const std::uint64_t place = code(p);
  for (int bit = 3 * kLevels - 1; bit >= 0; --bit) {
    const std::uint64_t low = place >> bit << bit;
    const std::uint64_t high = low + (std::uint64_t{1} << bit);
    const auto is_before = [](const Photon& photon, std::uint64_t at) { return photon.place < at; };
    const auto inner_first = std::lower_bound(first, last, low, is_before);
    const auto inner_last = std::lower_bound(inner_first, last, high, is_before);
    if (inner_last - inner_first < kFewest) break;
    first = inner_first;
    last = inner_last;
  }
  const auto count = last - first;
  return first[std::min(count - 1, static_cast<std::ptrdiff_t>(u * static_cast<float>(count)))]
      .first;
}

}  // namespace ajar
