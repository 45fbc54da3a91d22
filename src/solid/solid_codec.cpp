#include "bozzetto/solid/solid_codec.hpp"

#include <algorithm>
#include <cmath>

#include "bozzetto/base/error.hpp"

namespace bozzetto {
namespace {

constexpr std::uint32_t kMagic = 0x31444c53;  // "SLD1"
enum class DeltaKind : std::uint8_t { none, whole, places };

template <class T>
void putList(ByteWriter& out, const std::vector<T>& list) {
  out.put(static_cast<std::uint32_t>(list.size()));
  for (const T& item : list) out.put(item);
}
void put(ByteWriter& out, const glm::dvec3& p) {
  for (int axis = 0; axis < 3; ++axis) out.put(p[axis]);
}
void putList(ByteWriter& out, const std::vector<glm::dvec3>& list) {
  out.put(static_cast<std::uint32_t>(list.size()));
  for (const auto& p : list) put(out, p);
}
void putLists(ByteWriter& out, const Lists& lists) {
  out.put(static_cast<std::uint32_t>(lists.size()));
  for (std::size_t n = 0; n < lists.size(); ++n) {
    out.put(static_cast<std::uint16_t>(lists[n].size()));
    for (const Id item : lists[n]) out.put(item);
  }
}

class Reader {
 public:
  Reader(std::span<const std::byte> bytes, std::string_view name) : in_(bytes, name), name_(name) {}

  std::size_t count(std::size_t bytesEach) {
    const std::size_t found = in_.get<std::uint32_t>();
    if (found > in_.remaining() / bytesEach)
      fail("a list of " + std::to_string(found), "one that fits");
    return found;
  }
  template <class T>
  std::vector<T> list() {
    std::vector<T> result(count(sizeof(T)));
    for (T& item : result) item = in_.get<T>();
    return result;
  }
  // All numbers of a solid are finite and of sane size.
  double number() {
    const double value = in_.get<double>();
    if (!(std::abs(value) <= 1e18)) fail("a number out of range", "one up to 1e18");
    return value;
  }
  std::vector<double> numbers() {
    std::vector<double> result(count(8));
    for (double& item : result) item = number();
    return result;
  }
  std::vector<glm::dvec3> places() {
    std::vector<glm::dvec3> result(count(24));
    for (auto& p : result)
      for (int axis = 0; axis < 3; ++axis) p[axis] = number();
    return result;
  }
  Lists lists() {
    Lists result;
    std::vector<Id> items;
    for (std::size_t left = count(2); left > 0; --left) {
      const std::size_t size = in_.get<std::uint16_t>();
      if (size > in_.remaining() / 4) fail("a short list", "its numbers");
      items.clear();
      for (std::size_t n = 0; n < size; ++n) items.push_back(in_.get<Id>());
      result.add(items);
    }
    return result;
  }
  template <class T>
  T get() {
    return in_.get<T>();
  }
  void end() {
    if (in_.remaining() != 0) fail(std::to_string(in_.remaining()) + " bytes more", "the end");
  }
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
    throw Error(std::string(name_) + ": solid: found " + found + " at byte " +
                std::to_string(in_.position()) + ", expected " + expected);
  }

 private:
  ByteReader in_;
  std::string_view name_;
};

void putSettings(ByteWriter& out, const SolidSettings& s) {
  out.put(static_cast<std::uint8_t>(s.solver));
  out.put(static_cast<std::uint8_t>(s.levels));
  for (const double x : {s.timeStep, s.damping, s.stiffness, s.angular, s.ropeStrength, s.creep})
    out.put(x);
}

SolidSettings readSettings(Reader& in) {
  SolidSettings s;
  const auto solver = in.get<std::uint8_t>();
  if (solver > 3) in.fail("solver " + std::to_string(solver), "0 to 3");
  s.solver = static_cast<Solver>(solver);
  s.levels = in.get<std::uint8_t>();
  for (double* x : {&s.timeStep, &s.damping, &s.stiffness, &s.angular, &s.ropeStrength, &s.creep})
    *x = in.number();
  requireValid(s);
  return s;
}

void putMatter(ByteWriter& out, const SolidMatter& matter) {
  for (const auto* list : {&matter.mass, &matter.hardness, &matter.lengths, &matter.angles})
    putList(out, *list);
  putList(out, matter.trimmed);
  putList(out, matter.fixed);
  putList(out, matter.velocity);
}

SolidMatter readMatter(Reader& in) {
  SolidMatter matter;
  for (auto* list : {&matter.mass, &matter.hardness, &matter.lengths, &matter.angles})
    *list = in.numbers();
  matter.trimmed = in.list<std::uint8_t>();
  matter.fixed = in.list<std::uint8_t>();
  matter.velocity = in.places();
  return matter;
}

void requireSound(const Solid& solid, const Reader& in) {
  const std::size_t points = solid.control.points.size();
  const auto all = [&](std::size_t size) { return size == 0 || size == points; };
  if (solid.names.size() != points || !all(solid.wrapRest.size()) ||
      !all(solid.matter.fixed.size()) || !all(solid.matter.velocity.size()))
    in.fail("lists of other lengths", "one entry a point");
  if (solid.control.cells.size() == 0) in.fail("no cells", "at least one");
  if (const auto fault = validate(solid.control)) in.fail(*fault, "a lattice");
}

}  // namespace

