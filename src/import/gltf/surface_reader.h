#pragma once
#include "import/gltf/materials.h"

namespace ajar::gltf {

/// Reads one material.
class SurfaceReader {
 public:
  /// The base colour is multiplied with `colors`, or null.
  SurfaceReader(Context& context, Images& images, const Element& material,
                const VertexColors* colors)
      : context_(context), material_(material), colors_(colors), textures_(context, images) {}

  Surface read();

 private:
  // Each is a material of its own; the surface is a mix of them.
  desc::MaterialId read_base();
  desc::MaterialId metallic_roughness(const Element& pbr);
  desc::MaterialId specular_glossiness(const Element& pbr);
  desc::MaterialId unlit(const Element& pbr);
  desc::MaterialId with_transmission(desc::MaterialId opaque, const Element& transmission,
                                     const Element& pbr);
  desc::MaterialId with_opacity(desc::MaterialId visible);

  void set_clearcoat(desc::Node& node);
  /// Warns of extensions on a material that does not support them.
  void warn_of_layers();
  /// Warns of a volume on an opaque material.
  void warn_of_volume();
  void set_sheen(desc::Node& node);
  void set_diffuse_transmission(desc::Node& node);
  float index_of_refraction() const;
  /// Index whose reflectance at normal incidence is that of the material, with the colour of
  /// KHR_materials_specular, for a smooth `principled`.
  float index_for_specular();
  /// The factor of KHR_materials_specular: of all that is reflected, at any angle.
  desc::Value specular_strength();
  desc::MediumId read_medium(const Element& volume);
  void read_emission();
  /// Warns of a texture whose factor is 0 only because it is not given.
  void warn_of_unseen(const Element& holder, const char* factor, const char* texture);
  /// Normals for all materials from number `first_made` on.
  void read_normals(std::size_t first_made);

  /// The colour that the member `factor`, of four numbers, and the texture `texture` of `holder`
  /// say. Their alpha becomes that of the surface.
  desc::Value read_color(const Element& holder, const char* factor, const char* texture);
  /// The member `name`, clamped to [0, 1], with a warning if it was far beyond.
  float clamped_number(const Element& holder, std::string_view name, float fallback);
  /// Clamped `value`, which is that of the member.
  desc::Rgb clamped_color(const Element& holder, std::string_view name, const desc::Rgb& value);
  desc::Value mix_amount(const desc::Value& number) const;
  desc::MaterialId add(desc::Node node);
  desc::Node make(const Element& user, std::string_view model, desc::Node::Given given) const;

  Context& context_;
  const Element& material_;
  const VertexColors* colors_;
  Textures textures_;
  Surface surface_;
  /// Alpha of the base colour, for `alphaMode`.
  desc::Value alpha_ = 1.F;
};

}  // namespace ajar::gltf
