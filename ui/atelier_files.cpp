// Files: what leaves and enters the atelier, with questions first and progress meanwhile.
#include <fmt/format.h>

#include "bozzetto/base/text.hpp"
#include "bozzetto/render/picture.hpp"
#include "bozzetto/render/png.hpp"
#include "ui/atelier.hpp"
#include "ui/kept_look.hpp"

namespace bozzetto::ui {
namespace {

namespace fs = std::filesystem;

std::string numbered(const fs::path& path, int frame) {
  const fs::path folder = path.parent_path();
  return (folder / fmt::format("{}-{:03}.png", path.stem().string(), frame + 1)).string();
}

}  // namespace

void Atelier::whenDone(std::shared_ptr<LongJob> job, std::function<void()> then) {
  job_ = std::move(job);
  afterJob_ = std::move(then);
}

void Atelier::ifSaved(std::function<void()> next) {
  discarding_ = false;
  if (!isModified()) return next();
  afterSaving_ = std::move(next);
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
  ifSaved([this] { close(); });
}

void Atelier::close() {
  leaveDocument();
  worker_.post([](ClayDesk& desk) { desk.leave(); });
  closing_ = true;
}

// What the user said is done once, and only when there is something instead.
Leaving Atelier::leaving() {
  return std::exchange(discarding_, false) ? Leaving::discard : Leaving::keep;
}

void Atelier::leaveDocument() {
  if (leaving() == Leaving::discard) worker_.post([](ClayDesk& desk) { desk.discard(); });
}

void Atelier::startNew(NewClay kind, const fs::path& path) {
  leaveDocument();
  worker_.post([kind, path](ClayDesk& desk) { desk.startNew(kind, path); });
}

void Atelier::openScene(const fs::path& path) {
  dialog = Dialog::none;
  // A name for a scene that is to be: start with a ball and save there.
  if (!fs::exists(path) && !identityOf(historyFolderOf(path))) {
    return startNew(NewClay::ball, path);
  }
  whenDone(worker_.start("Opening " + path.filename().string(),
                         [path, leaving = leaving()](ClayDesk& desk, Progress& progress) {
                           desk.open(path, progress, leaving);
                         }),
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
  if (!then) then = std::exchange(afterSaving_, nullptr);
  afterSaving_ = nullptr;
  whenSaved_ = std::move(then);
  worker_.post([path, parts = parts()](ClayDesk& desk) { desk.save(path, parts); });
}

void Atelier::saveNumbered() {
  whenDone(worker_.start("Saving a copy",
                         [path = path(), parts = parts()](ClayDesk& desk, Progress& progress) {
                           desk.saveNumbered(path, parts, progress);
                         }),
           {});
}

void Atelier::importMesh(const fs::path& path, int cells) {
  dialog = Dialog::none;
  ImportOperation how;
  how.from = fs::absolute(path).string();
  how.cells = cells;
  how.colour = sculpt.colour;
  whenDone(worker_.start("Importing " + path.filename().string(),
                         [how, leaving = leaving()](ClayDesk& desk, Progress& progress) {
                           desk.import(how, progress, leaving);
                         }),
           {});
}

void Atelier::exportMesh(const fs::path& path, double keep) {
  dialog = Dialog::none;
  whenDone(worker_.start("Exporting " + path.filename().string(),
                         [path, keep](ClayDesk& desk, Progress& progress) {
                           desk.exportMesh(path, keep, progress);
                         }),
           [this, path] { say(Message::Kind::note, "Exported " + path.filename().string()); });
}

void Atelier::saveRecording(const fs::path& path) {
  dialog = Dialog::none;
  worker_.post([path](ClayDesk& desk) {
    desk.saveRecording(path);
    desk.note("Recording saved as " + path.filename().string());
  });
}

void Atelier::replay(const fs::path& path) {
  dialog = Dialog::none;
  whenDone(
      worker_.start("Replaying " + path.filename().string(),
                    [path](ClayDesk& desk, Progress& progress) { desk.replay(path, progress); }),
      {});
}

void Atelier::resample(double spacing) {
  whenDone(worker_.start("Resampling",
                         [spacing](ClayDesk& desk, Progress& progress) {
                           desk.apply(ResampleOperation{spacing}, progress);
                         }),
           {});
}

void Atelier::showStructure(Structure structure) {
  options.structure = structure;
  options.look.cellLines = structure != Structure::surface;
  worker_.post([structure](ClayDesk& desk) { desk.setStructure(structure); });
}

// The view as it is, without panels. Drawn by a context of the worker's own.
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
  whenDone(worker_.start("Drawing " + wish.path.filename().string(),
                         [wish, how](ClayDesk& desk, Progress& progress) {
                           const Sculptor& sculptor = desk.sculptor();
                           if (wish.frames == 1) {
                             writePng(wish.path, renderPicture(sculptor.surface(), sculptor.field(),
                                                               how, progress));
                             return;
                           }
                           const auto keep = [&](int frame, const Image& image) {
                             writePng(numbered(wish.path, frame), image);
                           };
                           renderTurn(sculptor.surface(), sculptor.field(), how, keep, progress);
                         }),
           [this, wish] { say(Message::Kind::note, "Saved " + wish.path.filename().string()); });
}

// Facing the viewer behind the target, nearly as high as the view.
void Atelier::addReference(const fs::path& path) {
  dialog = Dialog::none;
  try {
    Reference reference;
    reference.from = fs::absolute(path).string();
    ReferencePicture& picture = reference.picture;
    picture.image = std::make_shared<const Image>(readPng(path));
    const double half = unitsPerPixel(view, extent_, view.target) * extent_.height * .45;
    const double aspect = double(picture.image->width) / picture.image->height;
    picture.centre = view.target;
    picture.right = view.right() * (half * aspect);
    picture.up = view.up() * half;
    options.references.push_back(std::move(reference));
  } catch (const Error& error) {
    say(Message::Kind::error, error.what());
  }
}

void Atelier::loadMatcap(const fs::path& path) {
  dialog = Dialog::none;
  try {
    options.look.matcapImage = std::make_shared<const Image>(readPng(path));
    options.look.mode = Mode::matcap;
  } catch (const Error& error) {
    say(Message::Kind::error, error.what());
  }
}

// By what the first file is.
void Atelier::drop(const std::vector<std::string>& paths) {
  if (paths.empty()) return;
  const fs::path path = paths.front();
  if (shelf.open) return keepFile(path);
  const std::string kind = lower(path.extension().string());
  if (kind == ".bzt") {
    ifSaved([this, path] { openScene(path); });
  } else if (kind == ".jsonl") {
    replay(path);
  } else if (kind == ".png") {
    addReference(path);
  } else {
    ifSaved([this, path] { importMesh(path, 192); });
  }
}

}  // namespace bozzetto::ui
