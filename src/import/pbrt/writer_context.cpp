#include "import/pbrt/writer_context.h"

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/file_extension.h"

namespace ajar::pbrt {

WriterContext::WriterContext(const desc::SceneDesc& described, const std::string& out_path)
    : scene(described),
      path(std::filesystem::absolute(out_path).lexically_normal()),
      texture_uses(pbrt::texture_uses(scene)),
      texture_names(unique_names(scene.textures, "texture")),
      material_names(unique_names(scene.materials, "material")),
      medium_names(unique_names(scene.media, "medium")),
      object_names(unique_names(scene.objects, "object")) {}

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

std::string WriterContext::image_path(const std::string& image) const {
  const auto embedded = scene.embedded_files.find(image);
  if (embedded != scene.embedded_files.end()) {
    const auto number = std::distance(scene.embedded_files.begin(), embedded);
    const std::filesystem::path name =
        path.stem().string() + "_images/image_" + std::to_string(number) + file_extension(image);
    const std::filesystem::path folder = (path.parent_path() / name).parent_path();
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
      throw IoError("cannot make the folder \"" + folder.string() + "\": " + error.message());
    }
    write_file_atomically(path.parent_path() / name, *embedded->second);
    return name.generic_string();
  }
  const std::filesystem::path relative =
      std::filesystem::path(image).lexically_relative(path.parent_path());
  return relative.empty() ? image : relative.generic_string();
}

}  // namespace ajar::pbrt
