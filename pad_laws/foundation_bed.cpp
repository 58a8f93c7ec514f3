#include "pad_laws/foundation_bed.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/error.h"
#include "base/numbers.h"
#include "base/units.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr std::size_t kReservedTouches = 256;  // columns for which memory is reserved
constexpr double kMinHistoryForce = 1e-12;     // force below which history is dropped [N]
constexpr Index kLeafColumns = 12;             // columns of a leaf of the tree, tested together
constexpr double kLevelSlope = 1e-3;           // least slope between the surfaces [1]
// Least cosine of the normals of object and skin on the object's far side [1]
constexpr double kFarSideCosine = 0.5;
// Margin below the friction cone within which a column slips, over the cone's bound [1]
constexpr double kStickMargin = 1e-6;

void check_pose(const Pose<double>& X, double friction) {
  require(X.R.allFinite() && X.p.allFinite(), "the pose of an object on a pad must be finite");
  require(friction >= 0 && std::isfinite(friction), "friction must be finite and >= 0, got {}",
          friction);
}

/// Returns the columns of a matrix in another order.
template <typename Matrix>
Matrix sorted(const Matrix& columns, const std::vector<Index>& order) {
  Matrix out(columns.rows(), columns.cols());
  for (std::size_t i = 0; i < order.size(); ++i) out.col(i) = columns.col(order[i]);
  return out;
}

/// Forces of a column's history at the end of a step.
struct PastForces {
  double normal = 0;           // normal force [N]
  Vector3d friction{0, 0, 0};  // friction on the skin [N] (3)
};

PastForces past_forces(Index i, const MemoryStep& weights, const BedState& state) {
  PastForces past;
  for (std::size_t j = 0; j < weights.decay.size(); ++j) {
    past.normal += weights.decay[j] * state.terms(j, i) - weights.change[j] * state.elastic[i];
    past.friction += weights.decay[j] * state.shear_terms.block<3, 1>(3 * j, i) -
                     weights.change[j] * state.shear.col(i);
  }
  return past;
}

/// Advances a column's elastic forces and its history terms to the end of a step.
/// @return whether a history term is above kMinHistoryForce
bool advance_history(Index i, const MemoryStep& weights, double elastic, const Vector3d& shear,
                     BedState& state) {
  bool remains = false;
  for (std::size_t j = 0; j < weights.decay.size(); ++j) {
    state.terms(j, i) =
        weights.decay[j] * state.terms(j, i) + weights.change[j] * (elastic - state.elastic[i]);
    state.shear_terms.block<3, 1>(3 * j, i) =
        weights.decay[j] * state.shear_terms.block<3, 1>(3 * j, i) +
        weights.change[j] * (shear - state.shear.col(i));
    remains = remains || std::abs(state.terms(j, i)) > kMinHistoryForce ||
              state.shear_terms.block<3, 1>(3 * j, i).norm() > kMinHistoryForce;
  }
  state.elastic[i] = elastic;
  state.shear.col(i) = shear;
  return remains;
}

}  // namespace

FoundationBed::FoundationBed(FoundationColumns columns, const FoundationConstants& constants,
                             std::vector<ExponentialTerm> terms)
    : columns_(std::move(columns)), constants_(constants), terms_(std::move(terms)) {
  check_foundation(constants_);
  check_exponential_terms(terms_, "a bed of springs");
  const Index count = columns_.skin.cols();
  require(count > 0 && columns_.normal.cols() == count && columns_.thickness.size() == count &&
              columns_.area.size() == count,
          "columns of a bed have {} places, {} normals, {} thicknesses and {} areas", count,
          columns_.normal.cols(), columns_.thickness.size(), columns_.area.size());
  for (Index i = 0; i < count; ++i)
    require(columns_.thickness[i] > 0 && columns_.area[i] > 0 &&
                std::isfinite(columns_.thickness[i] + columns_.area[i]) &&
                columns_.skin.col(i).allFinite() &&
                std::abs(columns_.normal.col(i).norm() - 1) < 1e-9,
            "column {} of a bed needs a finite place, a unit normal, a thickness and an area above "
            "0, got {} m and {} m^2",
            i, columns_.thickness[i], columns_.area[i]);
  // Set the reach: a column whose middle is up to half its width apart may touch partly.
  reach_ = 0.5 * std::sqrt(columns_.area.maxCoeff());
  // Sort columns by leaves of a tree, so that neighbours lie together in memory.
  std::vector<Index> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), Index{0});
  split(order, 0, count);
  columns_.skin = sorted(columns_.skin, order);
  columns_.normal = sorted(columns_.normal, order);
  columns_.thickness = sorted(columns_.thickness.transpose().eval(), order).transpose();
  columns_.area = sorted(columns_.area.transpose().eval(), order).transpose();
  width_ = columns_.area.cwiseSqrt();
}

