#include "tendons/net/net_descent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

constexpr double kCarriedGap = 1e-9;  // depth of a start beyond which it is moved out of bone [m]
constexpr double kLyingGap = 2e-5;    // gap of a start within which contact is assumed [m]
constexpr double kHardPull = 10;      // pull at which taut nets converge quickly [N]

}  // namespace

NetDescent::NetDescent(const Net& net, const NetSolverOptions& options)
    : plan_(net),
      options_(options),
      here_(plan_),
      next_(plan_),
      reduced_(plan_.pattern),
      factor_(plan_.pattern),
      step_(plan_.pattern.size()) {}

void NetDescent::project_start(int k) {
  const int i = plan_.node[k];
  const NetNode& node = plan_.net.nodes[i];
  // Find the bones that the node touches or lies in.
  NodeContact& touch = here_.contact[k];
  touch.pressed = touch.touching = 0;
  touch.collapsed = 0;
  double depth = 0;
  for (int s : node.surfaces) {
    const double gap = gap_world(plan_.net, scene_, s, here_.x[i]).gap;
    depth = std::min(depth, gap);
    if (std::abs(gap) <= kLyingGap && touch.pressed < 3) touch.surface[touch.pressed++] = s;
  }
  // Move it out of the bones; restore its position if this fails.
  const Vector3d before = here_.x[i];
  if (!project_node(plan_.net, scene_, node, here_.x[i], touch)) {
    here_.x[i] = before;
    touch.pressed = touch.touching = 0;
  }
  if (depth < -kCarriedGap) pushed_out_.push_back(i);
}

void NetDescent::place(const TreeState<double>& state, const Eigen::Matrix3Xd* start) {
  // Place nodes with their links, or at the given start.
  for (std::size_t i = 0; i < here_.x.size(); ++i) {
    const NetNode& node = plan_.net.nodes[i];
    here_.x[i] = node.free && start ? Vector3d(start->col(static_cast<Eigen::Index>(i)))
                                    : moved(state, node.link, node.p);
  }
  // Move floating nodes out of the bones.
  pushed_out_.clear();
  for (int k = 0; k < rows(); ++k) project_start(k);
  next_.x = here_.x;
}

void NetDescent::measure(Place& at) {
  evaluate(plan_, scene_, at.x, at.E);
  ++evaluations_;
}

NetStatus NetDescent::descend(int patience) {
  definite_ = false;
  radius_ = kMaxStep;
  for (iterations_ = 0;; ++iterations_) {
    // Compute contact forces and residual; release collapsed nodes that their pull cannot hold.
    balance();
    if (release_from_exit()) {
      measure(here_);
      balance();
    }
    // If balanced, update the multipliers, then distinguish a minimum from a saddle.
    if (residual_ <= options_.tolerance) {
      if (update_multipliers()) {
        measure(here_);
        balance();
      } else if (is_minimum()) {
        return NetStatus::kBalanced;
      } else if (iterations_ >= patience || !leave_saddle()) {
        return NetStatus::kUnstable;
      } else {
        continue;
      }
    }
    // Otherwise take a Newton step.
    if (iterations_ >= patience) return NetStatus::kStalled;
    if (leave_saddle_early()) continue;
    if (!direction() || !line_search()) return NetStatus::kStalled;
  }
}

/// Descends once from the given nodes.
NetStatus NetDescent::settle(const TreeState<double>& state, const NetDrive& drive,
                             const Eigen::Matrix3Xd* start, int patience) {
  scene_ = pose_scene(plan_.net, state, drive);
  collapse_counts_.assign(plan_.bands.size(), 0);
  place(state, start);
  measure(here_);
  return descend(patience);
}

/// Descends under strong pulls first, then each time ten times weaker: weak pulls move a taut net
/// like a linkage, in steps as short as (8 pull L^2 / stiffness)^(1/3), which may be too slow.
NetStatus NetDescent::load_continuation(const TreeState<double>& state, const NetDrive& drive) {
  const double most = drive.tension.size() > 0 ? drive.tension.maxCoeff() : 0;
  // Reduce the pulls tenfold each time, down to the given ones.
  if (!(most > 0) || most > kHardPull) return NetStatus::kStalled;
  const std::vector<int> pushed_out = pushed_out_;
  int spent = iterations_;
  NetStatus status = NetStatus::kStalled;
  for (double times = kHardPull / most; times > 0;
       times = times == 1 ? 0 : std::max(times / 10, 1.0)) {
    // Start from the nodes under the previous pull.
    Eigen::Matrix3Xd from(3, static_cast<Eigen::Index>(here_.x.size()));
    for (std::size_t i = 0; i < here_.x.size(); ++i)
      from.col(static_cast<Eigen::Index>(i)) = here_.x[i];
    const int patience = times == 1 ? options_.max_iterations : options_.max_iterations / 5;
    status = settle(state, {times * drive.tension, drive.length, drive.law}, &from, patience);
    spent += iterations_;
  }
  // Report all steps, and the nodes of the first placement.
  iterations_ = spent;
  pushed_out_ = pushed_out;
  return status;
}

