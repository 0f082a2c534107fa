#include "import/tungsten/textures.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>
#include <vector>

#include "scene/desc/models.h"

namespace ajar::tungsten {
namespace {

constexpr WarningKind kStandIn{Effect::Surface,
                               "textures are not supported: constant ones stand in"};
constexpr WarningKind kUnknownTexture{Effect::Surface, "textures are unknown: grey stands in"};
constexpr WarningKind kNoImageFile{Effect::Surface, "textures name no file: grey stands in"};
constexpr WarningKind kNegative{Effect::Surface, "colours are negative: 0 stands in"};

using Kind = LocatedJson::Kind;

/// Members that Tungsten reads of each type of texture, to tell mistakes from them.
struct TextureType {
  std::string_view name;
  std::vector<std::string_view> members;
  /// Has no model of ours: this member stands in, as a constant; without one 1.
  std::string_view stand_in = {};
};
const std::vector<TextureType> kTextureTypes = {
    {"constant", {"value"}},
    {"bitmap", {"file", "path", "gamma_correct", "interpolate", "clamp", "scale"}},
    {"checker", {"on_color", "off_color", "res_u", "res_v"}},
    {"disk", {"value"}, "value"},
    {"blade", {"value", "blades", "angle"}, "value"},
    {"ies", {"file", "resolution", "scale"}, "scale"},
    {"wireframe", {"fill_color", "line_color", "line_width"}, "fill_color"}};

const TextureType* texture_type(std::string_view name) {
  const auto found = std::find_if(kTextureTypes.begin(), kTextureTypes.end(),
                                  [&](const TextureType& type) { return type.name == name; });
  return found == kTextureTypes.end() ? nullptr : &*found;
}

std::vector<std::string> names_of_texture_types() {
  std::vector<std::string> names;
  names.reserve(kTextureTypes.size());
  for (const TextureType& type : kTextureTypes) names.emplace_back(type.name);
  return names;
}

const Vec3 kGrey(0.5F);

bool is_bitmap(const LocatedJson& json) { return json.is(Kind::Text) || type_of(json) == "bitmap"; }

/// Tungsten's readers of these formats make an alpha of 1 where a file has none.
bool always_has_alpha(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

}  // namespace

Vec3 constant_or(const desc::Value& color, const Vec3& mean_of_textures) {
  const Vec3* constant = std::get_if<Vec3>(&color);
  return constant != nullptr ? *constant : mean_of_textures;
}

Vec3 not_negative(const Context& context, const SourceLocation& where, const Vec3& color) {
  const Vec3 result(std::max(color.x, 0.F), std::max(color.y, 0.F), std::max(color.z, 0.F));
  if (result != color)
    context.warnings.add(kNegative, where, "the colour is negative: 0 stands in");
  return result;
}

void check_texture(const Context& context, const LocatedJson& json) {
  const TextureType* type = texture_type(type_of(json));
  if (type == nullptr) return;
  const ObjectReader object(context, json, "a texture");
  object.accept({"name", "type"});
  object.accept(type->members);
  object.report_unknown();
}

desc::TextureRef TextureReader::add(const SourceLocation& where, desc::Node node) {
  context_.scene.textures.push_back({"", where, std::move(node)});
  return {static_cast<desc::TextureId>(context_.scene.textures.size()) - 1};
}

std::string TextureReader::resolve(const LocatedJson& name) {
  try {
    return context_.files.resolve(name.text(), name.where());
  } catch (const IoError& error) {
    throw SceneError(name.where(), error.what());
  }
}

std::optional<Bitmap> TextureReader::bitmap(const LocatedJson& json) {
  if (!is_bitmap(json)) return std::nullopt;
  Bitmap result;
  if (json.is(Kind::Text)) {
    if (!json.text().empty()) result.file = resolve(json);
  } else {
    const ObjectReader object(context_, json, "a bitmap");
    object.accept({"type", "name"});
    if (const auto file = object.find({"file", "path"})) result.file = resolve(*file);
    result.gamma_correct = object.flag("gamma_correct").value_or(true);
    result.interpolate = object.flag("interpolate").value_or(true);
    result.clamp = object.flag("clamp").value_or(false);
    result.scale = object.number("scale").value_or(1.F);
    object.report_unknown();
  }
  if (result.file.empty()) {
    context_.warnings.add(kNoImageFile, json.where(), "this texture names no file: grey stands in");
    return std::nullopt;
  }
  return result;
}

desc::Value TextureReader::of_object(const LocatedJson& json) {
  const ObjectReader object(context_, json, "a texture");
  object.accept({"name"});
  const std::optional<std::string> type = object.text("type");
  if (!type) throw SceneError(json.where(), "a texture needs \"type\"");
  if (*type == "constant") {
    const Vec3 value = object.vector("value").value_or(Vec3(0.F));
    object.report_unknown();
    return value;
  }
  if (*type == "checker") {
    const Vec3 on = object.vector("on_color").value_or(Vec3(0.8F));
    const Vec3 off = object.vector("off_color").value_or(Vec3(0.2F));
    const auto cells = [&](std::string_view name) {
      return static_cast<float>(object.integer(name).value_or(20));
    };
    desc::Node node = desc::texture_node(
        "checkerboard",
        {{"first", off}, {"second", on}, {"scale_u", cells("res_u")}, {"scale_v", cells("res_v")}});
    object.report_unknown();
    return add(json.where(), std::move(node));
  }
  const TextureType* known = texture_type(*type);
  if (known == nullptr) {
    context_.warnings.add(
        kUnknownTexture, json.where(),
        unknown_name_message("texture", printable(*type), names_of_texture_types()) +
            ". Grey stands in",
        printable(*type));
    return kGrey;
  }
  context_.warnings.add(kStandIn, json.where(),
                        "textures of type \"" + *type +
                            "\" are not supported: a constant one "
                            "stands in",
                        *type);
  object.accept(known->members);
  object.report_unknown();
  return object.vector(known->stand_in).value_or(Vec3(1.F));
}

desc::Value TextureReader::color(const LocatedJson& json) {
  if (json.is(Kind::Number) || json.is(Kind::Array)) return vector_of(json);
  if (!is_bitmap(json)) return of_object(json);
  const std::optional<Bitmap> image = bitmap(json);
  if (!image) return kGrey;
  return add_image(json.where(), *image, image->decoding_exponent(), "color");
}

desc::TextureRef TextureReader::add_image(const SourceLocation& where, const Bitmap& image,
                                          float decoding_exponent, const std::string& channel) {
  return add(where,
             desc::texture_node(
                 "image", {{"file", image.file},
                           {"channel", channel},
                           {"wrap", std::string(image.clamp ? "clamp" : "repeat")},
                           {"decoding_exponent", decoding_exponent},
                           {"scale", image.scale},
                           {"filter", std::string(image.interpolate ? "bilinear" : "nearest")}}));
}

desc::Value TextureReader::number(const LocatedJson& json, NumberRole role) {
  if (is_bitmap(json)) {
    if (const std::optional<Bitmap> image = bitmap(json)) {
      const char* const channel = role == NumberRole::Number      ? "mean"
                                  : always_has_alpha(image->file) ? "alpha"
                                                                  : "alpha_or_mean";
      return add_image(json.where(), *image, 1.F, channel);
    }
    return kGrey.x;
  }
  // Tungsten takes the first number of colours that are no image.
  desc::Value value = color(json);
  if (const Vec3* constant = std::get_if<Vec3>(&value)) return constant->x;
  const desc::TextureId id = std::get<desc::TextureRef>(value).id;
  desc::Node& checkerboard = context_.scene.textures[static_cast<std::size_t>(id)].node;
  for (const char* name : {"first", "second"}) {
    checkerboard.set(name, Vec3(checkerboard.color(name).x));
  }
  return value;
}

desc::Value TextureReader::color(const ObjectReader& object,
                                 std::initializer_list<std::string_view> names,
                                 const Vec3& fallback) {
  const auto json = object.find(names);
  return json ? color(*json) : fallback;
}

desc::Value TextureReader::number(const ObjectReader& object,
                                  std::initializer_list<std::string_view> names, float fallback) {
  const auto json = object.find(names);
  return json ? number(*json) : fallback;
}

desc::Value TextureReader::product(const desc::Value& color, const Vec3& factor) {
  if (const Vec3* constant = std::get_if<Vec3>(&color)) return *constant * factor;
  if (factor == Vec3(1.F)) return color;
  const desc::TextureId id = std::get<desc::TextureRef>(color).id;
  const SourceLocation where = context_.scene.textures[static_cast<std::size_t>(id)].where;
  return add(where, desc::texture_node("product", {{"first", color}, {"second", factor}}));
}

desc::Value TextureReader::product(const desc::Value& number, float factor) {
  if (const float* constant = std::get_if<float>(&number)) return *constant * factor;
  return product(number, Vec3(factor));
}

}  // namespace ajar::tungsten
