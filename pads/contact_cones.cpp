#include "pads/contact_cones.h"

#include <Eigen/LU>

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Depth above which an open node joins the problem [m]
constexpr double kJoinDepth = 1e-11;
constexpr int kMaxRounds = 20;  // solutions, each with the nodes that joined after the last
// Regularization added to the diagonal of W, over its largest entry [1]
constexpr double kAddedCompliance = 1e-12;

/// Returns two unit vectors tangential to a unit normal (3, 2).
Eigen::Matrix<double, 3, 2> tangents_of(const Vector3d& n) {
  Eigen::Matrix<double, 3, 2> out;
  Index least = 0;
  (void)n.cwiseAbs().minCoeff(&least);
  out.col(0) = n.cross(Vector3d::Unit(least)).normalized();
  out.col(1) = n.cross(out.col(0));
  return out;
}

/// Converts forces on surface nodes to forces on the body's free nodes [N] (3 free nodes).
VectorXd body_forces(const ContactSurface& surface, const VectorXd& forces, Index unknowns) {
  VectorXd out = VectorXd::Zero(unknowns);
  for (std::size_t k = 0; k < surface.nodes.size(); ++k)
    out.segment<3>(3 * surface.nodes[k]) = forces.segment<3>(3 * k);
  return out;
}

/// Returns the motion of the surface nodes [m] (3, nodes).
Matrix3Xd surface_motion(const ContactSurface& surface, const VectorXd& x) {
  Matrix3Xd moved(3, static_cast<Index>(surface.nodes.size()));
  for (Index k = 0; k < moved.cols(); ++k) moved.col(k) = x.segment<3>(3 * surface.nodes[k]);
  return moved;
}

/// Sparse rows of a matrix (rows, 3 nodes), as blocks (1, 3).
using Rows = std::vector<MeanGaps::Gradient>;

/// Returns  W = J A^-1 F'  for gradients J and directions F of forces (rows of J, rows of F).
MatrixXd compliance(CondensedBody& body, const ContactSurface& surface, const Rows& J,
                    const Rows& F, Index rows) {
  const auto nodes = static_cast<Index>(surface.nodes.size());
  // Condense the body to the nodes that the forces F load.
  std::vector<char> is_loaded(surface.nodes.size(), 0);
  for (const MeanGaps::Gradient& each : F) is_loaded[each.node] = 1;
  std::vector<int> loaded;
  for (int k = 0; k < nodes; ++k)
    if (is_loaded[k] != 0) loaded.push_back(k);
  body.condense(surface, loaded);
  // Compute the displacements under each row of F, and project them on the rows of J.
  MatrixXd response = MatrixXd::Zero(3 * nodes, rows);
  for (const MeanGaps::Gradient& each : F)
    response.col(each.row).noalias() += body.unit_response(each.node) * each.value;
  MatrixXd W = MatrixXd::Zero(rows, rows);
  for (const MeanGaps::Gradient& each : J)
    W.row(each.row).noalias() += each.value.transpose() * response.middleRows<3>(3 * each.node);
  return W;
}

/// Converts rows to a dense matrix (rows, 3 nodes).
MatrixXd to_dense(const Rows& list, Index rows, Index nodes) {
  MatrixXd out = MatrixXd::Zero(rows, 3 * nodes);
  for (const MeanGaps::Gradient& each : list)
    out.block<1, 3>(each.row, 3 * each.node) += each.value.transpose();
  return out;
}

}  // namespace

bool CondensedBody::factor(const std::vector<double>& values) {
  tangent_ = values;
  column_.clear();
  if (!factor_) factor_.emplace(pattern_);
  has_factor_ = factor_->factor(values);
  return has_factor_;
}

VectorXd CondensedBody::solve(const VectorXd& force) const { return factor_->solve(force); }

