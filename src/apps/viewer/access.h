#pragma once
#include <string>
#include <string_view>

/// Access to the viewer (docs/develop/live-viewer.md).
namespace ajar::viewer {

/// 128 random bits of the operating system, in hexadecimal digits. Raises IoError if there are
/// none.
std::string make_token();

/// True for the same token; takes as long for any other of its length.
bool is_token(std::string_view token, std::string_view offered);

/// True for a `Host` header that leads here by an address, or by a name that is surely ours:
/// `localhost` and `own`. Other names may be made to point here by whoever owns them.
bool is_own_host(std::string_view host, std::string_view own);

/// True for an `Origin` header of the page that the server of `host` gives.
bool is_own_origin(std::string_view origin, std::string_view host);

/// Value of Content-Security-Policy for everything that is served.
inline constexpr const char* kContentPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

}  // namespace ajar::viewer
