#include "kinematics_fit/fit_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/ranges.h>

#include "kinematics_fit/experiment_warnings.h"

namespace thenar {
namespace {

/// Shrinks the three residuals of one trial so that |r|^2 becomes c^2 log(1 + |r|^2 / c^2).
void shrink(double c, Eigen::Ref<Eigen::Vector3d> r, Eigen::Ref<Eigen::MatrixXd> J) {
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

FitProblem::FitProblem(TendonDigit digit, FitParameters parameters,
                       std::vector<Experiment> experiments, double robust_scale,
                       std::vector<AxisDistance> axis_distances)
    : digit_(std::move(digit)),
      parameters_(std::move(parameters)),
      experiments_(std::move(experiments)),
      robust_scale_(robust_scale),
      axis_distances_(std::move(axis_distances)) {
  require(parameters_.coordinates() > 0, "nothing to fit: every parameter is fixed");
  require(!experiments_.empty(), "nothing to fit to: no experiment");
  for (const Experiment& experiment : experiments_) {
    plans_.push_back(plan_experiment(digit_, parameters_, experiment));
    const auto known = std::find(specimens_.begin(), specimens_.end(), experiment.specimen);
    specimen_of_.push_back(static_cast<int>(known - specimens_.begin()));
    if (known == specimens_.end()) specimens_.push_back(experiment.specimen);
  }
  scale_coordinates();
  bound_coordinates();
  find_axes();
}

void FitProblem::find_axes() {
  const std::vector<std::string>& names = digit_.names.hinges;
  const auto hinge = [&](const std::string& joint) {
    const auto found = std::find(names.begin(), names.end(), joint);
    require(found != names.end(), "axis distance of joint '{}', which the digit has not; it has {}",
            joint, fmt::join(names, ", "));
    return static_cast<int>(found - names.begin());
  };
  for (const AxisDistance& wanted : axis_distances_) {
    require(wanted.lower <= wanted.upper && wanted.upper > 0,
            "axes of '{}' and '{}' cannot be {} .. {} m apart", wanted.joint_a, wanted.joint_b,
            wanted.lower, wanted.upper);
    axis_pairs_.push_back(
        {hinge(wanted.joint_a), hinge(wanted.joint_b), wanted.lower, wanted.upper});
  }
}

void FitProblem::scale_coordinates() {
  const bool alone = specimens_.size() == 1;
  const int n = parameters_.coordinates();
  population_sd_ = deviation_sd_ = Eigen::VectorXd::Zero(n);
  population_share_ = Eigen::VectorXd::Ones(n);
  population_.assign(n, -1);
  deviation_.assign(n, -1);
  for (int c = 0; c < n; ++c) {
    const Parameter& p = parameters_.all[parameters_.leader[c]];
    population_sd_[c] = alone ? std::hypot(p.sd, p.between_sd) : p.sd;
    deviation_sd_[c] = alone ? 0 : p.between_sd;
    if (alone) population_share_[c] = std::pow(p.sd / population_sd_[c], 2);
    if (population_sd_[c] > 0) population_[c] = population_size_++;
    if (deviation_sd_[c] > 0) deviation_[c] = deviation_size_++;
  }
}

void FitProblem::bound_coordinates() {
  const int size = population_size_ + deviation_size_ * static_cast<int>(specimens_.size());
  lower_ = Eigen::VectorXd::Constant(size, -std::numeric_limits<double>::infinity());
  upper_ = -lower_;
  for (int c = 0; c < parameters_.coordinates(); ++c) {
    const Parameter& p = parameters_.all[parameters_.leader[c]];
    if (population_[c] >= 0) {
      lower_[population_[c]] = (p.lower - p.mean) / population_sd_[c];
      upper_[population_[c]] = (p.upper - p.mean) / population_sd_[c];
      continue;
    }
    // Where the population does not move, a deviation alone can be kept within bounds.
    for (std::size_t s = 0; s < specimens_.size(); ++s) {
      const auto at = static_cast<int>(population_size_ + s * deviation_size_ + deviation_[c]);
      lower_[at] = (p.lower - p.mean) / deviation_sd_[c];
      upper_[at] = (p.upper - p.mean) / deviation_sd_[c];
    }
  }
}

Eigen::VectorXd FitProblem::displacements(const Eigen::VectorXd& z, int specimen) const {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(parameters_.coordinates());
  const int block = population_size_ + specimen * deviation_size_;
  for (int c = 0; c < parameters_.coordinates(); ++c) {
    const double share = specimen < 0 ? population_share_[c] : 1;
    if (population_[c] >= 0) u[c] += share * population_sd_[c] * z[population_[c]];
    if (deviation_[c] >= 0 && specimen >= 0) u[c] += deviation_sd_[c] * z[block + deviation_[c]];
  }
  return u;
}

Eigen::MatrixXd FitProblem::displacement_jacobian(int specimen) const {
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(parameters_.coordinates(), size());
  const int block = population_size_ + specimen * deviation_size_;
  for (int c = 0; c < parameters_.coordinates(); ++c) {
    const double share = specimen < 0 ? population_share_[c] : 1;
    if (population_[c] >= 0) J(c, population_[c]) = share * population_sd_[c];
    if (deviation_[c] >= 0 && specimen >= 0) J(c, block + deviation_[c]) = deviation_sd_[c];
  }
  return J;
}

CoordinateEntries FitProblem::entries(int c) const {
  CoordinateEntries of;
  of.population = population_.at(c);
  of.population_sd = population_sd_[c];
  if (deviation_[c] >= 0) of.deviation = population_size_ + deviation_[c];
  of.deviation_sd = deviation_sd_[c];
  return of;
}

Eigen::VectorXd FitProblem::unseen_variance() const {
  Eigen::VectorXd variance(parameters_.coordinates());
  for (int c = 0; c < parameters_.coordinates(); ++c) {
    const Parameter& p = parameters_.all[parameters_.leader[c]];
    // Given the sum of two normals, each still varies by share (1 - share) of its variance.
    const double share = population_share_[c];
    const double unsaid = share * (1 - share) * std::pow(population_sd_[c], 2);
    variance[c] = unsaid + std::pow(p.between_sd, 2);
  }
  return variance;
}

FitProblem::Prediction FitProblem::predict(const Eigen::VectorXd& z, int e,
                                           WithJacobian want) const {
  require(z.size() == size(), "fit has {} coordinates, got {}", size(), z.size());
  require(z.allFinite(), "coordinates of a fit must be finite");
  const int specimen = specimen_of_[e];
  const Eigen::VectorXd u = displacements(z, specimen);
  if (want == WithJacobian::kNo) return {force_values(digit_, parameters_, plans_[e], u), {}};
  ForceJacobian forces = force_jacobian(digit_, parameters_, plans_[e], u);
  return {std::move(forces.force), forces.J * displacement_jacobian(specimen)};
}

ConstraintValues FitProblem::constraints(const Eigen::VectorXd& z) const {
  const auto pairs = static_cast<Eigen::Index>(axis_pairs_.size());
  const auto specimens = static_cast<Eigen::Index>(specimens_.size());
  ConstraintValues out{Eigen::VectorXd(pairs * specimens),
                       Eigen::MatrixXd(pairs * specimens, size())};
  for (Eigen::Index s = 0; s < specimens && pairs > 0; ++s) {
    const int specimen = static_cast<int>(s);
    const ConstraintValues own =
        axis_constraints(digit_, parameters_, axis_pairs_, displacements(z, specimen));
    out.c.segment(s * pairs, pairs) = own.c;
    out.C.middleRows(s * pairs, pairs) = own.C * displacement_jacobian(specimen);
  }
  return out;
}

Eigen::VectorXd FitProblem::constraint_lower() const {
  Eigen::VectorXd lower(static_cast<Eigen::Index>(axis_pairs_.size()));
  for (Eigen::Index k = 0; k < lower.size(); ++k)
    lower[k] = std::pow(axis_pairs_[k].lower / axis_pairs_[k].upper, 2);
  return lower.replicate(static_cast<Eigen::Index>(specimens_.size()), 1);
}

std::vector<std::string> FitProblem::warnings() const {
  std::vector<std::string> all;
  for (std::size_t e = 0; e < plans_.size(); ++e)
    for (std::string& warning : experiment_warnings(digit_, plans_[e], experiments_[e]))
      all.push_back(std::move(warning));
  for (const Experiment& experiment : experiments_)
    if (!experiment.activations.empty())
      all.push_back(fmt::format(
          "experiment '{}': {} activation rows are not fitted, only a posterior uses them",
          experiment.name, experiment.activations.size()));
  return all;
}

int FitProblem::data_rows() const {
  int rows = 0;
  for (const ExperimentPlan& plan : plans_) rows += 3 * static_cast<int>(plan.force.cols());
  return rows;
}

Residuals FitProblem::evaluate(const Eigen::VectorXd& z, WithJacobian want) const {
  const bool jacobian = want == WithJacobian::kYes;
  const int data = data_rows();
  Residuals out;
  out.r.resize(data + size());
  if (jacobian) out.J = Eigen::MatrixXd::Zero(data + size(), size());
  int row = 0;
  for (std::size_t e = 0; e < plans_.size(); ++e) {
    const Prediction prediction = predict(z, static_cast<int>(e), want);
    for (Eigen::Index i = 0; i < prediction.force.cols(); ++i, row += 3) {
      const Eigen::Vector3d sd = plans_[e].sd.col(i);
      Eigen::Vector3d r = (prediction.force.col(i) - plans_[e].force.col(i)).cwiseQuotient(sd);
      Eigen::MatrixXd J(3, jacobian ? size() : 0);
      if (jacobian) J = sd.cwiseInverse().asDiagonal() * prediction.J.middleRows<3>(3 * i);
      if (robust_scale_ > 0) shrink(robust_scale_, r, J);
      out.r.segment<3>(row) = r;
      if (jacobian) out.J.middleRows<3>(row) = J;
    }
  }
  // Priors: every coordinate is standard normal.
  out.r.tail(size()) = z;
  if (jacobian) out.J.bottomRows(size()).setIdentity();
  return out;
}

std::vector<std::string> FitProblem::names() const {
  std::vector<std::string> names(size());
  for (int c = 0; c < parameters_.coordinates(); ++c) {
    const std::string& name = parameters_.all[parameters_.leader[c]].name;
    if (population_[c] >= 0) names[population_[c]] = name;
    for (std::size_t s = 0; s < specimens_.size() && deviation_[c] >= 0; ++s)
      names[population_size_ + s * deviation_size_ + deviation_[c]] = specimens_[s] + ": " + name;
  }
  return names;
}

LeastSquares least_squares(const FitProblem& problem) {
  LeastSquares out;
  out.lower = problem.lower();
  out.upper = problem.upper();
  out.residuals = [&problem](const Eigen::VectorXd& z, WithJacobian want) {
    return problem.evaluate(z, want);
  };
  if (problem.axis_distances().empty()) return out;
  out.c_lower = problem.constraint_lower();
  out.c_upper = Eigen::VectorXd::Ones(out.c_lower.size());
  out.constraints = [&problem](const Eigen::VectorXd& z) { return problem.constraints(z); };
  return out;
}

FitProblem subset(const FitProblem& problem,
                  const std::function<bool(const Experiment&, const Trial&)>& keep) {
  std::vector<Experiment> kept;
  for (Experiment experiment : problem.experiments()) {
    std::vector<Trial>& trials = experiment.trials;
    trials.erase(std::remove_if(trials.begin(), trials.end(),
                                [&](const Trial& trial) { return !keep(experiment, trial); }),
                 trials.end());
    if (!trials.empty()) kept.push_back(std::move(experiment));
  }
  return {problem.digit(), problem.parameters(), std::move(kept), problem.robust_scale(),
          problem.axis_distances()};
}

}  // namespace thenar
