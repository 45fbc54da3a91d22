#include <bozzetto/io/mesh_file.hpp>
#include <bozzetto/sculptor/replay.hpp>
#include <bozzetto/surface/welded.hpp>
#include <cstdio>

int main() {
  bozzetto::Sculptor sculptor({}, bozzetto::SurfaceUpkeep::afterEachDab);
  sculptor.apply(bozzetto::FillOperation{});
  sculptor.apply(bozzetto::parseOperation(R"({"op":"stroke","points":[[8,0,0],[0,9,0]]})", ""));
  const auto mesh = bozzetto::weld(sculptor.surface(), sculptor.field().scale);
  bozzetto::writeMesh("ball.ply", mesh);
  std::printf("%zu triangles written\n", mesh.triangles.size());
}
