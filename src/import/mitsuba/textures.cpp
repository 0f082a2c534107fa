#include "import/mitsuba/textures.h"

#include "core/printable_text.h"
#include "core/spectrum.h"
#include "import/mitsuba/node_maker.h"
#include "import/mitsuba/plugin_types.h"
#include "import/mitsuba/spectrum_plugins.h"
#include "import/mitsuba/uv_transform.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kNoImageFile{Effect::Surface, "textures have no \"filename\""};
constexpr WarningKind kTextureStandIn{Effect::Surface,
                                      "textures are not supported: grey stands in"};
constexpr WarningKind kWrap{
    Effect::Surface, "textures have a wrap mode that is not supported: the nearest stands in"};
constexpr WarningKind kImageFilter{Effect::Slight, "textures have an unknown filter: bilinear"};
constexpr WarningKind kChannel{Effect::Surface,
                               "textures use a channel of an image that is not supported: all"};

desc::Node constant(const desc::Rgb& value) {
  return desc::texture_node("constant", {{"value", Vec3(value)}});
}

/// Mitsuba's name of it, and whether ours is equivalent.
std::pair<std::string, bool> wrap_of(const std::string& mode) {
  if (mode == "clamp" || mode == "repeat") return {mode, true};
  if (mode == "zero" || mode == "black") return {"black", true};
  return {mode == "one" || mode == "white" ? "clamp" : "repeat", false};
}

/// Mitsuba's v counts from the top row of an image, ours from the bottom row.
void set_image_uv(desc::Node& node, UvTransform uv) {
  uv.scale.y = -uv.scale.y;
  uv.offset.y = 1.F - uv.offset.y;
  uv.set(node);
}

/// A colour as one number: the mean or the luminance of its lanes.
float number_of(const desc::Rgb& color, bool mean) {
  if (color.x == color.y && color.y == color.z) return color.x;
  const Spectrum lanes(color.x, color.y, color.z);
  return mean ? lanes.average() : luminance(lanes);
}

}  // namespace

std::optional<float> decoding_exponent(Arguments& bitmap) {
  const std::optional<double> gamma = bitmap.number("gamma");
  if (bitmap.flag("raw", false)) return 1.F;
  // Mitsuba 0.x takes -1 for the curve of sRGB, and 0 for the file's own.
  return gamma && *gamma > 0.0 ? std::optional(static_cast<float>(*gamma)) : std::nullopt;
}

TextureTable::Role TextureTable::number_role() const {
  return context_.document.major_version == 0 ? Role::Mean : Role::Luminance;
}

std::optional<desc::Value> TextureTable::find_color(Arguments& arguments, std::string_view name) {
  if (const Element* texture = arguments.texture(name)) {
    return desc::TextureRef{make(*texture)};
  }
  const std::optional<desc::Rgb> color = arguments.color(name);
  return color ? std::optional<desc::Value>(Vec3(*color)) : std::nullopt;
}

desc::Value TextureTable::color(Arguments& arguments, std::string_view name,
                                const desc::Rgb& fallback) {
  return find_color(arguments, name).value_or(Vec3(fallback));
}

std::optional<desc::Value> TextureTable::find_number(Arguments& arguments, std::string_view name) {
  if (const Element* texture = arguments.texture(name)) {
    return desc::TextureRef{make(*texture, number_role())};
  }
  const std::optional<desc::Rgb> color = arguments.color(name, "a number");
  if (!color) return std::nullopt;
  return number_of(*color, number_role() == Role::Mean);
}

desc::Value TextureTable::number(Arguments& arguments, std::string_view name, float fallback) {
  return find_number(arguments, name).value_or(fallback);
}

desc::Value TextureTable::scaled(const SourceLocation& where, const desc::Value& value,
                                 const desc::Rgb& factor) {
  if (const Vec3* color = std::get_if<Vec3>(&value)) return *color * factor;
  if (factor == desc::Rgb(1.F)) return value;
  context_.scene.textures.push_back(
      {"", where, desc::texture_node("product", {{"first", value}, {"second", Vec3(factor)}})});
  return desc::TextureRef{static_cast<desc::TextureId>(context_.scene.textures.size()) - 1};
}

desc::Value TextureTable::scaled(const SourceLocation& where, const desc::Value& value,
                                 float factor) {
  if (const float* number = std::get_if<float>(&value)) return *number * factor;
  return scaled(where, value, desc::Rgb(factor));
}

desc::TextureId TextureTable::make(const Element& element, Role role) {
  if (const auto known = made_.find({&element, role}); known != made_.end()) return known->second;
  desc::Node node = read(element, role);
  if (role != Role::Color) {
    for (const char* name : {"value", "first", "second"}) {
      if (!node.has(name)) continue;
      if (const Vec3* color = std::get_if<Vec3>(&node.get(name))) {
        node.set(name, Vec3(number_of(*color, role == Role::Mean)));
      }
    }
  }
  const auto id = static_cast<desc::TextureId>(context_.scene.textures.size());
  context_.scene.textures.push_back({element.id, element.where, std::move(node)});
  made_[{&element, role}] = id;
  return id;
}

desc::Node TextureTable::read(const Element& element, Role role) {
  if (is_spectrum(element)) return constant(evaluate_spectrum(context_, element));
  Arguments arguments(context_, element);
  if (element.type == "bitmap") return bitmap(arguments, role);
  if (element.type == "checkerboard") return checkerboard(arguments, role);
  if (element.type == "scale") return scale(arguments, role);
  return stand_in(arguments);
}

