// Any bytes must either be a serialized mesh of Mitsuba's or raise one of our errors. A fuzzer does
// not compress: after an odd first byte come the bytes of one mesh, which are packed as such a file
// has them.
#include <zlib.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "import/mesh/validate_mesh.h"
#include "import/mitsuba/serialized.h"

namespace {

template <typename Number>
void append(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

/// A file of one mesh.
std::string file_of(std::string_view body, std::uint16_t version) {
  std::string file;
  append<std::uint16_t>(file, 0x041C);
  append(file, version);
  std::vector<Bytef> packed(compressBound(body.size()));
  uLongf size = packed.size();
  compress2(packed.data(), &size, reinterpret_cast<const Bytef*>(body.data()), body.size(), 1);
  file.append(reinterpret_cast<const char*>(packed.data()), size);
  // Where the mesh begins, and how many there are.
  if (version == 4) {
    append<std::uint64_t>(file, 0);
  } else {
    append<std::uint32_t>(file, 0);
  }
  append<std::uint32_t>(file, 1);
  return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string file(reinterpret_cast<const char*>(data), size);
  if (size > 0 && data[0] % 2 == 1) {
    file = file_of(std::string_view(file).substr(1), data[0] % 4 == 1 ? 3 : 4);
  }
  std::vector<ajar::Warning> remarks;
  try {
    ajar::desc::Mesh mesh = ajar::mitsuba::read_serialized(file, "fuzz.serialized", 0);
    ajar::validate_mesh(mesh, {}, remarks);
  } catch (const ajar::SceneError&) {
  } catch (const ajar::IoError&) {
  }
  return 0;
}
