// The starter library as it travels in the program: data/tools, embedded when it is built.
#pragma once
#include <span>
#include <string_view>

namespace bozzetto {

struct StarterFile {
  std::string_view name, text;  ///< without folder
};

std::span<const StarterFile> starterFiles();

}  // namespace bozzetto
