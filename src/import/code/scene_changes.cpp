#include "import/code/scene_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "import/code/node_values.h"
#include "import/common/transforms.h"

namespace ajar {

namespace {

using code::Json;
using code::JsonPlace;
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
    references_.texture = [this](const Json& which, const JsonPlace& place) {
      return find(which, place, scene_.textures, first_texture_, "texture");
    };
    references_.material = [this](const Json& which, const JsonPlace& place) {
      return find(which, place, scene_.materials, first_material_, "material");
    };
  }

  void change(const JsonPlace& changes) {
    scene_.source = changes.text("source", scene_.source);
    if (const Json* film = changes.find("film")) set_film({*film, "film", {"resolution"}});
    each(changes, "media",
         [&](const Json& json, const std::string& what) { add_medium(json, what); });
    each(changes, "textures",
         [&](const Json& json, const std::string& what) { add_texture(json, what); });
    each(changes, "materials",
         [&](const Json& json, const std::string& what) { add_material(json, what); });
    each(changes, "shapes",
         [&](const Json& json, const std::string& what) { add_shape(json, what); });
    each(changes, "lights",
         [&](const Json& json, const std::string& what) { add_light(json, what); });
    if (const Json* camera = changes.find("camera")) set_camera(*camera);
    each(changes, "edits", [&](const Json& json, const std::string& what) { edit(json, what); });
  }

 private:
  /// "material" or, if it has a name, `material "glass"`.
  static std::string title(const Json& json, const std::string& what) {
    const auto name = json.is_object() ? json.find("name") : json.end();
    const bool is_named = json.is_object() && name != json.end() && name->is_string() &&
                          !name->get<std::string>().empty();
    return is_named ? what + " \"" + name->get<std::string>() + "\"" : what;
  }

  template <typename Add>
  static void each(const JsonPlace& changes, const char* name, Add add) {
    const Json* list = changes.find(name);
    if (list == nullptr) return;
    if (!list->is_array()) changes.fail("\"" + std::string(name) + "\" must be a list");
    std::string what = name;
    if (what == "media") what = "medium";
    if (what.ends_with('s')) what.pop_back();
    for (const Json& json : *list) add(json, title(json, what));
  }

  /// A number counts from `first`, a name is one of all; of several, the last.
  template <typename Things>
  static int find(const Json& which, const JsonPlace& place, const Things& things,
                  std::size_t first, const char* what) {
    if (which.is_string()) {
      std::vector<std::string> names;
      for (const auto& thing : things) names.push_back(thing.name);
      const std::string name = which.get<std::string>();
      const auto found = std::find(names.rbegin(), names.rend(), name);
      if (found != names.rend() && !name.empty()) {
        return static_cast<int>(names.rend() - found) - 1;
      }
      std::erase(names, "");
      place.fail(unknown_name_message(what, name, names));
    }
    const std::size_t count = things.size() - first;
    if (which.is_number_integer() && which.get<std::int64_t>() >= 0 &&
        which.get<std::uint64_t>() < count) {
      return static_cast<int>(first) + which.get<int>();
    }
    place.fail(fmt::format("there is no {} {}: it must come before what refers to it", what,
                           code::shown(which)));
  }

  int reference(const JsonPlace& place, const char* member,
                const std::function<int(const Json&, const JsonPlace&)>& find_it) const {
    const Json* which = place.find(member);
    return which == nullptr ? desc::kNone : find_it(*which, place);
  }
  int medium(const JsonPlace& place, const char* member) const {
    return reference(place, member, [this](const Json& which, const JsonPlace& at) {
      return find(which, at, scene_.media, first_medium_, "medium");
    });
  }

  static Mat4 transform(const JsonPlace& place) {
    const Json* json = place.find("to_world");
    return json == nullptr ? Mat4() : code::read_transform(*json, place, "to_world");
  }

  static Vec3 triple(const JsonPlace& place, const char* name) {
    const Json* json = place.find(name);
    if (json == nullptr) return Vec3(0.F);
    const bool fits = json->is_array() && json->size() == 3 &&
                      std::all_of(json->begin(), json->end(), [](const Json& number) {
                        return number.is_number() && number.get<float>() >= 0.F &&
                               std::isfinite(number.get<float>());
                      });
    if (!fits) {
      place.fail("\"" + std::string(name) + "\" must be three numbers from 0 on, not " +
                 code::shown(*json));
    }
    return {(*json)[0], (*json)[1], (*json)[2]};
  }

  void set_film(const JsonPlace& place) {
    const Json* size = place.find("resolution");
    if (size == nullptr) return;
    constexpr int kMost = 65536;
    const auto is_side = [](const Json& side) {
      return side.is_number_integer() && side.get<std::int64_t>() >= 1 &&
             side.get<std::int64_t>() <= kMost;
    };
    if (!size->is_array() || size->size() != 2 || !is_side((*size)[0]) || !is_side((*size)[1])) {
      place.fail("\"resolution\" must be width and height, each from 1 to 65536, not " +
                 code::shown(*size));
    }
    scene_.film.resolution = {(*size)[0].get<int>(), (*size)[1].get<int>()};
  }

