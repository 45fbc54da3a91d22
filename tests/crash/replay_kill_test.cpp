// The program is killed a thousand times while it sculpts, saves and rotates its undo-files. What
// comes back is the clay after the last operation that it had called done, or a later one, and undo
// leads on from there as if nothing had happened.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>

#include "bozzetto/sculptor/recording.hpp"
#include "bozzetto/sculptor/session.hpp"
#include "support/folder.hpp"

namespace bozzetto {
namespace {
namespace fs = std::filesystem;

// What a clean replay gives: clay after each of the last steps, and the place among them; undo and
// redo as everybody expects them. Copies cost pointers.
class Model {
 public:
  /// Another program starts: its hand is empty.
  void start() { hand_.clear(); }

  void apply(const Operation& operation) {
    if (std::holds_alternative<ToolOperation>(operation) ||
        std::holds_alternative<ActionOperation>(operation)) {
      hand_.push_back(operation);
    } else if (std::holds_alternative<UndoOperation>(operation)) {
      if (at_ > 0) --at_;
    } else if (std::holds_alternative<RedoOperation>(operation)) {
      if (at_ + 1 < states_.size()) ++at_;
    } else {
      step(operation);
    }
  }
  /// Of the state so many steps back, or on for negative counts; none where none is known.
  std::optional<std::uint64_t> hash(std::ptrdiff_t back) const {
    const std::ptrdiff_t state = static_cast<std::ptrdiff_t>(at_) - back;
    if (state < 0 || state >= std::ssize(states_)) return std::nullopt;
    return states_[static_cast<std::size_t>(state)]->hash;
  }
  bool knowsTheBeginning() const { return !forgotten_; }
  bool untouched() const { return states_.size() == 1 && !forgotten_; }

 private:
  struct State {
    explicit State(Clay clay) : field(std::move(clay)), hash(fieldHash(field)) {}
    Clay field;
    std::uint64_t hash;
  };

  void step(const Operation& operation) {
    Sculptor sculptor(states_[at_]->field);
    for (const Operation& taken : hand_) sculptor.apply(taken);
    sculptor.apply(operation);
    states_.resize(++at_);
    states_.push_back(std::make_shared<State>(sculptor.field()));
    constexpr std::size_t kRemembered = 60;
    if (at_ <= kRemembered) return;
    states_.erase(states_.begin());
    --at_;
    forgotten_ = true;
  }

  std::vector<std::shared_ptr<const State>> states_{std::make_shared<State>(Clay())};
  std::size_t at_ = 0;
  bool forgotten_ = false;
  std::vector<Operation> hand_;
};

// A sculptor at work: strokes of several tools and actions, some mirrored, balls of clay here and
// there, undo and redo in between.
class Worker {
 public:
  explicit Worker(std::mt19937& random) : random_(random) {}

  Recording work() {
    Recording recording;
    for (int left = 1 + pick(14); left > 0; --left) recording.operations.push_back(anything());
    return recording;
  }

 private:
  int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  glm::dvec3 place() { return {pick(48) - 24, pick(48) - 24, pick(48) - 24}; }
  Colour colour() { return {static_cast<std::uint8_t>(pick(256)), 100, 50}; }

  Operation anything() {
    switch (pick(10)) {
      case 0:
        return UndoOperation{1};
      case 1:
        return RedoOperation{1};
      case 2:
        return ball();
      case 3:
        return tool();
      case 4:
        return action();
      default:
        return stroke();
    }
  }

  Operation ball() {
    FillOperation fill;
    fill.primitive.centre = place();
    fill.primitive.radii = glm::dvec3(2.0 + pick(4));
    fill.primitive.colour = colour();
    return fill;
  }
  Operation tool() {
    ToolOperation tool;
    tool.shape.radii = glm::dvec3(2 + pick(6), 2 + pick(6), 2 + pick(6));
    return tool;
  }
  Operation action() {
    constexpr ActionKind kKinds[] = {ActionKind::add,       ActionKind::add,   ActionKind::remove,
                                     ActionKind::paint,     ActionKind::erase, ActionKind::smooth,
                                     ActionKind::paintSoft, ActionKind::stamp};
    ActionOperation action;
    action.action.kind = kKinds[pick(std::size(kKinds))];
    action.action.colour = colour();
    return action;
  }
  Operation stroke() {
    StrokeOperation stroke;
    stroke.stroke.points = {{place()}};
    for (int more = pick(3); more > 0; --more) {
      const glm::dvec3 step(pick(17) - 8, pick(17) - 8, pick(17) - 8);
      stroke.stroke.points.push_back({stroke.stroke.points.back().position + step});
    }
    stroke.stroke.symmetry.mirror[0] = pick(2) == 0;
    return stroke;
  }

  std::mt19937& random_;
};

// `bozzetto replay RECORDING --on SCENE`, and what it says. Without pictures: drawing them takes a
// hundred times as long as all that can be lost.
class Program {
 public:
  Program(const fs::path& recording, const fs::path& scene, bool isNew) {
    int pipe[2];
    if (::pipe(pipe) != 0) throw Error("no pipe");
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(pipe[1], STDOUT_FILENO);
      ::setenv("__EGL_VENDOR_LIBRARY_DIRS", "/nowhere", 1);
      ::execl(BOZZETTO_PROGRAM, "bozzetto", "replay", recording.c_str(), "--on", scene.c_str(),
              "--undo-files", kUndoFiles, isNew ? "--new" : static_cast<char*>(nullptr),
              static_cast<char*>(nullptr));
      ::_exit(127);
    }
    ::close(pipe[1]);
    words_ = ::fdopen(pipe[0], "r");
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
    ::fclose(words_);
  }

