// bozzetto tool make: a tool from a scene, recording, mesh, picture, letters, or a preset alone.
#include <fmt/format.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "bozzetto/base/file_system.hpp"
#include "bozzetto/base/text.hpp"
#include "bozzetto/sculptor/recording.hpp"
#include "bozzetto/sculptor/tool_library.hpp"
#include "cli/progress_bar.hpp"
#include "cli/subcommands.hpp"
#include "cli/tool_files.hpp"

namespace bozzetto::cli {
namespace {

using Json = nlohmann::ordered_json;

struct MakeArguments {
  ToolSource source;
  std::string out, tags, preset, lasso;
  std::optional<std::string> name, text;
  std::vector<double> region, plane, pivot, contact;
  bool replace = false, patch = false;

  bool presetOnly() const { return source.isAtHand() && !preset.empty(); }
};

std::optional<glm::dvec3> vectorOf(const std::vector<double>& numbers) {
  if (numbers.size() != 3) return std::nullopt;
  return glm::dvec3(numbers[0], numbers[1], numbers[2]);
}

std::vector<std::string> wordsOf(const std::string& list) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size());
    if (end > at) words.push_back(list.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

// A region as recordings have it, read by the reader of recordings.
WorldRegion regionFrom(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("lasso"))
    throw Error(R"(--lasso: {"lasso":[[x,y],…],"view":{…}} expected)");
  const Json line{{"op", "tool"}, {"shape", "freeform"}, {"region", json}};
  return *std::get<ToolOperation>(parseOperation(line.dump(), "--lasso")).source->region;
}

// What a recording says of the hand.
std::vector<Operation> presetFrom(const std::string& path) {
  if (path.empty()) return {};
  const Recording recording = readRecording(path);
  std::vector<Operation> preset;
  for (std::size_t n = 0; n < recording.operations.size(); ++n) {
    const Operation& operation = recording.operations[n];
    if (!isOfPreset(operation)) continue;
    try {
      requireOfPreset(operation);
    } catch (const Error& error) {
      throw Error(recording.placeOf(n) + error.what());
    }
    preset.push_back(operation);
  }
  if (preset.empty()) throw Error(path + ": no tool, action, stroke or clay found, one expected");
  return preset;
}

ToolSource sourceOf(const MakeArguments& arguments) {
  ToolSource source = arguments.source;
  if (arguments.text) {
    if (arguments.text->empty()) throw Error("--text: nothing found, letters expected");
    source.text = *arguments.text;
  }
  const auto& r = arguments.region;
  if (r.size() == 6) source.region = WorldRegion{{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, {}};
  if (!arguments.lasso.empty()) source.region = regionFrom(arguments.lasso);
  const auto& p = arguments.plane;
  if (arguments.patch) source.patch.emplace();
  if (p.size() == 6) source.patch = {ClayPlane{{p[0], p[1], p[2]}, {p[3], p[4], p[5]}}};
  source.pivot = vectorOf(arguments.pivot);
  source.contact = vectorOf(arguments.contact);
  if (source.isAtHand() ? arguments.preset.empty() : !source.from.empty() && !source.text.empty())
    throw Error("tool make: either a source, --text or --preset expected");
  if (source.isAtHand() && (source.region || source.patch || source.pivot || source.contact))
    throw Error("tool make: a preset alone has no region, patch, pivot or contact");
  requireValid(source);
  return source;
}

std::vector<std::string> tagsFrom(const std::string& list) {
  std::vector<std::string> tags = wordsOf(list);
  for (const std::string& tag : tags)
    if (!isOneLine(tag) || tag.size() > 255)
      throw Error("--tags: words of up to 255 bytes, UTF-8 in one line, expected");
  return tags;
}

// Whether tools of that file's name are found as `shelf:NAME`.
bool isInLibrary(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::equivalent(file.parent_path(), userToolFolder(), ignored);
}

[[noreturn]] void refuseTaken(const std::filesystem::path& out) {
  throw Error(out.string() + ": exists already; --replace replaces it");
}

// Never in the place of a file, not even of one that somebody else puts there meanwhile.
void saveNew(const std::filesystem::path& out, const ShelfTool& tool) {
  const auto draft = out.parent_path() / fmt::format(".bozzetto-tool-{}", ::getpid());
  saveTool(draft, tool);
  try {
    FileSystem::real().rename(draft, out, Existing::refuse);
  } catch (const FileError&) {
    std::error_code ignored;
    std::filesystem::remove(draft, ignored);
    if (std::filesystem::exists(out, ignored)) refuseTaken(out);
    throw;
  }
}

// Where the tool goes; refuses names, and what must not be replaced.
std::filesystem::path placeFor(const ShelfTool& tool, const MakeArguments& arguments) {
  std::filesystem::path out = arguments.out;
  requireToolName(tool.name);
  if (arguments.name || out.empty()) {
    const auto inLibrary = userToolFile(tool.name);
    if (out.empty()) out = inLibrary;
  }
  const std::string name = out.stem().string();
  if (out.extension() != ".bzt")
    throw Error(out.string() + ": tools are .bzt files, another name found");
  std::error_code ignored;
  const auto folder = out.parent_path();
  if (!arguments.out.empty() && !folder.empty() && !std::filesystem::is_directory(folder, ignored))
    throw Error(out.string() + ": no such folder");
  if (arguments.replace) return out;
  if (std::filesystem::exists(out, ignored)) refuseTaken(out);
  if (isStarter(name) && (arguments.out.empty() || isInLibrary(out)))
    throw Error(name + ": a starter is called so, and recordings that say shelf:" + name +
                " would get this tool; another --name, or --replace, expected");
  return out;
}

void make(const MakeArguments& arguments) {
  ProgressBar progress;
  const ToolSource source = sourceOf(arguments);
  const auto preset = presetFrom(arguments.preset);
  ShelfTool tool;
  if (arguments.presetOnly()) {
    tool.name = std::filesystem::path(arguments.preset).stem().string();
  } else {
    tool = toolFrom(source, progress);  // refuses what is no tool
  }
  if (arguments.name) tool.name = *arguments.name;
  if (!arguments.tags.empty()) tool.tags = tagsFrom(arguments.tags);
  if (!preset.empty()) tool.preset = preset;
  const std::filesystem::path out = placeFor(tool, arguments);
  tool.thumbnail = thumbnailOf(tool, progress);
  if (arguments.out.empty()) std::filesystem::create_directories(userToolFolder());
  arguments.replace ? saveTool(out, tool) : saveNew(out, tool);
  progress.clear();
  fmt::print("{}\n", out.string());
}

}  // namespace

void addToolMake(CLI::App& tool) {
  auto a = std::make_shared<MakeArguments>();
  CLI::App* command = tool.add_subcommand("make", "Makes a tool: one .bzt file");
  command->add_option("source", a->source.from,
                      ".bzt, .jsonl (replayed), a mesh, .png (relief), shelf:NAME");
  command->add_option("-o,--out", a->out, "The tool's file; the user's library without");
  command->add_option("--name", a->name, "What it is called");
  command->add_option("--tags", a->tags, "Words, separated by commas");
  CLI::Option* box =
      command->add_option("--region", a->region, "That part of the source: min x y z, max x y z")
          ->expected(6);
  command
      ->add_option("--lasso", a->lasso,
                   "That part, seen through an outline: a region as recordings have it")
      ->excludes(box);
  command->add_flag("--patch", a->patch,
                    "What stands on the plane under most of it, undercuts too, without the plane");
  command->add_option("--plane", a->plane, "A patch on this plane: place x y z and normal x y z")
      ->expected(6);
  command->add_option("--pivot", a->pivot, "The place that lies on strokes: x y z")->expected(3);
  command->add_option("--contact", a->contact, "Direction to the clay (0 0 -1)")->expected(3);
  command->add_option("--cells", a->source.cells, "Along the longest side of meshes and pictures");
  command->add_option("--width", a->source.width, "Of a picture's relief, world units");
  command->add_option("--height", a->source.height, "Of white in it, world units");
  command->add_option("--text", a->text, "Letters in place of a source");
  command->add_option("--font", a->source.font, "A font file in place of the packaged one");
  command->add_option("--size", a->source.letterSize,
                      "Of a capital letter with its room, world units");
  command->add_option("--depth", a->source.letterDepth, "Of letters, world units");
  command->add_option("--preset", a->preset,
                      "A recording whose tool, action, stroke go with it, or stand alone");
  command->add_flag("--replace", a->replace, "In the place of a file or starter of that name");
  command->callback([a] { make(*a); });
}

}  // namespace bozzetto::cli
