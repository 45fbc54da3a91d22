#include "render/clay_picture.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace bozzetto {
namespace {

constexpr double kStopped = .08;                 // seconds after which a camera has come to rest
constexpr std::size_t kTrianglesAtOnce = 50000;  // of a slice, on a processor
constexpr int kFewestShown = 4;                  // slices: fewer are grainy
constexpr int kJoinPixels = 16;
constexpr double kWholeAbove = .6;  // of the picture: then all of it is drawn

int slicesFor(Quality quality) { return quality == Quality::least ? 4 : 12; }

std::size_t coarseAbove(Quality quality) {
  if (quality == Quality::least) return 100000;
  return quality == Quality::light ? 250000 : SIZE_MAX;
}

int samplesFor(const ClayPicture::Request& request) {
  return !request.onProcessor && request.quality >= Quality::middle ? 4 : 0;
}

Look lookFor(const ClayPicture::Request& request) {
  Look look = request.look;
  look.detail = request.quality >= Quality::good ? Detail::full : Detail::baked;
  if (request.quality == Quality::least) look.floor = false;
  return look;
}

Look lookAtRest(const ClayPicture::Request& request) {
  Look look = request.look;
  look.detail = Detail::full;
  return look;
}

bool touch(const PixelRect& a, const PixelRect& b) {
  return a.x <= b.x + b.width + kJoinPixels && b.x <= a.x + a.width + kJoinPixels &&
         a.y <= b.y + b.height + kJoinPixels && b.y <= a.y + a.height + kJoinPixels;
}

PixelRect joined(const PixelRect& a, const PixelRect& b) {
  const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return {x, y, std::max(a.x + a.width, b.x + b.width) - x,
          std::max(a.y + a.height, b.y + b.height) - y};
}

// The box on the screen with some pixels around; nothing when it reaches behind the eye.
std::optional<PixelRect> onScreen(const Frame& frame, const CellBounds& box) {
  constexpr double kMargin = 3;
  const glm::dvec2 size(frame.width, frame.height);
  glm::dvec2 low = size, high(0);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p(corner & 4 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                       corner & 1 ? box.high.z : box.low.z);
    const glm::dvec3 local = p - glm::dvec3(frame.anchor.i, frame.anchor.j, frame.anchor.k);
    const glm::dvec4 clip = frame.clipFromCells * glm::dvec4(local, 1);
    if (clip.w <= 1e-6) return std::nullopt;
    const glm::dvec2 at = (glm::dvec2(clip) / clip.w * .5 + .5) * size;
    low = glm::min(low, at - kMargin);
    high = glm::max(high, at + kMargin);
  }
  low = glm::clamp(glm::floor(low), glm::dvec2(0), size);
  high = glm::clamp(glm::ceil(high), glm::dvec2(0), size);
  const glm::dvec2 extent = glm::max(high - low, glm::dvec2(0));
  return PixelRect{int(low.x), int(low.y), int(extent.x), int(extent.y)};
}

void join(std::vector<PixelRect>& parts, PixelRect part) {
  for (std::size_t n = 0; n < parts.size();) {
    if (!touch(parts[n], part)) {
      ++n;
      continue;
    }
    part = joined(parts[n], part);
    parts.erase(parts.begin() + std::ptrdiff_t(n));
    n = 0;
  }
  parts.push_back(part);
}

}  // namespace

std::vector<PixelRect> touchedParts(const Frame& frame, std::span<const CellBounds> boxes) {
  std::vector<PixelRect> parts;
  const std::vector<PixelRect> whole{{0, 0, frame.width, frame.height}};
  for (const CellBounds& box : boxes) {
    const auto part = onScreen(frame, box);
    if (!part) return whole;
    if (part->width > 0 && part->height > 0) join(parts, *part);
  }
  double area = 0;
  for (const PixelRect& part : parts) area += double(part.width) * part.height;
  return area > kWholeAbove * frame.width * frame.height ? whole : parts;
}

bool ClayPicture::shows(const Request& request) const {
  return valid_ && request.shot == shot_ && request.look == look_;
}

bool ClayPicture::wantsCoarse(const Request& request) const {
  const Renderer::Impl& r = renderer_;
  return r.finest() == Fineness::fine &&
         r.store(Fineness::fine).triangleCount() > coarseAbove(request.quality) &&
         r.store(Fineness::coarse).triangleCount() > 0;
}

