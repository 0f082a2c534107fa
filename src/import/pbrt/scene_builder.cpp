#include "import/pbrt/scene_builder.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/printable_text.h"
#include "import/common/opacity.h"
#include "import/pbrt/bilinear_mesh.h"
#include "import/pbrt/emitted_power.h"
#include "import/pbrt/lexer.h"
#include "import/pbrt/media.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kLateView{
    Effect::Light, "directives for camera and film come after WorldBegin and have no effect"};
constexpr WarningKind kLateOption{Effect::Slight,
                                  "options come after WorldBegin and have no effect"};
constexpr WarningKind kOption{Effect::Slight, "options are not supported and ignored"};
constexpr WarningKind kUnknownTarget{Effect::Slight,
                                     "attributes are for unknown targets and ignored"};
constexpr WarningKind kUnknownColorSpace{Effect::Surface,
                                         "colour spaces are unknown: those before stay"};
constexpr WarningKind kHiddenLamp{Effect::Light, "lamps that should not be seen are seen"};
constexpr WarningKind kTranslucentLamp{
    Effect::Light, "lamps are partly transparent by a texture: they shine as if they were not"};
constexpr WarningKind kOpenBlock{Effect::Slight, "blocks have no end"};
constexpr WarningKind kInstanceLeftOut{
    Effect::Geometry, "instances are left out: their transforms cannot be inverted"};
constexpr WarningKind kShapeLeftOut{Effect::Geometry,
                                    "shapes are left out: their transforms cannot be inverted"};
constexpr WarningKind kObjectNotMade{Effect::Geometry,
                                     "instances of objects that were not made are left out"};
constexpr WarningKind kMediumNotMade{Effect::Surface,
                                     "media are named that were not made: there are none"};
constexpr WarningKind kInstancedLight{
    Effect::Light, "shapes of objects cannot be lights: their emission is left out"};
constexpr WarningKind kNoEnd{Effect::Geometry, "files have no WorldEnd"};
constexpr WarningKind kNoCamera{Effect::Light, "scenes have no Camera"};
constexpr WarningKind kNoShapes{Effect::Geometry, "scenes have no shapes"};

constexpr std::size_t kDeepestNesting = 100000;
/// Limit of one target; every directive looks at all of them.
constexpr std::size_t kMostAttributes = 64;

const char* name_of_scope(int kind) {
  static constexpr const char* kNames[] = {"Attribute", "Transform", "Object", "Import"};
  return kNames[kind];
}

}  // namespace

SceneBuilder::SceneBuilder(FileAccess& files, std::string source, const DialectChoice& choice,
                           Warnings& warnings)
    : choice_(choice),
      warnings_(warnings),
      spectra_(files, choice.dialect, warnings),
      context_{scene_, warnings, files, spectra_, clouds_, choice_},
      textures_(context_),
      materials_(context_, textures_),
      meshes_(files, warnings) {
  scene_.source = std::move(source);
  scene_.film.filter = default_filter(choice.dialect);
  if (context_.is_v4()) state_.color_space = &ColorSpace::srgb();
}

// ---------------------------------------------------------------- options

bool SceneBuilder::in_options(const SourceLocation& where, const std::string& directive) {
  if (stage_ == Stage::Options) return true;
  const bool is_view = directive == "Camera" || directive == "Film";
  warnings_.add(is_view ? kLateView : kLateOption, where,
                directive + " has no effect after WorldBegin: ignored", directive);
  return false;
}

void SceneBuilder::camera(const SourceLocation& where, const std::string& type,
                          const ParameterList& parameters) {
  if (!in_options(where, "Camera")) return;
  camera_ = make_camera(context_, where, type, parameters, transforms_.get(where, warnings_));
  transforms_.define_camera(camera_->camera.to_world);
  camera_medium_ = state_.outside;
}

