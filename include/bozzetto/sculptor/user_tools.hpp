// The files of the user's own library: what of them is damaged, and what they are called.
#pragma once
#include <string>
#include <vector>

namespace bozzetto {

struct DamagedTool {
  std::string name;  ///< its file's, without .bzt
  std::string why;   ///< what was found wrong with it
};

/// Files of the user's library that cannot be read as tools, by name.
std::vector<DamagedTool> damagedTools();

/// Gives a tool of the user's library another name, or the same, and these tags; all else that is
/// in its file stays. Throws Error for names that starters or other tools of the library have.
void renameUserTool(const std::string& name, const std::string& to,
                    const std::vector<std::string>& tags);

/// Deletes one, damaged or not. Throws Error where that fails.
void dropUserTool(const std::string& name);

}  // namespace bozzetto
