// The one door: whoever wants to change clay hands an operation to a Sculptor. The same operations
// give the same field, bit for bit, on any number of threads and with blocks of any side.
#pragma once
#include <memory>

#include "bozzetto/base/progress.hpp"
#include "bozzetto/sculptor/live_stroke.hpp"
#include "bozzetto/sculptor/operation.hpp"
#include "bozzetto/sculptor/workbench.hpp"

namespace bozzetto {

template <int Side>
class BasicSculptor {
 public:
  /// With a history in memory only.
  explicit BasicSculptor(Field<Side> field = {}, SurfaceUpkeep upkeep = SurfaceUpkeep::none)
      : bench_(std::move(field), History<Side>(), upkeep) {}
  BasicSculptor(Field<Side> field, History<Side> history, SurfaceUpkeep upkeep)
      : bench_(std::move(field), std::move(history), upkeep) {}

  /// Does one operation. Throws Error and changes nothing when it cannot be done; notices (a
  /// widened tool, what a resample will need) go to `progress` first.
  OperationReport apply(const Operation& operation, Progress& progress = Progress::none());

  /// A stroke that is drawn now, with the tool and action in the hand. No other operation until it
  /// is finished or gone.
  std::unique_ptr<LiveStroke<Side>> begin(Stroke stroke) {
    return std::make_unique<LiveStroke<Side>>(bench_, std::move(stroke));
  }

  /// The solid of a document just opened: no step of history.
  void place(SolidRef solid) { bench_.placeSolid(std::move(solid)); }
  /// The supports of a document just opened: no step of history.
  void place(std::vector<clay::Support> supports) { bench_.placeSupports(std::move(supports)); }
  /// The ledger of a document just opened: no step of history.
  void place(const MassLedger& ledger) { bench_.placeLedger(ledger); }
  /// Where the clay's mass came from and went.
  const MassLedger& ledger() const { return bench_.ledger(); }
  /// The painted stiffness of a document just opened: no step of history.
  void place(clay::Stiffness stiffness) { bench_.placeStiffness(std::move(stiffness)); }
  /// How the clay of a document just opened behaves: no step of history.
  void place(const clay::Settings& settings) { bench_.clay.settings = settings; }
  /// The solid being worked on; null when there is none.
  const SolidRef& solid() const { return bench_.solid(); }

  const Field<Side>& field() const { return bench_.field(); }
  /// All steps, with labels, times and branches; where we are; what is on the disk.
  const History<Side>& history() const { return bench_.history(); }
  History<Side>& history() { return bench_.history(); }
  /// Who can draw a small picture (PNG) of the clay as it is: each step gets one.
  void setPictureTaker(std::function<Bytes()> take) { bench_.takePicture = std::move(take); }
  /// The tool of the next stroke; as long as nobody chose one, a ball of 8 cells.
  ToolShape tool() const { return bench_.hand.tool(field().scale.spacing); }
  /// Where names of tools lead: set its folder and the document's shelf.
  ToolLibrary& tools() { return bench_.tools; }
  const ToolLibrary& tools() const { return bench_.tools; }
  /// What strokes that move clay meet.
  const clay::Setup& clay() const { return bench_.clay; }
  const ActionOptions& action() const { return bench_.hand.action; }
  /// The surface as of the last dab or operation. Needs upkeep.
  const Surface<Side>& surface() const { return bench_.surface(); }
  /// What changed in clay and surface since the last call. Needs upkeep.
  SurfaceChanges takeChanges() { return bench_.takeChanges(); }
  /// Strokes leave the surface as it is, and note changed blocks, until it catches up.
  void letSurfaceWait() { bench_.letSurfaceWait(); }
  void catchUp() { bench_.catchUp(); }

 private:
  Workbench<Side> bench_;
};

extern template class BasicSculptor<1>;
extern template class BasicSculptor<8>;

using Sculptor = BasicSculptor<8>;

}  // namespace bozzetto
