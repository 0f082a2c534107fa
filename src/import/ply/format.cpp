#include "import/format.h"

#include "core/printable_text.h"
#include "import/common/bare_mesh.h"
#include "import/mesh/ply.h"

namespace ajar::ply {
namespace {

constexpr WarningKind kSkipped{Effect::Slight, "elements and properties of PLY files are not read"};

constexpr WarningKind kNoImage{Effect::Surface, "images of PLY files are left out"};
constexpr WarningKind kMoreImages{Effect::Surface,
                                  "PLY files name several images: the first counts"};
constexpr WarningKind kColors{Effect::Surface,
                              "PLY files have an image and colours of vertices: the image counts"};

void warn_of_skipped(const std::vector<std::string>& names, const SceneFile& file,
                     Warnings& warnings) {
  const SourceLocation where{std::make_shared<const std::string>(file.name), 0, 0};
  std::string list;
  for (const std::string& name : names) {
    list += (list.empty() ? "\"" : ", \"") + printable(name) + "\"";
  }
  if (list.empty()) return;
  warnings.add(kSkipped, where, "not read of this file: " + list);
}

/// The image that the mesh has, if there is one that it can have; empty without.
std::string image_of(const PlyContents& contents, const SceneFile& file, Warnings& warnings,
                     FileAccess& files) {
  if (contents.images.empty()) return {};
  const PlyImage& image = contents.images.front();
  const SourceLocation where{std::make_shared<const std::string>(file.name), image.line, 0};
  const auto leave_out = [&](const std::string& reason) {
    warnings.add(kNoImage, where, "this image is left out: " + reason, printable(image.file));
    return std::string();
  };
  if (contents.images.size() > 1) {
    warnings.add(kMoreImages, where, "the mesh has more images than one: the first counts");
  }
  if (contents.mesh.uvs.empty()) return leave_out("the vertices have no texture coordinates");
  try {
    std::string path = files.resolve_inside(image.file, where);
    if (!files.exists(path)) return leave_out("there is no \"" + printable(image.file) + "\"");
    if (!contents.colors.empty()) {
      warnings.add(kColors, where, "the image counts: the colours of the vertices are not shown");
    }
    return path;
  } catch (const IoError& error) {
    return leave_out(error.what());
  }
}

desc::SceneDesc read_bytes(const SceneFile& file, Warnings& warnings, FileAccess& files) {
  PlyContents contents = read_ply_contents(file.bytes, file.name);
  warn_of_skipped(contents.skipped, file, warnings);
  const Paint paint{.colors = contents.colors, .image = image_of(contents, file, warnings, files)};
  return scene_of_mesh(std::move(contents.mesh), paint, file, warnings, UpAxis::Y);
}

desc::SceneDesc read(const std::string& path, Warnings& warnings, const FileProvider& provider) {
  return read_scene_file(path, warnings, provider, read_bytes);
}

}  // namespace

Format format() {
  return {.name = "ply",
          .summary = "a mesh in Stanford's format, shown in a studio",
          .extensions = {".ply"},
          .read = read};
}

}  // namespace ajar::ply
