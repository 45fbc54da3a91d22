// What a scene keeps of how it is looked at beyond camera and plain lights: look, surroundings,
// lights with their soft boxes and what they are fixed to, reference pictures. A text among the
// scene's settings; scenes without it are shown as the window stands.
#pragma once
#include <string>

#include "ui/view_options.hpp"

namespace bozzetto::ui {

/// Its name among SceneParts::settings.
inline constexpr const char* kLookSetting = "look";

/// JSON. Pictures by the path they came from.
std::string lookText(const ViewOptions& options);
/// Takes what it understands; pictures that cannot be read any more have no image, and keep path
/// and place.
void takeLook(const std::string& text, ViewOptions& options);

}  // namespace bozzetto::ui
