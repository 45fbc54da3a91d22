// The tool shelf: what a sculptor keeps at hand, by name.
#pragma once
#include <string>
#include <vector>

#include "bozzetto/base/bytes.hpp"

namespace bozzetto {

/// A tool or piece that was put aside. The scene does not look into `payload` and `thumbnail`.
struct ShelfItem {
  std::string name;               ///< UTF-8, at most 255 bytes
  std::vector<std::string> tags;  ///< at most 255, each as a name
  Bytes payload;                  ///< what the tool's owner wrote: an operation's JSON, a field
  Bytes thumbnail;                ///< a PNG, or empty

  friend bool operator==(const ShelfItem&, const ShelfItem&) = default;
};

}  // namespace bozzetto
