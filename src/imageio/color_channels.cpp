#include "imageio/color_channels.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <tuple>

#include "core/printable_text.h"

namespace ajar {

namespace {

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return small;
}

template <std::size_t N>
std::size_t index_in(const std::array<std::string_view, N>& words, std::string_view word) {
  return static_cast<std::size_t>(std::find(words.begin(), words.end(), word) - words.begin());
}

std::string last_part(std::string_view channel) {
  return in_small_letters(channel.substr(prefix_of_channel(channel).size()));
}

constexpr std::size_t kAlpha = 3;
constexpr std::size_t kNoColor = 4;

/// 0 to 3 for red, green, blue and alpha.
std::size_t color_rank(const std::string& channel) {
  constexpr std::array<std::string_view, 4> kLetters = {"r", "g", "b", "a"};
  constexpr std::array<std::string_view, 4> kWords = {"red", "green", "blue", "alpha"};
  const std::string last = last_part(channel);
  return std::min(index_in(kLetters, last), index_in(kWords, last));
}

bool is_depth(const std::string& channel) {
  constexpr std::array<std::string_view, 4> kDepths = {"z", "zback", "depth", "deep"};
  return index_in(kDepths, last_part(channel)) < kDepths.size();
}

/// Meanings of a channel, with those after it in its layer, the likeliest first.
enum class Kind { Colors, Luminance, Coordinates, Other, Depth, Alpha };

struct Candidate {
  std::size_t first = 0;
  int count = 1;
  Kind kind = Kind::Other;
  bool is_in_layer = false;
  bool is_part_of_picture = false;  ///< part of a layer that is not known to be the whole

  bool is_picture() const { return kind <= Kind::Coordinates; }
  auto order() const {
    const Kind group = is_picture() ? Kind::Colors : kind;
    return std::tuple(group, is_in_layer, is_part_of_picture, kind);
  }
};

Candidate candidate_at(const std::vector<std::string>& names, std::size_t i) {
  const std::string_view prefix = prefix_of_channel(names[i]);
  const auto is_run = [&](const auto& fits) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (i + k >= names.size() || prefix_of_channel(names[i + k]) != prefix ||
          !fits(names[i + k], k)) {
        return false;
      }
    }
    return true;
  };
  constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
  const std::string last = last_part(names[i]);
  const bool follows_x =
      i > 0 && prefix_of_channel(names[i - 1]) == prefix && last_part(names[i - 1]) == "x";
  Candidate result;
  result.first = i;
  result.is_in_layer = !prefix.empty();
  result.is_part_of_picture =
      result.is_in_layer && !is_whole_picture(prefix.substr(0, prefix.size() - 1));
  if (is_run([](const auto& name, std::size_t k) { return color_rank(name) == k; })) {
    result.kind = Kind::Colors;
    result.count = 3;
  } else if (is_run([&](const auto& name, std::size_t k) { return last_part(name) == kAxes[k]; })) {
    result.kind = Kind::Coordinates;
    result.count = 3;
  } else if (last == "y" && !follows_x) {
    result.kind = Kind::Luminance;
  } else if (color_rank(names[i]) == kAlpha) {
    result.kind = Kind::Alpha;
  } else if (is_depth(names[i])) {
    result.kind = Kind::Depth;
  } else if (is_run([](const auto& name, std::size_t) {
               return color_rank(name) == kNoColor && !is_depth(name);
             })) {
    result.count = 3;
  }
  return result;
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) {
    text += (i > 0 ? ", \"" : "\"") + printable_line(names[i]) + "\"";
  }
  return names.size() > kMost ? text + ", …" : text;
}

}  // namespace

ColorChannels color_channels(const std::vector<std::string>& names) {
  ColorChannels result;
  if (names.empty()) return result;
  Candidate best = candidate_at(names, 0);
  int rivals = 0;  // number of equally good candidates
  for (std::size_t i = 1; i < names.size(); ++i) {
    const Candidate other = candidate_at(names, i);
    if (other.order() < best.order()) {
      best = other;
      rivals = 0;
    } else if (other.order() == best.order()) {
      ++rivals;
    }
  }
  result.first = static_cast<int>(best.first);
  result.count = best.count;
  const std::string_view prefix = prefix_of_channel(names[best.first]);
  std::size_t used = static_cast<std::size_t>(best.count);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (prefix_of_channel(names[i]) != prefix || color_rank(names[i]) != kAlpha) continue;
    result.alpha = static_cast<int>(i);
    if (best.kind != Kind::Alpha) ++used;
    break;
  }
  const bool is_plain = best.kind <= Kind::Luminance && !best.is_in_layer;
  if (!is_plain && used < names.size() && (rivals > 0 || !best.is_picture())) {
    const auto first = names.begin() + result.first;
    result.remark = "of its channels " + listed(names) + ", " +
                    listed({first, first + result.count}) +
                    (best.count == 1 ? " is shown" : " are shown");
  }
  if (!is_plain) {
    result.doubt = 1 + (best.is_picture() ? static_cast<int>(best.is_part_of_picture)
                                          : 2 + static_cast<int>(best.kind));
  }
  return result;
}

bool comes_before(const std::string& channel, const std::string& other) {
  const auto key = [](const std::string& name) {
    return std::tuple(prefix_of_channel(name), color_rank(name), std::string_view(name));
  };
  return key(channel) < key(other);
}

std::string_view prefix_of_channel(std::string_view channel) {
  const std::size_t dot = channel.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : channel.substr(0, dot + 1);
}

bool is_whole_picture(std::string_view layer) {
  constexpr std::array<std::string_view, 11> kNames = {"rgba",      "rgb",     "beauty", "combined",
                                                       "composite", "color",   "colour", "c",
                                                       "main",      "default", "image"};
  const std::string last = last_part(layer);  // "Combined" of "ViewLayer.Combined"
  return last.empty() || index_in(kNames, last) < kNames.size();
}

}  // namespace ajar
