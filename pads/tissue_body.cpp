#include "pads/tissue_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <Eigen/Geometry>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Returns the 27 nodes of a parent from its eight children, first axis fastest.
std::vector<int> lattice_of(const HexMesh& mesh, const HexCell& parent) {
  std::vector<int> nodes(27);
  for (int child = 0; child < 8; ++child)
    for (int corner = 0; corner < 8; ++corner)
      nodes[lattice_index(child, corner)] =
          mesh.cells()[parent.first_child + child].corners[corner];
  return nodes;
}

}  // namespace

TissueBody::TissueBody(const HexMesh& mesh, HexElement kind, std::vector<Tissue> tissues,
                       const std::vector<bool>& fixed)
    : kind_(kind), tissues_(std::move(tissues)) {
  require(fixed.size() == static_cast<std::size_t>(mesh.nodes()),
          "{} nodes, {} marks of fixed ones", mesh.nodes(), fixed.size());
  // Check the tissues, and store the history of undeformed elements of each.
  for (const Tissue& tissue : tissues_) {
    check_tissue(tissue);
    const auto points = static_cast<std::size_t>(gauss_point_count(kind_));
    undeformed_history_.push_back(
        {std::vector<Voigt>(points, Voigt::Zero()),
         std::vector<Voigt>(points * tissue.relaxation.size(), Voigt::Zero())});
  }
  // Number the unknowns: nodes in use that neither hang nor are fixed.
  free_index_.assign(fixed.size(), -1);
  node_masters_.resize(fixed.size());
  for (int node = 0; node < mesh.nodes(); ++node) {
    rest_positions_.push_back(mesh.place(node));
    if (!mesh.in_use(node)) continue;
    nodes_.push_back(node);
    node_masters_[node] = mesh.masters(node);
    if (!node_masters_[node].empty() || fixed[node]) continue;
    free_index_[node] = static_cast<int>(free_nodes_.size());
    free_nodes_.push_back(node);
  }
  require(!free_nodes_.empty(), "no node of the tissue is free");
  build_elements(mesh);
  build_pattern();
}

void TissueBody::build_elements(const HexMesh& mesh) {
  // Adds an element with its shape and the free masters of its nodes; fixed masters do not move.
  const auto add = [&](std::vector<int> nodes, int region) {
    require(region >= 0 && region < static_cast<int>(tissues_.size()), "region {} has no tissue",
            region);
    Element element;
    element.region = region;
    Matrix3Xd X(3, static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      X.col(a) = mesh.place(nodes[a]);
      require(kind_ != HexElement::kQuadratic || mesh.masters(nodes[a]).empty(),
              "a node of a quadratic mesh hangs");
      element.masters.emplace_back();
      for (const NodeWeight& each : mesh.support(nodes[a]))
        if (free_index(each.node) >= 0)
          element.masters.back().push_back({free_index(each.node), each.weight});
    }
    element.nodes = std::move(nodes);
    element.shape = element_shape(kind_, X);
    elements_.push_back(std::move(element));
  };
  if (kind_ != HexElement::kQuadratic) {
    // Add one element for each active cell.
    for (const int index : mesh.active()) {
      const HexCell& cell = mesh.cells()[index];
      add({cell.corners.begin(), cell.corners.end()}, cell.region);
    }
    return;
  }
  // Add one quadratic element for each parent of eight active cells.
  std::set<int> parents;
  for (const int index : mesh.active()) parents.insert(mesh.cells()[index].parent);
  for (const int index : parents) {
    require(index >= 0, "quadratic elements need cells in eights: refine the mesh once");
    const HexCell& parent = mesh.cells()[index];
    for (int k = 0; k < 8; ++k)
      require(mesh.cells()[parent.first_child + k].first_child < 0,
              "quadratic elements need cells in eights: cell {} has finer children", index);
    add(lattice_of(mesh, parent), parent.region);
  }
}

