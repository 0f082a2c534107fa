#include <numeric>

#include "import/common/opacity.h"
#include "import/common/relief_of_mix.h"
#include "import/mitsuba/material_plugins.h"
#include "import/mitsuba/numbers.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kTwoMaterials{
    Effect::Surface, "materials have another one behind, which is not supported: both sides alike"};
constexpr WarningKind kTwoReliefs{
    Effect::Surface, "bump or normal maps are inside of others: only the outer ones count"};
constexpr WarningKind kShadowing{
    Effect::Slight,
    "bump and normal maps are not darkened or turned as in newer versions of Mitsuba"};
constexpr WarningKind kNoRelief{Effect::Surface,
                                "bump or normal maps have no texture: surfaces are smooth"};

/// The materials in this one, from `least` to `most` of them.
std::vector<Surface> parts_of(const MaterialInputs& in, std::size_t least, std::size_t most) {
  std::vector<Surface> parts;
  for (const Element* bsdf : in.arguments.children("bsdf", most)) {
    parts.push_back(in.materials.make(*bsdf));
  }
  if (parts.size() < least) {
    throw SceneError(in.where(), "bsdf \"" + in.arguments.element().type + "\" needs " +
                                     std::to_string(least) + " bsdf in it, not " +
                                     std::to_string(parts.size()));
  }
  return parts;
}

Passing passing_of(const MaterialInputs& in) {
  return in.context().counts_straight ? Passing::Counted : Passing::Uncounted;
}

desc::MaterialRef part_of(const MaterialInputs& in, const Surface& surface) {
  return {part_of_mix(in.context().scene, surface.material, passing_of(in))};
}

/// `amount` of the first material, the rest of the second.
desc::MaterialId mix(const MaterialInputs& in, const desc::Value& amount, desc::MaterialRef first,
                     desc::MaterialRef second) {
  return in.materials.add(
      in.arguments.element(),
      desc::material_node("mix", {{"amount", amount}, {"first", first}, {"second", second}}));
}

/// Warns if the parts of a mix, whose first this is to be, have reliefs of their own.
void check_relief(const MaterialInputs& in, const Surface& first, const Surface& other) {
  check_relief_of_mix(in.context().scene, first.material, other.material, in.where(),
                      in.context().warnings);
}

/// A number as the colour that `mix` wants.
desc::Value as_color(const desc::Value& value) {
  if (const float* number = std::get_if<float>(&value)) return Vec3(*number);
  return value;
}

/// A copy of a material with this relief; of a mix, whose relief is that of its first part, with
/// that tilted.
desc::MaterialId tilted(const MaterialInputs& in, desc::MaterialId id, desc::TextureId bump,
                        const desc::NormalMap& normal_map) {
  std::vector<desc::Node> mixes;
  while (in.materials.get(id).node.is("mix")) {
    mixes.push_back(in.materials.get(id).node);
    id = mixes.back().material("first");
  }
  if (in.materials.get(id).has_relief()) {
    in.context().warnings.add(kTwoReliefs, in.where(),
                              "the bump or normal map in this one is not supported: left out");
  }
  desc::MaterialId made = in.materials.add(in.arguments.element(), in.materials.get(id).node);
  in.context().scene.materials.back().bump = bump;
  in.context().scene.materials.back().normal_map = normal_map;
  for (; !mixes.empty(); mixes.pop_back()) {
    mixes.back().set("first", desc::MaterialRef{made});
    made = in.materials.add(in.arguments.element(), std::move(mixes.back()));
  }
  return made;
}

/// The texture in this one, or, as in the renderer of Zeltner et al. 2020, its file; nothing, after
/// a warning, if there is none.
std::optional<desc::TextureId> texture_of_relief(const MaterialInputs& in, bool is_height) {
  const Element* texture = in.arguments.only_child("texture");
  if (texture == nullptr) {
    if (const auto color = in.arguments.color(is_height ? "bumpmap" : "normalmap")) {
      return in.textures.add_constant(in.where(), *color);
    }
    const std::optional<std::string> file = in.arguments.text("filename");
    if (file) return in.textures.add_vectors(in.where(), *file);
    in.context().warnings.add(
        kNoRelief, in.where(),
        "bsdf \"" + in.arguments.element().type + "\" has no texture in it: the surface is smooth");
    return std::nullopt;
  }
  return is_height ? in.textures.make_height(*texture) : in.textures.make(*texture);
}

