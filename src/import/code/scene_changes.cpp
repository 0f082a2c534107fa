#include "import/code/scene_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>

#include "import/code/node_values.h"
#include "import/common/transforms.h"

namespace ajar {

namespace {

using Json = nlohmann::ordered_json;
using desc::ModelKind;

/// Carries the changes out, part by part; additions come after existing parts.
class Changer {
 public:
  Changer(desc::SceneDesc& scene, std::span<const NumberArray> arrays, Warnings& warnings)
      : scene_(scene),
        arrays_(arrays, scene.embedded_files, warnings),
        first_texture_(scene.textures.size()),
        first_material_(scene.materials.size()),
        first_medium_(scene.media.size()) {
    references_.texture = [this](const LocatedJson& which) {
      return find(which, scene_.textures, first_texture_, "texture");
    };
    references_.material = [this](const LocatedJson& which) {
      return find(which, scene_.materials, first_material_, "material");
    };
  }

  void change(const LocatedJson& changes) {
    code::check_members(changes, {"source", "film", "camera", "media", "textures", "materials",
                                  "shapes", "lights", "edits"});
    scene_.source = changes.value_or("source", scene_.source);
    if (const auto film = changes.find("film")) set_film(*film);
    for (const LocatedJson& json : changes.items("media")) add_medium(json);
    for (const LocatedJson& json : changes.items("textures")) add_texture(json);
    for (const LocatedJson& json : changes.items("materials")) add_material(json);
    for (const LocatedJson& json : changes.items("shapes")) add_shape(json);
    for (const LocatedJson& json : changes.items("lights")) add_light(json);
    if (const auto camera = changes.find("camera")) set_camera(*camera);
    for (const LocatedJson& json : changes.items("edits")) edit(json);
  }

 private:
  /// A number counts from `first`, a name is one of all; of several, the last.
  template <typename Things>
  static int find(const LocatedJson& which, const Things& things, std::size_t first,
                  const char* what) {
    if (which.is(LocatedJson::Kind::Text)) {
      std::vector<std::string> names;
      for (const auto& thing : things) names.push_back(thing.name);
      const std::string name = which.text();
      const auto found = std::find(names.rbegin(), names.rend(), name);
      if (found != names.rend() && !name.empty()) {
        return static_cast<int>(names.rend() - found) - 1;
      }
      std::erase(names, "");
      which.fail(unknown_name_message(what, name, names));
    }
    const auto number = which.as<std::size_t>();
    if (number < things.size() - first) return static_cast<int>(first + number);
    which.fail(
        fmt::format("there is no {} {}: it must come before what refers to it", what, number));
  }

  static int reference(const LocatedJson& json, const char* member,
                       const std::function<int(const LocatedJson&)>& find_it) {
    const auto which = json.find(member);
    return which ? find_it(*which) : desc::kNone;
  }
  int medium(const LocatedJson& json, const char* member) const {
    return reference(json, member, [this](const LocatedJson& which) {
      return find(which, scene_.media, first_medium_, "medium");
    });
  }

  static Mat4 transform(const LocatedJson& json) {
    const auto matrix = json.find("to_world");
    return matrix ? code::read_transform(*matrix) : Mat4();
  }

  static Vec3 triple(const LocatedJson& json, const char* name) {
    const Vec3 value = json.value_or(name, Vec3(0.F));
    if (!(std::min({value.x, value.y, value.z}) >= 0.F)) {
      json.at(name).fail_type("three numbers from 0 on");
    }
    return value;
  }

  void set_film(const LocatedJson& json) {
    code::check_members(json, {"resolution"});
    const auto size = json.find("resolution");
    if (!size) return;
    constexpr int kMost = 65536;
    const auto sides = size->as<std::array<int, 2>>();
    if (std::min(sides[0], sides[1]) < 1 || std::max(sides[0], sides[1]) > kMost) {
      size->fail_type("width and height, each from 1 to 65536");
    }
    scene_.film.resolution = {sides[0], sides[1]};
  }

  void add_medium(const LocatedJson& json) {
    code::check_members(json, {"name", "sigma_a", "sigma_s", "g"});
    desc::Medium medium{json.value_or("name", std::string()), json.where()};
    medium.sigma_a = triple(json, "sigma_a");
    medium.sigma_s = triple(json, "sigma_s");
    medium.g = json.value_or("g", 0.F);
    if (!(medium.g > -1.F && medium.g < 1.F)) json.at("g").fail_type("between -1 and 1");
    scene_.media.push_back(std::move(medium));
  }

