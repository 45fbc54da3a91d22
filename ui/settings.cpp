#include "ui/settings.hpp"

#include <algorithm>
#include <cstdlib>

#include "bozzetto/base/error.hpp"
#include "bozzetto/base/file.hpp"
#include "ui/lenient_json.hpp"

namespace bozzetto::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRecent = 12;
constexpr std::size_t kLargestFile = 1 << 20;

}  // namespace

void Settings::remember(const fs::path& scene) {
  const std::string path = fs::absolute(scene).lexically_normal().string();
  std::erase(recent, path);
  recent.insert(recent.begin(), path);
  if (recent.size() > kMostRecent) recent.resize(kMostRecent);
}

fs::path configFolder() {
  if (const char* config = std::getenv("XDG_CONFIG_HOME"); config && config[0] == '/') {
    return fs::path(config) / "bozzetto";
  }
  const char* home = std::getenv("HOME");
  return home && home[0] == '/' ? fs::path(home) / ".config" / "bozzetto" : fs::path();
}

std::string toText(const Settings& settings) {
  const Json json{{"profile", settings.profile == KeyProfile::blender ? "blender" : "zbrush"},
                  {"keys", settings.keys},
                  {"recent", settings.recent},
                  {"folder", settings.folder},
                  {"orbit", settings.orbit == OrbitStyle::turntable ? "turntable" : "trackball"},
                  {"scale", settings.scale},
                  {"puck_speed", settings.puckSpeed},
                  {"pressure_gamma", settings.pressureGamma},
                  {"pressure_least", settings.pressureLeast},
                  {"pressure_strength", settings.pressureStrength},
                  {"pressure_size", settings.pressureSize}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Settings parseSettings(const std::string& text) {
  Settings settings;
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return settings;
  std::string profile, orbit;
  take(json, "profile", profile);
  take(json, "orbit", orbit);
  if (profile == "zbrush") settings.profile = KeyProfile::zbrush;
  if (orbit == "trackball") settings.orbit = OrbitStyle::trackball;
  take(json, "keys", settings.keys);
  take(json, "recent", settings.recent);
  if (settings.recent.size() > kMostRecent) settings.recent.resize(kMostRecent);
  take(json, "folder", settings.folder);
  takeWithin(json, "scale", 0.5, 4.0, settings.scale);
  takeWithin(json, "puck_speed", 0.1, 10.0, settings.puckSpeed);
  takeWithin(json, "pressure_gamma", 0.1, 10.0, settings.pressureGamma);
  takeWithin(json, "pressure_least", 0.0, 1.0, settings.pressureLeast);
  take(json, "pressure_strength", settings.pressureStrength);
  take(json, "pressure_size", settings.pressureSize);
  return settings;
}

Settings readSettings(const fs::path& folder) {
  try {
    const Bytes bytes = readFile(folder / "settings.json", kLargestFile);
    return parseSettings({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  } catch (const Error&) {
    return {};
  }
}

void writeSettings(const fs::path& folder, const Settings& settings) {
  if (folder.empty()) return;
  std::error_code ignored;
  fs::create_directories(folder, ignored);
  const std::string text = toText(settings);
  writeFile(folder / "settings.json", std::as_bytes(std::span(text)));
}

}  // namespace bozzetto::ui
