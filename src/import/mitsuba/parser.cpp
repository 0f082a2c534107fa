#include "import/mitsuba/parser.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/printable_text.h"
#include "import/mitsuba/attributes.h"
#include "import/mitsuba/names.h"
#include "import/mitsuba/numbers.h"
#include "import/mitsuba/property_reader.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kUnknownTag{Effect::Slight, "elements are unknown and ignored"};
constexpr WarningKind kNoVersion{Effect::None, "scenes do not say for which version they are"};
constexpr WarningKind kSameId{Effect::Surface, "ids are given twice: the later ones count"};

constexpr int kDeepestElements = 100;
constexpr int kMostFiles = 1000;

/// Elements that are plugins.
constexpr std::array<std::string_view, 14> kPluginTags = {
    "bsdf",    "emitter", "film",   "integrator", "medium",     "phase",   "rfilter",
    "sampler", "scene",   "sensor", "shape",      "subsurface", "texture", "volume"};

/// True if a number or a colour names a plugin: it is then the plugin's texture or constant.
bool is_typed_value(const pugi::xml_node& node) {
  return node.attribute("type") && is_value_tag(node.name());
}

/// Today's name of a tag that older versions called otherwise.
std::string plugin_tag(const pugi::xml_node& node) {
  const std::string tag = node.name();
  if (tag == "luminaire") return "emitter";
  if (tag == "camera") return "sensor";
  return is_typed_value(node) ? "texture" : tag;
}

bool is_plugin(const pugi::xml_node& node) {
  const std::string tag = plugin_tag(node);
  return std::find(kPluginTags.begin(), kPluginTags.end(), tag) != kPluginTags.end();
}

}  // namespace

Document Parser::parse(std::string_view text, const std::string& name, const std::string& path) {
  const XmlFile file(text, name);
  document_.end = file.end();
  const Source source{file, file.root()};
  if (source.node.name() != std::string_view("scene")) {
    throw SceneError(file.where(source.node), "this is not a Mitsuba scene: it begins with <" +
                                                  printable(source.node.name()) +
                                                  ">, not with <scene>");
  }
  read_version(file);
  check_attributes(file, warnings_);
  open_files_.push_back(path);
  document_.scene.tag = "scene";
  document_.scene.where = file.where(source.node);
  read_content(source, document_.scene, 0);
  definitions_.check_given(document_.scene.where);
  for (const Alias& alias : aliases_) {
    document_.resolve(Child{"", alias.where, nullptr, alias.id});  // raises if there is none
    document_.by_id.emplace(alias.name, document_.by_id.at(alias.id));
  }
  return std::move(document_);
}

void Parser::read_version(const XmlFile& file) {
  const std::string version = file.root().attribute("version").value();
  const std::optional<long long> major =
      parse_integer(std::string_view(version).substr(0, version.find('.')));
  if (major && *major >= 0 && *major <= 9) {
    document_.major_version = static_cast<int>(*major);
  } else {
    warnings_.add(kNoVersion, file.where(file.root()),
                  "the scene does not say for which version of Mitsuba it is: read as one of 3");
  }
}

void Parser::read_content(const Source& source, Element& parent, int depth) {
  if (depth > kDeepestElements) {
    throw SceneError(source.file.where(source.node), "elements are nested too deeply");
  }
  for (const pugi::xml_node& node : source.node.children()) {
    if (node.type() == pugi::node_element) read_one({source.file, node}, parent, depth);
  }
}

