#include "import/pbrt/options.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "import/common/printable.h"
#include "import/common/transforms.h"
#include "import/pbrt/lexer.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kRealisticCamera{
    Effect::Light, "realistic cameras are not supported: perspective ones stand in"};
constexpr WarningKind kFilmScale{Effect::Light, "films have a scale that leaves no picture"};
constexpr WarningKind kClamping{Effect::Slight,
                                "films have \"maxsampleluminance\", which is not supported"};
constexpr WarningKind kUnknownSampler{Effect::None, "samplers are unknown: others stand in"};
constexpr WarningKind kSampleCount{Effect::Slight, "numbers of samples are below 1 and ignored"};
constexpr WarningKind kUnknownIntegrator{Effect::Slight,
                                         "integrators are unknown: others stand in"};
constexpr WarningKind kPixelBounds{Effect::Slight,
                                   "integrators have \"pixelbounds\", which is not supported"};

constexpr int kLargestResolution = 65536;

std::optional<desc::ScreenWindow> screen_window(const ParameterList& p) {
  const Parameter* window = p.find("screenwindow", ParameterKind::Float);
  if (window == nullptr) return std::nullopt;
  const std::vector<float>& n = window->numbers;
  if (n.size() != 4 || n[0] == n[1] || n[2] == n[3]) {
    throw SceneError(window->where,
                     "\"screenwindow\" must have four numbers: x from, to, y from, to");
  }
  return desc::ScreenWindow{n[0], n[1], n[2], n[3]};
}

template <typename Camera>
Camera lens_camera(const SourceLocation& where, const ParameterList& p) {
  Camera node;
  node.lens_radius = p.get_float("lensradius", 0.F);
  node.focal_distance = p.get_float("focaldistance", 1e6F);
  node.window = screen_window(p);
  node.aspect = p.get_float("frameaspectratio");
  if (node.aspect && !(*node.aspect > 0.F))
    throw SceneError(where, "\"frameaspectratio\" must be positive");
  if (node.lens_radius < 0.F) throw SceneError(where, "\"lensradius\" is negative");
  if (!(node.focal_distance > 0.F)) throw SceneError(where, "\"focaldistance\" must be positive");
  return node;
}

desc::PerspectiveCamera perspective(const SourceLocation& where, const ParameterList& p) {
  auto node = lens_camera<desc::PerspectiveCamera>(where, p);
  node.fov = p.get_float("fov", 90.F);
  const float half = p.get_float("halffov", -1.F);
  if (half > 0.F) node.fov = 2.F * half;
  if (!(node.fov > 0.F && node.fov < 180.F))
    throw SceneError(where, "\"fov\" must be between 0 and 180 degrees");
  return node;
}

/// The number before "mm" in the name of a lens file, as in "dgauss.50mm.dat"; 50 if there is none.
double focal_length_of(const std::string& lens_file) {
  const std::size_t end = lens_file.find("mm");
  std::size_t begin = end == std::string::npos ? 0 : end;
  while (begin > 0 && lens_file[begin - 1] >= '0' && lens_file[begin - 1] <= '9') --begin;
  double length = 0.0;
  if (end != std::string::npos)
    std::from_chars(lens_file.data() + begin, lens_file.data() + end, length);
  return length > 0.0 ? length : 50.0;
}

}  // namespace