ClayPicture::Report ClayPicture::bring(const Request& request) {
  if (valid_ && request.shot != shot_) lastMove_ = request.now;
  const bool moving = request.now - lastMove_ < kStopped;
  const bool coarse = moving && wantsCoarse(request);
  const auto changes = renderer_.changes.since(revision_);
  if (!shows(request) || !changes) {
    return draw(request, coarse ? Fineness::coarse : renderer_.finest());
  }
  if (!changes->empty()) {
    if (coarse) return draw(request, Fineness::coarse);
    if (const auto report = patch(request, *changes)) return *report;
    return draw(request, renderer_.finest());
  }
  if (fineness_ == Fineness::coarse) {
    return moving ? Report{} : draw(request, Fineness::fine);
  }
  return refine(request);
}

void ClayPicture::makeRoom(const Request& request) {
  const int w = request.shot.width, h = request.shot.height, samples = samplesFor(request);
  if (shown_.width != w || shown_.height != h) {
    shown_ = Target(GL_RGBA8, w, h, Target::Depth::buffer);
    shown_.smooth();
    multisampled_.reset();
  }
  if (samples == 0) multisampled_.reset();
  if (samples > 0 && !multisampled_) multisampled_.emplace(w, h, samples);
  gl::check("making room for the view");
}

void ClayPicture::bindForDrawing() const {
  const gl::Framebuffer& target = multisampled_ ? multisampled_->framebuffer : shown_.framebuffer;
  glBindFramebuffer(GL_FRAMEBUFFER, target.get());
}

void ClayPicture::resolve(const PixelRect& part) const {
  if (!multisampled_) return;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, multisampled_->framebuffer.get());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, shown_.framebuffer.get());
  const int right = part.x + part.width, top = part.y + part.height;
  glBlitFramebuffer(part.x, part.y, right, top, part.x, part.y, right, top,
                    GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

ClayPicture::Report ClayPicture::draw(const Request& request, Fineness fineness) {
  const gl::KeepTarget keep;
  makeRoom(request);
  bindForDrawing();
  drawnLook_ = lookFor(request);
  const int taps = request.quality == Quality::good ? 8 : 16;  // 4 are grainy
  Report report{FrameReport::Clay::drawn, 0, false};
  report.triangles = renderer_.drawFrame(request.shot, drawnLook_, fineness, taps);
  resolve({0, 0, shown_.width, shown_.height});
  frame_ = makeFrame(request.shot, drawnLook_, Slice{});
  refined_.restart();
  valid_ = true;
  ++version_;
  meanShown_ = false;
  shot_ = request.shot;
  look_ = request.look;
  fineness_ = fineness;
  revision_ = renderer_.changes.now();
  return report;
}

// Only from a fine picture without slices: a refined one would show the part's outline. Full light
// reaches beyond the part with its shadows.
std::optional<ClayPicture::Report> ClayPicture::patch(const Request& request,
                                                      std::span<const CellBounds> boxes) {
  if (fineness_ != renderer_.finest() || meanShown_ || drawnLook_.detail == Detail::full) {
    return std::nullopt;
  }
  const std::vector<PixelRect> parts = touchedParts(frame_, boxes);
  const gl::KeepTarget keep;
  Report report{FrameReport::Clay::patched, 0, false};
  for (const PixelRect& part : parts) {
    bindForDrawing();
    report.triangles += renderer_.redrawPart(request.shot, drawnLook_, part);
    resolve(part);
  }
  refined_.restart();
  ++version_;
  revision_ = renderer_.changes.now();
  return report;
}

void ClayPicture::showMean() {
  const gl::KeepTarget keep;
  shown_.bind();
  glDepthMask(GL_FALSE);
  renderer_.show(refined_);
  glDepthMask(GL_TRUE);
  meanShown_ = true;
  ++version_;
}

ClayPicture::Report ClayPicture::refine(const Request& request) {
  Report report;
  report.settled = refined_.slices >= slicesFor(request.quality);
  if (report.settled || !request.mayRefine) return report;
  const std::size_t budget = request.onProcessor ? kTrianglesAtOnce : 0;
  const bool whole = renderer_.advance(refined_, request.shot, lookAtRest(request), budget);
  if (whole && refined_.slices >= kFewestShown) showMean();
  report.clay = FrameReport::Clay::refined;
  report.settled = refined_.slices >= slicesFor(request.quality);
  return report;
}

}  // namespace bozzetto
