#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace ajar::viewer {

/// A file of the page, in memory.
struct ServedFile {
  std::string_view path;  ///< without the first slash; index.html is the page
  std::string_view bytes;
};

/// An open page.
using PageId = std::uint64_t;

struct WebServerOptions {
  std::string host = "127.0.0.1";  ///< address or name to listen on
  std::uint16_t port = 0;          ///< 0: any that is free
  std::string token;
  std::span<const ServedFile> files;
  std::function<void(const std::string&)> log;  ///< lines about what was refused; may be empty
};

/// Serves a page, and a socket to each that has the token (docs/develop/live-viewer.md). It has one
/// thread of its own; listeners are called there, and must be quick.
class WebServer {
 public:
  struct Listener {
    virtual ~Listener() = default;
    virtual void opened(PageId page) = 0;
    virtual void text(PageId page, std::string_view message) = 0;
    virtual void binary(PageId page, std::string_view message) = 0;
    virtual void closed(PageId page) = 0;
  };

  /// Listens at once. `listener` must outlive this. Raises IoError if that place is taken or not
  /// ours.
  WebServer(WebServerOptions options, Listener& listener);
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  std::uint16_t port() const;

  // From any thread. Pages that are gone are no error.

  /// A text. With a `slot` other than 0 it takes the place of one of the same slot that has not
  /// been sent yet: a slow page gets the newest alone. A page that leaves too many others unread is
  /// closed.
  void send_text(PageId page, std::string message, int slot = 0);
  void send_binary(PageId page, std::string message);
  void close(PageId page);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ajar::viewer