void SceneBuilder::film(const SourceLocation& where, const std::string& type,
                        const ParameterList& parameters) {
  if (!in_options(where, "Film")) return;
  FilmOptions options = make_film(context_, where, type, parameters);
  options.film.filter = scene_.film.filter;
  scene_.film = std::move(options.film);
  film_diagonal_ = options.diagonal;
}

void SceneBuilder::pixel_filter(const SourceLocation& where, const std::string& type,
                                const ParameterList& parameters) {
  if (!in_options(where, "PixelFilter")) return;
  scene_.film.filter = make_filter(context_, where, type, parameters);
}

void SceneBuilder::sampler(const SourceLocation& where, const std::string& type,
                           const ParameterList& parameters) {
  if (!in_options(where, "Sampler")) return;
  // The integrator's number of samples is more specific, in any order.
  const std::optional<int> of_integrator =
      scene_.hints.integrator == "mmlt" || scene_.hints.integrator == "sppm"
          ? scene_.hints.samples_per_pixel
          : std::nullopt;
  apply_sampler(context_, where, type, parameters);
  if (of_integrator) scene_.hints.samples_per_pixel = of_integrator;
}

void SceneBuilder::integrator(const SourceLocation& where, const std::string& type,
                              const ParameterList& parameters) {
  if (!in_options(where, "Integrator")) return;
  apply_integrator(context_, where, type, parameters);
  integrator_ = {type, where};
}

// ---------------------------------------------------------------- pbrt-v4

const std::vector<std::string>& SceneBuilder::attribute_targets() {
  static const std::vector<std::string> kTargets = {"shape", "light", "material", "medium",
                                                    "texture"};
  return kTargets;
}

void SceneBuilder::attribute(const SourceLocation& where, const std::string& target,
                             const ParameterList& parameters) {
  const std::vector<std::string>& targets = attribute_targets();
  if (std::find(targets.begin(), targets.end(), target) == targets.end()) {
    report_unknown(context_, where, "target of Attribute", target, targets, kUnknownTarget,
                   "It is ignored");
    return;
  }
  std::vector<AttributePointer> all;
  for (const ParameterPointer& parameter : parameters.parameters()) {
    all.push_back(std::make_shared<AttributeParameter>(
        AttributeParameter{.parameter = parameter, .asked = {}}));
  }
  all_attributes_.insert(all_attributes_.end(), all.begin(), all.end());
  for (const AttributePointer& earlier : attributes(target)) {
    const bool is_replaced =
        std::any_of(all.begin(), all.end(), [&](const AttributePointer& later) {
          return later->parameter->name == earlier->parameter->name;
        });
    if (!is_replaced) all.push_back(earlier);
  }
  if (all.size() > kMostAttributes) throw SceneError(where, "too many attributes");
  state_.attributes[target] = std::make_shared<const std::vector<AttributePointer>>(std::move(all));
}

std::span<const AttributePointer> SceneBuilder::attributes(std::string_view target) const {
  const auto found = state_.attributes.find(std::string(target));
  if (found == state_.attributes.end()) return {};
  return *found->second;
}

void SceneBuilder::color_space(const SourceLocation& where, const std::string& name) {
  if (const ColorSpace* space = ColorSpace::find(name)) {
    state_.color_space = space;
    return;
  }
  report_unknown(context_, where, "colour space", name, ColorSpace::names(), kUnknownColorSpace,
                 "The one before stays");
}

void SceneBuilder::option(const SourceLocation& where, const SourceLocation& place,
                          const std::string& name, bool is_on) {
  static const std::vector<std::string> kWithoutEffect = {"disabletexturefiltering",
                                                          "disablewavelengthjitter",
                                                          "displacementedgescale",
                                                          "msereferenceimage",
                                                          "msereferenceout",
                                                          "rendercoordsys",
                                                          "pixelstats",
                                                          "seed",
                                                          "wavefront"};
  if (!in_options(where, "Option")) return;
  if (name == "forcediffuse" || name == "disablepixeljitter") {
    if (!is_on) return;
    warnings_.add(kOption, place, "the option \"" + name + "\" is not supported: ignored", name);
    return;
  }
  if (std::find(kWithoutEffect.begin(), kWithoutEffect.end(), name) == kWithoutEffect.end()) {
    report_unknown(context_, place, "option", name, kWithoutEffect, kOption, "It is ignored");
  }
}

