#include "bozzetto/sculptor/ledger.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace bozzetto {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSetting = "ledger";

constexpr std::array<std::pair<const char*, double MassLedger::*>, 4> kMasses{
    {{"added", &MassLedger::added},
     {"removed", &MassLedger::removed},
     {"dropped", &MassLedger::dropped},
     {"drift", &MassLedger::drift}}};

double finite(double mass, const std::string& name) {
  if (std::isfinite(mass)) return mass;
  throw Error(name + ": ledger: a mass that is no number found");
}

}  // namespace

Bytes encodeLedger(const MassLedger& ledger) {
  ByteWriter out;
  out.put(ledger.moves);
  for (const auto& [key, mass] : kMasses) out.put(ledger.*mass);
  return out.take();
}

MassLedger decodeLedger(std::span<const std::byte> bytes, const std::string& name) {
  MassLedger ledger;
  if (bytes.empty()) return ledger;
  ByteReader in(bytes, name);
  ledger.moves = in.get<std::int64_t>();
  for (const auto& [key, mass] : kMasses) ledger.*mass = finite(in.get<double>(), name);
  if (in.remaining() > 0) throw Error(name + ": ledger: bytes too many");
  return ledger;
}

void putLedger(const MassLedger& ledger, SceneParts& parts) {
  if (ledger == MassLedger{}) {
    parts.settings.erase(kSetting);
    return;
  }
  Json json{{"moves", ledger.moves}};
  for (const auto& [key, mass] : kMasses) json[key] = ledger.*mass;
  parts.settings[kSetting] = json.dump();
}

MassLedger ledgerOf(const SceneParts& parts, const std::string& name) {
  MassLedger ledger;
  const auto kept = parts.settings.find(kSetting);
  if (kept == parts.settings.end()) return ledger;
  const Json json = Json::parse(kept->second, nullptr, false);
  try {
    ledger.moves = json.at("moves").get<std::int64_t>();
    for (const auto& [key, mass] : kMasses) ledger.*mass = finite(json.at(key).get<double>(), name);
  } catch (const Json::exception&) {
    throw Error(name + ": ledger: numbers moves, added, removed, dropped, drift expected");
  }
  return ledger;
}

MassLedger takeLedger(SceneParts& parts, const std::string& name) {
  const MassLedger ledger = ledgerOf(parts, name);
  parts.settings.erase(kSetting);
  return ledger;
}

}  // namespace bozzetto
