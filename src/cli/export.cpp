// bozzetto export SCENE OUT: the surface as a mesh file.
#include "bozzetto/base/file.hpp"
#include "bozzetto/io/mesh_file.hpp"
#include "bozzetto/mesh/decimate.hpp"
#include "bozzetto/scene/scene_file.hpp"
#include "bozzetto/surface/welded.hpp"
#include "cli/progress_bar.hpp"
#include "cli/subcommands.hpp"

namespace bozzetto::cli {
namespace {

struct Arguments {
  std::string scene, out;
  double decimate = 1;
};

void run(const Arguments& arguments) {
  // A name that no writer knows is told before any work.
  if (!isStandardOutput(arguments.out)) meshFormatOf(arguments.out);
  ProgressBar progress;
  const Document document = loadScene(arguments.scene, progress);
  Surface<8> surface;
  surface.rebuild(document.field);
  const TriangleMesh mesh = decimate(weld(surface, document.field.scale), arguments.decimate);
  if (isStandardOutput(arguments.out)) {
    writeMesh(arguments.out, MeshFormat::ply, mesh, progress);
  } else {
    writeMesh(arguments.out, mesh, progress);
  }
}

}  // namespace

void addExport(CLI::App& app) {
  CLI::App* command = app.add_subcommand("export", "Writes the surface as a mesh");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("scene", arguments->scene, "The scene")->required();
  command
      ->add_option("out", arguments->out,
                   ".obj .ply .stl .glb .iv; - writes PLY to standard output")
      ->required();
  command->add_option("--decimate", arguments->decimate, "Part of the triangles to keep")
      ->check(CLI::Range(0.0, 1.0));
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bozzetto::cli
