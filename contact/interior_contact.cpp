#include "contact/interior_contact.h"

#include <cmath>

#include "base/numbers.h"
#include "base/stop_scope.h"

namespace thenar::internal {
namespace {

using Eigen::Index;
using Eigen::Ref;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Eigen::VectorXd;

// Share of the way to the boundary of the cones that a step takes [1]
constexpr double kToBoundary = 0.99;
// Least and largest share of tau at which a step aims [1]
constexpr double kLeastCentring = 1e-4, kMostCentring = 0.5;
// Step of the predictor from which its square is corrected [1]
constexpr double kCorrectFrom = 0.1;
// A shorter step is replaced by one away from the walls, aimed at this share of tau [1]
constexpr double kShortStep = 0.1, kAwayFromWalls = 0.9;
constexpr double kLeastFall = 1e-3;  // Least relative fall of the merit for a whole step [1]
constexpr double kMostGrowth = 2;    // Largest growth of tau in a step [1]
constexpr int kMostHalvings = 12;

/// u0^2 - |u1|^2 without cancellation of large squares.
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

/// The w with u o w = v.
Vector4d jordan_quotient(const Vector4d& u, const Vector4d& v) {
  Vector4d out;
  out(0) = (u(0) * v(0) - u.tail<3>().dot(v.tail<3>())) / lorentz_square(u);
  out.tail<3>() = (v.tail<3>() - out(0) * u.tail<3>()) / u(0);
  return out;
}

Vector4d mirrored(const Vector4d& u) { return {u(0), -u(1), -u(2), -u(3)}; }

/// Largest a with u + a d in the cone, at most 1 / kToBoundary.
double step_in_cone(const Vector4d& u, const Vector4d& d) {
  // First root a > 0 of  |u + a d|^2 = 0  in Lorentz's form, by formulas without cancellation.
  const double a = d(0) * d(0) - d.tail<3>().squaredNorm(),
               b = u(0) * d(0) - u.tail<3>().dot(d.tail<3>()), c = lorentz_square(u);
  double out = 1 / kToBoundary;
  const double discriminant = b * b - a * c;
  if (discriminant >= 0 && (b < 0 || a < 0)) {
    const double root = std::sqrt(discriminant), to = b < 0 ? c / (root - b) : -(b + root) / a;
    if (to > 0) out = std::min(out, to);
  }
  // The first component must stay positive.
  if (d(0) < 0) out = std::min(out, -u(0) / d(0));
  return out;
}

double step_above_zero(double gap, double change) { return change < 0 ? -gap / change : kInfinity; }

}  // namespace

Vector4d InteriorContact::times_scaling(const Cone& cone, const Vector4d& u) {
  return cone.beta * (2 * cone.v * cone.v.dot(u) - mirrored(u));
}

bool InteriorContact::Interval::has_lower() const { return std::isfinite(lower); }
bool InteriorContact::Interval::has_upper() const { return std::isfinite(upper); }

Vector3d InteriorContact::slope(const Cone& cone) const {
  if (coupling_ == Coupling::kFrozen) return Vector3d::Zero();
  return cone.y.tail<3>() / std::hypot(cone.y.tail<3>().norm(), smooth_);
}

void InteriorContact::start(const ScaledContacts& contacts, const Ref<const VectorXd>& f) {
  const Index n = rows_ = contacts.rows();
  if (n > rhs_.size()) {
    R_.resize(n, n);
    for (VectorXd* v : {&rest_, &rhs_, &f_, &u_}) v->resize(n);
  }
  cones_.clear();
  intervals_.clear();
  // Velocities at f, whose |ut| is kept where the coupling is frozen.
  const double size = contacts.scale();
  u_.head(n).noalias() = contacts.A() * f;
  u_.head(n) += contacts.b();
  for (const ScaledBlock& block : contacts.blocks()) {
    if (block.is_cone()) {
      // Cones start on their axis, at the scale of the problem.
      Cone cone;
      cone.start = block.start;
      cone.rows = block.rows;
      cone.mu = block.mu;
      cone.slip = u_.segment(block.start + 1, block.rows - 1).norm();
      cone.x(0) = cone.y(0) = size;
      cones_.push_back(cone);
      continue;
    }
    Interval interval;
    interval.start = block.start;
    interval.lower = block.lower;
    interval.upper = block.upper;
    // Impulse in the middle of the interval, but no farther from an end than the scale.
    interval.f = std::clamp(0.0, block.lower, block.upper);
    const double half = std::min(size, (block.upper - block.lower) / 2);
    if (interval.has_lower()) interval.f = std::max(interval.f, block.lower + half);
    if (interval.has_upper()) interval.f = std::min(interval.f, block.upper - half);
    if (interval.is_fixed()) interval.f = block.lower;
    // Multipliers of finite ends start at the scale.
    if (interval.has_lower()) interval.low = size;
    if (interval.has_upper()) interval.high = size;
    intervals_.push_back(interval);
  }
}

/// tau: the mean of x' y of cones and of multiplier times gap of ends.
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

/// Impulses, velocities, what the equations miss, and tau.
void InteriorContact::measure(const ScaledContacts& contacts) {
  const Index n = contacts.rows();
  // Impulses  fn = x_0 / mu,  ft = x_t,  and their velocities.
  for (const Cone& cone : cones_) {
    f_(cone.start) = cone.x(0) / cone.mu;
    for (int k = 1; k < cone.rows; ++k) f_(cone.start + k) = cone.x(k);
  }
  for (const Interval& interval : intervals_) f_(interval.start) = interval.f;
  u_.head(n).noalias() = contacts.A() * f_.head(n);
  u_.head(n) += contacts.b();

  // First tau, because it smooths |y_t|.
  tau_ = mean_complementarity();
  smooth_ = tau_ / contacts.scale();

  // Residuals  y - |y_t| e - D u  of cones, and  low - high - u  of intervals.
  missing_ = 0;
  for (const Cone& cone : cones_) {
    const int i = cone.start;
    const double slip = coupling_ == Coupling::kFull ? cone.y.tail<3>().norm() : cone.slip;
    rest_(i) = cone.y(0) - slip - u_(i) / cone.mu;
    for (int k = 1; k < cone.rows; ++k) rest_(i + k) = cone.y(k) - u_(i + k);
  }
  for (const Interval& interval : intervals_)
    rest_(interval.start) =
        interval.is_fixed() ? 0 : interval.low - interval.high - u_(interval.start);
  missing_ = rest_.head(n).lpNorm<Eigen::Infinity>();
}

/// Points of Nesterov and Todd:  W = beta (2 v v' - J),  W x = W^-1 y = lambda.
void InteriorContact::scale_cones() {
  for (Cone& cone : cones_) {
    // Scaling point w of x and y, both divided by their Lorentz length.
    const double y_size = std::sqrt(lorentz_square(cone.y)),
                 x_size = std::sqrt(lorentz_square(cone.x));
    const Vector4d y = cone.y / y_size, x = cone.x / x_size;
    const double gamma = std::sqrt((1 + x.dot(y)) / 2);
    cone.w = (y + mirrored(x)) / (2 * gamma);
    // Root of the scaling, v = (w + e) / sqrt(2 (w_0 + 1)), and lambda = W x.
    cone.v = cone.w;
    cone.v(0) += 1;
    cone.v /= std::sqrt(2 * cone.v(0));
    cone.beta = std::sqrt(y_size / x_size);
    cone.lambda = times_scaling(cone, cone.x);
  }
}

bool InteriorContact::factor(const ScaledContacts& contacts) {
  // System matrix D A D: normal rows and columns are over mu, as the unknowns are dx.
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
    H.row(0) -= slope(cone).transpose() * H.bottomRows<3>();
    R.block(i, i, rows, rows) += H.topLeftCorner(rows, rows);
  }
  // Ends of intervals add multiplier over gap; a fixed row becomes df = 0.
  for (const Interval& interval : intervals_) {
    const int i = interval.start;
    if (interval.is_fixed()) {
      R.row(i).setZero();
      R(i, i) = 1;
      continue;
    }
    if (interval.has_lower()) R(i, i) += interval.low / (interval.f - interval.lower);
    if (interval.has_upper()) R(i, i) += interval.high / (interval.upper - interval.f);
    // Free rows get a proximal 1e-12, because A may be singular.
    if (!interval.has_lower() && !interval.has_upper()) R(i, i) += 1e-12;
  }
  return lu_.factor(R);
}

