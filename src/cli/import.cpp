// bozzetto import MESH -o SCENE: a triangle mesh becomes clay.
#include <fmt/format.h>

#include "bozzetto/base/file.hpp"
#include "bozzetto/io/mesh_file.hpp"
#include "bozzetto/io/voxelise.hpp"
#include "bozzetto/render/thumbnail.hpp"
#include "bozzetto/scene/scene_file.hpp"
#include "cli/progress_bar.hpp"
#include "cli/subcommands.hpp"

namespace bozzetto::cli {
namespace {

struct Arguments {
  std::string mesh, out, colour;
  std::optional<int> cells;
  std::optional<double> spacing;
};

ImportOptions optionsOf(const Arguments& arguments) {
  ImportOptions options;
  if (arguments.cells) options.cells = *arguments.cells;
  if (arguments.spacing) options.spacing = *arguments.spacing;
  if (!arguments.colour.empty()) options.colour = parseColour(arguments.colour);
  return options;
}

void tell(const ImportReport& report) {
  fmt::print("spacing {:.6g}, {} corners, {} parts", report.spacing, report.corners, report.parts);
  if (report.openEdges > 0) fmt::print(", {} open edges closed", report.openEdges);
  if (report.turned > 0) fmt::print(", {} triangles turned", report.turned);
  fmt::print("; the mesh lies within {:.2f} cells of the clay's surface (mean {:.3f})\n",
             report.fitMax, report.fitMean);
}

void run(const Arguments& arguments) {
  ProgressBar progress;
  const TriangleMesh mesh = readMesh(arguments.mesh, progress);
  const ImportOptions options = optionsOf(arguments);
  Document document;
  document.field.scale.spacing = importSpacing(mesh, options);
  Edit<CornerBlock<8>> edit(document.field.tree);
  const ImportReport report = voxelise(mesh, options, edit, progress);
  edit.commit();
  document.parts.thumbnail = thumbnailOf(document.field);
  saveScene(arguments.out, document, progress);
  progress.clear();
  if (!isStandardOutput(arguments.out)) tell(report);
}

}  // namespace

void addImport(CLI::App& app) {
  CLI::App* command = app.add_subcommand("import", "Makes clay of a triangle mesh");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("mesh", arguments->mesh, ".stl .ply .obj .off .glb")->required();
  command->add_option("-o,--out", arguments->out, "The scene to write")->required();
  auto* cells =
      command->add_option("--cells", arguments->cells, "Cells along the mesh's longest side (128)");
  command->add_option("--spacing", arguments->spacing, "World units per cell instead")
      ->excludes(cells);
  command->add_option("--colour,--color", arguments->colour,
                      "#rrggbb where the file has no colours");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bozzetto::cli
