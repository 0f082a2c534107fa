#include "apps/viewer/messages.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "core/error.h"
#include "import/code/scene_changes.h"
#include "integrator/integrator.h"
#include "integrator/regions/region_rules.h"
#include "session/options/limits.h"
#include "session/scenes/catalog.h"
#include "session/version.h"

namespace ajar::viewer {

namespace {

using nlohmann::json;

constexpr std::size_t kMostRules = 1000;
constexpr std::size_t kMostEdits = 10000;

const json& member(const json& message, const char* name) {
  const auto found = message.find(name);
  if (found == message.end()) throw UsageError(fmt::format("{} is missing", name));
  return *found;
}

std::string text_of(const json& message, const char* name) {
  const json& value = member(message, name);
  if (!value.is_string()) throw UsageError(fmt::format("{} is no text", name));
  return value.get<std::string>();
}

double number_of(const json& value, const char* name) {
  if (!value.is_number()) throw UsageError(fmt::format("{} is no number", name));
  const double number = value.get<double>();
  if (!std::isfinite(number)) throw UsageError(fmt::format("{} is no number", name));
  return number;
}

template <typename Number>
Number whole_number(const json& value, const char* name, const Limits<Number>& limits) {
  const double number = number_of(value, name);
  if (number != std::floor(number) || number < static_cast<double>(limits.least) ||
      number > static_cast<double>(limits.most)) {
    throw UsageError(fmt::format("{} must be a whole number {}", name, limits.text()));
  }
  return static_cast<Number>(number);
}

std::optional<double> positive_or_null(const json& message, const char* name) {
  const auto found = message.find(name);
  if (found == message.end() || found->is_null()) return std::nullopt;
  const double number = number_of(*found, name);
  if (number <= 0.0) throw UsageError(fmt::format("{} must be above 0", name));
  return number;
}

Vec3 vector_of(const json& message, const char* name) {
  const json& value = member(message, name);
  if (!value.is_array() || value.size() != 3) {
    throw UsageError(fmt::format("{} has not three numbers", name));
  }
  Vec3 vector;
  for (int i = 0; i < 3; ++i) {
    vector[i] = static_cast<float>(number_of(value[static_cast<std::size_t>(i)], name));
  }
  return vector;
}

json json_of(const Vec3& v) { return json::array({v.x, v.y, v.z}); }

template <typename Value>
json or_null(const std::optional<Value>& value) {
  return value ? json(*value) : json();
}

Rule rule_of(const json& value) {
  if (!value.is_object()) throw UsageError("a rule is no object");
  Rule rule{text_of(value, "kind"), text_of(value, "name"), {}};
  const json& choice = member(value, "choice");
  rule.choice = choice.is_number() ? fmt::format("{}", number_of(choice, "choice"))
                                   : text_of(value, "choice");
  if (rule.name.find_first_of("\"\n\r") != std::string::npos) {
    throw UsageError("a rule cannot name what has a quotation mark or a line break in its name");
  }
  return rule;
}

void set_regions(const json& message, LiveState& state) {
  const json& rules = member(message, "rules");
  if (!rules.is_array() || rules.size() > kMostRules) throw UsageError("rules is no list");
  std::vector<Rule> parsed;
  for (const json& rule : rules) parsed.push_back(rule_of(rule));
  try {
    parse_region_rules(rules_text(parsed), "regions");
  } catch (const SceneError& error) {
    throw UsageError(error.what());
  }
  state.rules = std::move(parsed);
}

void set_method(const json& message, LiveState& state) {
  std::map<std::string, std::string> parameters;
  const json& given = member(message, "parameters");
  if (!given.is_object()) throw UsageError("parameters is no object");
  for (const auto& [name, value] : given.items()) {
    if (!value.is_string()) throw UsageError(name + " is no text");
    // A file of this machine is nothing for a page to choose.
    if (name == "regions") throw UsageError("regions are set by clicks and rules");
    parameters[name] = value.get<std::string>();
  }
  const std::string integrator = text_of(message, "integrator");
  find_integrator(integrator).read(parameters);
  const auto importance = parameters.find("importance");
  if (importance != parameters.end() && importance->second != "uniform" &&
      importance->second != "relative") {
    throw UsageError("importance is uniform or relative here");
  }
  state.integrator = integrator;
  state.parameters = std::move(parameters);
}

void set_camera(const json& message, LiveState& state) {
  CameraPose pose{vector_of(message, "position"), vector_of(message, "target"),
                  vector_of(message, "up")};
  pose.fov = static_cast<float>(number_of(member(message, "fov"), "fov"));
  pose.lens_radius = static_cast<float>(number_of(member(message, "lens_radius"), "lens_radius"));
  pose.focal_distance =
      static_cast<float>(number_of(member(message, "focal_distance"), "focal_distance"));
  desc::Camera trial;
  trial.node = desc::PerspectiveCamera{};
  move_camera(trial, pose);
  state.camera = pose;
}

void set_crop(const json& message, LiveState& state) {
  const json& window = member(message, "window");
  if (window.is_null()) {
    state.crop.reset();
    return;
  }
  if (!window.is_array() || window.size() != 4) throw UsageError("window has not four numbers");
  std::array<int, 4> crop{};
  for (std::size_t i = 0; i < 4; ++i) {
    crop[i] = whole_number(window[i], "window", limits::kCropEdge);
  }
  if (crop[0] >= crop[2] || crop[1] >= crop[3]) throw UsageError("window is empty");
  state.crop = crop;
}

void set_edit(const json& message, LiveState& state) {
  const std::string kind = text_of(message, "kind");
  if (kind != "materials" && kind != "lights") throw UsageError("kind is materials or lights");
  const json& parameters = member(message, "parameters");
  if (!parameters.is_object()) throw UsageError("parameters is no object");
  for (const auto& [name, value] : parameters.items()) {
    // Objects may name files.
    if (value.is_object()) throw UsageError(name + " is no number");
  }
  const json which = whole_number(member(message, "index"), "index", Limits<int>{0, 1 << 24});
  if (state.edits.size() >= kMostEdits) throw UsageError("there are too many edits");
  state.edits.push_back(
      {{"kind", kind.substr(0, kind.size() - 1)}, {"which", which}, {"parameters", parameters}});
}

json layers_json(const Picture& picture) {
  json names = json::array();
  for (const Picture::Layer& layer : picture.layers) names.push_back(layer.name);
  return names;
}

json camera_json(const CameraPose& pose) {
  return {{"position", json_of(pose.position)},
          {"target", json_of(pose.target)},
          {"up", json_of(pose.up)},
          {"fov", pose.fov},
          {"lens_radius", pose.lens_radius},
          {"focal_distance", pose.focal_distance}};
}

json rules_json(const std::vector<Rule>& rules) {
  json list = json::array();
  for (const Rule& rule : rules) {
    list.push_back({{"kind", rule.kind}, {"name", rule.name}, {"choice", rule.choice}});
  }
  return list;
}

/// By the number in a layer of identities, from 1.
json named(float number, std::span<const std::string> names) {
  const auto index = static_cast<std::size_t>(std::max(0.F, number));
  if (index == 0 || index > names.size()) return {};
  return {{"number", index}, {"name", names[index - 1]}};
}

}  // namespace

nlohmann::json parse_message(std::string_view text) {
  // Deep nesting would take the parser's stack.
  int depth = 0;
  for (const char c : text) {
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (depth > 32) throw UsageError("a message is nested too deeply");
  }
  json message = json::parse(text, nullptr, false);
  if (!message.is_object()) throw UsageError("a message is no JSON object");
  text_of(message, "type");
  return message;
}

bool apply_message(const json& message, LiveState& state) {
  const std::string type = text_of(message, "type");
  if (type == "regions") {
    set_regions(message, state);
  } else if (type == "method") {
    set_method(message, state);
  } else if (type == "camera") {
    set_camera(message, state);
  } else if (type == "resolution") {
    state.resolution = {whole_number(member(message, "width"), "width", Limits<int>{1, 8192}),
                        whole_number(member(message, "height"), "height", Limits<int>{1, 8192})};
    state.crop.reset();
  } else if (type == "crop") {
    set_crop(message, state);
  } else if (type == "edit") {
    set_edit(message, state);
  } else {
    return false;
  }
  return true;
}

StopAt parse_stop_at(const json& message) {
  return {positive_or_null(message, "samples"), positive_or_null(message, "seconds"),
          positive_or_null(message, "error")};
}

DisplayOptions parse_display(const json& message) {
  DisplayOptions display;
  if (message.contains("exposure")) {
    const double stops = number_of(message["exposure"], "exposure");
    check_within(limits::kStops, static_cast<float>(stops), "exposure");
    display.exposure = static_cast<float>(stops);
  }
  if (message.contains("tone")) display.tone_map = tone_map_by_name(text_of(message, "tone"));
  return display;
}

std::shared_ptr<const Mask> parse_mask(std::string_view bytes) {
  constexpr std::size_t kHeader = 12;
  if (bytes.size() < kHeader || bytes.substr(0, 4) != "AJM1") throw UsageError("no mask");
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::memcpy(&width, bytes.data() + 4, 4);
  std::memcpy(&height, bytes.data() + 8, 4);
  if (bytes.size() - kHeader != std::uint64_t{width} * height || width > kMaxResolution ||
      height > kMaxResolution) {
    throw UsageError("a mask has not a byte per pixel");
  }
  if (bytes.size() == kHeader) return nullptr;
  const std::string_view weights = bytes.substr(kHeader);
  return std::make_shared<const Mask>(Mask{Vec2i(static_cast<int>(width), static_cast<int>(height)),
                                           {weights.begin(), weights.end()}});
}

json welcome_message(const std::string& scene, const desc::SceneDesc& description,
                     const BuiltScene& built) {
  json layers = json::array({{{"name", ""}, {"help", "the picture"}},
                             {{"name", kDenoisedLayer}, {"help", "the picture without noise"}}});
  for (const AovInfo& info : aovs()) {
    layers.push_back({{"name", info.name}, {"help", info.summary}});
  }
  json objects = json::array();
  json materials = json::array();
  for (const std::string& name : built.scene.object_names()) objects.push_back(name);
  for (const std::string& name : built.scene.material_names()) materials.push_back(name);
  return {{"type", "welcome"},
          {"scene", scene},
          {"version", version()},
          {"integrators", catalog_json("integrators")},
          {"layers", std::move(layers)},
          {"objects", std::move(objects)},
          {"materials", std::move(materials)},
          {"parts", json::parse(editable_parts(description), nullptr, false)}};
}

json welcome_message(const std::string& file, const Picture& picture) {
  json layers = json::array();
  for (const Picture::Layer& layer : picture.layers) {
    const AovInfo* info = find_aov(layer.name.substr(0, layer.name.find('.')));
    const std::string help = layer.name.empty() ? "the picture" : info ? info->summary : "";
    layers.push_back({{"name", layer.name}, {"help", help}});
  }
  return {{"type", "welcome"},           {"scene", file},
          {"version", version()},        {"integrators", json::array()},
          {"layers", std::move(layers)}, {"objects", json::array()},
          {"materials", json::array()},  {"parts", json::object()},
          {"metadata", picture.metadata}};
}

json state_message(const LiveStatus& status, const Picture* picture, bool can_be_denoised) {
  json layers = picture == nullptr ? json::array() : layers_json(*picture);
  if (can_be_denoised && !layers.empty()) layers.insert(layers.begin() + 1, kDenoisedLayer);
  const LiveState& state = status.state;
  const Box2i& crop = status.crop;
  return {{"type", "state"},
          {"phase", to_string(status.phase)},
          {"message", status.message},
          {"epoch", status.epoch},
          {"width", status.resolution.x},
          {"height", status.resolution.y},
          {"crop", json::array({crop.min.x, crop.min.y, crop.max.x + 1, crop.max.y + 1})},
          {"samples", status.samples},
          {"seconds", status.seconds},
          {"rays_per_second", or_null(status.rays_per_second)},
          {"mutations_per_second", or_null(status.mutations_per_second)},
          {"error", or_null(status.error)},
          {"error_is_lower_bound", status.error_is_lower_bound},
          {"done", or_null(status.done)},
          {"layers", std::move(layers)},
          {"integrator", state.integrator},
          {"parameters", state.parameters},
          {"rules", rules_json(state.rules)},
          {"masked", state.mask != nullptr},
          {"camera", camera_json(status.camera)},
          {"stop_at",
           {{"samples", or_null(status.stop_at.samples)},
            {"seconds", or_null(status.stop_at.seconds)},
            {"error", or_null(status.stop_at.error)}}},
          {"can_undo", status.can_undo},
          {"can_redo", status.can_redo},
          {"chain_share", nullptr},
          {"acceptance", json::array()}};
}

json history_message(const LiveStatus& status) {
  return {{"type", "history"}, {"points", status.history}};
}

json pixel_message(const json& message, const Picture& picture, const BuiltScene* built) {
  const Limits<int> range{0, kMaxResolution};
  const Vec2i pixel(whole_number(member(message, "x"), "x", range),
                    whole_number(member(message, "y"), "y", range));
  if (!picture.crop.intersects(pixel)) throw UsageError("that pixel is not in the picture");
  const Vec2i size = picture.crop.size() + Vec2i(1, 1);
  const Vec2i place = pixel - picture.crop.min;
  const auto index = static_cast<std::size_t>(place.y) * static_cast<std::size_t>(size.x) +
                     static_cast<std::size_t>(place.x);
  json values = json::object();
  for (const Picture::Layer& layer : picture.layers) {
    json& list = values[layer.name] = json::array();
    for (int c = 0; c < layer.channels; ++c) {
      list.push_back(layer.pixels[index * static_cast<std::size_t>(layer.channels) +
                                  static_cast<std::size_t>(c)]);
    }
  }
  const auto first = [&](const char* layer) {
    const auto found = values.find(layer);
    return found == values.end() ? 0.F : (*found)[0].get<float>();
  };
  json answer = {{"type", "pixel"},    {"x", pixel.x},        {"y", pixel.y},
                 {"object", nullptr},  {"material", nullptr}, {"region", nullptr},
                 {"samples", nullptr}, {"error", nullptr}};
  if (built != nullptr) {
    answer["object"] = named(first("object-id"), built->scene.object_names());
    answer["material"] = named(first("material-id"), built->scene.material_names());
  }
  if (values.contains("regions")) answer["region"] = first("regions");
  if (values.contains("samples")) answer["samples"] = first("samples");
  if (values.contains("standard-error")) {
    double error = 0.0;
    double light = 0.0;
    for (const json& value : values["standard-error"]) error += value.get<double>();
    for (const json& value : values[""]) light += value.get<double>();
    if (light > 0.0) answer["error"] = error / light;
  }
  answer["values"] = std::move(values);
  return answer;
}

json note_message(bool is_warning, const std::string& text) {
  return {{"type", "note"}, {"level", is_warning ? "warning" : "note"}, {"text", text}};
}

}  // namespace ajar::viewer
