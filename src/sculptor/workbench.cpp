#include "bozzetto/sculptor/workbench.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bozzetto/scene/stiffness_bytes.hpp"
#include "bozzetto/scene/support_bytes.hpp"
#include "sculptor/timer.hpp"

namespace bozzetto {
namespace {

// Sorts what was noted dab by dab and leaves each once.
void sortOnce(std::vector<Key>& noted) {
  std::sort(noted.begin(), noted.end());
  noted.erase(std::unique(noted.begin(), noted.end()), noted.end());
}

// Sculptures that somebody holds already, with all that was prepared for them.
void adoptSculptures(std::vector<clay::Support>& read, const std::vector<clay::Support>& held) {
  for (clay::Support& support : read) {
    for (const clay::Support& other : held) {
      clay::Support like = support;
      like.sculpture = other.sculpture;
      if (other.sculpture && like == support) support.sculpture = other.sculpture;
    }
  }
}

bool keepsMass(const OperationReport& report, const Hand& hand) {
  if (report.op != "stroke") return report.op == "relax";
  return !hand.recall && movesClay(hand.action.kind);
}

}  // namespace

ToolShape Hand::tool(double spacing) const {
  ToolShape ball;
  ball.radii *= spacing;
  return chosen.value_or(ball);
}

template <int Side>
Workbench<Side>::Workbench(Field<Side> field, History<Side> history, SurfaceUpkeep upkeep)
    : field_(std::move(field)),
      history_(std::move(history)),
      upkeep_(upkeep),
      massUnits_(massUnits(field_)) {
  takeBeside();
  showAll();
}

template <int Side>
double Workbench<Side>::mass() const {
  const double spacing = field_.scale.spacing;
  return static_cast<double>(massUnits_) * kMassUnit * (spacing * spacing * spacing);
}

template <int Side>
void Workbench<Side>::keep(Edit<Block>& edit, const FieldScale& scale, OperationReport& report) {
  const FieldScale before = field_.scale;
  const double massBefore = mass();
  std::shared_ptr<const Delta<Block>> delta;
  {
    const Timer timer(report.msHistory);
    delta = std::make_shared<const Delta<Block>>(edit.commit());
    report.changedBlocks = delta->changes.size();
    account(*delta);
  }
  field_.scale = scale;
  enter(mass() - massBefore, report);
  if (!std::exchange(followed_, false)) show(*delta, report);
  Bytes picture = takePicture ? takePicture() : Bytes();
  const Timer timer(report.msHistory);
  std::string label = report.op;
  if (label == "stroke") {
    label += hand.recall ? " recall" : " " + std::string(toText(hand.action.kind));
  }
  StepNote note{std::move(label), before, scale};
  history_.push(std::move(delta), std::move(note), besideNow(), std::move(picture));
}

// One line of the ledger.
template <int Side>
void Workbench<Side>::enter(double change, const OperationReport& report) {
  ledger_.dropped += report.massDropped;
  if (keepsMass(report, hand)) {
    ++ledger_.moves;
    ledger_.drift += change;
  } else {
    (change > 0 ? ledger_.added : ledger_.removed) += std::abs(change);
  }
}

// For the history; written anew where it changed.
template <int Side>
Beside Workbench<Side>::besideNow() {
  if (clay.supports != toldSupports_) {
    toldSupports_ = clay.supports;
    supportBytes_ = nullptr;
    if (!toldSupports_.empty())
      supportBytes_ = std::make_shared<const Bytes>(encodeSupports(toldSupports_));
  }
  if (!(ledger_ == toldLedger_)) {
    toldLedger_ = ledger_;
    ledgerBytes_ = std::make_shared<const Bytes>(encodeLedger(ledger_));
  }
  if (!(clay.stiffness == toldStiffness_)) {
    toldStiffness_ = clay.stiffness;
    stiffnessBytes_ = nullptr;
    if (toldStiffness_.any())
      stiffnessBytes_ = std::make_shared<const Bytes>(encodeStiffness(toldStiffness_));
  }
  return {nextSolid_, supportBytes_, ledgerBytes_, stiffnessBytes_};
}

// What the history has where we are.
template <int Side>
void Workbench<Side>::takeBeside() {
  const Beside& now = history_.beside();
  nextSolid_ = now.solid;
  ledgerBytes_ = now.ledger;
  ledger_ = toldLedger_ = now.ledger ? decodeLedger(*now.ledger, "history") : MassLedger{};
  takeStiffness(now.stiffness);
  if (now.supports == supportBytes_) return;
  supportBytes_ = now.supports;
  std::vector<clay::Support> supports;
  if (now.supports) supports = decodeSupports(*now.supports, "history: supports");
  adoptSculptures(supports, clay.supports);
  clay.supports = toldSupports_ = std::move(supports);
}

template <int Side>
void Workbench<Side>::takeStiffness(const BytesRef& bytes) {
  if (bytes != stiffnessBytes_) {
    stiffnessBytes_ = bytes;
    toldStiffness_ = {};
    if (bytes) toldStiffness_ = decodeStiffness(*bytes, "history: stiffness");
  }
  clay.stiffness = toldStiffness_;
}

template <int Side>
void Workbench<Side>::placeStiffness(clay::Stiffness stiffness) {
  clay.stiffness = std::move(stiffness);
  history_.place(besideNow());
}

template <int Side>
void Workbench<Side>::placeSolid(SolidRef solid) {
  nextSolid_ = std::move(solid);
  history_.place(besideNow());
}

template <int Side>
void Workbench<Side>::placeSupports(std::vector<clay::Support> supports) {
  clay.supports = std::move(supports);
  history_.place(besideNow());
}

template <int Side>
void Workbench<Side>::placeLedger(const MassLedger& ledger) {
  ledger_ = ledger;
  history_.place(besideNow());
}

template <int Side>
void Workbench<Side>::showAll() {
  followed_ = false;
  waiting_.reset();
  if (upkeep_ == SurfaceUpkeep::none) return;
  surface_.rebuild(field_);
  changes_ = {.all = true, .blocks = {}, .patches = {}};
}

template <int Side>
SurfaceChanges Workbench<Side>::takeChanges() {
  SurfaceChanges taken = std::exchange(changes_, {});
  taken.blocks = withoutOverlaps(std::move(taken.blocks));
  sortOnce(taken.patches);
  return taken;
}

template <int Side>
void Workbench<Side>::refresh(std::span<const ChangedRun> changed, OperationReport& report) {
  if (upkeep_ == SurfaceUpkeep::none) return;
  followed_ = true;
  if (waiting_) {
    waiting_->insert(waiting_->end(), changed.begin(), changed.end());
    note(changed, {});
  } else {
    const Timer timer(report.msSurface);
    note(changed, surface_.refresh(field_, changed));
  }
  report.treated += treatedCubes<Side>(changed);
}

template <int Side>
void Workbench<Side>::letSurfaceWait() {
  if (upkeep_ == SurfaceUpkeep::afterEachDab && !waiting_) waiting_.emplace();
}

template <int Side>
void Workbench<Side>::catchUp() {
  if (!waiting_) return;
  const std::vector<KeyRun> runs = withoutOverlaps(std::move(*waiting_));
  waiting_.reset();
  note(std::span<const KeyRun>(runs), surface_.refresh(field_, runs));
}

// Brings the surface over a whole delta, in either direction.
template <int Side>
void Workbench<Side>::show(const Delta<Block>& delta, OperationReport& report) {
  if (upkeep_ == SurfaceUpkeep::none) return;
  catchUp();
  {
    const Timer timer(report.msSurface);
    const std::vector<KeyRun> keys = delta.keys();
    note(std::span<const KeyRun>(keys), surface_.refresh(field_, delta));
  }
  report.treated += treatedCubes<Side>(changedRuns<Side>(delta));
}

// Until somebody takes the changes, all of it may be new: then there is nothing to note.
template <int Side>
template <class Run>
void Workbench<Side>::note(std::span<const Run> changed, const RefreshReport& report) {
  if (changes_.all) return;
  changes_.blocks.insert(changes_.blocks.end(), changed.begin(), changed.end());
  changes_.patches.insert(changes_.patches.end(), report.changed.begin(), report.changed.end());
}

template <int Side>
std::string Workbench<Side>::goTo(StepNumber state, OperationReport& report) {
  typename History<Side>::Journey journey;
  {
    const Timer timer(report.msHistory);
    journey = history_.goTo(state, field_.tree, field_.scale);
    account(*journey.delta);
  }
  field_.scale = journey.scale;
  report.changedBlocks += journey.delta->changes.size();
  show(*journey.delta, report);
  takeBeside();
  return journey.trouble;
}

// Keeps the ledger: exact, whatever the order of changes.
template <int Side>
void Workbench<Side>::account(const Delta<Block>& delta) {
  for (const auto& change : delta.changes) {
    const MassSum after = change.after ? change.after->mass : 0;
    const MassSum before = change.before ? change.before->mass : 0;
    massUnits_ += (after - before) * change.length;
  }
}

template class Workbench<1>;
template class Workbench<8>;

}  // namespace bozzetto
