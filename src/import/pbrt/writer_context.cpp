#include "import/pbrt/writer_context.h"

#include "core/printable_text.h"

namespace ajar::pbrt {

WriterContext::WriterContext(const desc::SceneDesc& described, const std::string& out_path)
    : scene(described),
      path(std::filesystem::absolute(out_path).lexically_normal()),
      texture_uses(pbrt::texture_uses(scene)),
      texture_names(unique_names(scene.textures, "texture")),
      material_names(unique_names(scene.materials, "material")),
      medium_names(unique_names(scene.media, "medium")),
      object_names(unique_names(scene.objects, "object")),
      images(scene, path) {}

void WriterContext::reference(std::string_view name, desc::TextureId id) {
  if (id >= 0)
    out.parameter("texture " + std::string(name), texture_names.at(static_cast<std::size_t>(id)));
}

std::string WriterContext::medium_name(desc::MediumId id) const {
  return id < 0 ? std::string() : medium_names.at(static_cast<std::size_t>(id));
}

void WriterContext::medium_outside(desc::MediumId outside) {
  if (!scene.media.empty()) out.line("MediumInterface").quoted("").quoted(medium_name(outside));
}

namespace {

/// "channel (12 times), thin".
std::string list_of(const std::map<std::string, int>& counts) {
  std::string text;
  for (const auto& [name, count] : counts) {
    text += (text.empty() ? "" : ", ") + name;
    if (count > 1) text += " (" + std::to_string(count) + " times)";
  }
  return text;
}

}  // namespace

std::string WriterContext::unknown_to_pbrt() const {
  std::string text;
  if (!unknown_models.empty()) text = "models: " + list_of(unknown_models);
  if (!unknown_parameters.empty()) {
    text += (text.empty() ? "" : "; ") + ("parameters: " + list_of(unknown_parameters));
  }
  if (!text.empty()) text = "pbrt-v3 does not know, and shows otherwise, these " + text;
  const std::set<std::string>& unreadable = images.unreadable();
  if (!unreadable.empty()) {
    text +=
        (text.empty() ? "" : "; ") +
        ("images that cannot be read, and are named as they are: " +
         std::to_string(unreadable.size()) + ", the first " + printable_line(*unreadable.begin()));
  }
  return text;
}

}  // namespace ajar::pbrt
