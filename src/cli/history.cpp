// bozzetto history SCENE: the tree of steps; and the document some steps back or forth.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>

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

void run(const Arguments& arguments) {
  ProgressBar progress;
  Session session = Session::look(arguments.scene, {}, progress);
  for (const std::string& notice : session.findings().notices) progress.note(notice);
  if (!arguments.out.empty()) return saveAnotherState(arguments, session, progress);
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
  command->callback([arguments] {
    if (!arguments->out.empty() && arguments->undo < 0 && arguments->redo < 0)
      throw CLI::RequiredError("--undo or --redo");
    run(*arguments);
  });
}

}  // namespace bozzetto::cli
