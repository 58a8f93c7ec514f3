#include "pads/press_surface.h"

#include <algorithm>

namespace thenar {
namespace {

constexpr double kSlipping = 1e-6;  // of the cone, within which a node slips [1]

/// Corners of the faces of active cells that lie on the skin, in order around each.
std::vector<std::array<int, 4>> skin_faces(const HexMesh& mesh) {
  std::vector<std::array<int, 4>> faces;
  for (const int index : mesh.active())
    for (const std::array<int, 4>& face : hex_faces()) {
      std::array<int, 4> nodes{};
      for (std::size_t i = 0; i < 4; ++i)
        nodes[i] = mesh.cells()[static_cast<std::size_t>(index)]
                       .corners[static_cast<std::size_t>(face[i])];
      if (!std::all_of(nodes.begin(), nodes.end(),
                       [&](int node) { return PadChart::on_skin(mesh.chart_point(node)); }))
        continue;
      std::swap(nodes[2], nodes[3]);  // two rows become a round
      faces.push_back(nodes);
    }
  return faces;
}

/// Turns faces whose corners do not go counterclockwise seen from outside, which is away from the
/// pad's origin.
void turn_outward(const Eigen::Matrix3Xd& places, std::vector<std::array<int, 4>>& faces) {
  for (std::array<int, 4>& face : faces) {
    const Eigen::Vector3d a = places.col(face[0]), b = places.col(face[1]), c = places.col(face[2]),
                          d = places.col(face[3]);
    if ((c - a).cross(d - b).dot(a + b + c + d) < 0) std::swap(face[1], face[3]);
  }
}

SkinContact contact_of(double normal, double shear, double friction) {
  if (normal <= 0) return SkinContact::kFree;
  return shear < (1 - kSlipping) * friction * normal ? SkinContact::kSticks : SkinContact::kSlips;
}

/// What nodes of the mesh have (nodes of the mesh).
struct MeshContact {
  Eigen::VectorXd area;              // share of the deformed skin [m^2]
  Eigen::VectorXd normal;            // force [N]
  std::vector<SkinContact> contact;  // of nodes that do not hang
};

/// A quarter of each face for each corner; shares of hanging nodes go to their masters.
/// @param at  of all nodes, deformed [m] (3, nodes of the mesh)
Eigen::VectorXd deformed_shares(const HexMesh& mesh, const std::vector<std::array<int, 4>>& faces,
                                const Eigen::Matrix3Xd& at) {
  Eigen::VectorXd area = Eigen::VectorXd::Zero(mesh.nodes());
  for (const std::array<int, 4>& face : faces) {
    const Eigen::Vector3d one = at.col(face[2]) - at.col(face[0]);
    const Eigen::Vector3d other = at.col(face[3]) - at.col(face[1]);
    const double share = 0.125 * one.cross(other).norm();
    for (const int node : face) {
      if (mesh.masters(node).empty()) area[node] += share;
      for (const NodeWeight& each : mesh.masters(node)) area[each.node] += share * each.weight;
    }
  }
  return area;
}

/// Forces of the nodes that may touch.
void add_forces(const PadPress& press, double friction, MeshContact& out) {
  const PressState& state = press.state();
  out.normal = Eigen::VectorXd::Zero(press.mesh().nodes());
  out.contact.assign(static_cast<std::size_t>(press.mesh().nodes()), SkinContact::kFree);
  for (std::size_t k = 0; k < press.surface().nodes.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const int node = press.body().free_nodes()[static_cast<std::size_t>(press.surface().nodes[k])];
    out.normal[node] = state.normal[column];
    out.contact[static_cast<std::size_t>(node)] =
        contact_of(state.normal[column], state.shear.col(column).norm(), friction);
  }
}

/// Appends a node: a hanging one has the mean pressure of its masters, and touches where most do.
void add_node(const HexMesh& mesh, const MeshContact& found, int node, Eigen::Index k,
              PressedSkin& skin) {
  const auto pressure_of = [&](int n) {
    return found.area[n] > 0 ? found.normal[n] / found.area[n] : 0.0;
  };
  skin.pressure[k] = pressure_of(node);
  skin.normal[k] = found.normal[node];
  skin.contact.push_back(found.contact[static_cast<std::size_t>(node)]);
  if (mesh.masters(node).empty()) return;
  skin.pressure[k] = 0;
  double touching = 0, sticking = 0;
  for (const NodeWeight& each : mesh.masters(node)) {
    skin.pressure[k] += each.weight * pressure_of(each.node);
    const SkinContact of_master = found.contact[static_cast<std::size_t>(each.node)];
    touching += of_master != SkinContact::kFree ? each.weight : 0;
    sticking += of_master == SkinContact::kSticks ? each.weight : 0;
  }
  if (touching > 0.5)
    skin.contact.back() = 2 * sticking >= touching ? SkinContact::kSticks : SkinContact::kSlips;
}

}  // namespace

PressedSkin pressed_skin(const PadPress& press, double friction) {
  const HexMesh& mesh = press.mesh();
  Eigen::Matrix3Xd at_rest(3, mesh.nodes());
  for (int node = 0; node < mesh.nodes(); ++node) at_rest.col(node) = mesh.place(node);
  const Eigen::Matrix3Xd at = at_rest + press.body().spread(press.state().x, {});
  // Faces and what their nodes have, by nodes of the mesh.
  PressedSkin skin;
  skin.faces = skin_faces(mesh);
  turn_outward(at_rest, skin.faces);
  MeshContact found;
  found.area = deformed_shares(mesh, skin.faces, at);
  add_forces(press, friction, found);
  // Nodes of the skin alone, in the order in which faces name them.
  std::vector<int> nodes, place(static_cast<std::size_t>(mesh.nodes()), -1);
  for (std::array<int, 4>& face : skin.faces)
    for (int& node : face) {
      int& known = place[static_cast<std::size_t>(node)];
      if (known < 0) {
        known = static_cast<int>(nodes.size());
        nodes.push_back(node);
      }
      node = known;
    }
  const auto count = static_cast<Eigen::Index>(nodes.size());
  skin.places.resize(3, count);
  skin.at_rest.resize(3, count);
  skin.pressure.resize(count);
  skin.normal.resize(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const int node = nodes[static_cast<std::size_t>(k)];
    skin.places.col(k) = at.col(node);
    skin.at_rest.col(k) = at_rest.col(node);
    add_node(mesh, found, node, k, skin);
  }
  return skin;
}

}  // namespace thenar
