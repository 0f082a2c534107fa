#include "import/obj/surface_reader.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "core/error.h"
#include "core/printable_text.h"
#include "import/common/opacity.h"
#include "import/obj/material_text.h"
#include "scene/desc/models.h"

namespace ajar::obj {
namespace {

constexpr WarningKind kBump{Effect::Surface, "materials have bump maps: ignored"};
constexpr WarningKind kModel{Effect::Surface, "materials have an unknown \"illum\""};
constexpr WarningKind kGlassWords{Effect::Surface,
                                  "glass has colours, images or gloss of its own: ignored"};
constexpr WarningKind kOldGloss{Effect::Slight,
                                "materials have a gloss beside \"Pr\" or \"Pm\": ignored"};
constexpr WarningKind kFilter{Effect::Surface, "opaque materials have a filter: ignored"};
constexpr WarningKind kHidden{Effect::Surface,
                              "images have a factor of black, which would hide them: without it"};
constexpr WarningKind kNoColor{Effect::Surface, "materials have no colour: a light grey stands in"};
constexpr WarningKind kUnseen{Effect::Surface,
                              "materials are fully clear: nothing of them is seen"};
constexpr WarningKind kNoImage{Effect::Surface, "images cannot be found: left out"};

desc::Rgb reflectance_of(const tinyobj::real_t (&rgb)[3]) {
  desc::Rgb color;
  for (int lane = 0; lane < 3; ++lane) {
    color[lane] = std::isfinite(rgb[lane]) ? std::clamp(rgb[lane], 0.F, 1.F) : 0.F;
  }
  return color;
}

float share_of(float value) { return std::isfinite(value) ? std::clamp(value, 0.F, 1.F) : 0.F; }

/// Facets as wide as the lobe of Blinn's exponent `ns` (Walter et al. 2007, section 6).
float alpha_of(float ns) {
  return std::isfinite(ns) ? std::sqrt(2.F / (std::max(ns, 0.F) + 2.F)) : 0.F;
}

/// The words of those that are there, in quotes.
std::string listed(std::initializer_list<std::pair<const char*, bool>> words) {
  std::string text;
  for (const auto& [word, is_there] : words) {
    if (is_there) text += (text.empty() ? "\"" : ", \"") + std::string(word) + "\"";
  }
  return text;
}

/// The channel that `-imfchan` takes of an image that becomes a number.
std::string channel_of(const tinyobj::texture_option_t& options, const std::string& otherwise) {
  switch (options.imfchan) {
    case 'r':
      return "red";
    case 'g':
      return "green";
    case 'b':
      return "blue";
    case 'l':
      return "luminance";
    case 'a':
      return "alpha";
    default:
      return otherwise;
  }
}

bool is_srgb(const tinyobj::texture_option_t& options, bool otherwise) {
  if (options.colorspace == "linear") return false;
  return otherwise || options.colorspace == "sRGB" || options.colorspace == "srgb";
}

/// Values of `illum`.
constexpr int kNoGloss = 1;  // and below
constexpr int kMirror = 3;
constexpr int kGlass = 4;
constexpr int kRefraction = 6;
constexpr int kFresnelRefraction = 7;
constexpr int kGlassWithoutRays = 9;
constexpr int kLastModel = 10;

}  // namespace

Surface SurfaceReader::read() {
  Surface surface;
  if (values_.illum < 0 || values_.illum > kLastModel) {
    warnings_.add(kModel, where_,
                  "\"illum\" is from 0 to 10, not " + std::to_string(values_.illum) +
                      ": a material with gloss stands in",
                  printable_line(values_.name));
  }
  if (values_.unknown_parameter.contains(kHiddenImage)) {
    warnings_.add(kHidden, where_,
                  "\"Kd\" is black, which would hide the image of \"map_Kd\": it is shown as it is",
                  printable_line(values_.name));
  }
  if (values_.unknown_parameter.contains(kColorless)) {
    warnings_.add(kNoColor, where_, "this material has no colour: a light grey stands in",
                  printable_line(values_.name));
  }
  surface.material = add_material(is_glass() ? glass() : base());
  if (const auto normals =
          add_image(values_.normal_texname, values_.normal_texopt, "color", false, 1.F)) {
    scene_.materials.back().normal_map.texture = *normals;
    scene_.materials.back().normal_map.strength =
        std::isfinite(values_.normal_texopt.bump_multiplier) ? values_.normal_texopt.bump_multiplier
                                                             : 1.F;
  }
  warn_of_unused();
  if (!is_glass()) set_opacity(surface);
  set_emission(surface);
  surface.has_images = has_images_;
  if (!values_.bump_texname.empty()) {
    warnings_.add(kBump, where_, "bump maps, whose height has no unit, are ignored",
                  printable_line(values_.name));
  }
  return surface;
}

/// With rays that are refracted, or as glass that is not opaque: many programs write 4 for all.
bool SurfaceReader::is_glass() const {
  const bool is_refractive = values_.illum == kRefraction || values_.illum == kFresnelRefraction;
  const bool is_glass = values_.illum == kGlass || values_.illum == kGlassWithoutRays;
  return is_refractive || (is_glass && values_.dissolve < 1.F);
}

bool SurfaceReader::is_physically_based() const {
  return values_.roughness > 0.F || values_.metallic > 0.F || !values_.roughness_texname.empty() ||
         !values_.metallic_texname.empty();
}

void SurfaceReader::warn_of_unused() {
  constexpr float kUnset = 1.F;
  const desc::Rgb gloss = reflectance_of(values_.specular);
  const desc::Rgb diffuse = reflectance_of(values_.diffuse);
  const desc::Rgb filter = reflectance_of(values_.transmittance);
  const bool has_gloss_image = !values_.specular_texname.empty();
  const bool has_width = (gloss != Vec3(0.F) || has_gloss_image) && values_.shininess != kUnset;
  const std::string name = printable_line(values_.name);
  if (is_glass()) {
    const std::string words =
        listed({{"Kd", diffuse != Vec3(diffuse.x)},
                {"map_Kd", !values_.diffuse_texname.empty()},
                {"Ks", gloss != Vec3(0.F) && gloss != Vec3(1.F)},
                {"map_Ks", has_gloss_image},
                {"Ns", has_width},
                {"map_d", !values_.alpha_texname.empty()},
                {"Pr", values_.roughness > 0.F || !values_.roughness_texname.empty()},
                {"Pm", values_.metallic > 0.F || !values_.metallic_texname.empty()}});
    if (words.empty()) return;
    warnings_.add(kGlassWords, where_,
                  "glass is smooth and has the colour of \"Tf\", without " + words, name);
    return;
  }
  if (is_physically_based() && values_.illum > kNoGloss) {
    const std::string words =
        listed({{"Ks", gloss != Vec3(0.F)}, {"map_Ks", has_gloss_image}, {"Ns", has_width}});
    if (!words.empty()) {
      warnings_.add(kOldGloss, where_, "the gloss is that of \"Pr\" and \"Pm\", without " + words,
                    name);
    }
  }
  if (filter != Vec3(0.F) && filter != Vec3(1.F)) {
    warnings_.add(kFilter, where_,
                  "\"Tf\" is only supported in glass, of \"illum\" 6 and 7: ignored", name);
  }
}

desc::Node SurfaceReader::glass() const {
  constexpr float kUsual = 1.5F;
  constexpr float kLargest = 10.F;
  const bool has_index = values_.ior > 1.F && values_.ior <= kLargest;
  const desc::Rgb filter = reflectance_of(values_.transmittance);
  return desc::material_node("dielectric",
                             {{"eta", has_index ? values_.ior : kUsual},
                              {"transmittance", filter == Vec3(0.F) ? Vec3(1.F) : filter}});
}

desc::Node SurfaceReader::base() {
  const desc::Value diffuse =
      color(reflectance_of(values_.diffuse), values_.diffuse_texname, values_.diffuse_texopt);
  if (is_physically_based()) {
    return desc::material_node(
        "principled",
        {{"base_color", diffuse},
         {"blend", std::string("layered")},
         {"metallic", number(values_.metallic_texname.empty() ? share_of(values_.metallic) : 1.F,
                             values_.metallic_texname, values_.metallic_texopt, "color")},
         {"roughness", number(values_.roughness_texname.empty() ? share_of(values_.roughness) : 1.F,
                              values_.roughness_texname, values_.roughness_texopt, "color")}});
  }
  const desc::Rgb gloss = reflectance_of(values_.specular);
  const bool has_gloss = gloss != Vec3(0.F) || !values_.specular_texname.empty();
  if (values_.illum <= kNoGloss || !has_gloss) {
    return desc::material_node("diffuse", {{"reflectance", diffuse}});
  }
  const desc::Value specular = color(gloss, values_.specular_texname, values_.specular_texopt);
  if (values_.illum == kMirror && diffuse == desc::Value(Vec3(0.F))) {
    return desc::material_node("mirror", {{"reflectance", specular}});
  }
  return desc::material_node("coated_diffuse", {{"diffuse_reflectance", diffuse},
                                                {"glossy_reflectance", specular},
                                                {"roughness", alpha_of(values_.shininess)}});
}

void SurfaceReader::set_opacity(Surface& surface) {
  // The usual image of opacity is the alpha of that of the colour, or one of its own in gray.
  const bool is_shared = values_.alpha_texname == values_.diffuse_texname;
  const desc::Value opacity = number(share_of(values_.dissolve), values_.alpha_texname,
                                     values_.alpha_texopt, is_shared ? "alpha" : "color");
  if (opacity == desc::Value(1.F)) return;
  if (opacity == desc::Value(0.F)) {
    // Some programs write a "Tr" of 1 for opaque materials.
    warnings_.add(kUnseen, where_, "nothing of this material is seen, as \"d\" is 0 or \"Tr\" is 1",
                  printable_line(values_.name));
  }
  const PartlyClear partly =
      with_opacity(scene_, {.name = values_.name, .where = where_}, surface.material, opacity);
  surface.material = partly.material;
  surface.alpha = partly.alpha;
}

void SurfaceReader::set_emission(Surface& surface) {
  const auto& e = values_.emission;
  const Vec3 emission(e[0], e[1], e[2]);
  const bool has_image = !values_.emissive_texname.empty();
  if (!is_finite(emission) || (emission == Vec3(0.F) && !has_image)) return;
  const Vec3 scale(std::max(e[0], 0.F), std::max(e[1], 0.F), std::max(e[2], 0.F));
  surface.emission = desc::Emission{
      where_, desc::emission_node("area", {{"radiance", color(Vec3(1.F), values_.emissive_texname,
                                                              values_.emissive_texopt)},
                                           {"scale", scale == Vec3(0.F) ? Vec3(1.F) : scale}})};
}

desc::Value SurfaceReader::color(const desc::Rgb& factor, const std::string& image,
                                 const tinyobj::texture_option_t& options) {
  const std::optional<desc::TextureId> texture = add_image(image, options, "color", true, 1.F);
  if (!texture) return factor;
  if (factor == Vec3(1.F)) return desc::TextureRef{*texture};
  return desc::TextureRef{add_texture(
      desc::texture_node("product", {{"first", factor}, {"second", desc::TextureRef{*texture}}}))};
}

desc::Value SurfaceReader::number(float factor, const std::string& image,
                                  const tinyobj::texture_option_t& options, const char* channel) {
  const std::optional<desc::TextureId> texture =
      add_image(image, options, channel_of(options, channel), false, factor);
  return texture ? desc::Value(desc::TextureRef{*texture}) : desc::Value(factor);
}

std::optional<desc::TextureId> SurfaceReader::add_image(const std::string& image,
                                                        const tinyobj::texture_option_t& options,
                                                        const std::string& channel, bool is_coded,
                                                        float scale) {
  if (image.empty()) return std::nullopt;
  const bool is_stretched = options.brightness != 0.F || options.contrast != 1.F;
  try {
    const std::string path = files_.resolve_inside(image, where_);
    has_images_ = true;
    return add_texture(
        desc::texture_node("image", {{"file", path},
                                     {"channel", channel},
                                     {"decode_srgb", is_srgb(options, is_coded)},
                                     {"scale", scale * options.contrast},
                                     {"offset", scale * options.brightness},
                                     {"clamp", is_stretched},
                                     {"wrap", std::string(options.clamp ? "clamp" : "repeat")},
                                     {"scale_u", options.scale[0]},
                                     {"scale_v", options.scale[1]},
                                     {"offset_u", options.origin_offset[0]},
                                     {"offset_v", options.origin_offset[1]}}));
  } catch (const IoError& error) {
    warnings_.add(kNoImage, where_, std::string("this image is left out: ") + error.what(),
                  printable_line(image));
    return std::nullopt;
  }
}

desc::TextureId SurfaceReader::add_texture(desc::Node node) {
  scene_.textures.push_back({"", where_, std::move(node)});
  return static_cast<desc::TextureId>(scene_.textures.size()) - 1;
}

desc::MaterialId SurfaceReader::add_material(desc::Node node) {
  desc::Material& added = scene_.materials.emplace_back();
  added.name = values_.name;
  added.where = where_;
  added.node = std::move(node);
  return static_cast<desc::MaterialId>(scene_.materials.size()) - 1;
}

}  // namespace ajar::obj
