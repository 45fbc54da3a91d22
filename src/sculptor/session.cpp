#include "bozzetto/sculptor/session.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "bozzetto/history/copy.hpp"
#include "bozzetto/scene/stiffness_bytes.hpp"
#include "bozzetto/scene/support_bytes.hpp"
#include "bozzetto/sculptor/clay_settings.hpp"
#include "bozzetto/solid/solid_codec.hpp"
#include "sculptor/kept_parts.hpp"

namespace bozzetto {
namespace fs = std::filesystem;
namespace {

constexpr const char* kPlaceSetting = "history";
constexpr const char* kEnding = ".history";

// $XDG_STATE_HOME/bozzetto, where documents without a name live.
fs::path stateFolder() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && fs::path(state).is_absolute()) return fs::path(state) / "bozzetto";
  const char* home = std::getenv("HOME");
  if (home == nullptr || !fs::path(home).is_absolute())
    throw Error("no place for documents without a name: neither XDG_STATE_HOME nor HOME is set");
  return fs::path(home) / ".local" / "state" / "bozzetto";
}

bool livesInStateFolder(const fs::path& scene) {
  try {
    return folderOf(scene) == stateFolder();
  } catch (const Error&) {
    return false;
  }
}

HistoryPlace takePlace(SceneParts& parts) {
  const auto setting = parts.settings.find(kPlaceSetting);
  if (setting == parts.settings.end()) return kUnknownPlace;
  const auto place = HistoryPlace::parse(setting->second);
  parts.settings.erase(setting);
  return place.value_or(kUnknownPlace);
}

BytesRef refTo(Bytes bytes) { return std::make_shared<const Bytes>(std::move(bytes)); }

// Clay, place in the history and what is beside the clay are the history's; the rest stays, and
// supports and paint, so that what changed shows.
SavedScene<8> takeSaved(Document& document, const fs::path& scene) {
  SceneParts& parts = document.parts;
  Beside beside(decodeSolid(std::exchange(parts.solid, {}), scene.string()));
  if (!parts.supports.empty()) beside.supports = refTo(encodeSupports(parts.supports));
  if (parts.stiffness.any()) beside.stiffness = refTo(encodeStiffness(parts.stiffness));
  const MassLedger ledger = takeLedger(parts, scene.string());
  if (!(ledger == MassLedger{})) beside.ledger = refTo(encodeLedger(ledger));
  return {std::move(document.field), takePlace(parts), std::move(beside)};
}

// Supports and painted stiffness are in the steps of the history.
SceneParts withoutSteps(SceneParts parts) {
  parts.supports.clear();
  parts.stiffness = {};
  return parts;
}

// Saved by somebody who knows nothing of the history, and after it: it is not this document's any
// more. A minute, because copies of scene and history get their times as it happens.
bool outlived(const fs::path& scene, const SceneParts& parts, FileSystem& files) {
  if (parts.settings.contains(kPlaceSetting)) return false;
  const auto last = lastChangeOf(historyFolderOf(scene), files);
  const auto info = files.info(scene);
  return last && info && info->seconds > *last + 60;
}

HistoryFolder folderFor(const fs::path& scene, const SceneParts& parts, FileSystem& files) {
  return {historyFolderOf(scene), parts.identity.bytes, &files};
}

}  // namespace

fs::path historyFolderOf(const fs::path& scene) { return scene.string() + kEnding; }

Document asCopy(Document document) {
  document.parts.identity = SceneIdentity::random();
  document.parts.settings.erase(kPlaceSetting);
  takeSaves(document.parts);
  return document;
}

/// What there was to open.
struct Session::Opened {
  OpenedHistory<8> history;
  SceneParts parts;
  int saves = 0;
  std::optional<SceneParts> kept;  // of after the save
  SceneFile file;
};

Session::Session(fs::path path, Opened opened, const SessionOptions& options)
    : parts(std::move(opened.parts)),
      path_(std::move(path)),
      named_(!livesInStateFolder(path_)),
      options_(options),
      findings_{opened.history.recovered, opened.history.unsavedSteps, opened.history.time,
                opened.history.readOnly, std::move(opened.history.notices)},
      file_(std::move(opened.file)),
      savedParts_(parts),
      saves_(opened.saves),
      kept_(std::make_unique<KeptParts>(*options.files)),
      sculptor_(std::move(opened.history.field), std::move(opened.history.history),
                options.upkeep) {
  if (opened.kept) opened.kept->thumbnail = parts.thumbnail;
  if (opened.kept) opened.kept->supports = parts.supports;
  if (opened.kept) opened.kept->stiffness = parts.stiffness;
  if (opened.kept && *opened.kept != parts) {
    findings_.recovered = true;
    findings_.notices.push_back("Shelf and settings that were not saved are back");
    parts = std::move(*opened.kept);
  }
  give(parts);
  kept_->begin(withoutSteps(parts));
}

Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