desc::TextureId TextureTable::add_constant(const SourceLocation& where, const desc::Rgb& color) {
  context_.scene.textures.push_back({"", where, constant(color)});
  return static_cast<desc::TextureId>(context_.scene.textures.size()) - 1;
}

desc::TextureId TextureTable::add_vectors(const SourceLocation& where, const std::string& file) {
  desc::Node node = desc::texture_node(
      "image", {{"file", context_.files.files().resolve(context_.files.find(file), where)},
                {"decode_srgb", false}});
  set_image_uv(node, {});
  context_.scene.textures.push_back({"", where, std::move(node)});
  return static_cast<desc::TextureId>(context_.scene.textures.size()) - 1;
}

desc::Node TextureTable::bitmap(Arguments& arguments, Role role) {
  desc::Node node = desc::texture_node("image");
  const std::optional<std::string> name = arguments.text("filename");
  if (name && !name->empty()) {
    node.set("file", context_.files.files().resolve(context_.files.find(*name), arguments.where()));
  } else {
    context_.warnings.add(kNoImageFile, arguments.where(), "this bitmap has no \"filename\"");
  }

  const std::optional<float> exponent = decoding_exponent(arguments);
  node.set("decode_srgb", exponent != 1.F);
  if (exponent && *exponent != 1.F) node.set("decoding_exponent", *exponent);

  const std::string mode =
      arguments.word("wrap_mode", arguments.word("wrap_mode_u", std::string("repeat")));
  const auto [wrap, is_same] = wrap_of(mode);
  if (!is_same || arguments.word("wrap_mode_v", mode) != mode) {
    context_.warnings.add(kWrap, arguments.where(),
                          "wrap mode \"" + printable(mode) +
                              "\", or one for u and another for v, is not supported: " + wrap +
                              " stands in",
                          printable(mode));
  }
  node.set("wrap", wrap);
  const std::string filter = arguments.word("filter_type", "bilinear");
  if (filter == "nearest") {
    node.set("filter", filter);
  } else if (filter != "bilinear" && filter != "trilinear" && filter != "ewa") {
    static const std::vector<std::string> kFilters = {"bilinear", "nearest", "trilinear", "ewa"};
    context_.warnings.add(
        kImageFilter, arguments.where(),
        unknown_name_message("filter_type", printable(filter), kFilters) + ". Bilinear stands in",
        printable(filter));
  }
  if (role != Role::Color) {
    node.set("channel", std::string(role == Role::Mean ? "mean" : "luminance"));
  }
  if (const std::string channel = arguments.word("channel", "all"); channel != "all") {
    static const std::map<std::string, std::string> kChannels = {
        {"r", "red"}, {"g", "green"}, {"b", "blue"}, {"a", "alpha"}};
    const auto known = kChannels.find(channel);
    if (known != kChannels.end()) {
      node.set("channel", known->second);
    } else {
      context_.warnings.add(kChannel, arguments.where(),
                            "this channel of an image is not supported: all are used",
                            printable(channel));
    }
  }

  set_image_uv(node, read_uv_transform(arguments));
  arguments.accept({"cache", "max_anisotropy", "format", "accel", "wrap_mode_u", "wrap_mode_v"});
  return node;
}

desc::Node TextureTable::checkerboard(Arguments& arguments, Role role) {
  desc::Node node(*desc::find_model(desc::ModelKind::Texture, "checkerboard"));
  // Mitsuba's checkerboard of numbers has its colours the other way round since version 2.
  const bool is_exchanged = role != Role::Color && context_.document.major_version != 0;
  node.set(is_exchanged ? "second" : "first", color(arguments, "color0", desc::Rgb(0.4F)));
  node.set(is_exchanged ? "first" : "second", color(arguments, "color1", desc::Rgb(0.2F)));
  // Mitsuba's unit has two squares each way, ours has one.
  UvTransform uv = read_uv_transform(arguments);
  uv.scale *= 2.F;
  uv.offset *= 2.F;
  uv.set(node);
  return node;
}

desc::Node TextureTable::scale(Arguments& arguments, Role role) {
  const Element* nested = arguments.only_child("texture");
  const desc::Value value =
      nested != nullptr ? desc::Value(desc::TextureRef{make(*nested, role)})
                        : desc::Value(Vec3(arguments.color("value").value_or(desc::Rgb(1.F))));
  return desc::texture_node(
      "product",
      {{"first", value}, {"second", Vec3(arguments.color("scale").value_or(desc::Rgb(1.F)))}});
}

desc::Node TextureTable::stand_in(Arguments& arguments) {
  const Element& element = arguments.element();
  context_.warnings.add(kTextureStandIn, element.where,
                        unknown_type_message(element) + ". Its mean, or grey, stands in",
                        printable(element.type));
  // Its own value, or the mean of the colours that a grid and the like have, is nearer than any
  // grey.
  if (const std::optional<desc::Rgb> value = arguments.color("value")) {
    arguments.accept_all();
    return constant(*value);
  }
  const std::optional<desc::Rgb> first = arguments.color("color0");
  const std::optional<desc::Rgb> second = arguments.color("color1");
  arguments.accept_all();
  if (first && second) return constant((*first + *second) * 0.5F);
  return constant(first.value_or(desc::Rgb(0.5F)));
}

}  // namespace ajar::mitsuba
