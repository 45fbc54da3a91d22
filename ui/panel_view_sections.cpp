// Sections of the properties panel: look, stroke, symmetry, lights, view.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/letters.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

namespace bozzetto::ui {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

// A slider for a float.
bool slide(const char* label, float& value, const Slide& how, const char* tip) {
  double wide = value;
  if (!slider(label, wide, how, tip)) return false;
  value = float(wide);
  return true;
}

bool lookCard(const LookCard& card, ImTextureID ball, ImVec2 size, bool chosen) {
  ImGui::PushID(card.name);
  const bool clicked = hotArea("card", size);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(low, high, ink(chosen ? 0x3A2A24 : hovered ? 0x212429 : tint::card), px(8));
  if (chosen) {
    list->AddRect({low.x + .5f, low.y + .5f}, {high.x - .5f, high.y - .5f}, ink(tint::accent),
                  px(8), 0, px(1.6f));
  }
  const float r = px(22);
  const ImVec2 centre{(low.x + high.x) / 2, low.y + px(8) + r};
  if (ball != nullptr) {
    list->AddImageRounded(ball, {centre.x - r, centre.y - r}, {centre.x + r, centre.y + r}, {0, 1},
                          {1, 0}, ~0u, r);
  } else {
    list->AddCircleFilled(centre, r, ink(tint::raised), 40);
  }
  const float width = textWidth(fonts().medium, card.name);
  drawText(list, fonts().medium, {centre.x - width / 2, high.y - px(19)},
           chosen ? ink(0xF6D9CB) : ink(tint::dim), card.name);
  tooltip(card.tip);
  ImGui::PopID();
  return clicked;
}

}  // namespace

void lookSection(Atelier& atelier, const UiPictures& pictures) {
  Look& look = atelier.options.look;
  const float gap = px(8), width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  for (std::size_t n = 0; n < kLookCards.size(); ++n) {
    if (n % 3 != 0) ImGui::SameLine();
    const LookCard& card = kLookCards[n];
    if (lookCard(card, pictures.balls[n], {width, px(76)}, isShown(card, look))) {
      look.mode = card.mode;
      look.matcap = card.matcap;
      look.matcapImage.reset();
      atelier.options.matcapFrom.clear();
      atelier.touch();
    }
  }
  ImGui::PopStyleVar();
  if (look.mode == Mode::metal) {
    int metal = int(look.metal);
    if (choice("##metal", metal, {"Chrome", "Bronze"}, "Which metal.")) look.metal = Metal(metal);
  }
  if (look.mode == Mode::plastic) {
    slide("Paint", look.paint, {0, 1, "%", 100, 0}, "How much the layer hides the clay.");
  }
  double turn = look.studio.turn;
  if (slider("Light turn", turn, {-std::numbers::pi, std::numbers::pi, "°", kDegrees, 0},
             "Turns all lights about the vertical.")) {
    look.studio.turn = float(turn);
  }
}

void strokeSection(Atelier& atelier) {
  SculptState& sculpt = atelier.sculpt;
  toggle("Steady hand", sculpt.steady, "The tool follows the pointer on a rope (Shift+S).");
  if (sculpt.steady) {
    slider("Rope", sculpt.rope, {4, 200, "px", 1, 0, true}, "The rope's length in pixels.");
  }
  toggle("Work in the air", sculpt.air,
         "Strokes may start where there is no clay, at the working depth (Ctrl+wheel).");
  int empty = int(sculpt.emptyDrag);
  if (choice("A drag beside the clay", empty, {"sculpts", "orbits"},
             "What the left button does where there is no clay.")) {
    sculpt.emptyDrag = EmptyDrag(empty);
  }
  toggle("Pressure drives strength", sculpt.pressureStrength, "With a pen.");
  toggle("Pressure drives size", sculpt.pressureSize, "With a pen.");
  slider("Pressure curve", sculpt.curve.gamma, {0.25, 4, "", 1, 2, true},
         "1 is straight; more makes light touches lighter.");
  slider("Least pressure", sculpt.curve.least, {0, 0.9, "%", 100, 0},
         "What the lightest touch gives.");
}

