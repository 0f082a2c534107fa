#pragma once
#include <optional>
#include <string>
#include <vector>

#include "import/tungsten/bsdfs.h"

namespace ajar::tungsten {

/// Inputs of a bsdf.
struct BsdfInputs {
  Context& context;
  const ObjectReader& object;
  TextureReader& textures;
  BsdfTable& bsdfs;

  SourceLocation where() const { return object.where(); }
  /// "albedo", a colour or a texture.
  desc::Value albedo() const { return textures.color(object, {"albedo", "color"}, Vec3(1.F)); }
  desc::Value number(std::string_view name, float fallback) const {
    return textures.number(object, {name}, fallback);
  }
  /// "alpha", a number or a texture.
  desc::Value opacity() const {
    const auto json = object.find("alpha");
    return json ? textures.opacity(*json) : 1.F;
  }
  /// The material of the bsdf that a member is or names, if there is one. As in Tungsten, only the
  /// whole has bumps and media: bumps of parts are left out, and media are, with a warning.
  std::optional<desc::MaterialId> part(std::string_view name) const;
  /// `node` as a part of another.
  desc::MaterialId add(desc::Node node) const { return bsdfs.add(where(), std::move(node)); }
  /// `node` with its reflection multiplied by `tint`.
  desc::Node tinted(desc::Node node, const desc::Value& tint) const;
  void warn(const WarningKind& kind, const std::string& message) const {
    context.warnings.add(kind, where(), message, *object.text("type"));
  }
};

/// The material for a bsdf of this type; nothing if the type is unknown.
std::optional<desc::Node> make_bsdf(const std::string& type, const BsdfInputs& in);

/// "distribution", as our models name it; unsupported ones become the nearest, with a warning.
std::string distribution_of(const BsdfInputs& in);
/// "masking": Tungsten's facets hide each other by each side alone.
inline const std::string kMasking = "separable";

/// All types that `make_bsdf` knows.
std::vector<std::string> bsdf_types();

}  // namespace ajar::tungsten
