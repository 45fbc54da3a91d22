// Files: what leaves and enters the atelier, with questions first and progress meanwhile.
#include <fmt/format.h>

#include "bozzetto/base/text.hpp"
#include "bozzetto/io/mesh_file.hpp"
#include "bozzetto/render/picture.hpp"
#include "bozzetto/render/png.hpp"
#include "bozzetto/scene/scene_file.hpp"
#include "ui/atelier.hpp"
#include "ui/kept_look.hpp"

namespace bozzetto::ui {
namespace {

// What a scene says that was kept as a tool (src/sculptor/NOTES.md).
constexpr const char* kToolSetting = "tool";

namespace fs = std::filesystem;

std::string numbered(const fs::path& path, int frame) {
  const fs::path folder = path.parent_path();
  return (folder / fmt::format("{}-{:03}.png", path.stem().string(), frame + 1)).string();
}

void draw(const PictureWish& wish, const PictureOptions& how, const Surface<8>& surface,
          const Clay& clay, Progress& progress) {
  if (wish.frames == 1) {
    writePng(wish.path, renderPicture(surface, clay, how, progress));
    return;
  }
  const auto keep = [&](int frame, const Image& image) {
    writePng(numbered(wish.path, frame), image);
  };
  renderTurn(surface, clay, how, keep, progress);
}

}  // namespace

void Atelier::whenDone(std::shared_ptr<LongJob> job, std::function<void()> then) {
  jobs_.push_back({std::move(job), std::move(then)});
}

// What is still on its way to the clay counts too.
void Atelier::ifSaved(std::function<void()> next) {
  discarding_ = false;
  if (!worker_.hasTasks() && !worker_.hasNews()) return decide(next);
  afterAsking_ = std::move(next);
  asked_ = worker_.start("", [](ClayDesk&, Progress&) {});
}

void Atelier::decide(const std::function<void()>& next) {
  if (!isModified()) return next();
  afterSaving_ = next;
  dialog = Dialog::unsaved;
}

void Atelier::answerUnsaved(bool save) {
  dialog = Dialog::none;
  const auto next = std::exchange(afterSaving_, nullptr);
  if (!next) return;
  if (!save) {
    discarding_ = true;
    return next();
  }
  if (!path().empty() && !status_.keeping.readOnly) return saveScene(path(), next);
  afterSaving_ = next;  // saveScene goes on with it
  dialog = Dialog::saveAs;
}

void Atelier::askToClose() {
  for (const Job& each : jobs_) each.job->cancel();
  ifSaved([this] { close(); });
}

void Atelier::close() {
  worker_.post([leaving = leaving()](ClayDesk& desk) {
    if (leaving == Leaving::discard) desk.discard();
    desk.leave();
  });
  closing_ = true;
}

// What the user said is done once, and only when there is something instead.
Leaving Atelier::leaving() {
  return std::exchange(discarding_, false) ? Leaving::discard : Leaving::keep;
}

void Atelier::startNew(NewClay kind, const fs::path& path) {
  bring("Something new", [kind, path, leaving = leaving()](ClayDesk& desk, Progress&) {
    if (leaving == Leaving::discard) desk.discard();
    desk.startNew(kind, path);
  });
}

void Atelier::openScene(const fs::path& path) {
  dialog = Dialog::none;
  // A name for a scene that is to be: start with a ball and save there.
  if (!fs::exists(path) && !identityOf(historyFolderOf(path))) {
    return startNew(NewClay::ball, path);
  }
  bring(
      "Opening " + path.filename().string(),
      [path, leaving = leaving()](ClayDesk& desk, Progress& progress) {
        desk.open(path, progress, leaving);
      },
      [this, path] { settings.remember(path); });
}

SceneParts Atelier::parts() const {
  SceneParts parts;
  parts.view.camera = sceneCameraOf(view);
  parts.view.lights = keptLights();
  parts.view.workspace = options.boxSize;
  parts.settings[kLookSetting] = lookText(options);
  if (thumbnail) parts.thumbnail = thumbnail();
  return parts;
}

void Atelier::saveScene(const fs::path& wanted, std::function<void()> then) {
  fs::path path = wanted;
  if (path.extension().empty()) path += ".bzt";
  dialog = Dialog::none;
  if (anotherComes()) return;
  if (!then) then = std::exchange(afterSaving_, nullptr);
  afterSaving_ = nullptr;
  whenSaved_ = std::move(then);
  worker_.post([path, parts = parts()](ClayDesk& desk) { desk.save(path, parts); });
}

void Atelier::saveNumbered() {
  begin("Saving a copy", [path = path(), parts = parts()](ClayDesk& desk, Progress& progress) {
    desk.saveNumbered(path, parts, progress);
  });
}

void Atelier::importMesh(const fs::path& path, int cells) {
  dialog = Dialog::none;
  ImportOperation how;
  how.from = fs::absolute(path).string();
  how.cells = cells;
  how.colour = sculpt.colour;
  bring("Importing " + path.filename().string(),
        [how, leaving = leaving()](ClayDesk& desk, Progress& progress) {
          desk.import(how, progress, leaving);
        });
}

void Atelier::exportMesh(const fs::path& path, double keep) {
  dialog = Dialog::none;
  begin(
      "Exporting " + path.filename().string(),
      [path, keep](ClayDesk& desk, Progress& progress) { desk.exportMesh(path, keep, progress); },
      [this, path] { say(Message::Kind::note, "Exported " + path.filename().string()); });
}

void Atelier::saveRecording(const fs::path& path) {
  dialog = Dialog::none;
  ask([path](ClayDesk& desk) {
    desk.saveRecording(path);
    desk.note("Recording saved as " + path.filename().string());
  });
}

void Atelier::replay(const fs::path& path) {
  dialog = Dialog::none;
  begin("Replaying " + path.filename().string(),
        [path](ClayDesk& desk, Progress& progress) { desk.replay(path, progress); });
}

void Atelier::resample(double spacing) {
  begin("Resampling", [spacing](ClayDesk& desk, Progress& progress) {
    desk.apply(ResampleOperation{spacing}, progress);
  });
}

void Atelier::showStructure(Structure structure) {
  options.structure = structure;
  options.look.cellLines = structure != Structure::surface;
  worker_.post([structure](ClayDesk& desk) { desk.setStructure(structure); });
}

// A panel or another scene's look may have changed it.
void Atelier::tellSmoothing() {
  if (toldSmoothed_ == options.smoothed || gesture_ != Gesture::none) return;
  toldSmoothed_ = options.smoothed;
  const auto smoothing = options.smoothed ? Smoothing::shown : Smoothing::none;
  worker_.post([smoothing](ClayDesk& desk) { desk.setSmoothing(smoothing); });
}

// The view as it is, without panels. Drawn by a thread and a context of its own.
void Atelier::takePicture(const PictureWish& wish) {
  dialog = Dialog::none;
  PictureOptions how;
  how.width = wish.width;
  how.height = wish.height;
  how.slices = wish.slices;
  how.frames = wish.frames;
  how.look = options.look;
  how.look.dither = 0;
  how.projection = view.projection;
  how.camera = cameraOf(view, status_.scale.spacing);
  // Of the clay as it is now; work goes on meanwhile.
  const auto prepare = [wish, how](ClayDesk& desk) -> ClayWorker::Beside {
    return [wish, how, surface = desk.shownSurface(), clay = desk.shownClay()](Progress& progress) {
      draw(wish, how, surface, clay, progress);
    };
  };
  const std::string name = wish.path.filename().string();
  whenDone(worker_.startBeside("Drawing " + name, prepare),
           [this, name] { say(Message::Kind::note, "Saved " + name); });
}

// Facing the viewer behind the clay, nearly as high as the view. One that was lost comes back to
// its place.
void Atelier::addReference(const fs::path& path) {
  dialog = Dialog::none;
  try {
    Reference reference;
    reference.from = fs::absolute(path).string();
    reference.picture.image = std::make_shared<const Image>(readPng(path));
    for (Reference& each : options.references) {
      if (each.picture.image || fs::path(each.from).filename() != path.filename()) continue;
      each.from = reference.from;
      each.picture.image = reference.picture.image;
      return;
    }
    standBehind(reference.picture);
    options.references.push_back(std::move(reference));
  } catch (const Error& error) {
    say(Message::Kind::error, error.what());
  }
}

void Atelier::standBehind(ReferencePicture& picture) const {
  const CellBounds& clay = status_.bounds;
  double depth = 0;
  for (int n = 0; n < 8 && !clay.empty(); ++n) {
    const glm::dvec3 corner{(n & 1 ? clay.low : clay.high).x, (n & 2 ? clay.low : clay.high).y,
                            (n & 4 ? clay.low : clay.high).z};
    depth = std::max(depth, glm::dot(view.target - corner * status_.scale.spacing, view.back()));
  }
  picture.centre = view.target - view.back() * (1.02 * depth);
  const double half = unitsPerPixel(view, extent_, picture.centre) * extent_.height * .45;
  picture.right = view.right() * (half * picture.image->width / picture.image->height);
  picture.up = view.up() * half;
}

void Atelier::loadMatcap(const fs::path& path) {
  dialog = Dialog::none;
  try {
    options.look.matcapImage = std::make_shared<const Image>(readPng(path));
    options.matcapFrom = fs::absolute(path).string();
    options.look.mode = Mode::matcap;
  } catch (const Error& error) {
    say(Message::Kind::error, error.what());
  }
}

// Tools and pictures all of them, of documents the first.
void Atelier::drop(const std::vector<std::string>& paths) {
  std::vector<fs::path> documents;
  for (const std::string& name : paths) {
    const fs::path path = name;
    if (shelf.open) {
      keepFile(path);
    } else if (lower(path.extension().string()) == ".png") {
      addReference(path);
    } else {
      documents.push_back(path);
    }
  }
  if (documents.empty()) return;
  dropDocument(documents.front());
  if (documents.size() > 1)
    say(Message::Kind::note, "One at a time: took " + documents.front().filename().string());
}

// One that was kept as a tool is meant to be used.
void Atelier::dropScene(const fs::path& path) {
  const auto tool = std::make_shared<bool>(false);
  begin(
      "Looking at " + path.filename().string(),
      [path, tool](ClayDesk&, Progress& progress) {
        *tool = loadScene(path, progress).parts.settings.contains(kToolSetting);
      },
      [this, path, tool] {
        if (*tool) return takeFile(path);
        ifSaved([this, path] { openScene(path); });
      });
}

// What cannot be opened asks nothing.
void Atelier::dropDocument(const fs::path& path) {
  const std::string kind = lower(path.extension().string());
  if (kind == ".bzt") return dropScene(path);
  if (kind == ".jsonl") return replay(path);
  try {
    meshFormatOf(path);
    ifSaved([this, path] { importMesh(path, 192); });
  } catch (const Error& error) {
    say(Message::Kind::error, error.what());
  }
}

}  // namespace bozzetto::ui
