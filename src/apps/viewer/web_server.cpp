#include "apps/viewer/web_server.h"

#include <fmt/format.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <deque>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <utility>

#include "apps/viewer/access.h"
#include "core/error.h"

namespace ajar::viewer {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using std::chrono::seconds;

constexpr std::size_t kMostText = 64 << 10;
/// A mask of a picture of 8192 × 8192 pixels.
constexpr std::size_t kMostBinary = (64U << 20) + 64;
constexpr std::size_t kMostPages = 16;
constexpr std::size_t kMostConnections = 64;
constexpr std::size_t kMostUnread = 1024;
constexpr seconds kPatience{10};

std::string_view view_of(beast::string_view text) { return {text.data(), text.size()}; }

const char* content_type(std::string_view path) {
  if (path.ends_with(".html")) return "text/html; charset=utf-8";
  if (path.ends_with(".js")) return "text/javascript; charset=utf-8";
  if (path.ends_with(".css")) return "text/css; charset=utf-8";
  return "application/octet-stream";
}

using Response = http::response<http::string_body>;

Response respond(http::status status, std::string_view type, std::string_view body) {
  Response response(status, 11);
  response.set(http::field::content_type, beast::string_view(type.data(), type.size()));
  response.set("Content-Security-Policy", kContentPolicy);
  response.set("X-Content-Type-Options", "nosniff");
  response.set("Referrer-Policy", "no-referrer");
  response.set("Cross-Origin-Opener-Policy", "same-origin");
  response.set(http::field::cache_control, "no-store");
  response.keep_alive(false);
  response.body() = body;
  response.prepare_payload();
  return response;
}

bool has_token(std::string_view message, const std::string& token) {
  const nlohmann::json hello = nlohmann::json::parse(message, nullptr, false);
  if (!hello.is_object() || hello.value("type", nlohmann::json()) != "hello") return false;
  const auto offered = hello.find("token");
  return offered != hello.end() && offered->is_string() &&
         is_token(token, offered->get<std::string>());
}

class Hub;

/// A socket with a page.
class Page : public std::enable_shared_from_this<Page> {
 public:
  Page(beast::tcp_stream stream, Hub& hub, PageId id)
      : socket_(std::move(stream)), hub_(hub), id_(id) {}

  void accept(const http::request<http::string_body>& request);
  void send(std::string message, bool is_text, int slot);
  void close(websocket::close_code code);

 private:
  struct Unsent {
    std::string bytes;
    bool is_text = true;
    int slot = 0;
  };

  void read();
  void take(std::string_view message, bool is_text);
  void write();
  void end();

  websocket::stream<beast::tcp_stream> socket_;
  Hub& hub_;
  PageId id_;
  beast::flat_buffer buffer_;
  std::deque<Unsent> unsent_;  ///< the first is being sent
  asio::steady_timer patience_{socket_.get_executor()};
  bool is_known_ = false;
  bool closes_ = false;
};

/// All connections; the server's thread has it.
class Hub {
 public:
  Hub(WebServerOptions options, WebServer::Listener& listener)
      : options_(std::move(options)), listener_(listener), acceptor_(context_) {}

  void listen();
  void run() { context_.run(); }
  void stop() { context_.stop(); }
  std::uint16_t port() const { return acceptor_.local_endpoint().port(); }
  void post(std::function<void()> work) { asio::post(context_, std::move(work)); }

  void log(const std::string& line) const {
    if (options_.log) options_.log(line);
  }
  const WebServerOptions& options() const { return options_; }
  WebServer::Listener& listener() { return listener_; }
  const ServedFile* file(std::string_view target) const;

  bool has_room() const { return pages_.size() < kMostPages; }
  void add(PageId id, std::shared_ptr<Page> page) { pages_.emplace(id, std::move(page)); }
  void remove(PageId id) { pages_.erase(id); }
  std::shared_ptr<Page> page(PageId id) const {
    const auto found = pages_.find(id);
    return found == pages_.end() ? nullptr : found->second;
  }
  PageId next_id() { return ++last_id_; }

  std::size_t connections = 0;

 private:
  void accept();

