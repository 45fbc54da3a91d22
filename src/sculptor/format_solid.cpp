// solid, solid_move, bake, wrap, wrap_apply, solid_drop in JSON.
#include "sculptor/operation_format.hpp"

namespace bozzetto {
namespace {

Key readKey(const JsonObject& object, const Json& list, const char* name) {
  if (!list.is_array() || list.size() != 3)
    object.fail("'" + std::string(name) + "': three whole numbers expected");
  Key key;
  for (const Axis axis : kAxes) {
    const double value = object.toNumber(list[static_cast<std::size_t>(index(axis))], name);
    if (value != std::floor(value) || std::abs(value) > 1e9)
      object.fail("'" + std::string(name) + "': three whole numbers expected");
    key[axis] = static_cast<std::int32_t>(value);
  }
  return key;
}

Key readKey(JsonObject& object, const char* name, Key fallback) {
  return object.has(name) ? readKey(object, object.required(name), name) : fallback;
}

Json listOfKey(Key key) { return Json::array({key.i, key.j, key.k}); }

int readLevels(JsonObject& object, int fallback) {
  const int levels = object.integer("levels", fallback);
  if (levels < 0 || levels > 6) object.fail("levels", "0 to 6");
  return levels;
}

SolidOperation readSolid(JsonObject& object) {
  SolidOperation solid;
  solid.block.cells = readKey(object, "cells", {2, 2, 2});
  solid.block.edge = glm::dvec3(object.number("edge", 20));
  solid.block.centre = readVector(object, "center", {0, 0, 0});
  if (object.has("removed")) {
    const Json& lists = object.required("removed");
    if (!lists.is_array()) object.fail("removed", "a list of cells");
    for (const Json& list : lists) solid.block.removed.push_back(readKey(object, list, "removed"));
  }
  return solid;
}

Json writeSolid(const SolidOperation& solid) {
  Json removed = Json::array();
  for (const Key cell : solid.block.removed) removed.push_back(listOfKey(cell));
  return {{"cells", listOfKey(solid.block.cells)},
          {"edge", solid.block.edge.x},
          {"center", listOf(solid.block.centre)},
          {"removed", removed}};
}

SolidMoveOperation readMove(JsonObject& object) {
  SolidMoveOperation move;
  const Json& point = object.required("point");
  if (point.is_number()) {
    const double number = object.toNumber(point, "point");
    if (number != std::floor(number) || number < 0 || number > 1e9)
      object.fail("point", "[i, j, k] or a whole number");
    move.point = static_cast<Id>(number);
  } else {
    move.point = readKey(object, point, "point");
  }
  object.required("by");
  move.by = readVector(object, "by", {0, 0, 0});
  return move;
}

Json writeMove(const SolidMoveOperation& move) {
  const bool named = std::holds_alternative<Key>(move.point);
  const Json point = named ? listOfKey(std::get<Key>(move.point)) : Json(std::get<Id>(move.point));
  return {{"point", point}, {"by", listOf(move.by)}};
}

BakeOperation readBake(JsonObject& object) { return {{readLevels(object, 2), readColour(object)}}; }

Json writeBake(const BakeOperation& bake) {
  return {{"levels", bake.options.levels}, {"colour", toText(bake.options.colour)}};
}

WrapOperation readWrap(JsonObject& object) {
  WrapOperation wrap;
  wrap.cells = readKey(object, "cells", {4, 4, 4});
  if (object.has("min") != object.has("max")) object.fail("'min' and 'max' go together");
  if (object.has("min"))
    wrap.box = {readVector(object, "min", {0, 0, 0}), readVector(object, "max", {0, 0, 0})};
  return wrap;
}

Json writeWrap(const WrapOperation& wrap) {
  Json json{{"cells", listOfKey(wrap.cells)}};
  if (wrap.box) {
    json["min"] = listOf((*wrap.box)[0]);
    json["max"] = listOf((*wrap.box)[1]);
  }
  return json;
}

WrapApplyOperation readApply(JsonObject& object) {
  WrapApplyOperation apply;
  apply.options.levels = readLevels(object, 2);
  apply.options.keepMass = object.flag("keep_mass", true) ? KeepMass::yes : KeepMass::no;
  return apply;
}

Json writeApply(const WrapApplyOperation& apply) {
  return {{"levels", apply.options.levels}, {"keep_mass", apply.options.keepMass == KeepMass::yes}};
}

SolidDropOperation readDrop(JsonObject&) { return {}; }
Json writeDrop(const SolidDropOperation&) { return Json::object(); }

}  // namespace

std::span<const OperationFormat> solidFormats() {
  static constexpr OperationFormat kFormats[] = {
      formatOf<readSolid, writeSolid>("solid"),      formatOf<readMove, writeMove>("solid_move"),
      formatOf<readBake, writeBake>("bake"),         formatOf<readWrap, writeWrap>("wrap"),
      formatOf<readApply, writeApply>("wrap_apply"), formatOf<readDrop, writeDrop>("solid_drop")};
  return kFormats;
}

}  // namespace bozzetto
