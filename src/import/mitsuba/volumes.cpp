#include "import/mitsuba/volumes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/printable_text.h"
#include "import/common/density.h"
#include "import/common/transforms.h"
#include "import/mitsuba/plugin_types.h"
#include "import/mitsuba/volume_file.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kUnreadable{Effect::Surface,
                                  "grids of media cannot be read: they count as empty"};
constexpr WarningKind kUnknownVolume{Effect::Surface,
                                     "volumes are not supported: one value for all stands in"};
constexpr WarningKind kVaries{Effect::Surface,
                              "media vary in what is not supported to: the mean stands in"};
constexpr WarningKind kLattice{
    Effect::Slight, "albedos of media vary in another grid than their density: in that of it"};
constexpr WarningKind kTurnedGrid{
    Effect::Slight, "grids of media are turned: Mitsuba goes on with their border around them"};
constexpr WarningKind kLookup{Effect::Slight,
                              "grids of media are not looked up as they should be: trilinearly"};

/// Volume inside of caches; null if there is nothing.
const Element* without_caches(Context& context, const Element* volume) {
  if (volume == nullptr || volume->type != "volcache") return volume;
  Arguments cache(context, *volume);
  cache.accept({"voxel_width", "memory_limit"});
  return without_caches(context, cache.only_child("volume"));
}

/// The volume that is `name` to the medium, without the caches around it; null if there is none.
const Element* find_volume(Arguments& medium, std::string_view name) {
  return without_caches(medium.context(), medium.child(name, "volume"));
}

bool is_grid(const Element& volume) { return volume.type == "gridvolume" || volume.type == "grid"; }

/// Value of a volume that is constant, or is taken to be.
std::optional<desc::Rgb> constant(Arguments& volume, const char* fallback) {
  const std::string& type = volume.element().type;
  const std::optional<desc::Rgb> value = volume.color(type == "srgb" ? "color" : "value");
  if (!is_known(volume.element())) {
    volume.context().warnings.add(kUnknownVolume, volume.where(),
                                  unknown_type_message(volume.element()) + ". " +
                                      (value ? "Its \"value\"" : fallback) + " stands in",
                                  printable(type));
    volume.accept_all();
  }
  return value;
}

/// The file of a grid; nothing, after a warning, if it cannot be read.
std::optional<VolumeFile> load(Arguments& grid) {
  Context& context = grid.context();
  const std::string name = grid.text("filename", "");
  std::string reason = "it has no \"filename\"";
  if (!name.empty()) {
    const SourceLocation in_file{std::make_shared<const std::string>(printable(name)), 0, 0};
    try {
      FileAccess& files = context.files.files();
      const std::string path = files.resolve(context.files.find(name), grid.where());
      return read_volume_file(files.load(path).view(), in_file);
    } catch (const Error& error) {
      reason = error.what();
    }
  }
  context.warnings.add(kUnreadable, grid.where(),
                       "this grid cannot be read (" + reason + "): it counts as empty",
                       printable(name));
  return std::nullopt;
}

/// One number for each point: the mean of its channels.
std::vector<float> mean_channels(const VolumeFile& file) {
  const auto channels = static_cast<std::size_t>(file.channels);
  std::vector<float> result(file.values.size() / channels, 0.F);
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t channel = 0; channel < channels; ++channel) {
      result[i] += file.values[i * channels + channel];
    }
    result[i] /= static_cast<float>(channels);
  }
  return result;
}

/// Transform of the unit cube. In version 0 the file says where its box is, unless the scene does;
/// in later ones the box is the unit cube, unless the scene asks for that of the file.
Mat4 place_of(Arguments& grid, const VolumeFile& file) {
  const Mat4 to_world = grid.transform("to_world").value_or(Mat4());
  Vec3 low(0.F);
  Vec3 high(1.F);
  if (grid.context().document.major_version == 0) {
    const std::optional<Vec3d> given_low = grid.vector("min");
    const std::optional<Vec3d> given_high = grid.vector("max");
    const bool is_given = given_low && given_high;
    low = is_given ? Vec3(*given_low) : file.low;
    high = is_given ? Vec3(*given_high) : file.high;
    grid.accept({"send_data"});
  } else if (grid.flag("use_grid_bbox", false)) {
    low = file.low;
    high = file.high;
  }
  return scaling(Vec3d(high - low)) * translation(Vec3d(low)) * to_world;
}

