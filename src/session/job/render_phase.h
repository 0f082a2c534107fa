#pragma once

namespace ajar {

/// The steps of a render.
enum class RenderPhase { Load, Build, Prepare, Render, Denoise, Write };
/// "load", "build", "prepare", "render", "denoise", "write".
const char* to_string(RenderPhase phase);

}  // namespace ajar
