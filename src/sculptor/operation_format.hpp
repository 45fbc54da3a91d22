// How operations look in JSON: one row an operation, a file of rows a family. A new family adds its
// structs to the variant, a file format_FAMILY.cpp with its rows and a line in operation_json.cpp.
#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "bozzetto/sculptor/operation.hpp"
#include "sculptor/json_object.hpp"

namespace bozzetto {

struct OperationFormat {
  std::size_t index;  ///< which alternative of the variant
  std::string_view name;
  Operation (*read)(JsonObject& object);
  Json (*write)(const Operation& operation);  ///< all keys but "op"
};

template <class Kind, class... Kinds>
constexpr std::size_t indexOf(const std::variant<Kinds...>*) {
  constexpr bool same[] = {std::is_same_v<Kind, Kinds>...};
  std::size_t index = 0;
  while (!same[index]) ++index;
  return index;
}

/// The row of the operation that `Read` returns and `Write` takes.
template <auto Read, auto Write>
constexpr OperationFormat formatOf(std::string_view name) {
  using Kind = decltype(Read(std::declval<JsonObject&>()));
  return {indexOf<Kind>(static_cast<const Operation*>(nullptr)), name,
          [](JsonObject& object) -> Operation { return Read(object); },
          [](const Operation& operation) -> Json { return Write(std::get<Kind>(operation)); }};
}

std::span<const OperationFormat> sceneFormats();
std::span<const OperationFormat> toolFormats();
std::span<const OperationFormat> strokeFormats();
std::span<const OperationFormat> historyFormats();
std::span<const OperationFormat> volumeFormats();
std::span<const OperationFormat> solidFormats();
std::span<const OperationFormat> clayFormats();
std::span<const OperationFormat> solidToolFormats();
std::span<const OperationFormat> shelfFormats();

// Values that many operations have.
glm::dvec3 readVector(JsonObject& object, const char* key, std::array<double, 3> fallback);
glm::dquat readRotation(JsonObject& object);
glm::dvec3 readRequiredVector(JsonObject& object, const char* key);
WorldRegion readRegion(JsonObject& object);
Json listOf(const WorldRegion& box);
ToolSource readSource(JsonObject& object, const char* key);
void writeSource(const ToolSource& source, const char* key, Json& json);
Shape readShape(JsonObject& object);      // a primitive
Shape readToolShape(JsonObject& object);  // or a freeform one
Colour readColour(JsonObject& object);
Axis readAxis(JsonObject& object, const char* key);
StepNumber readStep(JsonObject& object);
Json listOf(const glm::dvec3& v);
Json listOf(const glm::dquat& q);
Json listOf(const std::vector<StrokePoint>& points);
std::vector<StrokePoint> readPoints(JsonObject& object);

}  // namespace bozzetto