  WebServerOptions options_;
  WebServer::Listener& listener_;
  asio::io_context context_{1};
  tcp::acceptor acceptor_;
  std::map<PageId, std::shared_ptr<Page>> pages_;
  PageId last_id_ = 0;
};

/// A connection, until it is answered or becomes a page's.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(tcp::socket socket, Hub& hub) : stream_(std::move(socket)), hub_(hub) {
    ++hub_.connections;
  }
  ~Connection() { --hub_.connections; }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void read() {
    parser_.header_limit(16 << 10);
    parser_.body_limit(0);
    stream_.expires_after(kPatience);
    http::async_read(stream_, buffer_, parser_,
                     [self = shared_from_this()](const beast::error_code& error, std::size_t) {
                       if (!error) self->answer();
                     });
  }

 private:
  void answer() {
    const auto& request = parser_.get();
    const std::string_view host = view_of(request[http::field::host]);
    const std::string_view target = view_of(request.target());
    if (!is_own_host(host, hub_.options().host)) {
      return refuse(http::status::misdirected_request, "This server has another name.\n");
    }
    if (websocket::is_upgrade(request)) {
      if (target != "/socket" || !is_own_origin(view_of(request[http::field::origin]), host)) {
        return refuse(http::status::forbidden, "Only the server's own page may talk to it.\n");
      }
      if (!hub_.has_room()) {
        return refuse(http::status::service_unavailable, "There are too many pages open.\n");
      }
      const PageId id = hub_.next_id();
      const auto page = std::make_shared<Page>(std::move(stream_), hub_, id);
      hub_.add(id, page);
      page->accept(request);
      return;
    }
    if (request.method() != http::verb::get && request.method() != http::verb::head) {
      return refuse(http::status::method_not_allowed, "There is nothing to be sent here.\n");
    }
    const ServedFile* file = hub_.file(target);
    if (file == nullptr) return refuse(http::status::not_found, "There is no such file.\n");
    Response response = respond(http::status::ok, content_type(file->path), file->bytes);
    if (request.method() == http::verb::head) response.body().clear();
    write(std::move(response));
  }

  void refuse(http::status status, std::string_view why) {
    hub_.log(fmt::format("a request was refused ({})", static_cast<unsigned>(status)));
    write(respond(status, "text/plain; charset=utf-8", why));
  }

  void write(Response response) {
    response_ = std::move(response);
    stream_.expires_after(kPatience);
    http::async_write(stream_, response_,
                      [self = shared_from_this()](beast::error_code error, std::size_t) {
                        self->stream_.socket().shutdown(tcp::socket::shutdown_send, error);
                      });
  }

  beast::tcp_stream stream_;
  Hub& hub_;
  beast::flat_buffer buffer_{64 << 10};
  http::request_parser<http::string_body> parser_;
  Response response_;
};

// ---------------------------------------------------------------- pages

void Page::accept(const http::request<http::string_body>& request) {
  beast::get_lowest_layer(socket_).expires_never();
  socket_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
  socket_.read_message_max(kMostBinary);
  // Frames have megabytes; in pieces of 4 KiB they take longer.
  socket_.auto_fragment(false);
  socket_.async_accept(request, [self = shared_from_this()](const beast::error_code& error) {
    if (error) return self->end();
    self->patience_.expires_after(kPatience);
    self->patience_.async_wait([weak = self->weak_from_this()](const beast::error_code& stopped) {
      const auto page = weak.lock();
      if (!stopped && page && !page->is_known_) page->close(websocket::close_code::policy_error);
    });
    self->read();
  });
}

void Page::read() {
  socket_.async_read(
      buffer_, [self = shared_from_this()](const beast::error_code& error, std::size_t) {
        if (error) return self->end();
        const auto data = self->buffer_.cdata();
        self->take({static_cast<const char*>(data.data()), data.size()}, self->socket_.got_text());
        self->buffer_.clear();
        if (!self->closes_) self->read();
      });
}

void Page::take(std::string_view message, bool is_text) {
  if (is_text && message.size() > kMostText) {
    hub_.log(fmt::format("a message of {} bytes was dropped", message.size()));
    if (!is_known_) close(websocket::close_code::policy_error);
    return;
  }
  if (!is_known_) {
    if (!is_text || !has_token(message, hub_.options().token)) {
      hub_.log("a socket without the token was closed");
      return close(websocket::close_code::policy_error);
    }
    is_known_ = true;
    patience_.cancel();
    hub_.listener().opened(id_);
    return;
  }
  if (is_text) {
    hub_.listener().text(id_, message);
  } else {
    hub_.listener().binary(id_, message);
  }
}

