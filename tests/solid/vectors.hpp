// Exact answers of subdivision and springs, worked out in fractions from another form of the rules.
#pragma once
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "bozzetto/solid/lattice.hpp"

namespace bozzetto::testing {

using Json = nlohmann::json;

inline const Json& vectors() {
  static const Json json =
      Json::parse(std::ifstream(std::string(BOZZETTO_SOURCE_DIR) + "/tests/solid/vectors.json"));
  return json;
}

/// A number, or a fraction "5/27".
inline double number(const Json& json) {
  if (json.is_number()) return json.get<double>();
  const std::string text = json.get<std::string>();
  const std::size_t bar = text.find('/');
  if (bar == std::string::npos) return std::stod(text);
  return std::stod(text.substr(0, bar)) / std::stod(text.substr(bar + 1));
}

inline glm::dvec3 place(const Json& json) {
  return {number(json[0]), number(json[1]), number(json[2])};
}

inline Lists lists(const Json& json) {
  Lists result;
  for (const Json& list : json) result.add(list.get<std::vector<Id>>());
  return result;
}

/// The lattice of that name; lattices given by rows only get places that do not matter.
inline Lattice lattice(const std::string& name) {
  const Json& json = vectors()["lattices"][name];
  Lattice result;
  result.faces = lists(json["faces"]);
  result.cells = lists(json["cells"]);
  Id points = 0;
  for (const Id n : result.faces.items()) points = std::max(points, n + 1);
  result.points.resize(points);
  for (Id n = 0; n < points; ++n) {
    result.points[n] = json.contains("points") ? place(json["points"][n]) : glm::dvec3(n, n * n, 1);
  }
  for (const Json& edge : json["sharp_edges"])
    result.sharpEdges.push_back(pointPair(edge[0].get<Id>(), edge[1].get<Id>()));
  std::ranges::sort(result.sharpEdges);
  return result;
}

inline std::string keyOf(char kind, std::vector<Id> points) {
  std::ranges::sort(points);
  std::string key(1, kind);
  for (const Id point : points) key += "_" + std::to_string(point);
  return key;
}

/// Names of refined points as the vectors call them: v_0, e_0_1, f_0_1_2_3, c_….
inline std::map<std::string, Id> rowNames(const Lattice& lattice, const Topology& topology) {
  std::map<std::string, Id> names;
  Id row = 0;
  const auto add = [&](char kind, auto points) {
    names[keyOf(kind, {points.begin(), points.end()})] = row++;
  };
  for (Id n = 0; n < lattice.points.size(); ++n) add('v', std::array{n});
  for (const PointPair& edge : topology.edges) add('e', edge);
  for (Id n = 0; n < lattice.faces.size(); ++n) add('f', lattice.faces[n]);
  for (Id n = 0; n < lattice.cells.size(); ++n) add('c', topology.cellPoints[n]);
  return names;
}

}  // namespace bozzetto::testing
