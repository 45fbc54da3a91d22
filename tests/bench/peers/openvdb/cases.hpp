// What peer_openvdb can measure.
#pragma once
#include <functional>

#include "scene.hpp"

namespace bozzetto::peer {

/// Cases without a tool are run once, others for every radius.
struct Case {
  std::string name;
  bool hasRadius;
  std::function<Result(const Job&)> run;
};

std::vector<Case> dabCases();
std::vector<Case> smoothCases();
std::vector<Case> meshCases();
std::vector<Case> fileCases();

/// One dab on the level set, a leaf at a time: swallowed leaves become tiles, the others are
/// written 8 voxels at once, in parallel.
void dabLevelSet(FloatGrid& grid, const Brush& brush, Change change);

}  // namespace bozzetto::peer
