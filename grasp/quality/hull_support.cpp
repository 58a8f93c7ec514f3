#include "grasp/quality/hull_support.h"

#include <algorithm>
#include <limits>

namespace thenar::internal {

Support::Support(const WrenchSet& set, ForceLimit limit) : limit_(limit) {
  // Caps of one contact side by side, in the order of their first.
  std::vector<bool> taken(set.caps.size(), false);
  int contacts = 0;
  for (std::size_t i = 0; i < set.caps.size(); ++i) {
    double largest = 0;
    for (std::size_t j = i; j < set.caps.size() && !taken[i]; ++j) {
      const WrenchCap& cap = set.caps[j];
      if (j != i && (taken[j] || cap.contact < 0 || cap.contact != set.caps[i].contact)) continue;
      caps_.push_back({cap.c, Eigen::Matrix<double, 6, 3>::Zero(), static_cast<int>(cap.A.cols()),
                       contacts, false});
      caps_.back().A.leftCols(cap.A.cols()) = cap.A;
      largest = std::max(largest, cap.c.norm() + cap.A.norm());
      if (j != i) taken[j] = true;
    }
    if (taken[i]) continue;
    caps_.back().last_of_contact = true;
    ++contacts;
    size_ = limit == ForceLimit::kL1 ? std::max(size_, largest) : size_ + largest;
  }
  rounding_ = 32 * std::numeric_limits<double>::epsilon() * size_;
}

double Support::reach(const Cap& cap, const Wrench& u) {
  double square = 0;
  for (int k = 0; k < cap.axes; ++k) {
    const double a = cap.A.col(k).dot(u);
    square += a * a;
  }
  return cap.c.dot(u) + std::sqrt(square);
}

void Support::add_point(const Cap& cap, const Wrench& u, Wrench& sum) {
  sum += cap.c;
  Eigen::Vector3d z = Eigen::Vector3d::Zero();
  for (int k = 0; k < cap.axes; ++k) z(k) = cap.A.col(k).dot(u);
  const double length = z.norm();
  if (length == 0) return;  // every point of the cap is as good
  for (int k = 0; k < cap.axes; ++k) sum += z(k) / length * cap.A.col(k);
}

Reach Support::operator()(const Wrench& u) const {
  constexpr double kLowest = -std::numeric_limits<double>::infinity();
  Reach out{0, Wrench::Zero()};
  const Cap* best = nullptr;
  double best_reach = kLowest;
  for (const Cap& cap : caps_) {
    const double h = reach(cap, u);
    if (h > best_reach) {
      best_reach = h;
      best = &cap;
    }
    if (limit_ == ForceLimit::kL1 || !cap.last_of_contact) continue;
    if (best_reach > 0) {
      out.h += best_reach;
      add_point(*best, u, out.p);
    }
    best_reach = kLowest;
  }
  if (limit_ == ForceLimit::kL1 && best != nullptr) {
    out.h = best_reach;
    add_point(*best, u, out.p);
  }
  return out;
}

}  // namespace thenar::internal
