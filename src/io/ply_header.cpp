#include "io/ply_header.hpp"

#include <array>
#include <limits>
#include <utility>

namespace bozzetto {
namespace {

// Nobody has so many; strangers shall not make us keep more.
constexpr std::size_t kMostProperties = 4096;

PlyType readType(TextReader& text) {
  static constexpr std::pair<std::string_view, PlyType> names[] = {
      {"char", PlyType::int8},      {"uchar", PlyType::uint8},    {"short", PlyType::int16},
      {"ushort", PlyType::uint16},  {"int", PlyType::int32},      {"uint", PlyType::uint32},
      {"float", PlyType::float32},  {"double", PlyType::float64}, {"int8", PlyType::int8},
      {"uint8", PlyType::uint8},    {"int16", PlyType::int16},    {"uint16", PlyType::uint16},
      {"int32", PlyType::int32},    {"uint32", PlyType::uint32},  {"float32", PlyType::float32},
      {"float64", PlyType::float64}};
  const auto word = text.wordOfLine();
  for (const auto& [name, type] : names) {
    if (word == name) return type;
  }
  text.fail(word, "a PLY type");
}

PlyFormat readFormat(TextReader& text) {
  const auto word = text.wordOfLine();
  if (word == "ascii") return PlyFormat::ascii;
  if (word == "binary_little_endian") return PlyFormat::littleEndian;
  if (word == "binary_big_endian") return PlyFormat::bigEndian;
  text.fail(word, "ascii, binary_little_endian or binary_big_endian");
}

PlyElement readElement(TextReader& text) {
  PlyElement element;
  element.name = text.wordOfLine();
  element.count = static_cast<std::size_t>(
      text.toInteger(text.wordOfLine(), 0, std::numeric_limits<std::int64_t>::max()));
  return element;
}

// property TYPE NAME or property list TYPE TYPE NAME
PlyProperty readProperty(TextReader& text) {
  PlyProperty property;
  const auto before = text;
  if (text.wordOfLine() == "list") {
    property.countType = readType(text);
  } else {
    text = before;
  }
  property.type = readType(text);
  property.name = text.wordOfLine();
  return property;
}

}  // namespace

std::size_t sizeOf(PlyType type) {
  static constexpr std::array<std::uint8_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

PlyHeader readPlyHeader(TextReader& text) {
  PlyHeader header;
  if (const auto word = text.wordOfLine(); word != "ply") text.fail(word, "ply");
  std::size_t properties = 0;
  for (bool formatSeen = false;;) {
    text.restOfLine();
    const auto word = text.wordOfLine();
    if (word.empty() && text.atEnd()) text.fail("", "end_header");
    if (word == "format") {
      header.format = readFormat(text);
      formatSeen = true;
    } else if (word == "element") {
      header.elements.push_back(readElement(text));
    } else if (word == "property") {
      if (header.elements.empty()) text.fail(word, "element before it");
      header.elements.back().properties.push_back(readProperty(text));
    } else if (word == "end_header") {
      if (!formatSeen) text.fail(word, "format before it");
      break;
    }  // all else is comment: some writers forget to say so
    if (++properties > kMostProperties) text.fail(word, "a header of at most 4096 lines");
  }
  text.restOfLine();
  return header;
}

std::size_t leastBytes(const PlyElement& element, PlyFormat format) {
  std::size_t bytes = 0;
  for (const auto& property : element.properties) {
    // In text a digit and a blank.
    bytes += format == PlyFormat::ascii ? 2 : sizeOf(property.countType.value_or(property.type));
  }
  return bytes;
}

}  // namespace bozzetto
