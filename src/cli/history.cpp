// bozzetto history SCENE: the tree of steps; what differs between two of them; and the document
// some steps back or forth.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bozzetto/field/difference.hpp"
#include "bozzetto/sculptor/session.hpp"
#include "cli/progress_bar.hpp"
#include "cli/subcommands.hpp"

namespace bozzetto::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
  std::string scene, out;
  bool json = false;
  int undo = -1, redo = -1;
  std::vector<StepNumber> compare;  // none, or two
};

std::string timeOf(const Step& step) {
  const auto seconds = fmt::gmtime(static_cast<std::time_t>(step.time / 1000));
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", seconds, step.time % 1000);
}

Json jsonOf(const Session& session) {
  const History<8>& history = session.sculptor().history();
  Json steps = Json::array();
  for (const Step& step : history.steps()) {
    steps.push_back({{"step", step.number},
                     {"parent", step.parent},
                     {"time", timeOf(step)},
                     {"label", step.note.label},
                     {"corners", step.changedCorners},
                     {"blocks", step.changedBlocks},
                     {"bytes", step.bytes}});
  }
  return {{"place", history.place()},
          {"undo", history.undoDepth()},
          {"redo", history.redoDepth()},
          {"saved", !session.findings().recovered},
          {"steps", steps}};
}

// One line a step; > where we are, a step after another than the last is a branch.
void print(const Session& session) {
  const History<8>& history = session.sculptor().history();
  StepNumber last = history.tree().root();
  for (const Step& step : history.steps()) {
    const std::string branch =
        step.parent == last ? "" : fmt::format("  branches off {}", step.parent);
    fmt::print("{} {:>6}  {}  {:<12} {:>9} corners {:>8} bytes{}\n",
               step.number == history.place() ? '>' : ' ', step.number, timeOf(step),
               step.note.label, step.changedCorners, step.bytes, branch);
    last = step.number;
  }
  fmt::print("{} to undo, {} to redo{}\n", history.undoDepth(), history.redoDepth(),
             session.findings().recovered ? "; not saved" : "");
}

void saveAnotherState(const Arguments& arguments, Session& session, Progress& progress) {
  const Operation operation = arguments.undo >= 0 ? Operation(UndoOperation{arguments.undo})
                                                  : Operation(RedoOperation{arguments.redo});
  session.sculptor().apply(operation, progress);
  saveScene(arguments.out, asCopy(session.document()), progress);
}

/// Two states, and what leads from one to the other.
struct Comparison {
  FieldScale before, after;
  FieldDifference found;
  bool sameGrid() const { return before.spacing == after.spacing; }  ///< else corners say nothing
  double massDifference() const { return found.massAfter - found.massBefore; }
};

Comparison comparison(Session& session, const std::vector<StepNumber>& steps) {
  Sculptor& sculptor = session.sculptor();
  const Clay before = sculptor.history().fieldAt(steps[0], sculptor.field());
  const Clay after = sculptor.history().fieldAt(steps[1], sculptor.field());
  return {before.scale, after.scale, bozzetto::compare(before, after)};
}

Json boundsOf(const Comparison& compared) {
  const KeyBox& box = compared.found.bounds;
  if (box.empty()) return nullptr;
  const auto pointOf = [&](Key corner) {
    const double spacing = compared.before.spacing;
    return Json{corner.i * spacing, corner.j * spacing, corner.k * spacing};
  };
  return {{"min", pointOf(box.low)}, {"max", pointOf(box.high)}};
}

Json jsonOf(const Comparison& compared) {
  const FieldDifference& found = compared.found;
  Json json{{"mass_before", found.massBefore},
            {"mass_after", found.massAfter},
            {"mass_difference", compared.massDifference()},
            {"same_grid", compared.sameGrid()}};
  if (!compared.sameGrid()) return json;
  json["blocks"] = found.blocks;
  json["corners"] = found.corners;
  json["reshaped"] = found.reshaped;
  json["bounds"] = boundsOf(compared);
  return json;
}

void print(const Comparison& compared) {
  const FieldDifference& found = compared.found;
  if (!compared.sameGrid()) {
    fmt::print("other grids: spacing {} and {}\n", compared.before.spacing, compared.after.spacing);
  } else if (found.corners == 0) {
    fmt::print("the same clay\n");
  } else {
    const Json bounds = boundsOf(compared);
    fmt::print("{} corners in {} blocks differ, {} of them in density; from {} to {}\n",
               found.corners, found.blocks, found.reshaped, bounds["min"].dump(),
               bounds["max"].dump());
  }
  fmt::print("mass {} then {}: {:+}\n", found.massBefore, found.massAfter,
             compared.massDifference());
}

void compare(const Arguments& arguments, Session& session, ProgressBar& progress) {
  const Comparison compared = comparison(session, arguments.compare);
  progress.clear();
  if (arguments.json) {
    fmt::print("{}\n", jsonOf(compared).dump());
  } else {
    print(compared);
  }
}

void run(const Arguments& arguments) {
  ProgressBar progress;
  Session session = Session::look(arguments.scene, {}, progress);
  for (const std::string& notice : session.findings().notices) progress.note(notice);
  if (!arguments.out.empty()) return saveAnotherState(arguments, session, progress);
  if (!arguments.compare.empty()) return compare(arguments, session, progress);
  progress.clear();
  if (arguments.json) {
    fmt::print("{}\n", jsonOf(session).dump());
  } else {
    print(session);
  }
}

}  // namespace

void addHistory(CLI::App& app) {
  CLI::App* command = app.add_subcommand("history", "Lists the steps of a scene, branches too");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("scene", arguments->scene, "The scene")->required();
  command->add_flag("--json", arguments->json, "As one JSON object");
  auto* out = command->add_option("-o,--out", arguments->out, "Where the other state goes");
  auto* undo = command->add_option("--undo", arguments->undo, "The state so many steps back")
                   ->check(CLI::NonNegativeNumber)
                   ->needs(out);
  command->add_option("--redo", arguments->redo, "The state so many steps on")
      ->check(CLI::NonNegativeNumber)
      ->needs(out)
      ->excludes(undo);
  command->add_option("--compare", arguments->compare, "What leads from one step to another")
      ->type_name("STEP STEP")
      ->expected(2)
      ->excludes(out);
  command->callback([arguments] {
    if (!arguments->out.empty() && arguments->undo < 0 && arguments->redo < 0)
      throw CLI::RequiredError("--undo or --redo");
    run(*arguments);
  });
}

}  // namespace bozzetto::cli