  void add_texture(const LocatedJson& json) {
    code::check_members(json, {"name", "model", "parameters"});
    desc::Texture texture{json.value_or("name", std::string()), json.where(),
                          code::read_node(ModelKind::Texture, json, arrays_, references_)};
    scene_.textures.push_back(std::move(texture));
  }

  void add_material(const LocatedJson& json) {
    code::check_members(json, {"name", "model", "parameters", "bump", "normal_map"});
    desc::Material material;
    material.name = json.value_or("name", std::string());
    material.where = json.where();
    material.bump = reference(json, "bump", references_.texture);
    material.normal_map.texture = reference(json, "normal_map", references_.texture);
    material.node = code::read_node(ModelKind::Material, json, arrays_, references_);
    scene_.materials.push_back(std::move(material));
  }

  void add_shape(const LocatedJson& json) {
    code::check_members(
        json, {"name", "model", "parameters", "to_world", "reverse_orientation", "material",
               "alpha", "shadow_alpha", "emission", "inside", "outside"});
    desc::Shape shape;
    shape.where = json.where();
    shape.name = json.value_or("name", std::string());
    shape.node = code::read_node(ModelKind::Shape, json, arrays_, references_);
    check_geometry(shape.node, json);
    shape.to_world = transform(json);
    shape.reverse_orientation = json.value_or("reverse_orientation", false);
    shape.material = reference(json, "material", references_.material);
    shape.alpha = reference(json, "alpha", references_.texture);
    shape.shadow_alpha = reference(json, "shadow_alpha", references_.texture);
    if (const auto emission = json.find("emission")) {
      code::check_members(*emission, {"model", "parameters"});
      shape.emission.emplace(
          desc::Emission{emission->where(),
                         code::read_node(ModelKind::Emission, *emission, arrays_, references_)});
    }
    shape.has_medium_interface = json.has("inside") || json.has("outside");
    shape.inside = medium(json, "inside");
    shape.outside = medium(json, "outside");
    scene_.shapes.push_back(std::move(shape));
  }

  /// A mesh or curves have no default.
  static void check_geometry(const desc::Node& node, const LocatedJson& json) {
    for (std::size_t i = 0; i < node.values().size(); ++i) {
      const desc::Value& value = node.values()[i];
      const auto* mesh = std::get_if<desc::MeshPointer>(&value);
      const auto* curves = std::get_if<desc::CurvesPointer>(&value);
      if ((mesh != nullptr && *mesh == nullptr) || (curves != nullptr && *curves == nullptr)) {
        json.fail("it needs \"" + node.model().parameters[i].name + "\"");
      }
    }
  }

  void add_light(const LocatedJson& json) {
    code::check_members(json, {"name", "model", "parameters", "to_world", "medium"});
    desc::Light light{json.where(), transform(json),
                      code::read_node(ModelKind::Light, json, arrays_, references_),
                      medium(json, "medium")};
    scene_.lights.push_back(std::move(light));
  }

  void set_camera(const LocatedJson& json) {
    code::check_members(json, {"model", "to_world", "fov", "lens_radius", "focal_distance",
                               "half_height", "medium"});
    const std::vector<std::string> models = {"perspective", "orthographic", "environment"};
    const std::string model = json.value_or("model", models[0]);
    desc::Camera& camera = scene_.camera;
    camera.where = json.where();
    camera.to_world = transform(json);
    camera.medium = medium(json, "medium");
    if (!inverse(camera.to_world)) json.fail("its transform cannot be inverted");
    const auto positive = [&](const char* name, float otherwise) {
      const float value = json.value_or(name, otherwise);
      if (!(value > 0.F)) json.at(name).fail_type("above 0");
      return value;
    };
    const float lens = json.value_or("lens_radius", 0.F);
    if (lens < 0.F) json.at("lens_radius").fail_type("at least 0");
    const float focus = positive("focal_distance", 1e6F);
    if (model == models[0]) {
      const float fov = positive("fov", 90.F);
      if (!(fov < 180.F)) json.at("fov").fail_type("below 180 degrees");
      camera.node = desc::PerspectiveCamera{fov, lens, focus, {}, {}};
    } else if (model == models[1]) {
      const float half = positive("half_height", 1.F);
      const float aspect = static_cast<float>(scene_.film.resolution.x) /
                           static_cast<float>(scene_.film.resolution.y);
      camera.node = desc::OrthographicCamera{
          lens, focus, desc::ScreenWindow{-half * aspect, half * aspect, -half, half}, {}};
    } else if (model == models[2]) {
      camera.node = desc::EnvironmentCamera{};
    } else {
      json.fail(unknown_name_message("camera", model, models));
    }
  }

