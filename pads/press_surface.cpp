#include "pads/press_surface.h"

#include "pads/pad_press.h"
#include "pads/press_state.h"

namespace thenar {
namespace {

/// Orders the corners of faces counterclockwise as seen from outside, away from the pad's origin.
void orient_outward(const Eigen::Matrix3Xd& places, std::vector<std::array<int, 4>>& faces) {
  for (std::array<int, 4>& face : faces) {
    const Eigen::Vector3d a = places.col(face[0]), b = places.col(face[1]), c = places.col(face[2]),
                          d = places.col(face[3]);
    if ((c - a).cross(d - b).dot(a + b + c + d) < 0) std::swap(face[1], face[3]);
  }
}

/// Contact quantities of the mesh's nodes, each (nodes of the mesh).
struct MeshContact {
  Eigen::VectorXd area;              // area of the deformed skin assigned to the node [m^2]
  Eigen::VectorXd normal;            // normal force [N]
  std::vector<SkinContact> contact;  // contact states of nodes that do not hang
};

/// Sets the normal forces and contact states of the nodes that may touch.
void set_contact(const PadPress& press, double friction, MeshContact& out) {
  const PressState& state = press.state();
  out.normal = Eigen::VectorXd::Zero(press.mesh().nodes());
  out.contact.assign(static_cast<std::size_t>(press.mesh().nodes()), SkinContact::kFree);
  for (std::size_t k = 0; k < press.surface().nodes.size(); ++k) {
    const int node = mesh_node(press.body(), press.surface(), k);
    out.normal[node] = state.normal_force[k];
    if (state.normal_force[k] <= 0) continue;
    out.contact[node] =
        node_sticks(state, k, friction) ? SkinContact::kSticks : SkinContact::kSlips;
  }
}

/// Sets the pressure and contact state of a skin node. A hanging node has the mean pressure of its
/// masters, and touches if most of them do.
void set_skin_node(const HexMesh& mesh, const MeshContact& mesh_contact, int node, Eigen::Index k,
                   PressedSkin& skin) {
  skin.normal[k] = mesh_contact.normal[node];
  skin.pressure[k] = 0;
  double touching = 0, sticking = 0;
  // Average the pressures of the masters, and sum the weights of those that touch.
  for (const NodeWeight& each : mesh.support(node)) {
    if (mesh_contact.area[each.node] > 0)
      skin.pressure[k] +=
          each.weight * (mesh_contact.normal[each.node] / mesh_contact.area[each.node]);
    const SkinContact contact = mesh_contact.contact[each.node];
    touching += contact != SkinContact::kFree ? each.weight : 0;
    sticking += contact == SkinContact::kSticks ? each.weight : 0;
  }
  skin.contact.push_back(touching <= 0.5            ? SkinContact::kFree
                         : 2 * sticking >= touching ? SkinContact::kSticks
                                                    : SkinContact::kSlips);
}

}  // namespace

std::vector<int> renumber(std::vector<std::array<int, 4>>& faces, int nodes) {
  std::vector<int> old, place(static_cast<std::size_t>(nodes), -1);
  for (std::array<int, 4>& face : faces)
    for (int& node : face) {
      int& known = place[node];
      if (known < 0) {
        known = static_cast<int>(old.size());
        old.push_back(node);
      }
      node = known;
    }
  return old;
}

PressedSkin pressed_skin(const PadPress& press, double friction) {
  const HexMesh& mesh = press.mesh();
  const Eigen::Matrix3Xd at_rest = rest_positions(mesh);
  const Eigen::Matrix3Xd at = at_rest + press.body().node_displacements(press.state().x, {});
  // Collect the faces of the skin, with areas and forces of the mesh's nodes.
  PressedSkin skin;
  const std::vector<HexFace> faces = marked_faces(mesh, skin_nodes(mesh));
  for (const HexFace& face : faces)  // from two rows to an order around the face
    skin.faces.push_back({face.nodes[0], face.nodes[1], face.nodes[3], face.nodes[2]});
  orient_outward(at_rest, skin.faces);
  MeshContact mesh_contact;
  mesh_contact.area = node_areas(mesh, faces, at);
  set_contact(press, friction, mesh_contact);
  // Keep the nodes of the skin, in the order in which the faces list them.
  const std::vector<int> nodes = renumber(skin.faces, mesh.nodes());
  const auto count = static_cast<Eigen::Index>(nodes.size());
  skin.places.resize(3, count);
  skin.at_rest.resize(3, count);
  skin.pressure.resize(count);
  skin.normal.resize(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const int node = nodes[k];
    skin.places.col(k) = at.col(node);
    skin.at_rest.col(k) = at_rest.col(node);
    set_skin_node(mesh, mesh_contact, node, k, skin);
  }
  return skin;
}

}  // namespace thenar
