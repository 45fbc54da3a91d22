// Names on the command line to values of an enum, with an error that lists the choices.
#pragma once
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "bozzetto/base/error.hpp"

namespace bozzetto {

template <class Enum>
Enum parseName(std::string_view what, std::string_view name,
               std::initializer_list<std::pair<std::string_view, Enum>> choices) {
  std::string list;
  for (const auto& [choice, value] : choices) {
    if (choice == name) return value;
    list += (list.empty() ? "" : ", ") + std::string(choice);
  }
  throw Error(std::string(what) + ": \"" + std::string(name) + "\" found, one of " + list +
              " expected");
}

}  // namespace bozzetto
