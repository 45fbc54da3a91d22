// The window without its pixels: what is held, looked at and asked for. Panels read and change it,
// input goes through it, and every change of the clay leaves it as an operation for the worker.
// Knows neither OpenGL nor ImGui, so that tests drive it directly.
#pragma once
#include <functional>
#include <optional>

#include "bozzetto/render/viewport.hpp"
#include "ui/events.hpp"
#include "ui/felt_hand.hpp"
#include "ui/settings.hpp"
#include "ui/shelf_drawer.hpp"
#include "ui/solid_state.hpp"
#include "ui/stroke_maker.hpp"
#include "ui/view_options.hpp"
#include "ui/worker.hpp"

namespace bozzetto::ui {

/// What a hand moves.
enum class Moves { scene, tool, light };

/// What the pointer is doing in the viewport.
enum class Gesture {
  none,
  stroke,
  orbit,
  pan,
  zoom,
  size,
  strength,
  rotation,
  sizeAndStrength,
  light,        ///< all lights
  lightHandle,  ///< one
  pickColour,
  boxHandle,
  reference,
  support,
  lasso,
  solid
};

enum class Dialog {
  none,
  open,
  saveAs,
  import,
  exportMesh,
  picture,
  windowPicture,
  turntable,
  reference,
  matcap,
  record,
  replay,
  shareTool,
  keepFile,
  combine,
  unsaved,
  recovered,   ///< work came back that was not saved
  leftBehind,  ///< so did work without a name
  help
};

/// A line that appears for some seconds.
struct Message {
  enum class Kind { note, error } kind = Kind::note;
  std::string text;
  double until = 0;
};

/// Where the pointer is, in the clay's world.
struct Hover {
  bool inside = false;  ///< of the free viewport
  std::optional<GroundHit> ground;
  glm::dvec3 air{0};  ///< the working point where there is no clay
  const glm::dvec3& point() const { return ground ? ground->position : air; }
};

/// The tool held in space, in six degrees of freedom.
struct HeldTool {
  glm::dvec3 position{0};
  glm::dquat rotation{1, 0, 0, 0};
};

/// What a still should be.
struct PictureWish {
  std::filesystem::path path;
  int width = 1280, height = 960, slices = 12;
  int frames = 1;  ///< above 1: a turntable, PATH-001.png …
};

class Atelier {
 public:
  struct Options {
    std::filesystem::path scene;         ///< empty: a new ball
    std::filesystem::path configFolder;  ///< empty: nothing is kept
    std::function<void()> wake = [] {};  ///< from any thread: there is something to show
    double newRadius = 48;               ///< of a new ball, cells
  };
  explicit Atelier(const Options& options);
  ~Atelier();

  // Every frame.
  void setTime(double seconds) { now_ = seconds; }
  double now() const { return now_; }
  /// The free viewport in window pixels; `scale` of the interface.
  /// With the keys comes what a drag beside the clay does.
  void setProfile(KeyProfile profile);
  void setViewport(glm::dvec2 corner, const Extent& extent, double scale);
  /// Takes what the worker has finished. Returns patches for the renderer.
  Publication poll();
  /// The worker has something to take.
  bool hasNews() const { return worker_.hasNews(); }

  // Input that no panel took.
  void pointer(const PointerMoved& event);
  void press(Button button, Modifiers held);
  void release(Button button);
  void wheel(double notches, Modifiers held);
  /// True when the key meant something.
  bool key(const Chord& chord, bool repeated);
  void modifiers(Modifiers held) { held_ = held; }
  void puck(const PuckMoved& event);
  void puckButton(const PuckButton& event);
  /// Between gestures: whether a panel has the pointer.
  void panelsHavePointer(bool have);
  void drop(const std::vector<std::string>& paths);
  void askToClose();

  void run(Command command);
  bool isChecked(Command command) const;
  bool isPossible(Command command) const;

