// Where the clay is worked on, off the window's thread: the session with its file and history, and
// what the window is to be shown. Not thread-safe: ClayWorker calls it from its one thread; tests
// call it directly.
#pragma once
#include <chrono>
#include <functional>
#include <memory>

#include "bozzetto/render/structure.hpp"
#include "bozzetto/scene/background_save.hpp"
#include "bozzetto/sculptor/recording.hpp"
#include "ui/posed_clay.hpp"
#include "ui/publication.hpp"
#include "ui/shown_clay.hpp"

namespace bozzetto::ui {

enum class ShelfPictures { none, made };

/// What becomes of work that was not saved when another document comes.
enum class Leaving { keep, discard };

enum class NewClay { empty, ball, block };

class ClayDesk {
 public:
  /// Nothing but air, in memory only.
  explicit ClayDesk(FileSystem& files = FileSystem::real());
  /// Finishes a save. What was not saved stays in the journal, as after a crash; see `leave`.
  ~ClayDesk();
  ClayDesk(const ClayDesk&) = delete;
  ClayDesk& operator=(const ClayDesk&) = delete;

  double newRadius = 48;  ///< of a new ball, world units = cells of a new scene
  /// Asked before every dab; true takes the stroke back. May be asked while others answer.
  std::function<bool()> givesUp = [] { return false; };

  // Documents. Each throws Error and leaves something sound on the desk.
  /// Without a name it lives in the user's state folder until it gets one.
  void startNew(NewClay kind, const std::filesystem::path& path = {});
  /// As of the last thing that happened to it, saved or not. What cannot be opened, or imported,
  /// leaves what is there.
  void open(const std::filesystem::path& path, Progress& progress, Leaving leaving = Leaving::keep);
  void import(const ImportOperation& operation, Progress& progress,
              Leaving leaving = Leaving::keep);
  /// In the background; the publication tells how it went. Throws where it cannot even begin.
  void save(const std::filesystem::path& path, const SceneParts& parts);
  /// A copy beside `path`; we go on with the file we have.
  void saveNumbered(const std::filesystem::path& path, const SceneParts& parts, Progress& progress);
  void exportMesh(const std::filesystem::path& path, double keep, Progress& progress);
  /// The user wants none of what was not saved.
  void discard();
  /// The user goes: nothing stays behind of a document that nobody worked on.
  void leave();
  /// Tells of work without a name that was left behind, the latest first. What was only begun goes.
  void findLeftBehind();
  void discardLeftBehind(const std::filesystem::path& path);

  /// From where the clay is looked at: while much of it moves only what is seen is shown.
  void seenFrom(const Camera& camera);
  void setHeightSwitch(const HeightSwitch& by) { heightSwitch_ = by; }

  // Operations.
  void apply(const Operation& operation, Progress& progress = Progress::none());
  /// How clay gives way from now on. Not while a stroke is drawn.
  void behave(const ClayOperation& clay);
  void beginStroke(const HandOperations& hand, Stroke stroke);
  /// Leaves out points after which the stroke would make absurdly much clay, and says so.
  void extendStroke(std::span<const StrokePoint> points);
  /// The next dab whose place is sure; false when there is none. Where memory ends the stroke is
  /// taken back, with an Error.
  bool dab();
  /// What dabs did comes into the publication: many at a time take less than each by itself.
  void showDabs();
  void endStroke();
  void cancelStroke();
  bool inStroke() const { return stroke_ != nullptr; }

  // History.
  /// How the clay of that state differs from ours.
  void compare(StepNumber step);
  /// Shows another state until the next call, or until anything else happens. Nothing: ours again.
  void peek(std::optional<StepNumber> step);
  /// A picture that was drawn when there was time.
  void keepPicture(StepNumber step, Bytes png);

  /// With these settings from now on.
  void relax(const ClayOperation& settings, int steps, Progress& progress);

  // Solids (clay_desk_solid.cpp).
  void showSolid(const SolidWish& wish);
  /// Shows what a move or a pull would do.
  void previewSolid(const Operation& drag);
  /// Tells the stiffness there.
  void touchSolid(const glm::dvec3& at, double radius);

  // Shelves (clay_desk_shelf.cpp).
  /// Lists all tools with the next publication; their pictures follow at rest.
  void listShelf();
  /// Whether anybody looks at them, and at pictures of steps that nobody saw happen.
  void setPictures(ShelfPictures pictures) { pictures_ = pictures; }
  void takeTool(const ToolSource& source);
  /// A tool of any place as one file.
  void shareTool(const std::string& name, const std::filesystem::path& path);
  /// In the user's library, under that name.
  void keepForUser(const std::string& name, const std::string& as);
  /// What a change of the library's files leaves is listed.
  void changeLibrary(const std::function<void()>& change);

  // Recordings.
  void saveRecording(const std::filesystem::path& path) const;
  void replay(const std::filesystem::path& path, Progress& progress);

