#include "import/tungsten/primitives.h"

#include <algorithm>
#include <set>
#include <utility>

#include "import/common/opacity.h"
#include "import/tungsten/instances.h"
#include "import/tungsten/strands.h"
#include "import/tungsten/transforms.h"
#include "scene/desc/models.h"

namespace ajar::tungsten {
namespace {

constexpr WarningKind kUnknownPrimitive{Effect::Geometry,
                                        "primitives are of unknown types and left out"};
constexpr WarningKind kUnsupported{Effect::Geometry, "primitives are not supported and left out"};
constexpr WarningKind kMoreBsdfs{Effect::Surface,
                                 "primitives have more bsdfs than they can: the first counts"};
constexpr WarningKind kNoMeshFile{Effect::Geometry, "meshes name no file and are left out"};
constexpr WarningKind kNoCurves{Effect::Geometry, "curves cannot be read and are left out"};
constexpr WarningKind kCurveMode{Effect::Slight,
                                 "curves are bands that turn with no normals: they face the ray"};
constexpr WarningKind kSubsample{Effect::Slight,
                                 "a share of curves is to be left out: all of them are there"};
constexpr WarningKind kUnlitCurves{Effect::Light,
                                   "curves cannot shine: their emission is left out"};
constexpr WarningKind kHair{Effect::Surface,
                            "curves have no bsdf, which makes them hair: white ones stand in"};
constexpr WarningKind kFlat{Effect::Geometry,
                            "primitives are left out: their transforms cannot be inverted"};
constexpr WarningKind kConeAngle{Effect::Light,
                                 "disks shine in all directions: their cones are not supported"};
constexpr WarningKind kCulling{Effect::Geometry,
                               "meshes are seen from behind, too: culling is not supported"};
constexpr WarningKind kBumpStrength{Effect::Slight,
                                    "primitives have bumps of older files, which are ignored"};
constexpr WarningKind kLids{Effect::Surface,
                            "cylinders have textures on their lids: they run around, not across"};
constexpr WarningKind kInstancedLight{Effect::Light,
                                      "what is copied cannot be a light: its emission is left out"};
constexpr WarningKind kUnlitInstances{Effect::Light,
                                      "instances cannot shine: their own emission is left out"};
constexpr WarningKind kNoMaster{Effect::Geometry, "instances have nothing to copy: left out"};
constexpr WarningKind kMovingInstances{Effect::Slight,
                                       "instances move between two files: the first counts"};

using Kind = LocatedJson::Kind;

const std::vector<std::string> kPrimitiveTypes = {
    "mesh",         "cube",      "sphere",          "quad",
    "disk",         "curves",    "point",           "skydome",
    "cylinder",     "instances", "infinite_sphere", "infinite_sphere_cap",
    "minecraft_map"};

/// True for a colour or texture of which Tungsten makes light.
bool is_bright(const LocatedJson& json) {
  if (json.is(Kind::Number) || json.is(Kind::Array)) {
    const Vec3 color = vector_of(json);
    return std::max({color.x, color.y, color.z}) > 0.F;
  }
  if (type_of(json) != "constant") return true;
  const auto value = json.find("value");
  return value && is_bright(*value);
}

/// True if a material, or a part of it, has a texture. Visits each once: mixes may name the same
/// parts in many ways.
bool has_texture(const desc::SceneDesc& scene, desc::MaterialId whole) {
  std::set<desc::MaterialId> known = {whole};
  std::vector<desc::MaterialId> left = {whole};
  while (!left.empty()) {
    const desc::Material& material = scene.materials[static_cast<std::size_t>(left.back())];
    left.pop_back();
    if (material.bump != desc::kNone) return true;
    for (const desc::Value& value : material.node.values()) {
      if (std::holds_alternative<desc::TextureRef>(value)) return true;
      const auto* part = std::get_if<desc::MaterialRef>(&value);
      if (part == nullptr || part->id == desc::kNone) continue;
      if (known.insert(part->id).second) left.push_back(part->id);
    }
  }
  return false;
}

bool is_zero(const desc::Value& color) { return color == desc::Value(Vec3(0.F)); }

}  // namespace

// ---------------------------------------------------------------- geometry

std::vector<Part> PrimitiveReader::mesh_parts(const ObjectReader& object, const Mat4& transform,
                                              int bsdf_count) {
  MeshTreatment treatment;
  treatment.smooth = object.flag("smooth").value_or(false);
  treatment.recompute_normals =
      object.flag("recompute_normals").value_or(false) && treatment.smooth;
  if (object.flag("backface_culling").value_or(false)) {
    context_.warnings.add(
        kCulling, object.where(),
        "\"backface_culling\" is not supported: the mesh is seen from behind, too");
  }
  const auto file = object.find({"file", "path"});
  if (!file || !file->is(Kind::Text) || file->text().empty()) {
    context_.warnings.add(kNoMeshFile, object.where(), "this mesh names no \"file\": left out");
    return {};
  }
  std::vector<Part> parts;
  for (const MeshPart& mesh : meshes_.load(*file, treatment, bsdf_count)) {
    parts.push_back(placed_mesh(mesh.mesh, transform));
    parts.back().bsdf = mesh.bsdf;
  }
  return parts;
}

std::vector<Part> PrimitiveReader::curve_parts(const ObjectReader& object, const Mat4& transform) {
  static const std::vector<std::string> kModes = {"half_cylinder", "cylinder", "bcsdf_cylinder",
                                                  "ribbon"};
  const std::string mode = object.text("mode").value_or(kModes.front());
  if (std::find(kModes.begin(), kModes.end(), mode) == kModes.end()) {
    throw SceneError(object.where(), unknown_name_message("curve mode", printable(mode), kModes));
  }
  if (mode == "ribbon") {
    context_.warnings.add(kCurveMode, object.where(),
                          "ribbons that turn at random are not supported: they face the ray");
  }
  if (object.number("subsample").value_or(0.F) > 0.F) {
    context_.warnings.add(kSubsample, object.where(),
                          "\"subsample\" is not supported: all curves are there");
  }
  if (const auto light = object.find({"power", "emission"}); light && is_bright(*light)) {
    context_.warnings.add(kUnlitCurves, light->where(),
                          "curves cannot shine: their emission is left out, and no even light "
                          "stands in for it");
  }
  if (!object.has("bsdf")) {
    context_.warnings.add(kHair, object.where(),
                          "curves without a \"bsdf\" are hair: a white diffuse stands in");
  }
  const StrandTreatment treatment{.radius = object.number("curve_thickness"),
                                  .tapers = object.flag("curve_taper").value_or(false)};
  const auto file = object.find({"file", "path"});
  const auto leave_out = [&](const std::string& reason) {
    context_.warnings.add(kNoCurves, object.where(), "cannot use these curves: " + reason,
                          !file ? "" : printable(file->text()));
    return std::vector<Part>();
  };
  if (!file) return leave_out("they name no \"file\"");
  desc::Curves curves;
  try {
    const std::string path = context_.files.resolve(file->text(), file->where());
    curves = curves_of(read_strands(context_.files.load(path).view(), path), treatment);
  } catch (const Error& error) {
    return leave_out(error.what());
  }
  if (std::all_of(curves.widths.begin(), curves.widths.end(), [](float w) { return w == 0.F; })) {
    return leave_out("none has three nodes and a width");
  }
  const bool faces_ray = mode == "ribbon" || mode == "bcsdf_cylinder";
  Part part;
  part.node = desc::shape_node(
      "curves", {{"type", std::string(faces_ray ? "flat" : "cylinder")},
                 {"curves", std::make_shared<const desc::Curves>(std::move(curves))}});
  part.to_world = transform;
  return {part};
}

std::vector<Part> PrimitiveReader::parts_of(const ObjectReader& object, const std::string& type,
                                            const Mat4& transform, int bsdf_count) {
  if (type == "mesh") return mesh_parts(object, transform, bsdf_count);
  if (type == "curves") return curve_parts(object, transform);
  if (type == "quad") return {quad(transform)};
  if (type == "cube") return {cube(transform)};
  if (type == "sphere") return {sphere(transform)};
  if (type == "cylinder") return cylinder(transform, object.flag("capped").value_or(true));
  if (type == "disk") {
    constexpr float kHalfSpace = 90.F;
    if (object.number("cone_angle").value_or(kHalfSpace) < kHalfSpace) {
      context_.warnings.add(kConeAngle, object.where(),
                            "\"cone_angle\" is not supported: the disk shines in all directions");
    }
    return {disk(transform)};
  }
  // Remaining types are lights and copies within copied primitives.
  if (std::find(kPrimitiveTypes.begin(), kPrimitiveTypes.end(), type) != kPrimitiveTypes.end()) {
    object.accept({"map_path", "resource_packs", "masters", "instances", "sample"});
    context_.warnings.add(kUnsupported, object.where(),
                          "primitives of type \"" + type + "\" are not supported here: left out",
                          type);
    return {};
  }
  context_.warnings.add(
      kUnknownPrimitive, object.where(),
      unknown_name_message("primitive type", printable(type), kPrimitiveTypes) + ". Left out",
      printable(type));
  return {};
}

// ---------------------------------------------------------------- what surrounds it

std::vector<Surface> PrimitiveReader::surfaces_of(const ObjectReader& object) {
  const auto json = object.find("bsdf");
  if (!json) return {bsdfs_.white()};
  if (!json->is(Kind::Array)) return {bsdfs_.resolve(*json)};
  std::vector<Surface> surfaces;
  for (const LocatedJson& item : json->items()) surfaces.push_back(bsdfs_.resolve(item));
  if (surfaces.empty()) throw SceneError(json->where(), "the array of bsdfs is empty");
  return surfaces;
}

std::optional<desc::Emission> PrimitiveReader::emission_of(const ObjectReader& object,
                                                           double area) {
  const auto emission = object.find("emission");
  const auto power = object.find("power");
  const auto json = power ? power : emission;
  if (!json) return std::nullopt;
  desc::Value radiance = textures_.color(*json);
  if (const Vec3* constant = std::get_if<Vec3>(&radiance)) {
    radiance = not_negative(context_, json->where(), *constant);
  }
  if (is_zero(radiance)) return std::nullopt;
  // A diffuse emitter of area A and radiance L has the power πAL.
  const double scale = power ? 1.0 / (static_cast<double>(kPi) * area) : 1.0;
  const Vec3 factor(static_cast<float>(scale));
  if (!is_finite(factor)) return std::nullopt;
  return desc::Emission{json->where(),
                        desc::emission_node("area", {{"radiance", radiance}, {"scale", factor}})};
}

void PrimitiveReader::set_media(const ObjectReader& object, const Surface& surface,
                                desc::Shape& shape) {
  auto inside = object.find("int_medium");
  auto outside = object.find("ext_medium");
  if (!inside) inside = surface.inside;
  if (!outside) outside = surface.outside;
  if (inside) shape.inside = media_.resolve(*inside);
  if (outside) shape.outside = media_.resolve(*outside);
  shape.has_medium_interface = inside || outside;
}

void PrimitiveReader::warn_of_lids(const ObjectReader& object, const Surface& surface,
                                   const std::optional<desc::Emission>& emission) {
  const bool has_any =
      has_texture(context_.scene, surface.material) || surface.alpha != desc::kNone ||
      (emission && std::holds_alternative<desc::TextureRef>(emission->node.get("radiance")));
  if (!has_any) return;
  context_.warnings.add(kLids, object.where(),
                        "the texture runs around the lids of this cylinder, not across them");
}

void PrimitiveReader::read(const LocatedJson& json, std::vector<desc::Shape>& shapes) {
  const ObjectReader object(context_, json, "a primitive");
  const std::string name = object.text("name").value_or("");
  const std::optional<std::string> type = object.text("type");
  if (!type) throw SceneError(json.where(), "a primitive needs \"type\"");
  const Mat4 transform = transform_of(context_, object);
  if (!name.empty()) places_.try_emplace(name, transform);
  const bool is_top = &shapes == &context_.scene.shapes;
  if (is_top) {
    const auto light = object.find({"power", "emission"});
    if (*type == "skydome" || (light && is_bright(*light))) has_light_ = true;
  }
  object.accept({"bump_strength"});
  if (object.has("bump")) {
    context_.warnings.add(kBumpStrength, object.where(),
                          "bumps of primitives are not supported, only those of bsdfs: ignored");
  }
  if (is_top && *type == "instances") return read_instances(object, transform);
  if (is_top && read_light(context_, textures_, object, *type, transform, places_)) {
    return object.report_unknown();
  }
  const std::vector<Surface> surfaces = surfaces_of(object);
  const std::vector<Part> parts =
      parts_of(object, *type, transform, static_cast<int>(surfaces.size()));
  double area = 0.0;
  for (const Part& part : parts) area += part.area;
  if (*type != "mesh" && surfaces.size() > 1) {
    context_.warnings.add(kMoreBsdfs, json.where(),
                          "only meshes can have several bsdfs: the first counts", printable(name));
  }
  const bool can_shine = *type != "curves";
  std::optional<desc::Emission> emission;
  if (can_shine) emission = emission_of(object, area);
  if (emission && !is_top) {
    context_.warnings.add(kInstancedLight, emission->where,
                          "what is copied cannot be a light: its emission is left out");
    emission.reset();
  }
  if (*type == "cylinder" && parts.size() > 1) warn_of_lids(object, surfaces.front(), emission);
  for (const Part& part : parts) {
    if (!is_invertible(part.to_world) || (can_shine && !(part.area > 0.0))) {
      context_.warnings.add(kFlat, json.where(),
                            "the transform of this primitive cannot be inverted: left out",
                            printable(name));
      continue;
    }
    const Surface& surface = surfaces[static_cast<std::size_t>(part.bsdf)];
    desc::Shape shape;
    shape.where = json.where();
    shape.name = name;
    shape.node = part.node;
    shape.to_world = part.to_world;
    shape.reverse_orientation = part.reverse_orientation;
    shape.material = surface.material;
    shape.alpha = surface.alpha;
    shape.alpha_counted =
        surface.alpha != desc::kNone && must_count_cut_outs(context_.scene.hints.max_depth.value_or(
                                            desc::RenderHints::kDefaultMaxDepth));
    shape.emission = emission;
    set_media(object, surface, shape);
    if (part.has_turned_winding) {
      // Opaque surfaces look alike from both sides, so that the emissive side decides.
      if (emission) {
        shape.reverse_orientation = true;
      } else {
        std::swap(shape.inside, shape.outside);
      }
    }
    shapes.push_back(std::move(shape));
  }
  object.accept({"emission", "power", "int_medium", "ext_medium"});
  object.report_unknown();
}

// ---------------------------------------------------------------- copies

desc::ObjectId PrimitiveReader::object_of(const LocatedJson& master) {
  LocatedJson json = master;
  if (master.is(Kind::Text)) {
    const auto found = named_.find(master.text());
    if (found == named_.end()) return desc::kNone;
    json = found->second;
  }
  std::vector<desc::Shape> shapes;
  read(json, shapes);
  if (shapes.empty()) return desc::kNone;
  context_.scene.objects.push_back({shapes.front().name, json.where(), std::move(shapes)});
  return static_cast<desc::ObjectId>(context_.scene.objects.size()) - 1;
}

void PrimitiveReader::read_instances(const ObjectReader& object, const Mat4& transform) {
  object.accept({"bsdf", "int_medium", "ext_medium"});
  if (const auto light = object.find({"power", "emission"}); light && is_bright(*light)) {
    context_.warnings.add(kUnlitInstances, light->where(),
                          "instances cannot shine: their own emission is left out, and no even "
                          "light stands in for it");
  }
  std::vector<desc::ObjectId> masters;
  if (const auto list = object.find("masters"); list && list->is(Kind::Array)) {
    for (const LocatedJson& master : list->items()) masters.push_back(object_of(master));
  }
  if (object.has("instancesB")) {
    context_.warnings.add(kMovingInstances, object.where(),
                          "instances between two files are not supported: the first file counts");
  }
  object.accept({"ratio"});
  const auto list = object.find({"instances", "instancesA"});
  object.report_unknown();
  if (!list) return;
  // Copies are never scaled, and neither is their common transform.
  const Mat4 turn = without_scale(transform, false);
  std::size_t lost = 0;
  for (const Placed& placed : read_placed(context_, *list)) {
    const auto index = static_cast<std::size_t>(placed.master);
    if (placed.master < 0 || index >= masters.size() || masters[index] == desc::kNone) {
      ++lost;
      continue;
    }
    Vec3d origin;
    transform.multVecMatrix(origin_of(placed.to_world), origin);
    const Mat4 turned = placed.to_world * turn;
    const Mat4 to_world =
        from_axes(axis_of(turned, 0), axis_of(turned, 1), axis_of(turned, 2), origin);
    if (!is_invertible(to_world)) {
      ++lost;
      continue;
    }
    context_.scene.instances.push_back({masters[index], to_world, list->where()});
  }
  if (lost > 0) {
    context_.warnings.add(kNoMaster, list->where(),
                          std::to_string(lost) + " instances have nothing to copy: left out");
  }
}

bool is_primitive_type(std::string_view name) {
  return std::find(kPrimitiveTypes.begin(), kPrimitiveTypes.end(), name) != kPrimitiveTypes.end();
}

void PrimitiveReader::read_all(const LocatedJson& list) {
  if (!list.is(Kind::Array)) throw SceneError(list.where(), "\"primitives\" must be an array");
  for (const LocatedJson& json : list.items()) {
    const auto name = json.is(Kind::Object) ? json.find("name") : std::nullopt;
    if (name && name->is(Kind::Text)) named_.try_emplace(name->text(), json);
  }
  // Primitives that may refer to the places of others come last.
  for (const bool last : {false, true}) {
    for (const LocatedJson& json : list.items()) {
      if ((type_of(json) == "infinite_sphere_cap") == last) read(json, context_.scene.shapes);
    }
  }
}

}  // namespace ajar::tungsten
