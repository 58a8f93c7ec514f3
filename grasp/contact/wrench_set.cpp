#include "grasp/contact/wrench_set.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "base/numbers.h"

namespace thenar {
namespace {

constexpr double kUnitError = 1e-6;  // maximum deviation of a normal from unit length [1]

void require_sound(const Contact& contact, std::size_t i) {
  require(contact.p.allFinite() && contact.n.allFinite(), "contact {} is not finite", i);
  require(std::abs(contact.n.norm() - 1) < kUnitError,
          "normal of contact {} has length {}, wanted 1", i, contact.n.norm());
  require(contact.friction >= 0 && contact.friction < kInfinity, "friction of contact {} is {}", i,
          contact.friction);
  require(contact.torsion >= 0 && contact.torsion < kInfinity, "torsion of contact {} is {} m", i,
          contact.torsion);
}

/// Builds the cap of one contact.
WrenchCap wrench_cap(const Contact& contact, const Eigen::Vector3d& arm, double torque_scale) {
  const auto wrench = [&](const Eigen::Vector3d& force) {
    return scaled_wrench(wrench_of_force(arm, force), torque_scale);
  };
  // Frictionless unit wrench of the normal.
  const Eigen::Vector3d n = contact.n.normalized();
  const Tangents t = tangents(n);
  WrenchCap cap{wrench(n), {}, -1};
  // Semi-axes of friction and of torsion, if there are any.
  const int slides = contact.friction > 0 ? 2 : 0, twists = contact.torsion > 0 ? 1 : 0;
  cap.A.resize(6, slides + twists);
  if (slides > 0)
    cap.A.leftCols<2>() << contact.friction * wrench(t.e1).vector(),
        contact.friction * wrench(t.e2).vector();
  if (twists > 0)
    cap.A.rightCols<1>() = scaled_wrench({contact.torsion * n, {0, 0, 0}}, torque_scale).vector();
  return cap;
}

}  // namespace

WrenchSet wrench_set(const std::vector<Contact>& contacts, const Eigen::Vector3d& centre,
                     double torque_scale) {
  require(torque_scale > 0 && torque_scale < kInfinity, "torque scale is {} m", torque_scale);
  require(centre.allFinite(), "the centre is not finite");
  // One cap for each contact point.
  WrenchSet set;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    require_sound(contacts[i], i);
    set.caps.push_back(wrench_cap(contacts[i], contacts[i].p - centre, torque_scale));
  }
  // Points of one region share a number, and with it a force limit.
  const std::vector<int> region = contact_regions(contacts);
  for (std::size_t i = 0; i < contacts.size(); ++i) set.caps[i].contact = region[i];
  return set;
}

Eigen::Matrix<double, 6, Eigen::Dynamic> wrench_columns(const WrenchSet& set) {
  Eigen::Matrix<double, 6, Eigen::Dynamic> all(6, 0);
  for (const WrenchCap& cap : set.caps) {
    all.conservativeResize(6, all.cols() + 1 + cap.A.cols());
    all.rightCols(1 + cap.A.cols()) << cap.c.vector(), cap.A;
  }
  return all;
}

double support(const WrenchSet& set, const ScaledWrench& u, ForceNorm limit) {
  double largest = -kInfinity, sum = 0;
  std::map<int, double> shared;  // maximum over the caps of each numbered contact, where positive
  for (const WrenchCap& cap : set.caps) {
    // Support of one cap: an ellipsoid.
    const double reach = u.dot(cap.c) + (cap.A.transpose() * u.vector()).norm();
    largest = std::max(largest, reach);
    if (cap.contact < 0)
      sum += std::max(0.0, reach);
    else
      shared[cap.contact] = std::max(shared[cap.contact], reach);
  }
  // Each numbered contact counts once, with its best cap.
  for (const auto& [contact, reach] : shared) sum += reach;
  return limit == ForceNorm::kL1 ? largest : sum;
}

}  // namespace thenar
