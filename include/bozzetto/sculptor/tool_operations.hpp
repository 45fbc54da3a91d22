// Operations with tools that are sculptures.
#pragma once
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bozzetto/tool/combine.hpp"
#include "bozzetto/tool/patch.hpp"

namespace bozzetto {

/// A part of space: a box of world units, ends included, and what a lasso holds of it.
struct WorldRegion {
  glm::dvec3 low{-kEverywhere}, high{kEverywhere};
  std::optional<Lasso> lasso{};

  static constexpr double kEverywhere = std::numeric_limits<double>::infinity();
};

/// Throws Error unless max lies above min on every axis, and for a lasso that is none.
void requireValid(const WorldRegion& region);

/// What is sculpted on a plane, without it.
struct PatchSource {
  std::optional<ClayPlane> plane{};  ///< without, the one that is found under it
};

/// Where a freeform tool comes from.
struct ToolSource {
  /// A file (.bzt; .jsonl, which is replayed; a mesh; .png, which becomes a relief) or
  /// "shelf:NAME"; empty: the clay at hand.
  std::string from;
  std::optional<WorldRegion> region;  ///< that part of it only
  std::optional<PatchSource> patch;   ///< of that, what stands on a plane
  std::optional<glm::dvec3> pivot;
  std::optional<glm::dvec3> contact;
  double cells = 96;              ///< along the longest side of meshes and pictures
  double width = 64, height = 8;  ///< of pictures' reliefs, world units
  std::string text{};             ///< in place of a file: letters as a relief
  std::string font{};             ///< of these; a file; empty: a packaged one
  double letterSize = 16;         ///< of a capital with its room, world units
  double letterDepth = 4;         ///< world units

  /// The clay that is being worked on.
  bool isAtHand() const { return from.empty() && text.empty(); }
};

/// Throws Error for regions, places and directions that are none, and for sizes that are no sizes:
/// what is measured in world units lies in 1e-3 … 1e6, cells in 4 … 4096.
void requireValid(const ToolSource& source);

/// union, subtract or intersect the clay with a file's or a shelf's.
struct CombineOperation {
  ToolSource with;
  Combining how = Combining::unite;
  CombinePose pose;
};

/// Takes a part of the clay away and into the hand, as a freeform tool that adds it again.
struct CutOperation {
  WorldRegion region;
};

/// Puts a tool on the document's shelf, in the place of one of that name. No step of history.
struct ShelfKeepOperation {
  std::string name;
  std::vector<std::string> tags{};
  ToolSource source{};
  std::vector<std::string> preset{};  ///< operations that put it to use, a line of JSON each
};

/// Another name for a tool on the document's shelf.
struct ShelfRenameOperation {
  std::string name, to;
  std::optional<std::vector<std::string>> tags{};  ///< as they were without
};

/// Takes a tool from the document's shelf.
struct ShelfDropOperation {
  std::string name;
};

/// Letters as a relief on a plane through `at`.
struct TextOperation {
  std::string text;
  double size = 16;  ///< of a capital with its room, world units
  double depth = 4;  ///< world units
  CombinePose pose;
  Colour colour;
  std::string font;  ///< a file; empty: a packaged one
};

}  // namespace bozzetto
