// Any text must be a study, or raise one of our errors.
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/error.h"
#include "study/study_plan.h"
#include "support/private_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string path = ajar::fuzz::private_file(std::span(data, size), ".json");
  try {
    ajar::study::read_study(path);
  } catch (const ajar::Error&) {
  }
  return 0;
}
