#include "session/preview/tcp_stream.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "core/error.h"

namespace ajar {

namespace {

constexpr int kPollMilliseconds = 100;
constexpr int kConnectPolls = 50;  // 5 s
constexpr int kDrainedAtOnce = 64;

std::string text_of(int reason) { return std::system_category().message(reason); }

[[noreturn]] void reject(const std::string& option, std::string_view text) {
  throw UsageError(option + ": \"" + std::string(text) +
                   "\" is not HOST:PORT, such as localhost:14158");
}

}  // namespace

ViewerAddress parse_viewer(const std::string& option, std::string_view text) {
  ViewerAddress viewer;
  std::string_view port;
  const std::size_t colon = text.rfind(':');
  if (text.starts_with('[')) {
    const std::size_t end = text.find(']');
    if (end == std::string_view::npos) reject(option, text);
    viewer.host = text.substr(1, end - 1);
    const std::string_view rest = text.substr(end + 1);
    if (rest.empty() || rest.front() == ':') {
      port = rest.empty() ? rest : rest.substr(1);
    } else {
      reject(option, text);
    }
    if (!rest.empty() && port.empty()) reject(option, text);
  } else if (colon == std::string_view::npos) {
    viewer.host = text;
  } else {
    viewer.host = text.substr(0, colon);
    port = text.substr(colon + 1);
    if (port.empty() || viewer.host.find(':') != std::string::npos) reject(option, text);
  }
  if (viewer.host.empty()) reject(option, text);
  int number = 0;
  for (const char digit : port) {
    if (digit < '0' || digit > '9') reject(option, text);
    number = 10 * number + (digit - '0');
    if (number > 65535) reject(option, text);
  }
  if (!port.empty()) {
    if (number == 0) reject(option, text);
    viewer.port = port;
  }
  return viewer;
}

Addresses find_addresses(const std::string& option, const ViewerAddress& viewer) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int error = getaddrinfo(viewer.host.c_str(), viewer.port.c_str(), &hints, &found);
  if (error != 0 || found == nullptr) {
    throw UsageError(option + ": there is no host \"" + viewer.host + "\" (" + gai_strerror(error) +
                     ")");
  }
  return {found, &freeaddrinfo};
}

std::string TcpStream::connect(const addrinfo* addresses, const KeepGoing& keep_going) {
  close();
  std::string reason = "no address";
  for (const addrinfo* one = addresses; one != nullptr && keep_going(); one = one->ai_next) {
    reason = connect_to(*one, keep_going);
    if (reason.empty()) return reason;
    close();
  }
  return reason;
}

std::string TcpStream::connect_to(const addrinfo& address, const KeepGoing& keep_going) {
  socket_ = ::socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC,
                     address.ai_protocol);
  if (socket_ < 0) return text_of(errno);
  if (::connect(socket_, address.ai_addr, address.ai_addrlen) == 0) return {};
  if (errno != EINPROGRESS) return text_of(errno);
  for (int i = 0; i < kConnectPolls && keep_going(); ++i) {
    pollfd wait{socket_, POLLOUT, 0};
    if (::poll(&wait, 1, kPollMilliseconds) <= 0) continue;
    int reason = 0;
    socklen_t size = sizeof(reason);
    ::getsockopt(socket_, SOL_SOCKET, SO_ERROR, &reason, &size);
    return reason == 0 ? std::string() : text_of(reason);
  }
  return text_of(ETIMEDOUT);
}

bool TcpStream::write(std::string_view bytes, const KeepGoing& keep_going) {
  while (!bytes.empty() && is_open()) {
    if (!keep_going()) {
      close();
      break;
    }
    // Two sides that both only write would wait for each other.
    drain();
    if (!is_open()) break;
    const ssize_t written = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      pollfd wait{socket_, POLLOUT, 0};
      ::poll(&wait, 1, kPollMilliseconds);
    } else if (errno != EINTR) {
      close();
    }
  }
  return is_open();
}

void TcpStream::drain() {
  std::array<char, 4096> unread{};
  for (int i = 0; i < kDrainedAtOnce && is_open(); ++i) {
    const ssize_t size = ::recv(socket_, unread.data(), unread.size(), 0);
    if (size > 0 || (size < 0 && errno == EINTR)) continue;
    if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return;
    close();
  }
}

void TcpStream::close() {
  if (is_open()) ::close(std::exchange(socket_, -1));
}

}  // namespace ajar