Bytes encodeSolid(const SolidRef& solid) {
  ByteWriter out;
  if (solid == nullptr) return out.take();
  out.put(kMagic);
  putList(out, solid->control.points);
  putLists(out, solid->control.faces);
  putLists(out, solid->control.cells);
  out.put(static_cast<std::uint32_t>(solid->control.sharpEdges.size()));
  for (const PointPair& edge : solid->control.sharpEdges) out.put(edge[0]), out.put(edge[1]);
  putList(out, solid->control.sharpPoints);
  out.put(static_cast<std::uint32_t>(solid->names.size()));
  for (const Key name : solid->names) out.put(name.i), out.put(name.j), out.put(name.k);
  putList(out, solid->wrapRest);
  putSettings(out, solid->settings);
  putMatter(out, solid->matter);
  return out.take();
}

SolidRef decodeSolid(std::span<const std::byte> bytes, std::string_view name) {
  if (bytes.empty()) return nullptr;
  Reader in(bytes, name);
  if (in.get<std::uint32_t>() != kMagic) in.fail("other bytes", "a solid");
  auto solid = std::make_shared<Solid>();
  solid->control.points = in.places();
  solid->control.faces = in.lists();
  solid->control.cells = in.lists();
  solid->control.sharpEdges.resize(in.count(8));
  for (PointPair& edge : solid->control.sharpEdges)
    for (Id& end : edge) end = in.get<Id>();
  solid->control.sharpPoints = in.list<Id>();
  solid->names.resize(in.count(12));
  for (Key& key : solid->names)
    for (const Axis axis : kAxes) key[axis] = in.get<std::int32_t>();
  solid->wrapRest = in.places();
  solid->settings = readSettings(in);
  solid->matter = readMatter(in);
  in.end();
  requireSound(*solid, in);
  return solid;
}

Bytes encodeSolidDelta(const SolidRef& before, const SolidRef& after) {
  ByteWriter out;
  if (before == after || (before && after && *before == *after)) {
    out.put(static_cast<std::uint8_t>(DeltaKind::none));
    return out.take();
  }
  if (before && after) {
    Solid moved = *before;
    moved.control.points = after->control.points;
    if (moved == *after) {
      out.put(static_cast<std::uint8_t>(DeltaKind::places));
      std::vector<Id> changed;
      for (Id n = 0; n < after->control.points.size(); ++n)
        if (before->control.points[n] != after->control.points[n]) changed.push_back(n);
      putList(out, changed);
      for (const Id n : changed) put(out, after->control.points[n]);
      return out.take();
    }
  }
  out.put(static_cast<std::uint8_t>(DeltaKind::whole));
  out.put(std::span<const std::byte>(encodeSolid(after)));
  return out.take();
}

SolidRef applySolidDelta(const SolidRef& before, std::span<const std::byte> bytes,
                         std::string_view name) {
  Reader in(bytes, name);
  const auto kind = static_cast<DeltaKind>(in.get<std::uint8_t>());
  if (kind == DeltaKind::whole) return decodeSolid(bytes.subspan(1), name);
  if (kind == DeltaKind::none) {
    in.end();
    return before;
  }
  if (kind != DeltaKind::places || before == nullptr) in.fail("another kind of change", "0 to 2");
  auto solid = std::make_shared<Solid>(*before);
  for (const Id n : in.list<Id>()) {
    if (n >= solid->control.points.size()) in.fail("point " + std::to_string(n), "one there is");
    for (int axis = 0; axis < 3; ++axis) solid->control.points[n][axis] = in.number();
  }
  in.end();
  return solid;
}

}  // namespace bozzetto
