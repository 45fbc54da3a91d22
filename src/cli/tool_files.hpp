// Tools by name or file, for the subcommands of `bozzetto tool`.
#pragma once
#include <optional>
#include <string>

#include "bozzetto/sculptor/tool_library.hpp"

namespace bozzetto::cli {

/// The tool of a file or "shelf:NAME"; pictures and meshes as the source says.
ShelfTool toolFrom(const ToolSource& source, Progress& progress);

/// A picture of it, PNG, from where one sees what it is.
Bytes pictureOf(const ShelfTool& tool, int size, Progress& progress);

/// Throws Error unless the name is one of a picture: other files are not replaced by one.
void requirePictureName(const std::string& out);

/// A small one for lists; empty, with a note, where nothing can be drawn.
Bytes thumbnailOf(const ShelfTool& tool, Progress& progress);

}  // namespace bozzetto::cli
