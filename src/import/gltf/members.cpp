#include "import/gltf/members.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/printable_text.h"
#include "import/gltf/extensions.h"

namespace ajar::gltf {
namespace {

constexpr WarningKind kUnknownMember{Effect::Slight, "members are unknown and ignored"};

constexpr WarningKind kMisplaced{Effect::Slight,
                                 "extensions stand where they mean nothing: ignored"};

/// A member: an object, or an array, of objects of a kind; without a kind nothing that has members,
/// or an unread one.
struct Member {
  std::string name;
  std::string_view kind = {};
};
using Kinds = std::map<std::string_view, std::vector<Member>>;

/// Source: the JSON schemas of glTF 2.0 and of the extensions.
const Kinds& kinds() {
  static const Kinds kKinds = {
      {"a file",
       {{"accessors", "an accessor"},
        {"animations", "an animation"},
        {"asset", "an asset"},
        {"buffers", "a buffer"},
        {"bufferViews", "a view of a buffer"},
        {"cameras", "a camera"},
        {"extensionsRequired"},
        {"extensionsUsed"},
        {"images", "an image"},
        {"materials", "a material"},
        {"meshes", "a mesh"},
        {"nodes", "a node"},
        {"samplers", "a sampler"},
        {"scene"},
        {"scenes", "a scene"},
        {"skins", "a skin"},
        {"textures", "a texture"}}},
      {"an asset", {{"copyright"}, {"generator"}, {"version"}, {"minVersion"}}},
      {"an accessor",
       {{"bufferView"},
        {"byteOffset"},
        {"componentType"},
        {"normalized"},
        {"count"},
        {"type"},
        {"max"},
        {"min"},
        {"sparse", "sparse values"},
        {"name"}}},
      {"sparse values", {{"count"}, {"indices", "a part"}, {"values", "a part"}}},
      {"an animation", {{"channels", "a channel"}, {"samplers", "its samples"}, {"name"}}},
      {"a channel", {{"sampler"}, {"target", "a channel's target"}}},
      {"a channel's target", {{"node"}, {"path"}}},
      {"its samples", {{"input"}, {"interpolation"}, {"output"}}},
      {"a skin", {{"inverseBindMatrices"}, {"skeleton"}, {"joints"}, {"name"}}},
      {"a part", {{"bufferView"}, {"byteOffset"}, {"componentType"}}},
      {"a buffer", {{"uri"}, {"byteLength"}, {"name"}}},
      {"a view of a buffer",
       {{"buffer"}, {"byteOffset"}, {"byteLength"}, {"byteStride"}, {"target"}, {"name"}}},
      {"a camera",
       {{"type"}, {"orthographic", "a projection"}, {"perspective", "a projection"}, {"name"}}},
      {"a projection", {{"aspectRatio"}, {"yfov"}, {"xmag"}, {"ymag"}, {"zfar"}, {"znear"}}},
      {"an image", {{"uri"}, {"mimeType"}, {"bufferView"}, {"name"}}},
      {"a material",
       {{"name"},
        {"pbrMetallicRoughness", "pbrMetallicRoughness"},
        {"normalTexture", "a normal map"},
        {"occlusionTexture", "an occlusion map"},
        {"emissiveTexture", "a use of a texture"},
        {"emissiveFactor"},
        {"alphaMode"},
        {"alphaCutoff"},
        {"doubleSided"}}},
      {"pbrMetallicRoughness",
       {{"baseColorFactor"},
        {"baseColorTexture", "a use of a texture"},
        {"metallicFactor"},
        {"roughnessFactor"},
        {"metallicRoughnessTexture", "a use of a texture"}}},
      {"a use of a texture", {{"index"}, {"texCoord"}}},
      {"a normal map", {{"index"}, {"texCoord"}, {"scale"}}},
      {"an occlusion map", {{"index"}, {"texCoord"}, {"strength"}}},
      {"a mesh", {{"primitives", "a primitive"}, {"weights"}, {"name"}}},
      {"a primitive",
       {{"attributes", "attributes"},
        {"indices"},
        {"material"},
        {"mode"},
        {"targets", "attributes"}}},
      {"attributes", {{"POSITION"}, {"NORMAL"}, {"TANGENT"}}},
      {"attributes of instances", {{"TRANSLATION"}, {"ROTATION"}, {"SCALE"}}},
      {"a node",
       {{"camera"},
        {"children"},
        {"skin"},
        {"matrix"},
        {"mesh"},
        {"rotation"},
        {"scale"},
        {"translation"},
        {"weights"},
        {"name"}}},
      {"a sampler", {{"magFilter"}, {"minFilter"}, {"wrapS"}, {"wrapT"}, {"name"}}},
      {"a scene", {{"nodes"}, {"name"}}},
      {"a texture", {{"sampler"}, {"source"}, {"name"}}},
      {"a light",
       {{"name"}, {"color"}, {"intensity"}, {"type"}, {"range"}, {"spot", "cone angles"}}},
      {"cone angles", {{"innerConeAngle"}, {"outerConeAngle"}}}};
  return kKinds;
}

/// Kinds of the extensions that are read and have members that are.
const Kinds& extension_kinds() {
  static const Kinds kKinds = {
      {"EXT_mesh_gpu_instancing", {{"attributes", "attributes of instances"}}},
      {"EXT_texture_webp", {{"source"}}},
      {"KHR_lights_punctual", {{"lights", "a light"}, {"light"}}},
      {"KHR_materials_clearcoat",
       {{"clearcoatFactor"},
        {"clearcoatTexture", "a use of a texture"},
        {"clearcoatRoughnessFactor"},
        {"clearcoatRoughnessTexture", "a use of a texture"},
        {"clearcoatNormalTexture", "a normal map"}}},
      {"KHR_materials_diffuse_transmission",
       {{"diffuseTransmissionFactor"},
        {"diffuseTransmissionTexture", "a use of a texture"},
        {"diffuseTransmissionColorFactor"},
        {"diffuseTransmissionColorTexture", "a use of a texture"}}},
      {"KHR_materials_emissive_strength", {{"emissiveStrength"}}},
      {"KHR_materials_ior", {{"ior"}}},
      {"KHR_materials_pbrSpecularGlossiness",
       {{"diffuseFactor"},
        {"diffuseTexture", "a use of a texture"},
        {"specularFactor"},
        {"glossinessFactor"},
        {"specularGlossinessTexture", "a use of a texture"}}},
      {"KHR_materials_sheen",
       {{"sheenColorFactor"},
        {"sheenColorTexture", "a use of a texture"},
        {"sheenRoughnessFactor"},
        {"sheenRoughnessTexture", "a use of a texture"}}},
      {"KHR_materials_specular",
       {{"specularFactor"},
        {"specularTexture", "a use of a texture"},
        {"specularColorFactor"},
        {"specularColorTexture", "a use of a texture"}}},
      {"KHR_materials_transmission",
       {{"transmissionFactor"}, {"transmissionTexture", "a use of a texture"}}},
      {"KHR_materials_unlit", {}},
      {"KHR_materials_volume",
       {{"thicknessFactor"},
        {"thicknessTexture", "a use of a texture"},
        {"attenuationDistance"},
        {"attenuationColor"}}},
      {"KHR_node_visibility", {{"visible"}}},
      {"KHR_texture_transform", {{"offset"}, {"rotation"}, {"scale"}, {"texCoord"}}}};
  return kKinds;
}

/// The kinds of objects that an extension with members may stand in.
bool may_stand_in(std::string_view extension, std::string_view kind) {
  using Places = std::vector<std::string_view>;
  static const std::map<std::string_view, Places> kPlaces = {
      {"EXT_mesh_gpu_instancing", {"a node"}},
      {"EXT_texture_webp", {"a texture"}},
      {"KHR_lights_punctual", {"a file", "a node"}},
      {"KHR_node_visibility", {"a node"}},
      {"KHR_texture_transform", {"a use of a texture", "a normal map", "an occlusion map"}}};
  if (extension.starts_with("KHR_materials_")) return kind == "a material";
  const Places& places = kPlaces.at(extension);
  return std::find(places.begin(), places.end(), kind) != places.end();
}

/// Attributes that may come in several sets, and those of an application.
bool is_numbered_attribute(std::string_view name) {
  constexpr std::string_view kSets[] = {"_", "TEXCOORD_", "COLOR_", "JOINTS_", "WEIGHTS_"};
  return std::any_of(std::begin(kSets), std::end(kSets),
                     [&](std::string_view set) { return name.starts_with(set); });
}

class MemberCheck {
 public:
  MemberCheck(const Element& root, Warnings& warnings) : warnings_(warnings) {
    for (const Element& name : root.items("extensionsUsed")) told_.insert(name.text());
  }

