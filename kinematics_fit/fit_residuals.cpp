#include "kinematics_fit/fit_residuals.h"

#include <cmath>

#include "base/error.h"
#include "kinematics_fit/activation_residuals.h"
#include "kinematics_fit/force_jacobian.h"
#include "kinematics_fit/kernel/force_kernel.h"
#include "kinematics_fit/specimen_prior.h"

namespace thenar {
namespace {

/// Shrinks the three residuals of one trial so that |r|^2 becomes c^2 log(1 + |r|^2 / c^2).
void apply_cauchy_loss(double c, Eigen::Ref<Eigen::Vector3d> r, Eigen::Ref<Eigen::MatrixXd> J) {
  const double s = r.squaredNorm() / (c * c);
  if (s < 1e-12) return;  // the factor is 1 - s/4 + ...
  const double factor = std::sqrt(std::log1p(s) / s);
  // d factor / d s, from factor^2 = log(1 + s) / s
  const double slope = (1 / (1 + s) - factor * factor) / (2 * factor * s);
  if (J.size() > 0) {
    const Eigen::RowVectorXd ds = 2 / (c * c) * r.transpose() * J;
    J = (factor * J + slope * r * ds).eval();
  }
  r *= factor;
}

}  // namespace

int data_rows(const FitProblem& problem) {
  int rows = 0;
  for (const ExperimentPlan& plan : problem.plans())
    rows += 3 * static_cast<int>(plan.force.cols());
  for (std::size_t e = 0; e < problem.plans().size(); ++e)
    rows += 4 * static_cast<int>(problem.activations_of(static_cast<int>(e)).tasks.size());
  return rows;
}

int force_rows(const FitProblem& problem, int e) {
  return 3 * static_cast<int>(problem.plans()[e].force.cols() +
                              static_cast<Eigen::Index>(problem.activations_of(e).tasks.size()));
}

int measured_numbers(const FitProblem& problem) {
  int count = 0;
  for (const ExperimentPlan& plan : problem.plans())
    count += plan.measured * static_cast<int>(plan.force.cols());
  for (std::size_t e = 0; e < problem.plans().size(); ++e)
    count += problem.plans()[e].measured *
             static_cast<int>(problem.activations_of(static_cast<int>(e)).tasks.size());
  return count;
}

namespace {

/// Returns the forces of a plan at the coordinates of its specimen, with their slopes if wanted.
ForceJacobian forces_at(const FitProblem& problem, int e, const ExperimentPlan& plan,
                        const ForceKernel* kernel, const Eigen::VectorXd& u, WithJacobian want) {
  const TendonDigit& digit = problem.digit_of(problem.specimen_of(e));
  if (want == WithJacobian::kYes)
    return force_jacobian(digit, problem.parameters(), plan, u, kernel);
  return {force_values(digit, problem.parameters(), plan, u, kernel), {}};
}

/// Applies the chain rule from coordinates to the entries of z that move the specimen; at most two
/// entries move each coordinate.
Eigen::MatrixXd by_entries(const FitCoordinates& coordinates, const CoordinateMotion& at,
                           const Eigen::MatrixXd& J) {
  Eigen::MatrixXd out =
      Eigen::MatrixXd::Zero(J.rows(), coordinates.population_entries() + coordinates.deviations());
  for (Eigen::Index c = 0; c < J.cols(); ++c) {
    const CoordinateEntries& coordinate = coordinates.entries(static_cast<int>(c));
    if (coordinate.population >= 0)
      out.col(coordinate.population) += at.by_population[c] * J.col(c);
    if (coordinate.deviation >= 0) out.col(coordinate.deviation) += at.by_deviation[c] * J.col(c);
  }
  return out;
}

/// Computes residuals of the activation rows of experiment e, with slopes by coordinates: three of
/// each row's force, row by row, then one of each row's width.
Residuals activation_rows(const FitProblem& problem, int e, const Eigen::VectorXd& u,
                          WithJacobian want) {
  const ActivationPlan& rows = problem.activations_of(e);
  const auto count = static_cast<Eigen::Index>(rows.tasks.size());
  const ForceJacobian unit =
      forces_at(problem, e, rows.plan, problem.activation_kernel_of(e), u, want);
  Residuals out;
  out.r.resize(4 * count);
  const bool jacobian = want == WithJacobian::kYes;
  if (jacobian) out.J.resize(4 * count, unit.J.cols());
  for (Eigen::Index k = 0; k < count; ++k) {
    // Select the forces of this row's unit pulls.
    const ActivationTask& task = rows.tasks[k];
    const auto pulls = static_cast<Eigen::Index>(task.pulls.size());
    Eigen::Matrix3Xd A(3, pulls);
    Eigen::MatrixXd A_u(3 * pulls, out.J.cols());
    for (Eigen::Index j = 0; j < pulls; ++j) {
      const Eigen::Index column = task.pulls[j].column;
      A.col(j) = unit.force.col(column);
      if (jacobian) A_u.middleRows(3 * j, 3) = unit.J.middleRows(3 * column, 3);
    }
    // Combine them into the row's residuals.
    const Residuals one = activation_residuals(task, A, A_u);
    out.r.segment<3>(3 * k) = one.r.head<3>();
    out.r[3 * count + k] = one.r[3];
    if (!jacobian) continue;
    out.J.middleRows<3>(3 * k) = one.J.topRows<3>();
    out.J.row(3 * count + k) = one.J.row(3);
  }
  return out;
}

}  // namespace

Eigen::Vector3d plain_residual(const Eigen::Vector3d& r, double c) {
  const double squared = r.squaredNorm();
  if (c <= 0 || squared == 0) return r;
  return r * std::sqrt(c * c * std::expm1(squared / (c * c)) / squared);
}

Residuals data_residuals(const FitProblem& problem, const Eigen::VectorXd& z, int e,
                         WithJacobian want) {
  // Compute forces, and their slopes by the entries of z that move the specimen.
  const FitCoordinates& coordinates = problem.coordinates();
  const ExperimentPlan& plan = problem.plans()[e];
  const CoordinateMotion at = coordinate_motion(coordinates, z, problem.specimen_of(e));
  const bool jacobian = want == WithJacobian::kYes;
  const ForceJacobian forces = forces_at(problem, e, plan, problem.kernel_of(e), at.u, want);
  Residuals out;
  out.r = (forces.force - plan.force).cwiseQuotient(plan.sd).reshaped();
  if (jacobian)
    out.J = plan.sd.reshaped().cwiseInverse().asDiagonal() * by_entries(coordinates, at, forces.J);

  // Append the activation rows after the trials.
  if (!problem.activations_of(e).tasks.empty()) {
    const Residuals rows = activation_rows(problem, e, at.u, want);
    out.r.conservativeResize(out.r.size() + rows.r.size());
    out.r.tail(rows.r.size()) = rows.r;
    if (jacobian) {
      const Eigen::MatrixXd J = by_entries(coordinates, at, rows.J);
      out.J.conservativeResize(out.r.size(), J.cols());
      out.J.bottomRows(J.rows()) = J;
    }
  }

  // Apply the robust loss, force by force.
  const double scale = problem.robust_scale();
  const Eigen::Index forces_end = force_rows(problem, e);
  for (Eigen::Index row = 0; row < forces_end && scale > 0; row += 3)
    apply_cauchy_loss(scale, out.r.segment<3>(row),
                      out.J.middleRows(jacobian ? row : 0, jacobian ? 3 : 0));
  return out;
}

Residuals specimen_residuals(const FitProblem& problem, const Eigen::VectorXd& z, int specimen) {
  const FitCoordinates& coordinates = problem.coordinates();
  Residuals out;
  out.J.resize(0, coordinates.population_entries() + coordinates.deviations());
  for (int e = 0; e < static_cast<int>(problem.experiments().size()); ++e) {
    if (problem.specimen_of(e) != specimen) continue;
    const Residuals one = data_residuals(problem, z, e, WithJacobian::kYes);
    const Eigen::Index forces = force_rows(problem, e), rows = out.r.size() + forces;
    out.r.conservativeResize(rows);
    out.r.tail(forces) = one.r.head(forces);
    out.J.conservativeResize(rows, Eigen::NoChange);
    out.J.bottomRows(forces) = one.J.topRows(forces);
  }
  return out;
}

Residuals fit_residuals(const FitProblem& problem, const Eigen::VectorXd& z, WithJacobian want) {
  const int size = problem.size();
  require(z.size() == size, "fit has {} coordinates, got {}", size, z.size());
  require(z.allFinite(), "coordinates of a fit must be finite");
  const bool jacobian = want == WithJacobian::kYes;
  const int data = data_rows(problem);
  Residuals out;
  out.r.resize(data + size);
  if (jacobian) out.J = Eigen::MatrixXd::Zero(data + size, size);

  // Fill in the data: columns of the population, and of each experiment's specimen.
  const int shared = problem.coordinates().population_entries();
  const int deviations = problem.coordinates().deviations();
  int row = 0;
  for (int e = 0; e < static_cast<int>(problem.plans().size()); ++e) {
    const Residuals one = data_residuals(problem, z, e, want);
    const auto rows = static_cast<int>(one.r.size());
    out.r.segment(row, rows) = one.r;
    if (jacobian) {
      const int own = shared + problem.specimen_of(e) * deviations;
      out.J.block(row, 0, rows, shared) = one.J.leftCols(shared);
      out.J.block(row, own, rows, deviations) = one.J.rightCols(deviations);
    }
    row += rows;
  }

  // Append the priors: every coordinate is standard normal.
  out.r.tail(size) = z;
  if (jacobian) out.J.bottomRows(size).setIdentity();
  return out;
}

ConstraintValues axis_constraints(const FitProblem& problem, const Eigen::VectorXd& z) {
  const auto pairs = static_cast<Eigen::Index>(problem.axis_pairs().size());
  const auto specimens = static_cast<Eigen::Index>(problem.specimens().size());
  // Evaluate each specimen, with the chain rule to z.
  ConstraintValues out{Eigen::VectorXd(pairs * specimens),
                       Eigen::MatrixXd::Zero(pairs * specimens, problem.size())};
  for (Eigen::Index s = 0; s < specimens && pairs > 0; ++s) {
    const int specimen = static_cast<int>(s);
    const Eigen::VectorXd u = displacements(problem.coordinates(), z, specimen);
    const ConstraintValues own =
        axis_constraints(problem.digit_of(specimen), problem.parameters(), problem.axis_pairs(), u);
    out.c.segment(s * pairs, pairs) = own.c;
    out.C(Eigen::seqN(s * pairs, pairs), problem.coordinates().entries_of_specimen(specimen)) =
        own.C * displacement_jacobian(problem.coordinates(), z, specimen);
  }
  return out;
}

Eigen::VectorXd axis_constraint_lower(const FitProblem& problem) {
  const std::vector<AxisPair>& pairs = problem.axis_pairs();
  Eigen::VectorXd lower(static_cast<Eigen::Index>(pairs.size()));
  for (Eigen::Index k = 0; k < lower.size(); ++k)
    lower[k] = std::pow(pairs[k].lower / pairs[k].upper, 2);
  return lower.replicate(static_cast<Eigen::Index>(problem.specimens().size()), 1);
}

namespace {

/// Returns the priors of the population's entries (block -1) or of a specimen's deviations: r = z.
ResidualPart prior_part(const ArrowLayout& layout, int block) {
  const int first = block < 0 ? 0 : layout.first_index(block);
  const int count = block < 0 ? layout.shared : layout.own;
  const int columns = layout.shared + (block < 0 ? 0 : layout.own);
  return {block, [=](const Eigen::VectorXd& z, WithJacobian want) {
            Residuals out{z.segment(first, count), {}};
            if (want == WithJacobian::kNo) return out;
            out.J = Eigen::MatrixXd::Zero(count, columns);
            out.J.rightCols(count).setIdentity();
            return out;
          }};
}

/// Adds the residuals of several specimens, in blocks.
void add_parts(const FitProblem& problem, LeastSquares& out) {
  const int specimens = static_cast<int>(problem.specimens().size());
  const int shared = problem.coordinates().population_entries();
  const int deviations = problem.coordinates().deviations();
  if (specimens < 2 || deviations == 0 || shared == 0) return;
  // Lay out the arrow: shared entries, and a block for each specimen.
  out.layout = {shared, deviations, specimens};
  for (int block = -1; block < specimens; ++block)
    out.parts.push_back(prior_part(out.layout, block));
  for (int e = 0; e < static_cast<int>(problem.experiments().size()); ++e)
    out.parts.push_back(
        {problem.specimen_of(e), [&problem, e](const Eigen::VectorXd& z, WithJacobian want) {
           return data_residuals(problem, z, e, want);
         }});
}

}  // namespace

LeastSquares least_squares(const FitProblem& problem) {
  // Set the residuals, whole and in blocks, and the bounds of z.
  LeastSquares out;
  add_parts(problem, out);
  out.lower = problem.coordinates().lower();
  out.upper = problem.coordinates().upper();
  out.residuals = [&problem](const Eigen::VectorXd& z, WithJacobian want) {
    return fit_residuals(problem, z, want);
  };
  if (problem.axis_distances().empty()) return out;

  // Constrain the distances between axes; their scaled upper bounds are 1.
  out.c_lower = axis_constraint_lower(problem);
  out.c_upper = Eigen::VectorXd::Ones(out.c_lower.size());
  out.constraints = [&problem](const Eigen::VectorXd& z) { return axis_constraints(problem, z); };
  return out;
}

}  // namespace thenar