NetEquilibrium NetDescent::run(const TreeState<double>& state, const NetDrive& drive,
                               const Eigen::Matrix3Xd* start) {
  evaluations_ = 0;
  // Use half of the steps directly; then start from strong pulls; then use the remaining steps.
  NetStatus status = settle(state, drive, start, options_.max_iterations / 2);
  if (status == NetStatus::kStalled && far_side_bands().empty())
    status = load_continuation(state, drive);
  if (status == NetStatus::kStalled && far_side_bands().empty())
    status = descend(options_.max_iterations);
  return report(status);
}

// Contact forces on nodes, and the residual.

namespace {

// Smallest lift from a bone that double precision resolves [m]
constexpr double kMinLift = 1e-11;
constexpr double kLiftRounding = 1e-17;  // rounding error of a lift [m]

}  // namespace

/// Computes the force with which bands that bend over a surface hold a node on it, at the smallest
/// lift that its position resolves [N]: their slope along the normal grows as  sqrt(2 lift /
/// radius) times their tension S, and rounding of the lift by kLiftRounding changes it by S
/// kLiftRounding / sqrt(2 lift radius).
double NetDescent::wrap_slop(int k, int surface) const {
  // Sum the tensions of the bands that bend over this surface.
  double sum = 0;
  for (int b : plan_.wrapping_bands[k]) {
    const NetBand& band = plan_.net.bands[b];
    if (band.over != surface) continue;
    const BandState now = band_state(plan_.net, scene_, b, here_.x[band.a], here_.x[band.b]);
    if (now.chord.bent) sum += now.pull.tension;
  }
  // Convert them to a force by the lift, or by its rounding if larger.
  const double radius = plan_.net.surfaces[surface].size[0];
  return sum * std::max(std::sqrt(2 * kMinLift / radius),
                        4 * kLiftRounding * sum / (options_.tolerance * radius));
}

/// Computes the normal component of the forces of bands that bend over a surface, on a node on it
/// [N]: they leave along the surface, so all of it is rounding of the node's lift, as in here_.E.g.
double NetDescent::normal_rounding(int k, int surface, const Vector3d& normal) const {
  double sum = 0;
  // Sum the bands over this surface, in closed form where they bend.
  for (int b : plan_.wrapping_bands[k]) {
    const NetBand& band = plan_.net.bands[b];
    BandGeometry run;
    if (band.over != surface || scene_.collapsed[b]) continue;
    const WrapState bend = wrap_over(scene_.bone[b], here_.x[band.a], here_.x[band.b], run);
    if (bend == WrapState::kStraight) continue;
    // Use the string of a degenerate wrap.
    if (bend == WrapState::kDegenerate) {
      const WrappedString chord =
          band_state(plan_.net, scene_, b, here_.x[band.a], here_.x[band.b]).chord;
      if (!chord.bent) continue;
      run.ua = chord.slope.head<3>(), run.ub = chord.slope.tail<3>();
    }
    sum += here_.E.tension[b] * normal.dot(plan_.bands[b].ka == k ? run.ua : run.ub);
  }
  return sum;
}

void NetDescent::balance() {
  residual_ = 0;
  for (int k = 0; k < rows(); ++k) {
    NodeContact& c = here_.contact[k];
    // Balance the node with normal forces down to minus the tolerance.
    const Vector3d& x = here_.x[plan_.node[k]];
    std::array<double, 3> slop{};
    slop.fill(options_.tolerance);
    const int touching = c.touching;
    balance_node(plan_.net, scene_, x, here_.E.g[k], slop, c);
    // Balance again a node that lifts off but may be held by bands that bend over the bone.
    if (c.pressed < touching && !plan_.wrapping_bands[k].empty()) {
      for (int i = 0; i < touching; ++i) slop[i] += wrap_slop(k, c.surface[i]);
      balance_node(plan_.net, scene_, x, here_.E.g[k], slop, c);
    }
    residual_ = std::max(residual_, c.residual.norm());
  }
}

// Newton direction.

using Eigen::Matrix3d;