void TissueBody::build_pattern() {
  // Collect pairs of free nodes that share an element, in the column of the first one.
  std::vector<std::set<int>> below(free_nodes_.size());
  for (const Element& element : elements_) {
    std::set<int> all;
    for (const std::vector<NodeWeight>& masters : element.masters)
      for (const NodeWeight& each : masters) all.insert(each.node);
    for (const int j : all) below[j].insert(all.lower_bound(j), all.end());
  }
  // List the rows of the lower triangle, three columns for each node.
  pattern_.size = unknowns();
  pattern_.starts = {0};
  for (std::size_t j = 0; j < below.size(); ++j) {
    below[j].insert(static_cast<int>(j));
    columns_.emplace_back(below[j].begin(), below[j].end());
    for (int c = 0; c < 3; ++c) {
      for (const int i : columns_.back())
        for (int r = i == static_cast<int>(j) ? c : 0; r < 3; ++r)
          pattern_.rows.push_back(3 * i + r);
      pattern_.starts.push_back(static_cast<int>(pattern_.rows.size()));
    }
  }
  for (Element& element : elements_) list_block_shares(element);
}

void TissueBody::list_block_shares(Element& element) const {
  const auto add = [&](std::size_t a, std::size_t b, const NodeWeight& left,
                       const NodeWeight& right) {
    // Blocks are stored with their row at or below their column.
    const int column = std::min(left.node, right.node), row = std::max(left.node, right.node);
    const bool transposed = left.node < right.node;
    if (a == b && transposed) return;  // the pair in the other order covers it
    const std::vector<int>& list = columns_[column];
    const auto place =
        static_cast<int>(std::lower_bound(list.begin(), list.end(), row) - list.begin());
    element.shares.push_back({static_cast<int>(a), static_cast<int>(b), column, place,
                              left.weight * right.weight, transposed, place == 0 && a != b});
  };
  // Add each pair of nodes of the element by pairs of their masters.
  for (std::size_t b = 0; b < element.masters.size(); ++b)
    for (std::size_t a = 0; a <= b; ++a)
      for (const NodeWeight& right : element.masters[b])
        for (const NodeWeight& left : element.masters[a]) add(a, b, left, right);
}

std::size_t TissueBody::block_entry(int column, int row_index, int r, int c) const {
  // Column 3 j + c has 3 - c rows of the diagonal block, then three of each block below.
  const int start = pattern_.starts[3 * column + c];
  return static_cast<std::size_t>(row_index == 0 ? start + r - c
                                                 : start + (3 - c) + 3 * (row_index - 1) + r);
}

std::size_t TissueBody::diagonal_entry(int free, int r, int c) const {
  return block_entry(free, 0, r, c);
}

void TissueBody::add_block(std::vector<double>& tangent, int row, int column,
                           const Eigen::Matrix3d& block) const {
  // Find the stored block in the lower triangle; its transpose is added if the row comes first.
  const int first = std::min(row, column);
  const std::vector<int>& below = columns_[first];
  const auto found = std::find(below.begin(), below.end(), std::max(row, column));
  const auto place = static_cast<int>(found - below.begin());
  for (int c = 0; c < 3; ++c)
    for (int r = place == 0 ? c : 0; r < 3; ++r)
      tangent[block_entry(first, place, r, c)] += row >= column ? block(r, c) : block(c, r);
}

