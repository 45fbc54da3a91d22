#include "bozzetto/sculptor/tool_library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "bozzetto/base/text.hpp"
#include "bozzetto/io/mesh_file.hpp"
#include "bozzetto/io/relief.hpp"
#include "bozzetto/io/voxelise.hpp"
#include "bozzetto/sculptor/replay.hpp"
#include "bozzetto/tool/relative.hpp"
#include "sculptor/nested_tools.hpp"
#include "sculptor/operation_format.hpp"

namespace bozzetto {
namespace {

namespace fs = std::filesystem;
constexpr int kDeepest = 8;
constexpr std::string_view kShelf = "shelf:";

Clay partIn(const Clay& clay, const WorldRegion& region) {
  const KeyBox box = cornersIn(region, clay.scale.spacing);
  return region.lasso ? partOf(clay, box, *region.lasso) : partOf(clay, box);
}

std::string keyOf(const ToolSource& s) {
  std::string key = fmt::format("{} {} {} {}", s.from, s.cells, s.width, s.height);
  key += fmt::format(" {} {} {} {}", s.text, s.font, s.letterSize, s.letterDepth);
  const auto add = [&](const glm::dvec3& v) { key += fmt::format(" {} {} {}", v.x, v.y, v.z); };
  if (s.region) key += " " + listOf(*s.region).dump();
  key += s.patch ? " patch" : "";
  if (s.patch && s.patch->plane) {
    add(s.patch->plane->at);
    add(s.patch->plane->normal);
  }
  key += s.pivot ? " pivot" : "";
  if (s.pivot) add(*s.pivot);
  key += s.contact ? " contact" : "";
  if (s.contact) add(*s.contact);
  return key;
}

bool hasMeshName(const fs::path& path) {
  try {
    meshFormatOf(path);
    return true;
  } catch (const Error&) {
    return false;
  }
}

// Meshes are known by their content too; what is none may be meant as another source.
TriangleMesh readSourceMesh(const fs::path& path, Progress& progress) {
  std::error_code ignored;
  try {
    return readMesh(path, progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {
    if (hasMeshName(path) || !fs::is_regular_file(path, ignored)) throw;
    throw Error(path.string() +
                ": no source of tools found, .bzt .jsonl .png .stl .ply .obj .off " +
                "or .glb expected");
  }
}

Clay clayOfMesh(const fs::path& path, const ToolSource& source, Progress& progress) {
  const TriangleMesh mesh = readSourceMesh(path, progress);
  ImportOptions options;
  options.cells = source.cells;
  Clay clay;
  clay.scale.spacing = importSpacing(mesh, options);
  const double longest = clay.scale.spacing * source.cells;
  if (!(longest >= 1e-6 && longest <= 1e9))
    throw Error(fmt::format("{}: longest side {:g} found, 1e-06 to 1e+09 expected", path.string(),
                            longest));
  Edit<CornerBlock<8>> edit(clay.tree);
  voxelise(mesh, options, edit, progress);
  edit.commit();
  return clay;
}

Clay clayOfPicture(const fs::path& path, const ToolSource& source) {
  const GreyImage image = readGreyPng(path);
  const double longest =
      source.width * std::max(1.0, double(image.height) / double(std::max(image.width, 1)));
  try {
    return relief(image, {source.width, source.height, longest / source.cells, {}});
  } catch (const Error& error) {
    throw Error(path.string() + ": " + error.what());
  }
}

// 64 cells a capital.
ShelfTool letters(const fs::path& folder, const ToolSource& source, Progress& progress) {
  const double cell = source.letterSize / 64;
  if (source.letterDepth < 2 * cell)
    progress.note(
        fmt::format("text: {:g} deep letters of size {:g} are less than two cells of {:g}; "
                    "they stand a cell high",
                    source.letterDepth, source.letterSize, cell));
  TextOptions options;
  if (!source.font.empty()) options.font = folder / source.font;
  const GreyImage image = drawText(source.text, options);
  const double width = image.width * source.letterSize / options.pixels;
  ShelfTool tool;
  const std::size_t first = source.text.find_first_not_of(' ');
  tool.name = source.text.substr(first, source.text.find_last_not_of(' ') + 1 - first);
  tool.clay = standingText(image, {width, source.letterDepth, cell, {}});
  tool.pivot = glm::dvec3(0);
  return tool;
}

Clay clayOfRecording(const fs::path& path, int depth, Progress& progress) {
  if (depth >= kDeepest) throw NestedTools();
  ReplayOptions options;
  options.depth = depth + 1;
  try {
    return replay(readRecording(path), {}, options, progress).field;
  } catch (NestedTools& nested) {
    nested.add(path.string());
    if (depth > 0) throw;
    throw Error(nested.sentence());
  }
}

fs::path fileIn(const fs::path& folder, const std::string& name) {
  const bool plain = !name.empty() && name.front() != '.' && name.find('/') == name.npos;
  return plain ? folder / (name + ".bzt") : fs::path();
}

}  // namespace

ShelfTool shapedBy(const ToolSource& source, ShelfTool tool) {
  const auto sculpture = sculptureOf(tool, source);
  tool.clay = sculpture->clay();
  if (source.region || source.patch) tool.thumbnail.clear();
  if (source.pivot || source.patch)
    tool.pivot = (sculpture->centre() + sculpture->pivot()) * sculpture->scale().spacing;
  if (source.contact || source.patch) tool.contact = sculpture->contact();
  return tool;
}

KeyBox cornersIn(const WorldRegion& region, double spacing) {
  KeyBox corners;
  for (const Axis axis : kAxes) {
    const int a = index(axis);
    const double low = std::ceil(region.low[a] / spacing);
    const double high = std::floor(region.high[a] / spacing);
    constexpr double rim = kWorkspaceRim;
    corners.low[axis] = static_cast<std::int32_t>(std::clamp(low, -rim, rim));
    corners.high[axis] = static_cast<std::int32_t>(std::clamp(high, -rim, rim));
  }
  return corners;
}

std::vector<ToolEntry> ToolLibrary::list(std::string_view query) const {
  std::vector<ToolEntry> entries;
  for (const ShelfItem& item : shelf)
    entries.push_back({item.name, item.tags, ToolEntry::Place::document});
  std::error_code ignored;
  for (const auto& file : fs::directory_iterator(userToolFolder(), ignored)) {
    if (file.path().extension() != ".bzt") continue;
    try {
      const ShelfTool tool = loadTool(file.path());
      entries.push_back({file.path().stem().string(), tool.tags, ToolEntry::Place::user});
    } catch (const Error&) {
      continue;  // a list shows what can be used
    }
  }
  for (ToolEntry& entry : starterTools()) entries.push_back(std::move(entry));
  std::erase_if(entries, [&](const ToolEntry& entry) { return !matches(entry, query); });
  std::ranges::stable_sort(entries, [](const ToolEntry& a, const ToolEntry& b) {
    return std::tie(a.place, a.name) < std::tie(b.place, b.name);
  });
  return entries;
}

ShelfTool ToolLibrary::find(const std::string& name, Progress& progress) const {
  const auto item = std::ranges::find(shelf, name, &ShelfItem::name);
  if (item != shelf.end()) return fromItem(*item);
  const fs::path file = fileIn(userToolFolder(), name);
  std::error_code ignored;
  if (!file.empty() && fs::exists(file, ignored)) {
    if (isStarter(name))
      progress.note("shelf:" + name + ": the user's library has one, the starter is not meant");
    return loadTool(file, progress);
  }
  if (isStarter(name)) return makeStarter(name, progress);
  throw Error(
      fmt::format("no tool is called '{}': neither on the document's shelf, nor in {}, nor "
                  "among the starters",
                  name.substr(0, 40), userToolFolder().string()));
}

ShelfTool ToolLibrary::load(const ToolSource& source, Progress& progress) const {
  requireValid(source);
  if (!source.text.empty()) return letters(folder, source, progress);
  if (source.from.starts_with(kShelf)) return find(source.from.substr(kShelf.size()), progress);
  if (source.from.empty()) throw Error("tool: no source found, a file or shelf:NAME expected");
  const fs::path path = folder / source.from;
  const std::string extension = lower(path.extension().string());
  if (extension == ".bzt") return loadTool(path, progress);
  ShelfTool tool;
  tool.name = path.stem().string();
  tool.clay = extension == ".jsonl" ? clayOfRecording(path, depth, progress)
              : extension == ".png" ? clayOfPicture(path, source)
                                    : clayOfMesh(path, source, progress);
  return tool;
}

std::shared_ptr<const Sculpture> ToolLibrary::sculpture(const ToolSource& source,
                                                        Progress& progress) {
  auto& kept = kept_[keyOf(source)];
  if (kept != nullptr) return kept;
  const bool fromShelf = source.text.empty() && source.from.starts_with(kShelf);
  kept = sculptureOf(fromShelf ? shelfTool(source, progress) : load(source, progress), source);
  return kept;
}

// Another pivot of the same tool needs no second reading.
const ShelfTool& ToolLibrary::shelfTool(const ToolSource& source, Progress& progress) {
  auto read = read_.find(source.from);
  if (read == read_.end()) read = read_.emplace(source.from, load(source, progress)).first;
  return read->second;
}

void ToolLibrary::forget() {
  kept_.clear();
  read_.clear();
}

namespace {

// What stands on the plane, its root to the clay and on strokes.
Clay patchOf(const Clay& clay, const PatchSource& patch, SculptureOptions& options) {
  const auto plane = patch.plane ? patch.plane : planeUnder(clay);
  if (!plane) throw Error("patch: no plane found under it; its place and normal expected");
  Clay standing = standingOn(clay, *plane);
  const KeyBox bounds = boundsOf(standing);
  const glm::dvec3 middle = (glm::dvec3(bounds.low.i, bounds.low.j, bounds.low.k) +
                             glm::dvec3(bounds.high.i, bounds.high.j, bounds.high.k)) *
                            (clay.scale.spacing / 2);
  const glm::dvec3 up = glm::normalize(plane->normal);
  options.contact = -up;
  if (!bounds.empty()) options.pivot = middle - glm::dot(middle - plane->at, up) * up;
  return standing;
}

std::string extentOf(const Clay& clay) {
  const KeyBox box = boundsOf(clay);
  const auto place = [&](Key key) {
    return toText(glm::dvec3(key.i, key.j, key.k) * clay.scale.spacing);
  };
  return place(box.low) + " to " + place(box.high);
}

// Of a source without clay, or without any in what was asked for.
std::string whyEmpty(const ShelfTool& tool, const ToolSource& source) {
  const std::string what = source.from.empty() ? "the document" : source.from;
  if (tool.clay.tree.empty())
    return what + (tool.preset.empty() ? "" : " is a preset and") + " holds no clay";
  const char* part = !source.patch ? "region" : source.region ? "patch of that region" : "patch";
  return what + " holds no clay in the " + part + "; it has some from " + extentOf(tool.clay);
}

}  // namespace

std::shared_ptr<const Sculpture> sculptureOf(const ShelfTool& tool, const ToolSource& source) {
  SculptureOptions options;
  options.pivot = tool.pivot;
  options.contact = tool.contact.value_or(options.contact);
  Clay clay = tool.clay;
  if (source.region) clay = partIn(clay, *source.region);
  if (source.patch) clay = patchOf(clay, *source.patch, options);
  if (source.pivot) options.pivot = source.pivot;
  if (source.contact) options.contact = *source.contact;
  if (clay.tree.empty()) throw Error("freeform tool: " + whyEmpty(tool, source));
  return std::make_shared<Sculpture>(std::move(clay), options);
}

}  // namespace bozzetto
