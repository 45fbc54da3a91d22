#include "bozzetto/sculptor/clay_settings.hpp"

#include "bozzetto/base/error.hpp"
#include "bozzetto/sculptor/operation.hpp"

namespace bozzetto {
namespace {

constexpr const char* kSetting = "clay";

}  // namespace

void keepSettings(const clay::Settings& settings, SceneParts& parts) {
  std::string text = toText(ClayOperation{settings});
  if (text == toText(ClayOperation{})) {
    parts.settings.erase(kSetting);
  } else {
    parts.settings[kSetting] = std::move(text);
  }
}

clay::Settings settingsOf(const SceneParts& parts, const std::string& name) {
  const auto kept = parts.settings.find(kSetting);
  if (kept == parts.settings.end()) return {};
  const Operation operation = parseOperation(kept->second, name + ": clay settings");
  const auto* clay = std::get_if<ClayOperation>(&operation);
  if (clay == nullptr) throw Error(name + ": clay settings: another operation found");
  return clay->settings;
}

}  // namespace bozzetto
