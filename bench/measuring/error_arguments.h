#pragma once
#include <optional>
#include <string>
#include <vector>

namespace ajar::bench {

/// Arguments of `ajar_error_bench`.
struct ErrorArguments {
  double seconds = 8.0;         ///< CPU-seconds of each render, all threads together
  int repeats = 3;              ///< seeds
  int size = 256;               ///< pixels of the longer side
  std::optional<double> scale;  ///< factor of the scene's own resolution, instead of `size`
  std::optional<int> depth;     ///< longest paths in edges, instead of the scene's
  std::string filter = "box";   ///< "box": one pixel wide; "scene": the scene's own
  int threads = 0;              ///< 0: as many as the machine offers
  std::string reference_folder = "build/bench-references";
  double reference_seconds = 120.0;  ///< CPU-seconds behind a reference, over all its parts
  std::string reference_variant = "bdpt";
  bool shared_reference = false;
  std::vector<std::string> scenes;    ///< empty: the default ones
  std::vector<std::string> variants;  ///< never empty
};

/// Command line: `OPTIONS SCENE… -- VARIANT…`.
/// Reads the arguments (without the name of the program). Empty if help was asked for, which is
/// then printed. Raises UsageError.
std::optional<ErrorArguments> parse_error_arguments(const std::vector<std::string>& arguments);

}  // namespace ajar::bench
