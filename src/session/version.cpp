#include "session/version.h"

namespace ajar {

const std::string& version() {
  static const std::string text = AJAR_VERSION;
  return text;
}

}  // namespace ajar