void SceneBuilder::import_begin(const SourceLocation& where) {
  require_world(where, "Import");
  open(Scope::Import, where);
}

void SceneBuilder::import_end() {
  if (world_ended()) return;
  close_open_blocks(Scope::Import);
  restore_innermost();
}

void SceneBuilder::close_open_blocks(std::optional<Scope> until) {
  while (!scopes_.empty() && scopes_.back().kind != until) {
    const OpenScope& scope = scopes_.back();
    warnings_.add(
        kOpenBlock, scope.where,
        std::string(name_of_scope(static_cast<int>(scope.kind))) + "Begin without an end");
    restore_innermost();
  }
}

// ---------------------------------------------------------------- scopes

void SceneBuilder::require_world(const SourceLocation& where, const char* directive) const {
  if (stage_ != Stage::World)
    throw SceneError(where, std::string(directive) + " is only allowed after WorldBegin");
}

void SceneBuilder::world_begin(const SourceLocation& where) {
  if (stage_ != Stage::Options) throw SceneError(where, "WorldBegin inside of the world");
  stage_ = Stage::World;
  transforms_.begin_world();
}

void SceneBuilder::world_end(const SourceLocation& where) {
  require_world(where, "WorldEnd");
  close_open_blocks(std::nullopt);
  stage_ = Stage::Done;
}

void SceneBuilder::open(Scope kind, const SourceLocation& where) {
  if (scopes_.size() >= kDeepestNesting) throw SceneError(where, "blocks are nested too deeply");
  transforms_.push();
  // In pbrt-v4 such a block is one of attributes.
  if (kind == Scope::Transform && !context_.is_v4()) {
    scopes_.push_back({kind, where, std::nullopt});
    return;
  }
  scopes_.push_back({kind, where, state_});
  textures_.begin_scope();
  materials_.begin_scope();
}

void SceneBuilder::close(Scope kind, const SourceLocation& where) {
  const std::string name = name_of_scope(static_cast<int>(kind));
  if (scopes_.empty()) throw SceneError(where, name + "End without " + name + "Begin");
  const OpenScope& scope = scopes_.back();
  if (scope.kind != kind) {
    throw SceneError(where, name + "End, but the innermost open block is " +
                                name_of_scope(static_cast<int>(scope.kind)) + "Begin at " +
                                scope.where.to_string());
  }
  restore_innermost();
}

void SceneBuilder::restore_innermost() {
  OpenScope& scope = scopes_.back();
  transforms_.pop();
  if (scope.saved) {
    state_ = std::move(*scope.saved);
    textures_.end_scope();
    materials_.end_scope();
  }
  if (scope.kind == Scope::Object) open_object_ = desc::kNone;
  scopes_.pop_back();
}

void SceneBuilder::attribute_begin(const SourceLocation& where) {
  require_world(where, "AttributeBegin");
  open(Scope::Attribute, where);
}
void SceneBuilder::attribute_end(const SourceLocation& where) {
  require_world(where, "AttributeEnd");
  close(Scope::Attribute, where);
}
void SceneBuilder::transform_begin(const SourceLocation& where) { open(Scope::Transform, where); }
void SceneBuilder::transform_end(const SourceLocation& where) { close(Scope::Transform, where); }

void SceneBuilder::object_begin(const SourceLocation& where, const std::string& name) {
  require_world(where, "ObjectBegin");
  if (open_object_ != desc::kNone) throw SceneError(where, "ObjectBegin inside of another object");
  open(Scope::Object, where);
  open_object_ = static_cast<desc::ObjectId>(scene_.objects.size());
  if (!objects_.insert_or_assign(name, open_object_).second) {
    warn_of_same_name(context_, where, "object", name);
  }
  scene_.objects.push_back({name, where, {}});
}

