#pragma once
#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "imageio/picture.h"
#include "post/denoise/denoiser.h"

namespace ajar::viewer {

/// Takes the noise out of pictures while they converge, on a thread of its own: of the newest that
/// it was given, one after the other.
class DenoisedView {
 public:
  /// `done` is called on that thread when there is a new one.
  explicit DenoisedView(std::function<void()> done);
  ~DenoisedView();
  DenoisedView(const DenoisedView&) = delete;
  DenoisedView& operator=(const DenoisedView&) = delete;

  /// A picture to be filtered, unless it was already. Null, and pictures without features of the
  /// scene, are left alone.
  void want(std::shared_ptr<const Picture> picture);
  /// The latest, with its layer "denoised"; null before the first.
  std::shared_ptr<const Picture> latest() const;
  /// Pictures are of another scene from now on.
  void forget();

 private:
  void work();

  std::function<void()> done_;
  std::shared_ptr<const Denoiser> denoiser_;
  std::atomic<bool> ended_{false};

  mutable std::mutex mutex_;  // guards all below
  std::condition_variable wake_;
  std::shared_ptr<const Picture> wanted_, filtered_, latest_;
  std::thread thread_;
};

}  // namespace ajar::viewer
