#include "import/pbrt/textures.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/printable_text.h"
#include "import/common/transforms.h"
#include "import/pbrt/lexer.h"
#include "import/pbrt/node_reader.h"
#include "import/pbrt/own_words.h"
#include "import/pbrt/texture_names.h"
#include "os/file_extension.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kNoFile{Effect::Surface, "image textures have no \"string filename\""};
constexpr WarningKind kUnknownTexture{Effect::Surface, "textures are unknown: grey stands in"};
constexpr WarningKind kUnsupported{Effect::Surface, "textures are not supported: others stand in"};
constexpr WarningKind kUnknownEncoding{Effect::Surface,
                                       "image textures have unknown encodings: sRGB stands in"};
constexpr WarningKind kNoDispersion{
    Effect::Slight, "indices of refraction depend on the wavelength, which is not supported"};
constexpr WarningKind kTextureNotMade{Effect::Surface,
                                      "textures are named that were not made: defaults stand in"};
constexpr WarningKind kOtherKind{
    Effect::Surface, "textures are used where those of another kind belong, and ignored"};

/// pbrt has one name for two models.
const ModelName* names_of(const Context& context, const SourceLocation& where,
                          const std::string& type, const ParameterList& parameters) {
  const std::vector<ModelName>& table = texture_names(context.choice.dialect);
  if (type != "checkerboard") return find_theirs(table, type);
  const int dimension = parameters.get_int("dimension", 2);
  if (dimension != 2 && dimension != 3) {
    throw SceneError(where,
                     "a checkerboard has dimension 2 or 3, not " + std::to_string(dimension));
  }
  parameters.accept({"aamode"});
  return find_ours(table, dimension == 2 ? "checkerboard" : "solid_checkerboard");
}

Mat4 inverse_place(const SourceLocation& where, const Mat4& ctm) {
  if (const std::optional<Mat4> inverted = rounded_inverse(ctm)) return *inverted;
  throw SceneError(where, "the current transform cannot be inverted, which this mapping needs");
}

/// pbrt-v4's planar mapping is in the texture's own space, ours in the world's: p M · axis = p · M
/// axis.
void move_plane(desc::Node& node, const SourceLocation& where, const Mat4& ctm) {
  const Mat4 m = inverse_place(where, ctm);
  for (const auto& [axis_name, offset_name] :
       {std::pair("axis_u", "offset_u"), std::pair("axis_v", "offset_v")}) {
    const Vec3d axis(node.vector(axis_name));
    const auto along = [&](int row) {
      return m[row][0] * axis.x + m[row][1] * axis.y + m[row][2] * axis.z;
    };
    node.set(axis_name, Vec3(Vec3d(along(0), along(1), along(2))));
    node.set(offset_name, node.number(offset_name) + static_cast<float>(along(3)));
  }
}

/// The place of a texture in the world, `ctm` being the current transform.
void set_place(const Context& context, desc::Node& node, const SourceLocation& where,
               const Mat4& ctm) {
  constexpr const char* kPlace = "world_to_texture";
  if (!node.has(kPlace)) return;
  if (!node.has("mapping")) {
    // Solid textures of pbrt-v3 use the transform itself, not its inverse.
    const Mat4 place = context.is_v4() ? inverse_place(where, ctm) : ctm;
    return node.set(kPlace, std::make_shared<const Mat4>(place));
  }
  const std::string& mapping = node.text("mapping");
  if (mapping == "planar" && context.is_v4()) return move_plane(node, where, ctm);
  if (mapping != "spherical" && mapping != "cylindrical") return;
  if (mapping == "cylindrical" && context.is_v4()) node.set("height", std::string("place"));
  node.set(kPlace, std::make_shared<const Mat4>(inverse_place(where, ctm)));
}

