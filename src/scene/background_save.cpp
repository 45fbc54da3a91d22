#include "bozzetto/scene/background_save.hpp"

namespace bozzetto {

BackgroundSave::BackgroundSave(SceneFile& file, std::filesystem::path path, Document document)
    : watch_(std::make_unique<Watch>()),
      job_([&file, path = std::move(path), document = std::move(document), watch = watch_.get()] {
        watch->saved = file.save(path, document, *watch);
      }) {}

SaveReport BackgroundSave::result() {
  job_.wait();
  return watch_->saved;
}

}  // namespace bozzetto
