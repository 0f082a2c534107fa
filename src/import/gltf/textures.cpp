#include "import/gltf/textures.h"

#include <cmath>

#include "scene/desc/models.h"

namespace ajar::gltf {
namespace {

constexpr WarningKind kNoSource{Effect::Surface, "textures have no image that can be read"};
constexpr WarningKind kOtherUvs{
    Effect::Surface, "textures have other coordinates than those of their material: left out"};
constexpr WarningKind kWrap{Effect::Slight, "textures are repeated in another way"};

/// Values of `wrapS` and `magFilter` (glTF 2.0, section 5.26).
constexpr std::uint64_t kClamp = 33071;
constexpr std::uint64_t kMirror = 33648;
constexpr std::uint64_t kRepeat = 10497;
constexpr std::uint64_t kNearest = 9728;

std::string name_of(Channel channel) {
  static constexpr const char* kNames[] = {"color", "red", "green", "blue", "alpha", "color"};
  return kNames[static_cast<std::size_t>(channel)];
}

/// KHR_texture_transform turns counterclockwise as seen with v downwards: p' = offset + R S p with
/// R = (c s, −s c). With V = 1 − v that is the rotation of an `image`, R = (c −s, s c), and this
/// offset.
void set_transform(desc::Node& node, const Element& transform) {
  using Pair = std::array<double, 2>;
  const Pair offset = transform.value_or("offset", Pair{0.0, 0.0});
  const Pair scale = transform.value_or("scale", Pair{1.0, 1.0});
  const double angle = transform.value_or("rotation", 0.0);
  const auto set = [&](const char* name, double value) {
    node.set(name, static_cast<float>(value));
  };
  set("scale_u", scale[0]);
  set("scale_v", scale[1]);
  set("rotation", angle * 180.0 / M_PI);
  set("offset_u", offset[0] + std::sin(angle) * scale[1]);
  set("offset_v", 1.0 - offset[1] - std::cos(angle) * scale[1]);
}

}  // namespace

desc::Value Textures::color(const Element& holder, std::string_view name, const desc::Rgb& factor) {
  const std::optional<desc::TextureId> texture = read(holder, name, Channel::Color, 1.F);
  if (!texture) return factor;
  return factor == Vec3(1.F) ? desc::Value(desc::TextureRef{*texture})
                             : product(factor, desc::TextureRef{*texture});
}

desc::Value Textures::number(const Element& holder, std::string_view name, float factor,
                             Channel channel) {
  if (factor == 0.F) return factor;
  const std::optional<desc::TextureId> texture = read(holder, name, channel, factor);
  return texture ? desc::Value(desc::TextureRef{*texture}) : desc::Value(factor);
}

desc::Value Textures::product(const desc::Value& first, const desc::Value& second) {
  const auto* a = std::get_if<float>(&first);
  const auto* b = std::get_if<float>(&second);
  if (a != nullptr && b != nullptr) return *a * *b;
  if (a != nullptr && *a == 1.F) return second;
  if (b != nullptr && *b == 1.F) return first;
  const auto* first_color = std::get_if<Vec3>(&first);
  const auto* second_color = std::get_if<Vec3>(&second);
  if (first_color != nullptr && second_color != nullptr) return *first_color * *second_color;
  if (first == desc::Value(Vec3(1.F))) return second;
  desc::Node node = desc::texture_node("product");
  const auto set = [&](const char* name, const desc::Value& value) {
    const auto* number = std::get_if<float>(&value);
    node.set(name, number != nullptr ? desc::Value(Vec3(*number)) : value);
  };
  set("first", first);
  set("second", second);
  context_.scene.textures.push_back({"", where_, std::move(node)});
  return desc::TextureRef{static_cast<desc::TextureId>(context_.scene.textures.size()) - 1};
}

desc::Value Textures::complement(const desc::Value& value) {
  if (const auto* number = std::get_if<float>(&value)) return 1.F - *number;
  context_.scene.textures.push_back(
      {"", where_,
       desc::texture_node("mix",
                          {{"first", Vec3(1.F)}, {"second", Vec3(0.F)}, {"amount", value}})});
  return desc::TextureRef{static_cast<desc::TextureId>(context_.scene.textures.size()) - 1};
}

desc::TextureId Textures::threshold(const Element& user, const desc::Value& value, float edge) {
  return add(user, desc::texture_node("threshold", {{"value", value}, {"edge", edge}}));
}

desc::TextureId Textures::add(const Element& user, desc::Node node) {
  context_.scene.textures.push_back({"", user.where(), std::move(node)});
  return static_cast<desc::TextureId>(context_.scene.textures.size()) - 1;
}

std::optional<desc::TextureId> Textures::read(const Element& holder, std::string_view name,
                                              Channel channel, float scale) {
  const std::optional<Element> info = holder.find(name);
  if (!info) return std::nullopt;
  const Element texture = referred(info->at("index"), context_.document.root, "textures");
  const std::optional<Element> image = image_of(texture);
  if (!image) {
    context_.warnings.add(kNoSource, texture.where(),
                          "this texture has no image that can be read: left out");
    return std::nullopt;
  }
  if (!has_usable_uvs(*info)) return std::nullopt;
  const std::optional<std::string> file = images_.name_of(*image);
  if (!file) return std::nullopt;
  desc::Node node = desc::texture_node("image", {{"file", *file},
                                                 {"channel", name_of(channel)},
                                                 {"decode_srgb", channel == Channel::Color},
                                                 {"scale", scale}});
  set_sampler(node, texture);
  if (const auto transform = extension_of(*info, "KHR_texture_transform")) {
    transform->located([&] { set_transform(node, *transform); });
  }
  where_ = info->where();
  return add(*info, std::move(node));
}

std::optional<Element> Textures::image_of(const Element& texture) const {
  for (const std::optional<Element>& holder :
       {std::optional(texture), extension_of(texture, "EXT_texture_webp")}) {
    const std::optional<Element> source = holder ? holder->find("source") : std::nullopt;
    if (source) return referred(*source, context_.document.root, "images");
  }
  return std::nullopt;
}

void Textures::set_sampler(desc::Node& node, const Element& texture) {
  const std::optional<Element> reference = texture.find("sampler");
  if (!reference) return;
  const Element sampler = referred(*reference, context_.document.root, "samplers");
  const std::uint64_t s = sampler.value_or<std::uint64_t>("wrapS", kRepeat);
  const std::uint64_t t = sampler.value_or<std::uint64_t>("wrapT", kRepeat);
  if (s == kClamp && t == kClamp) node.set("wrap", std::string("clamp"));
  if (sampler.value_or<std::uint64_t>("magFilter", 0) == kNearest)
    node.set("filter", std::string("nearest"));
  if (s != t || s == kMirror) {
    context_.warnings.add(kWrap, sampler.where(),
                          "mirrored repetition, and another along u than along v, are not "
                          "possible: the image is repeated");
  }
}

bool Textures::has_usable_uvs(const Element& info) {
  const auto transform = extension_of(info, "KHR_texture_transform");
  std::uint64_t set = info.value_or<std::uint64_t>("texCoord", 0);
  if (transform) set = transform->value_or<std::uint64_t>("texCoord", set);
  if (!uv_set_) uv_set_ = static_cast<std::size_t>(set);
  if (set == *uv_set_) return true;
  context_.warnings.add(kOtherUvs, info.where(),
                        "this texture uses TEXCOORD_" + std::to_string(set) +
                            ", others of its material TEXCOORD_" + std::to_string(*uv_set_) +
                            ": left out");
  return false;
}

}  // namespace ajar::gltf