  void add_medium(const Json& json, const std::string& what) {
    const JsonPlace place(json, what, {"name", "sigma_a", "sigma_s", "g"});
    desc::Medium medium{place.text("name"), place.where()};
    medium.sigma_a = triple(place, "sigma_a");
    medium.sigma_s = triple(place, "sigma_s");
    const double g = place.number("g", 0.0);
    if (!(g > -1.0 && g < 1.0)) place.fail("\"g\" must be between -1 and 1");
    medium.g = static_cast<float>(g);
    scene_.media.push_back(std::move(medium));
  }

  void add_texture(const Json& json, const std::string& what) {
    const JsonPlace place(json, what, {"name", "model", "parameters"});
    desc::Texture texture{place.text("name"), place.where(),
                          code::read_node(ModelKind::Texture, place, arrays_, references_)};
    scene_.textures.push_back(std::move(texture));
  }

  void add_material(const Json& json, const std::string& what) {
    const JsonPlace place(json, what, {"name", "model", "parameters", "bump", "normal_map"});
    desc::Material material;
    material.name = place.text("name");
    material.where = place.where();
    material.bump = reference(place, "bump", references_.texture);
    material.normal_map.texture = reference(place, "normal_map", references_.texture);
    material.node = code::read_node(ModelKind::Material, place, arrays_, references_);
    scene_.materials.push_back(std::move(material));
  }

  void add_shape(const Json& json, const std::string& what) {
    const JsonPlace place(json, what,
                          {"name", "model", "parameters", "to_world", "reverse_orientation",
                           "material", "alpha", "shadow_alpha", "emission", "inside", "outside"});
    desc::Shape shape;
    shape.where = place.where();
    shape.name = place.text("name");
    shape.node = code::read_node(ModelKind::Shape, place, arrays_, references_);
    check_geometry(shape.node, place);
    shape.to_world = transform(place);
    shape.reverse_orientation = place.flag("reverse_orientation", false);
    shape.material = reference(place, "material", references_.material);
    shape.alpha = reference(place, "alpha", references_.texture);
    shape.shadow_alpha = reference(place, "shadow_alpha", references_.texture);
    if (const Json* emission = place.find("emission")) {
      const JsonPlace of(*emission, "emission", {"model", "parameters"});
      shape.emission.emplace(desc::Emission{
          of.where(), code::read_node(ModelKind::Emission, of, arrays_, references_)});
    }
    shape.has_medium_interface =
        place.find("inside") != nullptr || place.find("outside") != nullptr;
    shape.inside = medium(place, "inside");
    shape.outside = medium(place, "outside");
    scene_.shapes.push_back(std::move(shape));
  }

  /// A mesh or curves have no default.
  static void check_geometry(const desc::Node& node, const JsonPlace& place) {
    for (std::size_t i = 0; i < node.values().size(); ++i) {
      const desc::Value& value = node.values()[i];
      const auto* mesh = std::get_if<desc::MeshPointer>(&value);
      const auto* curves = std::get_if<desc::CurvesPointer>(&value);
      if ((mesh != nullptr && *mesh == nullptr) || (curves != nullptr && *curves == nullptr)) {
        place.fail("it needs \"" + node.model().parameters[i].name + "\"");
      }
    }
  }

  void add_light(const Json& json, const std::string& what) {
    const JsonPlace place(json, what, {"name", "model", "parameters", "to_world", "medium"});
    desc::Light light{place.where(), transform(place),
                      code::read_node(ModelKind::Light, place, arrays_, references_),
                      medium(place, "medium")};
    scene_.lights.push_back(std::move(light));
  }

  void set_camera(const Json& json) {
    const JsonPlace place(
        json, "camera",
        {"model", "to_world", "fov", "lens_radius", "focal_distance", "half_height", "medium"});
    const std::vector<std::string> models = {"perspective", "orthographic", "environment"};
    const std::string model = place.text("model", models[0]);
    desc::Camera& camera = scene_.camera;
    camera.where = place.where();
    camera.to_world = transform(place);
    camera.medium = medium(place, "medium");
    if (!inverse(camera.to_world)) place.fail("its transform cannot be inverted");
    const auto positive = [&](const char* name, double otherwise) {
      const double value = place.number(name, otherwise);
      const auto used = static_cast<float>(value);
      if (!(used > 0.F)) place.fail(fmt::format("\"{}\" must be above 0, not {}", name, value));
      if (!std::isfinite(used)) place.fail(fmt::format("\"{}\" is too large: {}", name, value));
      return used;
    };
    const double lens = place.number("lens_radius", 0.0);
    if (lens < 0.0) place.fail(fmt::format("\"lens_radius\" must be at least 0, not {}", lens));
    if (!std::isfinite(static_cast<float>(lens))) {
      place.fail(fmt::format("\"lens_radius\" is too large: {}", lens));
    }
    const float focus = positive("focal_distance", 1e6);
    if (model == models[0]) {
      const float fov = positive("fov", 90.0);
      if (!(fov < 180.F)) place.fail(fmt::format("\"fov\" must be below 180 degrees, not {}", fov));
      camera.node = desc::PerspectiveCamera{fov, static_cast<float>(lens), focus, {}, {}};
    } else if (model == models[1]) {
      const float half = positive("half_height", 1.0);
      const float aspect = static_cast<float>(scene_.film.resolution.x) /
                           static_cast<float>(scene_.film.resolution.y);
      camera.node =
          desc::OrthographicCamera{static_cast<float>(lens),
                                   focus,
                                   desc::ScreenWindow{-half * aspect, half * aspect, -half, half},
                                   {}};
    } else if (model == models[2]) {
      camera.node = desc::EnvironmentCamera{};
    } else {
      place.fail(unknown_name_message("camera", model, models));
    }
  }

