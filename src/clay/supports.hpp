// Tools where they stand, supports among them.
#pragma once
#include "bozzetto/clay/stroke.hpp"
#include "clay/placed_tool.hpp"

namespace bozzetto::clay {

/// The solid of a tool with its box and sizes.
PlacedTool place(std::unique_ptr<Solid> solid, const DabPose& pose, Role role);

/// Throws Error for places beyond the workspace.
std::vector<PlacedTool> placeSupports(const std::vector<Support>& supports, double spacing);

}  // namespace bozzetto::clay
