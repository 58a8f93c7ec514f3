#include "pads/calibrate_laws.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/error.h"
#include "base/numbers.h"
#include "base/units.h"
#include "pads/pad_shape.h"
#include "pads/skin_gap.h"
#include "solvers/least_squares.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// sd of the logarithms of force, radius and torsion in the fits of power laws [1]
constexpr double kLogSd = 0.05;

/// Presses of one calibration, and messages of fits that did not converge.
struct Fits {
  const std::vector<MeasuredPress>& presses;
  std::string stalled;

  void note(const Solution& solution, const std::string& what) {
    if (solution.converged()) return;
    stalled += (stalled.empty() ? "" : "; ") + what + ": " + solution.message;
  }
  /// Minimizes  |(A z - y) / sd|^2  within bounds. @param what  name of the fit for messages
  Solution fit_lines(const MatrixXd& A, const VectorXd& y, const VectorXd& lower,
                     const VectorXd& upper, const std::string& what) {
    LeastSquares problem;
    problem.lower = lower;
    problem.upper = upper;
    problem.residuals = [&](const VectorXd& z, WithJacobian want) {
      Residuals out;
      out.r = (A * z - y) / kLogSd;
      if (want == WithJacobian::kYes) out.J = A / kLogSd;
      return out;
    };
    Solution found = solve(problem, VectorXd::Zero(A.cols()));
    note(found, what);
    return found;
  }

  /// Returns one value for each press.
  [[nodiscard]] VectorXd all(const std::function<double(const MeasuredPress&)>& of) const {
    VectorXd out(static_cast<Index>(presses.size()));
    for (std::size_t i = 0; i < presses.size(); ++i) out[i] = of(presses[i]);
    return out;
  }
};

double mean_semi_axis(const MeasuredPress& press) { return std::sqrt(press.area / kPi); }

/// Returns the share of torsion with which the law's radii match the measured arms, geometric mean
/// over the presses [1].
double torsion_share(const Fits& fits, const ContactLaw& law) {
  const VectorXd logs = fits.all([&](const MeasuredPress& press) {
    const SoftPatch patch = law.at_force(press.gap, press.force, 0).patch;
    return std::log(press.arm / mean_radius(patch.a, patch.b));
  });
  return std::min(1.0, std::exp(logs.mean()));
}

/// Returns the shear modulus with which a law, given with 1 Pa, matches the measured tangential
/// stiffness, geometric mean over the presses [Pa].
double shear_modulus(const Fits& fits, const ContactLaw& law) {
  return std::exp(fits.all([&](const MeasuredPress& press) {
                        return std::log(press.shear /
                                        law.at_force(press.gap, press.force, 0).shear);
                      })
                      .mean());
}

PowerLawConstants fit_power(Fits& fits) {
  const auto rows = static_cast<Index>(fits.presses.size());
  PowerLawConstants out;
  // Fit log force as a linear function of log depth.
  MatrixXd A = MatrixXd::Ones(rows, 2);
  A.col(1) = fits.all([](const MeasuredPress& p) { return std::log(p.depth / kLawDepth); });
  const VectorXd forces = fits.all([](const MeasuredPress& p) { return std::log(p.force); });
  Solution found = fits.fit_lines(A, forces, Eigen::Vector2d(-30, 0.1), Eigen::Vector2d(30, 10),
                                  "force of the power law");
  out.force = std::exp(found.z[0]);
  out.depth_exponent = found.z[1];
  // Fit log radius as a linear function of log force; gamma has the published bounds.
  A.col(1) = forces;
  const VectorXd radii =
      fits.all([](const MeasuredPress& p) { return std::log(mean_semi_axis(p) / kLawDepth); });
  found = fits.fit_lines(A, radii, Eigen::Vector2d(-30, 0), Eigen::Vector2d(30, 1.0 / 3),
                         "patch of the power law");
  out.patch = kLawDepth * std::exp(found.z[0]);
  out.patch_exponent = found.z[1];
  // Compute torsion and shear with the fitted patch, as means over the presses.
  out.torsion = torsion_share(fits, PowerLaw(out));
  out.shear = 1;
  out.shear = shear_modulus(fits, PowerLaw(out));
  return out;
}

