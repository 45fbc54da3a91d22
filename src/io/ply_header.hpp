// The head of a PLY file: what elements follow, with which properties of which types.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/text_reader.hpp"

namespace bozzetto {

enum class PlyFormat { ascii, littleEndian, bigEndian };

enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of a number in a binary file.
std::size_t sizeOf(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> countType;  ///< of lists
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
};

/// Reads up to and with the line `end_header`. Throws Error with the line.
PlyHeader readPlyHeader(TextReader& text);

/// The least bytes one element takes in the file; 0 for elements without properties.
std::size_t leastBytes(const PlyElement& element, PlyFormat format);

}  // namespace bozzetto
