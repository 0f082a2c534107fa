#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "import/common/name_table.h"
#include "import/pbrt/text_writer.h"
#include "import/pbrt/writer_images.h"
#include "import/pbrt/writer_names.h"
#include "import/pbrt/writer_substitutes.h"
#include "scene/desc/scene_desc.h"

namespace ajar::pbrt {

/// State shared by all parts of the writer.
struct WriterContext {
  const desc::SceneDesc& scene;
  std::filesystem::path path;  ///< path of the pbrt file
  std::vector<TextureUse> texture_uses;
  std::vector<std::string> texture_names, material_names, medium_names, object_names;
  ImageWriter images;
  TextWriter out;
  /// Counts of our written words that pbrt does not know.
  std::map<std::string, int> unknown_parameters, unknown_models;

  WriterContext(const desc::SceneDesc& described, const std::string& out_path);

  /// `"texture name" "…"`, or nothing for none.
  void reference(std::string_view name, desc::TextureId id);
  /// Empty for none.
  std::string medium_name(desc::MediumId id) const;
  /// The interface of lights and the camera, which know only the outside.
  void medium_outside(desc::MediumId outside);
  /// Message on written words that pbrt-v3 does not know; empty if it knows all.
  std::string unknown_to_pbrt() const;
};

/// The parameters of a node by the names that pbrt has for them; without `names`, by ours.
/// `numbers_for_colors`: as a texture of numbers has them. `substitutes`: values for pbrt instead.
void write_parameters(WriterContext& context, const desc::Node& node, const ModelName* names,
                      bool numbers_for_colors = false, const Substitutes& substitutes = {});
/// All parameters of a node by words of ours alone, for a model that pbrt does not have.
void write_own_words(WriterContext& context, const desc::Node& node);
/// Every texture, as float, as spectrum, as both or not at all, as it is used.
void write_textures(WriterContext& context);
/// Every material, as a named one.
void write_materials(WriterContext& context);
/// Every light that is not on a surface.
void write_lights(WriterContext& context);

}  // namespace ajar::pbrt
