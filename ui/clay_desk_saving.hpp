// A save that is on its way.
#pragma once
#include "ui/clay_desk.hpp"

namespace bozzetto::ui {

struct ClayDesk::Saving {
  Saving(SceneFile& file, std::filesystem::path to, Document what)
      : path(std::move(to)), document(std::move(what)), job(file, path, document) {}

  std::filesystem::path path;
  Document document;
  BackgroundSave job;
};

}  // namespace bozzetto::ui