void CondensedBody::condense(const ContactSurface& surface, const std::vector<int>& nodes) {
  if (column_.empty()) {
    column_.assign(surface.nodes.size(), -1);
    unit_responses_.resize(3 * static_cast<Index>(surface.nodes.size()), 0);
  }
  // List the nodes whose responses are not known.
  std::vector<int> missing;
  for (const int node : nodes)
    if (column_[node] < 0) missing.push_back(node);
  if (missing.empty()) return;
  // Solve for unit forces on all of them at once.
  const Index before = unit_responses_.cols(), count = 3 * static_cast<Index>(missing.size());
  MatrixXd unit = MatrixXd::Zero(pattern_.size, count);
  for (std::size_t i = 0; i < missing.size(); ++i) {
    const auto node = static_cast<std::size_t>(missing[i]);
    const auto column = static_cast<Index>(3 * i);
    unit.block<3, 3>(3 * surface.nodes[node], column).setIdentity();
    column_[node] = static_cast<int>((before + column) / 3);
  }
  const MatrixXd response = factor_->solve(unit);
  // Append the displacements of the surface nodes to the known ones.
  unit_responses_.conservativeResize(Eigen::NoChange, before + count);
  for (std::size_t k = 0; k < surface.nodes.size(); ++k)
    unit_responses_.block(static_cast<Index>(3 * k), before, 3, count) =
        response.middleRows<3>(3 * surface.nodes[k]);
}

bool ContactCones::factor(const std::vector<double>& values, const Matrix3Xd& springs) {
  springs_ = springs;
  return body_.factor(values);
}

void ContactCones::build_problem(const ContactSurface& surface, const Iterate& iterate,
                                 const Matrix3Xd& moved, const VectorXd& gaps,
                                 const std::vector<int>& touching) {
  // Size the problem: a node has a row for its gap and, with friction, two for its slip.
  const bool slips = iterate.friction > 0;
  const Index per_node = slips ? 3 : 1;
  const auto rows = per_node * static_cast<Index>(touching.size());
  problem_.b.resize(rows);
  initial_forces_.resize(rows);
  problem_.blocks.assign(touching.size(),
                         slips ? coulomb_block(iterate.friction) : unilateral_block());
  // Fill the rows of gaps, which depend on neighbouring nodes, and of slips.
  Rows list = iterate.gaps.gap_gradients(touching);
  for (MeanGaps::Gradient& each : list) each.row *= static_cast<int>(per_node);
  for (std::size_t i = 0; i < touching.size(); ++i) {
    const int k = touching[i];
    const auto row = per_node * static_cast<Index>(i);
    problem_.b[row] = gaps[k];
    initial_forces_[row] = iterate.normal_force[k];
    if (!slips) continue;
    const auto tangents = tangents_of(iterate.gaps.normal(static_cast<std::size_t>(k)));
    for (int t = 0; t < 2; ++t) list.push_back({static_cast<int>(row) + 1 + t, k, tangents.col(t)});
    problem_.b.segment<2>(row + 1) =
        tangents.transpose() * Vector3d(iterate.slip.col(k) + moved.col(k));
    initial_forces_.segment<2>(row + 1) =
        tangents.transpose() * Vector3d(iterate.friction_force.col(k));
  }
  // Compute the Delassus matrix  W = J A^-1 J'  and remove the asymmetry of rounding.
  J_ = to_dense(list, rows, moved.cols());
  const MatrixXd W = compliance(body_, surface, list, list, rows);
  problem_.W = 0.5 * (W + W.transpose());
}

