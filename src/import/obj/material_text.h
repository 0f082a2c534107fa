#pragma once
#include <string>
#include <string_view>

#include "core/warnings.h"

namespace ajar::obj {

/// Words of our own in it, for warnings on the materials that a face has: an image whose colour is
/// black, and a material without any colour.
inline constexpr char kHiddenImage[] = "ajar_hidden_image";
inline constexpr char kColorless[] = "ajar_colorless";

/// A material file rewritten for tinyobjloader where that reads it differently:
///
/// - one number for a colour is a grey, not a red,
/// - an image of `Kd` without its factor, or with a black one, has the factor 1,
/// - a material without any colour is light grey,
/// - `-o` and `-s` of an image may have one or two numbers, and options may follow its name; those
///   of which nothing comes are left out,
/// - a colour of gloss without `illum` is a material with gloss.
///
/// Lines whose value is no number, as `Kd spectral` and `d -halo`, are left out, with a warning.
/// There are warnings of colours beyond 0 to 1, and of materials that are there twice.
std::string understood_materials(std::string_view text, const std::string& name,
                                 Warnings& warnings);

}  // namespace ajar::obj
