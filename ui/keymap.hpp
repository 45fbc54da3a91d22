// Which keys do what: one of two profiles, and what the user changed.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ui/commands.hpp"

namespace bozzetto::ui {

enum class KeyProfile { blender, zbrush };

class Keymap {
 public:
  /// What the tool does while a modifier is held. Blender: Ctrl inverts; ZBrush: Alt does.
  bool inverts(Modifiers held) const;
  /// Shift smooths in both.
  bool smooths(Modifiers held) const { return held.shift && !held.ctrl && !held.alt; }
  /// ZBrush: Ctrl holds clay (a mask there).
  bool holds(Modifiers held) const {
    return profile_ == KeyProfile::zbrush && held.ctrl && !held.alt && !held.shift;
  }
  /// The name of the key that inverts.
  std::string_view invertName() const { return profile_ == KeyProfile::blender ? "Ctrl" : "Alt"; }

  KeyProfile profile() const { return profile_; }
  /// Changed keys stay changed.
  void setProfile(KeyProfile profile) { profile_ = profile; }

  std::vector<Chord> chords(Command command) const;
  /// The first chord as text; empty when the command has none.
  std::string chordText(Command command) const;
  std::optional<Command> find(const Chord& chord) const;

  /// Gives a command these keys and takes them from whoever had them.
  void bind(Command command, const std::vector<Chord>& chords);
  void resetToDefaults() { changed_.clear(); }
  bool isChanged(Command command) const { return changed_.contains(command); }

  /// What differs from the profile: id → "Ctrl+Z, F5". Unknown ids and keys are left out.
  std::map<std::string, std::string> changes() const;
  void setChanges(const std::map<std::string, std::string>& changes);

 private:
  KeyProfile profile_ = KeyProfile::blender;
  std::map<Command, std::vector<Chord>> changed_;
};

/// "Ctrl+Z, F5".
std::string toText(const std::vector<Chord>& chords);

}  // namespace bozzetto::ui
