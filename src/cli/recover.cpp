// bozzetto recover SCENE: after a crash, the document as of the last durable operation.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include "bozzetto/sculptor/session.hpp"
#include "cli/progress_bar.hpp"
#include "cli/subcommands.hpp"

namespace bozzetto::cli {
namespace {

struct Arguments {
  std::string scene, out;
};

void tell(const std::string& scene, const Session& session) {
  const SessionFindings& findings = session.findings();
  const History<8>& history = session.sculptor().history();
  const std::string steps =
      fmt::format("{} to undo, {} to redo", history.undoDepth(), history.redoDepth());
  if (!findings.recovered) {
    fmt::print("{}: nothing was lost; {}\n", scene, steps);
    return;
  }
  const auto when = fmt::gmtime(static_cast<std::time_t>(findings.time / 1000));
  fmt::print(
      "{}: {} steps after the last save come back, the last of {:%Y-%m-%d %H:%M:%S} UTC; {}\n",
      scene, findings.unsavedSteps, when, steps);
}

void run(const Arguments& arguments) {
  ProgressBar progress;
  const bool inPlace = arguments.out.empty();
  Session session = inPlace ? Session::open(arguments.scene, {}, progress)
                            : Session::look(arguments.scene, {}, progress);
  for (const std::string& notice : session.findings().notices) progress.note(notice);
  if (inPlace && session.findings().recovered) session.save(progress);
  if (!inPlace) saveScene(arguments.out, asCopy(session.document()), progress);
  progress.clear();
  tell(arguments.scene, session);
}

}  // namespace

void addRecover(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "recover", "Brings back what a crash left unsaved, and says what it found");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("scene", arguments->scene, "The scene, even where only its history is left")
      ->required();
  command->add_option("-o,--out", arguments->out, "Write it there and leave the scene as it is");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bozzetto::cli
