#include "import/gltf/extensions.h"

#include <algorithm>
#include <array>

#include "core/printable_text.h"

namespace ajar::gltf {
namespace {

constexpr WarningKind kUnread{Effect::Surface, "extensions of materials are not read"};
constexpr WarningKind kUnknownMaterial{Effect::Surface,
                                       "extensions of materials are not known and ignored"};
constexpr WarningKind kUnknownLight{Effect::Light,
                                    "extensions of lights are not known and ignored"};
constexpr WarningKind kUnknownExtension{Effect::Slight, "extensions are not known and ignored"};

constexpr std::array<std::string_view, 17> kRead = {"EXT_mesh_gpu_instancing",
                                                    "EXT_texture_webp",
                                                    "KHR_lights_punctual",
                                                    "KHR_materials_clearcoat",
                                                    "KHR_materials_diffuse_transmission",
                                                    "KHR_materials_emissive_strength",
                                                    "KHR_materials_ior",
                                                    "KHR_materials_pbrSpecularGlossiness",
                                                    "KHR_materials_sheen",
                                                    "KHR_materials_specular",
                                                    "KHR_materials_transmission",
                                                    "KHR_materials_unlit",
                                                    "KHR_materials_variants",
                                                    "KHR_materials_volume",
                                                    "KHR_mesh_quantization",
                                                    "KHR_node_visibility",
                                                    "KHR_texture_transform"};

/// Effect on the picture of unread extensions.
struct Unread {
  std::string_view name;
  std::string_view consequence;
  const WarningKind& kind;
};
constexpr std::array<Unread, 4> kUnreadExtensions = {
    {{"KHR_materials_anisotropy", "gloss is the same in all directions", kUnread},
     {"KHR_materials_dispersion", "glass has one index of refraction for all colours", kUnread},
     {"KHR_materials_iridescence", "thin films have no colours", kUnread},
     {"KHR_texture_basisu", "textures that have no other image are left out", kUnread}}};

/// Compressions without effect on the picture: files that do not require them have the same meshes
/// beside.
constexpr std::array<std::string_view, 3> kCompressions = {
    "KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"};
constexpr std::array<std::string_view, 2> kSilent = {"KHR_xmp_json_ld", "KHR_animation_pointer"};

template <typename Names>
bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

const Unread* find_unread(std::string_view name) {
  const auto found = std::find_if(kUnreadExtensions.begin(), kUnreadExtensions.end(),
                                  [&](const Unread& unread) { return unread.name == name; });
  return found == kUnreadExtensions.end() ? nullptr : &*found;
}

/// Kind of an unknown extension, by its name.
const WarningKind& kind_of_unknown(std::string_view name) {
  if (name.find("_materials_") != name.npos) return kUnknownMaterial;
  if (name.find("_lights_") != name.npos) return kUnknownLight;
  return kUnknownExtension;
}

void check_required(const Element& element) {
  const std::string name = element.text();
  if (contains(kCompressions, name)) {
    element.fail("the meshes of this file are compressed by " + name +
                 ", which cannot be read: export it without compression of meshes");
  }
  if (contains(kRead, name) || contains(kSilent, name) || find_unread(name) != nullptr) return;
  element.fail("the file cannot be read without an " +
               unknown_name_message("extension", printable_line(name),
                                    std::vector<std::string>(kRead.begin(), kRead.end())));
}

}  // namespace

void warn_of_extension(const std::string& name, const SourceLocation& where, Warnings& warnings) {
  if (contains(kRead, name) || contains(kSilent, name) || contains(kCompressions, name)) return;
  const std::string shown = printable_line(name);
  if (const Unread* unread = find_unread(name)) {
    warnings.add(unread->kind, where, shown + " is not read: " + std::string(unread->consequence),
                 shown);
  } else {
    warnings.add(kind_of_unknown(name), where, "the extension " + shown + " is not known: ignored",
                 shown);
  }
}

void check_extensions(const Element& root, Warnings& warnings) {
  for (const Element& element : root.items("extensionsRequired")) check_required(element);
  for (const Element& element : root.items("extensionsUsed")) {
    warn_of_extension(element.text(), element.where(), warnings);
  }
}

}  // namespace ajar::gltf
