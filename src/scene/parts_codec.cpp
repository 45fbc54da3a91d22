#include "scene/parts_codec.hpp"

#include <algorithm>
#include <cmath>

#include "bozzetto/scene/clay_bytes.hpp"
#include "bozzetto/scene/stiffness_bytes.hpp"
#include "bozzetto/scene/support_bytes.hpp"

namespace bozzetto {
namespace {

constexpr std::size_t kMostName = 255, kMostTags = 255, kMostSettings = 4096, kMostLights = 64;
constexpr std::size_t kMostSupports = 4096;
constexpr std::size_t kMostThumbnail = std::size_t{16} << 20, kMostText = std::size_t{1} << 20;

using ByteView = std::span<const std::byte>;

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw Error(name + ": " + what);
}

// Length (u32), then that many bytes.
void putBytes(ByteWriter& out, std::span<const std::byte> bytes) {
  out.put(static_cast<std::uint32_t>(bytes.size()));
  out.put(bytes);
}
void putText(ByteWriter& out, const std::string& text) {
  putBytes(out, std::as_bytes(std::span(text.data(), text.size())));
}

ByteView getBytes(ByteReader& in, std::size_t most, const std::string& name) {
  const auto size = in.get<std::uint32_t>();
  if (size > most) {
    refuse(name, std::to_string(size) + " bytes, at most " + std::to_string(most) + " expected");
  }
  return in.take(size);
}

std::string getText(ByteReader& in, std::size_t most, const std::string& name) {
  const ByteView bytes = getBytes(in, most, name);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::uint32_t getCount(ByteReader& in, std::size_t most, const std::string& name) {
  const auto count = in.get<std::uint32_t>();
  if (count > most || count > in.remaining()) {
    refuse(name, std::to_string(count) + " entries, at most " + std::to_string(most) + " expected");
  }
  return count;
}

double getNumber(ByteReader& in, const std::string& name) {
  const auto number = in.get<double>();
  if (!std::isfinite(number)) refuse(name, "a number that is not finite");
  return number;
}

glm::dvec3 getVector(ByteReader& in, const std::string& name) {
  glm::dvec3 v;
  for (int n = 0; n < 3; ++n) v[n] = getNumber(in, name);
  return v;
}

void putVector(ByteWriter& out, const glm::dvec3& v) {
  for (int n = 0; n < 3; ++n) out.put(v[n]);
}

std::uint8_t getChoice(ByteReader& in, std::uint8_t choices, const std::string& name) {
  const auto choice = in.get<std::uint8_t>();
  if (choice >= choices) refuse(name, "choice " + std::to_string(choice) + " unknown");
  return choice;
}

void requireEnd(const ByteReader& in, const std::string& name) {
  if (in.remaining() > 0) refuse(name, std::to_string(in.remaining()) + " bytes too many");
}

void require(bool holds, const std::string& name, const char* what) {
  if (!holds) refuse(name, what);
}

SceneCamera getCamera(ByteReader& in, const std::string& name) {
  SceneCamera camera;
  camera.target = getVector(in, name);
  const double w = getNumber(in, name), x = getNumber(in, name), y = getNumber(in, name);
  camera.worldFromCamera = glm::dquat(w, x, y, getNumber(in, name));
  camera.distance = getNumber(in, name);
  camera.fieldOfView = getNumber(in, name);
  camera.projection = static_cast<SceneProjection>(getChoice(in, 2, name));
  const double length = glm::length(camera.worldFromCamera);
  require(length > 0.5 && length < 2, name, "camera rotation is not a unit quaternion");
  require(camera.distance >= 0, name, "camera distance < 0");
  require(camera.fieldOfView > 0 && camera.fieldOfView < 180, name, "field of view not in 0 … 180");
  return camera;
}

void putCamera(ByteWriter& out, const SceneCamera& camera) {
  const glm::dquat& q = camera.worldFromCamera;
  putVector(out, camera.target);
  for (const double number : {q.w, q.x, q.y, q.z, camera.distance, camera.fieldOfView}) {
    out.put(number);
  }
  out.put(static_cast<std::uint8_t>(camera.projection));
}

Light getLight(ByteReader& in, const std::string& name) {
  Light light;
  light.towards = getVector(in, name);
  for (std::uint8_t* channel : {&light.colour.r, &light.colour.g, &light.colour.b}) {
    *channel = in.get<std::uint8_t>();
  }
  light.intensity = getNumber(in, name);
  light.softness = getNumber(in, name);
  light.castsShadow = getChoice(in, 2, name) == 1;
  require(light.intensity >= 0, name, "light intensity < 0");
  require(light.softness >= 0 && light.softness <= 1, name, "light softness not in 0 … 1");
  return light;
}

void putLight(ByteWriter& out, const Light& light) {
  putVector(out, light.towards);
  for (const std::uint8_t channel : {light.colour.r, light.colour.g, light.colour.b}) {
    out.put(channel);
  }
  out.put(light.intensity);
  out.put(light.softness);
  out.put(static_cast<std::uint8_t>(light.castsShadow));
}

}  // namespace

Bytes encodeHead(const SceneHead& head) {
  ByteWriter out;
  out.put(head.scale.spacing);
  out.put(head.scale.iso);
  for (const std::uint8_t byte : head.identity.bytes) out.put(byte);
  out.put(static_cast<std::uint32_t>(head.settings.size()));
  for (const auto& [key, value] : head.settings) {
    putText(out, key);
    putText(out, value);
  }
  return out.take();
}

SceneHead decodeHead(std::span<const std::byte> bytes, const std::string& name) {
  ByteReader in(bytes, name);
  SceneHead head;
  head.scale.spacing = getNumber(in, name);
  head.scale.iso = in.get<float>();
  require(head.scale.spacing > 1e-100 && head.scale.spacing < 1e100, name,
          "spacing not in 1e-100 … 1e100");
  require(head.scale.iso > 0 && head.scale.iso < 1, name, "iso not between 0 and 1");
  for (std::uint8_t& byte : head.identity.bytes) byte = in.get<std::uint8_t>();
  const std::uint32_t count = getCount(in, kMostSettings, name);
  for (std::uint32_t n = 0; n < count; ++n) {
    std::string key = getText(in, kMostName, name);
    require(head.settings.empty() || head.settings.rbegin()->first < key, name,
            "settings out of order");
    head.settings.emplace_hint(head.settings.end(), std::move(key), getText(in, kMostText, name));
  }
  requireEnd(in, name);
  return head;
}

Bytes encodeView(const View& view) {
  ByteWriter out;
  putCamera(out, view.camera);
  out.put(static_cast<std::uint32_t>(view.lights.size()));
  for (const Light& light : view.lights) putLight(out, light);
  out.put(static_cast<std::uint8_t>(view.workspace.has_value()));
  if (view.workspace) {
    putVector(out, view.workspace->low);
    putVector(out, view.workspace->high);
  }
  return out.take();
}

View decodeView(std::span<const std::byte> bytes, const std::string& name) {
  ByteReader in(bytes, name);
  View view;
  view.camera = getCamera(in, name);
  const std::uint32_t count = getCount(in, kMostLights, name);
  for (std::uint32_t n = 0; n < count; ++n) view.lights.push_back(getLight(in, name));
  if (getChoice(in, 2, name) == 1) {
    view.workspace = WorkspaceBox{getVector(in, name), {}};
    view.workspace->high = getVector(in, name);
    for (int n = 0; n < 3; ++n) {
      require(view.workspace->low[n] <= view.workspace->high[n], name, "workspace box inside out");
    }
  }
  requireEnd(in, name);
  return view;
}

Bytes encodeItem(const ShelfItem& item) {
  ByteWriter out;
  putText(out, item.name);
  out.put(static_cast<std::uint32_t>(item.tags.size()));
  for (const std::string& tag : item.tags) putText(out, tag);
  putBytes(out, item.payload);
  putBytes(out, item.thumbnail);
  return out.take();
}

ShelfItem decodeItem(std::span<const std::byte> bytes, const std::string& name) {
  ByteReader in(bytes, name);
  ShelfItem item;
  item.name = getText(in, kMostName, name);
  const std::uint32_t count = getCount(in, kMostTags, name);
  for (std::uint32_t n = 0; n < count; ++n) item.tags.push_back(getText(in, kMostName, name));
  const ByteView payload = getBytes(in, in.remaining(), name);
  item.payload.assign(payload.begin(), payload.end());
  item.thumbnail = checkedThumbnail(getBytes(in, kMostThumbnail, name), name);
  requireEnd(in, name);
  return item;
}

namespace {

using Sculptures = std::vector<std::shared_ptr<const Sculpture>>;

// Its place among those that came before, where it is put if it is new.
std::uint32_t numberOf(const std::shared_ptr<const Sculpture>& sculpture, Sculptures& known) {
  auto at = std::find(known.begin(), known.end(), sculpture);
  if (at == known.end()) at = known.insert(at, sculpture);
  return static_cast<std::uint32_t>(at - known.begin());
}

std::shared_ptr<const Sculpture> getSculpture(ByteReader& in, const std::string& name) {
  Clay clay = decodeClay(getBytes(in, in.remaining(), name), name + ": sculpture");
  try {
    return std::make_shared<const Sculpture>(std::move(clay));
  } catch (const Error& error) {
    refuse(name, error.what());
  }
}

clay::Support getSupport(ByteReader& in, const std::string& name) {
  clay::Support support;
  support.shape = static_cast<Shape>(getChoice(in, static_cast<int>(Shape::freeform) + 1, name));
  support.centre = getVector(in, name);
  support.radii = getVector(in, name);
  const double w = getNumber(in, name), x = getNumber(in, name), y = getNumber(in, name);
  support.rotation = glm::dquat(w, x, y, getNumber(in, name));
  return support;
}

}  // namespace

Bytes encodeSupports(const std::vector<clay::Support>& supports) {
  Sculptures sculptures;
  ByteWriter out;
  out.put(static_cast<std::uint32_t>(supports.size()));
  for (const clay::Support& support : supports) {
    const glm::dquat& q = support.rotation;
    out.put(static_cast<std::uint8_t>(support.shape));
    putVector(out, support.centre);
    putVector(out, support.radii);
    for (const double number : {q.w, q.x, q.y, q.z}) out.put(number);
    if (support.shape == Shape::freeform) out.put(numberOf(support.sculpture, sculptures));
  }
  for (const auto& sculpture : sculptures)
    putBytes(out, sculpture ? encodeClay(sculpture->clay()) : Bytes());
  return out.take();
}

std::vector<clay::Support> decodeSupports(std::span<const std::byte> bytes,
                                          const std::string& name) {
  ByteReader in(bytes, name);
  std::vector<clay::Support> supports;
  const std::uint32_t count = getCount(in, kMostSupports, name);
  std::vector<std::uint32_t> numbers;  // of the freeform ones
  std::uint32_t needed = 0;
  for (std::uint32_t n = 0; n < count; ++n) {
    supports.push_back(getSupport(in, name));
    if (supports.back().shape != Shape::freeform) continue;
    numbers.push_back(in.get<std::uint32_t>());
    require(numbers.back() <= needed, name, "support of a sculpture that is not there");
    needed = std::max(needed, numbers.back() + 1);
  }
  Sculptures sculptures;
  while (sculptures.size() < needed) sculptures.push_back(getSculpture(in, name));
  auto number = numbers.begin();
  for (clay::Support& support : supports) {
    if (support.shape == Shape::freeform) support.sculpture = sculptures[*number++];
    try {
      clay::requireValid(support);
    } catch (const Error& error) {
      refuse(name, error.what());
    }
  }
  requireEnd(in, name);
  return supports;
}

Bytes encodeStiffness(const clay::Stiffness& stiffness) {
  return stiffness.any() ? encodeClay(*stiffness.painted) : Bytes();
}

clay::Stiffness decodeStiffness(std::span<const std::byte> bytes, const std::string& name) {
  const clay::Stiffness stiffness = clay::stiffnessOf(decodeClay(bytes, name));
  require(stiffness.any(), name, "no painted stiffness");
  clay::requireValid(stiffness, name);
  return stiffness;
}

Bytes checkedThumbnail(std::span<const std::byte> bytes, const std::string& name) {
  constexpr unsigned char kSignature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  const auto signature = std::as_bytes(std::span(kSignature));
  const bool png = bytes.size() >= 8 && bytes.size() <= kMostThumbnail &&
                   std::equal(signature.begin(), signature.end(), bytes.begin());
  require(bytes.empty() || png, name, "thumbnail is not a PNG of at most 16 MiB");
  return {bytes.begin(), bytes.end()};
}

}  // namespace bozzetto
