#include "tendons/wrapping/fitted_path.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.h"
#include "base/units.h"
#include "tendons/wrapping/path_arms.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

/// Adds the coordinates of the hinges between two links.
void add_between(const Tree<double>& tree, int a, int b, std::set<int>& crossed) {
  for_each_hinge_between(tree, a, b,
                         [&](int i, bool /*on_b*/) { crossed.insert(tree[i].coordinate); });
}

// NOLINTNEXTLINE(misc-no-recursion): one level: a carrier does not ride
std::set<int> crossed_coordinates(const Tree<double>& tree, const PathSet& set,
                                  const WrappedPath& path) {
  // Collect the hinges between consecutive points and surfaces.
  std::set<int> crossed;
  for (std::size_t k = 0; k + 1 < path.points.size(); ++k) {
    int before = path.points[k].link;
    for (const PathWrap& bend : path.bends[k]) {
      const int link = set.surfaces[bend.surface].link;
      add_between(tree, before, link, crossed);
      before = link;
    }
    add_between(tree, before, path.points[k + 1].link, crossed);
  }
  // Add all coordinates of the carrier of a riding origin.
  if (path.carrier >= 0) {
    const WrappedPath& carrier = set.paths[path.carrier];
    crossed.merge(crossed_coordinates(tree, set, carrier));
    add_between(tree, path.points.front().link, carrier.points.back().link, crossed);
  }
  return crossed;
}

/// Extracts one run of a path as a set of its own, with the carrier of its origin first.
PathSet run_alone(const PathSet& set, const WrappedPath& path, std::size_t k) {
  // Copy two points with the surfaces between them.
  PathSet alone;
  alone.surfaces = set.surfaces;
  WrappedPath run;
  run.name = path.name;
  run.points = {path.points[k], path.points[k + 1]};
  run.bends = {path.bends[k]};
  // Add the carrier for the last run of a riding tendon.
  if (path.carrier >= 0 && k + 2 == path.points.size()) {
    alone.paths.push_back(set.paths[path.carrier]);
    run.carrier = 0;
    run.ride = path.ride;
  }
  alone.paths.push_back(run);
  return alone;
}

