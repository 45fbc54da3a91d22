// bozzetto render SCENE OUT.png: a studio picture, no display needed.
#include <fmt/format.h>
#include <charconv>
#include <cmath>
#include <numbers>

#include "bozzetto/field/smoothed.hpp"
#include "bozzetto/render/picture.hpp"
#include "bozzetto/render/png.hpp"
#include "bozzetto/scene/scene_file.hpp"
#include "cli/progress_bar.hpp"
#include "cli/subcommands.hpp"
#include "cli/tool_files.hpp"

namespace bozzetto::cli {
namespace {

struct Arguments {
  std::string scene, out, size = "1280x960", view = "hero", mode = "clay", matcap = "wax";
  std::string environment = "studio", stereo = "off", structure = "surface", lights = "scene";
  std::optional<double> yaw, pitch;  // degrees
  double zoom = 1, turn = 0;
  bool orthographic = false, flat = false, edges = false, bronze = false, smoothed = false;
  int frames = 1;
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

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

// The scene's own lights where it has some.
std::vector<StudioLight> lightsOf(const View& view) {
  std::vector<StudioLight> lights;
  for (const Light& light : view.lights) {
    lights.push_back(studioLight({light.towards, light.colour, light.intensity, light.softness}));
    if (light.castsShadow) std::swap(lights.front(), lights.back());
  }
  return lights;
}

void setLook(const Arguments& arguments, const View& view, Look& look) {
  look.mode = parseMode(arguments.mode);
  if (const auto matcap = matcapNamed(arguments.matcap)) {
    look.matcap = *matcap;
  } else {
    look.matcapImage = std::make_shared<const Image>(readPng(arguments.matcap));
  }
  look.metal = arguments.bronze ? Metal::bronze : Metal::chrome;
  look.shading = arguments.flat ? Shading::flat : Shading::smooth;
  look.edges = arguments.edges;
  look.studio = Studio(parseEnvironment(arguments.environment));
  look.studio.turn = float(radians(arguments.turn));
  if (!view.lights.empty() && arguments.lights == "scene") look.studio.lights = lightsOf(view);
}

PictureOptions optionsFrom(const Arguments& arguments) {
  PictureOptions options;
  std::tie(options.width, options.height) = parseSize(arguments.size);
  options.viewpoint = parseViewpoint(arguments.view);
  if (arguments.yaw) options.yaw = radians(*arguments.yaw);
  if (arguments.pitch) options.pitch = radians(*arguments.pitch);
  options.zoom = arguments.zoom;
  options.projection = arguments.orthographic ? Projection::orthographic : Projection::perspective;
  options.structure = parseStructure(arguments.structure);
  options.stereo.mode = parseStereo(arguments.stereo);
  options.frames = arguments.frames;
  return options;
}

// "turn.png" → "turn-007.png".
std::string numbered(const std::filesystem::path& path, int number) {
  const std::string name =
      fmt::format("{}-{:03}{}", path.stem().string(), number, path.extension().string());
  return (path.parent_path() / name).string();
}

void run(const Arguments& arguments) {
  requirePictureName(arguments.out);
  PictureOptions options = optionsFrom(arguments);
  setLook(arguments, {}, options.look);  // what is wrong with it is told before a scene is read
  ProgressBar progress;
  const Document document = loadScene(arguments.scene, progress);
  setLook(arguments, document.parts.view, options.look);
  const Clay clay = arguments.smoothed ? smoothed(document.field) : document.field;
  Surface<8> surface;
  surface.rebuild(clay);
  if (arguments.frames == 1) {
    writePng(arguments.out, renderPicture(surface, clay, options, progress));
    return;
  }
  const auto write = [&](int frame, const Image& image) {
    writePng(numbered(arguments.out, frame), image);
  };
  renderTurn(surface, clay, options, write, progress);
}

void addCamera(CLI::App& command, Arguments& a) {
  command.add_option("--size", a.size, "Pixels, as 1280x960")->capture_default_str();
  command
      .add_option("--view", a.view,
                  "hero (three quarters), front, back, left, right, top, bottom, iso")
      ->capture_default_str();
  command.add_option("--yaw", a.yaw, "Degrees about the vertical instead of the view's: 0 front")
      ->check(CLI::Range(-3600., 3600.));
  command.add_option("--pitch", a.pitch, "Degrees from above instead of the view's")
      ->check(CLI::Range(-90., 90.));
  command.add_option("--zoom", a.zoom, "2 shows the middle twice as large")
      ->check(CLI::Range(.05, 50.))
      ->capture_default_str();
  command.add_flag("--orthographic", a.orthographic, "Parallel rays");
  command.add_option("--turntable", a.frames, "As many pictures of one turn: OUT-000.png …")
      ->check(CLI::Range(1, 3600));
  command.add_option("--stereo", a.stereo, "Two eyes: off, side-by-side, rows, anaglyph")
      ->capture_default_str();
}

void addMaterial(CLI::App& command, Arguments& a) {
  command
      .add_option("--mode", a.mode,
                  "clay, glaze (environment by angle), plastic (half transparent), metal (opaque), "
                  "glass, matcap, wire")
      ->capture_default_str();
  command
      .add_option("--environment", a.environment,
                  "What mirrors in the clay, with its lights: studio, daylight, dusk, workshop, "
                  "zebra")
      ->capture_default_str();
  command.add_option("--light-turn", a.turn, "Degrees that lights and environment are turned")
      ->check(CLI::Range(-3600., 3600.));
  command.add_option("--lights", a.lights, "scene (its own where it has some) or environment")
      ->check(CLI::IsMember({"scene", "environment"}))
      ->capture_default_str();
  command
      .add_option("--matcap", a.matcap,
                  "wax, jade, plaster, pewter, or a PNG of a ball that fills a square")
      ->capture_default_str();
  command.add_flag("--bronze", a.bronze, "Metal is bronze instead of chrome");
  command.add_flag("--flat", a.flat, "Triangles as they are instead of smooth");
  command.add_flag("--smoothed", a.smoothed,
                   "A copy of the clay filtered once: no terraces where clay was moved");
  command.add_flag("--edges", a.edges, "Edges of the triangles over any mode");
  command
      .add_option("--structure", a.structure,
                  "surface, cubes (all with clay), crossing-cubes (those the surface crosses), "
                  "height-field (cloths over it, as while much clay moves)")
      ->capture_default_str();
}

}  // namespace

void addRender(CLI::App& app) {
  CLI::App* command = app.add_subcommand("render", "Makes a studio picture");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("scene", arguments->scene, "The scene")->required();
  command->add_option("out", arguments->out, "The picture, PNG")->required();
  addCamera(*command, *arguments);
  addMaterial(*command, *arguments);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace bozzetto::cli
