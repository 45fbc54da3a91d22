// The mass ledger of a document: what its clay's mass came from and went to, up to a state of the
// history. Undo takes entries back.
#pragma once
#include <string>

#include "bozzetto/scene/document.hpp"

namespace bozzetto {

/// World units, as masses are.
struct MassLedger {
  double added = 0, removed = 0;  ///< by operations that give and take
  double dropped = 0;             ///< of what was removed: let go by smoothing thin clay
  std::int64_t moves = 0;         ///< strokes that move clay, and relaxations
  double drift = 0;               ///< what moves did to the mass, all together: rounding

  double total() const { return added - removed + drift; }
  friend bool operator==(const MassLedger&, const MassLedger&) = default;
};

/// As bytes for steps of the history; nothing is an empty ledger. Throws Error, `name` first, for
/// bytes that are none.
Bytes encodeLedger(const MassLedger& ledger);
MassLedger decodeLedger(std::span<const std::byte> bytes, const std::string& name);

/// In a scene's settings, as JSON.
void putLedger(const MassLedger& ledger, SceneParts& parts);
/// The one kept, or an empty one. Throws Error, `name` first, for text that is none.
MassLedger ledgerOf(const SceneParts& parts, const std::string& name);
/// The same, and takes it out.
MassLedger takeLedger(SceneParts& parts, const std::string& name);

}  // namespace bozzetto
