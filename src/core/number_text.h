#pragma once
#include <string>

/// Numbers in messages.
namespace ajar {

/// As short as can be, but for whole numbers below 2^53, which have no exponent: 0.05, 100000000.
std::string number_text(double value);

/// A share of one in per cent, with two digits, or all before the point: "0.51 %", "150 %".
std::string percent_text(double share);

}  // namespace ajar
