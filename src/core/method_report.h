#pragma once
#include <nlohmann/json_fwd.hpp>

namespace ajar {

/// A method's report of itself and of its run: an object of named numbers, texts, lists and tables
/// (lists of objects with the same names), in reading order; null is unknown. Statistics, viewers
/// and other languages show it without knowing who made it; the names are those of the manual
/// (docs/command-line.md).
using MethodReport = nlohmann::ordered_json;

}  // namespace ajar
