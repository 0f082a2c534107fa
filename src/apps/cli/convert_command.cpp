#include "apps/cli/commands.h"
#include "apps/cli/messages.h"
#include "core/error.h"
#include "core/warnings.h"
#include "import/format.h"
#include "session/output/output.h"
#include "session/output/written_paths.h"
#include "session/scenes/scene_file.h"

namespace ajar::cli {

int convert(const ConvertArguments& arguments) {
  const Format& format = format_to_write(arguments.output);
  check_writable(arguments.output);
  Warnings warnings;
  const desc::SceneDesc scene =
      load_scene(arguments.scene.scene, warnings, arguments.scene.spec.definitions);
  check_spares({arguments.output}, scene.files);
  print_warnings(warnings, arguments.scene.scene);
  const std::string unknown = format.write(scene, arguments.output);
  print_path(arguments.output);
  if (!unknown.empty()) print_note(unknown);
  return 0;
}

}  // namespace ajar::cli