/// Interpolation of the points that the scene asks for.
void read_lookup(Arguments& grid, bool has_border) {
  const std::string filter = grid.text("filter_type", "trilinear");
  const std::string wrap = grid.text("wrap_mode", "clamp");
  grid.accept({"raw", "accel", "max_value"});
  if (filter == "trilinear" && (wrap == "clamp" || !has_border)) return;
  grid.context().warnings.add(kLookup, grid.where(),
                              "only grids that are trilinear and clamped are supported, not \"" +
                                  printable(filter) + "\" and \"" + printable(wrap) +
                                  "\": such a one stands in");
}

/// The box around the image of the unit cube, parallel to the axes.
Imath::Box3d box_of(const Mat4& cube) {
  Imath::Box3d box;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d at((corner & 1) != 0 ? 1.0 : 0.0, (corner & 2) != 0 ? 1.0 : 0.0,
                   (corner & 4) != 0 ? 1.0 : 0.0);
    Vec3d placed;
    cube.multVecMatrix(at, placed);
    box.extendBy(placed);
  }
  return box;
}

/// True if that box is larger.
bool is_turned(const Mat4& cube) {
  const Vec3d size = box_of(cube).size();
  const double whole = size.x * size.y * size.z;
  const Vec3d x(cube[0][0], cube[0][1], cube[0][2]);
  const Vec3d y(cube[1][0], cube[1][1], cube[1][2]);
  const Vec3d z(cube[2][0], cube[2][1], cube[2][2]);
  return whole - std::abs(x.cross(y).dot(z)) > 1e-4 * whole;
}

bool has_border(const VolumeGrid& grid) {
  const Vec3d size(grid.resolution);
  for (std::size_t i = 0; i < grid.point_count(); ++i) {
    const auto nx = static_cast<std::size_t>(grid.resolution.x);
    const auto ny = static_cast<std::size_t>(grid.resolution.y);
    const Vec3d at(static_cast<double>(i % nx), static_cast<double>(i / nx % ny),
                   static_cast<double>(i / nx / ny));
    const auto is_outmost = [&](int axis) {
      return at[axis] == 0.0 || at[axis] == size[axis] - 1.0;
    };
    if ((is_outmost(0) || is_outmost(1) || is_outmost(2)) && grid.at(i) != desc::Rgb(0.F)) {
      return true;
    }
  }
  return false;
}

VolumeValue read_grid(Arguments& grid) {
  const std::optional<VolumeFile> file = load(grid);
  const bool is_version_0 = grid.context().document.major_version == 0;
  read_lookup(grid, !is_version_0);
  const Mat4 to_world = place_of(grid, file.value_or(VolumeFile()));
  if (!file) return {};

  VolumeGrid result;
  const bool is_usual = file->channels == 1 || file->channels == 3;
  if (!is_usual) {
    grid.context().warnings.add(kVaries, grid.where(),
                                "grids of " + std::to_string(file->channels) +
                                    " channels are not supported: the mean of the channels stands "
                                    "in",
                                printable(grid.text("filename", "")));
  }
  result.resolution = file->resolution;
  result.channels = is_usual ? file->channels : 1;
  result.values = is_usual ? file->values : mean_channels(*file);
  using Points = desc::DensityGrid::Points;
  result.points = is_version_0 ? Points::Corners : Points::Centers;
  result.to_world = to_world;
  if (!is_version_0 && is_turned(to_world) && has_border(result)) {
    grid.context().warnings.add(
        kTurnedGrid, grid.where(),
        "this grid is turned, and not 0 at its border: Mitsuba goes on with "
        "that to the box around it, here is nothing");
  }
  // Also of albedos, whose points decide no places: damaged ones are errors here.
  desc::DensityGrid lattice = lattice_of(result);
  lattice.values.resize(result.point_count());
  place_grid(std::make_shared<const desc::DensityGrid>(std::move(lattice)), to_world, grid.where());
  return {desc::Rgb(1.F), std::move(result)};
}