void symmetrySection(Atelier& atelier) {
  Symmetry& symmetry = atelier.sculpt.symmetry;
  const char* names[] = {"Mirror X", "Mirror Y", "Mirror Z"};
  const char* tips[] = {"Left and right", "Up and down", "Front and back"};
  for (std::size_t n = 0; n < 3; ++n) toggle(names[n], symmetry.mirror[n], tips[n]);
  double count = symmetry.radialCount;
  if (slider("Around", count, {1, 24, "×", 1, 0}, "Copies around an axis.")) {
    symmetry.radialCount = int(std::lround(count));
  }
  int axis = index(symmetry.radialAxis);
  if (choice("Around the axis", axis, {"X", "Y", "Z"}, "The axis to go around.")) {
    symmetry.radialAxis = kAxes[std::size_t(axis)];
  }
  const float half = (ImGui::GetContentRegionAvail().x - px(8)) / 2;
  const double spacing = atelier.status().scale.spacing;
  if (button("Centre on clay", {half, 0}, ButtonKind::plain,
             "Mirrors about the middle of the clay.")) {
    symmetry.centre = atelier.patches().bounds().centre() * spacing;
  }
  ImGui::SameLine();
  if (button("Centre on 0", {half, 0}, ButtonKind::plain, "Mirrors about the origin.")) {
    symmetry.centre = glm::dvec3(0);
  }
}

namespace {

void oneLight(Studio& studio, std::size_t n) {
  StudioLight& light = studio.lights[n];
  ImGui::PushID(int(n));
  const float most = std::max({light.colour.r, light.colour.g, light.colour.b, 1e-3f});
  float colour[3] = {light.colour.r / most, light.colour.g / most, light.colour.b / most};
  double strength = most;
  const bool recoloured = ImGui::ColorEdit3(
      "##light", colour, ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoTooltip);
  ImGui::SameLine();
  ImGui::TextUnformatted(n == 0 ? "Key light" : ("Light " + std::to_string(n + 1)).c_str());
  if (n > 0) {
    ImGui::SameLine(ImGui::GetContentRegionAvail().x - px(48));
    if (ImGui::SmallButton("Remove")) {
      studio.lights.erase(studio.lights.begin() + std::ptrdiff_t(n));
      ImGui::PopID();
      return;
    }
  }
  const bool stronger =
      slider("Brightness", strength, {0.01, 8, "", 1, 2, true}, "How bright this light is.");
  if (recoloured || stronger) {
    light.colour = glm::vec3(colour[0], colour[1], colour[2]) * float(strength);
  }
  const glm::vec3 to = glm::normalize(light.towards);
  double around = std::atan2(to.x, to.z), height = std::asin(std::clamp(to.y, -1.f, 1.f));
  const bool turned = slider("Around", around, {-std::numbers::pi, std::numbers::pi, "°", kDegrees},
                             "From which side it comes.");
  const bool raised =
      slider("Height", height, {-1.5, 1.5, "°", kDegrees}, "From how high it comes.");
  if (turned || raised) {
    light.towards = {float(std::sin(around) * std::cos(height)), float(std::sin(height)),
                     float(std::cos(around) * std::cos(height))};
  }
  int frame = int(light.frame);
  if (choice("Goes with", frame, {"the view", "the clay"}, "What the light is fixed to.")) {
    light.frame = LightFrame(frame);
  }
  ImGui::Dummy({1, px(4)});
  ImGui::PopID();
}

}  // namespace

void lightSection(Atelier& atelier) {
  Look& look = atelier.options.look;
  Studio& studio = look.studio;
  int environment = int(studio.environment);
  if (choice("Surroundings", environment, {"Studio", "Day", "Dusk", "Workshop", "Zebra"},
             "What mirrors in the clay.")) {
    const float turn = studio.turn;
    studio = Studio(Environment(environment));
    studio.turn = turn;
  }
  slide("Exposure", studio.exposure, {0.1, 2, "", 1, 2, true}, "Brightness of all.");
  slide("Highlights", look.specular.strength, {0, 4, "", 1, 2}, "How strongly wet clay shines.");
  slide("Roughness", look.specular.roughness, {0.05, 1, "", 1, 2}, "0 a mirror, 1 chalk.");
  for (std::size_t n = 0; n < studio.lights.size(); ++n) oneLight(studio, n);
  if (studio.lights.size() < Studio::kMostLights &&
      button("Add a light", {ImGui::GetContentRegionAvail().x, 0}, ButtonKind::plain,
             "One more, from above.")) {
    studio.lights.push_back({});
  }
  if (button("Reset the lights", {ImGui::GetContentRegionAvail().x, 0}, ButtonKind::plain,
             "As they were made for this environment.")) {
    studio = Studio(studio.environment);
  }
}