/// Builds the reduced Hessian: H - sum force curvature, rotated so that pressed normals come first,
/// and pinned there.
void NetDescent::reduce() {
  for (int k = 0; k < rows(); ++k) {
    const NodeContact& c = here_.contact[k];
    Matrix3d& D = reduced_.diagonal[k];
    // Rotate the Hessian of the Lagrangian.
    D = c.Q * (here_.E.H.diagonal[k] - c.curvature) * c.Q.transpose();
    double scale = here_.E.H.diagonal[k].trace();
    if (scale <= 0) scale = 1, D.setIdentity();  // no stiffness: the node stays
    // Replace pinned directions by a scaled unit row.
    for (int r = 0; r < c.pinned; ++r) {
      D.row(r).setZero();
      D.col(r).setZero();
      D(r, r) = scale;
    }
  }
  // Reduce the blocks between two nodes.
  for (int s = 0; s < plan_.pattern.blocks(); ++s) {
    const auto [i, j] = plan_.pattern.rows_of(s);
    Matrix3d& B = reduced_.off[s];
    B = here_.contact[i].Q * here_.E.H.off[s] * here_.contact[j].Q.transpose();
    B.topRows(here_.contact[i].pinned).setZero();
    B.leftCols(here_.contact[j].pinned).setZero();
  }
}

/// Solves for the step. @return largest move of a node [m]
double NetDescent::solve_step() {
  // Project the forces on the free directions.
  for (int k = 0; k < rows(); ++k) {
    step_[k] = -(here_.contact[k].Q * here_.E.g[k]);
    step_[k].head(here_.contact[k].pinned).setZero();
  }
  factor_.solve(step_);
  // Rotate the step back to world axes.
  double longest = 0;
  for (int k = 0; k < rows(); ++k) {
    step_[k] = here_.contact[k].Q.transpose() * step_[k].eval();
    longest = std::max(longest, step_[k].norm());
  }
  return longest;
}

/// Computes Newton's step, with a shift where the stiffness is not positive definite or the step
/// exceeds the trust radius.
bool NetDescent::direction() {
  // Factor the stiffness; accept a semidefinite one to rounding.
  reduce();
  definite_ = factor_.factorise(reduced_, 0);
  largest_move_ = std::numeric_limits<double>::infinity();
  if (definite_ || factor_.factorise(reduced_, options_.tolerance / kStiffnessDistance, 1e-9))
    largest_move_ = solve_step();
  // Increase the shift until the step is within the trust radius.
  for (double shift = 0.1 * residual_ / radius_; largest_move_ > radius_; shift *= 4) {
    if (!(shift < 1e30)) return false;
    if (factor_.factorise(reduced_, shift)) largest_move_ = solve_step();
  }
  return true;
}

/// Adds the secant stiffness over a too long step to the bands that it stretches, slack bands too,
/// so that the next direction accounts for them.
/// @return whether there were any
bool NetDescent::add_secant_stiffness() {
  bool any = false;
  for (int b = 0; b < static_cast<int>(plan_.bands.size()); ++b) {
    // Compute the increase of tension and length over the step.
    const double more = next_.E.tension[b] - here_.E.tension[b],
                 dL = next_.E.length[b] - here_.E.length[b];
    if (scene_.pull[b] >= 0 || !(more > 0) || !(dL > 0)) continue;
    const BandPlan& at = plan_.bands[b];
    const NetBand& band = plan_.net.bands[b];
    // Use the secant stiffness where it clearly exceeds the tangent one.
    const BandState now = band_state(plan_.net, scene_, b, here_.x[band.a], here_.x[band.b]);
    const double k = more / dL - now.pull.stiffness;
    if (!(k > 1e-3 * now.pull.stiffness)) continue;
    // Add rank-one terms to the Hessian.
    const Vector3d ua = now.chord.slope.head<3>(), ub = now.chord.slope.tail<3>();
    if (at.ka >= 0) here_.E.H.diagonal[at.ka] += k * ua * ua.transpose();
    if (at.kb >= 0) here_.E.H.diagonal[at.kb] += k * ub * ub.transpose();
    if (at.slot >= 0)
      here_.E.H.off[at.slot] += at.flip ? k * ub * ua.transpose() : k * ua * ub.transpose();
    any = true;
  }
  return any;
}

// Line search.

namespace {

// Lift over radius below which the force of clasping bands grows as sqrt(lift) [1]
constexpr double kNearLift = 1e-3;
// Step length below which the secant stiffness of slack bands may be added [m]
constexpr double kKinkStep = 1e-4;

}  // namespace

/// Corrects Newton's step where bands clasp a node. Their force grows with its lift h as sqrt(h),
/// so the step dh is taken in sqrt(h), which makes it  h (1 + dh / 2h)^2  and exact.
void NetDescent::lift(int k, Vector3d& there) const {
  const NodeContact& c = here_.contact[k];
  const Vector3d& x = here_.x[plan_.node[k]];
  int before = -1;
  // Visit each surface once, except those that press already.
  for (int b : plan_.wrapping_bands[k]) {
    const int s = plan_.net.bands[b].over;
    const int* last = c.surface.data() + c.pressed;
    if (s == before || std::find(c.surface.data(), last, s) != last) continue;
    before = s;
    // Compute the lift of the node and its change.
    const double radius = plan_.net.surfaces[s].size[0];
    const SurfaceGap at = gap_world(plan_.net, scene_, s, x);
    if (at.gap > kNearLift * radius) continue;
    const double h = std::max(at.gap, 0.5e-14 * radius), dh = at.normal.dot(there - x);
    if (dh <= -2 * h) continue;
    // Limit the correction to the range of the root law.
    const double more = dh * dh / (4 * h), most = kNearLift * radius;
    if (h + dh + more <= most)
      there += more * at.normal;
    else if (h + dh < most)
      there += (most - h - dh) * at.normal;
  }
}