/// Instead of a grid.
desc::Rgb mean_of(Arguments& arguments, const VolumeValue& value, const char* what) {
  if (!value.grid) return value.color;
  arguments.context().warnings.add(kVaries, arguments.where(),
                                   std::string(what) +
                                       " that vary are not supported here: the mean of the grid "
                                       "stands in");
  return value.color * value.grid->mean();
}

}  // namespace

std::optional<VolumeValue> find_density(Arguments& medium, std::string_view name) {
  if (const Element* volume = find_volume(medium, name)) {
    Arguments of_volume(medium.context(), *volume);
    if (is_grid(*volume)) return read_grid(of_volume);
    const desc::Rgb color = constant(of_volume, "A density of 1").value_or(desc::Rgb(1.F));
    return constant_density(medium, color, of_volume.transform("to_world").value_or(Mat4()));
  }
  const std::optional<desc::Rgb> color = find_coefficient(medium, name);
  return color ? std::optional(constant_density(medium, *color)) : std::nullopt;
}

VolumeValue constant_density(const Arguments& medium, const desc::Rgb& color, const Mat4& cube) {
  const bool has_cube =
      medium.context().document.major_version != 0 && medium.element().type == "heterogeneous";
  if (!has_cube) return VolumeValue{color};
  const Imath::Box3d box = box_of(cube);
  VolumeGrid one;
  one.to_world = scaling(box.size()) * translation(box.min);
  one.values = {1.F};
  return {color, std::move(one)};
}

std::optional<VolumeValue> find_albedo(Arguments& medium, std::string_view name) {
  if (const Element* volume = find_volume(medium, name); volume != nullptr && is_grid(*volume)) {
    Arguments of_volume(medium.context(), *volume);
    return read_grid(of_volume);
  }
  const std::optional<desc::Rgb> color = find_coefficient(medium, name);
  return color ? std::optional(VolumeValue{*color}) : std::nullopt;
}

std::optional<desc::Rgb> find_coefficient(Arguments& medium, std::string_view name) {
  const Element* volume = find_volume(medium, name);
  if (volume == nullptr) return medium.color(name);
  Arguments of_volume(medium.context(), *volume);
  if (is_grid(*volume)) return mean_of(of_volume, read_grid(of_volume), "coefficients");
  return constant(of_volume, "The default");
}

void set_extinction(Arguments& arguments, desc::Medium& medium, VolumeValue sigma_t,
                    const VolumeValue& albedo) {
  Warnings& warnings = arguments.context().warnings;
  const std::string& name = medium.name;
  if (sigma_t.grid && albedo.grid && sigma_t.grid->point_count() == 1) {
    // A constant can have the points of the albedo.
    VolumeGrid& grid = *sigma_t.grid;
    sigma_t.color *= grid.at(0);
    grid.resolution = albedo.grid->resolution;
    grid.points = albedo.grid->points;
    grid.channels = 1;
    grid.values.assign(albedo.grid->point_count(), 1.F);
  }
  if (sigma_t.grid && (sigma_t.grid->is_colored() || albedo.grid)) {
    const VolumeGrid* albedos = albedo.grid ? &*albedo.grid : nullptr;
    if (albedos != nullptr && !albedos->has_lattice_of(*sigma_t.grid)) {
      warnings.add(kLattice, arguments.where(),
                   "the albedo of this medium varies in another grid than its density: it is "
                   "looked up at the points of that");
    }
    medium.density = make_density(color_grid(sigma_t.color, *sigma_t.grid, albedo.color, albedos),
                                  sigma_t.grid->to_world, arguments.where(), name, warnings);
    medium.sigma_a = medium.sigma_s = desc::Rgb(1.F);
    return;
  }
  if (sigma_t.grid) {
    desc::DensityGrid density = lattice_of(*sigma_t.grid);
    density.values = sigma_t.grid->values;
    medium.density =
        make_density(std::move(density), sigma_t.grid->to_world, arguments.where(), name, warnings);
  }
  medium.sigma_s = sigma_t.color * mean_of(arguments, albedo, "albedos of constant densities");
  medium.sigma_a = sigma_t.color - medium.sigma_s;
}

}  // namespace ajar::mitsuba
