#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ajar {

/// Choice of the channels of an image that are the picture.
struct ColorChannels {
  int first = 0;
  int count = 1;   ///< 1 (grey), or 3 one after the other
  int alpha = -1;  ///< -1: there is none
  /// Says which were taken, where others are as likely to be meant; else empty.
  std::string remark;
  /// Distance from the usual names of the picture: 0 for R, G, B, or Y.
  int doubt = 0;
};

/// Chooses among channels that are sorted as `comes_before` has it: red, green and blue, or
/// luminance, of the image itself, else of a layer, those first whose names say that they are the
/// whole ("rgba", "beauty", "combined"); then X, Y, Z; then whatever there is, depth and alpha
/// last. Source for names: "Technical Introduction to OpenEXR", openexr.com.
ColorChannels color_channels(const std::vector<std::string>& names);

/// The order of channels: layer by layer, in each red, green, blue, alpha, and the others by name.
bool comes_before(const std::string& channel, const std::string& other);

/// "diffuse." of "diffuse.R"; "" of "R".
std::string_view prefix_of_channel(std::string_view channel);

/// True if the layer or part of that name is the picture as a whole, by the habits of programs.
bool is_whole_picture(std::string_view layer);

}  // namespace ajar
