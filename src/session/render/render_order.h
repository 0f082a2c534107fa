#pragma once
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/work_share.h"
#include "os/file_lock.h"
#include "session/checkpoint/checkpoint.h"
#include "session/job/budget.h"
#include "session/job/interrupts.h"
#include "session/job/ranks.h"
#include "session/options/display.h"
#include "session/preview/tcp_stream.h"
#include "session/render/render_setup.h"
#include "session/scenes/loaded_scene.h"

namespace ajar {

/// What a render writes, and where it is shown; nothing unless it is named. None of it decides the
/// picture.
struct RenderFiles {
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  std::vector<std::string> pictures;
  bool default_pictures = false;   ///< if none is named: `default_outputs`
  double pictures_every = kNever;  ///< seconds, while rendering
  /// Of pictures for the eye; empty: srgb, or as before.
  std::string tone_map;
  std::optional<Exposure> exposure;  ///< likewise; empty: 0, or as before
  std::string denoiser;  ///< as `find_denoiser` takes it; likewise; empty: none, or as before
  std::string checkpoint;
  double checkpoint_every = 60.0;  ///< seconds
  std::string statistics;          ///< JSON
  std::optional<ViewerAddress> preview;

  std::string tone_map_name() const { return tone_map.empty() ? "srgb" : tone_map; }
  std::string denoiser_name() const { return denoiser.empty() ? "none" : denoiser; }
  /// Raises UsageError for a curve that is none.
  Display display() const;
  /// Pictures, statistics and checkpoint.
  std::vector<std::string> all() const;
};

/// A render that is wanted, new or to be gone on with.
struct RenderOrder {
  /// A file, or builtin:NAME (`load_scene`). If it is `loaded`: what that is called.
  std::string scene;
  std::map<std::string, std::string> definitions;  ///< for `load_scene`
  /// Ready, and shared with other renders of it; null: `scene` is loaded for this one.
  std::shared_ptr<LoadedScene> loaded;
  /// What was asked for; empty: go on with `resumed` as it was, within `budget`.
  std::optional<RenderRequest> request;
  bool all_aovs = false;         ///< of a request: "all" means what the method can make
  bool size_from_scene = false;  ///< the user did not choose it: what is too large is its fault
  Budget budget;                 ///< without a request
  WorkShare share;
  /// Where to go on. With a request, too, it must be of the same render.
  std::optional<Checkpoint> resumed;
  std::string resumed_from;  ///< its file
  bool force = false;        ///< go on with checkpoints of other versions or scenes
  /// Of the checkpoint to be written (`lock_checkpoint_of`).
  std::optional<FileLock> lock;

  RenderFiles files;
  int threads = 0;                          ///< 0: as many as the machine offers
  double show_every = RenderFiles::kNever;  ///< seconds between `RenderEvents::picture`
  Ranks* ranks = nullptr;                   ///< who render together; null: this process alone
  /// Counts who wants it to stop, beside `Render::stop`, which adds to it: signals, say. Null: that
  /// alone.
  InterruptCount* interrupts = nullptr;
  /// Counts who wants the files of the picture written as it is; may be null.
  const InterruptCount* picture_requests = nullptr;

  /// True but for ranks that only help another.
  bool is_root() const { return ranks == nullptr || ranks->is_root(); }
};

/// To be called before a checkpoint is read that may be gone on with, and then written. Raises
/// IoError if another program writes there.
void lock_checkpoint_of(RenderOrder& order);

/// Lets a request go on with the checkpoint of that name, if there is such a file. Raises IoError
/// as `read_checkpoint` does.
bool resume_if_there(const std::string& path, RenderOrder& order);

/// Goes on with the render of a checkpoint as it was: what `order` leaves empty (scene, budget,
/// pictures, display) is the checkpoint's, and where none is to be written, it is written again.
/// Raises IoError as `lock_checkpoint` and `read_checkpoint` do.
void resume_from(const std::string& path, RenderOrder& order);

}  // namespace ajar
