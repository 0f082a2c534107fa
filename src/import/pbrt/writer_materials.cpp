#include "import/pbrt/writer_context.h"

namespace ajar::pbrt {
namespace {

class MaterialWriter {
 public:
  explicit MaterialWriter(WriterContext& context) : context_(context) {}

  void write_material(std::size_t i) {
    const desc::Material& material = context_.scene.materials[i];
    context_.out.line("MakeNamedMaterial").quoted(context_.material_names[i]);
    std::visit([&](const auto& node) { write_node(node); }, material.node);
    context_.reference("bumpmap", material.bump);
  }

 private:
  void type(std::string_view name) { context_.out.parameter("string type", name); }
  void remap(bool value) { context_.out.flag("remaproughness", value); }
  void write_node(const desc::MatteMaterial& m) {
    type("matte");
    context_.reference("Kd", m.kd);
    context_.reference("sigma", m.sigma);
  }
  void write_node(const desc::MirrorMaterial& m) {
    type("mirror");
    context_.reference("Kr", m.kr);
  }
  void write_node(const desc::GlassMaterial& m) {
    type("glass");
    context_.reference("Kr", m.kr);
    context_.reference("Kt", m.kt);
    context_.reference("eta", m.eta);
    context_.reference("uroughness", m.u_roughness);
    context_.reference("vroughness", m.v_roughness);
    remap(m.remap_roughness);
    if (m.thin) context_.out.flag("thin", true);
  }
  void write_node(const desc::MetalMaterial& m) {
    type("metal");
    context_.reference("eta", m.eta);
    context_.reference("k", m.k);
    context_.reference("uroughness", m.u_roughness);
    context_.reference("vroughness", m.v_roughness);
    remap(m.remap_roughness);
    if (m.model == desc::MicrofacetModel::Beckmann)
      context_.out.parameter("string distribution", "beckmann");
  }
  void write_node(const desc::PlasticMaterial& m) {
    type("plastic");
    context_.reference("Kd", m.kd);
    context_.reference("Ks", m.ks);
    context_.reference("roughness", m.roughness);
    remap(m.remap_roughness);
  }
  void write_node(const desc::SubstrateMaterial& m) {
    type("substrate");
    context_.reference("Kd", m.kd);
    context_.reference("Ks", m.ks);
    context_.reference("uroughness", m.u_roughness);
    context_.reference("vroughness", m.v_roughness);
    remap(m.remap_roughness);
  }
  void write_node(const desc::UberMaterial& m) {
    type("uber");
    context_.reference("Kd", m.kd);
    context_.reference("Ks", m.ks);
    context_.reference("Kr", m.kr);
    context_.reference("Kt", m.kt);
    context_.reference("uroughness", m.u_roughness);
    context_.reference("vroughness", m.v_roughness);
    context_.reference("eta", m.eta);
    context_.reference("opacity", m.opacity);
    remap(m.remap_roughness);
  }
  void write_node(const desc::TranslucentMaterial& m) {
    type("translucent");
    context_.reference("Kd", m.kd);
    context_.reference("Ks", m.ks);
    context_.reference("roughness", m.roughness);
    context_.reference("reflect", m.reflect);
    context_.reference("transmit", m.transmit);
    remap(m.remap_roughness);
  }
  void write_node(const desc::DisneyMaterial& m) {
    type("disney");
    context_.reference("color", m.color);
    context_.reference("metallic", m.metallic);
    context_.reference("eta", m.eta);
    context_.reference("roughness", m.roughness);
    context_.reference("speculartint", m.specular_tint);
    context_.reference("anisotropic", m.anisotropic);
    context_.reference("sheen", m.sheen);
    context_.reference("sheentint", m.sheen_tint);
    context_.reference("clearcoat", m.clearcoat);
    context_.reference("clearcoatgloss", m.clearcoat_gloss);
    context_.reference("spectrans", m.spec_trans);
    context_.reference("flatness", m.flatness);
    context_.reference("difftrans", m.diff_trans);
    context_.out.flag("thin", m.thin);
  }
  void write_node(const desc::MixMaterial& m) {
    type("mix");
    context_.reference("amount", m.amount);
    context_.out.parameter("string namedmaterial1",
                           context_.material_names.at(static_cast<std::size_t>(m.a)));
    context_.out.parameter("string namedmaterial2",
                           context_.material_names.at(static_cast<std::size_t>(m.b)));
  }
  void write_node(const desc::InterfaceMaterial&) { type("none"); }

  WriterContext& context_;
};

}  // namespace

void write_materials(WriterContext& context) {
  MaterialWriter writer(context);
  for (std::size_t i = 0; i < context.scene.materials.size(); ++i) writer.write_material(i);
}

}  // namespace ajar::pbrt
