#pragma once
#include <nlohmann/json_fwd.hpp>

namespace ajar {

/// What a method tells of itself and of how it fared: an object of named numbers, texts, lists and
/// tables (lists of objects with the same names), in the order in which to read them; null is what
/// is not known. Statistics, viewers and other languages show it without knowing who made it; the
/// names are those of the manual (docs/command-line.md).
using MethodReport = nlohmann::ordered_json;

}  // namespace ajar
