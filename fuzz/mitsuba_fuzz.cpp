// Any text must either import or raise one of our errors. Files are served from memory; on the disk
// nothing is found.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "import/mitsuba/mitsuba_import.h"

using namespace std::string_view_literals;
/// A grid of one number, 1.
constexpr std::string_view kGrid =
    "VOL\3\1\0\0\0\1\0\0\0\1\0\0\0\1\0\0\0\1\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80?\0\0\x80?"
    "\0\0\x80?"
    "\0\0\x80?"sv;

/// Two strands of two points.
constexpr std::string_view kHair =
    "BINARY_HAIR\4\0\0\0"
    "\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80?\0\0\0\0\0\0\0\0"
    "\0\0\x80\x7f\0\0\0\0\0\0\x80?\0\0\0\0\0\0\x80?\0\0\x80?\0\0\0\0"sv;

/// Curves for a target of XML, as text in its last comment.
std::string_view last_comment(std::string_view text) {
  constexpr std::string_view kBegin = "<!--";
  const std::size_t begin = text.rfind(kBegin);
  if (begin == text.npos) return {};
  text.remove_prefix(begin + kBegin.size());
  return text.substr(0, text.find("-->"));
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  ajar::Warnings warnings;
  try {
    const ajar::desc::SceneDesc scene =
        ajar::import_mitsuba_text(text, "fuzz.xml", "/nonexistent", warnings,
                                  [&](const std::string& path) -> std::optional<std::string_view> {
                                    if (path == "/nonexistent/m.obj")
                                      return "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
                                    if (path == "/nonexistent/self.xml") return text;
                                    if (path == "/nonexistent/self.obj") return text;
                                    if (path == "/nonexistent/self.serialized") return text;
                                    if (path == "/nonexistent/comment.txt")
                                      return last_comment(text);
                                    if (path == "/nonexistent/a.hair") return kHair;
                                    if (path == "/nonexistent/a.txt")
                                      return "0 0 0 1\n1 0 0 1\n2 1 0 .5\n3 0 0 .1\n";
                                    if (path == "/nonexistent/a.vol") return kGrid;
                                    if (path == "/nonexistent/a.spd") return "400 0.5\n700 1\n";
                                    return std::nullopt;
                                  });
    ajar::desc::hash(scene);
  } catch (const ajar::SceneError&) {
  } catch (const ajar::IoError&) {
  }
  return 0;
}
