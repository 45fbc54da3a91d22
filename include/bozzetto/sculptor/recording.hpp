// Recordings: operations as JSON Lines, after one line that says what the file is. Macro, bug
// report, regression test, benchmark and demo at once.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "bozzetto/sculptor/operation.hpp"

namespace bozzetto {

struct Recording {
  std::vector<Operation> operations;
  std::filesystem::path folder{};  ///< where its relative paths start
  /// Where each operation was read, "NAME:LINE: "; nothing for one that was not.
  std::vector<std::string> places{};

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
