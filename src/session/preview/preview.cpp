#include "session/preview/preview.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <functional>
#include <limits>
#include <new>
#include <string_view>
#include <utility>

#include "session/heuristics.h"
#include "session/preview/tev_packets.h"

namespace ajar {

namespace {

constexpr int kRegionSize = 128;

std::chrono::duration<double> seconds(double value) { return std::chrono::duration<double>(value); }

}  // namespace

Preview::Preview(PreviewOptions options, const Integrator& integrator)
    : options_(std::move(options)),
      integrator_(integrator),
      addresses_(find_addresses("--preview", options_.viewer)),
      thread_([this] { serve(); }) {}

Preview::~Preview() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Preview::filter_by(std::shared_ptr<PictureFilter> filter) {
  const std::lock_guard lock(mutex_);
  filter_ = std::move(filter);
}

void Preview::show(Picture picture) {
  {
    const std::lock_guard lock(mutex_);
    look_ = std::move(picture);
  }
  changed_.notify_all();
}

bool Preview::wants_picture(const JobState& /*state*/) {
  return ready_.load(std::memory_order_relaxed) && clock_.seconds() >= due_;
}

void Preview::see_picture(const Film& film, const JobState& state) {
  if (wants_picture(state)) hand_over(film, state);
}

void Preview::hand_over(const Film& film, const JobState& state) {
  const double begun = clock_.seconds();
  try {
    const std::lock_guard lock(mutex_);
    // The viewer may have gone since.
    if (!ready_) return;
    look_.reset();
    film_ = film;
    samples_ = state.mean_samples();
    scales_ = development_of(film, integrator_, samples_);
    has_picture_ = true;
    ready_ = false;
  } catch (const std::bad_alloc&) {
    due_ = std::numeric_limits<double>::infinity();
    if (options_.note) options_.note("no preview: there is not enough memory for it");
    return;
  }
  changed_.notify_all();
  const double now = clock_.seconds();
  const double cost = now - begun + seconds_to_develop_.load();
  due_ = now + std::max(options_.every, cost / SessionHeuristics::kMostForPreviews);
}

void Preview::show_last(const Film& film, const JobState& state) {
  const double end = clock_.seconds() + options_.patience;
  const auto wait_until_taken = [&] {
    std::unique_lock lock(mutex_);
    const auto is_taken = [this] { return !has_picture_; };
    return changed_.wait_for(lock, seconds(std::max(0.0, end - clock_.seconds())), is_taken);
  };
  if (!wait_until_taken()) return;
  hand_over(film, state);
  wait_until_taken();
}

void Preview::serve() {
  std::string failure;
  const std::string where = options_.viewer.host + ":" + options_.viewer.port;
  const auto tell = [&](const std::string& text) {
    if (text != failure && options_.note) options_.note(text);
    failure = text;
  };
  while (keeps_going()) {
    const std::string reason = stream_.connect(addresses_.get(), [this] { return keeps_going(); });
    if (!keeps_going()) return;
    if (reason.empty()) {
      tell("the picture is shown by the viewer at " + where);
      try {
        serve_connection();
      } catch (const std::exception& error) {
        // There is no memory for it, most likely; the render may still have enough.
        tell(std::string("no preview: ") + error.what());
      }
      stream_.close();
    } else {
      tell(fmt::format("no viewer at {}: {}; it will be tried again", where, reason));
    }
    std::unique_lock lock(mutex_);
    ready_ = false;
    has_picture_ = false;
    changed_.notify_all();
    changed_.wait_for(lock, seconds(options_.seconds_to_retry), [this] { return !keeps_going(); });
  }
}

void Preview::serve_connection() {
  regions_.clear();
  {
    const std::lock_guard lock(mutex_);
    ready_ = true;
  }
  while (keeps_going() && stream_.is_open()) {
    std::optional<Picture> look;
    {
      std::unique_lock lock(mutex_);
      changed_.wait_for(lock, seconds(0.25),
                        [this] { return has_picture_ || look_ || !keeps_going(); });
      look = std::exchange(look_, std::nullopt);
      if (!has_picture_ && !look) {
        lock.unlock();
        stream_.drain();
        continue;
      }
    }
    if (look) {
      if (!send(*look)) return;
      continue;
    }
    const Stopwatch clock;
    Picture picture = develop(*film_, scales_, samples_, options_.film_scale, options_.aovs);
    if (filter_) {
      filter_->add_layers(picture, [this](double) { return keeps_going(); });
    }
    seconds_to_develop_ = clock.seconds();
    if (!send(picture)) return;
    {
      const std::lock_guard lock(mutex_);
      has_picture_ = false;
      ready_ = true;
    }
    changed_.notify_all();
  }
}

bool Preview::send(const Picture& picture) {
  const TcpStream::KeepGoing keep_going = [this] { return keeps_going(); };
  const std::vector<std::string> channels = channel_names(picture);
  const bool is_first = regions_.empty() || channels != channels_;
  if (is_first) {
    regions_.clear();
    channels_ = channels;
    const std::string packet = create_image_packet(options_.name, picture.resolution, channels);
    if (!stream_.write(packet, keep_going)) return false;
  }
  std::size_t number = 0;
  const Box2i& crop = picture.crop;
  for (int y = crop.min.y; y <= crop.max.y; y += kRegionSize) {
    for (int x = crop.min.x; x <= crop.max.x; x += kRegionSize, ++number) {
      const Box2i region(Vec2i(x, y), Vec2i(std::min(x + kRegionSize - 1, crop.max.x),
                                            std::min(y + kRegionSize - 1, crop.max.y)));
      const std::string packet = update_image_packet(options_.name, picture, region);
      const std::size_t hash = std::hash<std::string_view>{}(packet);
      if (is_first) regions_.push_back(hash + 1);
      if (regions_[number] == hash) continue;
      regions_[number] = hash;
      if (!stream_.write(packet, keep_going)) return false;
    }
  }
  return true;
}

}  // namespace ajar
