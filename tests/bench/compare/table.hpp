// Prints what was measured: a table for each aim, then everything of ours with its counters.
#pragma once
#include "aims.hpp"

namespace bozzetto::compare {

struct Tally {
  int met = 0, missed = 0, absent = 0;
};

/// One table; counts its rows that have an aim.
void printAim(const Aim& aim, const Measurements& measurements, Tally& tally);

/// Every measurement: time, hash, counters.
void printAll(const Measurements& measurements);

}  // namespace bozzetto::compare
