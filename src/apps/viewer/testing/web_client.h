#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace ajar::viewer::testing {

/// Answer to a request: status and everything else as it came.
struct HttpAnswer {
  unsigned status = 0;
  std::string text;
};
/// `head` is the request as it is sent, with its empty line.
HttpAnswer send_request(std::uint16_t port, const std::string& head);

/// A page by hand: a socket of the server, waiting for whatever comes.
class WebClient {
 public:
  /// Raises std::runtime_error if the server does not take it.
  WebClient(std::uint16_t port, const std::string& origin);
  ~WebClient();
  WebClient(const WebClient&) = delete;
  WebClient& operator=(const WebClient&) = delete;

  struct Message {
    bool is_text = true;
    std::string bytes;
  };
  void send_text(const std::string& text);
  void send_binary(const std::string& bytes);
  /// Empty when the server has closed it.
  std::optional<Message> receive();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ajar::viewer::testing