/// Wrapped run as a function of its own coordinates x in [-1, 1].
class Run {
 public:
  Run(const Tree<double>& tree, PathSet set, const FitBox& box)
      : tree_(tree), set_(std::move(set)), solver_(set_), box_(box) {
    for (int j : crossed_coordinates(tree, set_, set_.paths.back())) {
      coordinates.push_back(j);
      require(box.upper[j] - box.lower[j] < 2 * kPi - 1e-9 && box.upper[j] > box.lower[j],
              "strand '{}' crosses coordinate {}, which has no range to fit over",
              set_.paths.back().name, j);
    }
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Computes length and d length / dx of each own coordinate.
  FittedLength at(const VectorXd& x) {
    // Set the posture: own coordinates from x, all others in the middle of their range.
    VectorXd q = 0.5 * (box_.lower + box_.upper);
    for (std::size_t i = 0; i < coordinates.size(); ++i) q[coordinates[i]] += half(i) * x[i];
    // Solve the wrapped path there.
    const TreeState<double> state = pose_tree(tree_, q);
    const auto& shapes = solver_.solve(state);
    const PathShape& shape = shapes.back();
    require(shape.status == PathStatus::kTaut || shape.status == PathStatus::kRidesOnBend,
            "strand '{}' cannot be fitted: it is not taut within its joints' ranges (kink {:.3g} "
            "rad, a point {:.3g} mm inside a surface)",
            set_.paths.back().name, shape.error, 1e3 * shape.depth);
    // Convert arms by posture to derivatives by x.
    MatrixXd R(shapes.size(), q.size());
    path_arms(tree_, state, set_, shapes, R);
    RowVectorXd slope(coordinates.size());
    for (std::size_t i = 0; i < coordinates.size(); ++i)
      slope[i] = -half(i) * R(R.rows() - 1, coordinates[i]);
    return {shape.length, slope};
  }

  [[nodiscard]] double half(std::size_t i) const {
    return 0.5 * (box_.upper[coordinates[i]] - box_.lower[coordinates[i]]);
  }

  std::vector<int> coordinates;

 private:
  const Tree<double>& tree_;
  PathSet set_;
  PathSolver solver_;
  const FitBox& box_;
};

/// Computes an integer power.
Index power(Index base, std::size_t exponent) {
  Index result = 1;
  for (std::size_t i = 0; i < exponent; ++i) result *= base;
  return result;
}

/// Returns the digits of a number in a base, least significant first.
std::vector<Index> digits(Index number, Index base, std::size_t count) {
  std::vector<Index> result(count);
  for (Index& digit : result) {
    digit = number % base;
    number /= base;
  }
  return result;
}

/// Chebyshev polynomials T_0..T_n and their derivatives at x.
struct PolynomialBasis {
  VectorXd T, dT, ddT;
};
PolynomialBasis basis(int order, double x) {
  const VectorXd none = VectorXd::Zero(order + 1);
  // Apply the recurrence T_k = 2 x T_(k-1) - T_(k-2), differentiated twice.
  PolynomialBasis at{VectorXd::Ones(order + 1), none, none};
  if (order == 0) return at;
  at.T[1] = x;
  at.dT[1] = 1;
  for (int k = 2; k <= order; ++k) {
    at.T[k] = 2 * x * at.T[k - 1] - at.T[k - 2];
    at.dT[k] = 2 * at.T[k - 1] + 2 * x * at.dT[k - 1] - at.dT[k - 2];
    at.ddT[k] = 4 * at.dT[k - 1] + 2 * x * at.ddT[k - 1] - at.ddT[k - 2];
  }
  return at;
}

/// Evaluates a tensor and its derivatives by x: contracts its first coordinate, then the next.
FittedLength evaluate(const FittedRun& run, const VectorXd& x) {
  // Keep the value in parts[0], the derivative by each coordinate in the others.
  const Index n = run.order + 1;
  std::vector<VectorXd> parts{run.c};
  for (Index i = 0; i < x.size(); ++i) {
    const PolynomialBasis at = basis(run.order, x[i]);
    // Contract the next coordinate; its derivative starts a new part.
    const VectorXd whole = parts[0];
    const auto contracted = [&](const VectorXd& part, const VectorXd& by) {
      return VectorXd(Eigen::Map<const MatrixXd>(part.data(), n, part.size() / n).transpose() * by);
    };
    for (VectorXd& part : parts) part = contracted(part, at.T);
    parts.push_back(contracted(whole, at.dT));
  }
  FittedLength result{parts[0][0], RowVectorXd(x.size())};
  for (Index i = 0; i < x.size(); ++i) result.arms[i] = parts[static_cast<std::size_t>(i) + 1][0];
  return result;
}

/// Interpolates samples at Chebyshev points, one coordinate after the other:
///   c_i = (2 - [i = 0]) / n  sum_k f(x_k) T_i(x_k),   x_k = cos(pi (k + 1/2) / n).
FittedRun interpolate(Run& run, int order) {
  // Set up Chebyshev points and the matrix from samples to coefficients.
  const std::size_t d = run.coordinates.size();
  const Index n = order + 1;
  MatrixXd to_coefficients(n, n);
  VectorXd points(n);
  for (Index k = 0; k < n; ++k) {
    points[k] = std::cos(kPi * (static_cast<double>(k) + 0.5) / static_cast<double>(n));
    to_coefficients.col(k) = 2.0 / static_cast<double>(n) * basis(order, points[k]).T;
  }
  to_coefficients.row(0) *= 0.5;
  // Sample the length on the tensor grid.
  FittedRun fit{run.coordinates, order, VectorXd(power(n, d))};
  VectorXd x(static_cast<Index>(d));
  for (Index s = 0; s < fit.c.size(); ++s) {
    const std::vector<Index> at = digits(s, n, d);
    for (std::size_t i = 0; i < d; ++i) x[i] = points[at[i]];
    fit.c[s] = run.at(x).length;
  }
  for (std::size_t i = 0; i < d;
       ++i) {  // rotates the tensor: the first coordinate becomes the last
    const MatrixXd first =
        to_coefficients * Eigen::Map<const MatrixXd>(fit.c.data(), n, fit.c.size() / n);
    const MatrixXd turned = first.transpose();
    fit.c = Eigen::Map<const VectorXd>(turned.data(), turned.size());
  }
  return fit;
}

/// Returns the number of points per coordinate of the test grid: about 15,000 in all.
Index grid_points(std::size_t coordinates, int order) {
  const double many = std::pow(15000.0, 1.0 / static_cast<double>(coordinates));
  return std::max<Index>(static_cast<Index>(std::min(many, 401.0)), 2 * order + 3);
}

/// Measures the errors of a fit on an even grid, and bounds them between its points.
FitError fit_error(Run& run, const FittedRun& fit) {
  // Compute the differences of length and arms on an even grid.
  const std::size_t d = run.coordinates.size();
  const Index m = grid_points(d, d <= 3 ? fit.order : 0), all = power(m, d);
  MatrixXd arm_error(static_cast<Index>(d), all);  // [m/rad]
  FitError error;
  VectorXd x(static_cast<Index>(d));
  for (Index s = 0; s < all; ++s) {
    const std::vector<Index> at = digits(s, m, d);
    for (std::size_t i = 0; i < d; ++i)
      x[i] = -1 + 2.0 * static_cast<double>(at[i]) / static_cast<double>(m - 1);
    const FittedLength fitted = evaluate(fit, x), wrapped = run.at(x);
    error.length = std::max(error.length, std::abs(fitted.length - wrapped.length));
    for (std::size_t i = 0; i < d; ++i) {
      const auto row = static_cast<Index>(i);
      arm_error(row, s) = (fitted.arms[row] - wrapped.arms[row]) / run.half(i);
    }
  }
  // Take the largest differences on the grid.
  error.arm = arm_error.cwiseAbs().maxCoeff();
  error.arm_bound = error.arm;
  error.length_bound = error.length;
  // Add the largest change between neighbours, which bounds the arm's error between points.
  for (std::size_t i = 0; i < d; ++i) {
    const Index stride = power(m, i);
    double change = 0;
    for (Index s = 0; s < all; ++s)
      if (digits(s, m, d)[i] + 1 < m)
        change =
            std::max(change, (arm_error.col(s + stride) - arm_error.col(s)).cwiseAbs().maxCoeff());
    error.arm_bound += change;
  }
  // Integrate the bound of the arms over half a mesh width to bound the length.
  for (std::size_t i = 0; i < d; ++i)
    error.length_bound += run.half(i) / static_cast<double>(m - 1) * error.arm_bound;
  return error;
}

}  // namespace

