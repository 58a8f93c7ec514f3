#include "grasp/quality/planar_grasp.h"

#include <algorithm>
#include <map>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "base/error.h"
#include "base/lists.h"
#include "base/numbers.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

constexpr double kPlanarRounding =
    1e-12;                               // rounding error of the value over the largest wrench [1]
constexpr double kParallelSine = 1e-12;  // sine of the angle up to which edges are parallel [1]

Vector3d in_plane(const ScaledWrench& w) {
  return {w.force.x(), w.force.y(), w.moment_over_length.z()};
}

ScaledWrench in_space(const Vector3d& w) { return {{w.x(), w.y(), 0}, {0, 0, w.z()}}; }

/// Groups the points of each contact; caps with one number share a contact.
std::vector<Points> grouped_points(const WrenchSet& set) {
  std::vector<Points> groups;
  std::map<int, std::size_t> shared;
  for (const WrenchCap& cap : set.caps) {
    std::size_t at = groups.size();
    if (cap.contact >= 0) at = shared.try_emplace(cap.contact, at).first->second;
    if (at == groups.size()) groups.emplace_back();
    groups[at].push_back(in_plane(cap.c));
  }
  return groups;
}

/// Search for the minimum support over normals of pairs of vectors.
class LeastSupport {
 public:
  LeastSupport(const std::vector<Points>& groups, ForceNorm limit)
      : groups_(groups), limit_(limit) {}

  void look_across(const Vector3d& a, const Vector3d& b) {
    const Vector3d n = a.cross(b);
    if (n.norm() <= kParallelSine * a.norm() * b.norm()) return;
    for (const Vector3d& u : {Vector3d(n.normalized()), Vector3d(-n.normalized())}) {
      const double h = support(u);
      if (h < least) least = h, at = u;
    }
  }

  double least = kInfinity;
  Vector3d at{0, 0, 0};

 private:
  [[nodiscard]] double support(const Vector3d& u) const {
    // L1: the maximum over points; Linf: the sum of the maxima of all contacts, where positive.
    double sum = 0, largest = -kInfinity;
    for (const Points& points : groups_) {
      double best = -kInfinity;
      for (const Vector3d& p : points) best = std::max(best, u.dot(p));
      sum += std::max(0.0, best);
      largest = std::max(largest, best);
    }
    return limit_ == ForceNorm::kL1 ? largest : sum;
  }

  const std::vector<Points>& groups_;
  ForceNorm limit_;
};

/// L1: evaluates the normals of facets through three points of the set.
void look_at_triples(LeastSupport& search, const std::vector<Points>& groups) {
  Points all;
  for (const Points& points : groups) append_all(all, points);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j)
      for (std::size_t k = j + 1; k < all.size(); ++k)
        search.look_across(all[j] - all[i], all[k] - all[i]);
}

/// Linf: evaluates the normals of facets spanned by two edges of the contacts' hulls with 0.
void look_at_edge_pairs(LeastSupport& search, const std::vector<Points>& groups) {
  Points all;
  for (Points points : groups) {
    points.emplace_back(0, 0, 0);
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) all.emplace_back(points[i] - points[j]);
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) search.look_across(all[i], all[j]);
}

void require_planar(const WrenchSet& set) {
  require(set.caps.size() <= kMaxPlanarPoints, "a planar grasp has at most {} wrenches, got {}",
          kMaxPlanarPoints, set.caps.size());
  for (std::size_t i = 0; i < set.caps.size(); ++i)
    require(set.caps[i].c.is_finite() && set.caps[i].A.cols() == 0 &&
                set.caps[i].c.vector().segment<3>(2).isZero(0),
            "wrench {} is not one of the plane", i);
}

}  // namespace

WrenchSet planar_wrench_set(const std::vector<Contact>& contacts, const Vector3d& centre,
                            double torque_scale) {
  for (std::size_t i = 0; i < contacts.size(); ++i)
    require(contacts[i].p.z() == centre.z() && contacts[i].n.z() == 0 && contacts[i].torsion == 0,
            "contact {} is not one of the plane: z of its place and normal and its torsion are 0",
            i);
  const WrenchSet cones = wrench_set(contacts, centre, torque_scale);
  // Both ends of each friction cone, as wrenches of the plane.
  WrenchSet ends;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& contact = contacts[i];
    const Vector3d t = contact.friction * Vector3d(-contact.n.y(), contact.n.x(), 0),
                   arm = (contact.p - centre) / torque_scale;
    const ScaledWrench slide{t, {0, 0, arm.cross(t).z()}};
    const ScaledWrench push = in_space(in_plane(cones.caps[i].c));
    ends.caps.push_back({push + slide, {}, cones.caps[i].contact});
    if (contact.friction > 0) ends.caps.push_back({push - slide, {}, cones.caps[i].contact});
  }
  return ends;
}

Epsilon planar_epsilon(const WrenchSet& set, ForceNorm limit) {
  require_planar(set);
  Epsilon found = epsilon(set);  // of a flat set: 0, or minus the distance
  if (found.upper < 0 || set.caps.empty()) return found;

  // Rank of the planar wrenches.
  const Eigen::Matrix3Xd all =
      as_columns(set.caps, [](const WrenchCap& cap) { return in_plane(cap.c); });
  const Eigen::JacobiSVD<Eigen::Matrix3Xd> svd(all, Eigen::ComputeFullU);
  const Eigen::VectorXd& sigma = svd.singularValues();
  found.rank =
      static_cast<int>((sigma.array() > internal::kWrenchRankTolerance * sigma(0)).count());
  Vector3d missing = svd.matrixU().col(2);
  // Full rank: the minimum support over all facet normals, if it is positive.
  if (found.rank == 3) {
    const std::vector<Points> groups = grouped_points(set);
    LeastSupport search(groups, limit);
    limit == ForceNorm::kL1 ? look_at_triples(search, groups) : look_at_edge_pairs(search, groups);
    const double rounding = kPlanarRounding * all.colwise().norm().maxCoeff();
    if (search.least > rounding) {
      found.lower = search.least - rounding;
      found.upper = search.least + rounding;
      found.force_closure = true;
      found.has_missing_direction = false;
      found.missing_direction = {};
      found.worst_wrench = -in_space(search.at);
      return found;
    }
    missing = search.at;
  }
  found.missing_direction = in_space(missing);
  found.worst_wrench = -found.missing_direction;
  return found;
}

}  // namespace thenar
