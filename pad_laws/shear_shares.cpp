#include "pad_laws/shear_shares.h"

#include <algorithm>

namespace thenar {
namespace {

constexpr int kShearBisections = 60;  // bisections of the displacement, down to rounding

}  // namespace

ShearShares share_shear(const Eigen::VectorXd& normal, const Eigen::VectorXd& stiffness,
                        double friction, double load) {
  // Each spring carries at most its friction limit; beyond that it slips.
  const Eigen::VectorXd limit = friction * normal.cwiseMax(0);
  const auto borne = [&](double shift) { return (shift * stiffness).cwiseMin(limit).sum(); };
  // Find the displacement at which the last spring slips.
  double from = 0, to = 0;
  for (Eigen::Index i = 0; i < limit.size(); ++i)
    if (limit[i] > 0) to = std::max(to, limit[i] / stiffness[i]);
  // For a smaller load, find the displacement at which the springs carry it.
  if (load < borne(to))
    for (int i = 0; i < kShearBisections; ++i) {
      const double middle = (from + to) / 2;
      (borne(middle) < load ? from : to) = middle;
    }
  // Springs below their friction limit stick.
  ShearShares shares;
  shares.borne = borne(to);
  for (Eigen::Index i = 0; i < limit.size(); ++i)
    shares.sticks.push_back(limit[i] > 0 && to * stiffness[i] < limit[i]);
  return shares;
}

}  // namespace thenar