CameraOptions make_camera(Context& context, const SourceLocation& where, const std::string& type,
                          const ParameterList& p, const Mat4& ctm) {
  CameraOptions result;
  desc::Camera& camera = result.camera;
  camera.where = where;
  const std::optional<Mat4> to_world = rounded_inverse(ctm);
  if (!to_world) throw SceneError(where, "the transform of the camera cannot be inverted");
  camera.to_world = *to_world;
  if (type == "perspective") {
    camera.node = perspective(where, p);
  } else if (type == "orthographic") {
    camera.node = lens_camera<desc::OrthographicCamera>(where, p);
  } else if (type == "environment") {
    camera.node = desc::EnvironmentCamera{};
    p.accept({"lensradius", "focaldistance", "screenwindow", "frameaspectratio"});
  } else if (type == "realistic") {
    context.warnings.add(kRealisticCamera, where,
                         "the realistic camera is not supported: a perspective one of about the "
                         "same view stands in");
    constexpr float kMetersPerMillimeter = 0.001F;
    desc::PerspectiveCamera node;
    result.focal_length = focal_length_of(p.get_string("lensfile", ""));
    node.lens_radius =
        0.5F * kMetersPerMillimeter * std::max(p.get_float("aperturediameter", 1.F), 0.F);
    node.focal_distance = p.get_float("focusdistance", 10.F);
    if (!(node.focal_distance > 0.F)) throw SceneError(where, "\"focusdistance\" must be positive");
    camera.node = node;
    p.accept({"simpleweighting"});
  } else {
    fail_unknown(where, "camera", type,
                 {"perspective", "orthographic", "environment", "realistic"});
  }
  p.accept({"shutteropen", "shutterclose"});
  p.report_unused(context.warnings);
  return result;
}

FilmOptions make_film(Context& context, const SourceLocation& where, const std::string& type,
                      const ParameterList& p) {
  if (type != "image") fail_unknown(where, "film", type, {"image"});
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
  if (const Parameter* crop = p.find("cropwindow", ParameterKind::Float)) {
    const std::vector<float>& n = crop->numbers;
    if (n.size() != 4)
      throw SceneError(crop->where,
                       "\"cropwindow\" must have four numbers: x from, to, y from, to");
    for (std::size_t i = 0; i < 4; i += 2) {
      film.crop[i] = std::clamp(std::min(n[i], n[i + 1]), 0.F, 1.F);
      film.crop[i + 1] = std::clamp(std::max(n[i], n[i + 1]), 0.F, 1.F);
      if (!(film.crop[i] < film.crop[i + 1]))
        throw SceneError(crop->where, "the crop window is empty");
    }
  }
  film.scale = p.get_float("scale", 1.F);
  if (!(film.scale > 0.F)) {
    context.warnings.add(kFilmScale, where,
                         film.scale < 0.F ? "\"scale\" of the film is negative: so is the picture"
                                          : "\"scale\" of the film is 0: the picture is black");
  }
  result.diagonal = p.get_float("diagonal", 35.F);
  film.filename = p.get_string("filename", "pbrt.exr");
  if (p.get_float("maxsampleluminance")) {
    context.warnings.add(kClamping, where,
                         "\"maxsampleluminance\" is not supported: samples are not clamped");
  }
  p.report_unused(context.warnings);
  return result;
}

desc::Filter make_filter(Context& context, const SourceLocation& where, const std::string& type,
                         const ParameterList& p) {
  desc::Filter filter;
  filter.where = where;
  float radius = 2.F;  // pbrt-v3's default for most
  if (type == "box") {
    radius = 0.5F;
    filter.node = desc::BoxFilter{};
  } else if (type == "triangle") {
    filter.node = desc::TriangleFilter{};
  } else if (type == "gaussian") {
    filter.node = desc::GaussianFilter{p.get_float("alpha", 2.F)};
  } else if (type == "mitchell") {
    filter.node = desc::MitchellFilter{p.get_float("B", 1.F / 3.F), p.get_float("C", 1.F / 3.F)};
  } else if (type == "sinc") {
    radius = 4.F;
    filter.node = desc::SincFilter{p.get_float("tau", 3.F)};
  } else {
    fail_unknown(where, "filter", type, {"box", "triangle", "gaussian", "mitchell", "sinc"});
  }
  filter.radius = Vec2(p.get_float("xwidth", radius), p.get_float("ywidth", radius));
  constexpr float kLargest = 64.F;
  for (const float r : {filter.radius.x, filter.radius.y}) {
    if (!(r > 0.F && r <= kLargest))
      throw SceneError(where, "the filter width must be above 0 and at most 64 pixels");
  }
  p.report_unused(context.warnings);
  return filter;
}