  /// N of the next "done N"; nothing at the end.
  std::optional<std::size_t> nextDone() {
    std::size_t number = 0;
    return ::fscanf(words_, " done %zu", &number) == 1 ? std::optional(number) : std::nullopt;
  }
  void kill() const { ::kill(process_, SIGKILL); }

  /// So few that old ones go all the time.
  static constexpr const char* kUndoFiles = "12";

 private:
  pid_t process_ = -1;
  FILE* words_ = nullptr;
};

/// What a campaign met.
struct Met {
  std::size_t finished = 0, killedInSave = 0, checkpoints = 0;
};

class Campaign {
 public:
  explicit Campaign(unsigned seed) : random_(seed) {}

  void killOnce() {
    const Recording recording = Worker(random_).work();
    std::ofstream(folder_ / "r.jsonl") << toText(recording);
    const std::size_t done = runAndKill(recording.operations.size());
    model_.start();
    std::vector<Model> after{model_};
    for (const Operation& operation : recording.operations) {
      after.push_back(after.back());
      after.back().apply(operation);
    }
    takeWhatCameBack(after, done);
    std::error_code none;  // killed before there was a folder
    for (const auto& entry : fs::directory_iterator(historyFolderOf(scene_), none))
      met_.checkpoints += entry.path().extension() == ".checkpoint";
  }
  const Met& met() const { return met_; }
  const fs::path& scene() const { return scene_; }

 private:
  // Returns how many operations the program had called done.
  std::size_t runAndKill(std::size_t operations) {
    Program program(folder_ / "r.jsonl", scene_, isNew_);
    const std::size_t patience = random_() % (operations + 2);
    std::size_t done = 0;
    for (std::size_t n = 0; n < patience; ++n) {
      const auto next = program.nextDone();
      met_.finished += !next;
      if (!next) return done;
      done = *next;
    }
    ::usleep(static_cast<unsigned>(random_() % (patience == 0 ? 20'000 : 2'500)));
    program.kill();
    while (const auto more = program.nextDone()) done = *more;
    met_.killedInSave += done == operations;
    return done;
  }

  void takeWhatCameBack(const std::vector<Model>& after, std::size_t done) {
    Chain found;
    try {
      found = look();
      isNew_ = false;
    } catch (const Error& error) {
      ASSERT_TRUE(isNew_ && after[done].untouched()) << error.what();
      return;
    }
    std::size_t last = done;
    while (last < after.size() && !found.isOf(after[last])) ++last;
    ASSERT_LT(last, after.size()) << "done " << done << ", and something else came back";
    model_ = after[last];
  }

  // Hashes of where we are, of all that undo leads to, and of all that redo leads to.
  struct Chain {
    std::vector<std::uint64_t> back, on;

    // Undo-files may have gone at either end, never have led elsewhere.
    bool isOf(const Model& model) const {
      const auto same = [&](std::uint64_t hash, std::ptrdiff_t steps) {
        const auto known = model.hash(steps);
        return known ? *known == hash : !model.knowsTheBeginning() && steps > 0;
      };
      for (std::size_t n = 0; n < back.size(); ++n)
        if (!same(back[n], static_cast<std::ptrdiff_t>(n))) return false;
      for (std::size_t n = 0; n < on.size(); ++n)
        if (!same(on[n], -1 - static_cast<std::ptrdiff_t>(n))) return false;
      return true;
    }
  };

  Chain look() {
    Session session = Session::look(scene_);
    EXPECT_TRUE(session.findings().notices.empty()) << session.findings().notices[0];
    Sculptor& sculptor = session.sculptor();
    const StepTree& tree = sculptor.history().tree();
    const std::uint64_t here = fieldHash(sculptor.field());
    EXPECT_EQ(fieldHash(Session::look(scene_).sculptor().field()), here) << "seen twice";
    Chain chain{{here}, {}};
    const std::size_t far = random_() % 4 == 0 ? 100 : 2;
    const std::size_t back = std::min(far, tree.undoDepth());
    const std::size_t on = std::min(far, tree.redoDepth());
    EXPECT_EQ(validate(sculptor.field()), std::nullopt);
    for (std::size_t n = 0; n < back; ++n) chain.back.push_back(after(sculptor, UndoOperation{1}));
    sculptor.apply(RedoOperation{static_cast<int>(back)});
    EXPECT_EQ(fieldHash(sculptor.field()), here) << "undone and redone";
    for (std::size_t n = 0; n < on; ++n) chain.on.push_back(after(sculptor, RedoOperation{1}));
    return chain;
  }
  static std::uint64_t after(Sculptor& sculptor, const Operation& operation) {
    sculptor.apply(operation);
    return fieldHash(sculptor.field());
  }

  const testing::Folder folder_{testing::Folder::quick()};
  fs::path scene_ = folder_ / "scene.bzt";
  std::mt19937 random_;
  Model model_;
  bool isNew_ = true;
  Met met_;
};

// Four campaigns of 250, side by side where there are processors for it.
class ReplayKillSlow : public ::testing::TestWithParam<unsigned> {};

TEST_P(ReplayKillSlow, loseNothingThatWasDone) {
  Campaign campaign(GetParam());
  for (int kill = 0; kill < 250; ++kill) {
    ASSERT_NO_FATAL_FAILURE(campaign.killOnce()) << "kill " << kill;
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(campaign.met().finished, 0u) << "some came to their end";
  EXPECT_GT(campaign.met().killedInSave, 0u);
  EXPECT_GT(campaign.met().checkpoints, 0u);
  EXPECT_NE(Session::look(campaign.scene()).sculptor().history().tree().root(), 0u)
      << "old undo-files went";
}

INSTANTIATE_TEST_SUITE_P(Kills, ReplayKillSlow, ::testing::Values(1u, 2u, 3u, 4u));

}  // namespace
}  // namespace bozzetto
