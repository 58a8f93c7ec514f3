#include "pads/carry_press.h"

#include <algorithm>

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Returns the nodes of a cell and of its children, each once.
std::vector<int> nodes_within(const HexMesh& mesh, const HexCell& cell) {
  std::vector<int> out(cell.corners.begin(), cell.corners.end());
  for (int child = 0; cell.first_child >= 0 && child < 8; ++child) {
    const HexCell& part = mesh.cells()[cell.first_child + child];
    out.insert(out.end(), part.corners.begin(), part.corners.end());
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// Returns the history of an element that is an octant of an old one (-1: the old one itself).
/// Gauss points are ordered as corners: those of a child all take the history of its octant.
ElementHistory child_history(const ElementHistory& old, int octant) {
  ElementHistory history = old;
  if (octant < 0) return history;
  for (std::vector<Voigt>* list : {&history.elastic, &history.terms})
    for (std::size_t first = 0; first < list->size(); first += 8)
      std::fill_n(list->begin() + static_cast<std::ptrdiff_t>(first), 8,
                  Voigt((*list)[first + static_cast<std::size_t>(octant)]));
  return history;
}

}  // namespace

PressTransfer::PressTransfer(const HexMesh& mesh, std::unique_ptr<TissueBody> body,
                             ContactSurface surface)
    : body_(std::move(body)),
      surface_(std::move(surface)),
      active_(mesh.active()),
      rest_positions_(rest_positions(mesh)) {}

std::vector<PressTransfer::Origin> PressTransfer::element_origins(const HexMesh& mesh) const {
  std::vector<Origin> out;
  for (const int index : mesh.active()) {
    // Find the old element that the cell is or was split from, and its octant there.
    int cell = index, octant = -1;
    auto from = std::lower_bound(active_.begin(), active_.end(), cell);
    while (from == active_.end() || *from != cell) {
      const HexCell& part = mesh.cells()[cell];
      octant = cell - mesh.cells()[part.parent].first_child;
      cell = part.parent;
      from = std::lower_bound(active_.begin(), active_.end(), cell);
    }
    out.push_back({static_cast<std::size_t>(from - active_.begin()), octant});
  }
  return out;
}

std::vector<Matrix3d> PressTransfer::node_gradients(const HexMesh& mesh, const Matrix3Xd& u) const {
  const auto nodes = static_cast<std::size_t>(mesh.nodes());
  std::vector<Matrix3d> sum(nodes, Matrix3d::Zero());
  std::vector<int> cells(nodes, 0);
  // Average the gradients of the old cells around each node.
  for (const int index : active_) {
    const HexCell& cell = mesh.cells()[index];
    const Matrix3d gradient = mean_deformation(cell, rest_positions_, u) - Matrix3d::Identity();
    for (const int node : nodes_within(mesh, cell)) {
      sum[node] += gradient;
      ++cells[node];
    }
  }
  for (std::size_t k = 0; k < nodes; ++k) sum[k] /= std::max(1, cells[k]);
  return sum;
}

Matrix3Xd PressTransfer::transferred_displacements(const HexMesh& mesh,
                                                   const PressState& old) const {
  Matrix3Xd u = body_->node_displacements(old.x, {}), from = rest_positions_;
  const std::vector<Matrix3d> gradients = node_gradients(mesh, u);
  // Start new nodes at the means of the nodes that they were created from, which precede them.
  const Index old_nodes = u.cols();
  u.conservativeResize(3, mesh.nodes());
  from.conservativeResize(3, mesh.nodes());
  for (Index node = old_nodes; node < u.cols(); ++node) {
    u.col(node).setZero();
    from.col(node).setZero();
    for (const NodeWeight& each : mesh.made_from(static_cast<int>(node))) {
      u.col(node) += each.weight * u.col(each.node);
      from.col(node) += each.weight * from.col(each.node);
    }
  }
  // Add the offsets from these means, mapped by the deformation.
  for (Index node = 0; node < u.cols(); ++node)
    u.col(node) += gradients[node] * (mesh.place(static_cast<int>(node)) - from.col(node));
  return u;
}

PressTransfer::SkinFields PressTransfer::transferred_fields(const HexMesh& mesh,
                                                            const PressState& old) const {
  const auto nodes = static_cast<std::size_t>(mesh.nodes());
  SkinFields out{std::vector<double>(nodes, 0), std::vector<Vector3d>(nodes, Vector3d::Zero()),
                 std::vector<std::optional<Vector3d>>(nodes)};
  // Copy pressure, friction and anchors of the old surface's nodes.
  for (std::size_t k = 0; k < surface_.nodes.size(); ++k) {
    const auto node = static_cast<std::size_t>(mesh_node(*body_, surface_, k));
    out.pressure[node] = old.normal_force[k] / surface_.area[k];
    out.traction[node] = old.friction_force.col(k) / surface_.area[k];
    out.anchor[node] = old.anchor.col(k);
  }
  // Give new nodes the means of the nodes that they were created from.
  for (auto node = static_cast<std::size_t>(rest_positions_.cols()); node < nodes; ++node)
    for (const NodeWeight& each : mesh.made_from(static_cast<int>(node))) {
      out.pressure[node] += each.weight * out.pressure[each.node];
      out.traction[node] += each.weight * out.traction[each.node];
    }
  return out;
}

PressState PressTransfer::transfer_state(const PressState& old, const HexMesh& mesh,
                                         const TissueBody& body,
                                         const ContactSurface& surface) const {
  // Keep the object and the springs.
  PressState out;
  out.X_PO = old.X_PO;
  out.push = old.push;
  out.uses_skin_springs = old.uses_skin_springs;
  out.spring_energy = old.spring_energy;
  // Transfer the displacements to the new body's free nodes.
  const Matrix3Xd u = transferred_displacements(mesh, old);
  out.x.resize(body.unknowns());
  for (std::size_t i = 0; i < body.free_nodes().size(); ++i)
    out.x.segment<3>(3 * i) = u.col(body.free_nodes()[i]);
  // Compute the forces on nodes from the transferred tractions and the new areas.
  const auto count = static_cast<Index>(surface.nodes.size());
  out.normal_force.resize(count);
  out.friction_force.resize(3, count);
  out.anchor.resize(3, count);
  const SkinFields fields = transferred_fields(mesh, old);
  const Pose<double> X_OP = old.X_PO.inverse();
  for (Index k = 0; k < count; ++k) {
    const auto node = static_cast<std::size_t>(mesh_node(body, surface, k));
    out.normal_force[k] = surface.area[k] * fields.pressure[node];
    out.friction_force.col(k) = surface.area[k] * fields.traction[node];
    const Vector3d here = surface.rest_positions.col(k) + out.x.segment<3>(3 * surface.nodes[k]);
    out.anchor.col(k) = fields.anchor[node].value_or(X_OP * here);
  }
  // Take pressure and history from the old elements, because the transferred displacements alone do
  // not preserve volume at new nodes of a curved skin.
  for (const Origin& from : element_origins(mesh)) {
    if (!old.pressure.empty()) out.pressure.push_back(old.pressure[from.element]);
    if (!old.history.empty())
      out.history.push_back(child_history(old.history[from.element], from.octant));
  }
  return out;
}

}  // namespace thenar
