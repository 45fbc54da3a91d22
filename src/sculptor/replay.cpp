#include "bozzetto/sculptor/replay.hpp"

#include <set>

#include "bozzetto/field/resample.hpp"
#include "sculptor/nested_tools.hpp"

namespace bozzetto {
namespace {

// The spacing a recording is made for: what its first scene operation says, or what is there.
double recordedSpacing(const Recording& recording, const Clay& from) {
  if (!from.tree.empty()) return from.scale.spacing;
  for (const Operation& operation : recording.operations) {
    const auto* scene = std::get_if<SceneOperation>(&operation);
    if (scene != nullptr && scene->spacing) return *scene->spacing;
  }
  return from.scale.spacing;
}

// The recording for cells `factor` times as large.
Recording rescaled(Recording recording, double factor) {
  for (Operation& operation : recording.operations) {
    if (auto* scene = std::get_if<SceneOperation>(&operation)) {
      if (scene->spacing) *scene->spacing *= factor;
    } else if (auto* resampling = std::get_if<ResampleOperation>(&operation)) {
      resampling->spacing *= factor;
    }
  }
  return recording;
}

using Told = std::set<std::string, std::less<>>;

// Progress of one operation as a part of the whole. What is to be known is told once.
class Part : public Progress {
 public:
  Part(Progress& whole, Told& told, std::size_t index, std::size_t count)
      : whole_(&whole), told_(&told), begin_(double(index)), count_(double(count)) {}
  bool report(std::string_view, double done) override {
    return whole_->report("replaying", (begin_ + done) / count_);
  }
  void note(std::string_view text) override {
    if (told_->emplace(text).second) whole_->note(text);
  }

 private:
  Progress* whole_;
  Told* told_;
  double begin_, count_;
};

std::vector<OperationReport> run(const Recording& recording, Sculptor& sculptor, Progress& progress,
                                 const std::function<void(std::size_t)>& done) {
  sculptor.tools().folder = recording.folder;
  std::vector<OperationReport> reports;
  Told told;
  const std::size_t count = recording.operations.size();
  for (std::size_t n = 0; n < count; ++n) {
    Part part(progress, told, n, count);
    part.step("", 0);
    try {
      reports.push_back(sculptor.apply(recording.operations[n], part));
    } catch (const Cancelled&) {
      throw;
    } catch (const NestedTools&) {
      throw;
    } catch (const Error& error) {
      throw Error(recording.placeOf(n) + "operation " + std::to_string(n + 1) + ": " +
                  error.what());
    }
    if (done) done(n + 1);
  }
  return reports;
}

}  // namespace

void requireStart(const Recording& recording, const Clay& clay, Progress& progress) {
  if (!recording.start || fieldHash(clay) == recording.start->clay) return;
  const std::string& scene = recording.start->scene;
  const std::string where = scene.empty() ? "a scene that was not saved then" : scene;
  if (clay.tree.empty())
    throw Error("this recording goes on from clay that was there: no clay found, that of " + where +
                " expected (replay --from SCENE)");
  progress.note("this recording was made on other clay, that of " + where +
                ": what it does here may be something else");
}

std::vector<OperationReport> replay(const Recording& recording, Sculptor& sculptor,
                                    Progress& progress,
                                    const std::function<void(std::size_t)>& done) {
  requireStart(recording, sculptor.field(), progress);
  return run(recording, sculptor, progress, done);
}

ReplayResult replay(const Recording& recorded, const Clay& from, const ReplayOptions& options,
                    Progress& progress) {
  requireStart(recorded, from, progress);
  Clay start = from;
  clay::Stiffness stiffness = options.stiffness;
  Recording recording = recorded;
  if (options.spacing) {
    recording = rescaled(std::move(recording), *options.spacing / recordedSpacing(recorded, from));
    start = resample(from, *options.spacing, {}, progress);
    if (stiffness.any())
      stiffness = clay::stiffnessOf(resample(*stiffness.painted, *options.spacing, {}, progress));
  }
  Sculptor sculptor(std::move(start), options.upkeep);
  sculptor.place(options.solid);
  sculptor.place(options.supports);
  sculptor.place(std::move(stiffness));
  sculptor.place(options.settings);
  sculptor.place(options.ledger);
  sculptor.tools().shelf = options.shelf;
  sculptor.tools().depth = options.depth;
  auto reports = run(recording, sculptor, progress, {});
  return {sculptor.field(),         sculptor.solid(),          sculptor.tools().shelf,
          sculptor.clay().supports, sculptor.clay().stiffness, sculptor.clay().settings,
          sculptor.ledger(),        std::move(reports)};
}

OperationReport totalOf(const std::vector<OperationReport>& reports) {
  OperationReport total;
  if (reports.empty()) return total;
  for (const OperationReport& each : reports) {
    total.msField += each.msField;
    total.msSurface += each.msSurface;
    total.msHistory += each.msHistory;
    total.dabs += each.dabs;
    total.visited += each.visited;
    total.computed += each.computed;
    total.dirty += each.dirty;
    total.treated += each.treated;
    total.massDropped += each.massDropped;
    total.changedBlocks += each.changedBlocks;
  }
  total.massBefore = reports.front().massBefore;
  total.massAfter = reports.back().massAfter;
  return total;
}

}  // namespace bozzetto