  /// The place in `things` that an edit means: a number counts all of them.
  template <typename Things>
  std::size_t edited(const LocatedJson& json, const Things& things, const char* what) {
    return static_cast<std::size_t>(find(json.at("which"), things, 0, what));
  }

  void edit(const LocatedJson& json) {
    code::check_members(json, {"kind", "which", "parameters", "material", "to_world"});
    const std::vector<std::string> kinds = {"material", "light", "emission", "shape", "texture"};
    const std::string kind = json.value_or("kind", std::string());
    if (kind == "material") {
      desc::Material& material = scene_.materials[edited(json, scene_.materials, "material")];
      set(ModelKind::Material, material.node, json);
      check_order<desc::MaterialRef>(json, material, scene_.materials);
    } else if (kind == "texture") {
      desc::Texture& texture = scene_.textures[edited(json, scene_.textures, "texture")];
      set(ModelKind::Texture, texture.node, json);
      check_order<desc::TextureRef>(json, texture, scene_.textures);
    } else if (kind == "light") {
      desc::Light& light = light_edited(json);
      set(ModelKind::Light, light.node, json);
      if (json.has("to_world")) light.to_world = transform(json);
    } else if (kind == "emission") {
      desc::Shape& shape = scene_.shapes[edited(json, scene_.shapes, "shape")];
      if (!shape.emission) json.fail("the shape \"" + shape.name + "\" emits no light");
      set(ModelKind::Emission, shape.emission->node, json);
    } else if (kind == "shape") {
      desc::Shape& shape = scene_.shapes[edited(json, scene_.shapes, "shape")];
      set(ModelKind::Shape, shape.node, json);
      if (json.has("material")) {
        shape.material = reference(json, "material", references_.material);
      }
      if (json.has("to_world")) shape.to_world = transform(json);
    } else {
      json.fail(unknown_name_message("kind", kind, kinds));
    }
  }

  /// Lights have no names.
  desc::Light& light_edited(const LocatedJson& json) {
    const LocatedJson which = json.at("which");
    if (scene_.lights.empty()) which.fail("there is no light " + which.shown());
    return scene_.lights[which.index(scene_.lights.size())];
  }

  void set(ModelKind kind, desc::Node& node, const LocatedJson& json) {
    code::set_parameters(kind, node, json, arrays_, references_);
  }

  /// Cycles of references are refused.
  template <typename Reference, typename Thing>
  static void check_order(const LocatedJson& json, const Thing& thing,
                          const std::vector<Thing>& things) {
    const auto own = static_cast<int>(&thing - things.data());
    for (const desc::Value& value : thing.node.values()) {
      const auto* reference = std::get_if<Reference>(&value);
      if (reference != nullptr && reference->id >= own) {
        json.fail("it can only refer to what was there before it");
      }
    }
  }

  desc::SceneDesc& scene_;
  code::ArrayReader arrays_;
  code::References references_;
  std::size_t first_texture_, first_material_, first_medium_;
};

}  // namespace

std::size_t NumberArray::size() const {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

desc::SceneDesc changed_scene(desc::SceneDesc scene, std::string_view changes,
                              std::span<const NumberArray> arrays, Warnings& warnings) {
  Changer(scene, arrays, warnings).change(code::parse_description(changes, "scene"));
  return scene;
}

void check_node(ModelKind kind, std::string_view node) {
  desc::EmbeddedFiles embedded;
  Warnings warnings;
  const LocatedJson json = code::parse_description(node, code::name_of(kind));
  code::check_members(json, {"model", "parameters"});
  // References are resolved when it is added to a scene.
  const auto any = [](const LocatedJson&) { return 0; };
  code::read_node(kind, json, code::ArrayReader({}, embedded, warnings), {any, any});
}

std::string editable_parts(const desc::SceneDesc& scene) {
  const auto named = [](const std::string& name, const desc::Node& node) {
    Json json{{"name", name}};
    json.update(node.has_model() ? code::node_json(node) : Json::object());
    return json;
  };
  Json parts{{"textures", Json::array()},
             {"materials", Json::array()},
             {"lights", Json::array()},
             {"shapes", Json::array()}};
  for (const auto& texture : scene.textures) {
    parts["textures"].push_back(named(texture.name, texture.node));
  }
  for (const auto& material : scene.materials) {
    parts["materials"].push_back(named(material.name, material.node));
  }
  for (const auto& light : scene.lights) parts["lights"].push_back(named("", light.node));
  for (const auto& shape : scene.shapes) {
    Json& json = parts["shapes"].emplace_back(named(shape.name, shape.node));
    json["material"] = shape.material < 0 ? Json() : Json(shape.material);
    if (shape.emission) json["emission"] = code::node_json(shape.emission->node);
  }
  return parts.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace ajar
