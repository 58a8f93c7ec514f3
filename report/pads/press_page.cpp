// The page of a pad that was pressed.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "base/units.h"
#include "report/pads/press_answer.h"
#include "report/picture/color_ramp.h"
#include "report/picture/mesh_table.h"
#include "report/provenance.h"

namespace thenar {
namespace {

using Eigen::Index;

constexpr double kMapSizeRatio = 1.6;  // Size of a map, over that of the patch [1]
constexpr int kBoneRings = 12;         // Rings of the picture of the bone
const char* const kSkinColor = "#e8c4a8";
const char* const kBoneColor = "#ece5d3";
const char* const kObjectColor = "#9aa3ad";
const char* const kEdgeColor = "#5b4a3c";
const char* const kStickColor = "#1b7f5c";
const char* const kSlipColor = "#d9822b";

TriangleMesh triangles_of(const PressedSkin& skin) {
  const std::vector<std::array<int, 4>>& faces = skin.faces;
  TriangleMesh mesh;
  mesh.vertices = skin.places;
  mesh.triangles.resize(3, 2 * static_cast<Index>(faces.size()));
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto& [a, b, c, d] = faces[f];
    mesh.triangles.col(2 * static_cast<Index>(f)) << a, b, c;
    mesh.triangles.col(2 * static_cast<Index>(f) + 1) << a, c, d;
  }
  return mesh;
}

/// Edges of faces, each once, as pairs of places [mm].
Json edges_of(const PressedSkin& skin) {
  std::set<std::pair<int, int>> edges;
  for (const std::array<int, 4>& face : skin.faces)
    for (std::size_t i = 0; i < 4; ++i) edges.insert(std::minmax(face[i], face[(i + 1) % 4]));
  Json positions = Json::array();
  for (const auto& [a, b] : edges)
    for (const int node : {a, b}) positions.push_back(rounded(skin.places.col(node) / kMm, 10));
  return {{"kind", "lines"}, {"positions", std::move(positions)}, {"opacity", 0.35}};
}

/// The bone's surface, which does not move: rings of the chart's disc.
TriangleMesh bone_mesh(const PadShape& shape) {
  // Rings of the disc at the inner end of the chart, which is the bone.
  const PadChart chart(shape);
  constexpr int kRingSides = 48;  // Sides of a ring
  TriangleMesh mesh;
  mesh.vertices.resize(3, 1 + kBoneRings * kRingSides);
  mesh.vertices.col(0) = chart.place({0, 0, 0});
  std::vector<Eigen::Vector3i> triangles;
  // Number the nodes ring by ring, the sides closing on themselves.
  const auto at = [](int ring, int side) {
    return 1 + (ring - 1) * kRingSides + side % kRingSides;
  };
  // Place each node, and join it with those of the ring inside.
  for (int ring = 1; ring <= kBoneRings; ++ring)
    for (int side = 0; side < kRingSides; ++side) {
      const double r = static_cast<double>(ring) / kBoneRings, angle = 2 * kPi * side / kRingSides;
      mesh.vertices.col(at(ring, side)) =
          chart.place({r * std::cos(angle), r * std::sin(angle), 0});
      if (ring == 1) {
        triangles.emplace_back(0, at(1, side), at(1, side + 1));
        continue;
      }
      triangles.emplace_back(at(ring - 1, side), at(ring, side), at(ring, side + 1));
      triangles.emplace_back(at(ring - 1, side), at(ring, side + 1), at(ring - 1, side + 1));
    }
  mesh.triangles.resize(3, static_cast<Index>(triangles.size()));
  for (std::size_t i = 0; i < triangles.size(); ++i)
    mesh.triangles.col(static_cast<Index>(i)) = triangles[i];
  return mesh;
}

/// A mesh item in place, smooth.
Json smooth_item(const TriangleMesh& mesh, std::vector<MeshColor> colors, MeshTable& meshes) {
  return mesh_item(meshes.add(mesh, {-1, std::move(colors)}), {});
}

double largest_pressure(const PressResult& pressed) {
  return pressed.skin.pressure.size() > 0 ? pressed.skin.pressure.maxCoeff() : 0;
}

Json pressure_scale(const PressResult& pressed) {
  return {
      {"label", "pressure [kPa]"}, {"low", 0}, {"high", largest_pressure(pressed) / kKilopascal}};
}

/// The pad with its bone below the object, palm up, seen from the side and a little from above.
Json pad_scene(const PressResult& pressed, MeshTable& meshes) {
  const PressedSkin& skin = pressed.skin;
  // Colour the skin by pressure; bone, element edges and object can be switched.
  const Json pad = smooth_item(
      triangles_of(skin),
      ramp_colors(skin.pressure, largest_pressure(pressed), color_of_hex(kSkinColor)), meshes);
  const Json bone = smooth_item(bone_mesh(pressed.pad.model.shape), {}, meshes);
  const Json object =
      with(mesh_item(meshes.add(pressed.object.picture, {kBodyCrease, {}}), pressed.X_PO),
           {{"opacity", 0.18}});
  Json layers = Json::array(
      {layer("skin", kSkinColor, Json::array({pad})),
       layer("bone", kBoneColor, Json::array({bone})),
       with(layer("elements", kEdgeColor, Json::array({edges_of(skin)})), {{"visible", false}}),
       with(layer(pressed.object.name, kObjectColor, Json::array({object})), {{"fit", false}})});
  return {{"type", "scene"},
          {"caption",
           "The deformed pad, palm up, and what presses on it; x is distal, y radial, z palmar"},
          {"up", {0, 0, 1}},
          {"axes", {"distal", "radial", "palmar"}},
          {"view", {0.5, -1, 0.7}},
          {"color_scale", pressure_scale(pressed)},
          {"layers", std::move(layers)}};
}

/// The part of the skin near the patch; all of it where there is none.
PressedSkin near_patch(const PressedSkin& skin) {
  // Bound the patch, and keep the nodes within a multiple of its size.
  Eigen::AlignedBox3d patch;
  for (Index k = 0; k < skin.places.cols(); ++k)
    if (nth(skin.contact, k) != SkinContact::kFree)
      patch.extend(Eigen::Vector3d(skin.places.col(k)));
  if (patch.isEmpty()) return skin;
  const double reach = 0.5 * kMapSizeRatio * patch.diagonal().norm();
  // Faces with a corner in reach, and the nodes that they have.
  PressedSkin part;
  for (const std::array<int, 4>& face : skin.faces)
    if (std::any_of(face.begin(), face.end(), [&](int node) {
          return (skin.places.col(node) - patch.center()).norm() < reach;
        }))
      part.faces.push_back(face);
  const std::vector<int> nodes = renumber(part.faces, static_cast<int>(skin.places.cols()));
  part.places = skin.places(Eigen::all, nodes);
  part.at_rest = skin.at_rest(Eigen::all, nodes);
  part.pressure = skin.pressure(nodes);
  part.normal = skin.normal(nodes);
  for (const int node : nodes) part.contact.push_back(nth(skin.contact, node));
  return part;
}

std::vector<MeshColor> stick_colors(const PressedSkin& skin) {
  return transformed(skin.contact, [](SkinContact contact) {
    return color_of_hex(contact == SkinContact::kSticks  ? kStickColor
                        : contact == SkinContact::kSlips ? kSlipColor
                                                         : kSkinColor);
  });
}

/// Two maps of the patch from where the object comes, distal up.
Json patch_maps(const PressResult& pressed, MeshTable& meshes) {
  // Both maps turn together, and look the way the object came.
  const PressedSkin skin = near_patch(pressed.skin);
  const TriangleMesh mesh = triangles_of(skin);
  const auto map = [&](const std::string& caption, std::vector<MeshColor> colors) {
    Json layers = Json::array(
        {layer("skin", kSkinColor, Json::array({smooth_item(mesh, std::move(colors), meshes)})),
         layer("elements", kEdgeColor, Json::array({edges_of(skin)}))});
    return Json{{"type", "scene"},
                {"caption", caption},
                {"up", {1, 0, 0}},
                {"axes", {"distal", "radial", "palmar"}},
                {"view", numbers3(-pressed.touch.along)},
                {"link", "patch"},
                {"layers", std::move(layers)}};
  };
  Json pressure =
      map("Pressure on the skin, seen from the object, distal up",
          ramp_colors(skin.pressure, largest_pressure(pressed), color_of_hex(kSkinColor)));
  pressure["color_scale"] = pressure_scale(pressed);
  return row_block(
      Json::array({std::move(pressure),
                   map("Where it sticks (green) and slips (orange)", stick_colors(skin))}));
}

/// A curve over the instants of some phases.
template <typename X, typename Y>
Json press_curve(const PressResult& pressed, const std::string& name,
                 const std::vector<PressPhase>& phases, const X& x, const Y& y) {
  Json xs = Json::array(), ys = Json::array();
  for (const PressInstant& now : pressed.instants)
    if (contains(phases, now.phase)) {
      xs.push_back(x(now));
      ys.push_back(y(now));
    }
  return curve_json(name, std::move(xs), std::move(ys), "both");
}

double depth_of(const PressInstant& now) { return now.depth / kMm; }
double force_of(const PressInstant& now) { return now.force; }
double area_of(const PressInstant& now) { return now.area / kSquareMm; }

Json curve_section(const PressResult& pressed) {
  // Force over depth, then area, pressure and stick over force.
  const std::vector<PressPhase> way{PressPhase::kWay};
  const std::string name = pressed.pad.spec.name;
  Json force = lines_block("Force over depth", "depth [mm]", "force [N]",
                           {press_curve(pressed, name, way, depth_of, force_of)});
  Json area = lines_block("Contact area over force", "force [N]", "area [mm2]",
                          {press_curve(pressed, name, way, force_of, area_of)});
  Json pressure = lines_block(
      "Pressure over force", "force [N]", "pressure [kPa]",
      {press_curve(pressed, "largest", way, force_of,
                   [](const PressInstant& now) { return now.pressure / kKilopascal; }),
       press_curve(pressed, "mean", way, force_of, [](const PressInstant& now) {
         return now.area > 0 ? number_or_null(now.force / now.area / kKilopascal) : Json();
       })});
  Json stick =
      with(lines_block("Share of the normal force on skin that sticks", "force [N]", "share [1]",
                       {press_curve(pressed, name, way, force_of,
                                    [](const PressInstant& now) { return now.stick; })}),
           {{"reference_lines", Json::array({{{"value", 0}}})}});  // the axis begins there
  return section("curves", "Force, depth and area", "",
                 Json::array({row_block({std::move(force), std::move(area)}),
                              row_block({std::move(pressure), std::move(stick)}),
                              table_block("All instants", table_of(pressed))}));
}

/// Force over time; while the object stands still also over the logarithm of time.
Json relaxation_section(const PressResult& pressed) {
  // Chart the whole press over time, and the hold alone on a logarithmic axis.
  const std::vector<PressPhase> both{PressPhase::kWay, PressPhase::kHold};
  const auto time = [](const PressInstant& now) { return now.time; };
  Json charts = Json::array(
      {lines_block("Force over time from the touch on", "time [s]", "force [N]",
                   {press_curve(pressed, pressed.pad.spec.name, both, time, force_of)})});
  const PressInstant* end = pressed.end_of_motion();
  const double began = end != nullptr ? end->time : 0;
  if (pressed.request.hold > 0) {
    charts.push_back(
        with(lines_block("Force while the object is held still", "time since it stopped [s]",
                         "force [N]",
                         {press_curve(
                             pressed, pressed.pad.spec.name, {PressPhase::kHold},
                             [&](const PressInstant& now) { return now.time - began; }, force_of)}),
             {{"log_x", true}}));
  }
  return section("relaxation", "Relaxation", "", Json::array({row_block(std::move(charts))}));
}

Json rung_section(const PressResult& pressed) {
  // One series for each law, for each element on even meshes, and for meshes that refine.
  std::map<std::string, Json> series;
  for (const PressRung& rung : pressed.rungs) {
    if (!rung.message.empty() || rung.finest || !(rung.error > 0)) continue;
    const std::string name = rung.reduced   ? rung.element
                             : rung.refined ? rung.element + ", refined"
                                            : rung.element + ", even";
    Json& curve =
        series.emplace(name, curve_json(name, Json::array(), Json::array(), "both")).first->second;
    curve["x"].push_back(rung.cpu);
    curve["y"].push_back(rung.error);
    curve["labels"].push_back(rung.reduced ? rung.element : rung.mesh);
  }
  // Both axes are logarithmic, because laws and meshes differ by orders of magnitude.
  Json blocks = Json::array(), list = Json::array();
  for (auto& [name, curve] : series) list.push_back(std::move(curve));
  if (!list.empty()) {
    blocks.push_back(with(lines_block("Error of the force against the finest over processor time",
                                      "processor time [s]", "relative error [1]", std::move(list)),
                          {{"log_x", true}, {"log_y", true}}));
  }
  blocks.push_back(table_block("Laws, elements and meshes", rung_table(pressed)));
  return section(
      "rungs", "Rungs",
      "The same depth at once, in one step and without friction, by each reduced law and "
      "each kind of element and mesh; torsion is the largest torque per normal force, "
      "with the friction above. Errors are against the finest, which has an error of its own: "
      "what is below a per cent tells little.",
      std::move(blocks));
}

}  // namespace

Json page_of(const PressResult& pressed) {
  // The deformed pad, if it was solved at all.
  MeshTable meshes;
  Json blocks = Json::array({refusal_banner(
      refusal_of(pressed), pressed.outcome.warnings, "The press ended early",
      pressed.outcome.stopped() ? "The press was stopped" : "All steps were solved")});
  if (pressed.skin.places.cols() > 0) {
    blocks.push_back(pad_scene(pressed, meshes));
    blocks.push_back(patch_maps(pressed, meshes));
  }
  Json sections =
      Json::array({section("pad", "The pad", pressed.pad.spec.description, std::move(blocks))});
  // Curves along the way, relaxation and rungs, as far as there are some.
  if (!pressed.instants.empty()) {
    sections.push_back(curve_section(pressed));
    if (pressed.relaxes()) sections.push_back(relaxation_section(pressed));
  }
  if (!pressed.rungs.empty()) sections.push_back(rung_section(pressed));
  return {{"title", title_of(pressed)},
          {"subtitle", conditions_of(pressed)},
          {"provenance", provenance_json(files_of(pressed))},
          {"meshes", meshes.json()},
          {"sections", std::move(sections)}};
}

}  // namespace thenar
