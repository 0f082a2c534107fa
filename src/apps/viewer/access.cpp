#include "apps/viewer/access.h"

#include <sys/random.h>

#include <array>
#include <boost/asio/ip/address.hpp>

#include "core/error.h"

namespace ajar::viewer {

namespace {

/// Without the port, and without the brackets of an IPv6 address.
std::string_view name_of_host(std::string_view host) {
  if (host.starts_with('[')) return host.substr(1, host.find(']') - 1);
  return host.substr(0, host.find(':'));
}

bool is_address(std::string_view name) {
  boost::system::error_code error;
  boost::asio::ip::make_address(std::string(name), error);
  return !error;
}

}  // namespace

std::string make_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw IoError("view: the system has no random numbers for the address");
  }
  std::string token;
  for (const unsigned char byte : bytes) {
    token += "0123456789abcdef"[byte >> 4];
    token += "0123456789abcdef"[byte & 15];
  }
  return token;
}

bool is_token(std::string_view token, std::string_view offered) {
  if (token.size() != offered.size()) return false;
  unsigned differences = 0;
  for (std::size_t i = 0; i < token.size(); ++i) {
    differences |= static_cast<unsigned>(static_cast<unsigned char>(token[i]) ^
                                         static_cast<unsigned char>(offered[i]));
  }
  return differences == 0;
}

bool is_own_host(std::string_view host, std::string_view own) {
  const std::string_view name = name_of_host(host);
  return name == "localhost" || (!name.empty() && name == own) || is_address(name);
}

bool is_own_origin(std::string_view origin, std::string_view host) {
  for (const std::string_view scheme : {"http://", "https://"}) {
    if (origin.starts_with(scheme)) return origin.substr(scheme.size()) == host;
  }
  return false;
}

}  // namespace ajar::viewer
