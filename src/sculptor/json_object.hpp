// Strict reading of one JSON object: every key must be known, every value of the right kind, every
// number finite. Faults say which key, what was found and what was expected.
#pragma once
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bozzetto/base/error.hpp"

namespace bozzetto {

using Json = nlohmann::json;

class JsonObject {
 public:
  /// `where` opens every error text: "file.jsonl:12: stroke".
  JsonObject(const Json& json, std::string where) : json_(&json), where_(std::move(where)) {
    if (!json.is_object()) fail("an object expected, found " + shortText(json));
  }

  bool has(const char* key) const { return json_->contains(key); }

  double number(const char* key, double fallback) { return has(key) ? number(key) : fallback; }
  double number(const char* key) { return toNumber(required(key), key); }

  int integer(const char* key, int fallback) {
    if (!has(key)) return fallback;
    const double value = number(key);
    if (value != std::floor(value) || std::abs(value) > 1e9) fail(key, "a whole number");
    return static_cast<int>(value);
  }

  bool flag(const char* key, bool fallback) {
    if (!has(key)) return fallback;
    const Json& value = required(key);
    if (!value.is_boolean()) fail(key, "true or false");
    return value.get<bool>();
  }

  std::string text(const char* key, std::string fallback) {
    return has(key) ? text(key) : std::move(fallback);
  }
  std::string text(const char* key) {
    const Json& value = required(key);
    if (!value.is_string()) fail(key, "a text");
    return value.get<std::string>();
  }

  /// `Count` numbers, or what the fallback says.
  template <std::size_t Count>
  std::array<double, Count> numbers(const char* key, std::array<double, Count> fallback) {
    if (!has(key)) return fallback;
    const Json& list = required(key);
    if (!list.is_array() || list.size() != Count) {
      fail(key, "a list of " + std::to_string(Count) + " numbers");
    }
    for (std::size_t n = 0; n < Count; ++n) fallback[n] = toNumber(list[n], key);
    return fallback;
  }

  /// One of the named choices.
  template <class Choice>
  Choice choice(const char* key, const std::vector<std::pair<const char*, Choice>>& choices,
                Choice fallback) {
    if (!has(key)) return fallback;
    const std::string name = text(key);
    std::string names;
    for (const auto& [choiceName, value] : choices) {
      if (name == choiceName) return value;
      names += std::string(names.empty() ? "" : ", ") + choiceName;
    }
    fail(key, "one of " + names);
  }

  /// The value itself, for kinds of its own.
  const Json& required(const char* key) {
    const auto found = json_->find(key);
    if (found == json_->end()) fail("needs a key '" + std::string(key) + "'");
    used_.insert(key);
    return *found;
  }

  double toNumber(const Json& value, const char* key) const {
    if (!value.is_number())
      fail("'" + std::string(key) + "': a number expected, found " + shortText(value));
    const double result = value.get<double>();
    if (!std::isfinite(result)) fail("'" + std::string(key) + "': number is not finite");
    return result;
  }

  /// Call last: throws for the first key that nobody asked for.
  void done() const {
    for (const auto& [key, value] : json_->items()) {
      if (!used_.contains(key)) fail("unknown key '" + key.substr(0, 40) + "'");
    }
  }

  [[noreturn]] void fail(const char* key, const std::string& expected) const {
    fail("'" + std::string(key) + "': " + expected + " expected, found " +
         shortText((*json_)[key]));
  }
  /// Tells with the place what `check` finds wrong.
  template <class Check>
  void checked(Check&& check) const {
    try {
      check();
    } catch (const Error& error) {
      fail(error.what());
    }
  }

  [[noreturn]] void fail(const std::string& what) const { throw Error(where_ + ": " + what); }
  const std::string& where() const { return where_; }

 private:
  static std::string shortText(const Json& json) {
    const std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
    return text.size() <= 40 ? text : text.substr(0, 37) + "...";
  }

  const Json* json_;
  std::string where_;
  std::set<std::string, std::less<>> used_;
};

}  // namespace bozzetto
