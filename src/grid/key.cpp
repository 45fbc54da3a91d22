#include "bozzetto/grid/key.hpp"

#include "bozzetto/base/error.hpp"

namespace bozzetto {

std::string toText(Key key) {
  return "(" + std::to_string(key.i) + ", " + std::to_string(key.j) + ", " + std::to_string(key.k) +
         ")";
}

void requireInWorkspace(const KeyBox& box) {
  constexpr KeyBox workspace{{-kWorkspaceRim, -kWorkspaceRim, -kWorkspaceRim},
                             {kWorkspaceRim, kWorkspaceRim, kWorkspaceRim}};
  if (box.empty() || (workspace.contains(box.low) && workspace.contains(box.high))) return;
  throw Error("corners " + toText(box.low) + " to " + toText(box.high) +
              " leave the workspace of ±2^30 cells");
}

KeyBox grown(const KeyBox& box, std::int32_t rim) {
  if (box.empty()) return box;
  requireInWorkspace(box);  // so that the sums below cannot overflow
  const KeyBox larger{box.low - Key{rim, rim, rim}, box.high + Key{rim, rim, rim}};
  requireInWorkspace(larger);
  return larger;
}

}  // namespace bozzetto
