#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <variant>

#include "apps/cli/commands.h"
#include "apps/cli/messages.h"
#include "core/printable_text.h"
#include "core/warnings.h"
#include "os/standard_streams.h"
#include "scene/scene.h"
#include "session/job/progress.h"
#include "session/job/resources.h"
#include "session/render/memory_estimate.h"
#include "session/render/resolved_render.h"
#include "session/scenes/scene_file.h"

namespace ajar::cli {

namespace {

using Json = nlohmann::ordered_json;

template <typename... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

const char* kind_of(const desc::Camera& camera) {
  return std::visit(Overloaded{[](const desc::PerspectiveCamera&) { return "perspective"; },
                               [](const desc::OrthographicCamera&) { return "orthographic"; },
                               [](const desc::EnvironmentCamera&) { return "environment"; }},
                    camera.node);
}

const char* kind_of(const desc::Filter& filter) {
  return std::visit(Overloaded{[](const desc::BoxFilter&) { return "box"; },
                               [](const desc::TriangleFilter&) { return "triangle"; },
                               [](const desc::GaussianFilter&) { return "gaussian"; },
                               [](const desc::MitchellFilter&) { return "mitchell"; },
                               [](const desc::SincFilter&) { return "sinc"; }},
                    filter.node);
}

std::map<std::string, std::size_t> light_counts(const desc::SceneDesc& scene) {
  std::map<std::string, std::size_t> counts;
  for (const desc::Light& light : scene.lights) ++counts[light.node.model().name];
  for (const desc::Shape& shape : scene.shapes) {
    if (shape.emission) ++counts[shape.emission->node.model().name];
  }
  return counts;
}

std::map<std::string, std::size_t> shape_counts(const desc::SceneDesc& scene) {
  std::map<std::string, std::size_t> counts;
  const auto add = [&](const std::vector<desc::Shape>& shapes) {
    for (const desc::Shape& shape : shapes) ++counts[shape.node.model().name];
  };
  add(scene.shapes);
  for (const desc::Object& object : scene.objects) add(object.shapes);
  return counts;
}

std::map<std::string, std::size_t> material_counts(const desc::SceneDesc& scene) {
  std::map<std::string, std::size_t> counts;
  for (const desc::Material& material : scene.materials) ++counts[material.node.model().name];
  return counts;
}

Json camera_json(const desc::Camera& camera) {
  Json json{{"type", kind_of(camera)}};
  const Vec3 position = transform_point(camera.to_world, Vec3(0, 0, 0));
  const Vec3 direction = normalize(transform_vector(camera.to_world, Vec3(0, 0, 1)));
  json["position"] = {position.x, position.y, position.z};
  json["direction"] = {direction.x, direction.y, direction.z};
  if (const auto* perspective = std::get_if<desc::PerspectiveCamera>(&camera.node)) {
    json["fov_degrees"] = perspective->fov;
    json["lens_radius"] = perspective->lens_radius;
    json["focal_distance"] = perspective->focal_distance;
  }
  return json;
}

Json hints_json(const desc::RenderHints& hints) {
  const auto value_or_null = [](const auto& value) { return value ? Json(*value) : Json(); };
  return {{"integrator", hints.integrator.empty() ? Json() : Json(hints.integrator)},
          {"max_depth", value_or_null(hints.max_depth)},
          {"samples_per_pixel", value_or_null(hints.samples_per_pixel)},
          {"sampler", value_or_null(hints.sampler)}};
}

/// Images and patterns; a constant is no texture to whoever made the scene.
std::map<std::string, std::size_t> texture_counts(const desc::SceneDesc& scene) {
  std::map<std::string, std::size_t> counts;
  for (const desc::Texture& texture : scene.textures) {
    if (texture.node.is("constant")) continue;
    ++counts[texture.node.files().empty() ? "patterns" : "images"];
  }
  return counts;
}

/// Properties of the description, before the scene takes it.
Json describe(const desc::SceneDesc& description, const std::string& name) {
  Json json;
  json["scene"] = name;
  json["counts"] = Json::object();
  json["shapes"] = shape_counts(description);
  json["lights"] = light_counts(description);
  json["materials"] = material_counts(description);
  json["textures"] = texture_counts(description);
  json["media"] = Json::array();
  json["density_grids"] =
      std::count_if(description.media.begin(), description.media.end(),
                    [](const desc::Medium& medium) { return medium.density.has_value(); });
  for (const desc::Medium& medium : description.media) json["media"].push_back(medium.name);
  json["camera"] = camera_json(description.camera);
  const desc::Film& film = description.film;
  json["film"] = {{"resolution", {film.resolution.x, film.resolution.y}},
                  {"crop", {film.crop[0], film.crop[2], film.crop[1], film.crop[3]}},
                  {"filter", kind_of(film.filter)},
                  {"filter_radius", {film.filter.radius.x, film.filter.radius.y}},
                  {"scale", film.scale},
                  {"filename", film.filename}};
  json["hints"] = hints_json(description.hints);
  return json;
}

void add_built(const Scene& scene, Json& json) {
  const SceneCounts& c = scene.counts();
  std::size_t textures = 0;
  for (const auto& [kind, count] : json["textures"].items()) textures += count.get<std::size_t>();
  json["counts"] = {{"triangles", c.triangles},     {"instanced_triangles", c.instanced_triangles},
                    {"quadrics", c.quadrics},       {"curves", c.curves},
                    {"instances", c.instances},     {"lights", c.lights},
                    {"textures", textures},         {"materials", c.materials},
                    {"media", json["media"].size()}};
  const Box3& b = scene.bounds();
  if (!b.isEmpty()) {
    json["bounds"] = {{"min", {b.min.x, b.min.y, b.min.z}}, {"max", {b.max.x, b.max.y, b.max.z}}};
  } else {
    json["bounds"] = nullptr;
  }
  json["memory"]["embree_bytes"] = c.embree_bytes;
  json["memory"]["peak_bytes"] = peak_memory_bytes();
  json["hash"] = fmt::format("{:016x}", scene.hash());
}

/// Memory for rendering the picture that the file asks for with the layers that every method makes.
MemoryEstimate memory_of(const desc::SceneDesc& description) {
  const Vec2i resolution = description.film.resolution;
  const Box2i whole(Vec2i(0, 0), resolution - Vec2i(1, 1));
  const std::vector<LayerSpec> layers = {LayerSpec{.name = "direct"},
                                         LayerSpec{.name = "indirect"}};
  MemoryEstimate estimate;
  estimate.scene = scene_bytes(description);
  estimate.film = film_bytes(whole, ResolvedRender::kReplicates, layers);
  estimate.pictures = picture_bytes(whole, ResolvedRender::kReplicates, layers, {});
  return estimate;
}

std::string counts_text(const Json& counts) {
  std::string text;
  for (const auto& [name, count] : counts.items()) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count.get<std::size_t>(), name);
  }
  return text.empty() ? "none" : text;
}

