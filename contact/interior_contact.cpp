#include "contact/interior_contact.h"

#include "base/numbers.h"
#include "base/stop_scope.h"

namespace thenar::internal {
namespace {

using Eigen::Index;
using Eigen::Ref;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Eigen::VectorXd;

constexpr double kBoundaryRatio = 0.99;  // step length over the distance to the boundary [1]
constexpr double kMinCentring = 1e-4, kMaxCentring = 0.5;  // range of target tau over tau [1]
constexpr double kMinCorrectorStep = 0.1;  // predictor step from which it is corrected [1]
// Length below which a step is replaced by one away from the boundary, with this target over tau
constexpr double kShortStep = 0.1, kRecentring = 0.9;
constexpr double kMinDecrease = 1e-3;  // relative decrease of the merit in a full step [1]
constexpr double kMaxGrowth = 2;       // growth factor of tau in a step [1]
constexpr int kMaxHalvings = 12;       // halvings of a step in the line search
constexpr double kFreeProximal =
    1e-12;  // proximal term of unbounded rows, as A may be singular [1]

/// Returns u0^2 - |u1|^2 without cancellation of large squares, positive.
double lorentz_square(const Vector4d& u) {
  const double r = u.tail<3>().norm();
  return std::max((u(0) - r) * (u(0) + r), std::numeric_limits<double>::min());
}

Vector4d jordan_product(const Vector4d& u, const Vector4d& v) {
  Vector4d out;
  out(0) = u.dot(v);
  out.tail<3>() = u(0) * v.tail<3>() + v(0) * u.tail<3>();
  return out;
}

/// Returns the w with u o w = v.
Vector4d jordan_quotient(const Vector4d& u, const Vector4d& v) {
  Vector4d out;
  out(0) = (u(0) * v(0) - u.tail<3>().dot(v.tail<3>())) / lorentz_square(u);
  out.tail<3>() = (v.tail<3>() - out(0) * u.tail<3>()) / u(0);
  return out;
}

Vector4d reflected(const Vector4d& u) { return {u(0), -u(1), -u(2), -u(3)}; }

/// Returns the largest a with u + a d in the cone, at most 1 / kBoundaryRatio.
double max_step_in_cone(const Vector4d& u, const Vector4d& d) {
  // First root a > 0 of the Lorentz form of u + a d, by formulas without cancellation.
  const double a = d(0) * d(0) - d.tail<3>().squaredNorm(),
               b = u(0) * d(0) - u.tail<3>().dot(d.tail<3>()), c = lorentz_square(u);
  double out = 1 / kBoundaryRatio;
  const double discriminant = b * b - a * c;
  if (discriminant >= 0 && (b < 0 || a < 0)) {
    const double root = std::sqrt(discriminant), to = b < 0 ? c / (root - b) : -(b + root) / a;
    if (to > 0) out = std::min(out, to);
  }
  // The first component must stay positive.
  if (d(0) < 0) out = std::min(out, -u(0) / d(0));
  return out;
}

double max_step_above_zero(double gap, double change) {
  return change < 0 ? -gap / change : kInfinity;
}

}  // namespace

Vector4d InteriorContact::times_scaling(const Cone& cone, const Vector4d& u) {
  return cone.beta * (2 * cone.v * cone.v.dot(u) - reflected(u));
}

Vector3d InteriorContact::slip_gradient(const Cone& cone) const {
  if (coupling_ == Coupling::kFrozen) return Vector3d::Zero();
  return cone.y.tail<3>() / std::hypot(cone.y.tail<3>().norm(), smoothing_);
}

void InteriorContact::initialize(const ScaledContacts& contacts, const Ref<const VectorXd>& f) {
  const Index n = rows_ = contacts.rows();
  if (n > rhs_.size()) {
    R_.resize(n, n);
    for (VectorXd* v : {&residual_, &rhs_, &f_, &u_}) v->resize(n);
  }
  cones_.clear();
  intervals_.clear();
  // Velocities at f, whose |ut| is used if it is frozen.
  const double size = contacts.scale();
  u_.head(n).noalias() = contacts.A() * f;
  u_.head(n) += contacts.b();
  for (const ScaledBlock& block : contacts.blocks()) {
    if (block.is_cone()) {
      // Cones start on their axis at the scale of the problem.
      Cone cone{block.start, block.rows, block.mu};
      cone.slip = u_.segment(block.start + 1, block.rows - 1).norm();
      cone.x(0) = cone.y(0) = size;
      cones_.push_back(cone);
      continue;
    }
    Interval interval{block.start, block.lower, block.upper};
    // Impulse inside the interval, at most the scale away from its bounds.
    interval.f = std::clamp(0.0, block.lower, block.upper);
    const double half = std::min(size, (block.upper - block.lower) / 2);
    if (interval.has_lower()) interval.f = std::max(interval.f, block.lower + half);
    if (interval.has_upper()) interval.f = std::min(interval.f, block.upper - half);
    if (interval.is_fixed()) interval.f = block.lower;
    // Multipliers of finite bounds start at the scale.
    if (interval.has_lower()) interval.low = size;
    if (interval.has_upper()) interval.high = size;
    intervals_.push_back(interval);
  }
}

/// Returns tau, the mean of x' y of cones and of multiplier times gap of bounds.
double InteriorContact::mean_complementarity() const {
  double sum = 0;
  int count = 0;
  for (const Cone& cone : cones_) {
    sum += cone.x.dot(cone.y);
    ++count;
  }
  for (const Interval& interval : intervals_) {
    if (interval.is_fixed()) continue;
    if (interval.has_lower()) sum += interval.low * (interval.f - interval.lower);
    if (interval.has_upper()) sum += interval.high * (interval.upper - interval.f);
    count += (interval.has_lower() ? 1 : 0) + (interval.has_upper() ? 1 : 0);
  }
  return count > 0 ? sum / count : 0;
}

/// Computes impulses, velocities, residuals of the equations, and tau.
void InteriorContact::update_residuals(const ScaledContacts& contacts) {
  const Index n = contacts.rows();
  // Impulses  fn = x_0 / mu,  ft = x_t,  and their velocities.
  for (const Cone& cone : cones_) {
    f_(cone.start) = cone.x(0) / cone.mu;
    for (int k = 1; k < cone.rows; ++k) f_(cone.start + k) = cone.x(k);
  }
  for (const Interval& interval : intervals_) f_(interval.start) = interval.f;
  u_.head(n).noalias() = contacts.A() * f_.head(n);
  u_.head(n) += contacts.b();

  // Tau, which also smooths |y_t|.
  tau_ = mean_complementarity();
  smoothing_ = tau_ / contacts.scale();

  // Residuals  y - |y_t| e - D u  of cones, and  low - high - u  of intervals.
  for (const Cone& cone : cones_) {
    const int i = cone.start;
    const double slip = coupling_ == Coupling::kFull ? cone.y.tail<3>().norm() : cone.slip;
    residual_(i) = cone.y(0) - slip - u_(i) / cone.mu;
    for (int k = 1; k < cone.rows; ++k) residual_(i + k) = cone.y(k) - u_(i + k);
  }
  for (const Interval& interval : intervals_)
    residual_(interval.start) =
        interval.is_fixed() ? 0 : interval.low - interval.high - u_(interval.start);
  residual_norm_ = residual_.head(n).lpNorm<Eigen::Infinity>();
}

/// Computes the Nesterov-Todd scaling:  W = beta (2 v v' - J),  W x = W^-1 y = lambda.
void InteriorContact::scale_cones() {
  for (Cone& cone : cones_) {
    // Scaling point w of x and y, both divided by their Lorentz length.
    const double y_size = std::sqrt(lorentz_square(cone.y)),
                 x_size = std::sqrt(lorentz_square(cone.x));
    const Vector4d y = cone.y / y_size, x = cone.x / x_size;
    const double gamma = std::sqrt((1 + x.dot(y)) / 2);
    cone.w = (y + reflected(x)) / (2 * gamma);
    // Root of the scaling, v = (w + e) / sqrt(2 (w_0 + 1)), and lambda = W x.
    cone.v = cone.w;
    cone.v(0) += 1;
    cone.v /= std::sqrt(2 * cone.v(0));
    cone.beta = std::sqrt(y_size / x_size);
    cone.lambda = times_scaling(cone, cone.x);
  }
}

/// Assembles and factors the system matrix.
bool InteriorContact::factor(const ScaledContacts& contacts) {
  // D A D: normal rows and columns are divided by mu, as the unknowns are dx.
  const Index n = contacts.rows();
  auto R = R_.topLeftCorner(n, n);
  R = contacts.A();
  for (const Cone& cone : cones_) {
    R.row(cone.start) /= cone.mu;
    R.col(cone.start) /= cone.mu;
  }
  for (const Cone& cone : cones_) {
    // Add  G W^2,  where  G = I - e (y_t / |y_t|)'  is the derivative of  y - |y_t| e.
    const int i = cone.start, rows = cone.rows;
    Eigen::Matrix4d H = 2 * cone.w * cone.w.transpose();
    H.diagonal() -= Vector4d(1, -1, -1, -1);
    H *= cone.beta * cone.beta;
    H.row(0) -= slip_gradient(cone).transpose() * H.bottomRows<3>();
    R.block(i, i, rows, rows) += H.topLeftCorner(rows, rows);
  }
  // Bounds of intervals add multiplier over gap; a fixed row becomes df = 0.
  for (const Interval& interval : intervals_) {
    const int i = interval.start;
    if (interval.is_fixed()) {
      R.row(i).setZero();
      R(i, i) = 1;
      continue;
    }
    if (interval.has_lower()) R(i, i) += interval.low / (interval.f - interval.lower);
    if (interval.has_upper()) R(i, i) += interval.high / (interval.upper - interval.f);
    if (!interval.has_lower() && !interval.has_upper()) R(i, i) += kFreeProximal;
  }
  return lu_.factor(R);
}

/// Sets the right-hand side of the linear system for the target  x o y = target e.
void InteriorContact::set_right_side(double target, SecondOrder second_order) {
  for (Cone& cone : cones_) {
    // Cones:  lambda o rho = target e - lambda o lambda - second-order term.
    Vector4d want = -jordan_product(cone.lambda, cone.lambda);
    if (second_order == SecondOrder::kYes) {
      // W dx and W^-1 dy of the predictor.
      const Vector4d Jv = reflected(cone.v);
      const Vector4d Wdy = (2 * Jv * Jv.dot(cone.dy) - reflected(cone.dy)) / cone.beta;
      want -= jordan_product(times_scaling(cone, cone.dx), Wdy);
    }
    want(0) += target;
    cone.rho = jordan_quotient(cone.lambda, want);
    // rhs = G W rho + rest.
    const Vector4d Wrho = times_scaling(cone, cone.rho);
    rhs_(cone.start) = Wrho(0) - slip_gradient(cone).dot(Wrho.tail<3>()) + residual_(cone.start);
    for (int k = 1; k < cone.rows; ++k) rhs_(cone.start + k) = Wrho(k) + residual_(cone.start + k);
  }
  // Intervals: changes of the multipliers at df = 0.
  for (Interval& interval : intervals_) {
    double& rhs = rhs_(interval.start);
    rhs = residual_(interval.start);
    interval.low_term = interval.high_term = 0;
    if (interval.is_fixed()) continue;
    if (interval.has_lower()) {
      const double second = second_order == SecondOrder::kYes ? interval.df * interval.dlow : 0;
      interval.low_term = (target - second) / (interval.f - interval.lower) - interval.low;
    }
    if (interval.has_upper()) {
      const double second = second_order == SecondOrder::kYes ? -interval.df * interval.dhigh : 0;
      interval.high_term = (target - second) / (interval.upper - interval.f) - interval.high;
    }
    rhs += interval.low_term - interval.high_term;
  }
}

/// Returns the longest step that stays inside the cones and bounds, at most 1.
double InteriorContact::max_step_length() const {
  double out = 1 / kBoundaryRatio;
  for (const Cone& cone : cones_)
    out = std::min({out, max_step_in_cone(cone.x, cone.dx), max_step_in_cone(cone.y, cone.dy)});
  for (const Interval& interval : intervals_) {
    if (interval.is_fixed()) continue;
    if (interval.has_lower())
      out = std::min({out, max_step_above_zero(interval.f - interval.lower, interval.df),
                      max_step_above_zero(interval.low, interval.dlow)});
    if (interval.has_upper())
      out = std::min({out, max_step_above_zero(interval.upper - interval.f, -interval.df),
                      max_step_above_zero(interval.high, interval.dhigh)});
  }
  return std::min(1.0, kBoundaryRatio * out);
}

void InteriorContact::advance(double step) {
  for (Cone& cone : cones_) {
    cone.x += step * cone.dx;
    cone.y += step * cone.dy;
  }
  for (Interval& interval : intervals_) {
    interval.f += step * interval.df;
    interval.low += step * interval.dlow;
    interval.high += step * interval.dhigh;
  }
}

/// Solves the linear system, and computes the changes of all variables.
void InteriorContact::solve_direction() {
  // Changes of the impulses.
  const Index n = rows_;
  lu_.solve(R_.topLeftCorner(n, n), rhs_.head(n));
  // Cones: dy from  W dx + W^-1 dy = rho.
  for (Cone& cone : cones_) {
    cone.dx.head(cone.rows) = rhs_.segment(cone.start, cone.rows);
    cone.dy = times_scaling(cone, cone.rho - times_scaling(cone, cone.dx));
  }
  // Intervals: multipliers from  multiplier times gap = target,  linearised.
  for (Interval& interval : intervals_) {
    if (interval.is_fixed()) continue;
    interval.df = rhs_(interval.start);
    if (interval.has_lower())
      interval.dlow =
          interval.low_term - interval.low / (interval.f - interval.lower) * interval.df;
    if (interval.has_upper())
      interval.dhigh =
          interval.high_term + interval.high / (interval.upper - interval.f) * interval.df;
  }
}

/// Computes a direction by predictor and corrector.
void InteriorContact::compute_direction() {
  // Predictor: target tau = 0.
  set_right_side(0, SecondOrder::kNo);
  solve_direction();
  const double predicted = max_step_length();
  // Corrector: centring by the remaining part of the predictor step; a short predictor has no
  // second-order term.
  const double centring = std::clamp(std::pow(1 - predicted, 3), kMinCentring, kMaxCentring);
  set_right_side(centring * tau_,
                 predicted > kMinCorrectorStep ? SecondOrder::kYes : SecondOrder::kNo);
  solve_direction();
  if (max_step_length() > kShortStep) return;

  // Step blocked by a boundary: a target of almost the present tau leads away from it.
  set_right_side(kRecentring * tau_, SecondOrder::kNo);
  solve_direction();
}

/// Moves along the direction, with the step halved until the merit decreases, or the residual
/// decreases almost as that of a linear system and tau does not grow much.
/// @return false if no step does
bool InteriorContact::line_search(const ScaledContacts& contacts) {
  // Merit: residual of the equations plus tau, both relative.
  const double size = contacts.scale();
  const auto merit = [&] { return residual_norm_ / size + tau_ / (size * size); };
  const double before = merit(), missing = residual_norm_, tau = tau_;
  double length = max_step_length();
  const auto is_down = [&] {
    return merit() <= (1 - kMinDecrease * length) * before ||
           (residual_norm_ <= (1 - length / 2) * missing && tau_ <= kMaxGrowth * tau);
  };
  // Backtracking line search from the longest step.
  advance(length);
  update_residuals(contacts);
  for (int halvings = 0; !is_down(); ++halvings) {
    if (halvings == kMaxHalvings) return false;
    length /= 2;
    advance(-length);
    update_residuals(contacts);
  }
  return true;
}

int InteriorContact::run(const ScaledContacts& contacts, Coupling coupling, int max_steps,
                         double tolerance, Ref<VectorXd> f) {
  const Index n = contacts.rows();
  const double size = contacts.scale();
  coupling_ = coupling;
  initialize(contacts, f);
  update_residuals(contacts);
  double min_residual = kInfinity;
  for (int step = 0; step < max_steps; ++step) {
    // Stop when equations and complementarity have converged.
    if (tau_ <= tolerance * size * size && residual_norm_ <= tolerance * size) return step;
    end_if_stopped();
    // Newton direction with Nesterov-Todd scaling, then the line search.
    scale_cones();
    if (!factor(contacts)) return step;
    compute_direction();
    const bool moved = line_search(contacts);

    // Keep the best impulses, or with frozen |ut|, a different problem, the last ones.
    const double natural = contacts.residual(f_.head(n), u_.head(n));
    if (natural < min_residual || coupling == Coupling::kFrozen) {
      min_residual = natural;
      f = f_.head(n);
    }
    if (!moved) return step + 1;
  }
  return max_steps;
}

}  // namespace thenar::internal
