#include "bozzetto/solid/solid.hpp"

#include <algorithm>

#include "bozzetto/base/error.hpp"

namespace bozzetto {

Id Solid::pointNamed(Key name) const {
  const auto place = std::ranges::find(names, name);
  if (place == names.end() || name == kNoName)
    throw Error("solid: found point " + toText(name) + ", expected one of the lattice");
  return static_cast<Id>(place - names.begin());
}

}  // namespace bozzetto