FitBox fit_box(const Skeleton& skeleton) {
  FitBox box{VectorXd(skeleton.coordinates()), VectorXd(skeleton.coordinates())};
  for (int j = 0; j < skeleton.coordinates(); ++j) {
    box.lower[j] = skeleton.limits[j].lower;
    box.upper[j] = skeleton.limits[j].upper;
  }
  return box;
}

FittedPath fit_path(const Tree<double>& tree, const PathSet& set, std::size_t path,
                    const FitBox& box, int order) {
  require(order >= 1 && order <= 40, "the order of a fitted path must be 1 to 40, got {}", order);
  // Fit each run separately and add the errors.
  const WrappedPath& whole = set.paths.at(path);
  FittedPath fit{whole.name, box, 0, {}, {}};
  for (std::size_t k = 0; k + 1 < whole.points.size(); ++k) {
    Run run(tree, run_alone(set, whole, k), box);
    // Add a run that crosses no joint to the constant.
    if (run.coordinates.empty()) {
      fit.constant += run.at({}).length;
      continue;
    }
    fit.runs.push_back(interpolate(run, order));
    const FitError error = fit_error(run, fit.runs.back());
    fit.error.length += error.length;
    fit.error.arm += error.arm;
    fit.error.length_bound += error.length_bound;
    fit.error.arm_bound += error.arm_bound;
  }
  return fit;
}

namespace {

/// Position of a posture in a run's box, x in [-1, 1], and half the range of each coordinate.
struct BoxPlace {
  VectorXd x, half;
};
BoxPlace place_in_box(const FittedPath& path, const FittedRun& run, const VectorXd& q) {
  const auto d = static_cast<Index>(run.coordinates.size());
  BoxPlace place{VectorXd(d), VectorXd(d)};
  for (Index i = 0; i < d; ++i) {
    const int j = run.coordinates[i];
    place.half[i] = 0.5 * (path.box.upper[j] - path.box.lower[j]);
    place.x[i] = (q[j] - path.box.lower[j]) / place.half[i] - 1;
  }
  return place;
}

/// Contracts a tensor with one vector per coordinate.
double contract(const FittedRun& run, const std::vector<const VectorXd*>& by) {
  VectorXd part = run.c;
  for (const VectorXd* vector : by) {
    const Index n = vector->size();
    part =
        (Eigen::Map<const MatrixXd>(part.data(), n, part.size() / n).transpose() * *vector).eval();
  }
  return part[0];
}

}  // namespace

MatrixXd arm_derivatives(const FittedPath& path, const VectorXd& q) {
  MatrixXd dR = MatrixXd::Zero(q.size(), q.size());
  for (const FittedRun& run : path.runs) {
    // Evaluate polynomials with two derivatives, one coordinate at a time.
    const std::size_t d = run.coordinates.size();
    const BoxPlace place = place_in_box(path, run, q);
    std::vector<PolynomialBasis> bases;
    std::vector<const VectorXd*> by;
    for (Index i = 0; i < place.x.size(); ++i) bases.push_back(basis(run.order, place.x[i]));
    by.reserve(bases.size());
    for (const PolynomialBasis& at : bases) by.push_back(&at.T);
    // Add the second derivatives: two coordinates differentiated, or one of them twice.
    for (std::size_t i = 0; i < d; ++i)
      for (std::size_t j = 0; j < d; ++j) {
        std::vector<const VectorXd*> twice = by;
        twice[i] = &bases[i].dT;
        twice[j] = i == j ? &bases[i].ddT : &bases[j].dT;
        const double scale = place.half[i] * place.half[j];
        dR(run.coordinates[i], run.coordinates[j]) -= contract(run, twice) / scale;
      }
  }
  return dR;
}

FittedLength fitted_length(const FittedPath& path, const VectorXd& q) {
  // Sum the runs' lengths and arms.
  FittedLength sum{path.constant, RowVectorXd::Zero(q.size())};
  for (const FittedRun& run : path.runs) {
    const auto [x, half] = place_in_box(path, run, q);
    const FittedLength part = evaluate(run, x);
    sum.length += part.length;
    for (Index i = 0; i < x.size(); ++i) sum.arms[run.coordinates[i]] -= part.arms[i] / half[i];
  }
  return sum;
}

}  // namespace thenar
