#include "import/gltf/uri.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "core/printable_text.h"

namespace ajar::gltf {
namespace {

/// "%20" and the like (RFC 3986, section 2.1); other text stays.
std::string percent_decoded(std::string_view text) {
  std::string decoded;
  decoded.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned value = 0;
    const char* digits = text.data() + i + 1;
    if (text[i] == '%' && i + 2 < text.size() &&
        std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2) {
      decoded += static_cast<char>(value);
      i += 2;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

/// "https" of "https://…" (RFC 3986, section 3.1); empty for a relative reference.
std::string_view scheme_of(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  if (colon == uri.npos || colon == 0) return {};
  const auto in_scheme = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '+' || c == '-' || c == '.';
  };
  const std::string_view scheme = uri.substr(0, colon);
  return std::all_of(scheme.begin(), scheme.end(), in_scheme) ? scheme : std::string_view();
}

constexpr std::array<int, 256> make_base64_values() {
  std::array<int, 256> values{};
  values.fill(-1);
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < kDigits.size(); ++i) {
    values[static_cast<unsigned char>(kDigits[i])] = static_cast<int>(i);
  }
  return values;
}

}  // namespace

std::optional<std::string> decode_base64(std::string_view text) {
  static constexpr std::array<int, 256> kValues = make_base64_values();
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    const int value = kValues[static_cast<unsigned char>(c)];
    if (value < 0) return std::nullopt;
    bits = bits << 6U | static_cast<unsigned>(value);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 0xffU);
    }
  }
  return bytes;
}

UriTarget target_of(const Element& uri) {
  const std::string text = uri.text();
  const std::string_view scheme = scheme_of(text);
  if (scheme.empty()) return {{}, {}, percent_decoded(text)};
  if (scheme != "data") {
    throw IoError("it is looked for by \"" + printable_line(scheme.substr(0, 20)) +
                  ":\"; only files beside the scene and \"data:\" can be read");
  }
  const std::string_view rest = std::string_view(text).substr(scheme.size() + 1);
  const std::size_t comma = rest.find(',');
  if (comma == rest.npos) uri.fail("this data URI has no comma before its data");
  const std::string_view header = rest.substr(0, comma);
  if (!header.ends_with(";base64")) uri.fail("this data URI is not in base64");
  std::optional<std::string> data = decode_base64(rest.substr(comma + 1));
  if (!data) uri.fail("the base64 of this data URI is damaged");
  return {std::move(data), std::string(header.substr(0, header.find(';'))), {}};
}

}  // namespace ajar::gltf
