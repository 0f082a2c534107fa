#pragma once
#include <optional>
#include <string>

#include "apps/cli/commands.h"
#include "session/checkpoint.h"
#include "session/render_setup.h"

namespace ajar::cli {

/// A render to be carried out, new or resumed.
struct RunOrder {
  std::string scene;
  RunArguments run;
  WorkShare share;
  /// What was asked for; empty: go on with `resumed` as it was, within `budget`.
  std::optional<RenderRequest> request;
  bool all_aovs = false;         ///< of a request: "all" means what the method can make
  bool size_from_scene = false;  ///< the user did not choose it
  Budget budget;
  /// Where to go on. With a request, too, it must be of the same render.
  std::optional<Checkpoint> resumed;
  std::string resumed_from;  ///< its file
  /// Of the checkpoint to be written.
  std::optional<FileLock> lock;
};

/// To be called before a checkpoint is read that may be gone on with, and then written.
void lock_checkpoint_of(RunOrder& order);

/// The limits that the command line gives. Raises UsageError.
Budget budget_of(const RunArguments& arguments);

/// Raises UsageError for a curve that is none.
Display display_of(const std::string& tone_map, const Exposure& exposure);

/// Renders; returns the exit code or raises an `Error`.
int carry_out(RunOrder order);

}  // namespace ajar::cli