  // Files. All ask first when something would be lost.
  void openScene(const std::filesystem::path& path);
  void saveScene(const std::filesystem::path& path, std::function<void()> then = {});
  /// A copy beside the scene's file. Needs a path.
  void saveNumbered();
  void importMesh(const std::filesystem::path& path, int cells);
  void exportMesh(const std::filesystem::path& path, double keep);
  void saveRecording(const std::filesystem::path& path);
  void replay(const std::filesystem::path& path);
  void takePicture(const PictureWish& wish);
  void addReference(const std::filesystem::path& path);
  void loadMatcap(const std::filesystem::path& path);
  void apply(const Operation& operation);
  void resample(double spacing);
  void showStructure(Structure structure);
  void setTool(ActionKind action);

  // History.
  void goTo(StepNumber step);
  /// Strokes bring back the clay of that state from now on.
  void recallFrom(StepNumber step);
  void compareWith(StepNumber step);
  /// Shows the compared state while it lasts.
  void peek(bool shown);
  /// Of the recovered document; true: as the file has it.
  void answerRecovered(bool asSaved);
  void openLeftBehind(const std::filesystem::path& path);
  void discardLeftBehind(const std::filesystem::path& path);
  void keepPicture(StepNumber step, Bytes png);

  // Solids (atelier_solid.cpp).
  WorkMode mode() const { return mode_; }
  void setMode(WorkMode mode);
  /// Null when there is none.
  const std::shared_ptr<const SolidShown>& solidShown() const { return solidShown_; }
  /// What lies under the pointer.
  const SolidHit& solidHit() const { return solidHit_; }
  /// The curve in the making, with the places of its controls as they are dragged now.
  const SolidCurve& curve() const { return curve_; }
  std::vector<glm::dvec3> curveControls() const;
  /// What the tool in hand takes.
  Element solidElement() const;
  /// The hand while it feels something; null otherwise.
  const FeltHand* feltHand() const { return felt_.get(); }
  /// The force it feels, as long as it is drawn. World units.
  glm::dvec3 feltArrow() const;
  /// Stiffness where the probe touched last, 1 as usual.
  std::optional<double> touched() const { return touched_; }
  /// Shows it as `solid` says now.
  void tellSolid();
  void applySolid(const Operation& operation);
  /// Physics only inside the workspace box, where that is shown.
  void solidWindow();
  SolidState solid;

  // Shelves (atelier_shelf.cpp).
  void listShelf();
  void takeTool(const ToolEntry& entry);
  /// What is on the desk, its part in the box or lasso, or what the hand holds, as a tool of the
  /// document.
  void keepClay(const std::string& name, std::vector<std::string> tags, ShelfDrawer::Part part,
                std::optional<PatchSource> patch = {});
  /// What `keepClay` is to keep next: shows the box, or draws a lasso where there is none.
  void choosePart(ShelfDrawer::Part part);
  /// The sculpture in the hand with the pivot and contact it has there.
  void keepStand();
  /// A tool's file, a scene, a recording, a mesh or a grey picture.
  void keepFile(const std::filesystem::path& path);
  /// The same, and into the hand.
  void takeFile(const std::filesystem::path& path);
  /// The same kinds of files as volumes, where they stand in their own world.
  void combineFile(const std::filesystem::path& path, Combining how);
  void keepLetters(const std::string& text, double size, double depth);
  void renameTool(const ToolEntry& entry, const std::string& to, std::vector<std::string> tags);
  void dropTool(const ToolEntry& entry);
  void shareTool(const ToolEntry& entry, const std::filesystem::path& path);
  /// Copies it to the user's library.
  void keepForUser(const ToolEntry& entry, const std::string& as);

  // Parts of the clay, and sculptures as volumes (atelier_parts.cpp).
  /// The next drag draws round a part of the clay.
  bool drawsLasso() const { return lassoNext_; }
  const std::optional<Lasso>& lasso() const { return lasso_; }
  /// What the lasso holds, or the workspace box where it is shown.
  std::optional<WorldRegion> part() const;
  /// What the next click does with the tool in hand.
  std::optional<Combining> combining() const { return combining_; }

