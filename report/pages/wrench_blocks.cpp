#include "report/pages/wrench_blocks.h"

#include <array>

#include <fmt/format.h>

#include "grasp/closing/describe_grasp.h"
#include "grasp/limits/force_set.h"
#include "grasp/quality/wrench_set_mesh.h"
#include "report/blocks.h"
#include "report/picture/hand_picture.h"

namespace thenar {
namespace {

constexpr int kEdgePieces = 6;      // Pieces of each edge of the octahedron of directions
constexpr int kFrictionSteps = 24;  // Steps of the curve of friction
constexpr double kMaxFriction = 2;  // Largest friction, over the contacts' own [1]
constexpr const char* kSlice = "#0072b2";
constexpr const char* kShadow = "#8a8f99";
const Eigen::Vector3d kSlanted(1, -1, 0.7);  // eye on wrenches, which are in the object's frame

std::string enclosed(const Epsilon& e) {
  return fmt::format("between {:.5g} and {:.5g}", e.lower, e.upper);
}

Json number_table(const GraspResult& result) {
  // Bounds of epsilon, and what its units are.
  const Epsilon& e = result.grasp.quality;
  Table table{{"measure", "value"},
              {{"signed epsilon", enclosed(e)},
               {"force closure", e.force_closure ? "yes" : "no"},
               {"rank of the wrenches", fmt::format("{} of 6", e.rank)},
               {"limit of forces", result.request.limit == ForceNorm::kL1
                                       ? "normal forces sum up to 1 (L1)"
                                       : "each normal force is at most 1 (L-infinity)"},
               {"torques divided by",
                fmt::format("{:.1f} mm, the reach of the object from its centre of mass",
                            1000 * result.setting.setup.object.torque_scale)}}};
  if (e.has_missing_direction) table.add({"no wrench along", direction_words(e.missing_direction)});
  table.add({e.has_missing_direction ? "does not withstand" : "weakest against",
             direction_words(e.worst_wrench)});
  return table_block("Directions in the object's frame, torques about its centre of mass.", table);
}

/// The caps with all friction, torsion too, times a factor.
WrenchSet with_friction(const WrenchSet& set, double factor) {
  WrenchSet scaled = set;
  for (WrenchCap& cap : scaled.caps) cap.A *= factor;
  return scaled;
}

Json friction_chart(const GraspResult& result) {
  // Repeat epsilon with the cones scaled: it shows how much the grasp depends on friction.
  EpsilonOptions options;
  options.limit = result.request.limit;
  Json x = Json::array(), y = Json::array(), low = Json::array(), high = Json::array();
  for (int i = 0; i <= kFrictionSteps; ++i) {
    const double factor = kMaxFriction * i / kFrictionSteps;
    const Epsilon e = epsilon(with_friction(result.wrenches, factor), options);
    x.push_back(factor);
    y.push_back((e.lower + e.upper) / 2);
    low.push_back(e.lower);
    high.push_back(e.upper);
  }
  return with(
      lines_block("Signed epsilon of the same contacts with less and more friction.",
                  "friction relative to the materials' value [1]", "epsilon [1]",
                  Json::array({with(curve_json("epsilon", x, y),
                                    {{"band_low", low}, {"band_high", high}})})),
      {{"reference_lines", Json::array({{{"value", 0}, {"label", "force closure above"}},
                                        {{"axis", "x"}, {"value", 1}, {"label", "as it is"}}})}});
}

Json mesh_layer(const std::string& name, const std::string& color, double opacity,
                const WrenchSetMesh& picture, MeshTable& meshes) {
  TriangleMesh mesh = picture.mesh;
  mesh.vertices /= 1000;               // the table counts in mm, the scene in N
  constexpr double kCreaseAngle = 20;  // Angle beyond which an edge is drawn sharp [deg]
  return layer(name, color,
               Json::array({{{"kind", "mesh"},
                             {"mesh", meshes.add(mesh, {kCreaseAngle, {}})},
                             {"opacity", opacity}}}));
}

Json axes_layer() {
  Json items = Json::array();
  for (int k = 0; k < 3; ++k)
    items.push_back({{"kind", "arrow"},
                     {"from", Json::array({0, 0, 0})},
                     {"vector", numbers3(1.15 * Eigen::Vector3d::Unit(k))},
                     {"radius", 0.008},
                     {"label", std::string(1, "xyz"[k])}});
  return layer("axes", kShadow, items);
}

/// Three coordinates of the set: those of all wrenches, and of those without the other three.
Json set_scene(const GraspResult& result, int first, const std::string& caption,
               MeshTable& meshes) {
  // Draw the projection of the set, and the slice without the other three coordinates.
  const ForceSet forces = unit_forces(result.wrenches, result.request.limit);
  const std::array<int, 3> coordinates{first, first + 1, first + 2};
  const auto draw = [&](PictureKind kind) {
    return wrench_set_mesh(forces, coordinates, kind, kEdgePieces);
  };
  Json layers = Json::array({axes_layer(), mesh_layer("all wrenches", kShadow, 0.25,
                                                      draw(PictureKind::kProjection), meshes)});
  const WrenchSetMesh slice = draw(PictureKind::kSlice);
  if (result.grasp.quality.force_closure && slice.failed == 0)
    layers.push_back(
        mesh_layer(first == 0 ? "without torque" : "without force", kSlice, 0.75, slice, meshes));
  return with(picture_block(caption, kSlanted, std::move(layers)),
              {{"unit", "N"}, {"link", "wrenches"}});
}

}  // namespace

Json quality_section(const GraspResult& result) {
  return section(
      "quality", "Quality",
      "Epsilon is the largest wrench that the grasp resists in every direction, relative to its "
      "contact forces (the measure of Ferrari and Canny); below zero it is how far the grasp is "
      "from force closure. The true value is certified to lie between the bounds.",
      Json::array({number_table(result), friction_chart(result)}));
}

Json wrench_section(const GraspResult& result, MeshTable& meshes) {
  return section(
      "wrenches", "Wrenches that the contacts can make",
      "Pale: forces (left) and torques over the object's reach (right) of all wrenches within the "
      "limit of forces. Blue: pure forces (left), pure torques (right).",
      Json::array({row_block(Json::array(
          {set_scene(result, 0, "Forces on the object, for unit contact forces.", meshes),
           set_scene(result, 3, "Torques on the object over its reach.", meshes)}))}));
}

}  // namespace thenar
