#pragma once
#include "import/obj/materials.h"

namespace ajar::obj {

/// Reads one material. Sources: Wavefront, Advanced Visualizer manual, appendix B1 (MTL); for `Pr`
/// and `Pm`, Exocortex' extension by physically based parameters.
class SurfaceReader {
 public:
  SurfaceReader(const Description& description, desc::SceneDesc& scene, FileAccess& files,
                Warnings& warnings)
      : values_(description.values),
        where_(description.where),
        scene_(scene),
        files_(files),
        warnings_(warnings) {}

  Surface read();

 private:
  desc::Node base();
  desc::Node glass() const;
  bool is_glass() const;
  bool is_physically_based() const;
  /// Warns of values of the material that its kind does not use.
  void warn_of_unused();
  void set_opacity(Surface& surface);
  void set_emission(Surface& surface);

  /// `factor` times an image, if there is one; the factor alone if it cannot be found.
  desc::Value color(const desc::Rgb& factor, const std::string& image,
                    const tinyobj::texture_option_t& options);
  desc::Value number(float factor, const std::string& image,
                     const tinyobj::texture_option_t& options, const char* channel);
  std::optional<desc::TextureId> add_image(const std::string& image,
                                           const tinyobj::texture_option_t& options,
                                           const std::string& channel, bool is_coded, float scale);
  desc::TextureId add_texture(desc::Node node);
  desc::MaterialId add_material(desc::Node node);

  const tinyobj::material_t& values_;
  const SourceLocation& where_;
  desc::SceneDesc& scene_;
  FileAccess& files_;
  Warnings& warnings_;
  bool has_images_ = false;
};

}  // namespace ajar::obj
