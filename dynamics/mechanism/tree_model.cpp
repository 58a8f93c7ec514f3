#include "dynamics/mechanism/tree_model.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "base/error.h"

namespace thenar {
namespace {

/// -[a][b], the inertia that turns a moment of mass over two arms into one about a shifted origin.
Eigen::Matrix3d arm_product(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.dot(b) * Eigen::Matrix3d::Identity() - b * a.transpose();
}

/// Adds a body to its link.
void add_mass(TreeLink& link, const BodyMass& body, const Pose<double>& X_LB) {
  const Eigen::Vector3d com = X_LB * body.com;
  link.mass += body.mass;
  link.moment += body.mass * com;
  link.inertia += X_LB.R * body.inertia * X_LB.R.transpose() + body.mass * arm_product(com, com);
}

/// Puts links in the order of their depth in the tree, those of one depth as they came: neighbours
/// then wait for each other's results only where they have to, and processors overlap them.
void order_by_depth(TreeModel& model) {
  // Depths and the stable order by them.
  const std::size_t n = model.links.size();
  std::vector<int> depth(n, 0);
  for (std::size_t i = 0; i < n; ++i)
    if (model.links[i].parent >= 0)
      depth[i] = depth[static_cast<std::size_t>(model.links[i].parent)] + 1;
  std::vector<std::size_t> old_of(n);
  std::iota(old_of.begin(), old_of.end(), std::size_t{0});
  std::stable_sort(old_of.begin(), old_of.end(),
                   [&](std::size_t a, std::size_t b) { return depth[a] < depth[b]; });
  // Links in that order, and their new numbers.
  std::vector<int> new_of(n);
  std::vector<TreeLink> ordered;
  for (const std::size_t old : old_of) {
    new_of[old] = static_cast<int>(ordered.size());
    ordered.push_back(std::move(model.links[old]));
  }
  // Whatever names a link.
  const auto rename = [&](int& link) {
    if (link >= 0) link = new_of[static_cast<std::size_t>(link)];
  };
  for (TreeLink& link : ordered) rename(link.parent);
  for (BodyInLink& body : model.bodies) rename(body.link);
  model.links = std::move(ordered);
}

/// A joint whose motion moves no mass has no acceleration.
void check_masses(const TreeModel& model) {
  std::vector<bool> carries(model.links.size());
  // Find inwards which links carry mass, themselves or beyond, and which speeds move any.
  std::vector<bool> moves(static_cast<std::size_t>(model.layout.v));
  for (std::size_t i = model.links.size(); i-- > 0;) {
    const TreeLink& link = model.links[i];
    carries[i] = carries[i] || link.mass > 0 || !link.inertia.isZero(0);
    if (carries[i] && link.parent >= 0) carries[static_cast<std::size_t>(link.parent)] = true;
    if (carries[i]) moves[static_cast<std::size_t>(link.v)] = true;
  }
  for (const TreeLink& link : model.links)
    require(moves[static_cast<std::size_t>(link.v)], "joint '{}' moves nothing that has mass",
            link.joint.name);
}

/// Structure of the factor L' D L, eliminated from the last speed: two speeds are coupled if some
/// link moves with both, or if a later one is coupled to both.
std::vector<std::vector<int>> structure(const TreeModel& model) {
  std::vector<std::set<int>> lower(static_cast<std::size_t>(model.layout.v));
  for (const TreeLink& link : model.links) {
    // All speeds that move this link.
    std::vector<int> movers;
    const TreeLink* at = &link;
    while (true) {
      for (int k = 0; k < speeds_of(at->kind); ++k) movers.push_back(at->v + k);
      if (at->parent < 0) break;
      at = &model.links[static_cast<std::size_t>(at->parent)];
    }
    // Each pair of these is coupled.
    for (const int a : movers)
      for (const int b : movers)
        if (b < a) lower[static_cast<std::size_t>(a)].insert(b);
  }
  // Fill of the elimination.
  for (std::size_t k = lower.size(); k-- > 0;)
    for (const int i : lower[k])
      for (const int j : lower[k])
        if (j < i) lower[static_cast<std::size_t>(i)].insert(j);
  std::vector<std::vector<int>> out;
  for (const std::set<int>& row : lower) out.emplace_back(row.begin(), row.end());
  return out;
}

}  // namespace

TreeModel tree_model(const Mechanism& mechanism) {
  check_mechanism(mechanism);
  TreeModel model;
  model.layout = layout_of(mechanism);
  std::vector<int> used(mechanism.coordinates.size());

  // One link for each joint that moves; welded bodies join that of their parent.
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const MechanismJoint& joint = mechanism.joints[i];
    const BodyInLink parent =
        joint.parent < 0 ? BodyInLink{} : model.bodies[static_cast<std::size_t>(joint.parent)];
    const Pose<double> X_PF = parent.X_LB * joint.X_PF;
    if (joint.kind == JointKind::kWeld) {
      model.bodies.push_back({parent.link, X_PF * joint.X_BM.inverse()});
    } else {
      TreeLink link;
      link.kind = joint.kind;
      link.parent = parent.link;
      link.q = model.layout.first_q[i];
      link.v = model.layout.first_v[i];
      link.X_PF = X_PF;
      link.joint = joint;
      if (is_scalar(joint.kind)) ++used[static_cast<std::size_t>(joint.coordinate)];
      model.bodies.push_back({static_cast<int>(model.links.size()), joint.X_BM.inverse()});
      model.links.push_back(std::move(link));
    }
    // Its mass moves with the link.
    const BodyInLink& body = model.bodies.back();
    if (body.link >= 0)
      add_mass(model.links[static_cast<std::size_t>(body.link)], mechanism.bodies[i].mass,
               body.X_LB);
  }

  order_by_depth(model);

  // Coordinates that move several links.
  for (TreeLink& link : model.links) {
    if (!is_scalar(link.kind)) continue;
    link.shares = used[static_cast<std::size_t>(link.joint.coordinate)] > 1;
    model.has_couplings = model.has_couplings || link.shares;
  }
  check_masses(model);
  model.coupled_to = structure(model);
  return model;
}

}  // namespace thenar