  /// The place in `things` that an edit means: a number counts all of them.
  template <typename Things>
  std::size_t edited(const JsonPlace& place, const Things& things, const char* what) {
    const Json* which = place.find("which");
    if (which == nullptr) place.fail("an edit says \"which\"");
    return static_cast<std::size_t>(find(*which, place, things, 0, what));
  }

  void edit(const Json& json, const std::string& what) {
    const JsonPlace place(json, what, {"kind", "which", "parameters", "material", "to_world"});
    const std::vector<std::string> kinds = {"material", "light", "emission", "shape", "texture"};
    const std::string kind = place.text("kind");
    if (kind == "material") {
      desc::Material& material = scene_.materials[edited(place, scene_.materials, "material")];
      set(ModelKind::Material, material.node, place);
      check_order<desc::MaterialRef>(place, material, scene_.materials);
    } else if (kind == "texture") {
      desc::Texture& texture = scene_.textures[edited(place, scene_.textures, "texture")];
      set(ModelKind::Texture, texture.node, place);
      check_order<desc::TextureRef>(place, texture, scene_.textures);
    } else if (kind == "light") {
      desc::Light& light = scene_.lights[light_edited(place)];
      set(ModelKind::Light, light.node, place);
      if (place.find("to_world") != nullptr) light.to_world = transform(place);
    } else if (kind == "emission") {
      desc::Shape& shape = scene_.shapes[edited(place, scene_.shapes, "shape")];
      if (!shape.emission) place.fail("the shape \"" + shape.name + "\" emits no light");
      set(ModelKind::Emission, shape.emission->node, place);
    } else if (kind == "shape") {
      desc::Shape& shape = scene_.shapes[edited(place, scene_.shapes, "shape")];
      set(ModelKind::Shape, shape.node, place);
      if (place.find("material") != nullptr) {
        shape.material = reference(place, "material", references_.material);
      }
      if (place.find("to_world") != nullptr) shape.to_world = transform(place);
    } else {
      place.fail(unknown_name_message("kind", kind, kinds));
    }
  }

  std::size_t light_edited(const JsonPlace& place) {
    const Json* which = place.find("which");
    if (which == nullptr) place.fail("an edit says \"which\"");
    if (scene_.lights.empty()) place.fail("there is no light " + code::shown(*which));
    return static_cast<std::size_t>(place.index("which", scene_.lights.size()));
  }

  void set(ModelKind kind, desc::Node& node, const JsonPlace& place) {
    code::set_parameters(kind, node, place, arrays_, references_);
  }

  /// Cycles of references are refused.
  template <typename Reference, typename Thing>
  static void check_order(const JsonPlace& place, const Thing& thing,
                          const std::vector<Thing>& things) {
    const auto own = static_cast<int>(&thing - things.data());
    for (const desc::Value& value : thing.node.values()) {
      const auto* reference = std::get_if<Reference>(&value);
      if (reference != nullptr && reference->id >= own) {
        place.fail("it can only refer to what was there before it");
      }
    }
  }

  desc::SceneDesc& scene_;
  code::ArrayReader arrays_;
  code::References references_;
  std::size_t first_texture_, first_material_, first_medium_;
};

Json parsed(std::string_view text) {
  try {
    return code::parse_json(text);
  } catch (const UsageError& error) {
    throw SceneError("the description: " + std::string(error.what()));
  }
}

}  // namespace

std::size_t NumberArray::size() const {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

desc::SceneDesc changed_scene(desc::SceneDesc scene, std::string_view changes,
                              std::span<const NumberArray> arrays, Warnings& warnings) {
  const Json json = parsed(changes);
  Changer(scene, arrays, warnings)
      .change({json,
               "scene",
               {"source", "film", "camera", "media", "textures", "materials", "shapes", "lights",
                "edits"}});
  return scene;
}

void check_node(ModelKind kind, std::string_view node) {
  desc::EmbeddedFiles embedded;
  Warnings warnings;
  const Json json = parsed(node);
  // References are resolved when it is added to a scene.
  const auto any = [](const Json&, const JsonPlace&) { return 0; };
  code::read_node(kind, {json, code::name_of(kind), {"model", "parameters"}},
                  code::ArrayReader({}, embedded, warnings), {any, any});
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
