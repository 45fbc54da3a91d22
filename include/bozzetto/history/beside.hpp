// What stands beside the clay and goes along with its steps.
#pragma once
#include <memory>
#include <utility>

#include "bozzetto/base/bytes.hpp"
#include "bozzetto/solid/solid.hpp"

namespace bozzetto {

using BytesRef = std::shared_ptr<const Bytes>;

struct Beside {
  SolidRef solid;  ///< that is worked on; null when there is none
  /// As those above write them, who alone read them; null: nothing.
  BytesRef supports, ledger, stiffness;

  Beside(SolidRef solidNow = nullptr, BytesRef supportsNow = nullptr, BytesRef ledgerNow = nullptr,
         BytesRef stiffnessNow = nullptr)
      : solid(std::move(solidNow)),
        supports(std::move(supportsNow)),
        ledger(std::move(ledgerNow)),
        stiffness(std::move(stiffnessNow)) {}
  /// By reference.
  friend bool operator==(const Beside&, const Beside&) = default;
};

}  // namespace bozzetto
