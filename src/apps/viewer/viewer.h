#pragma once
#include <atomic>
#include <condition_variable>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>

#include "apps/viewer/denoised_view.h"
#include "apps/viewer/live_render.h"
#include "apps/viewer/web_server.h"

namespace ajar {

/// The page's files, as they are built into the program; none where it was built without Node.
std::span<const viewer::ServedFile> viewer_files();

}  // namespace ajar

namespace ajar::viewer {

struct ViewerOptions {
  std::string scene;  ///< or the file of `picture`
  RenderSpec spec;
  std::shared_ptr<const Picture> picture;  ///< to be looked at; null: the scene is rendered
  std::string host = "127.0.0.1";
  std::uint16_t port = 0;    ///< 0: any that is free
  std::string folder = ".";  ///< where pictures are saved
  std::function<void(bool is_warning, const std::string& text)> tell;
};

/// A live render, or a finished picture, with its pages. The render asks for nothing but what pages
/// have room for: without any it develops no picture.
class Viewer final : WebServer::Listener, LiveRender::Listener {
 public:
  /// Raises IoError if it cannot listen there, and as `load_scene` does.
  explicit Viewer(ViewerOptions options);
  ~Viewer() override;
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// The address of the page, with the token.
  std::string address() const;
  /// Writes the picture as it is, "exr" or "png": its path. As `ajar render` has them, without
  /// noise in the layer "denoised" and in what is for the eye; that takes a while. Raises Error.
  std::string save(const std::string& format, const DisplayOptions& display = {});

 private:
  /// A page: what it shows, and what it has.
  struct Watcher {
    std::string layer;
    std::uint32_t sent = 0;         ///< number of the last frame
    std::uint32_t drawn = 0;        ///< the last that it has drawn
    const void* picture = nullptr;  ///< picture of the last frame
    std::uint32_t epoch = 0;
    int step = 1;       ///< step of the last frame
    int next_step = 1;  ///< as fast as the page takes them
    double sent_at = 0.0;
    std::size_t bytes = 0;  ///< size of the last frame
    bool is_new = true;
  };

  void opened(PageId page) override;
  void text(PageId page, std::string_view message) override;
  void binary(PageId page, std::string_view message) override;
  void closed(PageId page) override;
  bool wants_picture() override;
  void changed() override;
  void note(bool is_warning, const std::string& text) override;

  void answer(PageId page, const nlohmann::json& message);
  void change(const std::string& type, const nlohmann::json& message);
  void save_for(PageId page, const nlohmann::json& message);
  LivePicture shown() const;
  /// The picture that has a layer: another for the denoised one of a render.
  LivePicture shown(const std::string& layer, const LivePicture& newest) const;
  LiveStatus status() const;
  std::shared_ptr<const BuiltScene> built_scene() const {
    return live_ ? live_->built_scene() : nullptr;
  }
  nlohmann::json welcome() const;
  void acknowledge(PageId page, std::uint32_t frame);
  void send_to_all(const nlohmann::json& message, int slot);
  void run();
  void send_frames();
  void send_state();
  void tell(bool is_warning, const std::string& text) const;

  ViewerOptions options_;
  std::string token_;
  Stopwatch clock_;

  std::mutex mutex_;  // guards all below
  std::condition_variable wake_;
  std::map<PageId, Watcher> watchers_;
  bool is_changed_ = true;
  bool ended_ = false;
  double due_ = 0.0;  ///< when a picture may be wanted again

  std::unique_ptr<LiveRender> live_;  ///< null where there is a finished picture
  std::unique_ptr<WebServer> server_;
  std::unique_ptr<DenoisedView> denoised_;
  std::future<void> saving_;  ///< by the server's thread only
  // The viewer's thread has these.
  std::uint32_t denoised_epoch_ = 0;
  const LoadedScene* welcomed_ = nullptr;  ///< scene that pages were told of
  std::thread thread_;
};

}  // namespace ajar::viewer
