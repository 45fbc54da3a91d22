// What a disk may hold after a power cut.
#include <algorithm>

#include "support/crash_file_system.hpp"

namespace bozzetto::testing {
namespace {

using Random = std::mt19937;

bool heads(Random& random) { return (random() & 1) != 0; }

}  // namespace

// Which of the first operations are safe: those on a file with a later sync of the file, those on
// names with a later sync of their folder. What a failed sync lost no later one brings back.
std::vector<CrashFileSystem::Fate> CrashFileSystem::fates(std::size_t count) const {
  using Kind = Operation::Kind;
  std::vector<Fate> fates(count, Fate::pending);
  std::map<NodeId, std::vector<std::size_t>> writes;
  std::map<std::string, std::vector<std::size_t>> names;
  const auto settle = [&](std::vector<std::size_t>& waiting, Fate fate) {
    for (const std::size_t each : waiting) fates[each] = fate;
    waiting.clear();
  };
  for (std::size_t n = 0; n < count; ++n) {
    const Operation& operation = log_[n];
    switch (operation.kind) {
      case Kind::write:
      case Kind::truncate:
        writes[operation.node].push_back(n);
        break;
      case Kind::sync:
        settle(writes[operation.node], Fate::durable);
        break;
      case Kind::lose:
        settle(writes[operation.node], Fate::lost);
        break;
      case Kind::create:
      case Kind::remove:
        names[std::filesystem::path(operation.name).parent_path().string()].push_back(n);
        break;
      case Kind::rename:
        names[std::filesystem::path(operation.to).parent_path().string()].push_back(n);
        break;
      case Kind::syncFolder:
        settle(names[operation.name], Fate::durable);
        break;
    }
  }
  return fates;
}

// Plays operations that nothing made durable, as far as they survive.
void CrashFileSystem::survive(Disk& disk, const std::vector<const Operation*>& pending,
                              const Survival& how) {
  Random random(how.seed);
  for (const Operation* operation : pending) {
    Bytes& file = disk.nodes[operation->node].bytes;
    if (operation->kind != Operation::Kind::write) {
      if (how.kind != Survival::Kind::random || heads(random)) disk.apply(*operation);
      continue;
    }
    const std::uint64_t begin = operation->offset, end = begin + operation->bytes.size();
    const bool grows = how.kind == Survival::Kind::sizes || random() % 4 == 0;
    if (grows && file.size() < end) file.resize(end);
    if (how.kind == Survival::Kind::sizes) continue;
    const unsigned fate = random() % 4;
    if (how.kind == Survival::Kind::all || fate == 0) {
      disk.apply(*operation);
    } else if (fate == 1) {
      for (std::uint64_t at = begin; at < end;) {
        const std::uint64_t next = std::min(end, (at / how.sector + 1) * how.sector);
        const auto part = std::span(operation->bytes).subspan(at - begin, next - at);
        if (heads(random)) {
          disk.apply({Operation::Kind::write,
                      "",
                      "",
                      operation->node,
                      at,
                      {part.begin(), part.end()},
                      false});
        }
        at = next;
      }
    }
  }
}

std::unique_ptr<CrashFileSystem> CrashFileSystem::afterPowerCut(std::size_t count,
                                                                const Survival& how) const {
  using Kind = Operation::Kind;
  const std::lock_guard lock(mutex_);
  auto result = std::make_unique<CrashFileSystem>();
  Disk disk = start_;
  const std::vector<Fate> fate = fates(count);
  // Names in their order; what was lost or is pending in files comes with the pending.
  std::vector<const Operation*> pending;
  for (std::size_t n = 0; n < count; ++n) {
    const bool file = log_[n].kind == Kind::write || log_[n].kind == Kind::truncate;
    if (fate[n] == Fate::durable) {
      disk.apply(log_[n]);
    } else if (how.kind == Survival::Kind::none) {
      continue;
    } else if (file && fate[n] == Fate::lost) {
      survive(disk, {&log_[n]}, {how.kind, how.seed + static_cast<std::uint32_t>(n), how.sector});
    } else {
      pending.push_back(&log_[n]);
    }
  }
  if (how.kind == Survival::Kind::random) {
    Random random(how.seed + 1);
    const auto names =
        std::stable_partition(pending.begin(), pending.end(), [](const Operation* operation) {
          return operation->kind == Kind::write || operation->kind == Kind::truncate;
        });
    std::shuffle(pending.begin(), names, random);
  }
  survive(disk, pending, how);
  for (auto& [id, node] : disk.nodes) node.lockedBy = nullptr;
  result->start_ = result->now_ = std::move(disk);
  result->nextNode_ = nextNode_;
  result->clock_ = clock_;
  return result;
}

}  // namespace bozzetto::testing