// To the sculptor, whose business they are from now on.
void Session::give(const SceneParts& given) {
  sculptor_.tools().shelf = given.shelf;
  sculptor_.place(settingsOf(given, path_.string()));
}

SceneParts Session::partsNow() const {
  SceneParts now = parts;
  now.shelf = sculptor_.tools().shelf;
  now.supports = sculptor_.clay().supports;
  now.stiffness = sculptor_.clay().stiffness;
  keepSettings(sculptor_.clay().settings, now);
  return now;
}

Session Session::begin(const fs::path& scene, HistoryAccess access, const SessionOptions& options,
                       Progress& progress) {
  FileSystem& files = *options.files;
  std::optional<SavedScene<8>> saved;
  SceneParts parts;
  SceneFile file(files);
  std::vector<std::string> notices;
  bool old = false;
  std::optional<int> saves;
  try {
    Document document = file.load(scene, progress);
    saves = takeSaves(document.parts);
    old = outlived(scene, document.parts, files);
    saved = takeSaved(document, scene);
    parts = std::move(document.parts);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    const auto identity = identityOf(historyFolderOf(scene), files);
    if (!identity) throw;
    if (files.info(scene)) notices.push_back(error.what());
    parts.identity.bytes = *identity;
  }
  HistoryFolder folder = folderFor(scene, parts, files);
  if (old) {
    notices.push_back(folder.path.string() + ": ignored, the scene was saved without it since");
    if (access == HistoryAccess::read) folder.path += "~none";
  }
  OpenedHistory<8> opened;
  try {
    if (old && access == HistoryAccess::write) putHistoryAside(folder.path, files);
    opened = openHistory<8>(folder, saved, access, options.limits);
  } catch (const FileError& error) {
    if (access == HistoryAccess::read) throw;
    opened = openHistory<8>(folder, saved, HistoryAccess::read, options.limits);
    opened.readOnly = true;
    notices.push_back(error.what());
  }
  auto kept = KeptParts::find(folder.path, parts.identity, saves, files, notices);
  opened.notices.insert(opened.notices.begin(), notices.begin(), notices.end());
  return {scene,
          Opened{std::move(opened), std::move(parts), saves.value_or(0), std::move(kept),
                 std::move(file)},
          options};
}

Session Session::open(const fs::path& scene, const SessionOptions& options, Progress& progress) {
  return begin(scene, HistoryAccess::write, options, progress);
}

Session Session::look(const fs::path& scene, const SessionOptions& options, Progress& progress) {
  return begin(scene, HistoryAccess::read, options, progress);
}

Session Session::create(const fs::path& scene, const SessionOptions& options) {
  FileSystem& files = *options.files;
  SceneParts parts;
  fs::path path = scene;
  if (scene.empty()) {
    std::error_code ignored;  // what is wrong shows at once
    fs::create_directories(stateFolder().parent_path(), ignored);
    files.makePrivateFolder(stateFolder());
    path = stateFolder() / (parts.identity.text() + ".bzt");
  }
  if (files.info(path)) throw Error(path.string() + ": exists already");
  OpenedHistory<8> opened =
      openHistory<8>(folderFor(path, parts, files), {}, HistoryAccess::write, options.limits);
  if (opened.readOnly) throw Error(path.string() + ": another program has it open");
  return {path, Opened{std::move(opened), std::move(parts), 0, {}, SceneFile(files)}, options};
}

Session Session::inMemory(const SessionOptions& options) {
  OpenedHistory<8> opened;
  opened.history = History<8>(options.limits);
  Session session({}, Opened{std::move(opened), {}, 0, {}, SceneFile(*options.files)}, options);
  session.named_ = false;
  return session;
}

void Session::discardLeftBehind(const fs::path& scene, FileSystem& files) {
  const fs::path folder = historyFolderOf(scene);
  if (livesInStateFolder(scene) && !historyIsLocked(folder, files)) removeHistory(folder, files);
}

