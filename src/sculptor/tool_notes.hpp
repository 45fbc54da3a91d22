// What is written down about a tool beside its clay, as JSON.
#pragma once
#include "bozzetto/sculptor/shelf_tool.hpp"
#include "sculptor/json_object.hpp"

namespace bozzetto {

/// What they are called among a file's settings.
inline constexpr const char* kToolSetting = "tool";

Json notesOf(const ShelfTool& tool);
/// Adds what the notes say. Throws Error, opened by `where`, for unknown keys and wrong kinds.
void readNotes(const Json& json, const std::string& where, ShelfTool& tool);

/// The n-th operation of a preset, from 0. Throws Error, opened by `where`, for what is none.
Operation presetOperation(const Json& json, const std::string& where, std::size_t n);

/// Text as JSON; deep nesting is refused while it is read. Throws Error opened by `where`.
Json parseJson(std::string_view text, const std::string& where);

}  // namespace bozzetto
