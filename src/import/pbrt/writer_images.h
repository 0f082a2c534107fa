#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "import/pbrt/sky_image.h"
#include "import/pbrt/writer_files.h"
#include "scene/desc/scene_desc.h"

namespace ajar::pbrt {

/// The images of a scene for pbrt-v3: it opens EXR, PNG, TGA and PFM files, takes the colours of
/// all of them, and decodes none in lights. Images that it would read differently are converted,
/// into the folder "<stem>_images" beside the scene: PNG where 8 bits hold it, else EXR. All
/// functions raise IoError for files that cannot be written (`WriterFiles`).
class ImageWriter {
 public:
  /// `path`: of the pbrt file, absolute.
  ImageWriter(const desc::SceneDesc& scene, std::filesystem::path path)
      : scene_(scene), path_(std::move(path)), files_(path_, "images") {}

  /// Path of an image, relative to the pbrt file where possible. One that is inside of another file
  /// is written.
  std::string name(const std::string& image);

  /// Absolute path of the image that is written for pbrt in place of a texture's; nothing if pbrt
  /// reads that equally, or it cannot be read.
  std::optional<std::string> for_texture(const desc::Node& texture);
  /// An image of 1 where that of a texture is at least `edge`, else 0; nothing if it cannot be
  /// read, or is not mapped by coordinates of the surface.
  std::optional<desc::Node> cut_out(const desc::Node& texture, float edge);
  /// Absolute path of an image of a clear sky, as the light of this model.
  std::string sky(const desc::Node& light);
  struct LightImage {
    std::optional<std::string> file;  ///< file for pbrt; nothing as for a texture
    std::optional<float> factor;      ///< factor of the light, where it is scaled to a given
                                      ///< strength
  };
  LightImage for_light(const desc::Node& light);
  /// Mean colour of an image texture; nothing if it cannot be read.
  std::optional<Vec3> mean(const desc::Node& texture);

  /// Images that could not be read, though pbrt would not see them as they are.
  const std::set<std::string>& unreadable() const { return unreadable_; }

 private:
  std::optional<LinearImage> read_finished(const desc::Node& texture);
  std::optional<LinearImage> read_linear(const desc::Node& node, const std::string& image);
  std::string write(const LinearImage& image, bool is_decoded, bool may_be_png) const;
  LightImage make_for_light(const desc::Node& light);

  const desc::SceneDesc& scene_;
  std::filesystem::path path_;
  WriterFiles files_;
  // Results so far, by all their inputs.
  std::map<std::string, std::optional<std::string>> textures_;
  std::map<std::string, LightImage> lights_;
  std::map<std::string, std::optional<Vec3>> means_;
  std::set<std::string> unreadable_;
};

}  // namespace ajar::pbrt
