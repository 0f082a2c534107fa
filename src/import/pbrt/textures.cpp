#include "import/pbrt/textures.h"

#include <algorithm>
#include <array>

#include "import/pbrt/lexer.h"
#include "import/pbrt/transforms.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kNoFile{Effect::Surface, "image textures have no \"string filename\""};
constexpr WarningKind kOtherKind{
    Effect::Surface, "textures are used where those of another kind belong, and ignored"};

const std::vector<std::string> kTypes = {"constant", "scale",    "mix",          "bilerp",
                                         "imagemap", "uv",       "checkerboard", "dots",
                                         "fbm",      "wrinkled", "windy",        "marble"};

/// Everything that one `Texture` directive says.
struct Source {
  Context& context;
  TextureTable& table;
  const SourceLocation& where;
  TextureClass texture_class;
  const ParameterList& parameters;
  const Mat4& ctm;

  desc::TextureId number(std::string_view name, float fallback) const {
    const auto value = TextureParameters(context, table, parameters).find_number(name);
    if (!value) return table.constant(fallback);
    if (const float* number = std::get_if<float>(&*value)) return table.constant(*number);
    return std::get<desc::TextureRef>(*value).id;
  }
  desc::TextureId child(std::string_view name, float fallback) const {
    if (texture_class == TextureClass::Float) return number(name, fallback);
    const auto value = TextureParameters(context, table, parameters).find_spectrum(name);
    if (!value) return table.constant(fallback);
    if (const Vec3* color = std::get_if<Vec3>(&*value)) return table.constant(*color);
    return std::get<desc::TextureRef>(*value).id;
  }
  desc::Rgb value(std::string_view name, float fallback) const {
    if (texture_class == TextureClass::Float)
      return desc::Rgb(parameters.get_float(name, fallback));
    return context.spectra.get(parameters, name, desc::Rgb(fallback));
  }
};

Mat4 world_to_texture(const Source& source) {
  if (const std::optional<Mat4> m = rounded_inverse(source.ctm)) return *m;
  throw SceneError(source.where,
                   "the current transform cannot be inverted, which this mapping needs");
}

desc::Mapping2D mapping_2d(const Source& source) {
  const ParameterList& p = source.parameters;
  const std::string type = p.get_string("mapping", "uv");
  if (type == "spherical") return desc::SphericalMapping{world_to_texture(source)};
  if (type == "cylindrical") return desc::CylindricalMapping{world_to_texture(source)};
  if (type == "planar") {
    return desc::PlanarMapping{p.get_vector("v1", {1.F, 0.F, 0.F}),
                               p.get_vector("v2", {0.F, 1.F, 0.F}), p.get_float("udelta", 0.F),
                               p.get_float("vdelta", 0.F)};
  }
  if (type != "uv") {
    fail_unknown(source.where, "texture mapping", type,
                 {"uv", "spherical", "cylindrical", "planar"});
  }
  return desc::UvMapping{p.get_float("uscale", 1.F), p.get_float("vscale", 1.F),
                         p.get_float("udelta", 0.F), p.get_float("vdelta", 0.F)};
}

desc::ImageTexture image(const Source& source) {
  const ParameterList& p = source.parameters;
  desc::ImageTexture node;
  node.mapping = mapping_2d(source);
  if (const std::optional<std::string> name = p.get_string("filename"); name && !name->empty()) {
    try {
      node.path = source.context.files.resolve(*name);
    } catch (const IoError& error) {
      throw SceneError(source.where, error.what());
    }
  } else {
    source.context.warnings.add(kNoFile, source.where,
                                "this image texture has no \"string filename\"");
  }
  const std::string wrap = p.get_string("wrap", "repeat");
  if (wrap == "black") {
    node.wrap = desc::Wrap::Black;
  } else if (wrap == "clamp") {
    node.wrap = desc::Wrap::Clamp;
  } else if (wrap != "repeat") {
    fail_unknown(source.where, "wrap mode", wrap, {"repeat", "black", "clamp"});
  }
  node.scale = p.get_float("scale", 1.F);
  // Images in float formats are linear whatever this says, as pbrt's default by extension has it.
  node.decode_srgb = p.get_bool("gamma", true);
  node.luminance = source.texture_class == TextureClass::Float;
  p.accept({"trilinear", "maxanisotropy", "filter"});
  return node;
}

desc::CheckerboardTexture checkerboard(const Source& source) {
  desc::CheckerboardTexture node;
  node.dimension = source.parameters.get_int("dimension", 2);
  if (node.dimension != 2 && node.dimension != 3) {
    throw SceneError(source.where,
                     "a checkerboard has dimension 2 or 3, not " + std::to_string(node.dimension));
  }
  node.a = source.child("tex1", 1.F);
  node.b = source.child("tex2", 0.F);
  // In 3D pbrt-v3 uses the transform itself, not its inverse, for this and all textures below.
  if (node.dimension == 2) {
    node.mapping = mapping_2d(source);
  } else {
    node.world_to_texture = source.ctm;
  }
  source.parameters.accept({"aamode"});
  return node;
}

int octaves(const Source& source) {
  constexpr int kMost = 64;
  const int n = source.parameters.get_int("octaves", 8);
  if (n < 0 || n > kMost) {
    throw SceneError(source.where, "\"octaves\" must be 0 to 64, not " + std::to_string(n));
  }
  return n;
}

