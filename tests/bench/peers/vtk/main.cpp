// peer_vtk: Flying Edges of VTK 9 on dense cubes of samples. Filling the cube is not timed.
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <exception>

#include "report.hpp"
#include "workload.hpp"

namespace bozzetto::peer {
namespace {

constexpr int kSide = workload::kGyroidSide;

// A ball of 0.4 of the cube's side, as a distance.
float ball(int x, int y, int z) {
  constexpr float kCentre = 0.5f * (kSide - 1), kRadius = 0.4f * kSide;
  const float dx = static_cast<float>(x) - kCentre, dy = static_cast<float>(y) - kCentre;
  const float dz = static_cast<float>(z) - kCentre;
  return std::sqrt(dx * dx + dy * dy + dz * dz) - kRadius;
}

using Sample = float (*)(int x, int y, int z);

void fill(vtkImageData& image, Sample sample) {
  image.SetDimensions(kSide, kSide, kSide);
  image.AllocateScalars(VTK_FLOAT, 1);
  auto* value = static_cast<float*>(image.GetScalarPointer());
  for (int z = 0; z < kSide; ++z) {
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) *value++ = sample(x, y, z);
    }
  }
}

enum class Normals { off, on };

struct Case {
  const char* name;
  Sample sample;
  Normals normals;
};

constexpr Case kCases[] = {{"gyroid_normals", workload::gyroid, Normals::on},
                           {"gyroid", workload::gyroid, Normals::off},
                           {"sphere_normals", ball, Normals::on},
                           {"sphere", ball, Normals::off}};

void describe(vtkPolyData& mesh, Result& result) {
  Fingerprint fingerprint;
  for (vtkIdType n = 0; n < mesh.GetNumberOfPoints(); ++n) {
    for (const double x : {mesh.GetPoint(n)[0], mesh.GetPoint(n)[1], mesh.GetPoint(n)[2]}) {
      const auto rounded = static_cast<float>(x);
      fingerprint.add(&rounded, 1);
    }
  }
  result.fingerprint = fingerprint.value();
  result.detail = {{"triangles", static_cast<double>(mesh.GetNumberOfCells())},
                   {"vertices", static_cast<double>(mesh.GetNumberOfPoints())}};
}

Result measure(const Case& one, int repeats) {
  Result result{one.name, 0, {}, 0, {}};
  vtkNew<vtkImageData> image;
  fill(*image, one.sample);
  for (int n = 0; n < repeats; ++n) {
    vtkNew<vtkFlyingEdges3D> filter;
    filter->SetInputData(image);
    filter->SetValue(0, 0.0);
    filter->SetComputeNormals(one.normals == Normals::on);
    filter->SetComputeGradients(false);
    filter->SetComputeScalars(false);
    const Clock clock;
    filter->Update();
    result.ms.push_back(clock.ms());
    if (n + 1 == repeats) describe(*filter->GetOutput(), result);
  }
  return result;
}

void run(const Options& options) {
  vtkSMPTools::SetBackend(options.threads == 1 ? "Sequential" : "TBB");
  vtkSMPTools::Initialize(options.threads);
  for (const Case& one : kCases) {
    if (std::string(one.name).rfind(options.only, 0) != 0) continue;
    if (options.list) {
      std::puts(one.name);
    } else {
      print("vtk", options, measure(one, options.repeats));
    }
  }
}

}  // namespace
}  // namespace bozzetto::peer

int main(int count, char** arguments) {
  try {
    bozzetto::peer::run(bozzetto::peer::parseOptions(count, arguments));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "peer_vtk: %s\n", error.what());
    return 1;
  }
}
