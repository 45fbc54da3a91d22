// What operations work on: the clay with its surface, its history and its ledger, and what the
// sculptor holds in the hand. Operations change the clay through an Edit and `keep` it.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bozzetto/clay/stroke.hpp"
#include "bozzetto/field/field.hpp"
#include "bozzetto/history/history.hpp"
#include "bozzetto/sculptor/ledger.hpp"
#include "bozzetto/sculptor/report.hpp"
#include "bozzetto/sculptor/tool_library.hpp"
#include "bozzetto/solid/solid.hpp"
#include "bozzetto/surface/surface.hpp"
#include "bozzetto/tool/action.hpp"
#include "bozzetto/tool/shape.hpp"

namespace bozzetto {

/// Whether the surface follows the field. `afterEachDab` is what a window shows and what the
/// paper counts; without it nothing is meshed.
enum class SurfaceUpkeep { none, afterEachDab };

/// What those who show the clay have not seen yet.
struct SurfaceChanges {
  bool all = false;            ///< everything may be different
  std::vector<KeyRun> blocks;  ///< of the field, sorted
  std::vector<Key> patches;    ///< of the surface, sorted
};

/// What strokes take; no step of history.
struct Hand {
  std::optional<ToolShape> chosen;  ///< as asked for: a finer grid may take it as it is
  ActionOptions action;
  std::optional<StepNumber> recall;  ///< strokes bring back this state instead

  /// The tool; as long as nobody chose one, a ball of 8 cells.
  ToolShape tool(double spacing) const;
};

template <int Side>
class Workbench {
 public:
  using Block = CornerBlock<Side>;
  using Tree = typename Field<Side>::Tree;

  /// `history` is the field's own: of a document that was opened, or a new one.
  Workbench(Field<Side> field, History<Side> history, SurfaceUpkeep upkeep);

  const Field<Side>& field() const { return field_; }
  History<Side>& history() { return history_; }
  const History<Side>& history() const { return history_; }
  const Surface<Side>& surface() const { return surface_; }  ///< needs upkeep
  /// Since the last call. Needs upkeep; empty without.
  SurfaceChanges takeChanges();
  double mass() const;  ///< world units; from a running sum, not a count: O(1)
  /// Where it came from, up to the state we are in.
  const MassLedger& ledger() const { return ledger_; }

  /// The solid being worked on; null when there is none.
  const SolidRef& solid() const { return history_.solid(); }
  /// What the solid is after the next `keep`, whose step remembers both.
  void setSolid(SolidRef solid) { nextSolid_ = std::move(solid); }
  /// Puts a solid there without a step, before all others.
  void placeSolid(SolidRef solid);
  /// Supports, painted stiffness and a ledger likewise.
  void placeSupports(std::vector<clay::Support> supports);
  void placeStiffness(clay::Stiffness stiffness);
  void placeLedger(const MassLedger& ledger);

  Hand hand;
  ToolLibrary tools;  ///< where names of tools lead; no step of history
  /// What strokes that move clay meet. Supports belong to the state they were set in: who goes back
  /// there finds them again, and the stiffness painted there.
  clay::Setup clay;

  /// The clay, for an Edit.
  Tree& tree() { return field_.tree; }
  /// For clay that has neither corners nor steps; others go through `keep`.
  void setScale(const FieldScale& scale) { field_.scale = scale; }
  /// Ends the edit: one step of history, whatever it changed.
  void keep(Edit<Block>& edit, const FieldScale& scale, OperationReport& report);
  void keep(Edit<Block>& edit, OperationReport& report) { keep(edit, field_.scale, report); }
  /// Brings the surface to what the clay is now, in the middle of an edit. `changed`, in key order,
  /// is all that the edit changed since the last call; an edit that calls this once calls it after
  /// every change.
  void refresh(std::span<const ChangedRun> changed, OperationReport& report);
  /// The surface stays as it is in edits to come, whose blocks are noted, until it catches up:
  /// somebody shows the clay in another way meanwhile.
  void letSurfaceWait();
  void catchUp();
  bool shows() const { return upkeep_ == SurfaceUpkeep::afterEachDab; }
  /// Makes the surface anew, after a rollback.
  void showAll();
  /// Goes to another state of the history. Throws Error for one that is not in it; returns what
  /// was lost on the way, empty as a rule.
  std::string goTo(StepNumber state, OperationReport& report);

  /// A PNG of the clay as it is now, asked for at the end of every step where somebody set it.
  std::function<Bytes()> takePicture;

 private:
  void show(const Delta<Block>& delta, OperationReport& report);
  template <class Run>
  void note(std::span<const Run> changed, const RefreshReport& report);
  void account(const Delta<Block>& delta);
  void enter(double change, const OperationReport& report);
  Beside besideNow();
  void takeBeside();
  void takeStiffness(const BytesRef& bytes);

  Field<Side> field_;
  Surface<Side> surface_;
  SurfaceChanges changes_;
  History<Side> history_;
  SolidRef nextSolid_;
  // Of supports, paint and ledger, what the history was told last.
  std::vector<clay::Support> toldSupports_;
  clay::Stiffness toldStiffness_;
  BytesRef supportBytes_, ledgerBytes_, stiffnessBytes_;
  MassLedger ledger_, toldLedger_;
  SurfaceUpkeep upkeep_;
  std::optional<std::vector<KeyRun>> waiting_;  // for the surface, while it is let wait
  bool followed_ = false;                       // the surface has followed the present edit
  MassSum massUnits_ = 0;
};

extern template class Workbench<1>;
extern template class Workbench<8>;

}  // namespace bozzetto
