#include "import/mitsuba/volumes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "import/common/density.h"
#include "import/common/printable.h"
#include "import/common/transforms.h"
#include "import/mitsuba/volume_file.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kUnreadable{Effect::Surface,
                                  "grids of media cannot be read: they count as empty"};
constexpr WarningKind kUnknownVolume{Effect::Surface,
                                     "volumes are not supported: one value for all stands in"};
constexpr WarningKind kColors{
    Effect::Surface, "media have colours that vary, which is not supported: the mean stands in"};
constexpr WarningKind kLookup{Effect::Slight,
                              "grids of media are not looked up as they should be: trilinearly"};

const std::vector<std::string> kTypes = {"gridvolume", "constvolume"};

/// The volume that is `name` to the medium, without the caches around it; null if there is none.
const Element* find_volume(Arguments& medium, std::string_view name) {
  const Element* volume = medium.child(name, "volume");
  while (volume != nullptr && volume->type == "volcache") {
    Arguments cache(medium.context(), *volume);
    const std::vector<const Element*> cached = cache.children("volume");
    cache.accept({"voxel_width", "memory_limit"});
    cache.report_unused();
    volume = cached.empty() ? nullptr : cached.front();
  }
  return volume;
}

bool is_grid(const Element& volume) { return volume.type == "gridvolume" || volume.type == "grid"; }

/// Of volumes that are the same everywhere, or are taken to be.
std::optional<desc::Rgb> constant(Arguments& volume, const char* fallback) {
  const std::string& type = volume.element().type;
  const std::optional<desc::Rgb> value = volume.color(type == "srgb" ? "color" : "value");
  if (type != "constvolume" && type != "uniform" && type != "srgb") {
    volume.context().warnings.add(kUnknownVolume, volume.where(),
                                  unknown_name_message("volume", printable(type), kTypes) + ". " +
                                      (value ? "Its \"value\"" : fallback) + " stands in",
                                  printable(type));
    volume.accept_all();
  }
  volume.report_unused();
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
      const std::string path = files.resolve(context.files.find(name));
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

/// Mean of each channel; of one channel three times the same. What is not finite does not count.
desc::Rgb mean_of(const VolumeFile& file) {
  Vec3d sum(0.0);
  const auto channels = static_cast<std::size_t>(file.channels);
  for (std::size_t i = 0; i < file.values.size(); i += channels) {
    for (int lane = 0; lane < 3; ++lane) {
      const float value = file.values[i + (channels == 3 ? static_cast<std::size_t>(lane) : 0)];
      if (std::isfinite(value)) sum[lane] += static_cast<double>(value);
    }
  }
  return desc::Rgb(sum * (static_cast<double>(channels) / static_cast<double>(file.values.size())));
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

/// Of the unit cube. In version 0 the file says where its box is, unless the scene does; in later
/// ones the box is the unit cube, unless the scene asks for that of the file.
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

VolumeValue grid_density(Arguments& grid) {
  const std::optional<VolumeFile> file = load(grid);
  const bool is_version_0 = grid.context().document.major_version == 0;
  read_lookup(grid, !is_version_0);
  const Mat4 to_world = place_of(grid, file.value_or(VolumeFile()));
  grid.report_unused();
  if (!file) return {};

  VolumeValue result{desc::Rgb(1.F)};
  if (file->channels > 1) {
    const desc::Rgb mean = mean_of(*file);
    const float grey = (mean[0] + mean[1] + mean[2]) / 3.F;
    if (grey > 0.F && std::isfinite(grey)) result.color = mean / grey;
    grid.context().warnings.add(kColors, grid.where(),
                                "densities of several channels are not supported: their mean "
                                "varies, in the mean of the colours",
                                printable(grid.text("filename", "")));
  }
  desc::DensityGrid density;
  density.resolution = file->resolution;
  density.values = mean_channels(*file);
  using Grid = desc::DensityGrid;
  density.points = is_version_0 ? Grid::Points::Corners : Grid::Points::Centers;
  density.border = Grid::Border::Clamp;
  result.density = make_density(std::move(density), to_world, grid.where(),
                                grid.text("filename", ""), grid.context().warnings);
  return result;
}

desc::Rgb grid_mean(Arguments& grid) {
  const std::optional<VolumeFile> file = load(grid);
  grid.accept_all();
  if (!file) return desc::Rgb(0.F);
  grid.context().warnings.add(kColors, grid.where(),
                              "coefficients that vary are not supported, but for the density: the "
                              "mean of this grid stands in",
                              printable(grid.text("filename", "")));
  return mean_of(*file);
}

}  // namespace

std::optional<VolumeValue> find_density(Arguments& medium, std::string_view name) {
  if (const Element* volume = find_volume(medium, name)) {
    Arguments of_volume(medium.context(), *volume);
    if (is_grid(*volume)) return grid_density(of_volume);
    return VolumeValue{constant(of_volume, "A density of 1").value_or(desc::Rgb(1.F))};
  }
  const std::optional<desc::Rgb> color = find_coefficient(medium, name);
  return color ? std::optional(VolumeValue{*color}) : std::nullopt;
}

std::optional<desc::Rgb> find_coefficient(Arguments& medium, std::string_view name) {
  const Element* volume = find_volume(medium, name);
  if (volume == nullptr) volume = medium.child(name, "texture");
  if (volume == nullptr) return medium.color(name);
  Arguments of_volume(medium.context(), *volume);
  if (is_grid(*volume)) return grid_mean(of_volume);
  return constant(of_volume, "The default");
}

}  // namespace ajar::mitsuba