ContactCones::Equilibrium ContactCones::solve(const ContactSurface& surface,
                                              const Iterate& iterate) {
  Equilibrium out;
  const auto nodes = static_cast<Index>(surface.nodes.size());
  // Returns the linearized gaps after a motion of the nodes.
  const auto gaps_after = [&](const Matrix3Xd& moved) {
    VectorXd gaps = iterate.gaps.gap_changes(moved);
    for (Index k = 0; k < nodes; ++k) gaps[k] += iterate.gaps.gap(static_cast<std::size_t>(k));
    return gaps;
  };
  // Move the body without contact. Nodes that had a force, or that penetrate now, touch.
  const Matrix3Xd free = surface_motion(surface, body_.solve(-iterate.tissue_force));
  const VectorXd free_gaps = gaps_after(free);
  std::vector<bool> touches(static_cast<std::size_t>(nodes));
  for (Index k = 0; k < nodes; ++k) touches[k] = iterate.normal_force[k] > 0 || free_gaps[k] < 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    std::vector<int> touching;
    for (int k = 0; k < nodes; ++k)
      if (touches[k]) touching.push_back(k);
    build_problem(surface, iterate, free, free_gaps, touching);
    out.status = solve_problem(surface, iterate, out);
    if (out.status != Status::kSolved) return out;
    // Let nodes that penetrate the object join.
    Matrix3Xd moved = surface_motion(surface, out.dx);
    if (iterate.drive) moved.colwise() -= out.object_motion * iterate.drive->direction;
    const VectorXd gaps = gaps_after(moved);
    bool has_joined = false;
    for (Index k = 0; k < nodes; ++k) {
      if (touches[k] || gaps[k] >= -kJoinDepth) continue;
      touches[k] = has_joined = true;
    }
    if (has_joined) continue;
    // Collect the forces on the nodes from the rows of the solution.
    out.normal_force = VectorXd::Zero(nodes);
    out.friction_force = Matrix3Xd::Zero(3, nodes);
    const Index per_node = iterate.friction > 0 ? 3 : 1;
    for (std::size_t i = 0; i < touching.size(); ++i) {
      const auto row = per_node * static_cast<Index>(i);
      const Index k = touching[i];
      out.normal_force[k] = f_[row];
      if (per_node > 1)
        out.friction_force.col(k) =
            J_.block<2, 3>(row + 1, 3 * k).transpose() * f_.segment<2>(row + 1);
    }
    return out;
  }
  out.status = Status::kLimit;
  return out;
}

Status ContactCones::solve_problem(const ContactSurface& surface, const Iterate& iterate,
                                   Equilibrium& equilibrium) {
  const auto solve_forces = [&] {
    const ContactSolution& solution = solver_.solve(problem_, initial_forces_);
    f_ = solution.f;
    return solution.status;
  };
  const Index unknowns = iterate.tissue_force.size();
  if (!iterate.drive) {
    // A fixed object needs the contact problem alone.
    const Status status = solve_forces();
    equilibrium.dx =
        body_.solve(body_forces(surface, J_.transpose() * f_, unknowns) - iterate.tissue_force);
    return status;
  }
  const Drive& drive = *iterate.drive;
  const auto nodes = static_cast<Index>(surface.nodes.size());
  // Compute the change c of the rows by a unit motion of the object, and the forces q of springs,
  // whose ends move with it.
  VectorXd c = J_ * drive.direction.replicate(nodes, 1), q = VectorXd::Zero(3 * nodes);
  double stiffness = drive.spring_stiffness;
  for (Index k = 0; k < springs_.cols(); ++k) {
    const double share = springs_.col(k).dot(drive.direction);
    q.segment<3>(3 * k) = share * springs_.col(k);
    stiffness += share * share;
  }
  // Eliminate the displacements of the body, which follows the springs.
  const VectorXd pulled = body_forces(surface, q, unknowns), follows = body_.solve(pulled);
  c -= J_ * surface_motion(surface, follows).reshaped();
  stiffness -= pulled.dot(follows);
  const double force = drive.force - follows.dot(iterate.tissue_force);
  // Eliminate the object's motion, (force - c . f) / stiffness, which adds a rank-one term to W.
  const MatrixXd W = problem_.W;
  const VectorXd b = problem_.b;
  problem_.W += c * c.transpose() / stiffness;
  problem_.b -= force / stiffness * c;
  Status status = solve_forces();
  equilibrium.object_motion = (force - c.dot(f_)) / stiffness;
  if (status != Status::kSolved || !(std::abs(equilibrium.object_motion) <= drive.max_motion)) {
    // Fix the motion at its bound if it is too long.
    equilibrium.object_motion = std::copysign(drive.max_motion, equilibrium.object_motion);
    problem_.W = W;
    problem_.b = b - equilibrium.object_motion * c;
    status = solve_forces();
  }
  equilibrium.dx = body_.solve(
      body_forces(surface, J_.transpose() * f_ + equilibrium.object_motion * q, unknowns) -
      iterate.tissue_force);
  return status;
}

