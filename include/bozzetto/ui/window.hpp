// The window of bozzetto.
#pragma once
#include <filesystem>
#include <string>

namespace bozzetto {

struct WindowOptions {
  std::filesystem::path scene;  ///< empty: a new ball; a name without a file: saved there later
};

/// Opens the window and returns when it is closed. Throws Error when there is no display or no
/// OpenGL 3.3.
void runWindow(const WindowOptions& options);

}  // namespace bozzetto