std::string vector_text(const Json& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v[0].get<double>(), v[1].get<double>(),
                     v[2].get<double>());
}

/// Warnings counted by their effect on the picture.
Json effects_json(const Warnings& warnings) {
  Json json = Json::object();
  for (std::size_t i = 0; i < kEffects; ++i) {
    const auto effect = static_cast<Effect>(i);
    json[std::string(name_of(effect))] = warnings.count(effect);
  }
  return json;
}

/// "7: 2 of light, 5 of slight effect".
std::string warnings_text(const Warnings& warnings) {
  std::string by_effect;
  for (std::size_t i = 0; i < kEffects; ++i) {
    const auto effect = static_cast<Effect>(i);
    if (const std::size_t count = warnings.count(effect); count > 0) {
      by_effect +=
          fmt::format("{}{} of {}", by_effect.empty() ? ": " : ", ", count, name_of(effect));
    }
  }
  return std::to_string(warnings.count()) + by_effect;
}

std::string text_of(const Json& j, const MemoryEstimate& memory, const Warnings& warnings) {
  std::string lines;
  const auto line = [&lines](const char* label, const std::string& text) {
    lines += fmt::format("{:<12}{}\n", label, printable_line(text));
  };
  const Json& c = j["counts"];
  const Json& film = j["film"];
  const Json& hints = j["hints"];
  const auto megabytes = [](const Json& bytes) {
    return fmt::format("{:.1f} MB", 1e-6 * bytes.get<double>());
  };
  line("scene", j["scene"].get<std::string>());
  line("triangles",
       fmt::format("{} stored, {} with instances ({} instances)", c["triangles"].get<std::size_t>(),
                   c["instanced_triangles"].get<std::size_t>(), c["instances"].get<std::size_t>()));
  line("shapes", counts_text(j["shapes"]));
  line("lights", counts_text(j["lights"]));
  line("materials", counts_text(j["materials"]));
  line("textures", counts_text(j["textures"]));
  line("media", std::to_string(j["media"].size()));
  line("bounds", j["bounds"].is_null()
                     ? "none: there are no shapes"
                     : vector_text(j["bounds"]["min"]) + " to " + vector_text(j["bounds"]["max"]));
  line("camera", j["camera"]["type"].get<std::string>() + " at " +
                     vector_text(j["camera"]["position"]) + " towards " +
                     vector_text(j["camera"]["direction"]));
  line("film", fmt::format("{}x{}, {} filter", film["resolution"][0].get<int>(),
                           film["resolution"][1].get<int>(), film["filter"].get<std::string>()));
  line("asks for", fmt::format("integrator {}, depth {}, spp {}", hints["integrator"].dump(),
                               hints["max_depth"].dump(), hints["samples_per_pixel"].dump()));
  line("needs", memory_text(memory) + " to be rendered as it asks");
  line("memory",
       fmt::format("{} free before, {} in Embree, {} peak so far",
                   megabytes(j["memory"]["available_bytes"]),
                   megabytes(j["memory"]["embree_bytes"]), megabytes(j["memory"]["peak_bytes"])));
  line("loaded in", fmt::format("{:.2f} s, built in {:.2f} s", j["seconds"]["load"].get<double>(),
                                j["seconds"]["build"].get<double>()));
  line("warnings", warnings_text(warnings));
  return lines;
}

}  // namespace

int info(const InfoArguments& arguments) {
  Warnings warnings(Warnings::kAll);
  const Stopwatch load_clock;
  desc::SceneDesc description =
      load_scene(arguments.scene.scene, warnings, arguments.scene.spec.definitions);
  const double load_seconds = load_clock.seconds();
  Json json = describe(description, arguments.scene.scene);
  const MemoryEstimate memory = memory_of(description);
  const std::uint64_t available = available_memory_bytes();
  json["memory"] = {{"scene_bytes", memory.scene},
                    {"film_bytes", memory.film},
                    {"picture_bytes", memory.pictures},
                    {"needed_bytes", memory.total()},
                    {"available_bytes", available}};
  const Stopwatch build_clock;
  const Scene scene(std::move(description), BuildOptions{}, warnings);
  json["seconds"] = {{"load", load_seconds}, {"build", build_clock.seconds()}};
  add_built(scene, json);
  json["warnings"] = warnings.count();
  json["warnings_by_effect"] = effects_json(warnings);
  json["warning_messages"] = warnings.messages();
  if (arguments.json) {
    print_result(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  } else {
    print_all_warnings(warnings);
    print_result(text_of(json, memory, warnings));
  }
  return 0;
}

}  // namespace ajar::cli