Eigen::Matrix<double, 6, 6> contact_stiffness(CondensedBody& body, const ContactSurface& surface,
                                              const MeanGaps& gaps, const TouchingNodes& touching,
                                              const Matrix3Xd& places, const Matrix3Xd& forces) {
  // List the rows J: gaps, then slips of sticking nodes. The forces F have the same directions, but
  // a slipping node has friction in proportion to its normal force.
  Rows J = gaps.gap_gradients(touching.nodes), F = J;
  auto rows = static_cast<Index>(touching.nodes.size());
  for (std::size_t i = 0; i < touching.nodes.size(); ++i) {
    const int k = touching.nodes[i];
    if (!touching.sticks[i]) {
      F.push_back({static_cast<int>(i), k, touching.friction_ratio.col(i)});
      continue;
    }
    const auto tangents = tangents_of(gaps.normal(static_cast<std::size_t>(k)));
    for (int t = 0; t < 2; ++t, ++rows) {
      J.push_back({static_cast<int>(rows), k, tangents.col(t)});
      F.push_back(J.back());
    }
  }
  const Index nodes = places.cols(), unknowns = static_cast<Index>(body.size());
  // Factor the compliance of the rows, regularized where contacts are redundant.
  MatrixXd W = compliance(body, surface, J, F, rows);
  W.diagonal().array() += kAddedCompliance * W.diagonal().maxCoeff();
  const Eigen::PartialPivLU<MatrixXd> lu(W);
  const MatrixXd slopes = to_dense(J, rows, nodes), pushes = to_dense(F, rows, nodes);
  return object_stiffness(places, forces, [&](const Matrix3Xd& rigid, const Matrix3Xd& turned) {
    // Solve for the forces that make the rows follow the object while old forces turn.
    const VectorXd turn = turned.reshaped();
    const Matrix3Xd by_turn =
        surface_motion(surface, body.solve(body_forces(surface, turn, unknowns)));
    const VectorXd f = lu.solve(slopes * (rigid - by_turn).reshaped());
    const VectorXd gained = pushes.transpose() * f + turn;
    return MotionResponse{
        gained.reshaped(3, nodes),
        surface_motion(surface, body.solve(body_forces(surface, gained, unknowns)))};
  });
}

Eigen::Matrix<double, 6, 6> object_stiffness(
    const Matrix3Xd& places, const Matrix3Xd& forces,
    const std::function<MotionResponse(const Matrix3Xd&, const Matrix3Xd&)>& response) {
  Eigen::Matrix<double, 6, 6> out = Eigen::Matrix<double, 6, 6>::Zero();
  for (int column = 0; column < 6; ++column) {
    // Move the object along one axis or about it, and turn the forces with it.
    const Vector3d axis = Vector3d::Unit(column % 3);
    Matrix3Xd rigid(3, places.cols()), turned = Matrix3Xd::Zero(3, places.cols());
    for (Index k = 0; k < places.cols(); ++k) {
      rigid.col(k) = column >= 3 ? axis : axis.cross(Vector3d(places.col(k)));
      if (column < 3) turned.col(k) = axis.cross(Vector3d(forces.col(k)));
    }
    const MotionResponse found = response(rigid, turned);
    // Sum the changes of force and moment, and the moment of the old forces on displaced nodes.
    for (Index k = 0; k < places.cols(); ++k) {
      const Vector3d gained = found.force_change.col(k);
      out.block<3, 1>(0, column) +=
          Vector3d(places.col(k)).cross(gained) +
          Vector3d(found.displacement.col(k)).cross(Vector3d(forces.col(k)));
      out.block<3, 1>(3, column) += gained;
    }
  }
  return out;
}

}  // namespace thenar
