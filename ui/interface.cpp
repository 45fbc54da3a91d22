#include "ui/interface.hpp"

#include <algorithm>
#include <cmath>

#include "ui/letters.hpp"

namespace bozzetto::ui {
namespace {

// ImGui 1.86 asks for keys by index into KeysDown.
void nameKeys(ImGuiIO& io) {
  const auto set = [&](ImGuiKey name, KeyCode key) { io.KeyMap[name] = int(key); };
  set(ImGuiKey_Tab, KeyCode::tab);
  set(ImGuiKey_LeftArrow, KeyCode::left);
  set(ImGuiKey_RightArrow, KeyCode::right);
  set(ImGuiKey_UpArrow, KeyCode::up);
  set(ImGuiKey_DownArrow, KeyCode::down);
  set(ImGuiKey_PageUp, KeyCode::pageUp);
  set(ImGuiKey_PageDown, KeyCode::pageDown);
  set(ImGuiKey_Home, KeyCode::home);
  set(ImGuiKey_End, KeyCode::end);
  set(ImGuiKey_Insert, KeyCode::insert);
  set(ImGuiKey_Delete, KeyCode::del);
  set(ImGuiKey_Backspace, KeyCode::backspace);
  set(ImGuiKey_Space, KeyCode::space);
  set(ImGuiKey_Enter, KeyCode::enter);
  set(ImGuiKey_Escape, KeyCode::escape);
  set(ImGuiKey_KeyPadEnter, KeyCode::numpadEnter);
  set(ImGuiKey_A, letter('A'));
  set(ImGuiKey_C, letter('C'));
  set(ImGuiKey_V, letter('V'));
  set(ImGuiKey_X, letter('X'));
  set(ImGuiKey_Y, letter('Y'));
  set(ImGuiKey_Z, letter('Z'));
}

}  // namespace

Interface::Interface(Atelier& atelier) : atelier_(&atelier), context_(ImGui::CreateContext()) {
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigInputTextCursorBlink = false;
  nameKeys(io);
}

Interface::~Interface() { ImGui::DestroyContext(context_); }

void Interface::setScale(float scale) { scale_ = std::clamp(scale, 0.5f, 4.f); }

// Menus and panels fit into the window. In steps: every other scale needs fonts of its own.
float Interface::fittingScale(glm::dvec2 size) const {
  constexpr double kLeastWidth = 880, kLeastHeight = 480, kSteps = 8;
  const double most = std::min(size.x / kLeastWidth, size.y / kLeastHeight);
  const double step = std::max(std::floor(most * kSteps) / kSteps, 0.5);
  return std::min(scale_, float(step));
}

bool Interface::panelsHavePointer() const {
  return atelier_->dialog != Dialog::none || atelier_->paletteOpen ||
         ImGui::GetIO().WantCaptureMouse;
}

bool Interface::panelsHaveKeys() const {
  return atelier_->dialog != Dialog::none || ImGui::GetIO().WantTextInput ||
         ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

void Interface::feedPointer(const PointerMoved& event) {
  ImGui::GetIO().MousePos = {float(event.at.x), float(event.at.y)};
  movedNow_ = true;
  atelier_->pointer(event);
}

// False: wait for the next frame, when ImGui knows what the pointer is over.
bool Interface::feedButton(const ButtonChanged& event) {
  const int n = int(event.button);
  if (buttonNow_[n] || (event.down && movedNow_)) return false;
  buttonNow_[n] = true;
  ImGuiIO& io = ImGui::GetIO();
  atelier_->touch();
  if (!event.down) {
    io.MouseDown[n] = false;
    if (std::exchange(onClay_[n], false)) atelier_->release(event.button);
    return true;
  }
  const bool keyGesture = atelier_->gesture() != Gesture::none;
  const bool inside = layout_.viewport.contains({double(io.MousePos.x), double(io.MousePos.y)});
  if (!panelsHavePointer() && (inside || keyGesture)) {
    onClay_[n] = true;
    ImGui::SetWindowFocus(nullptr);
    atelier_->press(event.button, held_);
  } else {
    io.MouseDown[n] = true;
  }
  return true;
}

bool Interface::feedKey(const KeyChanged& event) {
  if (std::find(keysNow_.begin(), keysNow_.end(), event.key) != keysNow_.end()) return false;
  ImGuiIO& io = ImGui::GetIO();
  // Fields see Ctrl with A, however fast it was let go.
  const auto isPressed = [&](KeyCode key) { return !isModifier(key) && io.KeysDown[int(key)]; };
  if (isModifier(event.key) && std::any_of(keysNow_.begin(), keysNow_.end(), isPressed)) {
    return false;
  }
  const int code = int(event.key);
  if (code <= 0 || code > int(KeyCode::last)) return true;
  if (!event.repeated) keysNow_.push_back(event.key);
  io.KeysDown[code] = event.down;
  const auto down = [&](KeyCode a, KeyCode b) {
    return io.KeysDown[int(a)] || io.KeysDown[int(b)];
  };
  held_.ctrl = io.KeyCtrl = down(KeyCode::leftControl, KeyCode::rightControl);
  held_.shift = io.KeyShift = down(KeyCode::leftShift, KeyCode::rightShift);
  held_.alt = io.KeyAlt = down(KeyCode::leftAlt, KeyCode::rightAlt);
  atelier_->modifiers(held_);
  atelier_->touch();
  if (atelier_->rebinding && event.down && !isModifier(event.key)) {
    rebind({event.key, held_});
  } else if (event.down && !isModifier(event.key) && !panelsHaveKeys()) {
    atelier_->key({event.key, held_}, event.repeated);
  }
  return true;
}

// The key that the help window waits for. Escape leaves the command without one.
void Interface::rebind(const Chord& chord) {
  const Command command = *std::exchange(atelier_->rebinding, std::nullopt);
  atelier_->justRebound = true;
  const bool none = chord.key == KeyCode::escape;
  atelier_->keymap.bind(command, none ? std::vector<Chord>{} : std::vector<Chord>{chord});
}

void Interface::releaseAll() {
  ImGuiIO& io = ImGui::GetIO();
  std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
  io.KeyCtrl = io.KeyShift = io.KeyAlt = false;
  held_ = {};
  atelier_->modifiers({});
}

// False: this event and what follows wait for the next frame.
bool Interface::feedOne(const InputEvent& event) {
  if (const auto* moved = std::get_if<PointerMoved>(&event)) {
    feedPointer(*moved);
  } else if (const auto* button = std::get_if<ButtonChanged>(&event)) {
    return feedButton(*button);
  } else if (const auto* key = std::get_if<KeyChanged>(&event)) {
    return feedKey(*key);
  } else if (const auto* wheel = std::get_if<WheelTurned>(&event)) {
    if (movedNow_) return false;
    if (!panelsHavePointer()) atelier_->wheel(wheel->by.y, held_);
    if (panelsHavePointer()) {
      ImGui::GetIO().MouseWheel += float(wheel->by.y);
      ImGui::GetIO().MouseWheelH += float(wheel->by.x);
    }
  } else if (const auto* text = std::get_if<TextTyped>(&event)) {
    ImGui::GetIO().AddInputCharacter(text->codepoint);
  } else if (const auto* focus = std::get_if<FocusChanged>(&event)) {
    if (!focus->focused) releaseAll();
  } else if (const auto* files = std::get_if<FilesDropped>(&event)) {
    atelier_->drop(files->paths);
  } else if (const auto* puck = std::get_if<PuckMoved>(&event)) {
    atelier_->puck(*puck);
  } else if (const auto* puckButton = std::get_if<PuckButton>(&event)) {
    atelier_->puckButton(*puckButton);
  } else if (std::holds_alternative<CloseAsked>(event)) {
    atelier_->askToClose();
  }
  return true;
}

void Interface::feed() {
  movedNow_ = false;
  std::fill(std::begin(buttonNow_), std::end(buttonNow_), false);
  keysNow_.clear();
  while (!events_.empty() && feedOne(events_.front())) events_.pop_front();
}

Publication Interface::frame(glm::dvec2 size, double now) {
  ImGui::SetCurrentContext(context_);
  const float scale = fittingScale(size);
  if (scale != builtScale_ || lettersAreNew()) {
    useTheme(scale);
    builtScale_ = scale;
    if (fontsChanged) fontsChanged();
  }
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {float(size.x), float(size.y)};
  io.DeltaTime = float(std::clamp(now - last_, 1e-4, 0.25));
  last_ = now;
  atelier_->setTime(now);
  layout_ = layoutFor(size, scale, atelier_->panelsShown && !atelier_->fullScreen,
                      atelier_->shelf.open ? Drawer::open : Drawer::closed);
  const Rect& at = layout_.viewport;
  atelier_->setViewport(at.low, {at.width(), at.height()}, scale);
  Publication fresh = atelier_->poll();
  feed();
  // Dialogs and open menus are gone through with arrows, Enter and Escape; else keys are the
  // clay's.
  io.ConfigFlags = panelsHaveKeys() ? ImGuiConfigFlags_NavEnableKeyboard : 0;
  // ImGui 1.86 knows only Space for that.
  const bool enter = io.KeysDown[int(KeyCode::enter)] || io.KeysDown[int(KeyCode::numpadEnter)];
  io.NavInputs[ImGuiNavInput_Activate] = enter && io.ConfigFlags != 0 ? 1.f : 0.f;
  ImGui::NewFrame();
  // Now ImGui knows what the pointer is over.
  if (ImGui::IsMousePosValid()) atelier_->panelsHavePointer(panelsHavePointer());
  build();
  ImGui::Render();
  return fresh;
}

void Interface::build() {
  const PanelContext context{*atelier_, layout_, pictures, figures};
  drawViewportMarks(context);
  atelier_->lightsOpen = atelier_->standOpen = false;  // whoever draws their section says so
  if (layout_.panels) {
    drawTopBar(context);
    drawToolColumn(context);
    drawShelf(context);
    drawProperties(context);
    drawStatusLine(context);
  }
  drawAxisBall(context);
  drawHistoryStrip(context);
  drawHistoryPanel(context);
  drawPalette(context);
  drawProgress(context);
  drawDialogs(context);
  drawRecovery(context);
  drawHelp(context);
  drawMessages(context);
  if (lettersAreNew()) atelier_->touch();  // they show in the next frame
}

}  // namespace bozzetto::ui
