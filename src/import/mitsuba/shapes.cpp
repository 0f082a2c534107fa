#include "import/mitsuba/shapes.h"

#include <cmath>

#include "core/printable_text.h"
#include "import/common/opacity.h"
#include "import/common/transforms.h"
#include "import/mitsuba/geometry.h"
#include "import/mitsuba/node_maker.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kFlat{Effect::Geometry,
                            "shapes are left out: their transforms cannot be inverted"};
constexpr WarningKind kTwice{Effect::Surface, "shapes have two bsdfs or emitters: the last counts"};
constexpr WarningKind kGroupedLight{
    Effect::Light, "shapes of groups cannot be lights: their emission is left out"};
constexpr WarningKind kEmitter{Effect::Light,
                               "emitters of shapes are not supported: left out, or area lights"};
constexpr WarningKind kUnlitCurves{Effect::Light, "curves cannot shine: their emission is ignored"};
constexpr WarningKind kSubsurface{Effect::Surface,
                                  "shapes have subsurface scattering, which is not supported"};
constexpr WarningKind kBack{
    Effect::Slight,
    "materials are black from behind in Mitsuba, unless they are twosided: alike from both sides"};

constexpr WarningKind kStretchedSphere{
    Effect::Slight,
    "spheres are stretched: Mitsuba shows round ones, of the radius along their x axis"};
constexpr WarningKind kSensor{Effect::None, "sensors on shapes are not supported and left out"};

/// A few kilobytes of merges of merges multiply to any number of shapes.
constexpr std::size_t kMostParts = 1'000'000;

bool is_of_shapes(const Element& element) {
  return element.type == "merge" || element.type == "shapegroup";
}

}  // namespace

void ShapeBuilder::add(const Element& element) {
  if (element.type == "shapegroup") return;  // only its instances are seen
  if (element.type == "instance") return add_instance(element);
  if (element.type == "merge") return add_parts(element, context_.scene.shapes, false);
  if (std::optional<desc::Shape> shape = make(element, false)) {
    context_.scene.shapes.push_back(std::move(*shape));
  }
}

void ShapeBuilder::add_parts(const Element& whole, std::vector<desc::Shape>& shapes,
                             bool is_in_group) {
  Arguments arguments(context_, whole);
  for (const Element* part : arguments.children("shape")) {
    if (++part_count_ > kMostParts) {
      throw SceneError(part->where, "shapes of shapes are more than " + std::to_string(kMostParts));
    }
    if (part->type == "instance") {
      if (is_in_group) throw SceneError(part->where, "a shapegroup cannot have instances in it");
      add_instance(*part);
    } else if (!is_of_shapes(*part)) {
      const auto [place, is_new] = parts_.try_emplace({part, is_in_group});
      if (is_new) place->second = make(*part, is_in_group);
      if (place->second) shapes.push_back(*place->second);
    } else if (part->type == "merge" || is_in_group) {
      add_parts(*part, shapes, is_in_group);
    }
  }
}

std::optional<desc::Shape> ShapeBuilder::make(const Element& element, bool is_in_group) {
  Arguments arguments(context_, element);
  std::optional<Geometry> geometry = make_geometry(arguments, meshes_);
  desc::Shape shape;
  shape.where = element.where;
  shape.reverse_orientation = arguments.flag("flip_normals", false);
  const Mat4 to_world = arguments.transform("to_world").value_or(Mat4());
  if (element.type == "sphere" && context_.document.major_version >= 2) {
    // Mirrors turn the normals of spheres, and of them alone. Source: Mitsuba 3, sphere.cpp.
    if (swaps_handedness(to_world)) shape.reverse_orientation = !shape.reverse_orientation;
    warn_of_stretched(element, to_world);
  }
  set_material(arguments, shape, geometry && geometry->is_closed);
  set_emission(arguments, shape, is_in_group);
  arguments.accept({"silhouette_sampling_weight"});
  if (!geometry) return std::nullopt;
  shape.name = element.id.empty() ? geometry->name : element.id;
  shape.node = std::move(geometry->node);
  if (shape.emission && shape.node.is("curves")) {
    context_.warnings.add(kUnlitCurves, shape.emission->where,
                          "curves cannot shine: their emission is ignored");
    shape.emission.reset();
  }
  shape.to_world = geometry->to_shape * to_world;
  if (!inverse(shape.to_world)) {
    context_.warnings.add(kFlat, element.where,
                          "the transform of this shape cannot be inverted: shape left out",
                          printable(shape.name));
    return std::nullopt;
  }
  return shape;
}

