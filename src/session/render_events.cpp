#include "session/render_events.h"

namespace ajar {

const char* to_string(RenderPhase phase) {
  switch (phase) {
    case RenderPhase::Load:
      return "load";
    case RenderPhase::Build:
      return "build";
    case RenderPhase::Prepare:
      return "prepare";
    case RenderPhase::Render:
      return "render";
    case RenderPhase::Write:
      return "write";
  }
  return "";
}

}  // namespace ajar
