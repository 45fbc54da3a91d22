#include "bozzetto/io/voxelise.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "bozzetto/base/parallel.hpp"
#include "io/block_kernel.hpp"
#include "io/empty_rows.hpp"
#include "io/grid_mesh.hpp"
#include "io/mesh_fit.hpp"

namespace bozzetto {
namespace {

using Block = CornerBlock<8>;

constexpr std::size_t kBatch = 4096;
constexpr std::size_t kMostBlocks = std::size_t{1} << 23;
constexpr int kReach = 1;

// Keeps the greater value of two blocks, with its colour.
void keepGreater(const Block& old, Block& block) {
  for (int n = 0; n < Block::kCount; ++n) {
    if (old.value[n] < block.value[n]) continue;
    block.value[n] = old.value[n];
    block.attributes[n] = old.attributes[n];
  }
}

std::vector<BlockTask> tasksOf(const std::vector<BlockTriangle>& pairs) {
  std::vector<BlockTask> tasks;
  for (std::size_t first = 0; first < pairs.size();) {
    std::size_t last = first;
    while (last < pairs.size() && pairs[last].block == pairs[first].block) ++last;
    tasks.push_back({unpackBlock(pairs[first].block), BlockKind::sheets,
                     std::span(pairs).subspan(first, last - first)});
    first = last;
  }
  if (tasks.size() <= kMostBlocks) return tasks;
  throw Error("import: found a surface of " + std::to_string(tasks.size()) +
              " blocks, expected at most 2^23: take fewer cells");
}

class Voxeliser {
 public:
  Voxeliser(const GridMesh& grid, Colour colour, Edit<Block>& edit, Progress& progress)
      : grid_(grid), winding_(grid.mesh), colour_(colour), edit_(edit), progress_(progress) {}

  // Returns whether any corner is inside.
  bool run() {
    progress_.step("Finding the surface", 0);
    const auto pairs = touchedBlocks(grid_.mesh.positions, grid_.mesh.triangles, kReach);
    auto tasks = tasksOf(pairs);
    const auto rows = emptyRows(grid_, winding_, tasks, progress_);
    for (std::size_t first = 0; first < tasks.size(); first += kBatch) {
      progress_.step("Filling the surface", double(first) / double(tasks.size()));
      fillBatch(std::span(tasks).subspan(first, std::min(kBatch, tasks.size() - first)));
    }
    for (const auto& row : rows) {
      edit_.replace({row.key + grid_.firstBlock, row.length},
                    Block::uniform(1, packAttributes(colour_)));
    }
    progress_.step("Filling the surface", 1);
    return inside_ || !rows.empty();
  }

 private:
  // Blocks are made and handed over here; threads only fill them.
  void fillBatch(std::span<const BlockTask> tasks) {
    std::vector<Ref<Block>> blocks;
    for (std::size_t n = 0; n < tasks.size(); ++n) blocks.push_back(edit_.fresh());
    std::vector<std::uint8_t> clay(tasks.size(), 0), inside(tasks.size(), 0);
    parallelFor(tasks.size(), 8, [&](std::size_t begin, std::size_t end) {
      BlockKernel kernel(grid_, winding_, colour_);
      for (std::size_t n = begin; n < end; ++n) {
        Block& block = *blocks[n];
        clay[n] = kernel.fill(tasks[n], block);
        inside[n] = std::any_of(block.value.begin(), block.value.end(),
                                [](float value) { return value > 0.5f; });
        const Block* old = edit_.read(tasks[n].block + grid_.firstBlock);
        if (old != nullptr) keepGreater(*old, block);
        block.updateRange();
      }
    });
    for (std::size_t n = 0; n < tasks.size(); ++n) {
      inside_ = inside_ || inside[n] != 0;
      if (clay[n] != 0) edit_.replace({tasks[n].block + grid_.firstBlock, 1}, blocks[n]);
    }
  }

  const GridMesh& grid_;
  WindingTree winding_;
  Colour colour_;
  Edit<Block>& edit_;
  Progress& progress_;
  bool inside_ = false;
};

void requirePositive(double number, const char* what) {
  if (number > 0 && std::isfinite(number)) return;
  throw Error(std::string("import: found ") + what + " " + std::to_string(number) +
              ", expected a number above 0");
}

}  // namespace

double importSpacing(const TriangleMesh& mesh, const ImportOptions& options) {
  if (options.spacing != 0) {
    requirePositive(options.spacing, "spacing");
    return options.spacing;
  }
  requirePositive(options.cells, "cells");
  MeshBounds bounds;
  for (const auto& t : mesh.triangles) {
    for (const auto v : t) bounds.add(mesh.positions[v]);
  }
  const double spacing = bounds.longestSide() / options.cells;
  if (spacing > 0 && std::isfinite(spacing)) return spacing;
  throw Error("import: found a mesh without extent, expected one with volume");
}

ImportReport voxelise(const TriangleMesh& mesh, const ImportOptions& options,
                      Edit<CornerBlock<8>>& edit, Progress& progress) {
  validate(mesh, "import");
  ImportReport report;
  report.spacing = importSpacing(mesh, options);
  progress.step("Checking the mesh", 0);
  const GridMesh grid = makeGridMesh(mesh, report.spacing, report);
  if (!Voxeliser(grid, options.colour, edit, progress).run()) {
    throw Error("import: found a mesh without volume at a spacing of " +
                std::to_string(report.spacing) + ", expected one that holds clay");
  }
  measureFit(grid, edit.tree(), report);
  return report;
}

}  // namespace bozzetto
