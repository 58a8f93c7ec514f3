#include "pads/pad_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "base/lists.h"
#include "base/numbers.h"
#include "base/progress_parts.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Step of the differences for derivatives, in coordinates [1]
constexpr double kNeighbourDistance = 1e-4;
// Largest eigenvalue of the information that counts as 0, over the largest of all [1]
constexpr double kSingularShare = 1e-10;
// Largest sd of a coordinate that counts as finite: derivatives do not extrapolate farther [1]
constexpr double kMaxSd = 10;
// sd of a weak prior about the start, for constants that nothing else determines [1]
constexpr double kAnchorSd = 1e3;
// Least correlation of two estimates that causes a warning [1]
constexpr double kJointCorrelation = 0.98;
// Largest misfit over the degrees of freedom without a warning [1]
constexpr double kBeyondChance = 4;
// Largest shift of an estimate on finer cells over its sd without a warning [1]
constexpr double kMeshMatters = 0.5;
constexpr double kUsualPads = 10;  // typical number of pads that a search presses, for progress
// Share of the total time of the press on finer cells, for progress [1]
constexpr double kFinerCells = 0.5;

double quantity_of(PressQuantity quantity, const PressPoint& point) {
  return quantity == PressQuantity::kIndentation ? point.indentation
         : quantity == PressQuantity::kForce     ? point.force
                                                 : point.area;
}

void check_datum(const PressRecord& record, const PressDatum& datum) {
  const auto loads = static_cast<int>(record.course.loads.size());
  require(datum.load >= 0 && datum.load < loads, "'{}' has {} loads, a datum is of load {}",
          record.name, loads, datum.load);
  require(!datum.over || (*datum.over >= 0 && *datum.over < loads && *datum.over != datum.load),
          "'{}': a datum of load {} cannot be a part of that of load {}", record.name, datum.load,
          datum.over.value_or(-1));
  require(datum.value > 0 && std::isfinite(datum.value), "'{}': a datum must be above 0, got {}",
          record.name, datum.value);
  require(datum.sd > 0 && std::isfinite(datum.sd),
          "'{}': the sd of a datum must be above 0, got {}", record.name, datum.sd);
  // An imposed quantity cannot be measured.
  const bool by_force = record.course.loads[datum.load].force.has_value();
  require(datum.quantity != (by_force ? PressQuantity::kForce : PressQuantity::kIndentation),
          "'{}': the {} of load {} is imposed, not measured", record.name, name_of(datum.quantity),
          datum.load);
}

/// Residuals of a fit problem and their derivatives.
class PadResiduals {
 public:
  explicit PadResiduals(const PadFitProblem& problem, const Progress& progress)
      : problem_(problem), progress_(progress) {
    // Compute the coordinates of the pad's own values, the means of the priors.
    for (const FreeConstant& each : problem.constants) {
      own_.push_back(value_of(problem.pad, each.constant));
      start_.push_back(coordinate_of(each.constant, own_.back()));
      if (each.prior_factor) ++priors_;
    }
    for (const PressRecord& record : problem.records) data_ += record.data.size();
  }

  [[nodiscard]] VectorXd start() const {
    return Eigen::Map<const VectorXd>(start_.data(), static_cast<Eigen::Index>(start_.size()));
  }
  [[nodiscard]] Eigen::Index data() const { return static_cast<Eigen::Index>(data_); }
  [[nodiscard]] int priors() const { return priors_; }

  /// Returns the pad at given coordinates.
  [[nodiscard]] PadModel pad_at(const VectorXd& z) const {
    PadModel pad = problem_.pad;
    for (std::size_t i = 0; i < own_.size(); ++i) {
      const PadConstant& constant = problem_.constants[i].constant;
      set_value(pad, constant, value_at(constant, z[i], own_[i]));
    }
    return pad;
  }

  struct Answer {
    VectorXd z, r;
    MatrixXd J;
    std::vector<std::vector<double>> predictions;  // (records, data)
    std::string failed;                            // reason why there are none
  };

  /// Returns residuals and derivatives. A cache serves solvers that evaluate a point twice.
  const Answer& at(const VectorXd& z) {
    for (const Answer& each : known_)
      if (each.z == z) return each;
    // Report progress that approaches 1, because the number of presses is unknown.
    progress_(presses_ / (presses_ + kUsualPads),
              presses_ == 0 ? "pressing the first pad"
                            : fmt::format("searching, {} pads pressed", presses_));
    Answer answer = evaluate(z);
    ++presses_;
    if (known_.size() >= 4) {
      // Drop the entry with the largest residual, so that the cache holds four.
      auto worst = known_.begin();
      for (auto each = known_.begin(); each != known_.end(); ++each)
        if (!(each->r.squaredNorm() <= worst->r.squaredNorm())) worst = each;
      known_.erase(worst);
    }
    known_.push_back(std::move(answer));
    return known_.back();
  }

