#include "integrator/regions/region_layers.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "integrator/regions/heuristics.h"

namespace ajar {

namespace {
bool names(std::span<const std::string> aovs, const char* name) {
  return std::find(aovs.begin(), aovs.end(), name) != aovs.end();
}
}  // namespace

NamedPlanes region_layers(std::span<const std::string> aovs, const Surfaces& surfaces,
                          const Plane& noise, const Plane& importance) {
  std::vector<float> numbers(surfaces.regions.count());
  std::iota(numbers.begin(), numbers.end(), 1.F);
  NamedPlanes planes;
  const auto add = [&](const char* name, const Plane& plane) {
    if (names(aovs, name)) planes.emplace_back(name, plane);
  };
  add("noise", noise);
  if (names(aovs, "regions")) add("regions", fill_regions(surfaces.regions, numbers));
  add("importance", importance);
  add("edges", surfaces.edges);
  return planes;
}

NamedPlanes black_region_layers(std::span<const std::string> aovs, const Box2i& crop) {
  NamedPlanes planes;
  for (const char* name : kRegionLayers) {
    if (names(aovs, name)) planes.emplace_back(name, Plane(crop.size() + Vec2i(1, 1)));
  }
  return planes;
}

MethodReport report_regions(const Scene& scene, const Regions& regions,
                            std::span<const double> noise, const Plane& importance) {
  std::vector<double> importances(regions.count());
  for (std::size_t i = 0; i < importance.values.size(); ++i) {
    importances[regions.labels[i]] += static_cast<double>(importance.values[i]);
  }
  std::vector<std::size_t> order(regions.count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return regions.pixel_counts[a] > regions.pixel_counts[b];
  });
  order.resize(std::min(order.size(), RegionHeuristics::kMostRegionsListed));
  const auto name_of = [](std::span<const std::string> all, std::uint32_t number) {
    return number > 0 ? all[number - 1] : std::string();
  };
  MethodReport rows = MethodReport::array();
  for (const std::size_t r : order) {
    const PixelIdentity& shown = regions.identities[r];
    const auto pixels = regions.pixel_counts[r];
    rows.push_back({{"region", r + 1},
                    {"pixels", pixels},
                    {"object", name_of(scene.object_names(), shown.object)},
                    {"material", name_of(scene.material_names(), shown.material)},
                    {"noise", noise[r]},
                    {"importance", importances[r] / static_cast<double>(pixels)}});
  }
  return rows;
}

}  // namespace ajar
