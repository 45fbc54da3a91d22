// bozzetto replay RECORDING: does what was recorded and keeps the scene.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bozzetto/base/file.hpp"
#include "bozzetto/base/parallel.hpp"
#include "bozzetto/render/thumbnail.hpp"
#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/sculptor/recording.hpp"
#include "bozzetto/sculptor/replay.hpp"
#include "cli/progress_bar.hpp"
#include "cli/subcommands.hpp"

namespace bozzetto::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
  std::string recording, from, out, stats;
  int threads = 0;
  double spacing = 0;
};

Json jsonOf(const OperationReport& report) {
  return {{"op", report.op},
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
}

void writeStatistics(const std::string& path, const std::vector<OperationReport>& reports) {
  Json operations = Json::array();
  for (const OperationReport& report : reports) operations.push_back(jsonOf(report));
  Json totals = jsonOf(totalOf(reports));
  totals.erase("op");
  const std::string text = Json{{"operations", operations}, {"totals", totals}}.dump(1) + "\n";
  writeFile(path, std::as_bytes(std::span(text)));
}

void run(const Arguments& arguments) {
  setThreadCount(arguments.threads);
  const Recording recording = readRecording(arguments.recording);
  ProgressBar progress;
  Document document;
  if (!arguments.from.empty()) document = loadScene(arguments.from, progress);
  ReplayOptions options;
  options.upkeep = arguments.stats.empty() ? SurfaceUpkeep::none : SurfaceUpkeep::afterEachDab;
  if (arguments.spacing != 0) options.spacing = arguments.spacing;
  const ReplayResult result = replay(recording, document.field, options, progress);
  document.field = result.field;
  document.parts.thumbnail = thumbnailOf(document.field);
  saveScene(arguments.out, document, progress);
  if (!arguments.stats.empty()) writeStatistics(arguments.stats, result.reports);
}

}  // namespace

void addReplay(CLI::App& app) {
  CLI::App* command = app.add_subcommand("replay", "Does what a recording says");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("recording", arguments->recording, "JSON Lines")->required();
  command->add_option("--from", arguments->from, "The scene to start from; empty without");
  command->add_option("-o,--out", arguments->out, "The scene to write")->required();
  command->add_option("--threads", arguments->threads, "As many as the machine has without")
      ->check(CLI::Range(0, 1024));
  command
      ->add_option("--spacing", arguments->spacing,
                   "Replay on another grid, finer or coarser: world units per cell")
      ->check(CLI::PositiveNumber);
  command->add_option("--stats", arguments->stats, "Counts and times of every operation, JSON");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bozzetto::cli
