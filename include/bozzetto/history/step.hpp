// What is known of a step of history besides the clay it changed.
#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "bozzetto/field/field.hpp"

namespace bozzetto {

/// The scene's 16 bytes: a history belongs to one scene.
using HistoryIdentity = std::array<std::uint8_t, 16>;

/// Counts up from 1 in the order in which steps were made, branches included. 0 is the state before
/// the first.
using StepNumber = std::uint32_t;

/// What the one who makes a step knows about it.
struct StepNote {
  std::string label;         ///< for people: "stroke", "fill"; at most 255 bytes are kept
  FieldScale before, after;  ///< of the field
};

struct Step {
  StepNumber number = 0;
  StepNumber parent = 0;         ///< the state it was made from
  std::uint64_t mark = 0;        ///< random: tells steps of the same number apart
  std::uint64_t parentMark = 0;  ///< 0 for step 0
  std::int64_t time = 0;         ///< milliseconds since 1970, UTC
  StepNote note;
  std::uint64_t changedBlocks = 0;
  std::uint64_t changedCorners = 0;  ///< known once it is written
  std::uint64_t bytes = 0;           ///< of its undo-file; 0 while there is none
};

}  // namespace bozzetto