namespace {

void shownThings(Atelier& atelier) {
  ViewOptions& options = atelier.options;
  toggle("Ring", options.ring, "The cursor on the surface.");
  toggle("Limit of influence", options.limit, "How far the tool reaches.");
  toggle("Wireframe", options.look.edges, "The triangles' edges (W).");
  bool flat = options.look.shading == Shading::flat;
  if (toggle("Flat triangles", flat, "Every triangle by itself.")) {
    options.look.shading = flat ? Shading::flat : Shading::smooth;
  }
  toggle("Smoothed", options.smoothed,
         "Shows moved clay without steps of one cell. Only a look: the clay that is saved and "
         "exported stays as sharp as it is.");
  toggle("Floor", options.look.floor, "Light and shadow under the clay.");
  toggle("Grid", options.grid, "Lines on the floor.");
  toggle("Workspace box", options.box, "A box around the clay (B).");
  if (options.box && button("Fit the box", {ImGui::GetContentRegionAvail().x, 0})) {
    atelier.run(Command::fitBox);
  }
}

}  // namespace

void viewSection(Atelier& atelier) {
  ViewOptions& options = atelier.options;
  int tool = int(options.tool);
  if (choice("The tool", tool, {"Hidden", "Solid", "Clear", "Wires"},
             "How the tool is shown (T).")) {
    options.tool = ToolDisplay(tool);
  }
  shownThings(atelier);
  double angle = atelier.view.fieldOfView;
  if (slider("Lens", angle, {0.1, 1.6, "°", kDegrees}, "The picture's height as an angle.")) {
    // The clay at the target stays as large as it is.
    atelier.view.distance *= std::tan(atelier.view.fieldOfView / 2) / std::tan(angle / 2);
    atelier.view.fieldOfView = angle;
  }
  int orbit = int(atelier.settings.orbit);
  if (choice("Orbit like a", orbit, {"Turntable", "Trackball"}, "How dragging turns the view.")) {
    atelier.settings.orbit = OrbitStyle(orbit);
  }
  int stereo = int(options.stereo.mode);
  if (choice(
          "Stereo", stereo,
          {"Off",
           "Side by side",
           "Rows",
           "Red-cyan",
           {"Quad buffer",
            atelier.quadBuffer ? "" : "This graphics driver has no left and right back buffers."}},
          "A picture for each eye.")) {
    options.stereo.mode = StereoMode(stereo);
  }
  if (options.stereo.mode != StereoMode::off) {
    slider("Eye distance", options.stereo.eyeDistance, {0.005, 0.15, "%", 100, 1, true},
           "As part of the distance to the plane of zero parallax.");
    slider("Zero parallax", options.stereo.zeroParallax, {0.5, 1.5, "", 1, 2},
           "What lies there is on the screen; 1 is the view's target.");
  }
  int structure = int(options.structure);
  if (choice("Data structure", structure, {"Surface", "All cubes", "Crossing"},
             "The data structure: all cubes with clay, cubes the surface crosses.")) {
    atelier.showStructure(Structure(structure));
  }
  int quality = options.quality ? int(*options.quality) + 1 : 0;
  if (choice("Quality", quality, {"Auto", "0", "1", "2", "3", "4"}, "How much frames may cost.")) {
    options.quality.reset();
    if (quality > 0) options.quality = Quality(quality - 1);
  }
}

void referenceSection(Atelier& atelier) {
  auto& references = atelier.options.references;
  for (std::size_t n = 0; n < references.size(); ++n) {
    ReferencePicture& picture = references[n].picture;
    ImGui::PushID(int(n));
    ImGui::TextUnformatted(lettered(std::filesystem::path(references[n].from).filename().string()));
    if (!picture.image && button("Not found: choose again…", {ImGui::GetContentRegionAvail().x, 0},
                                 ButtonKind::plain, references[n].from.c_str())) {
      atelier.run(Command::reference);
    }
    bool moves = atelier.movingReference == n;
    if (toggle("Move it", moves, "Drag it in the view; Shift+wheel: size, Ctrl+wheel: depth.")) {
      atelier.movingReference = moves ? std::optional(n) : std::nullopt;
    }
    slide("Opacity", picture.opacity, {0.05, 1, "%", 100, 0}, "How much of it is seen.");
    toggle("Behind the clay", picture.behind, "Or over everything.");
    double grown = 1;
    if (slider("Larger, smaller", grown, {0.8, 1.25, "×", 1, 2, true}, "Drag to resize.")) {
      picture.right *= grown;
      picture.up *= grown;
    }
    const bool gone = button("Remove", {ImGui::GetContentRegionAvail().x, 0});
    ImGui::PopID();
    if (gone) atelier.movingReference.reset();
    if (gone) references.erase(references.begin() + std::ptrdiff_t(n--));
  }
  if (button("Add a picture…", {ImGui::GetContentRegionAvail().x, 0}, ButtonKind::plain,
             "A PNG, facing you as you look now.")) {
    atelier.run(Command::reference);
  }
}

}  // namespace bozzetto::ui