/// Right side of the linear system towards  x o y = target e.
void InteriorContact::set_right_side(double target, Corrected corrected) {
  for (Cone& cone : cones_) {
    // Cones:  lambda o rho = target e - lambda o lambda - second-order term.
    Vector4d want = -jordan_product(cone.lambda, cone.lambda);
    if (corrected == Corrected::kYes) {
      // W dx and W^-1 dy of the predictor.
      const Vector4d Jv = mirrored(cone.v);
      const Vector4d Wdy = (2 * Jv * Jv.dot(cone.dy) - mirrored(cone.dy)) / cone.beta;
      want -= jordan_product(times_scaling(cone, cone.dx), Wdy);
    }
    want(0) += target;
    cone.rho = jordan_quotient(cone.lambda, want);
    // rhs = G W rho + rest.
    const Vector4d Wrho = times_scaling(cone, cone.rho);
    rhs_(cone.start) = Wrho(0) - slope(cone).dot(Wrho.tail<3>()) + rest_(cone.start);
    for (int k = 1; k < cone.rows; ++k) rhs_(cone.start + k) = Wrho(k) + rest_(cone.start + k);
  }
  // Intervals: changes of the multipliers at df = 0, which the linear system completes.
  for (Interval& interval : intervals_) {
    double& rhs = rhs_(interval.start);
    rhs = rest_(interval.start);
    interval.low_term = interval.high_term = 0;
    if (interval.is_fixed()) continue;
    if (interval.has_lower()) {
      const double second = corrected == Corrected::kYes ? interval.df * interval.dlow : 0;
      interval.low_term = (target - second) / (interval.f - interval.lower) - interval.low;
    }
    if (interval.has_upper()) {
      const double second = corrected == Corrected::kYes ? -interval.df * interval.dhigh : 0;
      interval.high_term = (target - second) / (interval.upper - interval.f) - interval.high;
    }
    rhs += interval.low_term - interval.high_term;
  }
}

