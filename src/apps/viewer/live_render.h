#pragma once
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "apps/viewer/live_state.h"
#include "session/options/render_spec.h"
#include "session/render.h"

namespace ajar::viewer {

/// When it pauses by itself.
struct StopAt {
  std::optional<double> samples;  ///< per pixel
  std::optional<double> seconds;  ///< time spent on this picture
  std::optional<double> error;    ///< relative, as estimated
};

enum class LivePhase { Loading, Preparing, Rendering, Paused, Finished, Failed };
const char* to_string(LivePhase phase);

/// All that is known about the picture.
struct LiveStatus {
  LivePhase phase = LivePhase::Loading;
  std::string message;      ///< reason for a failure
  std::uint32_t epoch = 0;  ///< another number: a picture that does not belong with the last
  Vec2i resolution{0, 0};
  Box2i crop;
  double samples = 0.0;  ///< per pixel, of all that is in the picture
  double seconds = 0.0;
  std::optional<double> rays_per_second, mutations_per_second;
  std::optional<double> error;  ///< relative
  bool error_is_lower_bound = true;
  std::optional<double> done;  ///< part of a preparation, 0…1
  LiveState state;
  CameraPose camera;
  StopAt stop_at;
  bool can_undo = false, can_redo = false;
  std::vector<std::pair<double, double>> history;  ///< seconds, error
};

/// The newest picture.
struct LivePicture {
  std::shared_ptr<const Picture> picture;  ///< null before there is one
  std::uint32_t epoch = 0;                 ///< see `LiveStatus`
  /// Pixels of the image, across and down, that each of its pixels stands for: while a mouse moves
  /// the camera the picture is a small one.
  int coarseness = 1;
};

/// A picture of a scene that is rendered until it is good, while a person changes it. Its sets of
/// regions are epochs: each is a render of its own, unbiased by itself, and they are added by their
/// numbers of samples, whatever they look like. All else that changes begins a new picture.
class LiveRender {
 public:
  struct Listener {
    virtual ~Listener() = default;
    /// Asked between passes, on the thread that renders: true if somebody would look at a picture.
    virtual bool wants_picture() = 0;
    /// There is a new picture, or something else is new. From any thread; must be quick.
    virtual void changed() = 0;
    virtual void note(bool is_warning, const std::string& text) = 0;
  };
  struct Options {
    std::string scene;
    RenderSpec spec;  ///< method, size, layers and so on to begin with
  };

  /// Loads the scene, and begins on a thread of its own. `listener` must outlive this. Raises as
  /// `load_scene` does.
  LiveRender(Options options, Listener& listener);
  ~LiveRender();
  LiveRender(const LiveRender&) = delete;
  LiveRender& operator=(const LiveRender&) = delete;

  // From any thread.

  /// Lets `edit` change what is rendered; what it raises changes nothing. Can be undone, except as
  /// the next change does if `is_passing`, as those of a mouse that moves.
  void change(const std::function<void(LiveState&)>& edit, bool is_passing = false);
  void undo() { step(undo_, redo_); }
  void redo() { step(redo_, undo_); }
  void restart();
  void pause(bool paused);
  void stop_at(const StopAt& limits);

  LiveStatus status() const;
  LivePicture picture() const;
  /// Null until there is a picture of it.
  std::shared_ptr<const BuiltScene> built_scene() const;
  /// The scene with its edits.
  std::shared_ptr<const LoadedScene> loaded_scene() const;

 private:
  struct Job;
  class Events;
  using States = std::vector<LiveState>;

  void work();
  void load();
  void begin(Job& job);
  void render(Job& job);
  RenderRequest request_of(const Job& job) const;
  std::string regions_file(const LiveState& state) const;
  void take(const Picture& picture);
  void keep_epoch();
  void fail(const std::string& why);
  void step(States& from, States& to);
  /// With the lock.
  void begin_anew(bool is_other_picture);
  bool has_reached_limits() const;

  Options options_;
  Listener& listener_;
  std::filesystem::path folder_;  ///< for files that renders read; goes with this

  mutable std::mutex mutex_;  // guards all below
  std::condition_variable wake_;
  bool ended_ = false;
  bool paused_ = false;
  bool is_passing_ = false;  ///< the last change was
  int coarseness_ = 1;       ///< coarseness of the render that runs
  int shown_coarseness_ = 1;
  std::uint64_t version_ = 1;  ///< counts what begins another render
  std::uint64_t begun_ = 0;    ///< version of the last that began
  LiveState state_;
  States undo_, redo_;
  StopAt stop_at_;
  LiveStatus status_;
  std::shared_ptr<LoadedScene> original_, loaded_;
  std::shared_ptr<const BuiltScene> built_;  ///< scene of the newest picture
  std::optional<LiveState> rendered_;        ///< state of the render that runs, or ran last
  std::shared_ptr<Render> current_;
  /// Epochs that have ended, and the one that runs.
  std::shared_ptr<const Picture> before_, newest_, shown_;
  double samples_before_ = 0.0, seconds_before_ = 0.0;
  double samples_ = 0.0;  ///< samples per pixel of `newest_`
  std::optional<double> error_before_;
  std::thread thread_;
};

/// A number that a render wrote into its picture; empty if it did not.
std::optional<double> metadata_number(const Picture& picture, const std::string& key);

/// Mean of two pictures of one scene by their samples: of what is light. All else is of `b`.
Picture add_epochs(const Picture& a, double samples_of_a, const Picture& b, double samples_of_b);

}  // namespace ajar::viewer
