#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "apps/viewer/live_render.h"
#include "post/display.h"

/// The texts that pages and the server exchange (docs/develop/live-viewer.md).
namespace ajar::viewer {

/// A message of a page as an object with a type. Raises UsageError for all else.
nlohmann::json parse_message(std::string_view text);

/// Changes a state as `regions`, `method`, `camera`, `resolution`, `crop` or `edit` asks. Raises
/// UsageError for what cannot be; false for other types.
bool apply_message(const nlohmann::json& message, LiveState& state);
/// The limits of `stop-at`. Raises UsageError.
StopAt parse_stop_at(const nlohmann::json& message);
/// Exposure and tone curve of a page, as `save` has them. Raises UsageError.
DisplayOptions parse_display(const nlohmann::json& message);
/// A mask, or null for one that takes it away. Raises UsageError.
std::shared_ptr<const Mask> parse_mask(std::string_view bytes);

nlohmann::json welcome_message(const std::string& scene, const desc::SceneDesc& description,
                               const BuiltScene& built);
/// For a finished picture.
nlohmann::json welcome_message(const std::string& file, const Picture& picture);
/// `picture`: null before there is one.
nlohmann::json state_message(const LiveStatus& status, const Picture* picture,
                             bool can_be_denoised);
nlohmann::json history_message(const LiveStatus& status);
/// The values of a pixel. Raises UsageError if it is not in the picture.
nlohmann::json pixel_message(const nlohmann::json& message, const Picture& picture,
                             const BuiltScene* built);
nlohmann::json note_message(bool is_warning, const std::string& text);

}  // namespace ajar::viewer