bool TissueBody::contains(const Vector3d& place, const Matrix3Xd& u) const {
  // Split a cell into six tetrahedra around the diagonal from corner 0 to 7, one for each side of
  // this hexagon.
  static constexpr std::array<int, 7> kAround{1, 3, 2, 6, 4, 5, 1};
  static constexpr std::array<int, 8> kCornersOf27{0, 2, 6, 8, 18, 20, 24, 26};
  // Returns whether the position is on the same side of all four faces.
  const auto in_tetrahedron = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c,
                                  const Vector3d& d) {
    const auto side = [](const Vector3d& x, const Vector3d& y, const Vector3d& z) {
      return x.cross(y).dot(z);
    };
    const Vector3d x = a - place, y = b - place, z = c - place, w = d - place;
    const std::array<double, 4> parts{side(y, w, z), side(x, z, w), side(x, w, y), side(x, y, z)};
    return all_of(parts, [](double part) { return part >= 0; }) ||
           all_of(parts, [](double part) { return part <= 0; });
  };
  return any_of(elements_, [&](const Element& element) {
    // Compute the deformed corners; their box excludes most elements.
    std::array<Vector3d, 8> at;
    Eigen::AlignedBox3d box;
    for (std::size_t k = 0; k < 8; ++k) {
      const auto entry = is_quadratic() ? static_cast<std::size_t>(kCornersOf27[k]) : k;
      const int node = element.nodes[entry];
      at[k] = this->rest_position(node) + u.col(node);
      box.extend(at[k]);
    }
    if (!box.contains(place)) return false;
    for (std::size_t k = 0; k < 6; ++k)
      if (in_tetrahedron(at[0], at[kAround[k]], at[kAround[k + 1]], at[7])) return true;
    return false;
  });
}

bool TissueBody::relaxes() const {
  return any_of(tissues_, [](const Tissue& tissue) { return !tissue.relaxation.empty(); });
}

double TissueBody::max_shear_modulus() const {
  double largest = 0;
  for (const Tissue& tissue : tissues_) largest = std::max(largest, tissue.shear_modulus);
  return largest;
}

double TissueBody::max_pressure_force() const {
  double largest = 0;
  for (const Element& element : elements_) {
    const double volume =
        std::accumulate(element.shape.volume.begin(), element.shape.volume.end(), 0.0);
    largest = std::max(largest, bulk_modulus(tissues_[element.region]) * std::pow(volume, 2.0 / 3));
  }
  return largest;
}

Matrix3Xd TissueBody::node_displacements(const VectorXd& x, const Matrix3Xd& at_fixed) const {
  const auto nodes = static_cast<Eigen::Index>(free_index_.size());
  Matrix3Xd u = at_fixed.cols() == 0 ? Matrix3Xd(Matrix3Xd::Zero(3, nodes)) : at_fixed;
  for (std::size_t i = 0; i < free_nodes_.size(); ++i) u.col(free_nodes_[i]) = x.segment<3>(3 * i);
  // Hanging nodes follow their masters, which do not hang, so any order is valid.
  for (Eigen::Index node = 0; node < nodes; ++node) {
    const std::vector<NodeWeight>& masters = node_masters_[node];
    if (masters.empty()) continue;
    u.col(node).setZero();
    for (const NodeWeight& each : masters) u.col(node) += each.weight * u.col(each.node);
  }
  return u;
}

std::vector<MemoryStep> TissueBody::memory_steps(double h) const {
  return transformed(tissues_,
                     [&](const Tissue& tissue) { return memory_step(tissue.relaxation, h); });
}

Matrix3Xd TissueBody::element_displacements(const Element& element, const Matrix3Xd& u) const {
  Matrix3Xd own(3, static_cast<Eigen::Index>(element.nodes.size()));
  for (std::size_t a = 0; a < element.nodes.size(); ++a) own.col(a) = u.col(element.nodes[a]);
  return own;
}

const ElementHistory& TissueBody::element_history(std::size_t element,
                                                  const TissueHistory& history) const {
  if (!history.empty()) return history[element];
  return undeformed_history_[elements_[element].region];
}

