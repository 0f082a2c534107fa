#include "import/pbrt/textures.h"

#include "import/common/printable.h"
#include "import/common/transforms.h"
#include "import/pbrt/lexer.h"
#include "import/pbrt/node_reader.h"
#include "import/pbrt/texture_names.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kNoFile{Effect::Surface, "image textures have no \"string filename\""};
constexpr WarningKind kOtherKind{
    Effect::Surface, "textures are used where those of another kind belong, and ignored"};

/// pbrt has one name for two models.
const ModelName* names_of(const SourceLocation& where, const std::string& type,
                          const ParameterList& parameters) {
  if (type != "checkerboard") return find_theirs(texture_names(), type);
  const int dimension = parameters.get_int("dimension", 2);
  if (dimension != 2 && dimension != 3) {
    throw SceneError(where,
                     "a checkerboard has dimension 2 or 3, not " + std::to_string(dimension));
  }
  parameters.accept({"aamode"});
  return find_ours(texture_names(), dimension == 2 ? "checkerboard" : "solid_checkerboard");
}

/// The place of a texture in the world, `ctm` being the current transform.
void set_place(desc::Node& node, const SourceLocation& where, const Mat4& ctm) {
  constexpr const char* kPlace = "world_to_texture";
  if (!node.has(kPlace)) return;
  // Of solid textures pbrt-v3 uses the transform itself, not its inverse.
  if (!node.has("mapping")) return node.set(kPlace, std::make_shared<const Mat4>(ctm));
  if (node.text("mapping") != "spherical" && node.text("mapping") != "cylindrical") return;
  const std::optional<Mat4> inverted = rounded_inverse(ctm);
  if (!inverted) {
    throw SceneError(where, "the current transform cannot be inverted, which this mapping needs");
  }
  node.set(kPlace, std::make_shared<const Mat4>(*inverted));
}

}  // namespace

desc::TextureId TextureTable::zero() {
  if (zero_ == desc::kNone) {
    zero_ = static_cast<desc::TextureId>(context_.scene.textures.size());
    context_.scene.textures.push_back(
        {"", {}, desc::texture_node("constant", {{"value", Vec3(0.F)}})});
  }
  return zero_;
}

void TextureTable::define(const SourceLocation& where, const std::string& name,
                          const std::string& texture_class, const std::string& type,
                          const ParameterList& parameters, const Mat4& ctm) {
  const bool is_float = texture_class == "float";
  if (!is_float && texture_class != "spectrum" && texture_class != "color") {
    fail_unknown(where, "texture class", texture_class, {"float", "spectrum", "color"});
  }
  const ModelName* names = names_of(where, type, parameters);
  const desc::Model* model = names == nullptr
                                 ? model_of_type(desc::ModelKind::Texture, texture_names(), type)
                                 : desc::find_model(desc::ModelKind::Texture, names->ours);
  if (model == nullptr) {
    fail_unknown(where, "texture", type, types_of(desc::ModelKind::Texture, texture_names()));
  }
  const TextureParameters lookup(context_, *this, parameters);
  desc::Node node = NodeReader(where, lookup).with_numbers_for_colors(is_float).read(*model, names);
  set_place(node, where, ctm);
  if (node.is("image")) {
    if (node.text("file").empty()) {
      context_.warnings.add(kNoFile, where, "this image texture has no \"string filename\"");
    }
    parameters.accept({"trilinear", "maxanisotropy", "filter"});
  }
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

std::optional<desc::Value> TextureParameters::find_spectrum(std::string_view name,
                                                            bool positive) const {
  for (const ParameterList* list : lists_) {
    if (list == nullptr) continue;
    if (const Parameter* p = list->find_one(name, ParameterKind::Texture)) {
      if (const std::optional<desc::TextureId> id = table_.find(*p, TextureClass::Spectrum))
        return desc::TextureRef{*id};
    } else if (const Parameter* colour = list->find_one(name, kSpectrumKinds)) {
      const std::optional<desc::Rgb> value =
          positive ? context_.spectra.positive_value(*colour) : context_.spectra.value(*colour);
      if (value) return *value;
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

std::optional<desc::Rgb> TextureParameters::color(std::string_view name, bool positive) const {
  return first_of([&](const ParameterList& list) -> std::optional<desc::Rgb> {
    const Parameter* colour = list.find_one(name, kSpectrumKinds);
    if (colour == nullptr) return std::nullopt;
    return positive ? context_.spectra.positive_value(*colour) : context_.spectra.value(*colour);
  });
}

std::optional<float> TextureParameters::number(std::string_view name) const {
  return first_of([&](const ParameterList& list) { return list.get_float(name); });
}

std::optional<int> TextureParameters::integer(std::string_view name) const {
  return first_of([&](const ParameterList& list) { return list.get_int(name); });
}

std::optional<Vec3> TextureParameters::vector(std::string_view name) const {
  return first_of([&](const ParameterList& list) { return list.get_vector(name); });
}

std::optional<Vec3> TextureParameters::point(std::string_view name) const {
  return first_of([&](const ParameterList& list) { return list.get_point(name); });
}

std::optional<bool> TextureParameters::flag(std::string_view name) const {
  return first_of([&](const ParameterList& list) { return list.get_bool(name); });
}

std::optional<std::string> TextureParameters::text(std::string_view name) const {
  return first_of([&](const ParameterList& list) { return list.get_string(name); });
}

void TextureParameters::accept(std::initializer_list<std::string_view> names) const {
  for (const ParameterList* list : lists_) {
    if (list != nullptr) list->accept(names);
  }
}

}  // namespace ajar::pbrt
