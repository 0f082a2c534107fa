#include "import/pbrt/transforms.h"
#include "import/pbrt/writer_context.h"

namespace ajar::pbrt {
namespace {

class TextureWriter {
 public:
  explicit TextureWriter(WriterContext& context) : context_(context) {}

  void write_texture(std::size_t i) {
    const desc::Texture& texture = context_.scene.textures[i];
    const std::optional<Mat4> place = texture_transform(texture);
    if (place) context_.out.line("TransformBegin").line("Transform").matrix(*place);
    for (const bool as_float : {true, false}) {
      if (!(as_float ? context_.texture_uses[i].as_float : context_.texture_uses[i].as_spectrum))
        continue;
      context_.out.line("Texture")
          .quoted(context_.texture_names[i])
          .quoted(as_float ? "float" : "spectrum");
      std::visit([&](const auto& node) { write_node(node, as_float); }, texture.node);
    }
    if (place) context_.out.line("TransformEnd");
  }

 private:
  void write_mapping(const desc::Mapping2D& mapping) {
    if (const auto* uv = std::get_if<desc::UvMapping>(&mapping)) {
      context_.out.parameter("float uscale", uv->su).parameter("float vscale", uv->sv);
      context_.out.parameter("float udelta", uv->du).parameter("float vdelta", uv->dv);
    } else if (const auto* planar = std::get_if<desc::PlanarMapping>(&mapping)) {
      context_.out.parameter("string mapping", "planar");
      context_.out.parameter("vector v1", planar->vs.x, planar->vs.y, planar->vs.z);
      context_.out.parameter("vector v2", planar->vt.x, planar->vt.y, planar->vt.z);
      context_.out.parameter("float udelta", planar->ds).parameter("float vdelta", planar->dt);
    } else {
      context_.out.parameter(
          "string mapping",
          std::holds_alternative<desc::SphericalMapping>(mapping) ? "spherical" : "cylindrical");
    }
  }

  /// The current transform that gives a texture its place; null if it has none.
  static std::optional<Mat4> texture_transform(const desc::Texture& texture) {
    const auto of_mapping = [](const desc::Mapping2D& mapping) -> std::optional<Mat4> {
      if (const auto* s = std::get_if<desc::SphericalMapping>(&mapping))
        return inverse(s->world_to_texture);
      if (const auto* c = std::get_if<desc::CylindricalMapping>(&mapping))
        return inverse(c->world_to_texture);
      return std::nullopt;
    };
    return std::visit(
        [&](const auto& node) -> std::optional<Mat4> {
          using Node = std::decay_t<decltype(node)>;
          if constexpr (std::is_same_v<Node, desc::CheckerboardTexture>) {
            if (node.dimension == 3) return node.world_to_texture;
            return of_mapping(node.mapping);
          } else if constexpr (requires { node.world_to_texture; }) {
            return node.world_to_texture;
          } else if constexpr (requires { node.mapping; }) {
            return of_mapping(node.mapping);
          } else {
            return std::nullopt;
          }
        },
        texture.node);
  }

  void value(const std::string& name, const desc::Rgb& rgb, bool as_float) {
    if (as_float) {
      context_.out.parameter("float " + name, rgb.x);
    } else {
      context_.out.rgb(name, rgb);
    }
  }
  void write_node(const desc::ConstantTexture& t, bool as_float) {
    context_.out.quoted("constant");
    value("value", t.value, as_float);
  }
  void write_node(const desc::ScaleTexture& t, bool) {
    context_.out.quoted("scale");
    context_.reference("tex1", t.a);
    context_.reference("tex2", t.b);
  }
  void write_node(const desc::MixTexture& t, bool) {
    context_.out.quoted("mix");
    context_.reference("tex1", t.a);
    context_.reference("tex2", t.b);
    context_.reference("amount", t.amount);
  }
  void write_node(const desc::BilerpTexture& t, bool as_float) {
    context_.out.quoted("bilerp");
    value("v00", t.v00, as_float);
    value("v01", t.v01, as_float);
    value("v10", t.v10, as_float);
    value("v11", t.v11, as_float);
    write_mapping(t.mapping);
  }
  void write_node(const desc::ImageTexture& t, bool) {
    static constexpr const char* kWraps[] = {"repeat", "black", "clamp"};
    context_.out.quoted("imagemap");
    if (!t.path.empty()) context_.out.parameter("string filename", context_.image_path(t.path));
    context_.out.parameter("string wrap", kWraps[static_cast<int>(t.wrap)]);
    context_.out.flag("gamma", t.decode_srgb).parameter("float scale", t.scale);
    write_mapping(t.mapping);
  }
  void write_node(const desc::CheckerboardTexture& t, bool) {
    context_.out.quoted("checkerboard").parameter("integer dimension", t.dimension);
    context_.reference("tex1", t.a);
    context_.reference("tex2", t.b);
    if (t.dimension == 2) write_mapping(t.mapping);
  }
  void write_node(const desc::DotsTexture& t, bool) {
    context_.out.quoted("dots");
    context_.reference("inside", t.inside);
    context_.reference("outside", t.outside);
    write_mapping(t.mapping);
  }
  void write_node(const desc::UvTexture& t, bool) {
    context_.out.quoted("uv");
    write_mapping(t.mapping);
  }
  void write_node(const desc::FbmTexture& t, bool) {
    context_.out.quoted("fbm")
        .parameter("integer octaves", t.octaves)
        .parameter("float roughness", t.roughness);
  }
  void write_node(const desc::WrinkledTexture& t, bool) {
    context_.out.quoted("wrinkled")
        .parameter("integer octaves", t.octaves)
        .parameter("float roughness", t.roughness);
  }
  void write_node(const desc::WindyTexture&, bool) { context_.out.quoted("windy"); }
  void write_node(const desc::MarbleTexture& t, bool) {
    context_.out.quoted("marble")
        .parameter("integer octaves", t.octaves)
        .parameter("float roughness", t.roughness);
    context_.out.parameter("float scale", t.scale).parameter("float variation", t.variation);
  }

  WriterContext& context_;
};

}  // namespace

void write_textures(WriterContext& context) {
  TextureWriter writer(context);
  for (std::size_t i = 0; i < context.scene.textures.size(); ++i) writer.write_texture(i);
}

}  // namespace ajar::pbrt