double InteriorContact::longest_step() const {
  // Distance to the nearest boundary, over cones, gaps and multipliers.
  double out = 1 / kToBoundary;
  for (const Cone& cone : cones_)
    out = std::min({out, step_in_cone(cone.x, cone.dx), step_in_cone(cone.y, cone.dy)});
  for (const Interval& interval : intervals_) {
    if (interval.is_fixed()) continue;
    if (interval.has_lower())
      out = std::min({out, step_above_zero(interval.f - interval.lower, interval.df),
                      step_above_zero(interval.low, interval.dlow)});
    if (interval.has_upper())
      out = std::min({out, step_above_zero(interval.upper - interval.f, -interval.df),
                      step_above_zero(interval.high, interval.dhigh)});
  }
  return std::min(1.0, kToBoundary * out);
}

void InteriorContact::move(double step) {
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

/// Solves the linear system, and what it leaves to the other variables.
void InteriorContact::take_direction() {
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

/// Predictor, centring by how far it may go, corrector where that is far enough.
void InteriorContact::find_step() {
  // Predictor: aim at tau = 0 and see how far the step may go.
  set_right_side(0, Corrected::kNo);
  take_direction();
  const double free = longest_step();
  // Centring by the cube of what the predictor leaves; a short predictor is not corrected.
  const double centring = std::clamp(std::pow(1 - free, 3), kLeastCentring, kMostCentring);
  set_right_side(centring * tau_, free > kCorrectFrom ? Corrected::kYes : Corrected::kNo);
  take_direction();
  if (longest_step() > kShortStep) return;

  // Blocked by a boundary: aim at almost the present tau, which leads away from it.
  set_right_side(kAwayFromWalls * tau_, Corrected::kNo);
  take_direction();
}

/// Halves the step until the equations and tau have fallen together, or the equations for
/// themselves about as a linear system's would, while tau has not grown much; false where none
/// does.
bool InteriorContact::move_down(const ScaledContacts& contacts) {
  // Merit: residual of the equations and tau, both relative.
  const double size = contacts.scale();
  const auto merit = [&] { return missing_ / size + tau_ / (size * size); };
  const double before = merit(), missing = missing_, tau = tau_;
  double length = longest_step();
  const auto is_down = [&] {
    return merit() <= (1 - kLeastFall * length) * before ||
           (missing_ <= (1 - length / 2) * missing && tau_ <= kMostGrowth * tau);
  };
  // Backtracking line search from the longest step.
  move(length);
  measure(contacts);
  for (int halvings = 0; !is_down(); ++halvings) {
    if (halvings == kMostHalvings) return false;
    length /= 2;
    move(-length);
    measure(contacts);
  }
  return true;
}

int InteriorContact::run(const ScaledContacts& contacts, Coupling coupling, int max_steps,
                         double tolerance, Ref<VectorXd> f) {
  const Index n = contacts.rows();
  const double size = contacts.scale();
  coupling_ = coupling;
  start(contacts, f);
  measure(contacts);
  double least = kInfinity;
  for (int step = 0; step < max_steps; ++step) {
    // Converged in equations and complementarity.
    if (tau_ <= tolerance * size * size && missing_ <= tolerance * size) return step;
    end_if_stopped();
    // Newton direction in Nesterov and Todd's scaling, then the line search.
    scale_cones();
    if (!factor(contacts)) return step;
    find_step();
    const bool moved = move_down(contacts);

    // Keep the best impulses; a frozen problem keeps the last, because its residual is another.
    const double natural = contacts.residual(f_.head(n), u_.head(n));
    if (natural < least || coupling == Coupling::kFrozen) {
      least = natural;
      f = f_.head(n);
    }
    if (!moved) return step + 1;
  }
  return max_steps;
}

}  // namespace thenar::internal
