#include "import/pbrt/media.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/printable_text.h"
#include "import/common/density.h"
#include "import/common/transforms.h"
#include "import/pbrt/lexer.h"
#include "import/pbrt/nanovdb_file.h"
#include "import/pbrt/own_words.h"
#include "import/pbrt/presets.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kUnreadable{Effect::Surface,
                                  "grids of media cannot be read: they count as empty"};
constexpr WarningKind kUnknownMedium{Effect::Surface, "media are unknown: clear ones stand in"};
constexpr WarningKind kNoEmission{Effect::Light, "media emit light, which is not supported"};
constexpr WarningKind kBesidePreset{Effect::Surface,
                                    "media have a preset and coefficients, which are ignored"};

/// True if the coefficient `name` is a grid of colours.
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

/// Values without the points that were added at each side.
template <typename Value>
void take_inner(std::vector<Value>& values, const desc::Vec3i& resolution, int beyond) {
  if (values.empty() || beyond == 0) return;
  std::vector<Value> inner;
  const desc::Vec3i& n = resolution;
  for (int z = beyond; z < n.z - beyond; ++z) {
    for (int y = beyond; y < n.y - beyond; ++y) {
      for (int x = beyond; x < n.x - beyond; ++x) {
        inner.push_back(values[static_cast<std::size_t>(x) +
                               static_cast<std::size_t>(n.x) *
                                   (static_cast<std::size_t>(y) +
                                    static_cast<std::size_t>(n.y) * static_cast<std::size_t>(z))]);
      }
    }
  }
  values = std::move(inner);
}

/// A coefficient that is the same at all points, which is constant up to the faces of the cube.
std::optional<desc::Rgb> constant_in(const std::vector<desc::Rgb>& factors) {
  const bool is_constant =
      !factors.empty() && std::all_of(factors.begin(), factors.end(),
                                      [&](const desc::Rgb& f) { return f == factors.front(); });
  return is_constant ? std::optional(factors.front()) : std::nullopt;
}

/// A grid, and its place; with the constant coefficient of a grid of colours.
struct PlacedGrid {
  desc::DensityGrid grid;
  Mat4 to_box;
  desc::Rgb sigma_a{1.F}, sigma_s{1.F};
};

/// Restores a grid from the larger one that is written for pbrt (`write_box` in pbrt_writer.cpp).
void read_own_bounds(const SourceLocation& where, const ParameterList& p, PlacedGrid& placed) {
  const std::optional<std::string> points = p.get_string(own_word("points"));
  const std::string border = p.get_string(own_word("border"), "zero");
  const int beyond = p.get_int(own_word("beyond"), 0);
  if (!points) return;
  desc::DensityGrid& grid = placed.grid;
  const desc::Vec3i n = grid.resolution;
  // Product of three integers, which may overflow one.
  const double size = static_cast<double>(std::max(n.x, 0)) *
                      static_cast<double>(std::max(n.y, 0)) * static_cast<double>(std::max(n.z, 0));
  for (const std::size_t count :
       {grid.values.size(), grid.absorption.size(), grid.scattering.size()}) {
    const bool fits = beyond >= 0 && beyond < (std::min({n.x, n.y, n.z}) + 1) / 2 &&
                      (count == 0 || static_cast<double>(count) == size);
    if (!fits) throw SceneError(where, "the medium does not have as many points as it says");
  }
  grid.points = *points == "corners" ? desc::DensityGrid::Points::Corners
                                     : desc::DensityGrid::Points::Centers;
  grid.border =
      border == "clamp" ? desc::DensityGrid::Border::Clamp : desc::DensityGrid::Border::Zero;
  const std::optional<desc::Rgb> sigma_a = constant_in(grid.absorption);
  const std::optional<desc::Rgb> sigma_s = constant_in(grid.scattering);
  if (sigma_a && !grid.scattering.empty() && !sigma_s) {
    placed.sigma_a = *sigma_a;
    grid.absorption.clear();
  } else if (sigma_s && !grid.absorption.empty() && !sigma_a) {
    placed.sigma_s = *sigma_s;
    grid.scattering.clear();
  }
  take_inner(grid.values, n, beyond);
  take_inner(grid.absorption, n, beyond);
  take_inner(grid.scattering, n, beyond);
  grid.resolution -= desc::Vec3i(2 * beyond);
  placed.to_box = Mat4();
}

/// Values at the middles of the cells of a box; 0 beyond. Source: pbrt-v3, media/grid.cpp, and
/// pbrt-v4, media.h and util/containers.h (SampledGrid).
PlacedGrid read_grid(Context& context, const SourceLocation& where, const std::string& type,
                     const ParameterList& p) {
  PlacedGrid placed;
  desc::DensityGrid& grid = placed.grid;
  grid.resolution = {p.get_int("nx", 1), p.get_int("ny", 1), p.get_int("nz", 1)};
  if (type == "rgbgrid") {
    read_colors(context, where, p, grid);
  } else if (const Parameter* density = p.find("density", ParameterKind::Float)) {
    grid.values = density->numbers;
  }
  const Vec3d low(p.get_point("p0", Vec3(0.F)));
  const Vec3d high(p.get_point("p1", Vec3(1.F)));
  placed.to_box = scaling(high - low) * translation(low);
  read_own_bounds(where, p, placed);
  return placed;
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
      const FileBytes bytes = context.files.load(context.files.resolve(file, where));
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

/// pbrt-v3 takes missing parameters from a preset, pbrt-v4 takes all of it.
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
  desc::Rgb constant_a(1.F);  // beside factors of a grid
  desc::Rgb constant_s(1.F);
  if (*type == "heterogeneous" || *type == "uniformgrid" || *type == "rgbgrid") {
    PlacedGrid placed = read_grid(context, where, *type, parameters);
    constant_a = placed.sigma_a;
    constant_s = placed.sigma_s;
    medium.density = make_density(std::move(placed.grid), placed.to_box * to_world, where, name,
                                  context.warnings);
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
  medium.sigma_a =
      is_colored ? constant_a * scale : coefficient("sigma_a", defaults.sigma_a) * scale;
  medium.sigma_s =
      is_colored ? constant_s * scale : coefficient("sigma_s", defaults.sigma_s) * scale;
  if (!is_finite(medium.sigma_a) || !is_finite(medium.sigma_s))
    throw SceneError(where, "the medium is too dense");
  if (context.is_v4()) warn_of_parameters_that_emit(context, where, name, parameters);
  parameters.report_unused(context.warnings);
  return medium;
}

}  // namespace ajar::pbrt
