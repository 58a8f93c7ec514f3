#include "kinematics_fit/force_jacobian.h"

#include <ceres/jet.h>

#include "kinematics_fit/axis_distance.h"

namespace thenar {
namespace {

constexpr int kLanes = 8;  // derivatives carried at once; fills two AVX or four SSE registers
using Jet = ceres::Jet<double, kLanes>;

/// u with unit derivatives for coordinates first .. first + kLanes - 1.
std::vector<Jet> seed(const Eigen::VectorXd& u, int first) {
  std::vector<Jet> jets(u.data(), u.data() + u.size());
  for (int lane = 0; lane < kLanes && first + lane < u.size(); ++lane)
    jets[first + lane].v[lane] = 1;
  return jets;
}

}  // namespace

Eigen::Matrix3Xd force_values(const TendonDigit& digit, const FitParameters& parameters,
                              const ExperimentPlan& plan, const Eigen::VectorXd& u) {
  return predict_forces(specimen_model(digit, parameters, parameter_values<double>(parameters, u)),
                        plan);
}

ForceJacobian force_jacobian(const TendonDigit& digit, const FitParameters& parameters,
                             const ExperimentPlan& plan, const Eigen::VectorXd& u) {
  // Eight coordinates at a time; the forces come along each time.
  const int n = parameters.coordinates();
  ForceJacobian out{Eigen::Matrix3Xd(3, plan.force.cols()),
                    Eigen::MatrixXd(3 * plan.force.cols(), n)};
  for (int first = 0; first < n; first += kLanes) {
    const auto forces = predict_forces(
        specimen_model(digit, parameters, parameter_values<Jet>(parameters, seed(u, first))), plan);
    // Values, and derivatives into their columns.
    for (Eigen::Index i = 0; i < forces.size(); ++i) {
      const Jet& f = forces.data()[i];
      out.force.data()[i] = f.a;
      for (int lane = 0; lane < kLanes && first + lane < n; ++lane)
        out.J(i, first + lane) = f.v[lane];
    }
  }
  return out;
}

ConstraintValues axis_constraints(const TendonDigit& digit, const FitParameters& parameters,
                                  const std::vector<AxisPair>& pairs, const Eigen::VectorXd& u) {
  // Eight coordinates at a time, as for forces.
  const int n = parameters.coordinates();
  const auto count = static_cast<Eigen::Index>(pairs.size());
  ConstraintValues out{Eigen::VectorXd(count), Eigen::MatrixXd(count, n)};
  for (int first = 0; first < n; first += kLanes) {
    const Tree<Jet> tree =
        specimen_model(digit, parameters, parameter_values<Jet>(parameters, seed(u, first)))
            .digit.tree;
    for (Eigen::Index k = 0; k < count; ++k) {
      // Squared distance over the squared upper limit.
      const AxisPair& pair = pairs[k];
      const Jet c =
          squared_axis_distance(tree[pair.first], tree[pair.second]) / (pair.upper * pair.upper);
      out.c[k] = c.a;
      for (int lane = 0; lane < kLanes && first + lane < n; ++lane)
        out.C(k, first + lane) = c.v[lane];
    }
  }
  return out;
}

}  // namespace thenar