std::vector<fs::path> Session::leftBehind(FileSystem& files) {
  std::vector<fs::path> scenes;
  std::vector<std::string> names;
  try {
    names = files.list(stateFolder());
  } catch (const Error&) {
  }
  for (const std::string& name : names) {
    if (!name.ends_with(kEnding)) continue;
    const fs::path folder = stateFolder() / name;
    if (!identityOf(folder, files) || historyIsLocked(folder, files)) continue;
    scenes.push_back(stateFolder() / name.substr(0, name.size() - std::string(kEnding).size()));
  }
  return scenes;
}

Document Session::document() const {
  Document document{sculptor_.field(), partsNow()};
  document.parts.solid = encodeSolid(sculptor_.solid());
  putLedger(sculptor_.ledger(), document.parts);
  putSaves(document.parts, saves_ + 1);
  document.parts.settings[kPlaceSetting] = sculptor_.history().savePlace().text();
  return document;
}

// A new document in which nothing has happened yet.
bool Session::untouched() const {
  const StepTree& tree = sculptor_.history().tree();
  return tree.size() == 0 && tree.root() == 0 && sculptor_.field().tree.empty();
}

bool Session::saved() const {
  return partsNow() == savedParts_ && (sculptor_.history().atSaved() || untouched());
}

void Session::markSaved(const Document& document) {
  savedParts_ = document.parts;
  savedParts_.solid.clear();
  takeLedger(savedParts_, path_.string());
  saves_ = takeSaves(savedParts_);
  sculptor_.history().markSaved(takePlace(savedParts_));
  kept_->drop(sculptor_.history().folder(), withoutSteps(savedParts_));
  keepParts();
}

void Session::keepParts() {
  if (!sculptor_.history().onDisk()) return;
  kept_->keep(sculptor_.history().folder(), withoutSteps(partsNow()), saves_);
}

std::string Session::trouble() const {
  std::string trouble = sculptor_.history().trouble();
  return trouble.empty() ? kept_->trouble() : trouble;
}

void Session::requireSavable() const {
  if (!named_) throw Error("the document has no name yet");
  if (findings_.readOnly) {
    throw Error(path_.string() + ": open elsewhere or not writable; save under another name");
  }
}

void Session::settleHistory() {
  try {
    sculptor_.history().waitDurable();
  } catch (const Error&) {  // its disk is full or broken: the more the file is to be saved
  }
}

SaveReport Session::save(Progress& progress) {
  requireSavable();
  settleHistory();
  const Document now = document();
  const SaveReport report = file_.save(path_, now, progress);
  markSaved(now);
  return report;
}

SaveReport Session::saveAs(const fs::path& scene, Progress& progress) {
  const Document now = document();
  const SaveReport report = file_.save(scene, now, progress);
  goOnAs(scene, now);
  return report;
}

void Session::goOnAs(const fs::path& scene, const Document& document) {
  const fs::path old = path_;
  const bool wasNamed = named_;
  if (old != scene) bringHistoryTo(historyFolderOf(scene), document);
  path_ = scene;
  named_ = true;
  findings_.readOnly = false;
  markSaved(document);
  if (!wasNamed && !old.empty()) removeHistory(historyFolderOf(old), *options_.files);
}

void Session::discard(Session session) {
  if (session.findings_.readOnly || session.saved()) return;
  FileSystem& files = *session.options_.files;
  const fs::path folder = session.sculptor_.history().folder();
  const bool hasFile = session.named_ && files.info(session.path_).has_value();
  if (hasFile) {
    const auto saved = session.sculptor_.history().savedState();
    if (saved) session.sculptor_.apply(GoToOperation{*saved});
    session.give(session.savedParts_);
    session.kept_->drop(folder, withoutSteps(session.savedParts_));
    return;
  }
  { const Session ended = std::move(session); }
  if (!folder.empty()) removeHistory(folder, files);
}

// Copies the undo-files and goes on writing there.
void Session::bringHistoryTo(const fs::path& folder, const Document& document) {
  History<8>& history = sculptor_.history();
  history.waitDurable();
  if (history.onDisk()) copyHistory(history, folder, *options_.files);
  Document copy = document;
  const SavedScene<8> saved = takeSaved(copy, path_);
  const HistoryFolder there{folder, copy.parts.identity.bytes, options_.files};
  OpenedHistory<8> opened = openHistory<8>(there, saved, HistoryAccess::write, options_.limits);
  if (opened.readOnly) throw Error(folder.string() + ": another program has it open");
  history = std::move(opened.history);
}

}  // namespace bozzetto