 private:
  [[nodiscard]] Answer evaluate(const VectorXd& z) const {
    const auto n = static_cast<Eigen::Index>(own_.size());
    Answer out;
    out.z = z;
    out.r = VectorXd::Constant(data() + priors_, std::numeric_limits<double>::quiet_NaN());
    out.J = MatrixXd::Zero(data() + priors_, n);
    // Build the pad at z, and a neighbour for each derivative.
    std::vector<PadModel> pads{pad_at(z)};
    for (Eigen::Index i = 0; i < n; ++i) {
      VectorXd beside = z;
      beside[i] += kNeighbourDistance;
      pads.push_back(pad_at(beside));
    }
    // Leave the residuals NaN if a pad is invalid.
    for (const PadModel& pad : pads) {
      out.failed = why_impossible(pad);
      if (!out.failed.empty()) return out;
    }
    VectorXd r(out.r.size());
    Eigen::Index row = 0;
    // Add the residuals of the data, (prediction - value) / sd, and their differences.
    for (const PressRecord& record : problem_.records) {
      const PressCurves curves = press_curves(pads, record.course, {{}, progress_.stop_requested});
      if (curves.status != Status::kSolved) {
        out.failed = fmt::format("'{}' cannot be pressed {}", record.name, curves.message);
        return out;
      }
      out.predictions.emplace_back();
      for (const PressDatum& datum : record.data) {
        const double here = predicted(datum, curves.points[0]);
        out.predictions.back().push_back(here);
        r[row] = (here - datum.value) / datum.sd;
        for (Eigen::Index i = 0; i < n; ++i)
          out.J(row, i) =
              (predicted(datum, curves.points[i + 1]) - here) / (datum.sd * kNeighbourDistance);
        ++row;
      }
    }
    // Add the residuals of the priors, (z - z_0) / sd.
    for (Eigen::Index i = 0; i < n; ++i) {
      const std::optional<double>& factor = problem_.constants[i].prior_factor;
      if (!factor) continue;
      const double sd = std::log(*factor);
      r[row] = (z[i] - start_[i]) / sd;
      out.J(row, i) = 1 / sd;
      ++row;
    }
    out.r = r;
    return out;
  }

  const PadFitProblem& problem_;
  const Progress& progress_;
  std::vector<double> own_, start_;  // values of the pad, and their coordinates
  std::size_t data_ = 0;
  int priors_ = 0;
  int presses_ = 0;  // of pads with their neighbours
  std::vector<Answer> known_;
};

/// Returns the residuals of the search, with a weak prior about the start for all coordinates, so
/// that there is always a minimum.
Residuals anchored(const PadResiduals::Answer& at, const VectorXd& start) {
  const Eigen::Index rows = at.r.size(), n = start.size();
  Residuals out{VectorXd(rows + n), MatrixXd(rows + n, n)};
  out.r << at.r, (at.z - start) / kAnchorSd;
  out.J << at.J, MatrixXd::Identity(n, n) / kAnchorSd;
  return out;
}

/// Returns the diagonal of the inverse of J'J; infinite for coordinates along singular directions.
VectorXd variances(const MatrixXd& J) {
  // Decompose the information J'J.
  const Eigen::SelfAdjointEigenSolver<MatrixXd> spectrum(MatrixXd(J.transpose() * J));
  const VectorXd& lambda = spectrum.eigenvalues();
  const MatrixXd& v = spectrum.eigenvectors();
  const double small = kSingularShare * std::max(lambda.tail<1>()[0], 1e-300);
  // Sum the variance of each coordinate along eigenvectors; infinite along singular ones.
  VectorXd out = VectorXd::Zero(J.cols());
  for (Eigen::Index k = 0; k < lambda.size(); ++k)
    for (Eigen::Index i = 0; i < out.size(); ++i) {
      const double part = v(i, k) * v(i, k);
      if (lambda[k] > small)
        out[i] += part / lambda[k];
      else if (part > kSingularShare)
        out[i] = kInfinity;
    }
  // Treat an sd far beyond the validity of the derivatives as infinite.
  for (double& variance : out)
    if (variance > kMaxSd * kMaxSd) variance = kInfinity;
  return out;
}

