#include "apps/viewer/denoised_view.h"

#include <chrono>
#include <utility>

#include "session/job/resources.h"
#include "session/output/denoise_file.h"

namespace ajar::viewer {

namespace {

/// Rest after a picture, in times of what it took.
constexpr double kRest = 3.0;

}  // namespace

DenoisedView::DenoisedView(std::function<void()> done)
    : done_(std::move(done)),
      denoiser_(find_denoiser("auto", nullptr)),
      thread_([this] { work(); }) {}

DenoisedView::~DenoisedView() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void DenoisedView::want(std::shared_ptr<const Picture> picture) {
  if (picture == nullptr || !has_features(*picture)) return;
  {
    const std::lock_guard lock(mutex_);
    if (picture == filtered_) return;
    wanted_ = std::move(picture);
  }
  wake_.notify_all();
}

std::shared_ptr<const Picture> DenoisedView::latest() const {
  const std::lock_guard lock(mutex_);
  return latest_;
}

void DenoisedView::forget() {
  const std::lock_guard lock(mutex_);
  wanted_ = filtered_ = latest_ = nullptr;
}

void DenoisedView::work() {
  double seconds = 0.0;
  while (true) {
    std::shared_ptr<const Picture> picture;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return ended_ || wanted_ != nullptr; });
      // Most of the time is the render's.
      wake_.wait_for(lock, std::chrono::duration<double>(kRest * seconds),
                     [this] { return ended_.load(); });
      if (ended_) return;
      if (wanted_ == nullptr) continue;
      picture = std::exchange(wanted_, nullptr);
      filtered_ = picture;
    }
    const Stopwatch clock;
    auto result = std::make_shared<Picture>(*picture);
    if (!denoise_picture(*result, denoiser_, [this](double) { return !ended_; })) return;
    seconds = clock.seconds();
    {
      const std::lock_guard lock(mutex_);
      if (filtered_ != picture) continue;  // forgotten meanwhile
      latest_ = std::move(result);
    }
    done_();
  }
}

}  // namespace ajar::viewer
