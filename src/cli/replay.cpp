// bozzetto replay RECORDING: does what was recorded and keeps the scene.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bozzetto/base/file.hpp"
#include "bozzetto/base/parallel.hpp"
#include "bozzetto/render/thumbnail.hpp"
#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/sculptor/clay_settings.hpp"
#include "bozzetto/sculptor/recording.hpp"
#include "bozzetto/sculptor/replay.hpp"
#include "bozzetto/sculptor/session.hpp"
#include "bozzetto/solid/solid_codec.hpp"
#include "cli/progress_bar.hpp"
#include "cli/subcommands.hpp"

namespace bozzetto::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
  std::string recording, from, out, on, stats;
  bool create = false;
  int threads = 0;
  double spacing = 0;
  HistoryLimits history;
};

Json jsonOf(const OperationReport& report) {
  Json json{{"op", report.op},
            {"dabs", report.dabs},
            {"ms_field", report.msField},
            {"ms_surface", report.msSurface},
            {"ms_history", report.msHistory},
            {"visited", report.visited},
            {"computed", report.computed},
            {"dirty", report.dirty},
            {"treated", report.treated},
            {"mass_before", report.massBefore},
            {"mass_after", report.massAfter},
            {"mass_dropped", report.massDropped}};
  if (report.physics) {
    json["steps"] = report.physics->steps;
    json["ms_step"] = report.physics->msStep;
    json["iterations"] = report.physics->iterations;
    json["energy"] = report.physics->energy;
  }
  return json;
}

void writeStatistics(const std::string& path, const std::vector<OperationReport>& reports) {
  Json operations = Json::array();
  for (const OperationReport& report : reports) operations.push_back(jsonOf(report));
  Json totals = jsonOf(totalOf(reports));
  totals.erase("op");
  const std::string text = Json{{"operations", operations}, {"totals", totals}}.dump(1) + "\n";
  writeFile(path, std::as_bytes(std::span(text)));
}

SurfaceUpkeep upkeepFor(const Arguments& arguments) {
  return arguments.stats.empty() ? SurfaceUpkeep::none : SurfaceUpkeep::afterEachDab;
}

std::vector<OperationReport> replayToFile(const Arguments& arguments, const Recording& recording,
                                          Progress& progress) {
  Document document;
  if (!arguments.from.empty()) document = asCopy(loadScene(arguments.from, progress));
  ReplayOptions options;
  options.upkeep = upkeepFor(arguments);
  if (arguments.spacing != 0) options.spacing = arguments.spacing;
  options.solid = decodeSolid(document.parts.solid, arguments.from);
  options.shelf = document.parts.shelf;
  options.supports = document.parts.supports;
  options.stiffness = document.parts.stiffness;
  options.settings = settingsOf(document.parts, arguments.from);
  options.ledger = ledgerOf(document.parts, arguments.from);
  ReplayResult result = replay(recording, document.field, options, progress);
  document.field = std::move(result.field);
  document.parts.solid = encodeSolid(result.solid);
  document.parts.shelf = std::move(result.shelf);
  document.parts.supports = std::move(result.supports);
  document.parts.stiffness = std::move(result.stiffness);
  keepSettings(result.settings, document.parts);
  putLedger(result.ledger, document.parts);
  document.parts.thumbnail = thumbnailOf(document.field);
  saveScene(arguments.out, document, progress);
  return std::move(result.reports);
}

// Says of every operation when it is on the disk.
std::vector<OperationReport> replayInPlace(const Arguments& arguments, const Recording& recording,
                                           ProgressBar& progress) {
  SessionOptions options;
  options.upkeep = upkeepFor(arguments);
  options.limits = arguments.history;
  Session session = arguments.create ? Session::create(arguments.on, options)
                                     : Session::open(arguments.on, options, progress);
  for (const std::string& notice : session.findings().notices) progress.note(notice);
  if (session.findings().readOnly) {
    throw Error(arguments.on + ": another program has it open, or its history cannot be written");
  }
  const auto tell = [&](std::size_t number) {
    session.keepParts();
    session.sculptor().history().waitDurable();
    if (const std::string trouble = session.trouble(); !trouble.empty()) throw Error(trouble);
    fmt::print("done {}\n", number);
    std::fflush(stdout);
  };
  auto reports = replay(recording, session.sculptor(), progress, tell);
  session.parts.thumbnail = thumbnailOf(session.sculptor().field());
  session.save(progress);
  return reports;
}

void run(const Arguments& arguments) {
  setThreadCount(arguments.threads);
  const Recording recording = readRecording(arguments.recording);
  ProgressBar progress;
  const auto reports = arguments.on.empty() ? replayToFile(arguments, recording, progress)
                                            : replayInPlace(arguments, recording, progress);
  if (!arguments.stats.empty()) writeStatistics(arguments.stats, reports);
}

}  // namespace

void addReplay(CLI::App& app) {
  CLI::App* command = app.add_subcommand("replay", "Does what a recording says");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("recording", arguments->recording, "JSON Lines")->required();
  auto* from =
      command->add_option("--from", arguments->from,
                          "The scene to start from; a recording that goes on from one needs it");
  auto* out = command->add_option("-o,--out", arguments->out, "The scene to write");
  auto* on = command->add_option("--on", arguments->on,
                                 "Instead: the scene to work on in place, with its history");
  on->excludes(from)->excludes(out);
  command->add_flag("--new", arguments->create, "The scene of --on is not there yet")->needs(on);
  command
      ->add_option("--undo-files", arguments->history.steps,
                   "With --on: so many are kept, the oldest go; 0 for any number")
      ->needs(on)
      ->capture_default_str();
  command
      ->add_option("--undo-bytes", arguments->history.diskBytes,
                   "With --on: so many bytes of undo-files are kept; 0 for any number")
      ->needs(on)
      ->capture_default_str();
  command->add_option("--threads", arguments->threads, "As many as the machine has without")
      ->check(CLI::Range(0, 1024));
  command
      ->add_option("--spacing", arguments->spacing,
                   "Replay on another grid, finer or coarser: world units per cell")
      ->check(CLI::PositiveNumber)
      ->excludes(on);
  command->add_option("--stats", arguments->stats, "Counts and times of every operation, JSON");
  command->callback([arguments, out, on] {
    if (out->empty() && on->empty()) throw CLI::RequiredError("--out or --on");
    run(*arguments);
  });
}

}  // namespace bozzetto::cli
