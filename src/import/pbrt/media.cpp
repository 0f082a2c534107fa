#include "import/pbrt/media.h"

#include <algorithm>

#include "import/common/density.h"
#include "import/common/printable.h"
#include "import/common/transforms.h"
#include "import/pbrt/lexer.h"
#include "import/pbrt/nanovdb_file.h"
#include "import/pbrt/presets.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kUnreadable{Effect::Surface,
                                  "grids of media cannot be read: they count as empty"};
constexpr WarningKind kUnknownMedium{Effect::Surface, "media are unknown: clear ones stand in"};
constexpr WarningKind kNoEmission{Effect::Light, "media emit light, which is not supported"};
constexpr WarningKind kBesidePreset{Effect::Surface,
                                    "media have a preset and coefficients, which are ignored"};

/// Whether the coefficient `name` is a grid of colours.
const Parameter* color_grid(const ParameterList& parameters, std::string_view name) {
  const Parameter* grid = parameters.find(name, ParameterKind::Rgb);
  return grid != nullptr && grid->size() > 1 ? grid : nullptr;
}

/// Factors of 1 for each lane. Source: pbrt-v4, media.h and media.cpp (RGBGridMedium).
void read_colors(Context& context, const SourceLocation& where, const ParameterList& parameters,
                 desc::DensityGrid& grid) {
  const Parameter* sigma_a = parameters.find("sigma_a", ParameterKind::Rgb);
  const Parameter* sigma_s = parameters.find("sigma_s", ParameterKind::Rgb);
  if (sigma_a != nullptr) grid.absorption = context.spectra.colors(*sigma_a);
  if (sigma_s != nullptr) grid.scattering = context.spectra.colors(*sigma_s);
  if (!grid.is_colored()) {
    throw SceneError(where,
                     "a medium of type \"rgbgrid\" needs \"rgb sigma_a\" or \"rgb sigma_s\"");
  }
  if (sigma_a != nullptr && sigma_s != nullptr &&
      grid.absorption.size() != grid.scattering.size()) {
    throw SceneError(where, "\"sigma_a\" and \"sigma_s\" of the medium differ in size");
  }
}

/// Values at the middles of the cells of a box; 0 beyond. Source: pbrt-v3, media/grid.cpp, and
/// pbrt-v4, media.h and util/containers.h (SampledGrid).
desc::Density read_grid(Context& context, const SourceLocation& where, const std::string& type,
                        const std::string& name, const ParameterList& p, const Mat4& to_world) {
  desc::DensityGrid grid;
  grid.resolution = {p.get_int("nx", 1), p.get_int("ny", 1), p.get_int("nz", 1)};
  if (type == "rgbgrid") {
    read_colors(context, where, p, grid);
  } else if (const Parameter* density = p.find("density", ParameterKind::Float)) {
    grid.values = density->numbers;
  }
  const Vec3d low(p.get_point("p0", Vec3(0.F)));
  const Vec3d high(p.get_point("p1", Vec3(1.F)));
  return make_density(std::move(grid), scaling(high - low) * translation(low) * to_world, where,
                      name, context.warnings);
}

void warn_of_emission(Context& context, const SourceLocation& where, const std::string& name) {
  context.warnings.add(kNoEmission, where, "media that emit light are not supported: dark",
                       printable(name));
}

/// The density of a file of NanoVDB; nothing, after a warning, if it cannot be read.
/// Source: pbrt-v4, media.h and media.cpp (NanoVDBMedium).
std::optional<desc::Density> read_voxels(Context& context, const SourceLocation& where,
                                         const std::string& name, const ParameterList& p,
                                         const Mat4& to_world) {
  const std::string file = p.get_string("filename").value_or("");
  std::string reason = "it has no \"filename\"";
  if (!file.empty()) {
    const SourceLocation in_file{std::make_shared<const std::string>(printable(file)), 0, 0};
    try {
      const FileBytes bytes = context.files.load(context.files.resolve(file));
      const float emitted = p.get_float("LeScale", p.get_float("Lescale", 1.F));
      if (emitted > 0.F && has_nanovdb_grid(bytes.view(), "temperature", in_file)) {
        warn_of_emission(context, where, name);
      }
      if (std::optional<VoxelGrid> voxels = read_nanovdb(bytes.view(), "density", in_file)) {
        return make_density(std::move(voxels->grid), voxels->to_world * to_world, where, name,
                            context.warnings);
      }
      reason = "it has no grid \"density\"";
    } catch (const Error& error) {
      reason = error.what();
    }
  }
  context.warnings.add(
      kUnreadable, where,
      "the grid of this medium cannot be read (" + reason + "): it counts as empty",
      printable(name));
  return std::nullopt;
}

