#include "import/pbrt/options.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/printable_text.h"
#include "import/common/left_out_media.h"
#include "import/common/transforms.h"
#include "import/pbrt/lexer.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kUnknownCamera{Effect::Light,
                                     "cameras are unknown: perspective ones stand in"};
constexpr WarningKind kEqualAreaCamera{
    Effect::Light,
    "cameras with equal-area maps are not supported: longitude by latitude stands in"};
constexpr WarningKind kRealisticCamera{
    Effect::Light, "realistic cameras are not supported: perspective ones stand in"};
constexpr WarningKind kUnknownSampler{Effect::None, "samplers are unknown: others stand in"};
constexpr WarningKind kSampleCount{Effect::Slight, "numbers of samples are below 1 and ignored"};
constexpr WarningKind kUnknownIntegrator{Effect::Slight,
                                         "integrators are unknown: others stand in"};
constexpr WarningKind kDirectOnly{
    Effect::Light, "integrators leave out light that diffuse surfaces pass on: it is shown"};
constexpr WarningKind kRegularize{Effect::Slight,
                                  "integrators make materials rougher, which is not supported"};
constexpr WarningKind kPixelBounds{Effect::Slight,
                                   "integrators have \"pixelbounds\", which is not supported"};

/// Where a file does not say "maxdepth", or has no Integrator.
constexpr int kDefaultBounces = 5;

/// Integrators replaced by ours. "ao" and "function" of pbrt-v4 are none of them.
const std::vector<std::string>& path_tracers(Dialect dialect) {
  static const std::vector<std::string> kOfV3 = {"path", "volpath", "directlighting", "whitted"};
  static const std::vector<std::string> kOfV4 = {"path",          "volpath",    "simplepath",
                                                 "simplevolpath", "randomwalk", "lightpath"};
  return dialect == Dialect::V3 ? kOfV3 : kOfV4;
}

/// pbrt counts bounces, we count edges.
int edges_of(int bounces) { return bounces + 1; }

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
  const bool is_v4 = context.is_v4();
  if (type == "perspective") {
    camera.node = perspective(where, p);
  } else if (type == "orthographic") {
    camera.node = lens_camera<desc::OrthographicCamera>(where, p);
  } else if (type == (is_v4 ? "spherical" : "environment")) {
    camera.node = desc::EnvironmentCamera{};
    if (is_v4 && p.get_string("mapping", "equalarea") != "equirectangular") {
      context.warnings.add(kEqualAreaCamera, where,
                           "cameras with equal-area maps are not supported: longitude by latitude "
                           "stands in, as \"equirectangular\" has it");
    }
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
    p.accept({"simpleweighting", "aperture", "scale"});
  } else {
    report_unknown(
        context, where, "camera", type,
        {"perspective", "orthographic", is_v4 ? "spherical" : "environment", "realistic"},
        kUnknownCamera, "A perspective one stands in");
    camera.node = perspective(where, p);
  }
  if (is_v4) {
    result.exposure_time = p.get_float("shutterclose", 1.F) - p.get_float("shutteropen", 0.F);
    if (!(result.exposure_time > 0.F)) {
      throw SceneError(where, "the shutter closes before it opens: the picture would be black");
    }
  }
  if (!is_v4) camera.hides_lights = p.get_bool("hides_lights", false);
  p.accept({"shutteropen", "shutterclose"});
  p.report_unused(context.warnings);
  return result;
}

void apply_no_integrator(Context& context) {
  context.scene.hints.max_depth = edges_of(kDefaultBounces);
}

void apply_sampler(Context& context, const SourceLocation& where, const std::string& type,
                   const ParameterList& p) {
  desc::RenderHints& hints = context.scene.hints;
  hints.sampler = type == "random" || type == "independent" ? "independent" : "sobol";
  int samples = 16;
  if (type == "stratified") {
    const double product = static_cast<double>(p.get_int("xsamples", 4)) * p.get_int("ysamples", 4);
    samples = product >= 1.0 && product < 1e9 ? static_cast<int>(product) : 0;
  } else {
    samples = p.get_int("pixelsamples", 16);
    static const std::vector<std::string> kOfV3 = {"random",     "halton",         "sobol",
                                                   "02sequence", "lowdiscrepancy", "maxmindist"};
    static const std::vector<std::string> kOfV4 = {"halton",  "independent", "paddedsobol",
                                                   "pmj02bn", "sobol",       "zsobol"};
    const std::vector<std::string>& known = context.is_v4() ? kOfV4 : kOfV3;
    if (std::find(known.begin(), known.end(), type) == known.end()) {
      context.warnings.add(
          kUnknownSampler, where,
          unknown_message(context.choice, "sampler", type, known) + ". Another stands in");
    }
  }
  if (samples >= 1) {
    hints.samples_per_pixel = samples;
  } else {
    context.warnings.add(kSampleCount, where, "the number of samples must be 1 or more: ignored");
  }
  p.accept({"jitter", "dimensions", "samplepixelcenter", "seed", "randomization"});
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
  const std::vector<std::string>& paths = path_tracers(context.choice.dialect);
  if (std::find(paths.begin(), paths.end(), type) != paths.end()) {
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
    std::vector<std::string> valid = paths;
    valid.insert(valid.end(), {"bdpt", "mlt", "sppm"});
    context.warnings.add(
        kUnknownIntegrator, where,
        unknown_message(context.choice, "integrator", type, valid) + ". Another stands in");
  }
  if (type == "directlighting" || type == "whitted") {
    context.warnings.add(kDirectOnly, where,
                         "\"" + type +
                             "\" of pbrt-v3 leaves out light that diffuse surfaces pass "
                             "on: here it is shown");
  }
  const int depth = p.get_int("maxdepth", kDefaultBounces);
  if (depth < 0 || depth > 1000000)
    throw SceneError(where, "\"maxdepth\" of " + std::to_string(depth) + " makes no sense");
  hints.max_depth = edges_of(depth);
  if (p.find("pixelbounds", ParameterKind::Integer) != nullptr) {
    context.warnings.add(kPixelBounds, where,
                         "\"pixelbounds\" is not supported: use the crop window of the film");
  }
  if (p.get_bool("regularize", false)) {
    context.warnings.add(kRegularize, where,
                         "\"regularize\" is not supported: no material is made rougher");
  }
  p.accept({"rrthreshold", "lightsamplestrategy", "strategy", "visualizestrategies",
            "visualizeweights", "imagewritefrequency", "quickrender", "lightsampler",
            "samplelights", "samplebsdf", "seed", "cossample", "maxdistance"});
  p.report_unused(context.warnings);
}

void check_media(Context& context, const SourceLocation& where, const std::string& type) {
  // Integrators of pbrt that render media; "" is the one of pbrt-v3 or pbrt-v4 where a file names
  // none.
  static const std::vector<std::string> kOfV3 = {"volpath", "bdpt", "mlt"};
  static const std::vector<std::string> kOfV4 = {"", "volpath", "simplevolpath", "bdpt", "mlt"};
  const std::vector<std::string>& know = context.is_v4() ? kOfV4 : kOfV3;
  if (std::find(know.begin(), know.end(), type) != know.end()) return;
  warn_of_left_out_media(context.scene, where, type.empty() ? "path" : type, "pbrt",
                         context.warnings);
}

}  // namespace ajar::pbrt