void TissueBody::evaluate(const Matrix3Xd& u, double h, const TissueHistory& history,
                          const TissuePressure& tangent_pressure, ElementRequest request,
                          TissueResponse& out) const {
  require(history.empty() || history.size() == elements_.size(), "{} histories for {} elements",
          history.size(), elements_.size());
  require(tangent_pressure.empty() || tangent_pressure.size() == elements_.size(),
          "{} pressures for {} elements", tangent_pressure.size(), elements_.size());
  // Compute the weights of the step, and reset the requested sums.
  const std::vector<MemoryStep> steps = memory_steps(h);
  out.inverted = false;
  out.energy = 0;
  if (request != ElementRequest::kEnergy) out.force.setZero(unknowns());
  if (request == ElementRequest::kStiffness) out.tangent.assign(pattern_.rows.size(), 0);
  ElementResponse response;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const Element& element = elements_[e];
    element_response(
        {kind_, element.shape, tissues_[element.region], element_displacements(element, u),
         &steps[element.region], &element_history(e, history),
         tangent_pressure.empty() ? nullptr : &tangent_pressure[e]},
        request, response);
    if (response.inverted) {
      out.inverted = true;
      return;
    }
    add_element(element, response, request, out);
  }
}

void TissueBody::add_element(const Element& element, const ElementResponse& response,
                             ElementRequest request, TissueResponse& out) const {
  out.energy += response.energy;
  if (request == ElementRequest::kEnergy) return;
  // Assign the forces on the nodes to their masters.
  for (std::size_t b = 0; b < element.masters.size(); ++b)
    for (const NodeWeight& each : element.masters[b])
      out.force.segment<3>(3 * each.node) += each.weight * response.force.segment<3>(3 * b);
  if (request != ElementRequest::kStiffness) return;
  for (const BlockShare& share : element.shares) {
    // Complete a diagonal block of the element, of which only the upper triangle is computed.
    Eigen::Matrix3d block = response.stiffness.block<3, 3>(3 * share.a, 3 * share.b);
    if (share.a == share.b) block.triangularView<Eigen::StrictlyLower>() = block.transpose();
    if (share.transposed) block.transposeInPlace();
    if (share.symmetric) block += block.transpose().eval();
    for (int c = 0; c < 3; ++c)
      for (int r = share.row_index == 0 ? c : 0; r < 3; ++r)
        out.tangent[block_entry(share.column, share.row_index, r, c)] += share.weight * block(r, c);
  }
}

TissuePressure TissueBody::predict_pressure(const Matrix3Xd& u, const Matrix3Xd& du) const {
  return transformed(elements_, [&](const Element& element) {
    return linear_pressure(
        {kind_, element.shape, tissues_[element.region], element_displacements(element, u)},
        element_displacements(element, du));
  });
}

TissueHistory TissueBody::advance_history(const Matrix3Xd& u, double h,
                                          const TissueHistory& history) const {
  if (!relaxes()) return {};
  const std::vector<MemoryStep> steps = memory_steps(h);
  TissueHistory next;
  ElementResponse response;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const Element& element = elements_[e];
    const MemoryStep& step = steps[element.region];
    // Compute the elastic stress at the end of the step.
    ElementHistory at = element_history(e, history);
    const std::size_t points = at.elastic.size();
    element_response({kind_, element.shape, tissues_[element.region],
                      element_displacements(element, u), &step, &at},
                     ElementRequest::kForce, response);
    require(!response.inverted, "a step cannot end with an element turned inside out");
    // Decay the history terms, and add the change of the elastic stress.
    if (!step.decay.empty()) {
      for (std::size_t i = 0; i < step.decay.size(); ++i)
        for (std::size_t q = 0; q < points; ++q) {
          Voigt& term = at.terms[i * points + q];
          term = step.decay[i] * term + step.change[i] * (response.elastic[q] - at.elastic[q]);
        }
      at.elastic = response.elastic;
    }
    next.push_back(std::move(at));
  }
  return next;
}

