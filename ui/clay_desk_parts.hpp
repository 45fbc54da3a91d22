// What the desk works with while something takes its time.
#pragma once
#include <cmath>

#include "bozzetto/surface/statistics.hpp"
#include "ui/clay_desk.hpp"

namespace bozzetto::ui {

struct ClayDesk::Saving {
  Saving(SceneFile& file, std::filesystem::path to, Document what)
      : path(std::move(to)), document(std::move(what)), job(file, path, document) {}

  std::filesystem::path path;
  Document document;
  BackgroundSave job;
};

// Another state of the clay with its surface; where it is on our grid, what differs of what is
// shown.
struct ClayDesk::Peek {
  Clay clay;
  Surface<8> surface;
  ShownClay shown;
  bool sameGrid = false;
  SurfaceChanges changes{};

  Peek(Clay then, const Sculptor& now, const ShownClay& shownNow)
      : clay(std::move(then)), surface(now.surface()), shown(shownNow) {
    sameGrid =
        clay.scale.spacing == now.field().scale.spacing && clay.scale.iso == now.field().scale.iso;
    if (sameGrid) {
      changes.blocks = differingBlocks(clay, now.field());
      changes.patches = surface.refresh(clay, changes.blocks).changed;
      changes = shown.follow(clay, changes);
    } else {
      surface.rebuild(clay);
      shown.rebuild(clay);
    }
  }
  double volume() const { return measure(surface).volume * std::pow(clay.scale.spacing, 3); }
};

// Notices become notes in the window.
class ClayDesk::Telling : public Progress {
 public:
  Telling(Progress& outer, ClayDesk& desk) : outer_(&outer), desk_(&desk) {}
  bool report(std::string_view what, double done) override { return outer_->report(what, done); }
  void note(std::string_view text) override { desk_->note(std::string(text)); }

 private:
  Progress* outer_;
  ClayDesk* desk_;
};

}  // namespace bozzetto::ui