  // Clay that moves (atelier_clay.cpp).
  void placeToolAsSupport(const glm::dvec3& at);
  /// Shows it so; it is done when the hand lets go.
  void moveSupport(std::size_t n, const clay::Support& support);
  void settleSupport();
  /// The document keeps how clay gives way, used or not.
  void tellClay();
  void dropSupport(std::size_t n);
  bool hoversLight() const { return hover_.inside && lightHandle_.has_value(); }
  bool hoversSupport() const { return hover_.inside && supportAt(pointer_).has_value(); }
  std::optional<std::size_t> chosenSupport;
  int relaxSteps = 10;

  // What panels change freely.
  SculptState sculpt;
  ViewOptions options;
  ViewState view;
  Settings settings;
  Keymap keymap;
  Moves mouseMoves = Moves::scene, puckMoves = Moves::scene;
  Dialog dialog = Dialog::none;
  std::optional<std::size_t> movingReference;  ///< by dragging in the viewport
  std::optional<Command> rebinding;            ///< the next key becomes this command's
  bool justRebound = false;
  std::optional<double> wantedSpacing;  ///< of the resampling that is being chosen
  ShelfDrawer shelf;
  bool paletteOpen = false;
  bool panelsShown = true;
  bool quadBuffer = false;  ///< the window has left and right buffers; whoever draws says so
  bool lightsOpen = false;  ///< the lights' section: their handles show
  bool standOpen = false;   ///< pivot and contact of the tool in hand are looked at
  bool historyShown = false;
  std::optional<Comparison> comparison;  ///< shown until it is closed
  glm::dvec2 palettePlace{0};
  bool fullScreen = false;
  std::function<Bytes()> thumbnail;                    ///< a PNG of the view; may be empty
  std::optional<std::filesystem::path> windowPicture;  ///< to be written after the next frame

  // What panels show.
  const ClayStatus& status() const { return status_; }
  const ClayStatistics& statistics() const { return statistics_; }
  const PatchSet& patches() const { return patches_; }
  const Hover& hover() const { return hover_; }
  Gesture gesture() const { return gesture_; }
  Modifiers held() const { return held_; }
  Held heldMeaning() const;
  ActionKind actionNow() const { return actionFor(sculpt.action, heldMeaning()); }
  const std::optional<HeldTool>& heldTool() const { return heldTool_; }
  /// A stroke is drawn, and the clay still on its way along it.
  bool followsStroke() const;
  const StrokeMaker* strokeMaker() const { return maker_ ? &*maker_ : nullptr; }
  const std::filesystem::path& path() const { return status_.keeping.path; }
  std::string title() const;
  bool isModified() const { return status_.keeping.modified; }
  const OpenedDocument& document() const { return document_; }
  const std::vector<LeftDocument>& leftBehind() const { return left_; }
  bool isPeeking() const { return peeking_; }
  bool wantsToClose() const { return closing_; }
  /// The one that runs, or has run last; null without any.
  std::shared_ptr<LongJob> job() const { return jobs_.empty() ? nullptr : jobs_.front().job; }
  std::size_t jobsWaiting() const { return jobs_.empty() ? 0 : jobs_.size() - 1; }
  std::vector<Message> messages() const;
  void say(Message::Kind kind, std::string text);
  glm::dvec2 pointerAt() const { return pointer_; }
  const Extent& extent() const { return extent_; }
  glm::dvec2 corner() const { return corner_; }
  double lastInput() const { return lastInput_; }
  double savedAt() const { return savedAt_; }
  ViewFrame viewFrame() const;
  Overlays overlays() const;
  ClayWorker& worker() { return worker_; }
  /// Does `next` at once, or after asking when work would be lost.
  void ifSaved(std::function<void()> next);
  void answerUnsaved(bool save);
  /// Something else than input changed what is shown.
  void touch() { lastInput_ = now_; }
  void lookFrom(double yaw, double pitch);
  void frameAll();

