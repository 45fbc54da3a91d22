// Operations from and to JSON: the rows of all families in one table.
#include "sculptor/operation_json.hpp"

#include <algorithm>
#include <cassert>

#include "sculptor/operation_format.hpp"

namespace bozzetto {
namespace {

// In the variant's order, so that a row is found by index.
const std::vector<OperationFormat>& formats() {
  static const std::vector<OperationFormat> all = [] {
    std::vector<OperationFormat> rows;
    for (const auto family :
         {sceneFormats, toolFormats, strokeFormats, historyFormats, solidFormats, solidToolFormats,
          clayFormats, volumeFormats, shelfFormats}) {
      for (const OperationFormat& row : family()) rows.push_back(row);
    }
    std::ranges::sort(rows, {}, &OperationFormat::index);
    assert(rows.size() == std::variant_size_v<Operation>);
    return rows;
  }();
  return all;
}

}  // namespace

Operation operationFrom(JsonObject& object) {
  const std::string name = object.text("op");
  const auto row = std::ranges::find(formats(), name, &OperationFormat::name);
  if (row == formats().end()) object.fail("unknown operation '" + name.substr(0, 40) + "'");
  Operation operation = row->read(object);
  object.done();
  return operation;
}

Json toJson(const Operation& operation) {
  Json json = formats()[operation.index()].write(operation);
  json["op"] = nameOf(operation);
  return json;
}

std::string_view nameOf(const Operation& operation) { return formats()[operation.index()].name; }

std::string toText(const Operation& operation) { return toJson(operation).dump(); }

}  // namespace bozzetto
