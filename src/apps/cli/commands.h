#pragma once
#include <string>
#include <vector>

#include "image/flip.h"
#include "session/job/ranks.h"
#include "session/options/render_spec.h"

/// Arguments of the program's commands, as written on the command line. Each command returns
/// an exit code or raises an `Error`.
namespace ajar::cli {

/// A scene as the user names it.
struct SceneArguments {
  std::string scene;
  RenderSpec spec;  ///< options of the scene and of its renders
};

/// Manner of a render: nothing of it decides the picture.
struct RunArguments {
  std::string progress = "auto";
  Ranks* ranks = nullptr;  ///< processes that render together; null: this process alone
};

struct RenderArguments {
  SceneArguments scene;
  RunArguments run;
};
int render(const RenderArguments& arguments);

struct ResumeArguments {
  std::string checkpoint;
  SceneArguments scene;  ///< empty: where it was
  RunArguments run;
};
int resume(const ResumeArguments& arguments);

struct MergeArguments {
  std::vector<std::string> checkpoints;
  RenderSpec spec;
};
int merge(const MergeArguments& arguments);

struct DenoiseArguments {
  std::string picture;
  RenderSpec spec;
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

struct ViewArguments {
  SceneArguments scene;
  std::string host = "127.0.0.1";
  int port = 0;  ///< 0: any that is free
};
int view(const ViewArguments& arguments);

struct StudyArguments {
  std::string file;
  std::string out;  ///< empty: a folder here, called like the study
};
int study(const StudyArguments& arguments);

}  // namespace ajar::cli