VectorXd TissueBody::error_energies(const Matrix3Xd& u) const {
  // Compute the stress at Gauss points, and its mean over the elements around each node of a
  // region.
  using Key = std::pair<int, int>;
  std::map<Key, std::pair<Voigt, double>> smooth;
  const auto points = static_cast<std::size_t>(gauss_point_count(kind_));
  std::vector<Voigt> stress(elements_.size() * points);
  std::vector<double> modulus;  // of the tangent, mean of an element [Pa]
  IsochoricResponse response;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const Element& element = elements_[e];
    const Matrix3Xd own = element_displacements(element, u);
    Voigt mean = Voigt::Zero();
    double volume = 0;
    const Tissue& tissue = tissues_[element.region];
    modulus.push_back(0);
    for (std::size_t q = 0; q < points; ++q) {
      isochoric_response(tissue, element_deformation(element.shape, own, q), true, response);
      modulus.back() += tangent_shear_modulus(tissue, response) / static_cast<double>(points);
      stress[e * points + q] = response.stress;
      mean += element.shape.volume[q] * response.stress;
      volume += element.shape.volume[q];
    }
    // Add the element's mean at its nodes, weighted by its volume.
    for (const int node : element.nodes) {
      auto& [sum, weight] =
          smooth.try_emplace({node, element.region}, Voigt(Voigt::Zero()), 0.0).first->second;
      sum += mean;
      weight += volume;
    }
  }
  // Integrate the energy of the difference between the smooth and the element's stress.
  VectorXd out(static_cast<Eigen::Index>(elements_.size()));
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const Element& element = elements_[e];
    std::vector<Voigt> nodal;
    for (const int node : element.nodes) {
      const auto& [sum, weight] = smooth.at({node, element.region});
      nodal.emplace_back(sum / weight);
    }
    double energy = 0;
    for (std::size_t q = 0; q < points; ++q) {
      Voigt apart = -stress[e * points + q];
      for (std::size_t a = 0; a < nodal.size(); ++a) apart += shape_value(kind_, q, a) * nodal[a];
      // Add the energy density  s : s / (4 mu);  shear components count twice.
      energy += element.shape.volume[q] *
                (apart.head<3>().squaredNorm() + 2 * apart.tail<3>().squaredNorm()) /
                (4 * modulus[e]);
    }
    out[e] = energy;
  }
  return out;
}

Matrix3Xd TissueBody::reactions(const Matrix3Xd& u, double h, const TissueHistory& history) const {
  const std::vector<MemoryStep> steps = memory_steps(h);
  Matrix3Xd out = Matrix3Xd::Zero(3, u.cols());
  ElementResponse response;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const Element& element = elements_[e];
    element_response(
        {kind_, element.shape, tissues_[element.region], element_displacements(element, u),
         &steps[element.region], &element_history(e, history)},
        ElementRequest::kForce, response);
    require(!response.inverted, "an element is turned inside out: it has no reactions");
    // Assign forces on hanging nodes to their masters.
    for (std::size_t a = 0; a < element.nodes.size(); ++a) {
      const Eigen::Vector3d f = response.force.segment<3>(3 * a);
      const std::vector<NodeWeight>& masters = node_masters_[element.nodes[a]];
      if (masters.empty()) out.col(element.nodes[a]) += f;
      for (const NodeWeight& each : masters) out.col(each.node) += each.weight * f;
    }
  }
  return out;
}

Eigen::Matrix3d mean_deformation(const HexCell& cell, const Matrix3Xd& places, const Matrix3Xd& u) {
  Matrix3Xd X(3, 8), moved(3, 8);
  for (Eigen::Index c = 0; c < 8; ++c) {
    const int node = cell.corners[c];
    X.col(c) = places.col(node);
    moved.col(c) = u.col(node);
  }
  const ElementShape shape = element_shape(HexElement::kMeanDilatation, X);
  Eigen::Matrix3d F = Eigen::Matrix3d::Zero();
  for (std::size_t point = 0; point < 8; ++point) F += element_deformation(shape, moved, point) / 8;
  return F;
}

}  // namespace thenar