/// Sets the estimates, their correlations and the misfit.
void estimate(const PadFitProblem& problem, const PadResiduals::Answer& at, const Eigen::Index data,
              PadFitResult& result) {
  const auto n = static_cast<Eigen::Index>(problem.constants.size());
  // Compute variances with and without priors, and correlations with priors.
  const VectorXd all = variances(at.J), alone = variances(at.J.topRows(data));
  result.correlations = MatrixXd::Identity(n, n);
  if (all.allFinite()) {
    const MatrixXd covariance = (at.J.transpose() * at.J).ldlt().solve(MatrixXd::Identity(n, n));
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j)
        if (i != j) result.correlations(i, j) = covariance(i, j) / std::sqrt(all[i] * all[j]);
  }
  // Set each estimate: value, sd, whether the data determine it, and whether it is at a bound.
  for (Eigen::Index i = 0; i < n; ++i) {
    const FreeConstant& free = problem.constants[i];
    ConstantEstimate each;
    each.value = value_of(result.pad, free.constant);
    each.sd = std::sqrt(all[i]);
    each.sd_by_data = std::sqrt(alone[i]);
    each.determined = 2 * each.sd_by_data < std::log(kDetermined);
    const double moved =
        at.z[i] - coordinate_of(free.constant, value_of(problem.pad, free.constant));
    each.at_bound = std::abs(moved - std::log(free.lower_factor)) < 1e-6 ||
                    std::abs(moved - std::log(free.upper_factor)) < 1e-6;
    result.estimates.push_back(each);
  }
  // Compute the misfit of the data alone.
  result.misfit = at.r.head(data).squaredNorm();
  result.degrees_of_freedom = static_cast<int>(data);
  for (const FreeConstant& each : problem.constants)
    if (!each.prior_factor) --result.degrees_of_freedom;
}

/// Computes to first order the shift of the estimate on cells of half the size, and the predictions
/// on these cells.
void check_mesh(const PadFitProblem& problem, const PadResiduals::Answer& at,
                const Progress& progress, PadFitResult& result) {
  const auto stopped = [&] {
    result.warnings.emplace_back("the mesh is not checked: it was stopped before");
  };
  if (progress.stop()) return stopped();
  // Press the pad with cells of half the size.
  PadModel finer = result.pad;
  finer.cells = {2 * finer.cells.across, 2 * finer.cells.around, 2 * finer.cells.through};
  const std::vector<PressCurves> curves = press_records(finer, problem.records, progress);
  // Compute the change of the residuals.
  VectorXd change = VectorXd::Zero(at.r.size());
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].status == Status::kStopped) return stopped();
    if (curves[i].status != Status::kSolved) {
      result.warnings.push_back(fmt::format("the mesh is not checked: '{}' cannot be pressed {}",
                                            problem.records[i].name, curves[i].message));
      return;
    }
    for (std::size_t k = 0; k < problem.records[i].data.size(); ++k) {
      const PressDatum& datum = problem.records[i].data[k];
      PressPrediction& here = result.predictions[i][k];
      here.finer = predicted(datum, curves[i].points[0]);
      change[row++] = (*here.finer - here.value) / datum.sd;
    }
  }
  // Solve the normal equations for the shift,  -(J'J)^-1 J' change.
  if (!variances(at.J).allFinite()) return;
  const VectorXd shift = -(at.J.transpose() * at.J).ldlt().solve(at.J.transpose() * change);
  for (Eigen::Index i = 0; i < shift.size(); ++i) result.estimates[i].mesh_shift = shift[i];
}

void warn(const PadFitProblem& problem, PadFitResult& result) {
  const auto name = [&](std::size_t i) {
    return name_of(problem.pad, problem.constants[i].constant);
  };
  // Warn of constants that are undetermined, at a bound, mesh-dependent, or strongly correlated.
  for (std::size_t i = 0; i < result.estimates.size(); ++i) {
    const ConstantEstimate& each = result.estimates[i];
    const bool prior = problem.constants[i].prior_factor.has_value();
    if (!each.determined)
      result.warnings.push_back(fmt::format(
          "{} is not determined by the data{}: {}", name(i),
          std::isinf(each.sd_by_data) ? ""
                                      : fmt::format(", which leave it within a factor of {:.3g}",
                                                    std::exp(2 * each.sd_by_data)),
          prior ? "its prior decides" : "give it a prior, or do not fit it"));
    if (each.at_bound)
      result.warnings.push_back(fmt::format("{} ends at a bound of its search", name(i)));
    if (std::isfinite(each.sd) && std::abs(each.mesh_shift) > kMeshMatters * each.sd)
      result.warnings.push_back(
          fmt::format("finer cells would change {} by a factor of {:.3g}, {:.2g} sds", name(i),
                      std::exp(each.mesh_shift), std::abs(each.mesh_shift) / each.sd));
    for (std::size_t j = 0; j < i; ++j) {
      const double together = result.correlations(i, j);
      if (std::abs(together) > kJointCorrelation)
        result.warnings.push_back(fmt::format(
            "{} and {} are known only together: correlation {:.3f}", name(j), name(i), together));
    }
  }
  // Warn of a misfit beyond chance.
  if (result.degrees_of_freedom > 0 && result.misfit > kBeyondChance * result.degrees_of_freedom)
    result.warnings.push_back(
        fmt::format("the pad misses the data: {:.3g} times what their sds allow",
                    result.misfit / result.degrees_of_freedom));
}

