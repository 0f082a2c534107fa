#pragma once
#include <optional>
#include <string>
#include <vector>

#include "image/flip.h"

/// What the commands of the program are told, as written on the command line. Each command returns
/// an exit code or raises an `Error`.
namespace ajar::cli {

struct RenderArguments {
  std::string scene;
  std::vector<std::string> outputs;
  std::string integrator;
  std::vector<std::string> assignments;  ///< KEY=VALUE
  std::string time, depth, resolution, crop, aovs;
  std::optional<std::uint64_t> spp;
  std::optional<double> target_error, scale;
  int threads = 0;
  std::string seed = "0";
  std::string stats;
  std::string progress = "auto";
  std::string tone_map = "srgb";
  float exposure = 0.F;
};
int render(const RenderArguments& arguments);

struct InfoArguments {
  std::string scene;
  bool json = false;
};
int info(const InfoArguments& arguments);

struct ConvertArguments {
  std::string scene;
  std::string output;
};
int convert(const ConvertArguments& arguments);

struct ListArguments {
  std::string kind;  ///< empty: all
  bool json = false;
};
int list(const ListArguments& arguments);

struct CompareArguments {
  std::string reference;
  std::vector<std::string> pictures;
  std::string metrics;  ///< empty: all
  double pixels_per_degree = kFlipPixelsPerDegree;
  bool json = false;
  std::string report;  ///< folder; empty: none
};
int compare(const CompareArguments& arguments);

struct StudyArguments {
  std::string file;
  std::string out;  ///< empty: a folder here, called like the study
};
int study(const StudyArguments& arguments);

}  // namespace ajar::cli