// NOLINTNEXTLINE(misc-no-recursion): halves each time
void FoundationBed::split(std::vector<Index>& order, Index first, Index end) {
  Eigen::AlignedBox3d box;
  for (Index i = first; i < end; ++i) box.extend(Vector3d(columns_.skin.col(order[i])));
  // Store few columns as a leaf with a bounding ball.
  if (end - first <= kLeafColumns) {
    double radius = 0;
    for (Index i = first; i < end; ++i)
      radius = std::max(radius, (columns_.skin.col(order[i]) - box.center()).norm());
    leaves_.push_back({box.center(), radius, first, end});
    return;
  }
  // Otherwise halve at the median along the longest side.
  Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const Index middle = (first + end) / 2;
  std::nth_element(
      order.begin() + first, order.begin() + middle, order.begin() + end,
      [&](Index a, Index b) { return columns_.skin(axis, a) < columns_.skin(axis, b); });
  split(order, first, middle);
  split(order, middle, end);
}

FoundationBed::Touches FoundationBed::touches(const Shape& object, const Pose<double>& X_PO) const {
  Touches found;
  found.columns.reserve(kReservedTouches);
  const Pose<double> X_OP = X_PO.inverse();
  const double reach = reach_ + object.accuracy();
  double least = kInfinity;
  for (const Leaf& leaf : leaves_) {
    // Use a leaf out of reach only to bound the gap.
    const double apart = object.distance(X_OP * leaf.centre) - leaf.radius;
    if (apart > reach) {
      least = std::min(least, apart - object.accuracy());
      continue;
    }
    // Collect columns with their overlap, minus the distance of the middle from the object.
    for (Index i = leaf.first; i < leaf.end; ++i) {
      const NearestSurface near = object.nearest(X_OP * Vector3d(columns_.skin.col(i)));
      least = std::min(least, near.distance);
      if (near.distance > reach_) continue;
      found.deepest = std::max(found.deepest, -near.distance);
      found.columns.push_back({i, -near.distance, X_PO.R * near.normal});
    }
  }
  found.gap = std::max(0.0, least);
  // Let the skin sink beside the object,  delta = deepest - spread (deepest - overlap),  and keep
  // columns with delta > 0.
  std::size_t kept = 0;
  if (found.deepest > 0)
    for (Touch& touch : found.columns) {
      touch.delta = found.deepest - constants_.spread * (found.deepest - touch.delta);
      found.area += columns_.area[touch.column] * area_share(touch);
      if (touch.delta > 0) found.columns[kept++] = touch;
    }
  found.columns.resize(kept);
  if (found.area > 0) found.surround_share = constants_.surround / std::sqrt(found.area / kPi);
  return found;
}

/// Returns the share of a column within the patch, whose rim is where delta is 0. Delta decreases
/// with the angle between the surfaces.
double FoundationBed::area_share(const Touch& touch) const {
  // Compute the decrease of delta over one column from the angle between the surfaces.
  const double along = touch.normal.dot(columns_.normal.col(touch.column));
  const double slope = std::max(kLevelSlope, std::sqrt(std::max(0.0, 1 - along * along)));
  const double fall = constants_.spread * slope * width_[touch.column];
  return std::clamp(0.5 + touch.delta / fall, 0.0, 1.0);
}

/// Computes the sums over columns. @param forces  normal forces [N] (touches)
void FoundationBed::sum_contact(const Touches& found, const VectorXd& forces, double friction,
                                BedContact& contact) const {
  contact.depth = found.deepest;
  contact.gap = found.gap;
  if (found.deepest <= 0) return;
  contact.area = found.area;
  // Sum the wrench of the normal forces; find the largest strain and pressed far sides.
  Matrix3Xd points(3, forces.size());
  for (std::size_t k = 0; k < found.columns.size(); ++k) {
    const Touch& touch = found.columns[k];
    points.col(k) = columns_.skin.col(touch.column);
    if (forces[k] <= 0) continue;
    contact.behind =
        contact.behind || touch.normal.dot(columns_.normal.col(touch.column)) > kFarSideCosine;
    const Vector3d push = forces[k] * touch.normal;
    contact.push += wrench_of_force(points.col(k), push);
    contact.normal += push;
    contact.strain = std::max(contact.strain, touch.delta / columns_.thickness[touch.column]);
  }
  // Compute force, centre, aspect and mean arm of the pressure about its mean normal.
  contact.normal = contact.normal.stableNormalized();
  const PressureMoments moments = pressure_moments(points, forces, contact.normal);
  contact.force = moments.force;
  contact.centre = moments.centre;
  contact.aspect = moments.aspect;
  contact.torsion = friction * moments.arm;
}

BedContact FoundationBed::press(const Shape& object, const Pose<double>& X_PO,
                                double friction) const {
  check_pose(X_PO, friction);
  const Touches found = touches(object, X_PO);
  BedContact contact;
  // Compute the instantaneous force of each column, which surrounding tissue raises by c h / r.
  VectorXd forces(static_cast<Index>(found.columns.size()));
  for (std::size_t k = 0; k < found.columns.size(); ++k) {
    const Index i = found.columns[k].column;
    const double h = columns_.thickness[i];
    const SpringPressure spring = spring_pressure(constants_, found.columns[k].delta / h);
    forces[k] = columns_.area[i] * spring.pressure * (1 + found.surround_share * h);
    contact.energy += columns_.area[i] * h * spring.energy;
  }
  sum_contact(found, forces, friction, contact);
  return contact;
}

