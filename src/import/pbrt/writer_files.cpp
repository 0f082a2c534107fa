#include "import/pbrt/writer_files.h"

#include <fmt/format.h>

#include "core/content_hash.h"
#include "core/error.h"
#include "os/atomic_file.h"
#include "os/regular_file.h"

namespace ajar::pbrt {

namespace fs = std::filesystem;

WriterFiles::WriterFiles(const fs::path& scene, const std::string& kind)
    : folder_(scene.parent_path() / (scene.stem().string() + "_" + kind)) {}

std::string WriterFiles::write(std::string_view begin, std::string_view bytes,
                               std::string_view extension) const {
  ContentHash hash;
  hash.bytes(bytes.data(), bytes.size());
  std::string path =
      (folder_ / fmt::format("{}_{:016x}{}", begin, hash.result(), extension)).string();
  std::error_code error;
  if (fs::exists(path, error)) {
    if (fs::file_size(path, error) == bytes.size() && read_file(path).view() == bytes) return path;
    throw IoError("\"" + path + "\" is another file, which is not replaced");
  }
  fs::create_directories(folder_, error);
  if (error) {
    throw IoError("cannot make the folder \"" + folder_.string() + "\": " + error.message());
  }
  write_file_atomically(path, bytes);
  return path;
}

}  // namespace ajar::pbrt
