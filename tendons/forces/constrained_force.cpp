#include "tendons/forces/constrained_force.h"

#include "base/error.h"
#include "base/numbers.h"
#include "solvers/relative_interior.h"
#include "tendons/forces/max_tip_force.h"
#include "tendons/forces/tip_balance.h"

namespace thenar {
namespace {

// Relaxation of constraints that leave no interior, over the unit of force [1]
constexpr double kInteriorRelaxation = 1e-7;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Unknowns z = (amounts of k unit forces, activations);  f = forces amounts,  t = unit a.
struct Unknowns {
  Eigen::Matrix3Xd forces;  // (3, k)  [N]
  VectorXd unit;            // (m)     [N]

  [[nodiscard]] Vector3d force(const VectorXd& z) const { return forces * z.head(forces.cols()); }
  [[nodiscard]] VectorXd tension(const VectorXd& z) const {
    return unit.cwiseProduct(z.tail(unit.size()));
  }
};

/// Evaluates all constraints, stacked.
ConstraintValue evaluate(const std::vector<ForceConstraint>& limits, const Vector3d& f,
                         const VectorXd& t) {
  ConstraintValue all{VectorXd(0), Eigen::MatrixX3d(0, 3), MatrixXd(0, t.size())};
  for (const ForceConstraint& limit : limits) {
    // Evaluate value and gradients of one constraint.
    const ConstraintValue one = limit(f, t);
    const Index k = one.g.size(), old = all.g.size();
    require(one.dg_df.rows() == k && one.dg_dt.rows() == k && one.dg_dt.cols() == t.size(),
            "a limit of {} rows has gradients of {} and {} rows, for {} of {} tensions", k,
            one.dg_df.rows(), one.dg_dt.rows(), one.dg_dt.cols(), t.size());
    // Append them.
    all.g.conservativeResize(old + k);
    all.dg_df.conservativeResize(old + k, 3);
    all.dg_dt.conservativeResize(old + k, t.size());
    all.g.tail(k) = one.g;
    all.dg_df.bottomRows(k) = one.dg_df;
    all.dg_dt.bottomRows(k) = one.dg_dt;
  }
  return all;
}

/// Adds the constraints as rows below the bounds.
void add_limits(const internal::RelativeInterior& interior, const Unknowns& unknowns,
                const std::vector<ForceConstraint>& limits, NonlinearProgram& program) {
  const auto at = [&limits, &unknowns, &interior](const VectorXd& y) {
    const VectorXd z = interior.z0 + interior.Z * y;
    return evaluate(limits, unknowns.force(z), unknowns.tension(z));
  };
  const Index bounds = program.row_lower.size();
  const Index rows = at(VectorXd::Zero(interior.Z.cols())).g.size();
  program.row_lower.conservativeResize(bounds + rows);
  program.row_upper.conservativeResize(bounds + rows);
  program.row_lower.tail(rows).setConstant(-kInfinity);
  program.row_upper.tail(rows).setZero();
  program.constraints = [at, linear = program.constraints, bounds, rows](const VectorXd& y) {
    VectorXd all(bounds + rows);
    all << linear(y), at(y).g;
    return all;
  };
  program.jacobian = [at, linear = program.jacobian, &interior, &unknowns, bounds,
                      rows](const VectorXd& y) {
    // Apply the chain rule.
    const ConstraintValue value = at(y);
    const Index k = unknowns.forces.cols(), m = unknowns.unit.size();
    MatrixXd all(bounds + rows, y.size());
    all.topRows(bounds) = linear(y);
    all.bottomRows(rows) = value.dg_df * unknowns.forces * interior.Z.topRows(k) +
                           value.dg_dt * unknowns.unit.asDiagonal() * interior.Z.bottomRows(m);
    return all;
  };
}

}  // namespace

ConstrainedForce constrained_force(const TipStatics& statics, const Vector3d& direction,
                                   ForceDirection aim, const std::vector<ForceConstraint>& limits) {
  const internal::TipBalance balance = internal::tip_balance(statics);
  const Vector3d d = internal::unit_direction(direction);
  const Index m = balance.upper.size();

  // Parametrise forces along d alone, or along axes in which a straight finger has exact zeros.
  const MatrixXd axes = aim == ForceDirection::kAlong ? MatrixXd(d) : MatrixXd(balance.U);
  const MatrixXd turned = internal::without_rounding(balance.U.transpose() * axes);
  const Unknowns unknowns{balance.force_unit * axes, balance.unit};
  LinearProgram allowed = internal::balance_program(balance, balance.force_part * turned);
  if (aim == ForceDirection::kAlong) allowed.lower[0] = 0;
  const internal::RelativeInterior interior = internal::relative_interior(allowed);
  ConstrainedForce result;
  result.status = interior.status;
  result.tension = result.activation = VectorXd::Zero(m);
  result.message = "the balance has no solution";
  if (interior.status == Status::kStalled) result.message = "a linear program stalled";
  if (interior.status != Status::kSolved) return result;

  // Maximise the component along the direction under the constraints.
  NonlinearProgram program = internal::program_over_interior(interior);
  const Index bounds = program.row_upper.size();
  add_limits(interior, unknowns, limits, program);
  const VectorXd slope = interior.Z.topRows(axes.cols()).transpose() * (axes.transpose() * d);
  program.objective = [&slope](const VectorXd& y) { return -slope.dot(y); };
  program.gradient = [&slope](const VectorXd&) -> VectorXd { return -slope; };
  NonlinearResult best = solve_ipopt(program, VectorXd::Zero(slope.size()));
  if (best.status == Status::kStalled) {
    // Relax constraints that leave no interior.
    program.row_upper.tail(program.row_upper.size() - bounds)
        .setConstant(kInteriorRelaxation * balance.force_unit);
    best = solve_ipopt(program, VectorXd::Zero(slope.size()));
  }

  // Compute forces and tensions at the optimum.
  const VectorXd z = interior.z0 + interior.Z * best.x;
  result.status = best.status;
  result.force = unknowns.force(z);
  result.component = result.status == Status::kUnbounded ? kInfinity : d.dot(result.force);
  result.tension = internal::tension(balance, z.tail(m));
  result.activation = internal::activation(statics, result.tension);
  // Measure constraint violations, and first-order conditions in newtons.
  const VectorXd g = evaluate(limits, result.force, result.tension).g;
  result.excess = g.size() > 0 ? g.maxCoeff() : 0;
  result.message = best.message;
  result.iterations = best.iterations;
  result.kkt_residual = best.kkt_residual;
  result.kkt_residual.stationarity *= balance.force_unit;
  result.kkt_residual.complementarity *= balance.force_unit;
  result.imbalance = internal::imbalance(statics, result.force, result.tension);
  return result;
}

}  // namespace thenar