void apply_sampler(Context& context, const SourceLocation& where, const std::string& type,
                   const ParameterList& p) {
  desc::RenderHints& hints = context.scene.hints;
  hints.sampler = type == "random" ? "independent" : "sobol";
  int samples = 16;
  if (type == "stratified") {
    const double product = static_cast<double>(p.get_int("xsamples", 4)) * p.get_int("ysamples", 4);
    samples = product >= 1.0 && product < 1e9 ? static_cast<int>(product) : 0;
  } else {
    samples = p.get_int("pixelsamples", 16);
    static const std::vector<std::string> kKnown = {"random",     "halton",         "sobol",
                                                    "02sequence", "lowdiscrepancy", "maxmindist"};
    if (std::find(kKnown.begin(), kKnown.end(), type) == kKnown.end()) {
      context.warnings.add(
          kUnknownSampler, where,
          unknown_name_message("sampler", printable(type), kKnown) + ". Another stands in");
    }
  }
  if (samples >= 1) {
    hints.samples_per_pixel = samples;
  } else {
    context.warnings.add(kSampleCount, where, "the number of samples must be 1 or more: ignored");
  }
  p.accept({"jitter", "dimensions", "samplepixelcenter"});
  p.report_unused(context.warnings);
}

void apply_integrator(Context& context, const SourceLocation& where, const std::string& type,
                      const ParameterList& p) {
  desc::RenderHints& hints = context.scene.hints;
  const auto pass = [&](const std::string& name, const Parameter* given) {
    if (given == nullptr) return;
    std::string text;
    if (given->kind == ParameterKind::Integer) {
      text = std::to_string(given->integers.front());
    } else {
      char buffer[64];
      text.assign(buffer,
                  std::to_chars(buffer, buffer + sizeof(buffer), given->numbers.front()).ptr);
    }
    hints.parameters.emplace_back(name, text);
  };
  const auto samples = [&](const Parameter* given) {
    if (given != nullptr && given->integers.front() >= 1)
      hints.samples_per_pixel = given->integers.front();
  };
  hints.parameters.clear();
  if (type == "path" || type == "volpath" || type == "directlighting" || type == "whitted") {
    hints.integrator = "pt";
  } else if (type == "bdpt") {
    hints.integrator = "bdpt";
  } else if (type == "mlt") {
    hints.integrator = "mmlt";
    for (const char* name : {"bootstrapsamples", "chains", "mutationsperpixel"}) {
      pass(name, p.find_one(name, ParameterKind::Integer));
    }
    for (const char* name : {"largestepprobability", "sigma"})
      pass(name, p.find_one(name, ParameterKind::Float));
    samples(p.find_one("mutationsperpixel", ParameterKind::Integer));
  } else if (type == "sppm") {
    hints.integrator = "sppm";
    pass("radius", p.find_one("radius", ParameterKind::Float));
    pass("photonsperiteration", p.find_one("photonsperiteration", ParameterKind::Integer));
    for (const char* name : {"numiterations", "iterations"})
      samples(p.find_one(name, ParameterKind::Integer));
  } else {
    context.warnings.add(
        kUnknownIntegrator, where,
        unknown_name_message("integrator", printable(type),
                             std::vector<std::string>{"path", "volpath", "bdpt", "mlt", "sppm",
                                                      "directlighting", "whitted"}) +
            ". Another stands in");
  }
  // pbrt counts bounces, we count edges.
  const int depth = p.get_int("maxdepth", 5);
  if (depth < 0 || depth > 1000000)
    throw SceneError(where, "\"maxdepth\" of " + std::to_string(depth) + " makes no sense");
  hints.max_depth = depth + 1;
  if (p.find("pixelbounds", ParameterKind::Integer) != nullptr) {
    context.warnings.add(kPixelBounds, where,
                         "\"pixelbounds\" is not supported: use the crop window of the film");
  }
  p.accept({"rrthreshold", "lightsamplestrategy", "strategy", "visualizestrategies",
            "visualizeweights", "imagewritefrequency", "quickrender"});
  p.report_unused(context.warnings);
}

}  // namespace ajar::pbrt