 private:
  void finishJobs(const std::vector<std::shared_ptr<LongJob>>& over);
  const LongJob* bringing() const;
  bool anotherComes();
  bool toolComes();
  /// Short work, long work, and what brings another document.
  void ask(ClayWorker::Task task);
  void begin(const std::string& title, ClayWorker::Work work, std::function<void()> then = {});
  void bring(const std::string& title, ClayWorker::Work work, std::function<void()> then = {});
  void decide(const std::function<void()>& next);
  void wantPictures();
  void lookForTool();
  void standBehind(ReferencePicture& picture) const;
  void dropDocument(const std::filesystem::path& path);
  void dropScene(const std::filesystem::path& path);
  void beginStroke(double pressure);
  void continueStroke(double pressure);
  void flushStroke();
  void tellEye();
  void endStroke();
  void cancelStroke();
  void beginHeldStroke();
  void dragTo(glm::dvec2 to);
  void dragValues(glm::dvec2 by);
  void pickColour();
  void turnLight(glm::dvec2 by);
  std::vector<LightMark> lightMarks() const;
  void findLight();
  void dragLight(glm::dvec2 to);
  void watchLights();
  void takeLights(const SceneParts& parts);
  std::vector<Light> keptLights() const;
  void changeSight(bool (ViewHistory::*how)(Sight&));
  void dragBox(glm::dvec2 by);
  void dragReference(glm::dvec2 to);
  void wheelReference(double notches, Modifiers with);
  std::optional<BoxOutline> boxOutline() const;
  bool isInside(glm::dvec2 pixel) const;
  void updateHover();
  void movedView(const ViewState& before);
  void moveToolDepth(double notches);
  void opened(OpenedDocument document);
  void tell(const Publication& fresh);
  void saved(const SavedFile& file);
  void close();
  Leaving leaving();
  void whenDone(std::shared_ptr<LongJob> job, std::function<void()> then);
  void startNew(NewClay kind, const std::filesystem::path& path = {});
  void takeHold(Moves what);
  void keepSettings();
  void tellSmoothing();
  bool runFile(Command command);
  bool runStroke(Command command);
  void runView(Command command);
  void showNextTool();
  void turnBy(double yaw, double pitch);
  void frameEdit();
  void scaleSize(double factor);
  SceneParts parts() const;
  Gesture gestureFor(Button button, Modifiers held) const;
  GroundHit heldGround() const;
  ToolShape toolAt(const GroundHit& ground) const;
  HandOperations handAt(const GroundHit& ground) const;
  std::optional<Press> pressOn(const GroundHit& ground) const;
  void keep(ShelfKeepOperation operation, std::function<void()> then = {});
  bool runParts(Command command);
  void beginLasso();
  void drawLasso(glm::dvec2 to);
  void endLasso();
  void dropParts();
  void takePart(Command how);
  void combineTool(Combining how);
  std::vector<glm::dvec3> lassoPlaces() const;
  bool runClay(Command command);
  bool runSolid(Command command);
  PickRay solidRay() const;
  SolidHit controlUnder() const;
  SolidHit massUnder() const;
  void hoverSolid();
  bool beginSolid();
  void dragSolid(glm::dvec2 to);
  void brushSolid();
  void endSolid();
  void cancelSolid();
  void workSolid();
  Operation solidDrag() const;
  void makeBlock();
  void wrapClay();
  void applyWrap();
  void bakeSolid();
  void beginFelt();
  void feel(const Publication& fresh);
  void touchSolid();
  void followHand();
  void addForce(Overlays& overlays) const;
  std::vector<glm::dvec3> curvePlaces() const;
  bool beginCurve();
  void hoverCurve();
  void keepCurve();
  void dropCurve();
  void addCurve(Overlays& overlays) const;
  void addSolid(Overlays& overlays) const;
  void addSolidHit(Overlays& overlays) const;
  void relax();
  void holdBox();
  void placeTable();
  std::optional<std::size_t> supportAt(glm::dvec2 pixel) const;
  void dragSupport(glm::dvec2 to);
  void showMovedSupport();
  void leaveSupport();
  void addSupports(Overlays& overlays) const;
  ToolGhost bodyOf(const ToolShape& tool, const glm::dvec3& at, double part = 1,
                   ToolDisplay display = ToolDisplay::transparent) const;
  /// Where the tool stands, how it is turned and how much larger it is than in the hand.
  struct Stand {
    glm::dvec3 at{0};  ///< world units
    glm::dmat3 turn{1};
    double growth = 1;
  };
  glm::dvec3 toolPlace(const GroundHit& ground) const;
  Stand standOn(const GroundHit& ground, const ToolShape& tool) const;
  bool draggedAnchor() const {
    return maker_ && sculpt.placement.anchored && !sculpt.leads(actionNow());
  }
  ToolGhost primitiveGhost(const ToolShape& tool, const Stand& stand) const;
  ToolGhost sculptureGhost(const ToolShape& tool, const Stand& stand) const;
  void addMarks(const ToolShape& tool, const Stand& stand, Overlays& overlays) const;
  GroundHit middleOfView() const;
  void addRings(Overlays& overlays) const;
  void addTool(Overlays& overlays) const;
  void addShownTool(Overlays& overlays) const;
  ToolGhost ghostOf(const ToolShape& tool, const Stand& stand) const;
  void addStage(Overlays& overlays) const;

