#include "import/common/transforms.h"
#include "import/pbrt/texture_names.h"
#include "import/pbrt/writer_context.h"

namespace ajar::pbrt {
namespace {

/// The current transform that gives a texture its place, as the importer reads it; nothing if it
/// has none.
std::optional<Mat4> place_of(const desc::Node& node) {
  constexpr const char* kPlace = "world_to_texture";
  if (!node.has(kPlace)) return std::nullopt;
  if (!node.has("mapping")) return node.transform(kPlace);
  const std::string& mapping = node.text("mapping");
  if (mapping != "spherical" && mapping != "cylindrical") return std::nullopt;
  return inverse(node.transform(kPlace));
}

/// An image that is written for pbrt includes the options that pbrt does not have.
Substitutes substitutes_of(WriterContext& context, const desc::Node& node) {
  if (!node.is("image")) return {};
  const std::optional<std::string> file = context.images.for_texture(node);
  if (!file) return {};
  Substitutes result{{"file", *file}};
  for (const char* said : {"channel", "decoding_exponent", "offset", "invert", "clamp"}) {
    result[said] = desc::Value();
  }
  return result;
}

/// The image that shows where a threshold of an image is reached; nothing for other textures.
std::optional<desc::Node> cut_out_in_pbrt(WriterContext& context, const desc::Node& node) {
  if (!node.is("threshold")) return std::nullopt;
  float edge = node.number("edge");
  const desc::Value* compared = &node.get("value");
  // Down through factors.
  for (;;) {
    const auto* texture = std::get_if<desc::TextureRef>(compared);
    if (texture == nullptr) return std::nullopt;
    const desc::Node& of = context.scene.textures[static_cast<std::size_t>(texture->id)].node;
    if (of.is("image")) return context.images.cut_out(of, edge);
    if (!of.is("product")) return std::nullopt;
    const bool is_second = std::holds_alternative<Vec3>(of.get("first"));
    const Vec3* factor = std::get_if<Vec3>(&of.get(is_second ? "first" : "second"));
    if (factor == nullptr || !(factor->x > 0.F)) return std::nullopt;
    edge /= factor->x;
    compared = &of.get(is_second ? "second" : "first");
  }
}

void write_texture(WriterContext& context, std::size_t i) {
  if (!context.texture_uses[i].as_float && !context.texture_uses[i].as_spectrum) return;
  const desc::Node& own = context.scene.textures[i].node;
  const std::optional<desc::Node> cut_out = cut_out_in_pbrt(context, own);
  const desc::Node& node = cut_out ? *cut_out : own;
  const ModelName* names = find_ours(texture_names(), node.model().name);
  const std::optional<Mat4> place = place_of(node);
  if (place) context.out.line("TransformBegin").line("Transform").matrix(*place);
  const Substitutes substitutes = substitutes_of(context, node);
  for (const bool as_float : {true, false}) {
    const TextureUse& use = context.texture_uses[i];
    if (!(as_float ? use.as_float : use.as_spectrum)) continue;
    context.out.line("Texture").quoted(context.texture_names[i]);
    context.out.quoted(as_float ? "float" : "spectrum")
        .quoted(names == nullptr ? node.model().name : names->theirs);
    if (node.is("solid_checkerboard")) context.out.parameter("integer dimension", 3);
    write_parameters(context, node, names, as_float, substitutes);
    if (cut_out) write_own_words(context, own);
  }
  if (place) context.out.line("TransformEnd");
}

}  // namespace

void write_textures(WriterContext& context) {
  for (std::size_t i = 0; i < context.scene.textures.size(); ++i) write_texture(context, i);
}

}  // namespace ajar::pbrt
