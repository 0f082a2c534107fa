#include "session/job/render_phase.h"

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
    case RenderPhase::Denoise:
      return "denoise";
    case RenderPhase::Write:
      return "write";
  }
  return "";
}

}  // namespace ajar
