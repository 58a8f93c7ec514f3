#include "kinematics_fit/fit_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/ranges.h>

#include "base/bounded_normal.h"
#include "kinematics_fit/experiment_plan.h"

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

/// What bounds leave to the deviation of one specimen, in sds of it.
struct DeviationBounds {
  double lower, upper;  // [1]
  bool far;             // no mass lies beyond them
};

DeviationBounds deviation_bounds(const CoordinateEntries& of, double population, double sd) {
  constexpr double kFar = 9;  // beyond lies 1e-19 of a normal distribution [sds]
  // Rounding may leave the population a last bit outside.
  const double lower = std::min(0.0, (of.lower - population) / sd);
  const double upper = std::max(0.0, (of.upper - population) / sd);
  return {lower, upper, lower < -kFar && upper > kFar};
}

}  // namespace

SpecimenDeviation specimen_deviation(const CoordinateEntries& of, double population, double x,
                                     double factor) {
  const double sd = factor * of.deviation_sd;
  const DeviationBounds bounds = deviation_bounds(of, population, sd);
  if (bounds.far) return {sd * x, sd, 0, sd * x};
  if (!(bounds.lower < bounds.upper)) return {0, 0, 0, 0};
  const BoundedNormal::Image image = BoundedNormal(bounds.lower, bounds.upper).at(x);
  SpecimenDeviation out{sd * image.z, sd * image.by_x, -(image.by_lower + image.by_upper),
                        sd * image.z};
  // A wider spread brings both bounds nearer, in its sds.
  if (std::isfinite(bounds.lower)) out.by_log_factor -= sd * image.by_lower * bounds.lower;
  if (std::isfinite(bounds.upper)) out.by_log_factor -= sd * image.by_upper * bounds.upper;
  return out;
}

double deviation_entry(const CoordinateEntries& of, double population, double u, double factor) {
  constexpr double kMargin = 1e-12;  // x is infinite on a bound [sds]
  const double sd = factor * of.deviation_sd;
  const DeviationBounds bounds = deviation_bounds(of, population, sd);
  if (bounds.far) return u / sd;
  if (!(bounds.lower < bounds.upper)) return 0;
  return BoundedNormal(bounds.lower, bounds.upper).inverse(u / sd, kMargin);
}

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
  list_entries();
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

void FitProblem::list_entries() {
  const bool alone = specimens_.size() == 1;
  const int n = parameters_.coordinates();
  const auto leader = [&](int c) -> const Parameter& {
    return parameters_.all[parameters_.leader[c]];
  };
  entries_.resize(n);
  population_share_ = Eigen::VectorXd::Ones(n);

  // The population's entries come first.
  for (int c = 0; c < n; ++c) {
    const Parameter& p = leader(c);
    CoordinateEntries& of = entries_[c];
    of.population_sd = alone ? std::hypot(p.sd, p.between_sd) : p.sd;
    if (alone) population_share_[c] = std::pow(p.sd / of.population_sd, 2);
    if (of.population_sd > 0) of.population = population_size_++;
  }

  // Then those of each specimen, bounded about what the population leaves them.
  for (int c = 0; c < n && !alone; ++c) {
    const Parameter& p = leader(c);
    CoordinateEntries& of = entries_[c];
    of.deviation_sd = p.between_sd;
    if (of.deviation_sd > 0) of.deviation = population_size_ + deviation_size_++;
    // A tilt's belief is on the sphere, where the guard of its chart is no bound of anatomy.
    const bool tilt = p.kind == ParameterKind::kAxisDirection;
    if (of.deviation_sd <= 0 || of.population < 0 || tilt) continue;
    of.lower = p.lower - p.mean;
    of.upper = p.upper - p.mean;
  }
}

void FitProblem::bound_coordinates() {
  const int size = population_size_ + deviation_size_ * static_cast<int>(specimens_.size());
  lower_ = Eigen::VectorXd::Constant(size, -std::numeric_limits<double>::infinity());
  upper_ = -lower_;
  for (int c = 0; c < parameters_.coordinates(); ++c) {
    const Parameter& p = parameters_.all[parameters_.leader[c]];
    const CoordinateEntries& of = entries_[c];
    if (of.population >= 0) {
      lower_[of.population] = (p.lower - p.mean) / of.population_sd;
      upper_[of.population] = (p.upper - p.mean) / of.population_sd;
      continue;
    }
    // Where the population does not move, a deviation is all that is bounded.
    for (std::size_t s = 0; s < specimens_.size(); ++s) {
      const auto at = static_cast<int>(of.deviation + s * deviation_size_);
      lower_[at] = (p.lower - p.mean) / of.deviation_sd;
      upper_[at] = (p.upper - p.mean) / of.deviation_sd;
    }
  }
}

CoordinateMotion FitProblem::motion(const Eigen::VectorXd& z, int specimen) const {
  const int n = parameters_.coordinates();
  CoordinateMotion out{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n),
                       Eigen::VectorXd::Zero(n)};
  for (int c = 0; c < n; ++c) {
    // What all specimens have in common.
    const CoordinateEntries& of = entries_[c];
    const double share = specimen < 0 ? population_share_[c] : 1;
    if (of.population >= 0) {
      out.by_population[c] = share * of.population_sd;
      out.u[c] = out.by_population[c] * z[of.population];
    }
    if (of.deviation < 0 || specimen < 0) continue;

    // What this one has for itself, within what bounds leave to it.
    const double x = z[of.deviation + specimen * deviation_size_];
    const SpecimenDeviation own = specimen_deviation(of, out.u[c], x);
    out.u[c] += own.u;
    out.by_population[c] *= 1 + own.by_population;
    out.by_deviation[c] = own.by_x;
  }
  return out;
}

