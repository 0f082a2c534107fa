#pragma once
#include <optional>
#include <string>
#include <string_view>

/// Numbers as text, whatever locale the host program has: with a point, without separators.
namespace ajar {

/// Shortest text of a number, but for whole numbers below 2^53, which have no exponent: 0.05,
/// 100000000.
std::string number_text(double value);

/// A share of one in per cent, with two digits, or all before the point: "0.51 %", "150 %".
std::string percent_text(double share);

/// The number that a whole text is, of which too small ones are 0 and too large ones infinite;
/// empty if it is none.
std::optional<double> number_of(std::string_view text);

/// The decimal number that people write for a float: 0.1 for 0.1F.
double decimal_of(float value);

}  // namespace ajar
