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

namespace bozzetto {
namespace {
namespace fs = std::filesystem;

// A kill does not wait for the disk: memory is as good, and quicker.
class Folder {
 public:
  Folder() {
    const fs::path quick = "/dev/shm";
    std::string name =
        ((fs::is_directory(quick) ? quick : fs::temp_directory_path()) / "bozzetto-XXXXXX")
            .string();
    if (::mkdtemp(name.data()) == nullptr) throw Error("no temporary folder");
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path_); }
  fs::path operator/(const char* name) const { return path_ / name; }

 private:
  fs::path path_;
};

// Clay after each of the last steps, and the place among them: undo and redo as everybody expects
// them. Copies cost pointers.
class Model {
 public:
  void apply(const Operation& operation) {
    if (std::holds_alternative<UndoOperation>(operation)) {
      if (at_ > 0) --at_;
    } else if (std::holds_alternative<RedoOperation>(operation)) {
      if (at_ + 1 < states_.size()) ++at_;
    } else {
      Sculptor sculptor(states_[at_]->field);
      sculptor.apply(operation);
      states_.resize(++at_);
      states_.push_back(std::make_shared<State>(sculptor.field()));
      forget();
    }
  }
  std::uint64_t hash() const { return states_[at_]->hash; }
  std::optional<std::uint64_t> hashBefore() const {
    return at_ > 0 ? std::optional(states_[at_ - 1]->hash) : std::nullopt;
  }

 private:
  struct State {
    explicit State(Clay clay) : field(std::move(clay)), hash(fieldHash(field)) {}
    Clay field;
    std::uint64_t hash;
  };
  // So many undos in a row do not happen.
  void forget() {
    constexpr std::size_t kDeepest = 60;
    if (at_ <= kDeepest) return;
    states_.erase(states_.begin());
    --at_;
  }

  std::vector<std::shared_ptr<const State>> states_{std::make_shared<State>(Clay())};
  std::size_t at_ = 0;
};

// Balls of clay here and there, with undo and redo in between.
Recording someWork(std::mt19937& random) {
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  Recording recording;
  for (int n = 0; n < 12; ++n) {
    const int kind = pick(8);
    if (kind == 0) {
      recording.operations.push_back(UndoOperation{1});
    } else if (kind == 1) {
      recording.operations.push_back(RedoOperation{1});
    } else {
      FillOperation fill;
      fill.primitive.centre = {pick(60) - 30, pick(60) - 30, pick(60) - 30};
      fill.primitive.radii = glm::dvec3(2.0 + pick(4));
      fill.primitive.colour = {static_cast<std::uint8_t>(pick(256)), 100, 50};
      recording.operations.push_back(fill);
    }
  }
  return recording;
}

// `bozzetto replay RECORDING --on SCENE`, and what it says.
class Program {
 public:
  Program(const fs::path& recording, const fs::path& scene, bool isNew) {
    int pipe[2];
    if (::pipe(pipe) != 0) throw Error("no pipe");
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(pipe[1], STDOUT_FILENO);
      ::execl(BOZZETTO_PROGRAM, "bozzetto", "replay", recording.c_str(), "--on", scene.c_str(),
              isNew ? "--new" : static_cast<char*>(nullptr), static_cast<char*>(nullptr));
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

 private:
  pid_t process_ = -1;
  FILE* words_ = nullptr;
};

class Campaign {
 public:
  explicit Campaign(unsigned seed) : random_(seed) {}

  void killOnce() {
    const Recording recording = someWork(random_);
    std::ofstream(folder_ / "r.jsonl") << toText(recording);
    const std::size_t done = runAndKill(recording.operations.size());
    std::vector<Model> after{model_};
    for (const Operation& operation : recording.operations) {
      after.push_back(after.back());
      after.back().apply(operation);
    }
    takeWhatCameBack(after, done);
  }
  std::size_t finished() const { return finished_; }

 private:
  // Returns how many operations the program had called done.
  std::size_t runAndKill(std::size_t operations) {
    Program program(folder_ / "r.jsonl", scene_, isNew_);
    const std::size_t patience = random_() % (operations + 3);
    std::size_t done = 0;
    for (std::size_t n = 0; n < patience; ++n) {
      const auto next = program.nextDone();
      finished_ += !next;
      if (!next) break;
      done = *next;
    }
    ::usleep(static_cast<unsigned>(random_() % 2500));
    program.kill();
    while (const auto more = program.nextDone()) done = *more;
    return done;
  }

  void takeWhatCameBack(const std::vector<Model>& after, std::size_t done) {
    std::optional<std::uint64_t> found, before;
    try {
      Session session = Session::look(scene_);
      found = fieldHash(session.sculptor().field());
      if (session.sculptor().history().undoDepth() > 0) {
        session.sculptor().apply(UndoOperation{1});
        before = fieldHash(session.sculptor().field());
      }
      ASSERT_EQ(fieldHash(Session::look(scene_).sculptor().field()), found) << "seen twice";
      isNew_ = false;
    } catch (const Error& error) {
      ASSERT_TRUE(isNew_ && done == 0) << error.what();
      return;
    }
    std::size_t last = done;
    while (last < after.size() && !isState(after[last], *found, before)) ++last;
    ASSERT_LT(last, after.size()) << "done " << done << ", and something else came back";
    model_ = after[last];
  }

  // Undo may have been cut at the limit of undo-files, never led elsewhere.
  static bool isState(const Model& model, std::uint64_t hash, std::optional<std::uint64_t> before) {
    return model.hash() == hash && (!before || model.hashBefore() == before);
  }

  Folder folder_;
  fs::path scene_ = folder_ / "scene.bzt";
  std::mt19937 random_;
  Model model_;
  bool isNew_ = true;
  std::size_t finished_ = 0;
};

TEST(ReplayKillSlow, aThousandKillsLoseNothingThatWasDone) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    Campaign campaign(seed);
    for (int kill = 0; kill < 250; ++kill) {
      ASSERT_NO_FATAL_FAILURE(campaign.killOnce()) << "seed " << seed << ", kill " << kill;
      if (::testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(campaign.finished(), 0u) << "some came to their end";
  }
}

}  // namespace
}  // namespace bozzetto
