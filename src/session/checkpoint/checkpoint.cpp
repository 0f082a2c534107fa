#include "session/checkpoint/checkpoint.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <utility>

#include "core/error.h"
#include "os/atomic_file.h"
#include "os/regular_file.h"
#include "session/checkpoint/checkpoint_archive.h"
#include "session/checkpoint/checkpoint_check.h"
#include "session/job/resources.h"
#include "session/version.h"

namespace ajar {

namespace {

static_assert(std::endian::native == std::endian::little, "checkpoints are little-endian");

constexpr std::uint32_t kCheckpointFormat = 23;
constexpr std::array<char, 16> kMagic = {'A', 'j', 'a', 'r', ' ', 'c', 'h', 'e',
                                         'c', 'k', 'p', 'o', 'i', 'n', 't', '\n'};

/// Beginning of a file, in this and all later formats.
struct Header {
  std::array<char, 16> magic = kMagic;
  std::uint32_t format = kCheckpointFormat;
  std::uint32_t content_checksum = 0;  ///< CRC-32 of all that follows the header
  std::uint64_t head_bytes = 0;        ///< size of cereal's part
  std::uint64_t sums = 0;              ///< 8 bytes each, after that
  std::uint64_t header_checksum = 0;   ///< CRC-32 of the fields before
};
static_assert(sizeof(Header) == 48, "no padding");

std::uint32_t checksum(std::uint32_t before, const void* bytes, std::size_t size) {
  return static_cast<std::uint32_t>(crc32_z(before, static_cast<const Bytef*>(bytes), size));
}

std::uint32_t checksum_of(const Header& header) {
  return checksum(0, &header, offsetof(Header, header_checksum));
}

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
  throw IoError(path + ": " + reason);
}

void read_bytes(std::ifstream& file, void* bytes, std::size_t size, const std::string& path) {
  if (size == 0) return;
  file.read(static_cast<char*>(bytes), static_cast<std::streamsize>(size));
  if (!file) refuse(path, "cannot be read to its end");
}

Header read_header(std::ifstream& file, std::uint64_t size, const std::string& path) {
  Header header;
  if (size < sizeof(header)) {
    std::array<char, 16> magic{};
    file.read(magic.data(), magic.size());
    const bool begins = size >= magic.size() && magic == kMagic;
    refuse(path, begins ? "is cut short" : "is not a checkpoint of Ajar");
  }
  read_bytes(file, &header, sizeof(header), path);
  if (header.magic != kMagic) refuse(path, "is not a checkpoint of Ajar");
  if (header.header_checksum != checksum_of(header)) {
    refuse(path, "is damaged (the checksum of its header does not fit)");
  }
  if (header.format != kCheckpointFormat) {
    refuse(path, fmt::format("is written in format {}, but ajar {} knows format {} only: it needs "
                             "{} version of Ajar",
                             header.format, version(), kCheckpointFormat,
                             header.format > kCheckpointFormat ? "a newer" : "an older"));
  }
  // Written so that no sum can overflow.
  const std::uint64_t content = size - sizeof(header);
  if (header.head_bytes > content ||
      header.sums != (content - header.head_bytes) / sizeof(std::int64_t) ||
      (content - header.head_bytes) % sizeof(std::int64_t) != 0) {
    refuse(path, fmt::format("is cut short or has something added: it has {} bytes", size));
  }
  return header;
}

std::string size_text(const RenderSettings& s) {
  return fmt::format("{}x{} pixels, crop {},{},{},{}", s.resolution.x, s.resolution.y, s.crop.min.x,
                     s.crop.min.y, s.crop.max.x + 1, s.crop.max.y + 1);
}

/// Text of a record in the words of the command line.
std::vector<std::pair<std::string, std::string>> described(const RenderRecord& record) {
  const RenderSettings& s = record.settings;
  std::vector<std::pair<std::string, std::string>> lines = {
      {"integrator", record.integrator},
      {"seed", std::to_string(s.seed)},
      {"size", size_text(s)},
      {"depth", fmt::format("{}:{}", s.min_depth, s.max_depth)},
      {"replicates", std::to_string(s.replicates)}};
  // The others have been resolved.
  for (const RenderOption& option : render_options()) {
    if (!option.decides_picture || !option.is_kept) continue;
    lines.emplace_back(option.name, option_text(option, record.spec));
  }
  for (const auto& [name, value] : record.parameters) lines.emplace_back(name, value);
  return lines;
}

bool same_layer(const LayerSpec& a, const LayerSpec& b) {
  return a.name == b.name && a.has_replicates == b.has_replicates && a.magnitude == b.magnitude &&
         a.holds_identities == b.holds_identities && a.part_of == b.part_of &&
         a.instead_of == b.instead_of && a.box_of == b.box_of;
}

}  // namespace

