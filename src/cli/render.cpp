// bozzetto render SCENE OUT.png: a studio picture, no display needed.
#include <charconv>

#include "bozzetto/render/picture.hpp"
#include "bozzetto/render/png.hpp"
#include "bozzetto/scene/scene_file.hpp"
#include "cli/progress_bar.hpp"
#include "cli/subcommands.hpp"

namespace bozzetto::cli {
namespace {

struct Arguments {
  std::string scene, out, size = "1280x960", view = "hero", mode = "clay";
};

// "1280x960" → width and height.
std::pair<int, int> parseSize(const std::string& text) {
  int width = 0, height = 0;
  const char* end = text.data() + text.size();
  auto at = std::from_chars(text.data(), end, width);
  const bool crossed = at.ec == std::errc() && at.ptr != end && *at.ptr == 'x';
  if (crossed) at = std::from_chars(at.ptr + 1, end, height);
  if (!crossed || at.ec != std::errc() || at.ptr != end) {
    throw Error("size '" + text.substr(0, 40) + "' is not of the form 1280x960");
  }
  return {width, height};
}

void run(const Arguments& arguments) {
  PictureOptions options;
  std::tie(options.width, options.height) = parseSize(arguments.size);
  options.viewpoint = parseViewpoint(arguments.view);
  options.look.mode = parseMode(arguments.mode);
  ProgressBar progress;
  const Document document = loadScene(arguments.scene, progress);
  Surface<8> surface;
  surface.rebuild(document.field);
  writePng(arguments.out, renderPicture(surface, document.field, options, progress));
}

}  // namespace

void addRender(CLI::App& app) {
  CLI::App* command = app.add_subcommand("render", "Makes a studio picture");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("scene", arguments->scene, "The scene")->required();
  command->add_option("out", arguments->out, "The picture, PNG")->required();
  command->add_option("--size", arguments->size, "Pixels, as 1280x960")->capture_default_str();
  command
      ->add_option("--view", arguments->view,
                   "hero (three quarters), front, back, left, right, top, bottom, iso")
      ->capture_default_str();
  command->add_option("--mode", arguments->mode, "clay, glaze, metal, glass, matcap, wire")
      ->capture_default_str();
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bozzetto::cli
