#include "tendons/forces/coordination.h"

#include <cmath>

#include "base/error.h"
#include "solvers/linear_program.h"
#include "solvers/nonlinear_program.h"
#include "solvers/relative_interior.h"
#include "tendons/forces/tip_balance.h"

namespace thenar {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Problem of both methods: statics, balance, wanted force and exponent p.
struct Task {
  const TipStatics& statics;
  const internal::TipBalance& balance;
  Vector3d wanted;  // [N]
  double p;
};

/// Builds the bounds and balance of activations that produce the wanted force, without an
/// objective.
LinearProgram activation_program(const Task& task) {
  const VectorXd wanted =
      task.balance.row_scale.cwiseProduct(task.statics.J.transpose() * task.wanted);
  LinearProgram program = internal::balance_program(task.balance, MatrixXd(wanted.size(), 0));
  program.row_lower = program.row_upper = task.balance.constant - wanted;
  return program;
}

/// Builds the result from activations and force.
Coordination report(const Task& task, Status status, const VectorXd& a, const Vector3d& force,
                    const std::string& message, double gap = KktResidual::kUnknown) {
  Coordination result{status, internal::tension(task.balance, a), {}, 0, force, {}, message, gap};
  result.activation = internal::activation(task.statics, result.tension);
  result.effort = result.activation.array().pow(task.p).sum();
  result.tau_residual = task.statics.J.transpose() * task.wanted -
                        task.statics.R.transpose() * result.tension - task.statics.tau_0;
  return result;
}

/// Builds the result without tensions and force, where a linear program stopped without a solution.
Coordination unsolved(const Task& task, Status status) {
  return report(task, status, VectorXd::Zero(task.balance.upper.size()), Vector3d::Zero(),
                "a linear program stalled");
}

/// Computes an upper bound of a convex objective's excess over its minimum: the sum of multiplier x
/// distance to bounds, plus the residual gradient times the largest distance of the optimum.
double convex_gap(const NonlinearResult& result, double radius) {
  const double slope =
      result.kkt_residual.stationarity * std::sqrt(static_cast<double>(result.x.size()));
  return result.kkt_residual.complementarity + slope * radius;
}

/// Computes the diameter of the box of m activations between 0 and 1.
double diameter(Index m) { return std::sqrt(static_cast<double>(m)); }

/// Builds the effort as a function of y with exact second derivatives; |a|^p, so that it is convex
/// for trial steps below zero.
NonlinearProgram effort_program(const internal::RelativeInterior& interior, double p) {
  NonlinearProgram program = internal::program_over_interior(interior);
  const auto activation = [&interior](const VectorXd& y) -> ArrayXd {
    return (interior.z0 + interior.Z * y).array();
  };
  program.objective = [activation, p](const VectorXd& y) {
    return activation(y).abs().pow(p).sum();
  };
  program.gradient = [activation, &interior, p](const VectorXd& y) -> VectorXd {
    const ArrayXd a = activation(y);
    return interior.Z.transpose() * (p * a.sign() * a.abs().pow(p - 1)).matrix();
  };
  program.hessian = [activation, &interior, p](const VectorXd& y, double factor,
                                               const VectorXd&) -> MatrixXd {
    const ArrayXd a =
        activation(y).abs().max(1e-12);  // for p < 2 the curvature at zero is infinite
    const VectorXd curvature = factor * p * (p - 1) * a.pow(p - 2);
    return interior.Z.transpose() * curvature.asDiagonal() * interior.Z;
  };
  return program;
}

/// Computes the feasible force nearest to the wanted one:  minimise |U phi - wanted|^2.
Coordination nearest_force(const Task& task) {
  const internal::TipBalance& balance = task.balance;
  const Index m = balance.upper.size();
  const internal::RelativeInterior interior =
      internal::relative_interior(internal::balance_program(balance, balance.force_part));
  if (interior.status != Status::kSolved)
    return report(task, interior.status, VectorXd::Zero(m), Vector3d::Zero(),
                  interior.status == Status::kStalled
                      ? "a linear program stalled"
                      : "no force at all balances the passive torque");

  const VectorXd aim = balance.U.transpose() * task.wanted / balance.force_unit;
  const MatrixXd Z = interior.Z.topRows(3);
  const auto miss = [&](const VectorXd& y) -> VectorXd {
    return interior.z0.head(3) + Z * y - aim;
  };
  NonlinearProgram program = internal::program_over_interior(interior);
  program.objective = [&](const VectorXd& y) { return miss(y).squaredNorm(); };
  program.gradient = [&](const VectorXd& y) -> VectorXd { return 2 * Z.transpose() * miss(y); };
  program.hessian = [&](const VectorXd&, double factor, const VectorXd&) -> MatrixXd {
    return 2 * factor * Z.transpose() * Z;
  };
  const NonlinearResult best = solve_ipopt(program, VectorXd::Zero(Z.cols()));
  const Status status = best.status;
  const VectorXd z = interior.z0 + interior.Z * best.x;
  const auto square = [](double value) { return value * value; };
  // Bound the distance of the optimum by twice the present miss.
  return report(
      task, status == Status::kSolved ? Status::kInfeasible : status, z.tail(m),
      balance.force_unit * (balance.U * z.head(3)),
      status == Status::kSolved ? "the wanted force is out of reach; this is the nearest"
                                : best.message,
      square(balance.force_unit) * convex_gap(best, diameter(m) + 2 * miss(best.x).norm()));
}

}  // namespace

Coordination coordinate(const TipStatics& statics, const Vector3d& f,
                        const CoordinationOptions& options) {
  const internal::TipBalance balance = internal::tip_balance(statics);
  require(f.allFinite(), "the wanted force must be finite");
  require(options.p >= 1 && std::isfinite(options.p), "the power of an effort must be >= 1, got {}",
          options.p);
  require(statics.max_tension.allFinite(), "effort needs a finite F0 for every muscle");
  const Task task{statics, balance, f, options.p};

  LinearProgram linear = activation_program(task);
  if (options.p == 1) {
    linear.objective.setConstant(-1);
    const LinearResult best = solve(linear);
    if (best.status == Status::kInfeasible) return nearest_force(task);
    if (best.status != Status::kSolved) return unsolved(task, best.status);
    return report(task, Status::kSolved, best.x, f, "linear program", best.certificate.gap);
  }

  const internal::RelativeInterior interior = internal::relative_interior(linear);
  if (interior.status == Status::kInfeasible) return nearest_force(task);
  if (interior.status != Status::kSolved) return unsolved(task, interior.status);
  NonlinearOptions sharp;  // the error of a silent muscle is the p-th root of the tolerance
  sharp.tolerance = 1e-13;
  const NonlinearResult best =
      solve_ipopt(effort_program(interior, options.p), VectorXd::Zero(interior.Z.cols()), sharp);
  return report(task, best.status, interior.z0 + interior.Z * best.x, f, best.message,
                convex_gap(best, diameter(interior.z0.size())));
}

}  // namespace thenar