void write_checkpoint(const std::string& path, const Checkpoint& checkpoint,
                      std::span<const std::int64_t> sums) {
  const std::string head = archived([&](OutputArchive& archive) { archive(checkpoint); });
  const auto sum_bytes = std::as_bytes(sums);
  Header header;
  header.head_bytes = head.size();
  header.sums = sums.size();
  header.content_checksum = checksum(0, head.data(), head.size());
  header.content_checksum = checksum(header.content_checksum, sum_bytes.data(), sum_bytes.size());
  header.header_checksum = checksum_of(header);
  const std::array<std::span<const std::byte>, 3> pieces = {
      std::as_bytes(std::span(&header, 1)), std::as_bytes(std::span(head)), sum_bytes};
  write_file_atomically(path, pieces);
}

FileLock lock_checkpoint(const std::string& path) {
  return {lock_file_of(path), path + ": another render keeps its checkpoint there"};
}

Checkpoint read_checkpoint(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) refuse(path, "no such file");
  if (const std::string complaint = reading_complaint(path); !complaint.empty()) {
    refuse(path, complaint);
  }
  const std::uint64_t size = std::filesystem::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  if (error || !file) refuse(path, "cannot be read");
  const Header header = read_header(file, size, path);
  // A file may have holes, and so be larger than the disk.
  if (const std::uint64_t available = available_memory_bytes(); available > 0 && size > available) {
    refuse(path, fmt::format("needs {} MB of memory, of which {} MB are available", size / 1000000,
                             available / 1000000));
  }

  Checkpoint checkpoint;
  std::string head(header.head_bytes, '\0');
  read_bytes(file, head.data(), head.size(), path);
  checkpoint.sums.resize(header.sums);
  const auto sum_bytes = std::as_writable_bytes(std::span(checkpoint.sums));
  read_bytes(file, sum_bytes.data(), sum_bytes.size(), path);
  const std::uint32_t found =
      checksum(checksum(0, head.data(), head.size()), sum_bytes.data(), sum_bytes.size());
  if (found != header.content_checksum) refuse(path, "is damaged (its checksum does not fit)");
  try {
    unarchive(head, [&](InputArchive& archive) { archive(checkpoint); });
    check_sense(checkpoint);
  } catch (const std::exception& reason) {
    refuse(path, std::string("makes no sense: ") + reason.what());
  }
  return checkpoint;
}

Film film_of(Checkpoint& checkpoint, const Filter& filter, const std::string& path) {
  const RenderSettings& settings = checkpoint.render.settings;
  if (!film_fits(settings, checkpoint.layers, checkpoint.sums.size())) {
    refuse(path, "makes no sense: its film has another size");
  }
  try {
    Film film(settings.resolution, settings.crop, filter, settings.replicates, checkpoint.layers);
    film.take_raw(std::move(checkpoint.sums));
    return film;
  } catch (const std::invalid_argument& reason) {
    refuse(path, std::string("makes no sense: ") + reason.what());
  }
}

void check_resumable(const Checkpoint& checkpoint, const std::string& path, bool force) {
  if (checkpoint.merged.size() > 1) {
    throw UsageError(path +
                     ": is a merge of several seeds, of which none can go on; go on with "
                     "its parts, or render one more seed, and merge again");
  }
  if (checkpoint.version != version() && !force) {
    throw UsageError(fmt::format(
        "{}: was written by ajar {}, this is ajar {}, which may render other bits; --force goes on "
        "nevertheless",
        path, checkpoint.version, version()));
  }
}

void check_same_render(const RenderRecord& then, const RenderRecord& now, const std::string& path) {
  const auto lines_then = described(then);
  const auto lines_now = described(now);
  for (std::size_t i = 0; i < std::min(lines_then.size(), lines_now.size()); ++i) {
    if (lines_then[i] == lines_now[i]) continue;
    throw UsageError(fmt::format("{}: is of a render with {} {}, not {} {}", path,
                                 lines_then[i].first, lines_then[i].second, lines_now[i].first,
                                 lines_now[i].second));
  }
}

void check_scene(const Checkpoint& checkpoint, std::uint64_t hash,
                 std::span<const LayerSpec> layers, const std::string& path, bool force) {
  if (checkpoint.render.scene_hash != hash && !force) {
    throw UsageError(path +
                     ": the scene has changed since; --force goes on if it has only moved "
                     "to another folder");
  }
  if (!std::equal(layers.begin(), layers.end(), checkpoint.layers.begin(), checkpoint.layers.end(),
                  same_layer)) {
    throw UsageError(path +
                     ": the scene, or an image it uses, has changed since: it looks "
                     "different");
  }
}

}  // namespace ajar
