#include "kinematics_fit/fit_residuals.h"

#include <cmath>

#include "base/error.h"
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
  return rows;
}

int measured_numbers(const FitProblem& problem) {
  int count = 0;
  for (const ExperimentPlan& plan : problem.plans())
    count += plan.measured * static_cast<int>(plan.force.cols());
  return count;
}

Residuals data_residuals(const FitProblem& problem, const Eigen::VectorXd& z, int e,
                         WithJacobian want) {
  // Forces, and their slopes by the coordinates of the specimen.
  const FitCoordinates& coordinates = problem.coordinates();
  const FitParameters& parameters = problem.parameters();
  const ExperimentPlan& plan = problem.plans()[e];
  const CoordinateMotion at = coordinate_motion(coordinates, z, problem.specimen_of(e));
  const bool jacobian = want == WithJacobian::kYes;
  const TendonDigit& digit = problem.digit_of(problem.specimen_of(e));
  const ForceKernel* kernel = problem.kernel_of(e);
  const ForceJacobian forces =
      jacobian ? force_jacobian(digit, parameters, plan, at.u, kernel)
               : ForceJacobian{force_values(digit, parameters, plan, at.u, kernel), {}};

  // Chain rule to the entries of z: two of them at most move a coordinate.
  const Eigen::Index rows = forces.force.size();
  Residuals out;
  out.r = (forces.force - plan.force).cwiseQuotient(plan.sd).reshaped();
  if (jacobian) {
    out.J =
        Eigen::MatrixXd::Zero(rows, coordinates.population_entries() + coordinates.deviations());
    for (int c = 0; c < parameters.coordinates(); ++c) {
      const CoordinateEntries& of = coordinates.entries(c);
      if (of.population >= 0) out.J.col(of.population) += at.by_population[c] * forces.J.col(c);
      if (of.deviation >= 0) out.J.col(of.deviation) += at.by_deviation[c] * forces.J.col(c);
    }
    out.J = plan.sd.reshaped().cwiseInverse().asDiagonal() * out.J;
  }

  // Robust loss, trial by trial.
  const double scale = problem.robust_scale();
  for (Eigen::Index row = 0; row < rows && scale > 0; row += 3)
    apply_cauchy_loss(scale, out.r.segment<3>(row),
                      out.J.middleRows(jacobian ? row : 0, jacobian ? 3 : 0));
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

  // Data: columns of the population, and of the specimen that each experiment was done on.
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

  // Priors: every coordinate is standard normal.
  out.r.tail(size) = z;
  if (jacobian) out.J.bottomRows(size).setIdentity();
  return out;
}

ConstraintValues axis_constraints(const FitProblem& problem, const Eigen::VectorXd& z) {
  const auto pairs = static_cast<Eigen::Index>(problem.axis_pairs().size());
  const auto specimens = static_cast<Eigen::Index>(problem.specimens().size());
  // Specimen by specimen, with the chain rule to z.
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

/// Priors of the population's entries (block -1) or of a specimen's deviations: r = z.
ResidualPart prior_part(const ArrowLayout& layout, int block) {
  const int first = block < 0 ? 0 : layout.first(block);
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

/// The residuals of several specimens, in blocks.
void add_parts(const FitProblem& problem, LeastSquares& out) {
  const int specimens = static_cast<int>(problem.specimens().size());
  const int shared = problem.coordinates().population_entries();
  const int deviations = problem.coordinates().deviations();
  if (specimens < 2 || deviations == 0 || shared == 0) return;
  // Arrow layout: shared entries, and a block for each specimen.
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
  // Residuals within the bounds of z, whole and in blocks.
  LeastSquares out;
  add_parts(problem, out);
  out.lower = problem.coordinates().lower();
  out.upper = problem.coordinates().upper();
  out.residuals = [&problem](const Eigen::VectorXd& z, WithJacobian want) {
    return fit_residuals(problem, z, want);
  };
  if (problem.axis_distances().empty()) return out;

  // Distances between axes; their scaled upper bounds are 1.
  out.c_lower = axis_constraint_lower(problem);
  out.c_upper = Eigen::VectorXd::Ones(out.c_lower.size());
  out.constraints = [&problem](const Eigen::VectorXd& z) { return axis_constraints(problem, z); };
  return out;
}

}  // namespace thenar