void ShapeBuilder::set_material(Arguments& arguments, desc::Shape& shape, bool is_closed) {
  shape.inside = media_.find(arguments, "interior");
  shape.outside = media_.find(arguments, "exterior");
  shape.has_medium_interface = shape.inside != shape.outside;
  const std::vector<const Element*> bsdfs = arguments.children("bsdf");
  const bool emits = !arguments.children("emitter").empty();
  const bool has_media = shape.inside != desc::kNone || shape.outside != desc::kNone;
  Surface surface;
  for (std::size_t i = 0; i + 1 < bsdfs.size(); ++i) {
    context_.warnings.add(kTwice, bsdfs[i]->where,
                          "this shape has another bsdf, which counts instead of this one");
  }
  if (!bsdfs.empty()) {
    surface = materials_.make(*bsdfs.back());
    if (surface.is_one_sided && !is_closed) warn_of_back(*bsdfs.back(), surface.material);
  } else if (emits) {
    surface = materials_.diffuse(0.F);
  } else if (has_media && context_.document.major_version == 0) {
    surface = materials_.interface();
  } else {
    surface = materials_.diffuse(0.5F);
  }
  shape.material = surface.material;
  shape.alpha = surface.alpha;
  shape.alpha_counted = surface.alpha != desc::kNone && context_.counts_boundaries &&
                        must_count_cut_outs(*context_.scene.hints.max_depth);
  if (!arguments.children("subsurface").empty()) {
    context_.warnings.add(kSubsurface, shape.where,
                          "subsurface scattering is not supported: this shape is opaque");
  }
  for (const Element* sensor : arguments.children("sensor")) {
    context_.warnings.add(kSensor, sensor->where, "sensors on shapes are not supported: left out");
  }
}

void ShapeBuilder::warn_of_stretched(const Element& sphere, const Mat4& to_world) {
  const auto length = [&](int axis) {
    return Vec3d(to_world[axis][0], to_world[axis][1], to_world[axis][2]).length();
  };
  constexpr double kTolerance = 1e-4;
  const auto is_like_x = [&](int axis) {
    return std::abs(length(axis) - length(0)) <= kTolerance * length(0);
  };
  if (is_like_x(1) && is_like_x(2)) return;
  context_.warnings.add(kStretchedSphere, sphere.where,
                        "this sphere is stretched, which Mitsuba does not support: it shows a "
                        "round one",
                        printable(sphere.id));
}

void ShapeBuilder::warn_of_back(const Element& bsdf, desc::MaterialId material) {
  if (!warned_of_back_.insert(&bsdf).second) return;
  context_.scene.warnings_if_seen.push_back(
      {desc::WarningIfSeen::If::FromBehind,
       material,
       0.F,
       {kBack, bsdf.where,
        "this material is black from behind in Mitsuba, as it is not twosided: here it is the same "
        "from both sides",
        printable(bsdf.id)}});
}

void ShapeBuilder::set_emission(Arguments& arguments, desc::Shape& shape, bool is_in_group) {
  for (const Element* element : arguments.children("emitter")) {
    if (is_in_group) {
      context_.warnings.add(kGroupedLight, element->where,
                            "shapes of groups cannot be lights: its emission is left out");
      continue;
    }
    if (shape.emission) {
      context_.warnings.add(kTwice, shape.emission->where,
                            "this shape has another emitter, which counts instead of this one");
    }
    Arguments emitter(context_, *element);
    const bool has_radiance = emitter.has("radiance");
    if (element->type != "area") {
      context_.warnings.add(kEmitter, element->where,
                            "emitter \"" + printable(element->type) +
                                "\" of a shape is not supported: " +
                                (has_radiance ? "an area light stands in" : "left out"),
                            printable(element->type));
      emitter.accept_all();
      if (!has_radiance) continue;
    }
    const desc::Value radiance = textures_.color(emitter, "radiance", desc::Rgb(1.F));
    shape.emission = desc::Emission{
        element->where, make_node(context_, element->where, desc::ModelKind::Emission, "area",
                                  {{"radiance", radiance}})};
    emitter.accept({"sampling_weight"});
  }
}

desc::ObjectId ShapeBuilder::object_of(const Element& group) {
  const auto [place, is_new] =
      objects_.try_emplace(&group, static_cast<desc::ObjectId>(context_.scene.objects.size()));
  if (!is_new) return place->second;
  desc::Object object{group.id, group.where, {}};
  context_.scene.objects.push_back(object);
  add_parts(group, object.shapes, true);
  context_.scene.objects[static_cast<std::size_t>(place->second)] = std::move(object);
  return place->second;
}

void ShapeBuilder::add_instance(const Element& element) {
  Arguments arguments(context_, element);
  const std::vector<const Element*> groups = arguments.children("shape");
  if (groups.size() != 1 || groups.front()->type != "shapegroup") {
    throw SceneError(arguments.where(), "an instance needs a reference to one shapegroup");
  }
  const Mat4 to_world = arguments.transform("to_world").value_or(Mat4());
  if (!inverse(to_world)) {
    context_.warnings.add(kFlat, arguments.where(),
                          "the transform of this instance cannot be inverted: left out",
                          printable(groups.front()->id));
    return;
  }
  context_.scene.instances.push_back({object_of(*groups.front()), to_world, arguments.where()});
}

}  // namespace ajar::mitsuba
