#include <numeric>

#include "import/mitsuba/material_plugins.h"
#include "import/mitsuba/numbers.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kTwoMaterials{
    Effect::Surface, "materials have another one behind, which is not supported: both sides alike"};
constexpr WarningKind kNormalMap{Effect::Surface,
                                 "normal maps are not supported: surfaces are smooth"};
constexpr WarningKind kNoBump{Effect::Surface, "bump maps have no texture: surfaces are smooth"};

/// The materials in this one, `count` or more of them.
std::vector<Surface> parts_of(const MaterialInputs& in, std::size_t count) {
  std::vector<Surface> parts;
  for (const Element* bsdf : in.arguments.children("bsdf"))
    parts.push_back(in.materials.make(*bsdf));
  if (parts.size() < count) {
    throw SceneError(in.where(), "bsdf \"" + in.arguments.element().type + "\" needs " +
                                     std::to_string(count) + " bsdf in it, not " +
                                     std::to_string(parts.size()));
  }
  return parts;
}

/// The material of a part of a mix, where nothing must let light pass.
desc::MaterialRef part_of_mix(const MaterialInputs& in, const Surface& part) {
  const bool is_nothing = in.materials.get(part.material).node.is("interface");
  return {is_nothing ? in.materials.pass_through() : part.material};
}

/// `amount` of the first material, the rest of the second.
desc::MaterialId mix(const MaterialInputs& in, const desc::Value& amount, desc::MaterialRef first,
                     desc::MaterialRef second) {
  return in.materials.add(
      in.arguments.element(),
      desc::material_node("mix", {{"amount", amount}, {"first", first}, {"second", second}}));
}

/// A number as the colour that `mix` wants.
desc::Value as_color(const desc::Value& value) {
  if (const float* number = std::get_if<float>(&value)) return Vec3(*number);
  return value;
}

}  // namespace

Surface make_null(const MaterialInputs& in) { return in.materials.interface(); }

Surface make_two_sided(const MaterialInputs& in) {
  const std::vector<Surface> parts = parts_of(in, 1);
  if (parts.size() > 1 && parts[1].material != parts[0].material) {
    in.context().warnings.add(kTwoMaterials, in.where(),
                              "another material behind is not supported: the one in front is used "
                              "for both sides");
  }
  Surface result = parts.front();
  result.is_one_sided = false;
  return result;
}

Surface make_mask(const MaterialInputs& in) {
  Surface result = parts_of(in, 1).front();
  const desc::Value opacity = in.textures.color(in.arguments, "opacity", desc::Rgb(0.5F));
  if (opacity == desc::Value(Vec3(1.F))) return result;
  if (opacity == desc::Value(Vec3(0.F))) return in.materials.interface();
  // What is cut away does not stop light on its way from a lamp; the rest is a mix.
  if (const auto* texture = std::get_if<desc::TextureRef>(&opacity)) result.alpha = texture->id;
  result.material = mix(in, opacity, {result.material}, {in.materials.pass_through()});
  return result;
}

Surface make_bump_map(const MaterialInputs& in) {
  Surface result = parts_of(in, 1).front();
  const std::vector<const Element*> textures = in.arguments.children("texture");
  const float scale = in.arguments.number("scale", 1.F);
  if (textures.empty()) {
    in.context().warnings.add(kNoBump, in.where(), "this bump map has no texture: ignored");
    return result;
  }
  const desc::Value bump =
      in.textures.scaled(in.where(), desc::TextureRef{in.textures.make(*textures.front())}, scale);
  const desc::Material& inner = in.materials.get(result.material);
  if (inner.node.is("interface")) return result;
  const desc::Node node = inner.node;
  result.material = in.materials.add(in.arguments.element(), node);
  in.context().scene.materials.back().bump = std::get<desc::TextureRef>(bump).id;
  return result;
}

Surface make_normal_map(const MaterialInputs& in) {
  const Surface result = parts_of(in, 1).front();
  in.context().warnings.add(kNormalMap, in.where(),
                            "normal maps are not supported: the surface is smooth");
  in.arguments.accept_all();
  return result;
}

Surface make_blend(const MaterialInputs& in) {
  const std::vector<Surface> parts = parts_of(in, 2);
  const desc::Value weight = as_color(in.textures.number(in.arguments, "weight", 0.5F));
  return {mix(in, weight, part_of_mix(in, parts[1]), part_of_mix(in, parts[0])), desc::kNone,
          parts[0].is_one_sided || parts[1].is_one_sided};
}

Surface make_mixture(const MaterialInputs& in) {
  const std::vector<Surface> parts = parts_of(in, 1);
  std::optional<std::vector<double>> weights = parse_numbers(in.arguments.text("weights", ""));
  if (!weights || weights->size() != parts.size()) {
    throw SceneError(in.where(), "a mixture needs as many numbers in \"weights\" as it has bsdfs");
  }
  for (const double weight : *weights) {
    if (!(weight >= 0.0)) throw SceneError(in.where(), "a weight of this mixture is negative");
  }
  in.arguments.accept({"ensure_energy_conservation"});
  double rest = std::accumulate(weights->begin(), weights->end(), 0.0);
  if (!(rest > 0.0)) return {in.materials.black()};
  // What the weights leave is absorbed; what is too much is taken from all.
  const double absorbed = std::max(1.0 - rest, 0.0);
  Surface result{absorbed > 0.0 ? in.materials.black() : part_of_mix(in, parts.back()).id};
  rest = absorbed > 0.0 ? absorbed : weights->back();
  for (std::size_t i = parts.size() - (absorbed > 0.0 ? 0U : 1U); i-- > 0;) {
    rest += (*weights)[i];
    const auto share = static_cast<float>(rest > 0.0 ? (*weights)[i] / rest : 0.0);
    result.material = mix(in, Vec3(share), part_of_mix(in, parts[i]), {result.material});
  }
  for (const Surface& part : parts) result.is_one_sided |= part.is_one_sided;
  return result;
}

}  // namespace ajar::mitsuba
