// bozzetto tool list|show|render: tools that are sculptures.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bozzetto/base/file.hpp"
#include "bozzetto/sculptor/recording.hpp"
#include "bozzetto/sculptor/tool_library.hpp"
#include "bozzetto/sculptor/user_tools.hpp"
#include "cli/progress_bar.hpp"
#include "cli/subcommands.hpp"
#include "cli/tool_files.hpp"

namespace bozzetto::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string_view placeOf(ToolEntry::Place place) {
  switch (place) {
    case ToolEntry::Place::document:
      return "document";
    case ToolEntry::Place::user:
      return "user";
    case ToolEntry::Place::starter:
      return "starter";
  }
  return "";
}

void list(const std::string& query, bool json) {
  Json entries = Json::array();
  for (const DamagedTool& damaged : damagedTools()) ProgressBar().note("left out: " + damaged.why);
  for (const ToolEntry& entry : ToolLibrary().list(query)) {
    if (json) {
      entries.push_back(
          {{"name", entry.name}, {"tags", entry.tags}, {"place", placeOf(entry.place)}});
    } else {
      fmt::print("{:<16} {:<9} {}\n", entry.name, placeOf(entry.place), fmt::join(entry.tags, " "));
    }
  }
  if (json) fmt::print("{}\n", entries.dump(1, ' ', false, Json::error_handler_t::replace));
}

Json listOf(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

// Of its sculpture; nothing of a preset without one.
void describeClay(const ShelfTool& tool, Json& json) {
  if (tool.clay.tree.empty() && !tool.preset.empty()) return;
  const auto sculpture = sculptureOf(tool, {});
  const double spacing = tool.clay.scale.spacing;
  const FieldStatistics counts = statistics(tool.clay);
  json["spacing"] = spacing;
  json["extent"] = listOf((2.0 * sculpture->halfExtents() - 2.0) * spacing);
  json["pivot"] = listOf((sculpture->centre() + sculpture->pivot()) * spacing);
  json["contact"] = listOf(sculpture->contact());
  json["corners"] = counts.corners;
  json["mass"] = counts.mass;
}

Json described(const ShelfTool& tool) {
  Json json{{"name", tool.name}, {"tags", tool.tags}};
  describeClay(tool, json);
  json["thumbnail_bytes"] = tool.thumbnail.size();
  json["preset"] = Json::array();
  for (const Operation& operation : tool.preset)
    json["preset"].push_back(Json::parse(toText(operation)));
  return json;
}

void show(const std::string& from) {
  ProgressBar progress;
  ToolSource source;
  source.from = from;
  const Json json = described(toolFrom(source, progress));
  progress.clear();
  fmt::print("{}\n", json.dump(1));
}

void render(const std::string& from, const std::string& out, int size) {
  requirePictureName(out);
  std::error_code ignored;
  if (std::filesystem::equivalent(from, out, ignored))
    throw Error(out + ": the picture that the tool is made of, another name expected");
  ProgressBar progress;
  ToolSource source;
  source.from = from;
  writeFile(out, pictureOf(toolFrom(source, progress), size, progress));
}

}  // namespace

void addTool(CLI::App& app) {
  CLI::App* tool = app.add_subcommand("tool", "Tools that are sculptures");
  tool->require_subcommand(1);
  addToolMake(*tool);

  auto query = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  CLI::App* lists = tool->add_subcommand("list", "Tools of the user's library and the starters");
  lists->add_option("words", *query, "Part of names or tags");
  lists->add_flag("--json", *json, "As JSON");
  lists->callback([query, json] { list(*query, *json); });

  auto from = std::make_shared<std::string>();
  auto out = std::make_shared<std::string>();
  auto size = std::make_shared<int>(512);
  CLI::App* shows = tool->add_subcommand("show", "What is known of a tool, as JSON");
  shows->add_option("tool", *from, "A file or shelf:NAME")->required();
  shows->callback([from] { show(*from); });

  CLI::App* renders = tool->add_subcommand("render", "A picture of a tool");
  renders->add_option("tool", *from, "A file or shelf:NAME")->required();
  renders->add_option("out", *out, "The picture, PNG")->required();
  renders->add_option("--size", *size, "Pixels a side")->check(CLI::Range(16, 4096));
  renders->callback([from, out, size] { render(*from, *out, *size); });
}

}  // namespace bozzetto::cli
