#include "aims.hpp"

namespace bozzetto::compare {
namespace {

constexpr const char* kRecord = "blender of 2026-11-21";

std::string perDab(const std::string& name) { return name + "/radius:{r}/side:8/threads:{t}"; }
std::string openvdb(const std::string& name) { return "openvdb/" + name + "/threads:{t}"; }

void addKernelAims(std::vector<Aim>& aims) {
  const std::vector<double> fromSixteen{kNoAim, 1, 1, 1, 1};
  const std::vector<double> none(kRadii.size(), kNoAim);
  for (const std::string change : {"add", "remove"}) {
    const Figure ours{perDab("dab_" + change)};
    const auto against = [&](const std::string& what, const std::string& name,
                             const std::vector<double>& factors) {
      aims.push_back({"brush kernel, " + change + ", against OpenVDB leaf-wise " + what,
                      ours,
                      {openvdb(name + change + "/radius:{r}")},
                      factors});
    };
    against("level set", "dab_", fromSixteen);
    against("fog with tiles", "fog_", none);
    against("fog, dense", "fog_dense_", none);
    against("fog, our potential and arithmetic", "fog_wyvill_", none);
  }
  aims.push_back({"smooth (ours 27 neighbours with colours, theirs 6)",
                  {perDab("dab_smooth")},
                  {openvdb("smooth/radius:{r}")},
                  none});
}

void addSurfaceAims(std::vector<Aim>& aims) {
  const Figure refresh{perDab("refresh")};
  aims.push_back({"surface refresh against copied leaves + volumeToMesh",
                  refresh,
                  {openvdb("refresh/radius:{r}")},
                  {8, 8, 5, 3, 2}});
  aims.push_back({"the same without the apron of a leaf",
                  refresh,
                  {openvdb("refresh_tight/radius:{r}")},
                  std::vector<double>(5, kNoAim)});
  aims.push_back({"full extraction, memory never touched before, against volumeToMesh",
                  {"extract_ball_cold/side:8/threads:{t}"},
                  {openvdb("mesh")},
                  {kNoAim}});
  aims.push_back({"full extraction against volumeToMesh",
                  {"extract_ball/side:8/threads:{t}"},
                  {openvdb("mesh")},
                  {2}});
  aims.push_back({"full extraction, gyroid, against VTK Flying Edges with normals",
                  {"extract_gyroid/side:8/threads:{t}"},
                  {"vtk/gyroid_normals/threads:{t}"},
                  {1}});
}

void addWholeDabAims(std::vector<Aim>& aims) {
  const Figure ours{perDab("whole_dab")};
  const std::vector<double> draw{1, 1, 1, 1 / 2.5, 1 / 2.5};
  const std::vector<double> dyntopo{10, 10, 10, 10, kNoAim};
  aims.push_back(
      {"whole dab against Blender's Draw", ours, {"blender/draw/radius:{r}/threads:{t}"}, draw});
  aims.push_back({"whole dab against Blender's dyntopo",
                  ours,
                  {"blender/dyntopo/radius:{r}/threads:{t}"},
                  dyntopo});
  aims.push_back({std::string("whole dab against Draw, ") + kRecord,
                  ours,
                  {"record/draw/radius:{r}/threads:{t}"},
                  draw});
  aims.push_back({std::string("whole dab against dyntopo, ") + kRecord,
                  ours,
                  {"record/dyntopo/radius:{r}/threads:{t}"},
                  dyntopo});
  aims.push_back({"whole dab against an editor built on OpenVDB",
                  ours,
                  {openvdb("whole_dab/radius:{r}")},
                  std::vector<double>(5, kNoAim)});
  aims.push_back({"dab in a scene of a million blocks against an empty one",
                  {perDab("dab_crowded")},
                  {perDab("dab_lonely")},
                  std::vector<double>(5, 1 / 1.3)});
}

void addStorageAims(std::vector<Aim>& aims) {
  const Figure memory{"memory_ball", "bytes_without_colour"};
  aims.push_back({"memory of the ball, without 4 bytes a corner for colour and hold, against fog",
                  memory,
                  {"openvdb/snapshot_fog/threads:1", "bytes"},
                  {1}});
  aims.push_back(
      {"the same against the level set", memory, {"openvdb/snapshot/threads:1", "bytes"}, {1}});
  for (const std::string how : {"blosc", "zip"}) {
    aims.push_back({"save against .vdb " + how + " with fsync",
                    {"save_ball/threads:{t}"},
                    {openvdb("write_fsync_" + how)},
                    {how == "blosc" ? kNoAim : 1}});
    aims.push_back(
        {"load against .vdb " + how, {"load_ball/threads:{t}"}, {openvdb("read_" + how)}, {1}});
    aims.push_back({"bytes of the file against .vdb " + how,
                    {"save_ball/threads:{t}", "bytes"},
                    {openvdb("write_fsync_" + how), "bytes"},
                    {1}});
  }
}

}  // namespace

std::vector<Contest> contests() {
  return {
      {"bench_tool",
       {{"peer_openvdb", "dab_"}, {"peer_openvdb", "fog_"}, {"peer_openvdb", "smooth"}}},
      {"bench_surface", {{"peer_openvdb", "refresh"}, {"peer_openvdb", "mesh"}, {"peer_vtk", ""}}},
      {"bench_dab",
       {{"peer_openvdb", "whole_dab"}, {"peer_openvdb", "snapshot"}, {"peer_blender", ""}}},
      {"bench_scene", {{"peer_openvdb", "write_"}, {"peer_openvdb", "read_"}}},
      {"bench_replay", {}},
      {"bench_freeform", {}},
      {"bench_history", {}},
      {"bench_clay", {}},
      {"bench_solid", {}}};
}

std::vector<Aim> aims() {
  std::vector<Aim> all;
  addKernelAims(all);
  addSurfaceAims(all);
  addWholeDabAims(all);
  addStorageAims(all);
  return all;
}

void addBlenderOfRecord(Measurements& to) {
  constexpr double kDraw[2][5] = {{0.166, 0.211, 0.546, 1.41, 4.54},
                                  {0.160, 0.173, 0.414, 0.960, 2.59}};
  constexpr double kDyntopo[2][4] = {{0.979, 3.18, 21.25, 91.74}, {1.31, 2.91, 21.13, 104}};
  for (std::size_t t = 0; t < 2; ++t) {
    for (std::size_t r = 0; r < 5; ++r) {
      const std::string where =
          "/radius:" + std::to_string(kRadii[r]) + "/threads:" + std::to_string(kThreads[t]);
      to.at("record/draw" + where).addTime(kDraw[t][r]);
      if (r < 4) to.at("record/dyntopo" + where).addTime(kDyntopo[t][r]);
    }
  }
}

}  // namespace bozzetto::compare
