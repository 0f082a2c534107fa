#pragma once
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "session/job/pass_observer.h"
#include "session/job/resources.h"
#include "session/output/output.h"
#include "session/output/picture_filter.h"
#include "session/output/repeated_writing.h"
#include "session/preview/tcp_stream.h"

namespace ajar {

struct PreviewOptions {
  ViewerAddress viewer;
  std::string name;  ///< name of the picture in the viewer
  double film_scale = 1.0;
  std::vector<std::string> aovs;  ///< see `develop`
  double every = 1.0;             ///< seconds, at least, between pictures
  double patience = 2.0;          ///< seconds that the last picture may take to be sent
  double seconds_to_retry = 2.0;  ///< if there is no viewer
  RepeatedWriting::Say note;      ///< tells the user
};

/// Shows the picture while it is rendered, in a viewer that speaks tev's protocol. The render only
/// copies the sums of its film, and only if a viewer is there and has taken the picture before;
/// developing, connecting and sending are done on a thread of its own. A viewer that is slow gets
/// fewer pictures, one that comes later or again gets the whole one; nothing it does can stop,
/// delay or change the render. Of a picture only the regions that have changed are sent.
class Preview final : public PassObserver {
 public:
  /// `integrator` must outlive this. Raises UsageError if there is no such host; that nobody
  /// listens there is only told.
  Preview(PreviewOptions options, const Integrator& integrator);
  ~Preview() override;
  Preview(const Preview&) = delete;
  Preview& operator=(const Preview&) = delete;

  /// Filter of pictures from now on, but those of `show`; null: unfiltered.
  void filter_by(std::shared_ptr<PictureFilter> filter);
  /// A picture of its own, before there is one of the film: as soon as a viewer is there, unless
  /// another comes first.
  void show(Picture picture);

  bool wants_picture(const JobState& state) override;
  void see_picture(const Film& film, const JobState& state) override;
  /// The last picture, if a viewer is there; returns when it is sent or patience has ended.
  void show_last(const Film& film, const JobState& state);

 private:
  void serve();
  void serve_connection();
  bool send(const Picture& picture);
  bool keeps_going() const { return !stopping_.load(std::memory_order_relaxed); }
  void hand_over(const Film& film, const JobState& state);

  PreviewOptions options_;
  const Integrator& integrator_;
  Addresses addresses_;
  Stopwatch clock_;
  double due_ = 0.0;                ///< time of the next picture; by the render's thread only
  std::atomic<bool> ready_{false};  ///< a viewer is there and has taken all there was
  std::atomic<bool> stopping_{false};
  std::atomic<double> seconds_to_develop_{0.0};

  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Picture> look_;  ///< guarded: of `show`, not yet taken
  bool has_picture_ =
      false;  ///< guarded: `filter_` and what follows are the thread's until it is not
  std::shared_ptr<PictureFilter> filter_;
  std::optional<Film> film_;
  Development scales_;
  std::uint64_t samples_ = 0;

  TcpStream stream_;                   ///< the thread's, as all below
  std::vector<std::string> channels_;  ///< channels of the viewer's picture
  std::vector<std::size_t> regions_;   ///< hashes of it
  std::thread thread_;
};

}  // namespace ajar
