// Recordings: operations as JSON Lines, after one line that says what the file is. Macro, bug
// report, regression test, benchmark and demo at once.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bozzetto/sculptor/operation.hpp"

namespace bozzetto {

/// The clay that a recording goes on from.
struct RecordingStart {
  std::string scene;       ///< its file's name; empty for one that was never saved
  std::uint64_t clay = 0;  ///< its field's hash
  friend bool operator==(const RecordingStart&, const RecordingStart&) = default;
};

struct Recording {
  std::vector<Operation> operations;
  std::filesystem::path folder{};  ///< where its relative paths start
  /// Where each operation was read, "NAME:LINE: "; nothing for one that was not.
  std::vector<std::string> places{};
  std::optional<RecordingStart> start{};  ///< none: it begins with nothing

  std::string placeOf(std::size_t operation) const {
    return operation < places.size() ? places[operation] : std::string();
  }
};

/// Parses the whole text. Throws Error "NAME:LINE: …" for the first line that is not right; empty
/// lines are skipped.
Recording parseRecording(std::string_view text, const std::string& name);

/// Reads a file, at most 1 GiB.
Recording readRecording(const std::filesystem::path& path);

/// Header line and one line an operation.
std::string toText(const Recording& recording);

}  // namespace bozzetto