void SceneBuilder::object_end(const SourceLocation& where) {
  require_world(where, "ObjectEnd");
  close(Scope::Object, where);
}

void SceneBuilder::object_instance(const SourceLocation& where, const std::string& name) {
  require_world(where, "ObjectInstance");
  if (open_object_ != desc::kNone) throw SceneError(where, "ObjectInstance inside of an object");
  const auto found = objects_.find(name);
  if (found == objects_.end()) {
    std::vector<std::string> valid;
    for (const auto& entry : objects_) valid.push_back(entry.first);
    return warn_of_unknown_name(context_, kObjectNotMade, where, "object", name, valid,
                                "The instance is left out");
  }
  const Mat4& to_world = transforms_.get(where, warnings_);
  if (!inverse(to_world)) {
    warnings_.add(kInstanceLeftOut, where,
                  "the transform of this instance cannot be inverted: left out", printable(name));
    return;
  }
  scene_.instances.push_back({found->second, to_world, where});
}

void SceneBuilder::reverse_orientation(const SourceLocation& where) {
  require_world(where, "ReverseOrientation");
  state_.reverse_orientation = !state_.reverse_orientation;
}

// ---------------------------------------------------------------- named things

void SceneBuilder::texture(const SourceLocation& where, const std::string& name,
                           const std::string& texture_class, const std::string& type,
                           const ParameterList& parameters) {
  require_world(where, "Texture");
  textures_.define(where, name, texture_class, type, parameters, transforms_.get(where, warnings_));
}

void SceneBuilder::material(const SourceLocation& where, const std::string& type,
                            std::shared_ptr<const ParameterList> parameters) {
  require_world(where, "Material");
  state_.material = materials_.make(where, type, std::move(parameters));
}

void SceneBuilder::make_named_material(const SourceLocation& where, const std::string& name,
                                       std::shared_ptr<const ParameterList> parameters) {
  require_world(where, "MakeNamedMaterial");
  materials_.make_named(where, name, std::move(parameters));
}

void SceneBuilder::named_material(const SourceLocation& where, const std::string& name) {
  require_world(where, "NamedMaterial");
  state_.material = materials_.named(where, name);
}

void SceneBuilder::make_named_medium(const SourceLocation& where, const std::string& name,
                                     const ParameterList& parameters) {
  scene_.media.push_back(
      make_medium(context_, where, name, parameters, transforms_.get(where, warnings_)));
  const auto id = static_cast<desc::MediumId>(scene_.media.size()) - 1;
  if (!media_.insert_or_assign(name, id).second) {
    warn_of_same_name(context_, where, "medium", name);
  }
}

void SceneBuilder::medium_interface(const SourceLocation& where, const std::string& inside,
                                    const std::string& outside) {
  state_.inside = inside;
  state_.outside = outside;
  state_.media_where = where;
}

desc::MediumId SceneBuilder::medium_id(const std::string& name) {
  if (name.empty()) return desc::kNone;
  const auto found = media_.find(name);
  if (found != media_.end()) return found->second;
  std::vector<std::string> valid;
  for (const auto& entry : media_) valid.push_back(entry.first);
  if (!unknown_media_.insert(name).second) return desc::kNone;
  warn_of_unknown_name(context_, kMediumNotMade, state_.media_where, "medium", name, valid,
                       "There is none in its place");
  return desc::kNone;
}

// ---------------------------------------------------------------- lights and shapes

void SceneBuilder::light_source(const SourceLocation& where, const std::string& type,
                                const ParameterList& parameters) {
  require_world(where, "LightSource");
  std::optional<desc::Light> light =
      make_light(context_, textures_, where, type, parameters, transforms_.get(where, warnings_));
  if (!light) return;
  light->medium = medium_id(state_.outside);
  scene_.lights.push_back(std::move(*light));
}