void Page::send(std::string message, bool is_text, int slot) {
  if (closes_ || !is_known_) return;
  for (std::size_t i = 1; slot != 0 && i < unsent_.size(); ++i) {
    if (unsent_[i].slot == slot) {
      unsent_[i].bytes = std::move(message);
      return;
    }
  }
  if (unsent_.size() >= kMostUnread) {
    hub_.log("a page that does not read was closed");
    return end();
  }
  unsent_.push_back({std::move(message), is_text, slot});
  if (unsent_.size() == 1) write();
}

void Page::write() {
  socket_.text(unsent_.front().is_text);
  socket_.async_write(asio::buffer(unsent_.front().bytes),
                      [self = shared_from_this()](const beast::error_code& error, std::size_t) {
                        if (error) return self->end();
                        self->unsent_.pop_front();
                        if (!self->unsent_.empty()) self->write();
                      });
}

void Page::close(websocket::close_code code) {
  if (std::exchange(closes_, true)) return;
  socket_.async_close(code, [self = shared_from_this()](const beast::error_code&) { self->end(); });
}

void Page::end() {
  closes_ = true;
  patience_.cancel();
  beast::error_code error;
  beast::get_lowest_layer(socket_).socket().close(error);
  if (hub_.page(id_) == nullptr) return;
  hub_.remove(id_);
  if (is_known_) hub_.listener().closed(id_);
}

// ---------------------------------------------------------------- all of them

void Hub::listen() {
  try {
    tcp::resolver resolver(context_);
    const auto found =
        resolver.resolve(options_.host, std::to_string(options_.port), tcp::resolver::passive);
    const tcp::endpoint place = found.begin()->endpoint();
    acceptor_.open(place.protocol());
    acceptor_.set_option(asio::socket_base::reuse_address(true));
    acceptor_.bind(place);
    acceptor_.listen();
  } catch (const boost::system::system_error& error) {
    throw IoError(fmt::format("view: cannot listen at {}:{}: {}", options_.host, options_.port,
                              error.code().message()));
  }
  accept();
}

void Hub::accept() {
  acceptor_.async_accept([this](const beast::error_code& error, tcp::socket socket) {
    if (!acceptor_.is_open()) return;
    if (!error && connections < kMostConnections) {
      std::make_shared<Connection>(std::move(socket), *this)->read();
    }
    accept();
  });
}

const ServedFile* Hub::file(std::string_view target) const {
  std::string_view path = target.substr(0, target.find('?'));
  if (!path.starts_with('/')) return nullptr;
  path = path == "/" ? "index.html" : path.substr(1);
  for (const ServedFile& file : options_.files) {
    if (file.path == path) return &file;
  }
  return nullptr;
}

}  // namespace

struct WebServer::Parts {
  Parts(WebServerOptions options, Listener& listener) : hub(std::move(options), listener) {}

  Hub hub;
  std::thread thread;
};

WebServer::WebServer(WebServerOptions options, Listener& listener)
    : parts_(std::make_unique<Parts>(std::move(options), listener)) {
  parts_->hub.listen();
  parts_->thread = std::thread([&hub = parts_->hub] { hub.run(); });
}

WebServer::~WebServer() {
  parts_->hub.stop();
  parts_->thread.join();
}

std::uint16_t WebServer::port() const { return parts_->hub.port(); }

void WebServer::send_text(PageId page, std::string message, int slot) {
  parts_->hub.post([&hub = parts_->hub, page, message = std::move(message), slot]() mutable {
    if (const auto found = hub.page(page)) found->send(std::move(message), true, slot);
  });
}

void WebServer::send_binary(PageId page, std::string message) {
  parts_->hub.post([&hub = parts_->hub, page, message = std::move(message)]() mutable {
    if (const auto found = hub.page(page)) found->send(std::move(message), false, 0);
  });
}

void WebServer::close(PageId page) {
  parts_->hub.post([&hub = parts_->hub, page] {
    if (const auto found = hub.page(page)) found->close(websocket::close_code::normal);
  });
}

}  // namespace ajar::viewer