/// The material in this one with this relief.
Surface with_relief(const MaterialInputs& in, desc::TextureId bump,
                    const desc::NormalMap& normal_map) {
  // False is the behaviour of versions without these words.
  for (const char* name : {"use_shadowing_function", "flip_invalid_normals"}) {
    if (!in.arguments.flag(name, false)) continue;
    in.context().warnings.add(kShadowing, in.where(),
                              "\"" + std::string(name) + "\" is not supported: ignored", name);
  }
  Surface result = parts_of(in, 1, 1).front();
  const bool is_none = bump == desc::kNone && normal_map.texture == desc::kNone;
  if (is_none || in.materials.get(result.material).node.is("interface")) return result;
  result.material = tilted(in, result.material, bump, normal_map);
  return result;
}

}  // namespace

Surface make_null(const MaterialInputs& in) { return in.materials.interface(); }

Surface make_two_sided(const MaterialInputs& in) {
  const std::vector<Surface> parts = parts_of(in, 1, 2);
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
  Surface result = parts_of(in, 1, 1).front();
  // A number since Mitsuba 2.
  const desc::Value opacity = in.context().document.major_version == 0
                                  ? in.textures.color(in.arguments, "opacity", desc::Rgb(0.5F))
                                  : as_color(in.textures.number(in.arguments, "opacity", 0.5F));
  if (opacity == desc::Value(Vec3(1.F))) return result;
  if (opacity == desc::Value(Vec3(0.F))) return in.materials.interface();
  const PartlyClear partly =
      with_opacity(in.context().scene, {.name = in.arguments.element().id, .where = in.where()},
                   result.material, opacity, passing_of(in));
  result.material = partly.material;
  if (partly.alpha != desc::kNone) result.alpha = partly.alpha;
  return result;
}

Surface make_bump_map(const MaterialInputs& in) {
  const float scale = in.arguments.number("scale", 1.F);
  const std::optional<desc::TextureId> height = texture_of_relief(in, true);
  if (!height) return with_relief(in, desc::kNone, {});
  const desc::Value scaled = in.textures.scaled(in.where(), desc::TextureRef{*height}, scale);
  return with_relief(in, std::get<desc::TextureRef>(scaled).id, {});
}

Surface make_normal_map(const MaterialInputs& in) {
  const desc::TextureId normals = texture_of_relief(in, false).value_or(desc::kNone);
  return with_relief(in, desc::kNone, {.texture = normals, .right_handed = true});
}

Surface make_blend(const MaterialInputs& in) {
  const std::vector<Surface> parts = parts_of(in, 2, 2);
  check_relief(in, parts[1], parts[0]);
  const desc::Value weight = as_color(in.textures.number(in.arguments, "weight", 0.5F));
  return {mix(in, weight, part_of(in, parts[1]), part_of(in, parts[0])), desc::kNone,
          parts[0].is_one_sided || parts[1].is_one_sided};
}

Surface make_mixture(const MaterialInputs& in) {
  const std::vector<Surface> parts = parts_of(in, 1, Arguments::kAll);
  std::optional<std::vector<double>> weights = parse_numbers(in.arguments.text("weights", ""));
  if (!weights || weights->size() != parts.size()) {
    throw SceneError(in.where(), "a mixture needs as many numbers in \"weights\" as it has bsdfs");
  }
  for (const double weight : *weights) {
    if (!(weight >= 0.0)) throw SceneError(in.where(), "a weight of this mixture is negative");
  }
  for (std::size_t i = 1; i < parts.size(); ++i) check_relief(in, parts[0], parts[i]);
  in.arguments.accept({"ensure_energy_conservation"});
  double rest = std::accumulate(weights->begin(), weights->end(), 0.0);
  if (!(rest > 0.0)) return {in.materials.black()};
  // Missing weight is absorption; an excess scales all parts.
  const double absorbed = std::max(1.0 - rest, 0.0);
  Surface result{absorbed > 0.0 ? in.materials.black() : part_of(in, parts.back()).id};
  rest = absorbed > 0.0 ? absorbed : weights->back();
  for (std::size_t i = parts.size() - (absorbed > 0.0 ? 0U : 1U); i-- > 0;) {
    rest += (*weights)[i];
    const auto share = static_cast<float>(rest > 0.0 ? (*weights)[i] / rest : 0.0);
    result.material = mix(in, Vec3(share), part_of(in, parts[i]), {result.material});
  }
  for (const Surface& part : parts) result.is_one_sided |= part.is_one_sided;
  return result;
}

}  // namespace ajar::mitsuba
