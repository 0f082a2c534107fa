#pragma once
#include <string>

/// Numbers in messages.
namespace ajar {

/// As short as can be, but for whole numbers, which have no exponent: 0.05, 100000000.
std::string number_text(double value);

/// A share of one in per cent, with two digits, or more where it is large: "0.5 %", "150 %".
std::string percent_text(double share);

}  // namespace ajar