void SceneBuilder::area_light_source(const SourceLocation& where, const std::string& type,
                                     const ParameterList& parameters) {
  require_world(where, "AreaLightSource");
  state_.emission = nullptr;
  if (type.empty()) return;
  if (auto emission = make_emission(context_, textures_, where, type, parameters)) {
    state_.emission = std::make_shared<const AreaEmission>(std::move(*emission));
  }
}

desc::TextureId SceneBuilder::alpha(const ParameterList& parameters, std::string_view name) {
  if (const Parameter* reference = parameters.find_one(name, ParameterKind::Texture)) {
    return textures_.find(*reference, TextureClass::Float).value_or(desc::kNone);
  }
  // Only 0 cuts away.
  return parameters.get_float(name, 1.F) == 0.F ? textures_.zero() : desc::kNone;
}

void SceneBuilder::make_partly_clear(const ParameterList& parameters, desc::Shape& shape) {
  const float number = std::clamp(parameters.get_float("alpha", 1.F), 0.F, 1.F);
  const bool is_textured = parameters.find_one("alpha", ParameterKind::Texture) != nullptr;
  if (shape.emission && !is_textured && number == 0.F) return show_hidden_lamp(shape);
  if (is_textured ? shape.alpha == desc::kNone : number == 0.F || number == 1.F) return;
  if (shape.emission && is_textured) {
    warnings_.add(kTranslucentLamp, shape.where,
                  "where \"alpha\" of this lamp is between 0 and 1, it shines as if it were 1");
  } else if (shape.emission) {
    desc::Node& node = shape.emission->node;
    node.set("scale", node.color("scale") * number);
  }
  const auto material = static_cast<std::size_t>(shape.material);
  if (shape.material == desc::kNone || scene_.materials[material].node.is("interface")) return;
  const desc::Value opacity =
      is_textured ? desc::Value(desc::TextureRef{shape.alpha}) : desc::Value(number);
  const auto [made, is_new] =
      partly_clear_.try_emplace({shape.material, shape.alpha, is_textured ? 1.F : number});
  if (is_new) {
    const desc::Material like{.name = scene_.materials[material].name,
                              .where = scene_.materials[material].where};
    // Surfaces that "alpha" cuts away are no intersections.
    made->second = with_opacity(scene_, like, shape.material, opacity, Passing::Uncounted).material;
  }
  shape.material = made->second;
}

void SceneBuilder::show_hidden_lamp(desc::Shape& shape) {
  warnings_.add(kHiddenLamp, shape.where,
                "with \"alpha\" 0 this lamp shines but is not seen in pbrt-v4: here it is seen");
  shape.alpha = desc::kNone;
  // Interfaces between media cannot shine.
  desc::Material& clear = scene_.materials.emplace_back();
  clear.where = shape.where;
  clear.node = clear_material(Passing::Uncounted);
  shape.material = static_cast<desc::MaterialId>(scene_.materials.size()) - 1;
}

void SceneBuilder::emit(const SourceLocation& where, desc::Shape& shape) {
  if (open_object_ != desc::kNone) {
    warnings_.add(kInstancedLight, where,
                  "shapes of objects cannot be lights: its emission is left out");
    return;
  }
  shape.emission = state_.emission->emission;
}