  /// Shows the surface, or the cubes it is made of.
  void setStructure(Structure structure);
  /// Shows the clay as it is, or smoothed. Not while a stroke is drawn.
  void setSmoothing(Smoothing smoothing);
  /// What is shown, of our state.
  const Clay& shownClay() const { return shown_.of(sculptor().field()); }
  const Surface<8>& shownSurface() const { return shown_.of(sculptor().surface()); }

  /// A piece of the work that waits until nothing else is to do (better light, statistics); false
  /// when all is done.
  bool settle();
  /// Looks what has become of saves and the journal.
  void lookAfter();
  /// When to do that again, though nothing else happens; nothing when there is no need.
  std::optional<std::chrono::milliseconds> patience() const;
  /// A save, or steps that are not on the disk yet.
  bool isWaiting() const;

  /// What changed since the last call.
  Publication take();

  const Sculptor& sculptor() const { return session_->sculptor(); }
  const Recording& recording() const { return recording_; }
  const Session& session() const { return *session_; }
  void note(std::string text) { out_.notes.push_back(std::move(text)); }
  void fail(std::string text) { out_.errors.push_back(std::move(text)); }

 private:
  struct Saving;
  class Telling;

  Sculptor& bench() { return session_->sculptor(); }
  const History<8>& history() const { return sculptor().history(); }
  SessionOptions options() const;
  void give(const SceneParts& parts);
  void endSaving();
  bool isModified() const;
  void lay(Session session);
  void putAway();
  void leave(Leaving leaving);
  Session begin(const std::filesystem::path& path);
  void settleHand();
  StepNumber newestStep() const;
  void show();
  void showAll();
  void showMesh(const SurfaceChanges& changes);
  void showCloths(const SurfaceChanges& changes);
  void putCloths(std::vector<UnpackedPatch> patches);
  void drape();
  void undrape();
  void put(std::vector<UnpackedPatch> patches);
  void showStiffness();
  bool enough(const std::function<bool()>& work);
  void tellNotice();
  void hold(const HandOperations& hand);
  void holdOne(const Operation& wanted, std::string& held);
  void tellSolid(const SolidRef& solid);
  void poseClay(const SolidRef& solid);
  void picture(ShelfCard& card);
  void share(ShelfTool tool, const std::filesystem::path& path);
  bool pictureNext();
  void tellStatus();
  void tellSupports();
  Keeping keeping() const;
  bool loadPicture();
  bool pictureStep();
  void keepPartsSoon();
  bool grewEnough();
  ClayStatistics count() const;

  FileSystem* files_;
  std::unique_ptr<Session> session_;  // never null
  std::unique_ptr<LiveStroke<8>> stroke_;
  std::size_t nodesBefore_ = 0;  // of the tree, when the stroke began
  std::int64_t dabs_ = 0;        // made of the stroke
  bool grown_ = false;           // as far as a stroke may
  bool unshown_ = false;         // dabs that are made are not on their way to the window
  std::string noticed_;          // told of the stroke
  std::unique_ptr<Saving> saving_;
  std::unique_ptr<Dresser> dresser_;
  /// The state that nobody has worked on: the first shape of a new document.
  std::optional<StepNumber> begun_;
  struct Peek;
  std::unique_ptr<Peek> peek_;           // another state, while it is looked at
  std::vector<StepNumber> pictureless_;  // steps whose picture has not been looked for
  std::vector<StepNumber> unpictured_;   // and those that have none
  Recording recording_;
  std::string heldTool_, heldAction_, heldClay_;  // operations last told; empty: not known
  std::vector<ShelfCard> cards_;
  SolidWish solidWish_;
  SolidRef solidTold_;  // what the window shows
  double solidSpacing_ = 0;
  std::optional<RunReport> solidRan_;            // the last physics, also of a preview
  std::map<Key, PatchRef> fine_, coarse_;        // the clay's own surface, as last told
  clay::Stiffness stiffnessTold_;                // painted, as it is tinted
  std::unique_ptr<PosedClay> posed_;             // while a wrap is seen posed
  std::shared_ptr<const Sculpture> unprepared_;  // may push clay, and knows no ways out of it yet
  ShelfPictures pictures_ = ShelfPictures::none;
  std::map<std::string, std::shared_ptr<const Bytes>> starterPictures_;
  /// Of the supports that are sculptures, each once.
  std::map<std::shared_ptr<const Sculpture>, std::shared_ptr<const ToolMesh>> supportMeshes_;
  ClayStatus status_;
  std::uint64_t historyMoment_ = 0;
  std::chrono::steady_clock::time_point partsKept_;
  Publication out_;
  CellBounds bounds_;  // of all patches
  Structure structure_ = Structure::surface;
  ShownClay shown_;
  std::optional<Camera> eye_;
  HeightSwitch heightSwitch_;
  bool draped_ = false;
  enum class Rest { light, floor, statistics, pictures, nothing } rest_ = Rest::nothing;
};

}  // namespace bozzetto::ui
