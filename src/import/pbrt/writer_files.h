#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace ajar::pbrt {

/// Files that a pbrt file names, in the folder "<stem>_<kind>" beside it. They are named by their
/// contents, so that all that is there stays as it is: files of an earlier version of the scene,
/// of the scene that is read, and of others.
class WriterFiles {
 public:
  /// `scene`: path of the pbrt file, absolute. `kind`: "meshes".
  WriterFiles(const std::filesystem::path& scene, const std::string& kind);
  /// Absolute path of a file of these bytes, "<begin>_<hash><extension>", written unless it is
  /// there. Raises IoError if it cannot be, or if another file has its name.
  std::string write(std::string_view begin, std::string_view bytes,
                    std::string_view extension) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace ajar::pbrt
