// What the project set out to reach, as data: which figure of ours stands against which figure of
// whom, and how many times as good it shall be.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "measurements.hpp"

namespace bozzetto::compare {

/// One figure: of which measurement, and "ms" or the name of a counter. In names {r} stands for
/// the tool's radius and {t} for the number of threads.
struct Figure {
  std::string name;
  std::string metric = "ms";
};

/// Nothing is asked for; the row is for information.
inline constexpr double kNoAim = 0;

struct Aim {
  std::string title;
  Figure ours, theirs;
  std::vector<double> factors;  ///< theirs / ours shall reach it: for each radius, or a single one
};

/// A program of ours and the peers' cases that run next to it.
struct Contest {
  std::string program;                                         ///< of ours
  std::vector<std::pair<std::string, std::string>> opponents;  ///< program, beginning of cases
};

inline constexpr std::array<int, 5> kRadii{8, 16, 32, 64, 128};
inline constexpr std::array<int, 2> kThreads{1, 2};

std::vector<Contest> contests();
std::vector<Aim> aims();

/// Blender's figures of 2026-11-21: another machine (AMD EPYC, Zen 5), not this run.
void addBlenderOfRecord(Measurements& to);

}  // namespace bozzetto::compare
