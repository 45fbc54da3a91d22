// bozzetto info SCENE: what is in it, for people or as one JSON object.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "bozzetto/base/hash.hpp"
#include "bozzetto/mesh/check.hpp"
#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/sculptor/session.hpp"
#include "bozzetto/surface/statistics.hpp"
#include "bozzetto/surface/welded.hpp"
#include "cli/progress_bar.hpp"
#include "cli/subcommands.hpp"

namespace bozzetto::cli {
namespace {

using Json = nlohmann::ordered_json;

Json listOf(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

Json boundsOf(const MeshReport& mesh) {
  if (mesh.bounds.empty) return nullptr;
  return {{"min", listOf(mesh.bounds.min)}, {"max", listOf(mesh.bounds.max)}};
}

// `before`: what was there when the ledger began.
Json ledgerIn(const SceneParts& parts, double mass, const std::string& path) {
  const MassLedger ledger = ledgerOf(parts, path);
  const double before = mass - ledger.total();
  const bool rounding = std::abs(before) <= 1e-12 * (mass + ledger.added + ledger.removed);
  return {{"before", rounding ? 0 : before}, {"added", ledger.added}, {"removed", ledger.removed},
          {"dropped", ledger.dropped},       {"moves", ledger.moves}, {"drift", ledger.drift}};
}

std::size_t historySteps(const std::string& path) {
  return Session::look(path).sculptor().history().tree().size();
}

Json describe(const std::string& path, const Document& document) {
  const Clay& clay = document.field;
  Surface<8> surface;
  surface.rebuild(clay);
  const SurfaceStatistics shape = statistics(surface, clay);
  const FieldStatistics matter = statistics(clay);
  const clay::Stiffness& stiffness = document.parts.stiffness;
  const MeshReport mesh = checkMesh(weld(surface, clay.scale));
  return {{"corners", matter.corners},
          {"bricks", matter.nodes},
          {"cubes", shape.cubes},
          {"crossing_cubes", shape.crossingCubes},
          {"edges", shape.edges},
          {"triangles", shape.triangles},
          {"components", mesh.components},
          {"mass", matter.mass},
          {"ledger", ledgerIn(document.parts, matter.mass, path)},
          {"volume", mesh.volume},
          {"area", mesh.area},
          {"bounds", boundsOf(mesh)},
          {"spacing", clay.scale.spacing},
          {"iso", clay.scale.iso},
          {"field_hash", hexDigits(fieldHash(clay))},
          {"bytes_memory", matter.bytes + surface.bytes()},
          {"bytes_file", std::filesystem::file_size(path)},
          {"history_steps", historySteps(path)},
          {"supports", document.parts.supports.size()},
          {"stiffness_corners", stiffness.any() ? statistics(*stiffness.painted).corners : 0},
          {"bytes_thumbnail", document.parts.thumbnail.size()}};
}

void printLedger(const Json& ledger) {
  for (const auto& [name, value] : ledger.items())
    fmt::print("{:<15} {}\n", "  mass " + name, value.dump());
}

void run(const std::string& path, bool json) {
  ProgressBar progress;
  const Document document = loadScene(path, progress);
  const Json description = describe(path, document);
  progress.clear();
  if (json) {
    fmt::print("{}\n", description.dump());
    return;
  }
  for (const auto& [name, value] : description.items()) {
    if (name == "ledger") {
      printLedger(value);
      continue;
    }
    fmt::print("{:<15} {}\n", name, value.is_string() ? value.get<std::string>() : value.dump());
  }
}

}  // namespace

void addInfo(CLI::App& app) {
  CLI::App* command = app.add_subcommand("info", "Tells what is in a scene");
  auto scene = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  command->add_option("scene", *scene, "The scene")->required();
  command->add_flag("--json", *json, "As one JSON object");
  command->callback([scene, json] { run(*scene, *json); });
}

}  // namespace bozzetto::cli