/// Moves by the fraction `part` of the step, outside bones.
/// @return linear change of E [J]; none: a node cannot be moved out of a bone
std::optional<double> NetDescent::try_step(double part) {
  double slope = 0;
  for (int k = 0; k < rows(); ++k) {
    const int i = plan_.node[k];
    // Move the node.
    next_.contact[k] = here_.contact[k];
    next_.x[i] = here_.x[i] + part * step_[k];
    // Add the energy change along the straight step.
    const double straight = part * here_.E.g[k].dot(step_[k]);
    if (here_.contact[k].collapsed > 0 || plan_.net.nodes[i].surfaces.empty()) {
      slope += straight;
      continue;
    }
    // Project it out of the bones; use the actual displacement of a node that hits one.
    if (!plan_.wrapping_bands[k].empty()) lift(k, next_.x[i]);
    if (!project_node(plan_.net, scene_, plan_.net.nodes[i], next_.x[i], next_.contact[k]))
      return std::nullopt;
    const bool hit = next_.contact[k].touching > here_.contact[k].pressed;
    slope += hit ? here_.E.g[k].dot(next_.x[i] - here_.x[i]) : straight;
  }
  measure(next_);
  return slope;
}

/// Computes the fraction of the step at which the first band of constant pull passes its exit; 1 if
/// none does.
double NetDescent::step_to_exit() const {
  double part = 1;
  for (std::size_t b = 0; b < plan_.bands.size(); ++b) {
    // Compute the relative move of the ends of a band of constant pull.
    if (!(scene_.pull[b] > 0)) continue;
    const BandPlan& at = plan_.bands[b];
    const NetBand& band = plan_.net.bands[b];
    Vector3d move = Vector3d::Zero();
    if (at.ka >= 0) move += step_[at.ka];
    if (at.kb >= 0) move -= step_[at.kb];
    const Vector3d d = here_.x[band.a] - here_.x[band.b];
    if (is_regularised(scene_, static_cast<int>(b), d.norm())) continue;  // at the exit already
    // Find the fraction at which the length would pass zero.
    const double way = -d.dot(move), whole = move.squaredNorm();
    if (way > 0 && way < whole && whole > 0.1 * d.squaredNorm()) part = std::min(part, way / whole);
  }
  return part;
}

/// Estimates the change of E by rounding of node positions [J].
double NetDescent::rounding() const {
  double reach = 0, sum = 0;
  for (const Vector3d& x : here_.x) reach = std::max(reach, x.norm());
  for (double T : here_.E.tension) sum += T;
  return 2e-16 * reach * sum + 1e-15 * here_.E.size;
}

/// Shortens the step until E decreases. @return whether it did
bool NetDescent::line_search() {
  // Try the whole step first, or up to the first exit.
  const double noise = rounding();
  const double exit = step_to_exit();
  double part = exit > 1e-3 && exit < 0.9 ? exit : 1;
  bool at_exit = part < 1;
  int secant_trials = iterations_ % 2 == 0
                          ? 5
                          : 0;  // on alternate iterations: either method alone may converge slowly
  for (int tries = 0; tries < 60; ++tries) {
    const std::optional<double> slope = try_step(part);
    // Test Armijo's condition, up to rounding.
    if (slope && next_.E.energy <= here_.E.energy + 1e-4 * std::min(*slope, 0.0) + noise) {
      // Accept, and update the trust radius.
      std::swap(here_, next_);
      if (part < 0.3)
        radius_ =
            std::max({2 * part * largest_move_, 0.1 * std::min(largest_move_, radius_), 1e-7});
      else
        radius_ = std::min(std::max(radius_, 4 * largest_move_), kMaxStep);
      largest_move_ *= part;
      return true;
    }
    // Add the secant stiffness of bands that a long first step makes taut.
    if (part == 1 && slope && largest_move_ < kKinkStep && secant_trials-- > 0 &&
        add_secant_stiffness()) {
      if (!direction()) return false;
      definite_ = false;  // the Hessian is modified
      continue;
    }
    // Shorten the step.
    part = at_exit ? 1 : 0.5 * part;
    at_exit = false;
  }
  return false;
}

}  // namespace thenar::internal
