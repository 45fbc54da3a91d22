#include "ui/keymap.hpp"

#include <algorithm>

namespace bozzetto::ui {

bool Keymap::inverts(Modifiers held) const {
  if (held.shift) return false;
  return profile_ == KeyProfile::blender ? held.ctrl && !held.alt : held.alt && !held.ctrl;
}

std::vector<Chord> Keymap::chords(Command command) const {
  if (const auto found = changed_.find(command); found != changed_.end()) return found->second;
  const CommandRow& row = rowOf(command);
  return chordsOf(profile_ == KeyProfile::blender ? row.blender : row.zbrush);
}

std::string Keymap::chordText(Command command) const {
  const std::vector<Chord> all = chords(command);
  return all.empty() ? "" : toText(all.front());
}

std::optional<Command> Keymap::find(const Chord& chord) const {
  for (const CommandRow& row : commandTable()) {
    const std::vector<Chord> all = chords(row.command);
    if (std::find(all.begin(), all.end(), chord) != all.end()) return row.command;
  }
  return std::nullopt;
}

void Keymap::bind(Command command, const std::vector<Chord>& wanted) {
  for (const Chord& chord : wanted) {
    const auto owner = find(chord);
    if (!owner || *owner == command) continue;
    std::vector<Chord> left = chords(*owner);
    std::erase(left, chord);
    changed_[*owner] = left;
  }
  changed_[command] = wanted;
}

std::map<std::string, std::string> Keymap::changes() const {
  std::map<std::string, std::string> texts;
  for (const auto& [command, chords] : changed_) {
    texts[std::string(rowOf(command).id)] = toText(chords);
  }
  return texts;
}

void Keymap::setChanges(const std::map<std::string, std::string>& changes) {
  changed_.clear();
  for (const CommandRow& row : commandTable()) {
    const auto found = changes.find(std::string(row.id));
    if (found != changes.end()) changed_[row.command] = chordsOf(found->second);
  }
}

std::string toText(const std::vector<Chord>& chords) {
  std::string text;
  for (const Chord& chord : chords) text += (text.empty() ? "" : ", ") + toText(chord);
  return text;
}

}  // namespace bozzetto::ui
