#pragma once
#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cstring>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace ajar {

/// A viewer for tests: takes connections on a port of its own and keeps the pictures it is sent, or
/// behaves badly.
class FakeViewer {
 public:
  enum class Manners {
    Good,      ///< reads everything
    Silent,    ///< accepts, and never reads
    Rude,      ///< closes after the first bytes
    Babbling,  ///< reads, and sends as much as it can
  };
  struct Picture {
    int width = 0;
    int height = 0;
    int creations = 0;
    int updates = 0;
    std::map<std::string, std::vector<float>> channels;
    std::size_t pixels() const {
      return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    std::size_t at(int x, int y) const {
      return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
             static_cast<std::size_t>(x);
    }
  };

  explicit FakeViewer(Manners manners, int port = 0) : manners_(manners) {
    listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int yes = 1;
    ::setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    socklen_t size = sizeof(address);
    auto* const any = reinterpret_cast<sockaddr*>(&address);
    if (::bind(listener_, any, size) != 0 || ::listen(listener_, 4) != 0 ||
        ::getsockname(listener_, any, &size) != 0) {
      throw std::runtime_error("the fake viewer cannot listen");
    }
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { serve(); });
  }
  ~FakeViewer() {
    stopping_ = true;
    thread_.join();
    ::close(listener_);
  }
  FakeViewer(const FakeViewer&) = delete;
  FakeViewer& operator=(const FakeViewer&) = delete;

  int port() const { return port_; }
  int connections() const { return connections_; }
  Picture picture(const std::string& name) const {
    const std::lock_guard lock(mutex_);
    const auto found = pictures_.find(name);
    return found == pictures_.end() ? Picture() : found->second;
  }
  /// Fault of the packets; empty if there is none.
  std::string fault() const {
    const std::lock_guard lock(mutex_);
    return fault_;
  }

 private:
  /// Reads fields from a packet; what is too short is a fault.
  class Reader {
   public:
    explicit Reader(const std::string& bytes) : bytes_(bytes) {}
    template <typename Number>
    Number number() {
      Number value;
      std::memcpy(&value, take(sizeof(value)), sizeof(value));
      return value;
    }
    std::string text() {
      const std::size_t end = bytes_.find('\0', at_);
      if (end == std::string::npos) throw std::runtime_error("a text has no end");
      std::string value = bytes_.substr(at_, end - at_);
      at_ = end + 1;
      return value;
    }
    std::vector<std::string> texts() {
      std::vector<std::string> values(static_cast<std::size_t>(number<std::int32_t>()));
      for (std::string& value : values) value = text();
      return values;
    }
    std::size_t rest() const { return bytes_.size() - at_; }
    const char* take(std::size_t size) {
      if (size > rest()) throw std::runtime_error("a packet is too short");
      at_ += size;
      return bytes_.data() + at_ - size;
    }

   private:
    const std::string& bytes_;
    std::size_t at_ = 0;
  };

  void serve() {
    while (!stopping_) {
      pollfd wait{listener_, POLLIN, 0};
      if (::poll(&wait, 1, 20) <= 0) continue;
      const int socket = ::accept(listener_, nullptr, nullptr);
      if (socket < 0) continue;
      ++connections_;
      talk(socket);
      ::close(socket);
    }
  }

  void talk(int socket) {
    std::string bytes;
    const std::string babble(1 << 16, '?');
    while (!stopping_) {
      if (manners_ == Manners::Babbling) {
        ::send(socket, babble.data(), babble.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
      }
      pollfd wait{socket, POLLIN, 0};
      if (manners_ == Manners::Silent) {
        ::poll(nullptr, 0, 20);
        continue;
      }
      if (::poll(&wait, 1, 20) <= 0) continue;
      char buffer[1 << 16];
      const ssize_t size = ::recv(socket, buffer, sizeof(buffer), 0);
      if (size <= 0 || manners_ == Manners::Rude) return;
      bytes.append(buffer, static_cast<std::size_t>(size));
      take_packets(bytes);
    }
  }

  void take_packets(std::string& bytes) {
    while (bytes.size() >= sizeof(std::uint32_t)) {
      std::uint32_t length = 0;
      std::memcpy(&length, bytes.data(), sizeof(length));
      if (bytes.size() < length) return;
      const std::lock_guard lock(mutex_);
      try {
        take_packet(bytes.substr(sizeof(length), length - sizeof(length)));
      } catch (const std::exception& error) {
        fault_ = error.what();
      }
      bytes.erase(0, length);
    }
  }

  void take_packet(const std::string& bytes) {
    Reader reader(bytes);
    const auto type = reader.number<std::uint8_t>();
    reader.number<std::uint8_t>();  // flag for showing it
    Picture& picture = pictures_[reader.text()];
    if (type == 4) {
      picture.width = reader.number<std::int32_t>();
      picture.height = reader.number<std::int32_t>();
      picture.channels.clear();
      ++picture.creations;
      for (const std::string& channel : reader.texts()) {
        picture.channels[channel].resize(picture.pixels());
      }
    } else if (type == 6) {
      update(picture, reader);
    } else {
      throw std::runtime_error("an unknown packet");
    }
    if (reader.rest() != 0) throw std::runtime_error("a packet is too long");
  }

  static void update(Picture& picture, Reader& reader) {
    ++picture.updates;
    const std::vector<std::string> channels = reader.texts();
    const auto x0 = reader.number<std::int32_t>();
    const auto y0 = reader.number<std::int32_t>();
    const auto width = reader.number<std::int32_t>();
    const auto height = reader.number<std::int32_t>();
    std::vector<std::int64_t> offsets(channels.size());
    std::vector<std::int64_t> strides(channels.size());
    for (auto& offset : offsets) offset = reader.number<std::int64_t>();
    for (auto& stride : strides) stride = reader.number<std::int64_t>();
    std::vector<float> values(reader.rest() / sizeof(float));
    if (!values.empty()) std::memcpy(values.data(), reader.take(reader.rest()), 4 * values.size());
    for (std::size_t c = 0; c < channels.size(); ++c) {
      std::vector<float>& pixels = picture.channels.at(channels[c]);
      for (int i = 0; i < width * height; ++i) {
        const int x = x0 + i % width;
        const int y = y0 + i / width;
        const auto from = static_cast<std::size_t>(offsets[c] + i * strides[c]);
        pixels.at(picture.at(x, y)) = values.at(from);
      }
    }
  }

  Manners manners_;
  int listener_ = -1;
  int port_ = 0;
  std::atomic<bool> stopping_{false};
  std::atomic<int> connections_{0};
  mutable std::mutex mutex_;
  std::map<std::string, Picture> pictures_;
  std::string fault_;
  std::thread thread_;
};

}  // namespace ajar
