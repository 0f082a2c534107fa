// Any bytes must either have a grid of floats or raise one of our errors. A file with all levels of
// a tree is larger than the random input of a fuzzer: after an odd first byte come places in a
// valid file, and the bytes to write there.
#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/IO.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "import/pbrt/nanovdb_file.h"

namespace {

std::string good_file() {
  nanovdb::GridBuilder<float> builder(0.F);
  auto accessor = builder.getAccessor();
  accessor.setValue(nanovdb::Coord(1, 2, 3), 0.5F);
  accessor.setValue(nanovdb::Coord(1, 12, 3), 0.25F);
  std::vector<nanovdb::GridHandle<>> grids;
  grids.push_back(builder.getHandle<>(1.0, nanovdb::Vec3d(0), "density"));
  std::ostringstream stream(std::string(4096, '\0'), std::ios::binary);
  nanovdb::io::writeGrids(stream, grids);
  return stream.str().substr(0, static_cast<std::size_t>(stream.tellp()));
}

/// Nonzero bytes, which have a meaning, are in few places of a large file.
std::vector<std::size_t> places_of_numbers(const std::string& file) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < file.size(); i += 4) {
    if (i < 1024 || file[i] != '\0' || file[i + 1] != '\0') places.push_back(i);
  }
  return places;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string kGood = good_file();
  static const std::vector<std::size_t> kPlaces = places_of_numbers(kGood);
  std::string file(reinterpret_cast<const char*>(data), size);
  if (size > 0 && data[0] % 2 == 1) {
    file = kGood;
    for (std::size_t i = 1; i + 10 <= size; i += 10) {
      std::uint16_t which = 0;
      std::memcpy(&which, data + i, sizeof(which));
      const std::size_t place = kPlaces[which % kPlaces.size()];
      std::memcpy(file.data() + place, data + i + 2, std::min<std::size_t>(8, file.size() - place));
    }
  }
  try {
    ajar::pbrt::read_nanovdb(file, "density", {}, 1 << 16);
  } catch (const ajar::Error&) {
  }
  return 0;
}
