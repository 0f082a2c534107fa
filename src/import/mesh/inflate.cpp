#include "import/mesh/inflate.h"

#include <zlib.h>

#include <algorithm>
#include <limits>

#include "core/error.h"
#include "import/mesh/gzip.h"
#include "os/available_memory.h"

namespace ajar {
namespace {

/// Ends a zlib stream at the end of a scope.
class Inflater {
 public:
  explicit Inflater(StreamKind kind) {
    constexpr int kGzip = 16;  // zlib's way to ask for it
    ok_ = inflateInit2(&stream_, (kind == StreamKind::Gzip ? kGzip : 0) + MAX_WBITS) == Z_OK;
  }
  ~Inflater() {
    if (ok_) inflateEnd(&stream_);
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  bool ok() const { return ok_; }
  z_stream& stream() { return stream_; }

 private:
  z_stream stream_ = {};
  bool ok_ = false;
};

}  // namespace

std::optional<std::string> inflate_stream(std::string_view bytes, StreamKind kind,
                                          std::size_t max_size) {
  Inflater inflater(kind);
  if (!inflater.ok()) return std::nullopt;
  z_stream& stream = inflater.stream();
  std::string result;
  std::size_t used = 0;
  std::size_t consumed = 0;
  bool ended = false;
  while (true) {
    if (stream.avail_in == 0 && consumed < bytes.size()) {
      const std::size_t chunk =
          std::min<std::size_t>(bytes.size() - consumed, std::numeric_limits<uInt>::max());
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + consumed));
      stream.avail_in = static_cast<uInt>(chunk);
      consumed += chunk;
    }
    if (ended) {
      if (kind == StreamKind::Zlib) break;
      // Another member may follow; anything else after the end is padding, as gzip treats it.
      const std::size_t left = bytes.size() - consumed + stream.avail_in;
      if (left < 2 || !is_gzip(bytes.substr(bytes.size() - left))) break;
      if (inflateReset(&stream) != Z_OK) return std::nullopt;
      ended = false;
    }
    if (used == result.size()) {
      if (used >= max_size) return std::nullopt;
      const std::size_t wanted = std::max<std::size_t>(2 * used, 4 * bytes.size() + 4096);
      const std::size_t size = std::min(wanted, max_size);
      // Old and new contents are there together while they move.
      if (const std::string preparation_cut = memory_shortage(used + size);
          !preparation_cut.empty()) {
        throw IoError("unpacked, this file " + preparation_cut);
      }
      result.resize(size);
    }
    const std::size_t space =
        std::min<std::size_t>(result.size() - used, std::numeric_limits<uInt>::max());
    stream.next_out = reinterpret_cast<Bytef*>(result.data() + used);
    stream.avail_out = static_cast<uInt>(space);
    const int status = inflate(&stream, Z_NO_FLUSH);
    used += space - stream.avail_out;
    if (status == Z_STREAM_END) {
      ended = true;
    } else if (status != Z_OK) {
      return std::nullopt;  // damaged, or no more input (Z_BUF_ERROR)
    }
  }
  result.resize(used);
  return result;
}

}  // namespace ajar