desc::Density read_cloud(Context& context, const SourceLocation& where, const std::string& name,
                         const ParameterList& p, const Mat4& to_world) {
  Cloud cloud;
  cloud.density = p.get_float("density", cloud.density);
  cloud.wispiness = p.get_float("wispiness", cloud.wispiness);
  cloud.frequency = p.get_float("frequency", cloud.frequency);
  cloud.low = p.get_point("p0", cloud.low);
  cloud.high = p.get_point("p1", cloud.high);
  return place_grid(
      context.clouds.get(cloud, where, name, context.warnings),
      scaling(Vec3d(cloud.high - cloud.low)) * translation(Vec3d(cloud.low)) * to_world, where);
}

void warn_of_parameters_that_emit(Context& context, const SourceLocation& where,
                                  const std::string& name, const ParameterList& p) {
  const bool has_grid = color_grid(p, "Le") != nullptr;
  const desc::Rgb emitted =
      has_grid ? desc::Rgb(1.F)
               : context.spectra.get_positive(p, "Le", desc::Rgb(0.F), ColorRole::Light);
  const Parameter* temperatures = p.find("temperature", ParameterKind::Float);
  const bool glows = emitted != desc::Rgb(0.F) || temperatures != nullptr ||
                     p.get_float("temperaturescale").has_value();
  p.accept({"Lescale", "LeScale", "temperaturecutoff", "temperaturescale", "temperatureoffset"});
  if (glows) warn_of_emission(context, where, name);
}

/// pbrt-v3 takes from a preset what no parameter says, pbrt-v4 takes all of it.
void warn_beside_preset(Context& context, const Parameter* coefficient) {
  if (coefficient == nullptr) return;
  context.warnings.add(kBesidePreset, coefficient->where,
                       "\"" + coefficient->name + "\" is ignored: \"preset\" says it",
                       coefficient->name);
}

}  // namespace

desc::Medium make_medium(Context& context, const SourceLocation& where, const std::string& name,
                         const ParameterList& parameters, const Mat4& to_world) {
  // pbrt-v3 has no grids of colours: the word is ours there, for those that we write.
  static const std::vector<std::string> kTypesOfV3 = {"homogeneous", "heterogeneous", "rgbgrid"};
  static const std::vector<std::string> kTypesOfV4 = {"homogeneous", "uniformgrid", "rgbgrid",
                                                      "cloud", "nanovdb"};
  desc::Medium medium;
  medium.name = name;
  medium.where = where;
  const std::optional<std::string> type = parameters.get_string("type");
  if (!type) throw SceneError(where, "MakeNamedMedium needs \"string type\"");
  const std::vector<std::string>& types = context.is_v4() ? kTypesOfV4 : kTypesOfV3;
  if (std::find(types.begin(), types.end(), *type) == types.end()) {
    report_unknown(context, where, "medium", *type, types, kUnknownMedium, "A clear one stands in");
    return medium;
  }
  const std::optional<std::string> preset_name = parameters.get_string("preset");
  const std::optional<ScatteringPreset> preset = preset_named(context, where, preset_name);
  const bool says_all = context.is_v4() && preset && find_scattering_preset(*preset_name);
  // pbrt-v3 always starts from a preset; pbrt-v4 has 1 without one, and with one nothing else.
  const ScatteringPreset defaults = preset.value_or(
      context.is_v4() ? ScatteringPreset{desc::Rgb(1.F), desc::Rgb(1.F)} : default_preset());
  const auto coefficient = [&](std::string_view parameter, const desc::Rgb& fallback) {
    if (says_all) {
      warn_beside_preset(context, parameters.find(parameter, kSpectrumKinds));
      return fallback;
    }
    return context.spectra.get_positive(parameters, parameter, fallback);
  };
  float scale = parameters.get_float("scale", 1.F);
  if (*type == "heterogeneous" || *type == "uniformgrid" || *type == "rgbgrid") {
    medium.density = read_grid(context, where, *type, name, parameters, to_world);
  } else if (*type == "nanovdb") {
    medium.density = read_voxels(context, where, name, parameters, to_world);
    if (!medium.density) scale = 0.F;
  } else if (*type == "cloud") {
    medium.density = read_cloud(context, where, name, parameters, to_world);
  }
  medium.g = parameters.get_float("g", 0.F);
  if (scale < 0.F) throw SceneError(where, "\"scale\" of a medium is negative");
  if (!(medium.g > -1.F && medium.g < 1.F))
    throw SceneError(where, "\"g\" must be between -1 and 1");
  const bool is_colored = medium.density && medium.density->grid->is_colored();
  medium.sigma_a = is_colored ? desc::Rgb(scale) : coefficient("sigma_a", defaults.sigma_a) * scale;
  medium.sigma_s = is_colored ? desc::Rgb(scale) : coefficient("sigma_s", defaults.sigma_s) * scale;
  if (!is_finite(medium.sigma_a) || !is_finite(medium.sigma_s))
    throw SceneError(where, "the medium is too dense");
  if (context.is_v4()) warn_of_parameters_that_emit(context, where, name, parameters);
  parameters.report_unused(context.warnings);
  return medium;
}

}  // namespace ajar::pbrt