Eigen::VectorXd FitProblem::displacements(const Eigen::VectorXd& z, int specimen) const {
  return motion(z, specimen).u;
}

Eigen::MatrixXd FitProblem::displacement_jacobian(const Eigen::VectorXd& z, int specimen) const {
  const CoordinateMotion at = motion(z, specimen);
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(parameters_.coordinates(), size());
  for (int c = 0; c < parameters_.coordinates(); ++c) {
    const CoordinateEntries& of = entries_[c];
    if (of.population >= 0) J(c, of.population) = at.by_population[c];
    if (of.deviation >= 0 && specimen >= 0)
      J(c, of.deviation + specimen * deviation_size_) = at.by_deviation[c];
  }
  return J;
}

std::vector<int> FitProblem::entries_of_specimen(int specimen) const {
  std::vector<int> entries(population_size_ + (specimen < 0 ? 0 : deviation_size_));
  std::iota(entries.begin(), entries.end(), 0);
  for (std::size_t k = population_size_; k < entries.size(); ++k)
    entries[k] += specimen * deviation_size_;
  return entries;
}

Eigen::VectorXd FitProblem::unseen_variance() const {
  Eigen::VectorXd variance(parameters_.coordinates());
  for (int c = 0; c < parameters_.coordinates(); ++c) {
    const Parameter& p = parameters_.all[parameters_.leader[c]];
    // Given the sum of two normals, each still varies by share (1 - share) of its variance.
    const double share = population_share_[c];
    const double unsaid = share * (1 - share) * std::pow(entries_[c].population_sd, 2);
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
  return {std::move(forces.force), forces.J * displacement_jacobian(z, specimen)};
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
    out.C.middleRows(s * pairs, pairs) = own.C * displacement_jacobian(z, specimen);
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

Residuals FitProblem::data_residuals(const Eigen::VectorXd& z, int e, WithJacobian want) const {
  // Forces and their slopes by the coordinates of the specimen.
  const ExperimentPlan& plan = plans_[e];
  const CoordinateMotion at = motion(z, specimen_of_[e]);
  const bool jacobian = want == WithJacobian::kYes;
  ForceJacobian forces;
  if (jacobian)
    forces = force_jacobian(digit_, parameters_, plan, at.u);
  else
    forces.force = force_values(digit_, parameters_, plan, at.u);

  // By entries of z: each coordinate hangs on two of them at most.
  const Eigen::Index rows = forces.force.size();
  Residuals out;
  out.r = (forces.force - plan.force).cwiseQuotient(plan.sd).reshaped();
  if (jacobian) {
    out.J = Eigen::MatrixXd::Zero(rows, population_size_ + deviation_size_);
    for (int c = 0; c < parameters_.coordinates(); ++c) {
      const CoordinateEntries& of = entries_[c];
      if (of.population >= 0) out.J.col(of.population) += at.by_population[c] * forces.J.col(c);
      if (of.deviation >= 0) out.J.col(of.deviation) += at.by_deviation[c] * forces.J.col(c);
    }
    out.J = plan.sd.reshaped().cwiseInverse().asDiagonal() * out.J;
  }
  for (Eigen::Index row = 0; row < rows && robust_scale_ > 0; row += 3)
    apply_cauchy_loss(robust_scale_, out.r.segment<3>(row),
                      out.J.middleRows(jacobian ? row : 0, jacobian ? 3 : 0));
  return out;
}

Residuals FitProblem::evaluate(const Eigen::VectorXd& z, WithJacobian want) const {
  require(z.size() == size(), "fit has {} coordinates, got {}", size(), z.size());
  require(z.allFinite(), "coordinates of a fit must be finite");
  const bool jacobian = want == WithJacobian::kYes;
  const int data = data_rows();
  Residuals out;
  out.r.resize(data + size());
  if (jacobian) out.J = Eigen::MatrixXd::Zero(data + size(), size());
  int row = 0;
  for (int e = 0; e < static_cast<int>(plans_.size()); ++e) {
    const Residuals one = data_residuals(z, e, want);
    const auto rows = static_cast<int>(one.r.size());
    out.r.segment(row, rows) = one.r;
    if (jacobian) {
      const int own = population_size_ + specimen_of_[e] * deviation_size_;
      out.J.block(row, 0, rows, population_size_) = one.J.leftCols(population_size_);
      out.J.block(row, own, rows, deviation_size_) = one.J.rightCols(deviation_size_);
    }
    row += rows;
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
    const CoordinateEntries& of = entries_[c];
    if (of.population >= 0) names[of.population] = name;
    for (std::size_t s = 0; s < specimens_.size() && of.deviation >= 0; ++s)
      names[of.deviation + s * deviation_size_] = specimens_[s] + ": " + name;
  }
  return names;
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
  if (specimens < 2 || problem.deviations() == 0 || problem.population_entries() == 0) return;
  out.layout = {problem.population_entries(), problem.deviations(), specimens};
  for (int block = -1; block < specimens; ++block)
    out.parts.push_back(prior_part(out.layout, block));
  for (int e = 0; e < static_cast<int>(problem.experiments().size()); ++e)
    out.parts.push_back(
        {problem.specimen_of(e), [&problem, e](const Eigen::VectorXd& z, WithJacobian want) {
           return problem.data_residuals(z, e, want);
         }});
}

}  // namespace

LeastSquares least_squares(const FitProblem& problem) {
  LeastSquares out;
  add_parts(problem, out);
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
