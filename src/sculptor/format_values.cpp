// Values that many operations have, from and to JSON.
#include "sculptor/operation_format.hpp"

namespace bozzetto {

glm::dvec3 readVector(JsonObject& object, const char* key, std::array<double, 3> fallback) {
  const auto numbers = object.numbers<3>(key, fallback);
  return {numbers[0], numbers[1], numbers[2]};
}

glm::dvec3 readRequiredVector(JsonObject& object, const char* key) {
  object.required(key);
  return readVector(object, key, {0, 0, 0});
}

glm::dquat readRotation(JsonObject& object) {
  const auto wxyz = object.numbers<4>("rotation", {1, 0, 0, 0});
  return {wxyz[0], wxyz[1], wxyz[2], wxyz[3]};
}

namespace {

using ShapeNames = std::vector<std::pair<const char*, Shape>>;
ShapeNames primitives() {
  return {{"ellipsoid", Shape::ellipsoid},
          {"box", Shape::box},
          {"cylinder", Shape::cylinder},
          {"capsule", Shape::capsule}};
}

}  // namespace

Shape readShape(JsonObject& object) {
  return object.choice<Shape>("shape", primitives(), Shape::ellipsoid);
}

Shape readToolShape(JsonObject& object) {
  ShapeNames names = primitives();
  names.emplace_back("freeform", Shape::freeform);
  return object.choice<Shape>("shape", names, Shape::ellipsoid);
}

Colour readColour(JsonObject& object) {
  if (!object.has("colour")) return {};
  try {
    return parseColour(object.text("colour"));
  } catch (const Error& error) {
    object.fail(error.what());
  }
}

Axis readAxis(JsonObject& object, const char* key) {
  return object.choice<Axis>(key, {{"x", Axis::x}, {"y", Axis::y}, {"z", Axis::z}}, Axis::y);
}

Json listOf(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }
Json listOf(const glm::dquat& q) { return Json::array({q.w, q.x, q.y, q.z}); }

namespace {

StrokePoint readPoint(const JsonObject& object, const Json& list) {
  if (!list.is_array() || (list.size() != 3 && list.size() != 4)) {
    object.fail("'points': each point has 3 coordinates and maybe a pressure");
  }
  const auto number = [&](std::size_t n) { return object.toNumber(list[n], "points"); };
  StrokePoint result{{number(0), number(1), number(2)}, list.size() == 4 ? number(3) : 1.0};
  if (result.pressure < 0 || result.pressure > 1) object.fail("'points': pressure not in 0…1");
  return result;
}

Json jsonOf(const StrokePoint& point) {
  Json list = listOf(point.position);
  if (point.pressure != 1) list.push_back(point.pressure);
  return list;
}

}  // namespace

std::vector<StrokePoint> readPoints(JsonObject& object) {
  const Json& lists = object.required("points");
  if (!lists.is_array() || lists.empty()) object.fail("points", "a list of points");
  std::vector<StrokePoint> points;
  points.reserve(lists.size());
  for (const Json& list : lists) points.push_back(readPoint(object, list));
  return points;
}

Json listOf(const std::vector<StrokePoint>& points) {
  Json lists = Json::array();
  for (const StrokePoint& point : points) lists.push_back(jsonOf(point));
  return lists;
}

StepNumber readStep(JsonObject& object) {
  object.required("step");
  const int step = object.integer("step", 0);
  if (step < 0) object.fail("step", "the number of a step");
  return static_cast<StepNumber>(step);
}

}  // namespace bozzetto
