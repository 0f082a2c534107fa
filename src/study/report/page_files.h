#pragma once
#include <span>
#include <string_view>

namespace ajar {

/// A file of `src/study/report/page/`, embedded in the program by `cmake/embed.cmake`.
struct PageFile {
  std::string_view name;
  std::string_view content;
};
std::span<const PageFile> page_files();

}  // namespace ajar
