#include "cli/tool_files.hpp"

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include "bozzetto/base/text.hpp"
#include "bozzetto/render/picture.hpp"
#include "bozzetto/render/png.hpp"

namespace bozzetto::cli {

ShelfTool toolFrom(const ToolSource& source, Progress& progress) {
  ToolLibrary library;
  ShelfTool tool = library.load(source, progress);
  const bool isPreset = tool.clay.tree.empty() && !tool.preset.empty() && !source.region;
  return isPreset ? tool : shapedBy(source, std::move(tool));
}

namespace {

// Tools that are longer towards the clay than across it are seen from the side where they are
// widest, working end in front; flat ones (ornaments, letters) as they lie on the clay.
void turnToView(const ShelfTool& tool, PictureOptions& options) {
  const KeyBox box = statistics(tool.clay).bounds;
  const glm::dvec3 contact = glm::abs(tool.contact.value_or(glm::dvec3(0, 0, -1)));
  const Key extent = box.high - box.low;
  const bool alongZ = contact.z >= contact.x && contact.z >= contact.y;
  if (box.empty() || !alongZ || extent.k <= extent.i || extent.k <= extent.j) return;
  const bool thinInY = 5 * extent.j < 4 * extent.i;
  options.yaw = glm::radians(thinInY ? 155.0 : 128.0);
  options.pitch = glm::radians(thinInY ? 52.0 : 16.0);
}

}  // namespace

Bytes pictureOf(const ShelfTool& tool, int size, Progress& progress) {
  const Clay clay = likenessOf(tool);
  PictureOptions options;
  options.width = options.height = size;
  turnToView(tool, options);
  Surface<8> surface;
  surface.rebuild(clay);
  return encodePng(renderPicture(surface, clay, options, progress));
}

void requirePictureName(const std::string& out) {
  const std::filesystem::path path = out;
  std::error_code ignored;
  const bool device = out == "-" || std::filesystem::is_character_file(path, ignored) ||
                      std::filesystem::is_fifo(path, ignored);
  if (!device && lower(path.extension().string()) != ".png")
    throw Error(out + ": pictures are .png files, another name found");
}

Bytes thumbnailOf(const ShelfTool& tool, Progress& progress) {
  try {
    return pictureOf(tool, 128, progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    progress.note(std::string("no thumbnail: ") + error.what());
    return {};
  }
}

}  // namespace bozzetto::cli
