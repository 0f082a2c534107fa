#pragma once
#include <netdb.h>

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace ajar {

/// Where a viewer listens.
struct ViewerAddress {
  std::string host;
  std::string port = "14158";  ///< tev's own
};
/// `HOST`, `HOST:PORT` or `[IPv6]:PORT`. Raises UsageError that names the option.
ViewerAddress parse_viewer(const std::string& option, std::string_view text);

/// A connection to which bytes are written, and which gives up as soon as `keep_going` says no (it
/// is asked at least ten times a second). Nothing here waits longer than that, raises a signal, or
/// keeps what the other side says.
class TcpStream {
 public:
  using KeepGoing = std::function<bool()>;

  TcpStream() = default;
  ~TcpStream() { close(); }
  TcpStream(const TcpStream&) = delete;
  TcpStream& operator=(const TcpStream&) = delete;

  /// Tries every address of the host. Empty if it is connected, else why it is not.
  std::string connect(const addrinfo* addresses, const KeepGoing& keep_going);
  bool is_open() const { return socket_ >= 0; }
  /// All of `bytes`; if that fails the connection is closed.
  bool write(std::string_view bytes, const KeepGoing& keep_going);
  /// Throws away what has arrived, and closes if the other side has.
  void drain();
  void close();

 private:
  std::string connect_to(const addrinfo& address, const KeepGoing& keep_going);
  int socket_ = -1;
};

/// The addresses of a host; raises UsageError, which names the option, if there are none.
using Addresses = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;
Addresses find_addresses(const std::string& option, const ViewerAddress& viewer);

}  // namespace ajar