/// pbrt-v4's "encoding": "sRGB", "linear" or "gamma 2.2".
void set_encoding(const Context& context, const SourceLocation& where, desc::Node& image,
                  const std::string& encoding) {
  constexpr std::string_view kGamma = "gamma ";
  if (encoding == "sRGB") return;
  if (encoding == "linear") return image.set("decode_srgb", false);
  if (encoding.substr(0, kGamma.size()) == kGamma) {
    const std::string digits = encoding.substr(kGamma.size());
    float gamma = 0.F;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), gamma);
    if (error == std::errc() && end == digits.data() + digits.size() && gamma > 0.F &&
        std::isfinite(gamma)) {
      return image.set("decoding_exponent", gamma);
    }
  }
  context.warnings.add(
      kUnknownEncoding, where,
      unknown_name_message("encoding", printable(encoding),
                           std::vector<std::string>{"sRGB", "linear", "gamma 2.2"}) +
          ". sRGB stands in",
      printable(encoding));
}

bool may_exceed_one(const desc::Node& image) {
  const std::string extension = file_extension(image.text("file"));
  return image.number("scale") > 1.F || extension == ".exr" || extension == ".hdr" ||
         extension == ".pfm";
}

/// Adds pbrt-v4's options of images.
void finish_image(const Context& context, const SourceLocation& where,
                  const ParameterList& parameters, bool is_float, desc::Node& image) {
  if (is_float && image.text("channel") == "color") {
    // Uninterpolated images of pbrt have only their first channel.
    const std::string filter = parameters.get_string("filter", "bilinear");
    const bool is_first = filter == "point" || filter == "ewa";
    image.set("channel", is_first ? "red" : "varying_alpha_or_mean");
  }
  const std::string encoding = parameters.get_string("encoding", "sRGB");
  if (obeys_encoding(image.text("file"))) {
    set_encoding(context, where, image, encoding);
  } else if (is_float && image.text("channel") == "varying_alpha_or_mean") {
    image.set("channel", std::string("mean"));
  }
  // Reflected colours are clamped to 1.
  if (!is_float && may_exceed_one(image)) image.set("clamp", true);
  if (parameters.get_string("filter", "bilinear") == "point") {
    image.set("filter", std::string("nearest"));
  }
}

/// "scale" of pbrt-v4's scale texture: a number or a texture of numbers.
void finish_product(const TextureParameters& lookup, desc::Node& product) {
  const std::optional<desc::Value> scale = lookup.find_number("scale");
  if (!scale) return;
  const float* number = std::get_if<float>(&*scale);
  product.set("second", number == nullptr ? *scale : desc::Value(Vec3(*number)));
}

}  // namespace

bool obeys_encoding(const std::string& file) {
  const std::string extension = file_extension(file);
  return extension != ".jpg" && extension != ".jpeg" && extension != ".tga" &&
         extension != ".bmp" && extension != ".gif";
}

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
  const std::vector<ModelName>& table = texture_names(context_.choice.dialect);
  const desc::Model* model =
      own_model(context_, where, desc::ModelKind::Texture, parameters.get_string(kOwnModel));
  const ModelName* names = nullptr;
  if (model == nullptr) {
    names = names_of(context_, where, type, parameters);
    model = names == nullptr ? model_of_type(desc::ModelKind::Texture, table, type)
                             : desc::find_model(desc::ModelKind::Texture, names->ours);
  }
  const auto define_as = [&](desc::Node node) {
    ScopedNames<desc::TextureId>& names_of_class = is_float ? floats_ : spectra_;
    if (names_of_class.is_from_here(name)) warn_of_same_name(context_, where, "texture", name);
    names_of_class.set(name, static_cast<desc::TextureId>(context_.scene.textures.size()));
    context_.scene.textures.push_back({name, where, std::move(node)});
  };
  if (type == "ptex") {
    context_.warnings.add(kUnsupported, where, "ptex textures are not supported: grey stands in",
                          name);
    parameters.accept({"filename", "gamma", "encoding", "scale"});
    parameters.report_unused(context_.warnings);
    return define_as(desc::texture_node("constant", {{"value", Vec3(0.5F)}}));
  }
  if (context_.is_v4() && type == "directionmix") {
    context_.warnings.add(kUnsupported, where,
                          "textures that depend on the direction of the surface are not "
                          "supported: the mean of both stands in",
                          name);
    parameters.accept({"dir"});
  }
  if (model == nullptr) {
    report_unknown(context_, where, "texture", type, types_of(desc::ModelKind::Texture, table),
                   kUnknownTexture, "Grey stands in");
    return define_as(desc::texture_node("constant", {{"value", Vec3(0.5F)}}));
  }
  const TextureParameters lookup(context_, *this, parameters);
  desc::Node node = NodeReader(where, lookup).with_numbers_for_colors(is_float).read(*model, names);
  set_place(context_, node, where, ctm);
  if (node.is("image")) {
    if (node.text("file").empty()) {
      context_.warnings.add(kNoFile, where, "this image texture has no \"string filename\"");
    }
    if (context_.is_v4()) finish_image(context_, where, parameters, is_float, node);
    parameters.accept({"trilinear", "maxanisotropy", "filter"});
  } else if (node.is("product") && context_.is_v4()) {
    finish_product(lookup, node);
  }
  parameters.report_unused(context_.warnings);
  define_as(std::move(node));
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
  warn_of_unknown_name(context_, kTextureNotMade, reference.where,
                       is_float ? "float texture" : "spectrum texture", name,
                       (is_float ? floats_ : spectra_).names(), "The default stands in");
  return std::nullopt;
}

