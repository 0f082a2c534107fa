#include "import/pbrt/film.h"

#include <algorithm>

#include "core/printable_text.h"
#include "import/common/resolution.h"
#include "import/pbrt/lexer.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kFilmScale{Effect::Light, "films have a scale that leaves no picture"};
constexpr WarningKind kClamping{Effect::Slight,
                                "films clamp bright samples, which is not supported"};
constexpr WarningKind kUnknownFilm{Effect::Slight, "films are unknown: others stand in"};
constexpr WarningKind kUnknownFilter{Effect::Slight, "filters are unknown: others stand in"};
constexpr WarningKind kSensor{
    Effect::Slight,
    "films have the sensor of a camera, which is not supported: an ideal one "
    "stands in"};
constexpr WarningKind kBounds{Effect::Slight, "films have \"pixelbounds\" that do not fit"};

void set_crop(const SourceLocation& where, desc::Film& film, std::size_t side, float from,
              float to) {
  film.crop[side] = std::clamp(std::min(from, to), 0.F, 1.F);
  film.crop[side + 1] = std::clamp(std::max(from, to), 0.F, 1.F);
  if (!(film.crop[side] < film.crop[side + 1])) throw SceneError(where, "the crop window is empty");
}

void read_crop_window(const ParameterList& p, desc::Film& film) {
  const Parameter* crop = p.find("cropwindow", ParameterKind::Float);
  if (crop == nullptr) return;
  const std::vector<float>& n = crop->numbers;
  if (n.size() != 4)
    throw SceneError(crop->where, "\"cropwindow\" must have four numbers: x from, to, y from, to");
  for (std::size_t i = 0; i < 4; i += 2) set_crop(crop->where, film, i, n[i], n[i + 1]);
}

/// pbrt-v4: the crop window in pixels, which one in fractions overrides.
void read_pixel_bounds(Context& context, const ParameterList& p, desc::Film& film) {
  const Parameter* bounds = p.find("pixelbounds", ParameterKind::Integer);
  if (bounds == nullptr) return;
  const std::vector<int>& n = bounds->integers;
  if (n.size() != 4)
    throw SceneError(bounds->where,
                     "\"pixelbounds\" must have four numbers: x from, to, y from, to");
  const int sizes[2] = {film.resolution.x, film.resolution.y};
  for (std::size_t i = 0; i < 2; ++i) {
    const int from = n[2 * i];
    const int to = n[2 * i + 1];
    if (from < 0 || to > sizes[i]) {
      context.warnings.add(kBounds, bounds->where,
                           "\"pixelbounds\" are larger than the picture: cut");
    }
    const auto size = static_cast<float>(sizes[i]);
    set_crop(bounds->where, film, 2 * i, static_cast<float>(from) / size,
             static_cast<float>(to) / size);
  }
}

/// Scale of the picture by pbrt-v4's sensor.
float sensor_scale(Context& context, const SourceLocation& where, const ParameterList& p) {
  const std::string sensor = p.get_string("sensor", "cie1931");
  if (sensor != "cie1931") {
    context.warnings.add(kSensor, where,
                         "the sensor \"" + printable(sensor) +
                             "\" is not supported: an ideal one (cie1931) stands in",
                         printable(sensor));
  } else if (p.get_float("whitebalance", 0.F) != 0.F) {
    context.warnings.add(kSensor, where, "\"whitebalance\" is not supported: left as it is");
  }
  p.accept({"whitebalance", "savefp16", "coordinatesystem", "nbuckets", "lambdamin", "lambdamax"});
  const float iso = p.get_float("iso", 100.F);
  if (!(iso > 0.F)) throw SceneError(where, "\"iso\" must be positive");
  return iso / 100.F;
}

}  // namespace

