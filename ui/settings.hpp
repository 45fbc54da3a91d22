// What is kept between sessions, in $XDG_CONFIG_HOME/bozzetto/settings.json.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "ui/keymap.hpp"
#include "ui/view_state.hpp"

namespace bozzetto::ui {

struct Settings {
  KeyProfile profile = KeyProfile::blender;
  std::map<std::string, std::string> keys;  ///< Keymap::changes()
  std::vector<std::string> recent;          ///< paths, the last one first
  std::string folder;                       ///< where the file dialog was last
  OrbitStyle orbit = OrbitStyle::turntable;
  double scale = 0;  ///< of the interface; 0: the monitor's
  double puckSpeed = 1;
  double pressureGamma = 1, pressureLeast = 0;
  bool pressureStrength = true, pressureSize = false;

  friend bool operator==(const Settings&, const Settings&) = default;

  void remember(const std::filesystem::path& scene);
};

/// $XDG_CONFIG_HOME/bozzetto, else ~/.config/bozzetto; empty where neither is known.
std::filesystem::path configFolder();

/// JSON. Parsing takes what it understands and leaves the rest at its default: an old or damaged
/// file never keeps the window from opening.
std::string toText(const Settings& settings);
Settings parseSettings(const std::string& text);

/// The file in a folder; defaults when there is none.
Settings readSettings(const std::filesystem::path& folder);
/// Throws Error when it cannot be written.
void writeSettings(const std::filesystem::path& folder, const Settings& settings);

}  // namespace bozzetto::ui
