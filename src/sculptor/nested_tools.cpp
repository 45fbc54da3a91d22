#include "sculptor/nested_tools.hpp"

#include <algorithm>

namespace bozzetto {

std::string NestedTools::sentence() const {
  if (inward_.empty()) return what();
  const std::string& first = inward_.front();
  const auto again = std::find(inward_.begin() + 1, inward_.end(), first);
  if (again == inward_.end()) return first + ": " + what();
  std::string by;
  for (auto each = inward_.begin() + 1; each != again; ++each)
    by += " with the tool " + *each + ", which is made";
  return first + " is made" + by + " with " + (by.empty() ? "itself" : "the first") + " as a tool";
}

}  // namespace bozzetto