void FoundationBed::initialize(BedState& state) const {
  const Index count = columns_.skin.cols(), terms = static_cast<Index>(terms_.size());
  // Initialize an empty state at rest.
  if (state.elastic.size() == 0) {
    state.elastic = state.normal_force = VectorXd::Zero(count);
    state.terms = Eigen::MatrixXd::Zero(terms, count);
    state.shear = state.anchor = state.shear_force = Matrix3Xd::Zero(3, count);
    state.shear_terms = Eigen::MatrixXd::Zero(3 * terms, count);
    state.touching.assign(static_cast<std::size_t>(count), false);
    state.remembers = state.touching;
  }
  require(state.elastic.size() == count && state.terms.rows() == terms,
          "the state is of another bed, of {} columns and {} terms", state.elastic.size(),
          state.terms.rows());
}

BedContact FoundationBed::step(const Shape& object, const Pose<double>& X_PO, double friction,
                               double seconds, BedState& state) const {
  check_pose(X_PO, friction);
  initialize(state);
  const StepInputs inputs{X_PO, X_PO.inverse(), friction, memory_step(terms_, seconds)};
  const Touches found = touches(object, X_PO);
  BedContact contact;
  VectorXd forces = VectorXd::Zero(found.columns.size());
  double stuck = 0;
  Wrench friction_wrench;
  // Step all touched columns, which are in the order of all columns, and those with a history.
  std::size_t next = 0;
  for (Index i = 0; i < columns_.skin.cols(); ++i) {
    const std::size_t k = next;
    const bool near = k < found.columns.size() && found.columns[k].column == i;
    if (near) ++next;
    if (!near && !state.remembers[i]) continue;
    // Compute the elastic force of the spring, 0 where nothing touches it.
    const double h = columns_.thickness[i], area = columns_.area[i];
    SpringPressure spring;
    if (near) spring = spring_pressure(constants_, found.columns[k].delta / h);
    contact.energy += area * h * spring.energy;
    const bool sticks =
        move_column(i, area * spring.pressure * (1 + found.surround_share * h),
                    near ? found.columns[k].normal : Vector3d(0, 0, 0), inputs, state);
    // Sum the sticking force and the wrench of friction over columns in contact.
    if (!state.touching[i]) continue;
    forces[k] = state.normal_force[i];
    if (sticks) stuck += state.normal_force[i];
    friction_wrench += wrench_of_force(columns_.skin.col(i), state.shear_force.col(i));
  }
  // Compute normal forces and patch, and add friction.
  sum_contact(found, forces, friction, contact);
  contact.push += friction_wrench;
  contact.stick = contact.force > 0 ? stuck / contact.force : 0;
  return contact;
}

bool FoundationBed::move_column(Index i, double elastic, const Vector3d& n,
                                const StepInputs& inputs, BedState& state) const {
  const double now = inputs.weights.now;
  const PastForces past = past_forces(i, inputs.weights, state);
  const double force = now * elastic + past.normal;
  const bool touches = elastic > 0 && force > 0;
  // A free column has the elastic forces that cancel its history.
  ColumnFriction friction{-past.friction / now};
  if (touches)
    friction = stick_or_slip(i, n, force, past.friction, inputs, state);
  else
    elastic = std::max(0.0, -past.normal / now);
  state.remembers[i] =
      advance_history(i, inputs.weights, elastic, friction.elastic, state) || touches;
  state.normal_force[i] = touches ? force : 0;
  state.shear_force.col(i) = friction.force;
  state.touching[i] = touches;
  return friction.sticks;
}

FoundationBed::ColumnFriction FoundationBed::stick_or_slip(Index i, const Vector3d& n, double force,
                                                           Vector3d past, const StepInputs& inputs,
                                                           BedState& state) const {
  if (!state.touching[i]) state.anchor.col(i) = inputs.X_OP * Vector3d(columns_.skin.col(i));
  // Compute the trial force of a column that sticks to its anchor on the object.
  const double spring = constants_.shear * columns_.area[i] / columns_.thickness[i];
  const double limit = inputs.friction * force;
  const Vector3d displacement =
      inputs.X_PO * Vector3d(state.anchor.col(i)) - Vector3d(columns_.skin.col(i));
  past -= n * n.dot(past);
  ColumnFriction out{spring * (displacement - n * n.dot(displacement))};
  out.force = inputs.weights.now * out.elastic + past;
  out.sticks = out.force.norm() < (1 - kStickMargin) * limit;
  // If it slips, scale friction back to the cone, and move the anchor to where the spring agrees.
  if (out.force.norm() > limit) {
    out.force *= limit / out.force.norm();
    out.elastic = (out.force - past) / inputs.weights.now;
    if (spring > 0)
      state.anchor.col(i) =
          inputs.X_OP * Vector3d(Vector3d(columns_.skin.col(i)) + out.elastic / spring);
  }
  return out;
}

}  // namespace thenar