SoftFingerConstants fit_soft_finger(Fits& fits) {
  const auto rows = static_cast<Index>(fits.presses.size());
  SoftFingerConstants out;
  // Fit log force as a linear function of log depth and log radius of the gap.
  MatrixXd A = MatrixXd::Ones(rows, 3);
  A.col(1) = fits.all([](const MeasuredPress& p) { return std::log(p.depth / kLawDepth); });
  A.col(2) = fits.all([](const MeasuredPress& p) {
    return std::log(internal::radius_of(p.gap).radius / kLawRadius);
  });
  const VectorXd forces = fits.all([](const MeasuredPress& p) { return std::log(p.force); });
  Solution found = fits.fit_lines(A, forces, Vector3d(-30, 0.1, -10), Vector3d(30, 10, 10),
                                  "force of the soft finger");
  out.force = std::exp(found.z[0]);
  out.depth_exponent = found.z[1];
  out.radius_exponent = found.z[2];
  // Fit log mean radius as a linear function of log force and log radius of the gap.
  A.col(1) = forces;
  const VectorXd radii =
      fits.all([](const MeasuredPress& p) { return std::log(mean_semi_axis(p) / kLawDepth); });
  found = fits.fit_lines(A, radii, Vector3d(-30, 0, -10), Vector3d(30, 10, 10),
                         "patch of the soft finger");
  out.patch = kLawDepth * std::exp(found.z[0]);
  out.patch_exponent = found.z[1];
  out.patch_radius = found.z[2];
  // Fit the log ratio of the semi-axes as proportional to that of the gap's radii.
  const MatrixXd ratios =
      fits.all([](const MeasuredPress& p) { return std::log(internal::radius_of(p.gap).ratio); });
  const VectorXd aspects = fits.all([](const MeasuredPress& p) { return std::log(p.aspect); });
  found = fits.fit_lines(ratios, aspects, VectorXd::Constant(1, -10), VectorXd::Constant(1, 10),
                         "semi-axes of the soft finger");
  out.aspect = found.z[0];
  out.torsion = torsion_share(fits, SoftFinger(out));
  out.shear = 1;
  out.shear = shear_modulus(fits, SoftFinger(out));
  return out;
}

/// Returns the constants of a bed from coordinates: log pressure at a strain of 0.2, m, s, spread,
/// c.
FoundationConstants foundation_at(const VectorXd& z, const FoundationConstants& base) {
  FoundationConstants out = base;
  out.exponent = z[1];
  out.stiffening = z[2];
  out.spread = z[3];
  out.surround = z[4];
  constexpr double kMeanStrain = 0.2;  // Strain at which the modulus of the springs is matched [1]
  out.modulus = 1;
  out.modulus = std::exp(z[0]) / spring_pressure(out, kMeanStrain).pressure;
  return out;
}

FoundationConstants fit_foundation(Fits& fits, const FoundationColumns& columns,
                                   const FoundationConstants& base, const LawFitOptions& options) {
  const auto rows = static_cast<Index>(fits.presses.size());
  // Returns the residuals: log ratios of force and area to those of the elements.
  const auto residuals = [&](const VectorXd& z) {
    const FoundationBed bed(columns, foundation_at(z, base));
    VectorXd r(2 * rows);
    for (Index i = 0; i < rows; ++i) {
      const MeasuredPress& press = fits.presses[i];
      const BedContact contact = bed.press(*press.object, press.X_PO);
      r[2 * i] = std::log(contact.force / press.force) / options.force_sd;
      r[2 * i + 1] = std::log(contact.area / press.area) / options.area_sd;
    }
    return r;
  };
  // Set bounds of log pressure, m, s, spread and c.
  LeastSquares problem;
  problem.lower = VectorXd::Zero(5);
  problem.upper = VectorXd::Constant(5, 100);
  problem.lower.segment<3>(1) << 0.2, 0, 1;
  problem.upper.head<4>() << 25, 5, 1000, 4;
  problem.residuals = [&](const VectorXd& z, WithJacobian want) {
    Residuals out;
    out.r = residuals(z);
    if (want == WithJacobian::kNo) return out;
    // Differentiate by central differences, one-sided at a bound.
    out.J.resize(out.r.size(), z.size());
    for (Index k = 0; k < z.size(); ++k) {
      VectorXd more = z, less = z;
      const double h = 1e-5 * (1 + std::abs(z[k]));
      more[k] = std::min(problem.upper[k], z[k] + h);
      less[k] = std::max(problem.lower[k], z[k] - h);
      out.J.col(k) = (residuals(more) - residuals(less)) / (more[k] - less[k]);
    }
    return out;
  };
  // Start from soft linear springs.
  VectorXd start(5);
  start << std::log(1e4), 1, 1, 1.5, 0.5;
  const Solution found = solve(problem, start);
  fits.note(found, "bed of springs");
  return foundation_at(found.z, base);
}

/// Returns the tangential stiffness that sticking adds to a bed of springs with G = 1 Pa [N/m].
double shear_per_modulus(const FoundationColumns& columns, FoundationConstants constants,
                         const MeasuredPress& press) {
  constexpr double kDifferenceWay = 1e-6, kHoldingFriction = 10;  // [m]; a friction that holds
  constants.shear = 1;
  const FoundationBed bed(columns, constants);
  const Tangents across = tangents(bed.press(*press.object, press.X_PO).normal);
  double sum = 0;
  // Average over two tangential directions: pull with full sticking less pull without friction.
  for (const Vector3d& way : {across.e1, across.e2}) {
    Pose<double> X = press.X_PO;
    X.p += kDifferenceWay * way;
    const auto pull = [&](double friction) {
      BedState state;
      (void)bed.step(*press.object, press.X_PO, friction, 0, state);
      return way.dot(bed.step(*press.object, X, friction, 0, state).push.force);
    };
    sum += pull(kHoldingFriction) - pull(0);
  }
  return 0.5 * sum / kDifferenceWay;
}