void SceneBuilder::shape(const SourceLocation& where, const std::string& type,
                         const ParameterList& parameters) {
  require_world(where, "Shape");
  std::optional<desc::Node> node =
      make_shape(context_, meshes_, textures_, where, type, parameters);
  if (!node) return;
  desc::Shape shape;
  shape.where = where;
  shape.node = std::move(*node);
  if (type == "plymesh") {
    shape.name = std::filesystem::path(parameters.get_string("filename", "")).stem().string();
  }
  shape.to_world = transforms_.get(where, warnings_);
  shape.reverse_orientation = state_.reverse_orientation;
  shape.alpha = alpha(parameters, "alpha");
  shape.shadow_alpha = alpha(parameters, "shadowalpha");
  if (!context_.is_v4()) shape.alpha_counted = parameters.get_bool("alpha_counted", false);
  shape.material = materials_.for_shape(where, state_.material, parameters);
  shape.inside = medium_id(state_.inside);
  shape.outside = medium_id(state_.outside);
  shape.has_medium_interface = shape.inside != shape.outside;
  if (state_.emission) emit(where, shape);
  if (context_.is_v4()) make_partly_clear(parameters, shape);
  parameters.report_unused(warnings_);
  if (!inverse(shape.to_world)) {
    warnings_.add(kShapeLeftOut, where,
                  "the transform of this shape cannot be inverted: shape left out", shape.name);
    return;
  }
  std::vector<desc::Shape>& shapes =
      open_object_ == desc::kNone ? scene_.shapes
                                  : scene_.objects[static_cast<std::size_t>(open_object_)].shapes;
  if (shape.emission && state_.emission->power) {
    const std::size_t triangles =
        type == "bilinearmesh" ? read_bilinear_mesh(where, parameters).triangles_per_patch : 1;
    powered_.push_back({shapes.size(), *state_.emission->power, triangles});
  }
  shapes.push_back(std::move(shape));
}

// ---------------------------------------------------------------- end

void SceneBuilder::finish_realistic_camera() {
  // Half the angle of the shorter side of the film, as measured by "fov".
  const double aspect = static_cast<double>(scene_.film.resolution.x) / scene_.film.resolution.y;
  const double height = static_cast<double>(film_diagonal_) / std::sqrt(1.0 + aspect * aspect);
  const double half = 0.5 * std::min(height, height * aspect);
  const double degrees =
      2.0 * std::atan(half / *camera_->focal_length) * 180.0 / 3.14159265358979323846;
  std::get<desc::PerspectiveCamera>(scene_.camera.node).fov =
      static_cast<float>(std::clamp(degrees, 1.0, 170.0));
}

desc::SceneDesc SceneBuilder::finish(const SourceLocation& end) {
  if (stage_ == Stage::Options)
    throw SceneError(end, "this is not a complete pbrt scene: there is no WorldBegin");
  if (stage_ == Stage::World) {
    // Files of pbrt-v4 simply end.
    if (!context_.is_v4()) {
      const bool is_told = context_.choice.where.file != nullptr;
      warnings_.add(kNoEnd, end,
                    std::string("there is no WorldEnd: the file may have been cut off") +
                        (is_told ? "" : ", or be meant as pbrt-v4, of which it has no word"));
    }
    world_end(end);
  }
  report_unused(all_attributes_, warnings_);
  if (camera_) {
    scene_.camera = camera_->camera;
    scene_.film.scale *= camera_->exposure_time;
    if (camera_->focal_length) finish_realistic_camera();
  } else {
    warnings_.add(kNoCamera, end, "there is no Camera: a perspective one at the origin is used");
    scene_.camera.where = end;
  }
  if (!scene_.film.where.file) scene_.film.where = end;
  if (!integrator_) apply_no_integrator(context_);
  // pbrt-v3 makes the camera at WorldEnd: the medium around it is the outside at the top level
  // there.
  scene_.camera.medium = medium_id(context_.is_v4() ? camera_medium_ : state_.outside);
  const auto& [integrator, integrator_where] = integrator_.value_or(std::pair(std::string(), end));
  check_media(context_, integrator_where, integrator);
  meshes_.load_all();
  for (const Powered& light : powered_) {
    desc::Shape& shape = scene_.shapes[light.shape];
    if (is_empty_mesh(shape)) continue;
    scale_to_power(shape, light.power, light.triangles_per_primitive, warnings_);
  }
  remove_empty_meshes(scene_);
  if (scene_.shapes.empty() && scene_.instances.empty())
    warnings_.add(kNoShapes, end, "there are no shapes in this scene");
  return std::move(scene_);
}

}  // namespace ajar::pbrt
