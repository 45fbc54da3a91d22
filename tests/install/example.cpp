#include <bozzetto/base/colour.hpp>
#include <cstdio>

int main() {
  const bozzetto::Colour clay = bozzetto::parseColour("#ac7052");
  std::printf("%s\n", bozzetto::toText(clay).c_str());
}