void Parser::read_one(const Source& source, Element& parent, int depth) {
  const std::string tag = source.node.name();
  const SourceLocation where = source.file.where(source.node);
  if (is_plugin(source.node)) {
    ElementPointer element = read_element(source, depth);
    parent.children.push_back({snake_case(attribute(source, "name")), where, element, ""});
  } else if (tag == "ref") {
    parent.children.push_back(
        {snake_case(attribute(source, "name")), where, nullptr, required(source, "id")});
  } else if (tag == "default") {
    define(source);
  } else if (tag == "include") {
    include(source, parent, depth);
  } else if (tag == "alias") {
    add_alias(source);
  } else if (tag == "path") {
    add_path(source);
  } else if (is_property_tag(tag)) {
    const bool is_emitted = document_.major_version >= 2 && parent.tag == "emitter";
    const Seen of_surfaces = document_.major_version < 3 ? Seen::AsLight : Seen::InDaylight;
    const PropertyReader reader(source.file, definitions_, files_, warnings_,
                                is_emitted ? Seen::Emitted : of_surfaces);
    if (std::optional<PropertyValue> value = reader.read(source.node)) {
      parent.properties.push_back({snake_case(required(source, "name")), where, std::move(*value)});
    }
  } else {
    warnings_.add(kUnknownTag, where,
                  "<" + printable(tag) + "> is not an element of Mitsuba scenes: ignored",
                  printable(tag));
  }
}

ElementPointer Parser::read_element(const Source& source, int depth) {
  auto element = std::make_shared<Element>();
  element->tag = plugin_tag(source.node);
  element->type = attribute(source, "type");
  element->id = attribute(source, "id");
  element->where = source.file.where(source.node);
  if (element->type.empty() && element->tag != "scene") {
    throw SceneError(element->where, "<" + element->tag + "> needs the attribute \"type\"");
  }
  read_content(source, *element, depth + 1);
  if (!element->id.empty()) add_id(element->id, element);
  return element;
}

void Parser::add_id(const std::string& id, ElementPointer element) {
  const auto [place, is_new] = document_.by_id.try_emplace(id, element);
  if (is_new) return;
  warnings_.add(kSameId, element->where,
                "the id \"" + printable(id) + "\" was given before, at " +
                    place->second->where.to_string() + ": this one counts",
                printable(id));
  place->second = std::move(element);
}

void Parser::include(const Source& source, Element& parent, int depth) {
  const SourceLocation where = source.file.where(source.node);
  const std::string name = files_.find(required(source, "filename"));
  const std::string path = files_.files().resolve(name, where);
  if (std::find(open_files_.begin(), open_files_.end(), path) != open_files_.end()) {
    throw SceneError(where, "\"" + printable(name) + "\" includes itself");
  }
  if (++files_read_ > kMostFiles) throw SceneError(where, "too many files are included");
  std::optional<FileBytes> bytes;
  try {
    bytes = files_.files().load_text(path);
  } catch (const IoError& error) {
    throw SceneError(where, std::string("cannot include this file: ") + error.what());
  }
  const XmlFile file(bytes->view(), name);
  check_attributes(file, warnings_);
  std::string portable = name;
  std::replace(portable.begin(), portable.end(), '\\', '/');
  files_.add(std::filesystem::path(portable).parent_path().string());
  open_files_.push_back(path);
  const Source root{file, file.root()};
  if (root.node.name() == std::string_view("scene")) {
    read_content(root, parent, depth + 1);
  } else {
    read_one(root, parent, depth + 1);
  }
  open_files_.pop_back();
}

void Parser::define(const Source& source) {
  definitions_.define(required(source, "name"), attribute(source, "value"));
}

void Parser::add_alias(const Source& source) {
  aliases_.push_back(
      {required(source, "as"), required(source, "id"), source.file.where(source.node)});
}

void Parser::add_path(const Source& source) { files_.add(required(source, "value")); }

std::string Parser::attribute(const Source& source, const char* name) {
  return definitions_.substitute(source.node.attribute(name).value(),
                                 source.file.where(source.node));
}

std::string Parser::required(const Source& source, const char* name) {
  std::string value = attribute(source, name);
  if (value.empty()) {
    throw SceneError(source.file.where(source.node), "<" + printable(source.node.name()) +
                                                         "> needs the attribute \"" + name + "\"");
  }
  return value;
}

}  // namespace ajar::mitsuba