  double now_ = 0, lastInput_ = 0, savedAt_ = -1, scale_ = 1, pressure_ = 1;
  glm::dvec2 corner_{0}, pointer_{0}, pressedAt_{0};
  Extent extent_{1280, 800};
  Modifiers held_;
  Hover hover_;
  Gesture gesture_ = Gesture::none;
  bool gestureByKey_ = false, runsByKey_ = false;
  SculptState before_;
  ViewHistory views_;
  std::optional<glm::dvec3> airPoint_, joinFrom_;
  std::optional<HeldTool> heldTool_;
  std::optional<StrokeMaker> maker_;
  std::optional<Camera> toldEye_;  // to the worker
  WorkMode mode_ = WorkMode::clay;
  std::shared_ptr<const SolidShown> solidShown_;
  SolidHit solidHit_;
  glm::dvec3 dragged_{0};  // where the hand has taken the hit
  glm::dvec3 handTo_{0};   // where the pointer would take it
  std::unique_ptr<FeltHand> felt_;
  std::optional<double> touched_;
  SolidCurve curve_;
  std::vector<glm::dvec3> curveStart_;  // where its points were when the drag began
  bool heldStroke_ = false, lassoNext_ = false, previewing_ = false;
  std::vector<glm::dvec2> lassoPixels_;
  ViewState lassoView_;
  std::optional<Lasso> lasso_;
  std::optional<Combining> combining_;
  std::optional<std::size_t> lightHandle_;  // under the pointer, or dragged
  bool lightBehind_ = false;                // it was behind the clay when it was taken
  Studio studioSeen_;
  std::optional<int> boxHandle_;  // under the pointer, or dragged
  std::vector<StrokePoint> points_;

  PatchSet patches_;
  ClayStatus status_;
  ClayStatistics statistics_;
  OpenedDocument document_;
  std::vector<LeftDocument> left_;
  std::filesystem::path configFolder_;
  Settings settingsKept_;
  double settingsKeptAt_ = 0;
  bool closing_ = false, framed_ = false, sized_ = false, peeking_ = false;
  std::vector<Message> messages_;
  bool discarding_ = false;  // the user said so; done when the document is left
  std::function<void()> afterSaving_, whenSaved_;
  struct Job {
    std::shared_ptr<LongJob> job;
    std::function<void()> then;
  };
  std::vector<Job> jobs_;
  std::shared_ptr<LongJob> asked_;
  std::pair<std::shared_ptr<LongJob>, ActionKind> taking_;  // what the hand did when it was asked
  std::function<void()> afterAsking_;
  struct MovedSupport {
    std::size_t number;
    clay::Support before, now;
  };
  std::optional<MovedSupport> movedSupport_;
  bool toldSmoothed_ = false;  // to the worker
  std::string toldClay_;       // how clay gives way, as the desk was told last
  ClayWorker worker_;
};

}  // namespace bozzetto::ui
