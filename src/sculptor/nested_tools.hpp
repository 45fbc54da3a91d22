// Recordings that make tools for recordings, without end: told once, not at every turn.
#pragma once
#include <string>
#include <vector>

#include "bozzetto/base/error.hpp"

namespace bozzetto {

/// On its way out of the innermost one every recording adds its name.
class NestedTools : public Error {
 public:
  NestedTools() : Error("recordings of tools nested too deeply") {}

  void add(const std::string& recording) { inward_.insert(inward_.begin(), recording); }
  /// Which of them is made with itself.
  std::string sentence() const;

 private:
  std::vector<std::string> inward_;
};

}  // namespace bozzetto
