#include "import/common/conductors.h"

#include <algorithm>
#include <array>

#include "import/common/metals.h"

namespace ajar {
namespace {

struct Conductor {
  std::string_view name;
  double eta[3];
  double k[3];
};
/// Linear RGB by the CIE 1931 observer of the measurements that renderers share by these names,
/// beside those of `metals.h`. Sources: E. D. Palik (ed.), Handbook of Optical Constants of Solids,
/// 1985; SOPRA n,k database. As collected by the luxpop.com database.
constexpr std::array<Conductor, 33> kConductors = {
    {{"a-C", {2.9441, 2.2272, 1.9682}, {0.88743, 0.79932, 0.81529}},
     {"AlAs", {3.6051, 3.2329, 2.2176}, {0.00066702, 0.0, 0.0074261}},
     {"AlSb", {0.0, 4.1428, 4.6698}, {0.0, 0.093767, 1.3007}},
     {"Be", {4.1851, 3.1851, 2.7841}, {3.8354, 3.0101, 2.869}},
     {"CsI", {2.1449, 1.7023, 1.6624}, {0.0, 0.0, 0.0}},
     {"Cu2O", {3.5493, 2.9521, 2.7369}, {0.11322, 0.19467, 0.60017}},
     {"CuO", {3.2454, 2.4496, 2.1974}, {0.52027, 0.57074, 0.71723}},
     {"d-C", {2.7113, 2.3186, 2.2289}, {0.0, 0.0, 0.0}},
     {"Hg", {2.3989, 1.44, 0.90955}, {6.3276, 4.3719, 3.4218}},
     {"HgTe", {4.7795, 3.231, 2.66}, {1.632, 1.5808, 1.7296}},
     {"Ir", {3.0864, 2.0822, 1.6179}, {5.5922, 4.0672, 3.2673}},
     {"K", {0.064049, 0.04641, 0.038184}, {2.1042, 1.3489, 0.91321}},
     {"Li", {0.26579, 0.19561, 0.22092}, {3.5402, 2.3111, 1.6686}},
     {"MgO", {2.0896, 1.6507, 1.5949}, {0.0, 0.0, 0.0}},
     {"Mo", {4.4837, 3.5255, 2.7761}, {4.1111, 3.4209, 3.1506}},
     {"Na", {0.060267, 0.056141, 0.061991}, {3.1793, 2.1125, 1.5791}},
     {"Nb", {3.4201, 2.7902, 2.3956}, {3.4414, 2.7376, 2.5799}},
     {"Rh", {2.5858, 1.8602, 1.5544}, {6.7823, 4.703, 3.9761}},
     {"Se-e", {5.7243, 4.1654, 4.0816}, {0.87137, 1.1053, 1.5648}},
     {"Se", {4.0593, 2.8427, 2.8208}, {0.75438, 0.63852, 0.52159}},
     {"SiC", {3.1723, 2.526, 2.4794}, {0.0, 0.0, 0.0}},
     {"SnTe", {4.5252, 1.9812, 1.2817}, {0.0, 0.0, 0.0}},
     {"Ta", {2.0626, 2.3931, 2.6281}, {2.408, 1.7414, 1.947}},
     {"Te-e", {7.509, 4.2965, 2.3699}, {5.5842, 4.9476, 3.9975}},
     {"Te", {7.3908, 4.4821, 2.6371}, {3.2561, 3.5274, 3.2922}},
     {"ThF4", {1.8307, 1.4422, 1.3876}, {0.0, 0.0, 0.0}},
     {"TiC", {3.7005, 2.8374, 2.5823}, {3.2657, 2.3516, 2.1728}},
     {"TiN", {1.6485, 1.1504, 1.3798}, {3.3685, 1.9435, 1.102}},
     {"TiO2-e", {3.1066, 2.5132, 2.5824}, {0.0, 0.0, 0.0}},
     {"TiO2", {3.4566, 2.8017, 2.9051}, {0.0, 0.0, 0.0}},
     {"V", {4.2775, 3.5132, 2.7611}, {3.4912, 2.8894, 3.1117}},
     {"VC", {3.6576, 2.7527, 2.5327}, {3.0684, 2.1987, 1.9632}},
     {"VN", {2.8656, 2.1192, 1.9401}, {3.0323, 2.0561, 1.6163}}}};

constexpr std::array<std::string_view, 7> kMetalNames = {"Ag", "Al", "Au", "Cr", "Cu", "Ni", "W"};

}  // namespace

std::optional<ComplexIndex> conductor_named(std::string_view name) {
  constexpr std::string_view kSource = "_palik";
  if (name.ends_with(kSource)) name.remove_suffix(kSource.size());
  const std::optional<Vec3d> eta = metal_rgb(name, MetalQuantity::Eta);
  const std::optional<Vec3d> k = metal_rgb(name, MetalQuantity::K);
  if (eta && k) return ComplexIndex{Vec3(*eta), Vec3(*k)};
  const auto found = std::find_if(kConductors.begin(), kConductors.end(),
                                  [&](const Conductor& entry) { return entry.name == name; });
  if (found == kConductors.end()) return std::nullopt;
  const auto rgb = [](const double(&v)[3]) { return Vec3(Vec3d(v[0], v[1], v[2])); };
  return ComplexIndex{rgb(found->eta), rgb(found->k)};
}

std::vector<std::string> conductor_names() {
  std::vector<std::string> names(kMetalNames.begin(), kMetalNames.end());
  for (const Conductor& entry : kConductors) names.emplace_back(entry.name);
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace ajar