void check_problem(const PadFitProblem& problem) {
  require(!problem.constants.empty(), "no constant of the pad is free");
  // Check the data.
  std::size_t data = 0;
  for (const PressRecord& record : problem.records) {
    for (const PressDatum& datum : record.data) check_datum(record, datum);
    data += record.data.size();
  }
  require(data > 0, "there are no data to fit a pad to");
  // Check that the constants exist, and their bounds and priors.
  for (const FreeConstant& each : problem.constants) {
    (void)value_of(problem.pad, each.constant);  // there is one
    const std::string name = name_of(problem.pad, each.constant);
    require(each.lower_factor > 0 && each.lower_factor <= 1 && each.upper_factor >= 1 &&
                std::isfinite(each.upper_factor),
            "bounds of {} are factors below and above 1, got {} and {}", name, each.lower_factor,
            each.upper_factor);
    require(!each.prior_factor || (*each.prior_factor > 1 && std::isfinite(*each.prior_factor)),
            "the prior of {} needs a factor above 1, got {}", name, each.prior_factor.value_or(0));
  }
  // Check the pad at which the search begins.
  const std::string impossible = why_impossible(problem.pad);
  require(impossible.empty(), "{}", impossible);
}

}  // namespace

double predicted(const PressDatum& datum, const std::vector<PressPoint>& points) {
  const double value = quantity_of(datum.quantity, points.at(static_cast<std::size_t>(datum.load)));
  if (!datum.over) return value;
  return value / quantity_of(datum.quantity, points.at(static_cast<std::size_t>(*datum.over)));
}

std::vector<PressCurves> press_records(const PadModel& pad, const std::vector<PressRecord>& records,
                                       const Progress& progress) {
  return transformed(records, [&](const PressRecord& record) {
    return press_curves({pad}, record.course, {{}, progress.stop_requested});
  });
}

PadFitResult fit_pad(const PadFitProblem& problem, const PadFitOptions& options) {
  check_problem(problem);
  // Set up least squares in coordinates, with bounds about the pad's own values.
  ProgressParts parts(options.progress, 1);
  const Progress of_search = parts.next(options.check_mesh ? 1 - kFinerCells : 1);
  PadResiduals residuals(problem, of_search);
  LeastSquares squares;
  const VectorXd start = residuals.start();
  squares.lower = squares.upper = start;
  for (std::size_t i = 0; i < problem.constants.size(); ++i) {
    squares.lower[i] += std::log(problem.constants[i].lower_factor);
    squares.upper[i] += std::log(problem.constants[i].upper_factor);
  }
  squares.residuals = [&](const VectorXd& z, WithJacobian) {
    return anchored(residuals.at(z), start);
  };
  // Press the pad at which the search begins.
  PadFitResult result;
  result.pad = problem.pad;
  const std::string failed = residuals.at(start).failed;
  if (options.progress.stop()) {
    result.solution.z = start;
    result.solution.status = Status::kStopped;
    return result;
  }
  require(failed.empty(), "the search cannot begin: {}", failed);
  // Search, and build the pad at the solution.
  SolveOptions search;
  search.tolerance = options.tolerance;
  search.progress.stop_requested = options.progress.stop_requested;
  result.solution = solve(squares, start, search);
  const PadResiduals::Answer best = residuals.at(result.solution.z);
  result.pad = residuals.pad_at(best.z);
  if (!best.failed.empty()) return result;  // stopped while it was pressed
  // Collect predictions, estimates and their errors.
  for (const std::vector<double>& record : best.predictions) {
    result.predictions.emplace_back();
    for (const double value : record) result.predictions.back().push_back({value, {}});
  }
  estimate(problem, best, residuals.data(), result);
  // Press on finer cells for the shift by the mesh.
  if (options.check_mesh) {
    const Progress of_mesh = parts.next(kFinerCells);
    of_mesh(0, "pressing the estimate on finer cells");
    check_mesh(problem, best, of_mesh, result);
  }
  warn(problem, result);
  return result;
}

}  // namespace thenar
