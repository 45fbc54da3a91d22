// Reading JSON that somebody may have damaged: what is understood is taken, the rest stays as it
// is.
#pragma once
#include <nlohmann/json.hpp>

namespace bozzetto::ui {

using Json = nlohmann::ordered_json;

template <class T>
void take(const Json& json, const char* name, T& value) {
  const auto found = json.find(name);
  if (found == json.end()) return;
  try {
    value = found->get<T>();
  } catch (const Json::exception&) {
    // Left as it is.
  }
}

/// Only a number between two others.
template <class T>
void takeWithin(const Json& json, const char* name, T low, T high, T& value) {
  T read = value;
  take(json, name, read);
  if (read >= low && read <= high) value = read;
}

}  // namespace bozzetto::ui
