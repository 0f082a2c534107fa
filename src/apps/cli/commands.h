#pragma once
#include <optional>
#include <string>
#include <vector>

#include "image/flip.h"
#include "session/job/ranks.h"
#include "session/options/display.h"
#include "session/options/option_values.h"

/// What the commands of the program are told, as written on the command line. Each command returns
/// an exit code or raises an `Error`.
namespace ajar::cli {

/// What `render` and `resume` have in common: nothing of it decides the picture.
struct RunArguments {
  std::vector<std::string> outputs;
  std::string time;
  std::optional<std::uint64_t> spp;
  std::optional<TargetError> target_error;
  int threads = 0;
  std::string stats;
  std::string progress = "auto";
  std::string tone_map;              ///< empty: srgb, or as before
  std::optional<Exposure> exposure;  ///< empty: 0, or as before
  std::string denoiser;              ///< empty: auto, or as before
  std::string checkpoint;            ///< empty: none, or the one that is resumed
  std::string checkpoint_every = "60s";
  std::string output_every;
  std::string preview;  ///< HOST:PORT of a viewer; empty: none
  bool force = false;
  Ranks* ranks = nullptr;  ///< who render together; null: this process alone
};

/// A scene as the user names it.
struct SceneArguments {
  std::string scene;
  std::vector<std::string> definitions;  ///< KEY=VALUE
};

struct RenderArguments {
  SceneArguments scene;
  RunArguments run;
  std::string integrator;
  std::vector<std::string> assignments;  ///< KEY=VALUE
  std::string depth, resolution, crop, filter, aovs;
  std::optional<double> scale;
  std::string seed = "0";
  std::string share;   ///< K/N; empty: all
  std::string resume;  ///< empty: begin anew
};
int render(const RenderArguments& arguments);

struct ResumeArguments {
  std::string checkpoint;
  RunArguments run;
  std::string scene;  ///< empty: where it was
};
int resume(const ResumeArguments& arguments);

struct MergeArguments {
  std::vector<std::string> checkpoints;
  std::vector<std::string> outputs;
  std::string checkpoint;  ///< empty: none
  std::string stats;
  std::string tone_map = "srgb";
  Exposure exposure;
  std::string denoiser = "auto";
  bool force = false;
};
int merge(const MergeArguments& arguments);

struct DenoiseArguments {
  std::string picture;
  std::vector<std::string> outputs;
  std::string denoiser = "auto";
  std::string tone_map = "srgb";
  Exposure exposure;
};
int denoise(const DenoiseArguments& arguments);

struct InfoArguments {
  SceneArguments scene;
  bool json = false;
};
int info(const InfoArguments& arguments);

struct ConvertArguments {
  SceneArguments scene;
  std::string output;
};
int convert(const ConvertArguments& arguments);

struct ListArguments {
  std::string kind;  ///< empty: all
  std::string name;  ///< name of an integrator, to see its parameters; empty: all
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
