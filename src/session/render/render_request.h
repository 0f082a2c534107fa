#pragma once
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "os/file_lock.h"
#include "session/checkpoint/checkpoint.h"
#include "session/job/interrupts.h"
#include "session/job/ranks.h"
#include "session/options/render_spec.h"
#include "session/render/resolved_render.h"
#include "session/scenes/loaded_scene.h"

namespace ajar {

/// A render that is wanted, new or to be gone on with.
struct RenderRequest {
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  /// A file, or builtin:NAME (`load_scene`). If it is `loaded`: what that is called.
  std::string scene;
  /// Ready, and shared with other renders of it; null: `scene` is loaded for this one.
  std::shared_ptr<LoadedScene> loaded;
  RenderSpec spec;
  /// Go on with `resumed` as it was: of what decides the picture `spec` has what that says.
  bool as_before = false;
  bool may_lack_layers = false;   ///< without those that the method does not make
  bool default_pictures = false;  ///< if none is named: `default_outputs`
  /// Where to go on. With a request, too, it must be of the same render.
  std::optional<Checkpoint> resumed;
  std::string resumed_from;  ///< its file
  /// Lock of the checkpoint to be written (`lock_checkpoint_of`).
  std::optional<FileLock> lock;

  double show_every = kNever;  ///< seconds between `RenderEvents::picture`
  Ranks* ranks = nullptr;      ///< processes that render together; null: this process alone
  /// External stop counter, of a signal handler, say, to which `Render::stop` adds. Null: the
  /// render's own.
  InterruptCount* interrupts = nullptr;
  /// Counts who wants the files of the picture written as it is; may be null.
  const InterruptCount* picture_requests = nullptr;

  /// True but for ranks that only help another.
  bool is_root() const { return ranks == nullptr || ranks->is_root(); }
};

/// To be called before a checkpoint is read that may be gone on with, and then written. Raises
/// IoError if another program writes there.
void lock_checkpoint_of(RenderRequest& request);

/// Lets a request go on with the checkpoint of that name, if there is such a file. Raises IoError
/// as `read_checkpoint` does.
bool resume_if_there(const std::string& path, RenderRequest& request);

/// Goes on with the render of a checkpoint as it was: what `ajar resume` takes is the order's where
/// that has it, all else that is kept is the checkpoint's, and where none is to be written, it is
/// written again.
/// Raises IoError as `lock_checkpoint` and `read_checkpoint` do.
void resume_from(const std::string& path, RenderRequest& request);

}  // namespace ajar
