// How clay behaves, kept in the scene: a scene that is opened again goes on alike.
#pragma once
#include <string>

#include "bozzetto/clay/settings.hpp"
#include "bozzetto/scene/document.hpp"

namespace bozzetto {

/// Keeps them as the text of their operation; the defaults as nothing.
void keepSettings(const clay::Settings& settings, SceneParts& parts);

/// Those kept, or the defaults. Throws Error for text that is no such operation; `name` opens it.
clay::Settings settingsOf(const SceneParts& parts, const std::string& name);

}  // namespace bozzetto
