#include "dynamics/mechanism/tree_model.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

/// Returns -[a][b], the term of the parallel axis theorem per unit mass.
Eigen::Matrix3d parallel_axis_term(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.dot(b) * Eigen::Matrix3d::Identity() - b * a.transpose();
}

/// Adds the mass of a body to its link.
void add_mass(TreeLink& link, const BodyMass& body, const Pose<double>& X_LB) {
  const Eigen::Vector3d com = X_LB * body.com;
  link.mass += body.mass;
  link.moment += body.mass * com;
  link.inertia +=
      X_LB.R * body.inertia * X_LB.R.transpose() + body.mass * parallel_axis_term(com, com);
}

/// Sorts links by their depth in the tree, stably: consecutive links then rarely depend on each
/// other, and processors can overlap their computation.
void order_by_depth(TreeModel& model) {
  // Compute depths and the order by them.
  const std::size_t n = model.links.size();
  std::vector<int> depth(n, 0);
  for (std::size_t i = 0; i < n; ++i)
    if (model.links[i].parent >= 0) depth[i] = depth[model.links[i].parent] + 1;
  std::vector<std::size_t> old_of(n);
  std::iota(old_of.begin(), old_of.end(), std::size_t{0});
  std::stable_sort(old_of.begin(), old_of.end(),
                   [&](std::size_t a, std::size_t b) { return depth[a] < depth[b]; });
  // Reorder the links and note their new indices.
  std::vector<int> new_of(n);
  std::vector<TreeLink> ordered;
  for (const std::size_t old : old_of) {
    new_of[old] = static_cast<int>(ordered.size());
    ordered.push_back(std::move(model.links[old]));
  }
  // Update all indices of links.
  const auto renumber = [&](int& link) {
    if (link >= 0) link = new_of[link];
  };
  for (TreeLink& link : ordered) renumber(link.parent);
  for (BodyInLink& body : model.bodies) renumber(body.link);
  model.links = std::move(ordered);
}

/// Checks that every velocity moves some mass; otherwise M would be singular.
void check_masses(const TreeModel& model) {
  std::vector<bool> carries(model.links.size());
  // Inward pass: find the links with mass on or beyond them, and the velocities that move them.
  std::vector<bool> moves(static_cast<std::size_t>(model.layout.v));
  for (std::size_t i = model.links.size(); i-- > 0;) {
    const TreeLink& link = model.links[i];
    carries[i] = carries[i] || link.mass > 0 || !link.inertia.isZero(0);
    if (carries[i] && link.parent >= 0) carries[link.parent] = true;
    if (carries[i]) moves[link.first_v] = true;
  }
  for (const TreeLink& link : model.links)
    require(moves[link.first_v], "joint '{}' moves nothing that has mass", link.joint.name);
}

/// Returns all velocities that move a link.
std::vector<int> movers_of(const TreeModel& model, const TreeLink& link) {
  std::vector<int> movers;
  for (const TreeLink* at = &link;; at = &model.links[at->parent]) {
    for (int k = 0; k < speed_count(at->kind); ++k) movers.push_back(at->first_v + k);
    if (at->parent < 0) return movers;
  }
}

/// Computes the sparsity pattern of the factor L' D L, eliminated from the last velocity: two
/// velocities are coupled if a link moves with both, or if a later velocity is coupled to both.
std::vector<std::vector<int>> factor_structure(const TreeModel& model) {
  std::vector<std::set<int>> lower(static_cast<std::size_t>(model.layout.v));
  for (const TreeLink& link : model.links) {
    // Couple each pair of the velocities that move this link.
    const std::vector<int> movers = movers_of(model, link);
    for (const int a : movers)
      for (const int b : movers)
        if (b < a) lower[a].insert(b);
  }
  // Add the fill-in of the elimination.
  for (std::size_t k = lower.size(); k-- > 0;)
    for (const int i : lower[k])
      for (const int j : lower[k])
        if (j < i) lower[i].insert(j);
  return transformed(
      lower, [](const std::set<int>& row) { return std::vector<int>(row.begin(), row.end()); });
}

}  // namespace

TreeModel tree_model(const Mechanism& mechanism) {
  check_mechanism(mechanism);
  TreeModel model;
  model.layout = layout_of(mechanism);
  std::vector<int> used(mechanism.coordinates.size());

  // Create a link for each movable joint; welded bodies join their parent's link.
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const MechanismJoint& joint = mechanism.joints[i];
    const BodyInLink parent = joint.parent < 0 ? BodyInLink{} : model.bodies[joint.parent];
    const Pose<double> X_PF = parent.X_LB * joint.X_PF;
    if (joint.kind == JointKind::kWeld) {
      model.bodies.push_back({parent.link, X_PF * joint.X_BM.inverse()});
    } else {
      TreeLink link;
      link.kind = joint.kind;
      link.parent = parent.link;
      link.first_q = model.layout.first_q[i];
      link.first_v = model.layout.first_v[i];
      link.X_PF = X_PF;
      link.joint = joint;
      if (is_scalar(joint.kind)) ++used[joint.coordinate];
      model.bodies.push_back({static_cast<int>(model.links.size()), joint.X_BM.inverse()});
      model.links.push_back(std::move(link));
    }
    // Add the body's mass to its link.
    const BodyInLink& body = model.bodies.back();
    if (body.link >= 0) add_mass(model.links[body.link], mechanism.bodies[i].mass, body.X_LB);
  }

  order_by_depth(model);

  // Mark links that share a coordinate.
  for (TreeLink& link : model.links) {
    if (!is_scalar(link.kind)) continue;
    link.shares_coordinate = used[link.joint.coordinate] > 1;
    model.has_couplings = model.has_couplings || link.shares_coordinate;
  }
  check_masses(model);
  model.coupled_to = factor_structure(model);
  return model;
}

}  // namespace thenar
