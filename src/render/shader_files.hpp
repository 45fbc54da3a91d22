// The .glsl files of this folder as text in the program; the table is made by cmake/shaders.cmake.
#pragma once
#include <span>
#include <string_view>

namespace bozzetto {

struct ShaderFile {
  std::string_view name;  // file name without .glsl
  std::string_view text;
};

std::span<const ShaderFile> shaderFiles();

}  // namespace bozzetto
