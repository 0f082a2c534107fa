#include <algorithm>
#include <cmath>

#include "core/printable_text.h"
#include "import/common/resolution.h"
#include "import/mitsuba/plugin_types.h"
#include "import/mitsuba/sensor.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kLuminance{Effect::Surface, "pictures of luminance are not supported"};
constexpr WarningKind kSpectralFilm{Effect::Slight, "pictures of wavelengths are not supported"};
constexpr WarningKind kToneMap{Effect::Light, "tone maps are not supported: pictures are linear"};
constexpr WarningKind kUnknownFilm{Effect::Slight, "films are unknown: that of hdrfilm stands in"};
constexpr WarningKind kFilter{Effect::Slight, "filters are unknown: gaussian ones stand in"};

int read_size(Arguments& arguments, std::string_view name, int fallback) {
  const long long size = arguments.integer(name).value_or(fallback);
  if (size < 1 || size > kLargestResolution) {
    throw SceneError(arguments.where(), "\"" + std::string(name) + "\" must be 1 to " +
                                            std::to_string(kLargestResolution) + ", not " +
                                            std::to_string(size));
  }
  return static_cast<int>(size);
}

/// Sets the part of one side that is rendered, as fractions.
void read_crop(Arguments& arguments, std::string_view offset_name, std::string_view size_name,
               int whole, float* from) {
  const long long offset = arguments.integer(offset_name).value_or(0);
  const long long size = arguments.integer(size_name).value_or(whole - offset);
  if (offset < 0 || size < 1 || offset > whole || size > whole - offset) {
    throw SceneError(arguments.where(), "the crop window is empty or reaches beyond the film");
  }
  from[0] = static_cast<float>(static_cast<double>(offset) / whole);
  from[1] = static_cast<float>(static_cast<double>(offset + size) / whole);
}

desc::Filter gaussian(float deviation) {
  desc::Filter filter;
  filter.node = desc::GaussianFilter{1.F / (2.F * deviation * deviation)};
  filter.radius = Vec2(4.F * deviation);
  return filter;
}

desc::Filter make_filter(Arguments& arguments) {
  constexpr float kDeviation = 0.5F;
  const std::string& type = arguments.element().type;
  desc::Filter filter;
  float radius = 2.F;
  if (type == "box") {
    radius = arguments.number("radius", 0.5F);
    filter.node = desc::BoxFilter{};
  } else if (type == "tent") {
    radius = arguments.number("radius", 1.F);
    filter.node = desc::TriangleFilter{};
  } else if (type == "mitchell") {
    filter.node = desc::MitchellFilter{arguments.number("b", arguments.number("B", 1.F / 3.F)),
                                       arguments.number("c", arguments.number("C", 1.F / 3.F))};
  } else if (type == "catmullrom") {
    filter.node = desc::MitchellFilter{0.F, 0.5F};
  } else if (type == "lanczos") {
    radius = static_cast<float>(arguments.integer("lobes").value_or(3));
    filter.node = desc::SincFilter{radius};
  } else {
    if (!is_known(arguments.element())) {
      arguments.context().warnings.add(
          kFilter, arguments.where(),
          unknown_type_message(arguments.element()) + ". A gaussian one stands in",
          printable(type));
      arguments.accept_all();
    }
    const float deviation = arguments.number("stddev", kDeviation);
    filter = gaussian(deviation > 0.F ? deviation : kDeviation);
    radius = filter.radius.x;
  }
  constexpr float kLargest = 64.F;
  if (!(radius > 0.F && radius <= kLargest)) {
    throw SceneError(arguments.where(),
                     "the radius of the filter must be above 0 and at most 64 pixels");
  }
  filter.radius = Vec2(radius);
  filter.where = arguments.where();
  return filter;
}

/// Tone mapping of a film for displays.
void read_tone(Arguments& arguments, desc::Film& film) {
  const std::string method = arguments.word("tonemap_method", "gamma");
  const float stops = arguments.number("exposure", 0.F);
  arguments.accept({"key", "burn"});
  if (method != "gamma") {
    arguments.context().warnings.add(
        kToneMap, arguments.where(),
        "the tone map \"" + printable(method) + "\" is not supported: the picture is linear",
        printable(method));
    return;
  }
  film.scale = std::exp2(stops);
  if (!(film.scale > 0.F) || !std::isfinite(film.scale)) {
    throw SceneError(arguments.where(), "the \"exposure\" is beyond what a float holds");
  }
}

}  // namespace

desc::Film default_film(const SourceLocation& where) {
  desc::Film film;
  film.where = where;
  film.resolution = Vec2i(768, 576);
  film.filter = gaussian(0.5F);
  film.filter.where = where;
  return film;
}

void read_film(Context& context, const Element& element) {
  Arguments arguments(context, element);
  desc::Film film = default_film(element.where);
  // The film for matrices begins with a single number, of the luminance.
  const bool is_matrix = element.type == "mfilm";
  if (is_matrix) {
    film.resolution = Vec2i(1);
    film.filter.node = desc::BoxFilter{};
    film.filter.radius = Vec2(0.5F);
  }
  film.resolution = Vec2i(read_size(arguments, "width", film.resolution.x),
                          read_size(arguments, "height", film.resolution.y));
  read_crop(arguments, "crop_offset_x", "crop_width", film.resolution.x, &film.crop[0]);
  read_crop(arguments, "crop_offset_y", "crop_height", film.resolution.y, &film.crop[2]);
  film.filename = arguments.text("filename", "");
  if (const Element* rfilter = arguments.only_child("rfilter")) {
    Arguments of_filter(context, *rfilter);
    film.filter = make_filter(of_filter);
  }
  if (arguments.word("pixel_format", is_matrix ? "luminance" : "rgb").starts_with("luminance")) {
    context.warnings.add(kLuminance, element.where,
                         "pictures of luminance are not supported: this one has colours");
  }
  if (element.type == "ldrfilm") read_tone(arguments, film);
  if (element.type == "specfilm") {
    context.warnings.add(kSpectralFilm, element.where,
                         "pictures of wavelengths are not supported: this one has colours");
    arguments.children("texture");  // the responses of its channels
  }
  if (!is_known(element)) {
    context.warnings.add(kUnknownFilm, element.where,
                         unknown_type_message(element) + ". That of hdrfilm stands in",
                         printable(element.type));
    arguments.accept_all();
  }
  // The format of the written file is the user's choice.
  arguments.accept({"file_format", "component_format", "gamma", "banner", "high_quality_edges",
                    "attach_log", "sample_border", "compensate", "variable", "digits"});
  context.scene.film = film;
}

}  // namespace ajar::mitsuba
