#include "post/denoise/library_file.h"

#include <fcntl.h>
#include <link.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <vector>

#include "os/regular_file.h"

namespace ajar {

namespace {

using FileHeader = ElfW(Ehdr);
using Segment = ElfW(Phdr);
using Dynamic = ElfW(Dyn);

/// A file, of which parts are read.
class PartialFile {
 public:
  explicit PartialFile(const char* path)
      : descriptor_(::open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    struct stat status = {};
    if (descriptor_ >= 0 && ::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode)) {
      size_ = static_cast<std::uint64_t>(status.st_size);
    }
  }
  ~PartialFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  bool is_open() const { return descriptor_ >= 0; }
  bool has(std::uint64_t offset, std::uint64_t bytes) const {
    return offset <= size_ && bytes <= size_ - offset;
  }
  /// Empty if they are not all there.
  template <typename T>
  std::vector<T> read(std::uint64_t offset, std::uint64_t count) const {
    if (count > size_ / sizeof(T) || !has(offset, count * sizeof(T))) return {};
    std::vector<T> values(count);
    const auto bytes = static_cast<ssize_t>(count * sizeof(T));
    const ssize_t got =
        ::pread(descriptor_, values.data(), count * sizeof(T), static_cast<off_t>(offset));
    return got == bytes ? values : std::vector<T>();
  }

 private:
  int descriptor_;
  std::uint64_t size_ = 0;
};

std::optional<FileHeader> header_of(const PartialFile& file) {
  const std::vector<FileHeader> header = file.read<FileHeader>(0, 1);
  if (header.empty() || std::memcmp(header[0].e_ident, ELFMAG, SELFMAG) != 0) return std::nullopt;
  return header[0];
}

/// True if both are for the same kind of processor. The running program is the reference.
bool runs_here(const FileHeader& header) {
  const std::optional<FileHeader> own = header_of(PartialFile("/proc/self/exe"));
  return !own ||
         (own->e_ident[EI_CLASS] == header.e_ident[EI_CLASS] &&
          own->e_ident[EI_DATA] == header.e_ident[EI_DATA] && own->e_machine == header.e_machine);
}

/// True if the loader finds names and symbols by it.
bool leads_to_symbols(const std::vector<Dynamic>& dynamic, const std::vector<Segment>& segments) {
  const auto is_loaded = [&](std::uint64_t address) {
    return std::any_of(segments.begin(), segments.end(), [&](const Segment& segment) {
      return segment.p_type == PT_LOAD && address >= segment.p_vaddr &&
             address - segment.p_vaddr < segment.p_filesz;
    });
  };
  const auto end = std::find_if(dynamic.begin(), dynamic.end(),
                                [](const Dynamic& entry) { return entry.d_tag == DT_NULL; });
  const auto points_inside = [&](auto tag) {
    return std::any_of(dynamic.begin(), end, [&](const Dynamic& entry) {
      return entry.d_tag == tag && is_loaded(entry.d_un.d_ptr);
    });
  };
  return end != dynamic.end() && points_inside(DT_STRTAB) && points_inside(DT_SYMTAB);
}

}  // namespace

std::string library_complaint(const std::filesystem::path& path) {
  if (std::string complaint = reading_complaint(path.string()); !complaint.empty()) {
    return complaint;
  }
  const PartialFile file(path.c_str());
  if (!file.is_open()) return "it cannot be read";
  if (file.read<char>(0, 1).empty()) return "it is empty";
  const std::optional<FileHeader> header = header_of(file);
  if (!header) return "it is no library";
  if (header->e_type != ET_DYN || header->e_phentsize != sizeof(Segment)) return "it is no library";
  if (!runs_here(*header)) return "it is for another kind of processor";
  constexpr const char* kShort = "it is cut short";
  const std::vector<Segment> segments = file.read<Segment>(header->e_phoff, header->e_phnum);
  if (segments.empty() ||
      !std::all_of(segments.begin(), segments.end(), [&](const Segment& segment) {
        return file.has(segment.p_offset, segment.p_filesz);
      })) {
    return kShort;
  }
  // The table of sections is unused, but it is the end of the file.
  if (!file.has(header->e_shoff, std::uint64_t{header->e_shnum} * header->e_shentsize)) {
    return kShort;
  }
  const auto dynamic = std::find_if(segments.begin(), segments.end(), [](const Segment& segment) {
    return segment.p_type == PT_DYNAMIC;
  });
  if (dynamic == segments.end() ||
      !leads_to_symbols(file.read<Dynamic>(dynamic->p_offset, dynamic->p_filesz / sizeof(Dynamic)),
                        segments)) {
    return "it is damaged, or no library";
  }
  return {};
}

}  // namespace ajar
