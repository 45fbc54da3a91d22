#include "bozzetto/io/mesh_file.hpp"

#include <array>
#include <string>

#include "bozzetto/base/file.hpp"
#include "bozzetto/io/glb.hpp"
#include "bozzetto/io/inventor.hpp"
#include "bozzetto/io/obj.hpp"
#include "bozzetto/io/off.hpp"
#include "bozzetto/io/ply.hpp"
#include "bozzetto/io/stl.hpp"
#include "io/sniff.hpp"
#include "io/text_reader.hpp"

namespace bozzetto {
namespace {

constexpr std::array<std::pair<std::string_view, MeshFormat>, 6> kExtensions{
    {{".stl", MeshFormat::stl},
     {".ply", MeshFormat::ply},
     {".obj", MeshFormat::obj},
     {".off", MeshFormat::off},
     {".glb", MeshFormat::glb},
     {".iv", MeshFormat::inventor}}};

std::optional<MeshFormat> formatByExtension(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  for (const auto& [name, format] : kExtensions) {
    if (equalsIgnoringCase(extension, name)) return format;
  }
  return std::nullopt;
}

[[noreturn]] void failUnknown(const std::filesystem::path& path, std::string_view expected) {
  throw Error(path.string() + ": found extension " + shownText(path.extension().string()) +
              ", expected " + std::string(expected));
}

Bytes encode(MeshFormat format, const TriangleMesh& mesh, Progress& progress) {
  switch (format) {
    case MeshFormat::stl:
      return writeStl(mesh, progress);
    case MeshFormat::ply:
      return writePly(mesh, progress);
    case MeshFormat::obj:
      return writeObj(mesh, progress);
    case MeshFormat::glb:
      return writeGlb(mesh, progress);
    case MeshFormat::inventor:
      return writeInventor(mesh, progress);
    case MeshFormat::off:
      break;
  }
  throw Error("OFF is read, not written: expected .stl .ply .obj .glb or .iv");
}

}  // namespace

MeshFormat meshFormatOf(const std::filesystem::path& path) {
  if (const auto format = formatByExtension(path)) return *format;
  failUnknown(path, ".stl .ply .obj .off .glb or .iv");
}

TriangleMesh readMesh(const std::filesystem::path& path, Progress& progress) {
  const Bytes bytes = readFile(path);
  const std::string name = path.string();
  if (bytes.empty()) throw Error(name + ": found an empty file, expected a mesh");
  const auto sniffed = sniffMeshFormat(bytes);
  const auto format = sniffed ? sniffed : formatByExtension(path);
  switch (format.value_or(MeshFormat::inventor)) {
    case MeshFormat::stl:
      return readStl(bytes, name, progress);
    case MeshFormat::ply:
      return readPly(bytes, name, progress);
    case MeshFormat::obj:
      return readObj(bytes, name, progress);
    case MeshFormat::off:
      return readOff(bytes, name, progress);
    case MeshFormat::glb:
      return readGlb(bytes, name, progress);
    case MeshFormat::inventor:
      break;
  }
  failUnknown(path, "a mesh: .stl .ply .obj .off or .glb");
}

void writeMesh(const std::filesystem::path& path, const TriangleMesh& mesh, Progress& progress) {
  writeMesh(path, meshFormatOf(path), mesh, progress);
}

void writeMesh(const std::filesystem::path& path, MeshFormat format, const TriangleMesh& mesh,
               Progress& progress) {
  writeFile(path, encode(format, mesh, progress));
}

}  // namespace bozzetto
