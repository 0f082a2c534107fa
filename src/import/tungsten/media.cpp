#include "import/tungsten/media.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "import/tungsten/settings.h"
#include "import/tungsten/transmittance.h"

namespace ajar::tungsten {
namespace {

constexpr WarningKind kUnknownMedium{Effect::Surface, "media are unknown and left out"};
constexpr WarningKind kHeterogeneous{
    Effect::Surface, "media that vary are not supported: homogeneous ones stand in"};
constexpr WarningKind kNoGrid{Effect::Surface,
                              "media of voxels have grids that are not read: they count as empty"};
constexpr WarningKind kPhase{Effect::Slight,
                             "phase functions are not supported: isotropic ones stand in"};
constexpr WarningKind kShortPaths{Effect::Light,
                                  "media end paths that scatter often: here they go on"};
constexpr WarningKind kSameMediumName{Effect::Surface,
                                      "media have the same name: the first counts"};

using Kind = LocatedJson::Kind;

const std::vector<std::string> kMediumTypes = {"homogeneous", "atmosphere", "exponential", "voxel"};
const std::vector<std::string> kPhases = {"isotropic", "henyey_greenstein", "rayleigh"};

/// g of Henyey and Greenstein.
float phase_of(const Context& context, const LocatedJson& json) {
  const ObjectReader object(context, json, "a phase function");
  object.accept({"name"});
  const std::string type = object.text("type").value_or("isotropic");
  const float g = object.number("g").value_or(0.F);
  object.report_unknown();
  if (type == "isotropic") return 0.F;
  if (type != "henyey_greenstein") {
    context.warnings.add(
        kPhase, json.where(),
        type == "rayleigh" ? "Rayleigh scattering is not supported: isotropic scattering, as even "
                             "to both sides, stands in"
                           : unknown_name_message("phase function", printable(type), kPhases) +
                                 ". An isotropic one stands in",
        printable(type));
    return 0.F;
  }
  if (!(g > -1.F && g < 1.F)) throw SceneError(json.where(), "\"g\" must be between -1 and 1");
  return g;
}

Vec3 coefficient(const ObjectReader& object, std::string_view name, float density) {
  const Vec3 value = object.vector(name).value_or(Vec3(0.F)) * density;
  if (!(value.x >= 0.F && value.y >= 0.F && value.z >= 0.F) || !is_finite(value)) {
    throw SceneError(object.where(), "\"" + std::string(name) +
                                         "\" times the density must be finite and not negative");
  }
  return value;
}

/// Checks the grid of a voxel medium, for messages: it is not read, as OpenVDB's files need
/// OpenVDB.
std::string grid_of(const ObjectReader& medium) {
  const auto json = medium.find("grid");
  if (!json) return "a grid";
  const ObjectReader grid(medium.context(), *json, "a grid");
  const std::string file = grid.text("file").value_or("");
  grid.accept({"type", "grid_name", "density_name", "density_scale", "emission_name",
               "emission_scale", "scale_emission_by_density", "normalize_size",
               "integration_method", "sampling_method", "step_size", "transform"});
  grid.report_unknown();
  return "the grid \"" + printable(file) + "\", which is not read";
}

}  // namespace

desc::MediumId MediumTable::read(const LocatedJson& json) {
  const ObjectReader object(context_, json, "a medium");
  const std::string name = object.text("name").value_or("");
  const std::optional<std::string> type = object.text("type");
  if (!type) throw SceneError(json.where(), "a medium needs \"type\"");
  if (std::find(kMediumTypes.begin(), kMediumTypes.end(), *type) == kMediumTypes.end()) {
    context_.warnings.add(kUnknownMedium, json.where(),
                          unknown_name_message("medium type", printable(*type), kMediumTypes) +
                              ". The medium is left out",
                          printable(*type));
    return desc::kNone;
  }
  if (*type == "voxel") {
    // Without its grid its extent is unknown; a camera may be in it.
    context_.warnings.add(kNoGrid, json.where(),
                          "a medium of voxels needs " + grid_of(object) + ": it counts as empty",
                          printable(name));
    object.accept({"sigma_a", "sigma_s", "density", "phase_function", "phase", "transmittance",
                   "max_bounces"});
    object.report_unknown();
    return desc::kNone;
  }
  if (*type != "homogeneous") {
    context_.warnings.add(
        kHeterogeneous, json.where(),
        "media of type \"" + *type +
            "\" are not supported: a homogeneous one of its \"density\" stands in",
        printable(name));
    object.accept(
        {"pivot", "falloff_scale", "radius", "center", "unit_point", "falloff_direction"});
  }
  const float density = object.number("density").value_or(1.F);
  desc::Medium medium;
  medium.name = name;
  medium.where = json.where();
  medium.sigma_a = coefficient(object, "sigma_a", density);
  medium.sigma_s = coefficient(object, "sigma_s", density);
  if (const auto phase = object.find({"phase_function", "phase"})) {
    medium.g = phase_of(context_, *phase);
  }
  if (const auto transmittance = object.find("transmittance")) {
    check_transmittance(context_, *transmittance);
  }
  constexpr int kUsualMaxBounces = 1024;
  const int bounces = object.integer("max_bounces").value_or(kUsualMaxBounces);
  const int longest = context_.scene.hints.max_depth.value_or(kUsualPathBounces);
  if (bounces < longest && medium.sigma_s != Vec3(0.F)) {
    const auto limit = object.find("max_bounces");
    context_.warnings.add(kShortPaths, limit ? limit->where() : json.where(),
                          "paths that scatter more than " + std::to_string(bounces) +
                              " times in this medium go on here, up to the " +
                              std::to_string(longest) + " of the integrator",
                          printable(name));
  }
  object.report_unknown();
  context_.scene.media.push_back(std::move(medium));
  return static_cast<desc::MediumId>(context_.scene.media.size()) - 1;
}

void MediumTable::define(const LocatedJson& list) {
  if (!list.is(Kind::Array)) throw SceneError(list.where(), "\"media\" must be an array");
  for (const LocatedJson& json : list.items()) {
    const desc::MediumId id = read(json);
    const auto name = json.find("name");
    if (!name || named_.try_emplace(name->text(), id).second) continue;
    context_.warnings.add(
        kSameMediumName, name->where(),
        "there is another medium \"" + printable(name->text()) + "\" before, which counts",
        printable(name->text()));
  }
}

desc::MediumId MediumTable::resolve(const LocatedJson& json) {
  if (!json.is(Kind::Text)) return read(json);
  if (json.text().empty()) return desc::kNone;
  const auto found = named_.find(json.text());
  if (found != named_.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& entry : named_) names.push_back(printable(entry.first));
  context_.warnings.add(
      kUnknownMedium, json.where(),
      unknown_name_message("medium", printable(json.text()), names) + ". It is left out",
      printable(json.text()));
  return desc::kNone;
}

}  // namespace ajar::tungsten
