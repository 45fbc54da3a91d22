// What a tool does to the clay it covers (Ferley §4.2; algorithms.md §1).
#pragma once
#include <memory>
#include <optional>
#include <string_view>

#include "bozzetto/field/changed_run.hpp"
#include "bozzetto/field/corner_block.hpp"
#include "bozzetto/tool/stamp.hpp"

namespace bozzetto {

/// With p the tool's potential at the corner and s the strength, scaled by 1 − hold/255:
///   add         v ← min(1, v + s·p), colour blended with weight s·p / (v + s·p)
///   remove      v ← max(0, v − s·p)
///   erase       v ← 0 where p > 0; of sculptures v ← min(v, 1 − min(1, 2p)): all is gone where
///               they are, and their wall is as smooth as they are
///   paint       colour ← tool's where p > 0
///   paintSoft   colour blended with weight s·p / (s·p + v)
///   smooth      v ← v + s·p·(lowpass(v) − v), colour likewise weighted by density
///   stamp       v ← clamp(v + s·def(d)); the bulge rises from clay only (stamp.hpp); sculptures
///               press v − s·p, but not below min(v, 1 − p), however many dabs there are
///   hold        where hold is less than s it grows by p of what is missing; the clay stays
///   free        where hold is more than 1 − s it falls by p of what is too much
///   stiffen, soften   not on the clay but on what painted stiffness is kept in: o ← o ± s·p
///   push, grip, swell   move clay: strokes of these are made by clay/stroke.hpp
/// The hard ones, erase and paint, ignore s and act where hold < 128.
enum class ActionKind {
  add,
  remove,
  erase,
  paint,
  paintSoft,
  smooth,
  stamp,
  hold,
  free,
  stiffen,
  soften,
  push,
  grip,
  swell
};

/// "add", "remove", "erase", "paint", "paint_soft", "smooth", "stamp", "hold", "free", "stiffen",
/// "soften", "push", "grip", "swell".
std::string_view toText(ActionKind kind);
std::optional<ActionKind> actionNamed(std::string_view name);

/// The clay stays as it is, how stiff it is changes.
constexpr bool stiffens(ActionKind kind) {
  return kind == ActionKind::stiffen || kind == ActionKind::soften;
}
/// push, grip, swell: no Action does these.
constexpr bool movesClay(ActionKind kind) { return kind >= ActionKind::push; }

struct ActionOptions {
  ActionKind kind = ActionKind::add;
  double strength = 0.5;    ///< 0…1 per dab
  Colour colour;            ///< what add and the paints give
  bool ownColours = false;  ///< or those of the tool, where it has some (freeform)
  StampOptions stamp{};
};

/// Throws Error unless the strength is in 0…1.
void requireValid(const ActionOptions& options);

/// The corners of a block as an action sees them. The arrays of the new state may be those of the
/// old one.
struct BlockView {
  int count;
  const float* value;
  const Attributes* attributes;
  float* newValue;
  Attributes* newAttributes;
  const float* potential;
  const struct Lowpass* lowpass = nullptr;  ///< for actions that ask for it
  const Attributes* toolColours = nullptr;  ///< likewise; where the potential is above 0
  const float* body = nullptr;              ///< likewise; how much of the tool is there
  const float* swept = nullptr;             ///< likewise; and was, in dabs of the stroke before
  /// What is known of the old corners without looking: that all with clay have the attributes
  /// `only` (or that there is none), and the least value.
  bool oneColour = false;
  Attributes only = 0;
  float low = 0;
};

/// The block's neighbourhood, low-passed: (1 2 1)³/64 of the old values.
struct Lowpass {
  const float* value;
  const float* premultiplied[3];  ///< of value · colour channel; null where one colour is all
  Attributes onlyColour;          ///< that colour
  const float* climb = nullptr;   ///< how steeply old values climb to neighbours, a cell
};

/// What became of a block. Where dirty is 0 the new state is the old one, bit for bit.
struct Outcome {
  int dirty = 0;            ///< corners that changed
  float low = 0, high = 0;  ///< of the new values
  bool uniform = false;     ///< all corners are equal, attributes too
  MassUnits dropped = 0;    ///< mass the action let go (smooth)
  /// Which corners changed; unless the action knows better, all may have.
  CornerBits corners{kAllCorners, kAllCorners, kAllCorners, kAllCorners,
                     kAllCorners, kAllCorners, kAllCorners, kAllCorners};
  /// The block is as canonical() would leave it, and whether all its clay has the attributes
  /// `only`.
  bool settled = false;
  bool oneColour = false;
  Attributes only = 0;
};

/// What is known of a block, or of a run of equal ones, before looking at its corners.
struct BlockSummary {
  bool present = false;
  bool uniform = false;  ///< all corners as these:
  float value = 0;
  Attributes attributes = 0;
};

class Action {
 public:
  virtual ~Action() = default;
  /// True when such a block stays as it is whatever the potential.
  virtual bool leaves(const BlockSummary& block) const = 0;
  /// Does it; `strength` per dab.
  virtual Outcome apply(const BlockView& block, float strength) const = 0;
  virtual bool wantsLowpass() const { return false; }
  virtual bool wantsColours() const { return false; }
  virtual bool wantsBody() const { return false; }
};

/// What p is: a potential that falls slowly, or the density of a sculpture, which falls from 1 to 0
/// within two of its cells.
enum class ToolBody { potential, sculpture };

/// `iso` is for the stamp.
std::unique_ptr<Action> makeAction(const ActionOptions& options, double iso = 0.5,
                                   ToolBody body = ToolBody::potential);

}  // namespace bozzetto