  void check(const Element& object, std::string_view kind, const std::vector<Member>& members) {
    if (!object.is(Element::Kind::Object)) return;
    for (const auto& [name, key, value] : object.members()) {
      if (name == "extras") continue;
      if (name == "extensions") {
        check_extensions(value, kind);
        continue;
      }
      const auto known =
          std::find_if(members.begin(), members.end(),
                       [&name = name](const Member& member) { return member.name == name; });
      if (known != members.end()) {
        if (!known->kind.empty()) check_all(value, known->kind);
      } else if (!kind.starts_with("attributes") || !is_numbered_attribute(name)) {
        warn(key, kind, name, members);
      }
    }
  }

 private:
  void check_all(const Element& value, std::string_view kind) {
    const std::vector<Member>& members = kinds().at(kind);
    if (!value.is(Element::Kind::Array)) return check(value, kind, members);
    for (const Element& element : value.items()) check(element, kind, members);
  }

  void check_extensions(const Element& extensions, std::string_view kind) {
    if (!extensions.is(Element::Kind::Object)) return;
    for (const auto& [name, key, extension] : extensions.members()) {
      const auto read = extension_kinds().find(name);
      if (read != extension_kinds().end() && !may_stand_in(name, kind)) {
        warnings_.add(kMisplaced, extension.where(),
                      name + " means nothing on " + std::string(kind) + ": ignored", name);
      } else if (read != extension_kinds().end()) {
        check(extension, read->first, read->second);
      } else if (told_.insert(name).second) {
        warn_of_extension(name, extension.where(), warnings_);
      }
    }
  }

  void warn(const Element& key, std::string_view kind, const std::string& name,
            const std::vector<Member>& members) {
    std::vector<std::string> valid;
    for (const Member& member : members) valid.push_back(member.name);
    const std::string shown = printable_line(name);
    const std::string nearest = nearest_name(name, valid);
    warnings_.add(kUnknownMember, key.where(),
                  std::string(kind) + " has no member \"" + shown + "\"" +
                      (nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?") + ": ignored",
                  shown);
  }

  Warnings& warnings_;
  std::set<std::string> told_;  ///< extensions that there is a warning of, if need be
};

}  // namespace

void check_members(const Element& root, Warnings& warnings) {
  MemberCheck(root, warnings).check(root, "a file", kinds().at("a file"));
}

}  // namespace ajar::gltf
