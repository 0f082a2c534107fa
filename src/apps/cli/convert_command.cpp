#include <fmt/format.h>

#include <filesystem>

#include "apps/cli/commands.h"
#include "apps/cli/messages.h"
#include "core/error.h"
#include "import/pbrt/pbrt_writer.h"
#include "session/output.h"
#include "session/scene_file.h"

namespace ajar::cli {

int convert(const ConvertArguments& arguments) {
  if (!arguments.output.ends_with(".pbrt")) {
    throw UsageError(arguments.output + ": the file to write must end in .pbrt");
  }
  std::error_code unknown;
  if (std::filesystem::equivalent(arguments.scene, arguments.output, unknown)) {
    throw UsageError(arguments.output + ": this would overwrite the scene that is read");
  }
  check_writable(arguments.output);
  Warnings warnings;
  const desc::SceneDesc scene = load_scene(arguments.scene, warnings);
  print_warnings(warnings, "");
  write_pbrt(scene, arguments.output);
  fmt::print("{}\n", arguments.output);
  return 0;
}

}  // namespace ajar::cli