FilmOptions make_film(Context& context, const SourceLocation& where, const std::string& type,
                      const ParameterList& p) {
  const std::vector<std::string> types =
      context.is_v4() ? std::vector<std::string>{"rgb", "gbuffer", "spectral"}
                      : std::vector<std::string>{"image"};
  if (std::find(types.begin(), types.end(), type) == types.end()) {
    report_unknown(context, where, "film", type, types, kUnknownFilm, "\"rgb\" stands in");
  }
  FilmOptions result;
  desc::Film& film = result.film;
  film.where = where;
  film.resolution = Vec2i(p.get_int("xresolution", 1280), p.get_int("yresolution", 720));
  for (const int n : {film.resolution.x, film.resolution.y}) {
    if (n < 1 || n > kLargestResolution) {
      throw SceneError(where, "the resolution must be 1 to " + std::to_string(kLargestResolution) +
                                  ", not " + std::to_string(n));
    }
  }
  const char* clamping = context.is_v4() ? "maxcomponentvalue" : "maxsampleluminance";
  if (context.is_v4()) {
    read_pixel_bounds(context, p, film);
    film.scale = sensor_scale(context, where, p);
  } else {
    film.scale = p.get_float("scale", 1.F);
    if (!(film.scale > 0.F)) {
      context.warnings.add(kFilmScale, where,
                           film.scale < 0.F ? "\"scale\" of the film is negative: so is the picture"
                                            : "\"scale\" of the film is 0: the picture is black");
    }
  }
  read_crop_window(p, film);
  result.diagonal = p.get_float("diagonal", 35.F);
  film.filename = p.get_string("filename", "pbrt.exr");
  if (p.get_float(clamping)) {
    context.warnings.add(
        kClamping, where,
        "\"" + std::string(clamping) + "\" is not supported: samples are not clamped");
  }
  p.report_unused(context.warnings);
  return result;
}

desc::Filter default_filter(Dialect dialect) {
  desc::Filter filter;
  if (dialect == Dialect::V4) {
    filter.node = desc::GaussianFilter{2.F};
    filter.radius = Vec2(1.5F);
  }
  return filter;
}

desc::Filter make_filter(Context& context, const SourceLocation& where, const std::string& type,
                         const ParameterList& p) {
  const bool is_v4 = context.is_v4();
  desc::Filter filter;
  filter.where = where;
  float radius = 2.F;  // the default of most
  if (type == "box") {
    radius = 0.5F;
    filter.node = desc::BoxFilter{};
  } else if (type == "triangle") {
    filter.node = desc::TriangleFilter{};
  } else if (type == "gaussian" && is_v4) {
    radius = 1.5F;
    const float sigma = p.get_float("sigma", 0.5F);
    if (!(sigma > 0.F)) throw SceneError(where, "\"sigma\" of a filter must be positive");
    filter.node = desc::GaussianFilter{0.5F / (sigma * sigma)};
  } else if (type == "gaussian") {
    filter.node = desc::GaussianFilter{p.get_float("alpha", 2.F)};
  } else if (type == "mitchell") {
    filter.node = desc::MitchellFilter{p.get_float("B", 1.F / 3.F), p.get_float("C", 1.F / 3.F)};
  } else if (type == "sinc") {
    radius = 4.F;
    filter.node = desc::SincFilter{p.get_float("tau", 3.F)};
  } else {
    report_unknown(context, where, "filter", type,
                   {"box", "triangle", "gaussian", "mitchell", "sinc"}, kUnknownFilter,
                   "A gaussian one stands in");
    filter = default_filter(context.choice.dialect);
    filter.where = where;
    return filter;
  }
  filter.radius = Vec2(p.get_float(is_v4 ? "xradius" : "xwidth", radius),
                       p.get_float(is_v4 ? "yradius" : "ywidth", radius));
  constexpr float kLargest = 64.F;
  for (const float r : {filter.radius.x, filter.radius.y}) {
    if (!(r > 0.F && r <= kLargest))
      throw SceneError(where, "the filter width must be above 0 and at most 64 pixels");
  }
  p.report_unused(context.warnings);
  return filter;
}

}  // namespace ajar::pbrt