/// Quantities of a press that a law predicts.
struct LawAnswer {
  double force, area, radius, arm, shear;
};

LawError error_of(const std::vector<MeasuredPress>& presses,
                  const std::function<LawAnswer(const MeasuredPress&)>& law) {
  LawError out;
  // Adds a relative error to the mean square and to the largest.
  const auto add = [&](RelativeError& error, double ours, double theirs) {
    const double wrong = std::abs(ours / theirs - 1);
    error.rms += wrong * wrong / static_cast<double>(presses.size());
    error.worst = max_or_nan(error.worst, wrong);
  };
  for (const MeasuredPress& press : presses) {
    const LawAnswer answer = law(press);
    add(out.force, answer.force, press.force);
    add(out.area, answer.area, press.area);
    add(out.radius, answer.radius, mean_semi_axis(press) * std::sqrt(press.aspect));
    add(out.torsion, answer.arm, press.arm);
    add(out.shear, answer.shear, press.shear);
  }
  for (RelativeError* error : {&out.force, &out.area, &out.radius, &out.torsion, &out.shear})
    error->rms = std::sqrt(error->rms);
  return out;
}

LawError error_of(const std::vector<MeasuredPress>& presses, const ContactLaw& law) {
  return error_of(presses, [&](const MeasuredPress& press) {
    const LawContact contact = law.at_depth(press.gap, press.depth, 1);
    return LawAnswer{contact.force, contact.area, contact.patch.a, contact.patch.torsion,
                     contact.shear};
  });
}

LawError error_of(const std::vector<MeasuredPress>& presses, const FoundationColumns& columns,
                  const FoundationConstants& constants) {
  const FoundationBed bed(columns, constants);
  return error_of(presses, [&](const MeasuredPress& press) {
    const BedContact contact = bed.press(*press.object, press.X_PO, 1);
    return LawAnswer{contact.force, contact.area, std::sqrt(contact.area / kPi * contact.aspect),
                     contact.torsion,
                     constants.shear * shear_per_modulus(columns, constants, press)};
  });
}

}  // namespace

LawCalibration fit_laws(const PadModel& model, const MeasuredPresses& fit,
                        const MeasuredPresses& check, const LawFitOptions& options) {
  require(fit.presses.size() >= 4 && !check.presses.empty(),
          "laws need at least 4 presses to fit and 1 to check, got {} and {}", fit.presses.size(),
          check.presses.size());
  // Check that presses touch, because logarithms are fitted.
  for (const MeasuredPresses* presses : {&fit, &check})
    for (const MeasuredPress& press : presses->presses)
      require(
          press.force > 0 && press.area > 0 && press.depth > 0 && press.arm > 0 && press.shear > 0,
          "a press by '{}' does not touch the pad", press.trial);
  // Fit the point contact laws.
  LawCalibration out;
  CalibratedLaws& laws = out.laws;
  laws.relaxation = model.tissues.at(0).relaxation;
  Fits fits{fit.presses, ""};
  laws.power = fit_power(fits);
  laws.soft_finger = fit_soft_finger(fits);
  // Fit the bed of springs over the pad's skin; ElasticFoundation uses its mean thickness.
  const FoundationColumns columns = pad_columns(model.shape, options.rings);
  FoundationConstants base;
  const VectorXd thickness = fits.all([&](const MeasuredPress& press) {
    return deepest_skin(PadChart(model.shape), *press.object, press.X_PO).thickness;
  });
  base.thickness = thickness.mean();
  laws.foundation = fit_foundation(fits, columns, base, options);
  // Compute the shear modulus of the springs as a geometric mean.
  laws.foundation.shear = std::exp(
      fits.all([&](const MeasuredPress& press) {
            return std::log(press.shear / shear_per_modulus(columns, laws.foundation, press));
          })
          .mean());
  // Measure errors on presses that were not fitted.
  laws.power_error = error_of(check.presses, PowerLaw(laws.power));
  laws.soft_finger_error = error_of(check.presses, SoftFinger(laws.soft_finger));
  laws.foundation_error = error_of(check.presses, ElasticFoundation(laws.foundation));
  laws.bed_error = error_of(check.presses, columns, laws.foundation);
  // Record the evidence for the laws, and failures.
  laws.evidence.fitted = static_cast<int>(fit.presses.size());
  laws.evidence.checked = static_cast<int>(check.presses.size());
  laws.evidence.depth = fits.all([](const MeasuredPress& p) { return p.depth; }).maxCoeff();
  laws.evidence.force = fits.all([](const MeasuredPress& p) { return p.force; }).maxCoeff();
  laws.evidence.force_error =
      fits.all([](const MeasuredPress& p) { return p.force_error; }).maxCoeff();
  for (const MeasuredPresses* presses : {&fit, &check})
    out.failures.insert(out.failures.end(), presses->failures.begin(), presses->failures.end());
  out.message = fits.stalled;
  if (fits.stalled.empty()) out.status = Status::kSolved;
  return out;
}

}  // namespace thenar
