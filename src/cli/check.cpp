// bozzetto check SCENE: whole-file integrity; exit 1 and the first fault if damaged.
#include <fmt/format.h>

#include "bozzetto/scene/scene_file.hpp"
#include "cli/progress_bar.hpp"
#include "cli/subcommands.hpp"

namespace bozzetto::cli {

void addCheck(CLI::App& app) {
  CLI::App* command = app.add_subcommand("check", "Tells whether a scene file is whole");
  auto scene = std::make_shared<std::string>();
  command->add_option("scene", *scene, "The scene")->required();
  command->callback([scene] {
    ProgressBar progress;
    if (const auto fault = checkScene(*scene, progress)) throw Error(*fault);
    progress.clear();
    fmt::print("{}: whole\n", *scene);
  });
}

}  // namespace bozzetto::cli
