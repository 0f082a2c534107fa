#include "import/pbrt/named_spectra.h"

#include <array>

#include "color/cie_illuminants.h"
#include "color/color.h"

namespace ajar::pbrt {
namespace {

struct Glass {
  std::string_view name;
  float index;
};
/// n at 587.6 nm. Source: Schott, optical glass data sheets. Three of the dense flints have a name
/// in pbrt-v4 without the S of the manufacturer's.
constexpr std::array<Glass, 10> kGlasses = {{{"BK7", 1.5168F},
                                             {"BAF10", 1.67003F},
                                             {"FK51A", 1.48656F},
                                             {"LASF9", 1.85025F},
                                             {"SF5", 1.67271F},
                                             {"SF10", 1.72828F},
                                             {"SF11", 1.78472F},
                                             {"F5", 1.67271F},
                                             {"F10", 1.72828F},
                                             {"F11", 1.78472F}}};

/// Substances beside the measured metals. Sources: Querry 1985 (brass of 70 % copper); Stephens and
/// Malitson 1952 (magnesia), Devore 1951 (rutile, ordinary ray), at 611, 549 and 464 nm.
struct Substance {
  std::string_view symbol;
  Vec3d eta, k;
};
const std::array<Substance, 3> kSubstances = {
    {{"CuZn", {0.444, 0.527, 1.094}, {3.695, 2.765, 1.829}},
     {"MgO", {1.7360, 1.7406, 1.7502}, {0.0, 0.0, 0.0}},
     {"TiO2", {2.5973, 2.6490, 2.7787}, {0.0, 0.0, 0.0}}}};
constexpr std::array<std::string_view, 4> kMetals = {"Ag", "Al", "Au", "Cu"};
constexpr std::array<std::string_view, 15> kStandardIlluminants = {
    "A", "D50", "D65", "F1", "F2", "F3", "F4", "F5", "F6", "F7", "F8", "F9", "F10", "F11", "F12"};

bool take_front(std::string_view& text, std::string_view front) {
  if (text.substr(0, front.size()) != front) return false;
  text.remove_prefix(front.size());
  return true;
}

}  // namespace

std::optional<Vec3d> named_metal(std::string_view name) {
  if (!take_front(name, "metal-")) return std::nullopt;
  const std::size_t dash = name.find('-');
  if (dash == std::string_view::npos) return std::nullopt;
  const std::string_view symbol = name.substr(0, dash);
  const std::string_view quantity = name.substr(dash + 1);
  if (quantity != "eta" && quantity != "k") return std::nullopt;
  for (const Substance& substance : kSubstances) {
    if (substance.symbol == symbol) return quantity == "eta" ? substance.eta : substance.k;
  }
  const MetalQuantity wanted = quantity == "eta" ? MetalQuantity::Eta : MetalQuantity::K;
  return metal_rgb_in_daylight(symbol, wanted);
}

std::optional<float> named_glass(std::string_view name) {
  if (!take_front(name, "glass-")) return std::nullopt;
  for (const Glass& glass : kGlasses) {
    if (glass.name == name) return glass.index;
  }
  return std::nullopt;
}

std::optional<Vec3d> named_illuminant(std::string_view name) {
  if (take_front(name, "stdillum-")) return illuminant_xyz(name);
  if (take_front(name, "illum-")) return illuminant_xyz(name);
  return std::nullopt;
}

std::vector<std::string> spectrum_names() {
  std::vector<std::string> names;
  const auto add_metal = [&](std::string_view symbol) {
    names.push_back("metal-" + std::string(symbol) + "-eta");
    names.push_back("metal-" + std::string(symbol) + "-k");
  };
  for (const std::string_view symbol : kMetals) add_metal(symbol);
  for (const Substance& substance : kSubstances) add_metal(substance.symbol);
  for (const Glass& glass : kGlasses) names.push_back("glass-" + std::string(glass.name));
  for (const std::string_view name : kStandardIlluminants) {
    names.push_back("stdillum-" + std::string(name));
  }
  names.emplace_back("illum-acesD60");
  return names;
}

}  // namespace ajar::pbrt
