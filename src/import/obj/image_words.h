#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace ajar::obj {

/// An option of an image, with its values: "-o", {"0.5", "1"}.
struct ImageOption {
  std::string name;
  std::vector<std::string> values;
};

/// Words behind one as `map_Kd`: options and the name of a file, which may have spaces in it.
/// Source: Wavefront, Advanced Visualizer manual, appendix B1. Options behind the name, as some
/// programs write them, count, too.
struct ImageWords {
  std::vector<ImageOption> options;
  std::string file;
};
ImageWords image_words(std::string_view text);

/// Options in the form of tinyobjloader: with three numbers for `-o` and `-s`, without options that
/// have no effect; the channel of alpha, "m", is "a".
std::string in_full(const ImageWords& words);

/// True if an image follows such a word.
bool names_image(std::string_view keyword);

}  // namespace ajar::obj
