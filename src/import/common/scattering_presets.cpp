#include "import/common/scattering_presets.h"

#include <algorithm>
#include <array>

namespace ajar {
namespace {

struct Entry {
  std::string_view name;
  float sigma_s[3];
  float sigma_a[3];
};
constexpr std::array<Entry, 12> kEntries = {
    {{"Apple", {2.29F, 2.39F, 1.97F}, {0.0030F, 0.0034F, 0.046F}},
     {"Chicken1", {0.15F, 0.21F, 0.38F}, {0.015F, 0.077F, 0.19F}},
     {"Chicken2", {0.19F, 0.25F, 0.32F}, {0.018F, 0.088F, 0.20F}},
     {"Cream", {7.38F, 5.47F, 3.15F}, {0.0002F, 0.0028F, 0.0163F}},
     {"Ketchup", {0.18F, 0.07F, 0.03F}, {0.061F, 0.97F, 1.45F}},
     {"Marble", {2.19F, 2.62F, 3.00F}, {0.0021F, 0.0041F, 0.0071F}},
     {"Potato", {0.68F, 0.70F, 0.55F}, {0.0024F, 0.0090F, 0.12F}},
     {"Skimmilk", {0.70F, 1.22F, 1.90F}, {0.0014F, 0.0025F, 0.0142F}},
     {"Skin1", {0.74F, 0.88F, 1.01F}, {0.032F, 0.17F, 0.48F}},
     {"Skin2", {1.09F, 1.59F, 1.79F}, {0.013F, 0.070F, 0.145F}},
     {"Spectralon", {11.6F, 20.4F, 14.9F}, {0.0F, 0.0F, 0.0F}},
     {"Wholemilk", {2.55F, 3.21F, 3.77F}, {0.0011F, 0.0024F, 0.014F}}}};

bool same_letters(std::string_view a, std::string_view b) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : int{c}; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return small(x) == small(y); });
}

}  // namespace

std::optional<ScatteringPreset> find_scattering_preset(std::string_view name) {
  const auto found = std::find_if(kEntries.begin(), kEntries.end(), [&](const Entry& entry) {
    return same_letters(entry.name, name);
  });
  if (found == kEntries.end()) return std::nullopt;
  const auto rgb = [](const float(&v)[3]) { return Vec3(v[0], v[1], v[2]); };
  return ScatteringPreset{rgb(found->sigma_s), rgb(found->sigma_a)};
}

std::vector<std::string> scattering_preset_names() {
  std::vector<std::string> names;
  for (const Entry& entry : kEntries) names.emplace_back(entry.name);
  return names;
}

}  // namespace ajar