desc::TextureId TextureTable::add(const SourceLocation& where, desc::Node node) {
  context_.scene.textures.push_back({"", where, std::move(node)});
  return static_cast<desc::TextureId>(context_.scene.textures.size()) - 1;
}

void TextureTable::begin_scope() {
  if (context_.is_v4()) return;
  floats_.begin_scope();
  spectra_.begin_scope();
}

void TextureTable::end_scope() {
  if (context_.is_v4()) return;
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
      const std::optional<desc::Rgb> value = positive
                                                 ? context_.spectra.positive_value(*colour, role_)
                                                 : context_.spectra.value(*colour, role_);
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
    } else if (const std::optional<float> mean = mean_of_spectrum(*list, name)) {
      return *mean;
    }
  }
  return std::nullopt;
}

std::optional<float> TextureParameters::mean_of_spectrum(const ParameterList& list,
                                                         std::string_view name) const {
  if (!context_.is_v4()) return std::nullopt;
  const Parameter* spectrum = list.find_one(name, kSpectrumKinds);
  if (spectrum == nullptr) return std::nullopt;
  const std::optional<desc::Rgb> value = context_.spectra.value(*spectrum, role_);
  if (!value) return std::nullopt;
  if (value->x != value->y || value->y != value->z || !spectrum->strings.empty()) {
    context_.warnings.add(
        kNoDispersion, spectrum->where,
        "dispersion is not supported: one \"" + spectrum->name + "\" is used for all wavelengths",
        spectrum->name);
  }
  return (value->x + value->y + value->z) / 3.F;
}

std::optional<desc::Rgb> TextureParameters::color(std::string_view name, bool positive) const {
  return first_of([&](const ParameterList& list) -> std::optional<desc::Rgb> {
    const Parameter* colour = list.find_one(name, kSpectrumKinds);
    if (colour == nullptr) return std::nullopt;
    return positive ? context_.spectra.positive_value(*colour, role_)
                    : context_.spectra.value(*colour, role_);
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

std::vector<std::string> TextureParameters::texts(std::string_view name) const {
  for (const ParameterList* list : lists_) {
    if (list == nullptr) continue;
    if (std::vector<std::string> found = list->get_strings(name); !found.empty()) return found;
  }
  return {};
}

std::optional<std::string> TextureParameters::text(std::string_view name) const {
  return first_of([&](const ParameterList& list) { return list.get_string(name); });
}

bool TextureParameters::has_own_words() const {
  return std::any_of(std::begin(lists_), std::end(lists_), [](const ParameterList* list) {
    return list != nullptr && list->has_own_words();
  });
}

desc::Value TextureParameters::product(const SourceLocation& where, const desc::Value& a,
                                       const desc::Value& b) const {
  const Vec3* first = std::get_if<Vec3>(&a);
  const Vec3* second = std::get_if<Vec3>(&b);
  if (first != nullptr && second != nullptr) return *first * *second;
  return desc::TextureRef{
      table_.add(where, desc::texture_node("product", {{"first", a}, {"second", b}}))};
}

void TextureParameters::accept(std::initializer_list<std::string_view> names) const {
  for (const ParameterList* list : lists_) {
    if (list != nullptr) list->accept(names);
  }
}

}  // namespace ajar::pbrt
