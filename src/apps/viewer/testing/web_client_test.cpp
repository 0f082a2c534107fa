#include "apps/viewer/testing/web_client.h"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <stdexcept>

namespace ajar::viewer::testing {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using asio::ip::tcp;

tcp::endpoint place(std::uint16_t port) { return {asio::ip::make_address("127.0.0.1"), port}; }

}  // namespace

HttpAnswer send_request(std::uint16_t port, const std::string& head) {
  asio::io_context context;
  tcp::socket socket(context);
  socket.connect(place(port));
  asio::write(socket, asio::buffer(head));
  HttpAnswer answer;
  beast::error_code error;
  std::array<char, 4096> part{};
  while (!error) {
    const std::size_t size = socket.read_some(asio::buffer(part), error);
    answer.text.append(part.data(), size);
  }
  if (answer.text.size() > 12)
    answer.status = static_cast<unsigned>(std::stoi(answer.text.substr(9, 3)));
  return answer;
}

struct WebClient::Parts {
  asio::io_context context;
  websocket::stream<tcp::socket> socket{context};
};

WebClient::WebClient(std::uint16_t port, const std::string& origin)
    : parts_(std::make_unique<Parts>()) {
  parts_->socket.next_layer().connect(place(port));
  parts_->socket.set_option(websocket::stream_base::decorator(
      [origin](websocket::request_type& request) { request.set("Origin", origin); }));
  parts_->socket.read_message_max(256 << 20);
  parts_->socket.handshake("127.0.0.1:" + std::to_string(port), "/socket");
}

WebClient::~WebClient() {
  beast::error_code ignored;
  parts_->socket.next_layer().close(ignored);
}

void WebClient::send_text(const std::string& text) {
  parts_->socket.text(true);
  parts_->socket.write(asio::buffer(text));
}

void WebClient::send_binary(const std::string& bytes) {
  parts_->socket.text(false);
  parts_->socket.write(asio::buffer(bytes));
}

std::optional<WebClient::Message> WebClient::receive() {
  beast::flat_buffer buffer;
  beast::error_code error;
  parts_->socket.read(buffer, error);
  if (error) return std::nullopt;
  return Message{parts_->socket.got_text(), beast::buffers_to_string(buffer.data())};
}

}  // namespace ajar::viewer::testing
