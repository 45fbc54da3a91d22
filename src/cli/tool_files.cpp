#include "cli/tool_files.hpp"

#include "bozzetto/render/picture.hpp"
#include "bozzetto/render/png.hpp"

namespace bozzetto::cli {

ShelfTool toolFrom(const ToolSource& source, Progress& progress) {
  ToolLibrary library;
  ShelfTool tool = library.load(source, progress);
  if (source.region) tool.clay = sculptureOf(tool, source)->clay();
  if (source.pivot) tool.pivot = source.pivot;
  if (source.contact) tool.contact = source.contact;
  return tool;
}

Bytes pictureOf(const Clay& clay, int size, Progress& progress) {
  PictureOptions options;
  options.width = options.height = size;
  Surface<8> surface;
  surface.rebuild(clay);
  return encodePng(renderPicture(surface, clay, options, progress));
}

Bytes thumbnailOf(const Clay& clay, Progress& progress) {
  if (clay.tree.empty()) return {};
  try {
    return pictureOf(clay, 128, progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    progress.note(std::string("no thumbnail: ") + error.what());
    return {};
  }
}

}  // namespace bozzetto::cli