decltype(desc::Texture::node) make_node(const Source& source, const std::string& type) {
  const ParameterList& p = source.parameters;
  if (type == "constant") return desc::ConstantTexture{source.value("value", 1.F)};
  if (type == "scale")
    return desc::ScaleTexture{source.child("tex1", 1.F), source.child("tex2", 1.F)};
  if (type == "mix") {
    return desc::MixTexture{source.child("tex1", 0.F), source.child("tex2", 1.F),
                            source.number("amount", 0.5F)};
  }
  if (type == "bilerp") {
    return desc::BilerpTexture{source.value("v00", 0.F), source.value("v01", 1.F),
                               source.value("v10", 0.F), source.value("v11", 1.F),
                               mapping_2d(source)};
  }
  if (type == "imagemap") return image(source);
  if (type == "checkerboard") return checkerboard(source);
  if (type == "dots") {
    return desc::DotsTexture{source.child("inside", 1.F), source.child("outside", 0.F),
                             mapping_2d(source)};
  }
  if (type == "uv") return desc::UvTexture{mapping_2d(source)};
  if (type == "fbm")
    return desc::FbmTexture{octaves(source), p.get_float("roughness", 0.5F), source.ctm};
  if (type == "wrinkled")
    return desc::WrinkledTexture{octaves(source), p.get_float("roughness", 0.5F), source.ctm};
  if (type == "windy") return desc::WindyTexture{source.ctm};
  if (type == "marble") {
    return desc::MarbleTexture{octaves(source), p.get_float("roughness", 0.5F),
                               p.get_float("scale", 1.F), p.get_float("variation", 0.2F),
                               source.ctm};
  }
  fail_unknown(source.where, "texture", type, kTypes);
}

}  // namespace

desc::TextureId TextureTable::constant(const desc::Rgb& value) {
  const auto [place, is_new] = constants_.try_emplace(
      {value.x, value.y, value.z}, static_cast<desc::TextureId>(context_.scene.textures.size()));
  if (is_new) context_.scene.textures.push_back({"", {}, desc::ConstantTexture{value}});
  return place->second;
}

void TextureTable::define(const SourceLocation& where, const std::string& name,
                          const std::string& texture_class, const std::string& type,
                          const ParameterList& parameters, const Mat4& ctm) {
  const bool is_float = texture_class == "float";
  if (!is_float && texture_class != "spectrum" && texture_class != "color") {
    fail_unknown(where, "texture class", texture_class, {"float", "spectrum", "color"});
  }
  const Source source{context_,   *this,
                      where,      is_float ? TextureClass::Float : TextureClass::Spectrum,
                      parameters, ctm};
  decltype(desc::Texture::node) node = make_node(source, type);
  parameters.report_unused(context_.warnings);
  (is_float ? floats_ : spectra_)
      .set(name, static_cast<desc::TextureId>(context_.scene.textures.size()));
  context_.scene.textures.push_back({name, where, std::move(node)});
}

std::optional<desc::TextureId> TextureTable::find(const Parameter& reference,
                                                  TextureClass texture_class) const {
  const bool is_float = texture_class == TextureClass::Float;
  const std::string& name = reference.strings.front();
  if (const desc::TextureId* id = (is_float ? floats_ : spectra_).find(name)) return *id;
  if ((is_float ? spectra_ : floats_).find(name) != nullptr) {
    context_.warnings.add(kOtherKind, reference.where,
                          "\"" + reference.name + "\" needs a " +
                              (is_float ? "float" : "spectrum") + " texture, but \"" +
                              printable(name) + "\" is one of the other kind: ignored",
                          printable(name));
    return std::nullopt;
  }
  throw SceneError(reference.where,
                   unknown_name_message(is_float ? "float texture" : "spectrum texture",
                                        printable(name), (is_float ? floats_ : spectra_).names()));
}

void TextureTable::begin_scope() {
  floats_.begin_scope();
  spectra_.begin_scope();
}

void TextureTable::end_scope() {
  floats_.end_scope();
  spectra_.end_scope();
}

std::optional<desc::Value> TextureParameters::find_spectrum(std::string_view name) const {
  for (const ParameterList* list : lists_) {
    if (list == nullptr) continue;
    if (const Parameter* p = list->find_one(name, ParameterKind::Texture)) {
      if (const std::optional<desc::TextureId> id = table_.find(*p, TextureClass::Spectrum))
        return desc::TextureRef{*id};
    } else if (const Parameter* colour = list->find_one(name, kSpectrumKinds)) {
      if (const std::optional<desc::Rgb> value = context_.spectra.value(*colour)) return *value;
    }
  }
  return std::nullopt;
}

std::optional<desc::Value> TextureParameters::find_number(std::string_view name) const {
  for (const ParameterList* list : lists_) {
    if (list == nullptr) continue;
    if (const Parameter* p = list->find_one(name, ParameterKind::Texture)) {
      if (const std::optional<desc::TextureId> id = table_.find(*p, TextureClass::Float))
        return desc::TextureRef{*id};
    } else if (const std::optional<float> value = list->get_float(name)) {
      return *value;
    }
  }
  return std::nullopt;
}

std::optional<bool> TextureParameters::flag(std::string_view name) const {
  for (const ParameterList* list : lists_) {
    if (list == nullptr) continue;
    if (const std::optional<bool> value = list->get_bool(name)) return value;
  }
  return std::nullopt;
}

std::optional<std::string> TextureParameters::text(std::string_view name) const {
  for (const ParameterList* list : lists_) {
    if (list == nullptr) continue;
    if (std::optional<std::string> value = list->get_string(name)) return value;
  }
  return std::nullopt;
}

void TextureParameters::accept(std::initializer_list<std::string_view> names) const {
  for (const ParameterList* list : lists_) {
    if (list != nullptr) list->accept(names);
  }
}

}  // namespace ajar::pbrt
