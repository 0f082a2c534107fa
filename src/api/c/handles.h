#pragma once
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "ajar/ajar.h"
#include "ajar/c.h"
#include "core/error.h"

/// Objects behind the handles of ajar/c.h, and the exit of errors from it.
struct ajar_scene {
  ajar::v0::Scene scene;
};

struct ajar_picture {
  ajar::v0::Picture picture;
};

namespace ajar::c {

/// A render on a thread of its own.
class BackgroundRender {
 public:
  BackgroundRender(const v0::Scene& scene, const v0::Settings& settings);
  /// Stops it, and waits until it has.
  ~BackgroundRender();
  BackgroundRender(const BackgroundRender&) = delete;
  BackgroundRender& operator=(const BackgroundRender&) = delete;

  /// True if it has ended within so many seconds (below 0: waits for the end). Raises its error.
  bool wait(double seconds);
  bool is_done() const;
  void stop() { render_.stop(); }
  std::optional<v0::Picture> picture() const;
  v0::Progress progress() const { return render_.progress(); }
  std::string statistics() const { return render_.statistics(); }
  struct Messages {
    std::vector<std::string> warnings, troubles, notes;
  };
  Messages messages() const;

 private:
  void run();
  /// Callbacks that keep its messages.
  v0::Callbacks listeners();

  mutable std::mutex mutex_;
  std::condition_variable ended_;
  bool is_done_ = false;
  std::exception_ptr error_;
  std::optional<v0::Picture> result_;
  Messages messages_;
  v0::Render render_;
  std::thread thread_;  ///< the last: it uses all others
};

/// Calls `work`, and makes a code and `ajar_last_error` of what it raises.
int guarded(const std::function<void()>& work);

/// The object behind a pointer that a caller gave. Raises UsageError that names the argument if
/// that is none.
template <typename T>
T& given(T* pointer, const char* argument) {
  if (pointer == nullptr) throw UsageError(std::string(argument) + " is NULL");
  return *pointer;
}

/// Gives a text out, for the caller to free.
void give_text(const std::string& text, char** out);

}  // namespace ajar::c

struct ajar_render {
  ajar::c::BackgroundRender render;
};
