// Operations from and to JSON, one pair of functions each.
#pragma once
#include "bozzetto/sculptor/operation.hpp"
#include "sculptor/json_object.hpp"

namespace bozzetto {

Operation operationFrom(JsonObject& object);
Json toJson(const Operation& operation);

}  // namespace bozzetto
