// Parts of the clay that are taken, by a lasso or the workspace box, and sculptures that are united
// with the clay, taken away from it or met with it at once.
#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "ui/atelier.hpp"

namespace bozzetto::ui {
namespace {

constexpr double kLassoStep = 3;  // pixels between its points
constexpr const char *kCopy = "copy", *kPart = "part";

Combining combiningOf(Command command) {
  return command == Command::subtractTool    ? Combining::subtract
         : command == Command::intersectTool ? Combining::intersect
                                             : Combining::unite;
}

// The place of a pixel in the picture of an eye, or in world units where rays are parallel.
glm::dvec2 inPicture(const ViewState& view, const Extent& extent, glm::dvec2 pixel) {
  const Ray ray = rayThrough(view, extent, pixel);
  const glm::dquat viewFromWorld = glm::conjugate(view.worldFromView);
  if (view.projection == Projection::orthographic)
    return glm::dvec2(viewFromWorld * (ray.origin - view.target));
  const glm::dvec3 way = viewFromWorld * ray.direction;
  return glm::dvec2(way) / -way.z;
}

// Parts take each other's place, but no other tool's.
std::string nameForCopy(const std::vector<ShelfItem>& shelf) {
  std::string name = kCopy;
  const auto taken = [&](const ShelfItem& item) {
    return item.name == name && std::ranges::find(item.tags, kPart) == item.tags.end();
  };
  for (int n = 2; std::ranges::any_of(shelf, taken); ++n) name = fmt::format("{} {}", kCopy, n);
  return name;
}

}  // namespace

void Atelier::beginLasso() {
  lassoNext_ = false;
  lasso_.reset();
  lassoView_ = view;
  lassoPixels_ = {pointer_};
}

void Atelier::drawLasso(glm::dvec2 to) {
  pointer_ = to;
  if (glm::distance(to, lassoPixels_.back()) >= kLassoStep * scale_) lassoPixels_.push_back(to);
}

// A slip of the hand is no part, and the lasso still to be drawn.
void Atelier::endLasso() {
  const auto pixels = std::exchange(lassoPixels_, {});
  lassoNext_ = pixels.size() < 4;
  if (lassoNext_) return;
  const bool parallel = view.projection == Projection::orthographic;
  Lasso drawn;
  drawn.rays = parallel ? LassoRays::parallel : LassoRays::fromEye;
  drawn.eye = parallel ? view.target : view.eye();
  drawn.worldFromView = view.worldFromView;
  for (const glm::dvec2& pixel : pixels) drawn.outline.push_back(inPicture(view, extent_, pixel));
  lasso_ = std::move(drawn);
  say(Message::Kind::note,
      fmt::format("{} copies the part, {} cuts it, Esc lets it go",
                  keymap.chordText(Command::copyPart), keymap.chordText(Command::cutPart)));
}

void Atelier::dropParts() {
  lassoNext_ = false;
  lasso_.reset();
  lassoPixels_.clear();
  combining_.reset();
}

// Where the outline is seen, at the depth of what was looked at.
std::vector<glm::dvec3> Atelier::lassoPlaces() const {
  std::vector<glm::dvec3> places;
  for (const glm::dvec2& pixel : lassoPixels_)
    places.push_back(onFacingPlane(view, rayThrough(view, extent_, pixel), view.target));
  if (!lasso_) return places;
  const bool parallel = lasso_->rays == LassoRays::parallel;
  for (const glm::dvec2& point : lasso_->outline) {
    const glm::dvec3 seen =
        parallel ? glm::dvec3(point, 0) : glm::dvec3(point, -1) * lassoView_.distance;
    places.push_back(lasso_->eye + lasso_->worldFromView * seen);
  }
  return places;
}

std::optional<WorldRegion> Atelier::part() const {
  WorldRegion region;
  region.lasso = lasso_;
  if (lasso_) return region;
  if (!options.box || !options.boxSize) return std::nullopt;
  return WorldRegion{options.boxSize->low, options.boxSize->high, {}};
}

// It comes into the hand by way of the document's shelf, so that recordings know it.
void Atelier::takePart(Command how) {
  const WorldRegion region = *part();
  ShelfKeepOperation copy{kCopy, {kPart}};
  copy.source.region = region;
  ActionOptions adding{ActionKind::add, 1, sculpt.colour};
  adding.ownColours = true;
  StrokeOperation plain;  // whatever the tool before did
  plain.stroke.points = {{glm::dvec3(0), 1}};
  copy.preset = {toText(ActionOperation{adding}), toText(plain)};
  const bool cuts = how == Command::cutPart;
  const bool lists = shelf.open;
  lasso_.reset();
  begin(cuts ? "Cutting" : "Copying", [=](ClayDesk& desk, Progress& progress) mutable {
    copy.name = nameForCopy(desk.sculptor().tools().shelf);
    desk.apply(copy, progress);
    if (cuts) desk.apply(CutOperation{region}, progress);
    ToolSource source;
    source.from = "shelf:" + copy.name;
    desk.takeTool(source);
    if (lists) desk.listShelf();
  });
}

// Where it is seen, as it stands there.
void Atelier::combineTool(Combining how) {
  combining_.reset();
  GroundHit ground = hover_.ground.value_or(GroundHit{hover_.air, view.back()});
  const ToolShape tool = toolAt(ground);
  ground.position = toolPlace(ground);
  const Sculpture& sculpture = *tool.sculpture;
  const glm::dvec3 pivot = (sculpture.centre() + sculpture.pivot()) * sculpture.scale().spacing;
  CombineOperation combine;
  combine.with = sculpt.freeform->source;
  combine.how = how;
  combine.pose.rotation = sculpt.standing(tool, ground.normal);
  combine.pose.scale = tool.scale;
  combine.pose.at = ground.position - combine.pose.rotation * (tool.scale * pivot);
  apply(combine);
}

void Atelier::combineFile(const std::filesystem::path& path, Combining how) {
  dialog = Dialog::none;
  CombineOperation combine;
  combine.with.from = std::filesystem::absolute(path).string();
  combine.how = how;
  apply(combine);
}

bool Atelier::runParts(Command command) {
  switch (command) {
    case Command::lasso:
      setMode(WorkMode::clay);
      lassoNext_ = true;
      return true;
    case Command::copyPart:
    case Command::cutPart:
      takePart(command);
      return true;
    case Command::uniteTool:
    case Command::subtractTool:
    case Command::intersectTool:
      setMode(WorkMode::clay);
      // By a key at once; from a menu, whose place says nothing, with the next click.
      combining_ = combiningOf(command);
      if (hover_.inside && runsByKey_) combineTool(*combining_);
      return true;
    default:
      return false;
  }
}

}  // namespace bozzetto::ui
