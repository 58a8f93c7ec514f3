#include "tendons/net/net_descent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

constexpr double kCarriedGap = 1e-9;  // Starts deeper than this are pushed out of the bone [m]
constexpr double kLyingGap = 2e-5;    // Starts within this gap are tried as lying on the bone [m]
constexpr double kHardPull = 10;      // Pull at which taut nets swing freely [N]

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
  // Bones that the node touches, or lies in.
  NodeContact& touch = here_.contact[k];
  touch.pressed = touch.touching = 0;
  touch.collapsed = 0;
  double depth = 0;
  for (int s : node.surfaces) {
    const double gap = gap_world(plan_.net, scene_, s, here_.x[i]).gap;
    depth = std::min(depth, gap);
    if (std::abs(gap) <= kLyingGap && touch.pressed < 3) touch.surface[touch.pressed++] = s;
  }
  // Moved out of the bones; if this fails it keeps its place.
  const Vector3d before = here_.x[i];
  if (!project_node(plan_.net, scene_, node, here_.x[i], touch)) {
    here_.x[i] = before;
    touch.pressed = touch.touching = 0;
  }
  if (depth < -kCarriedGap) pushed_out_.push_back(i);
}

void NetDescent::place(const TreeState<double>& state, const Eigen::Matrix3Xd* start) {
  // Nodes with their links, or where the start has them.
  for (std::size_t i = 0; i < here_.x.size(); ++i) {
    const NetNode& node = plan_.net.nodes[i];
    here_.x[i] = node.free && start ? Vector3d(start->col(static_cast<Eigen::Index>(i)))
                                    : moved(state, node.link, node.p);
  }
  // Floating nodes come out of the bones.
  pushed_out_.clear();
  for (int k = 0; k < rows(); ++k) project_start(k);
  next_.x = here_.x;
}

void NetDescent::accept() { std::swap(here_, next_); }

void NetDescent::measure(Place& at) {
  evaluate(plan_, scene_, at.x, at.E);
  ++evaluations_;
}

NetStatus NetDescent::descend(int patience) {
  definite_ = false;
  radius_ = kMaxStep;
  for (iterations_ = 0;; ++iterations_) {
    // Forces left out of balance, and collapsed nodes that their pull no longer holds.
    balance();
    if (release_from_exit()) {
      measure(here_);
      balance();
    }
    // Balanced: update the multipliers, then tell a minimum from a saddle.
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
    // Otherwise another Newton step.
    if (iterations_ >= patience) return NetStatus::kStalled;
    if (leave_saddle_early()) continue;
    if (!direction() || !line_search()) return NetStatus::kStalled;
  }
}

/// One descent from where the nodes are given.
NetStatus NetDescent::settle(const TreeState<double>& state, const NetDrive& drive,
                             const Eigen::Matrix3Xd* start, int patience) {
  scene_ = pose_scene(plan_.net, state, drive);
  collapse_counts_.assign(plan_.bands.size(), 0);
  place(state, start);
  measure(here_);
  return descend(patience);
}

/// Weak pulls swing a taut net like a linkage, in steps as short as (8 pull L^2 / stiffness)^(1/3):
/// where that is too slow, the net is first pulled hard, and then ten times less each time.
NetStatus NetDescent::load_continuation(const TreeState<double>& state, const NetDrive& drive) {
  const double most = drive.tension.size() > 0 ? drive.tension.maxCoeff() : 0;
  // Pulls ten times less each time, the last one as asked.
  if (!(most > 0) || most > kHardPull) return NetStatus::kStalled;
  const std::vector<int> pushed_out = pushed_out_;
  int spent = iterations_;
  NetStatus status = NetStatus::kStalled;
  for (double times = kHardPull / most; times > 0;
       times = times == 1 ? 0 : std::max(times / 10, 1.0)) {
    // Start from the nodes of the pull before.
    Eigen::Matrix3Xd from(3, static_cast<Eigen::Index>(here_.x.size()));
    for (std::size_t i = 0; i < here_.x.size(); ++i)
      from.col(static_cast<Eigen::Index>(i)) = here_.x[i];
    const int patience = times == 1 ? options_.max_iterations : options_.max_iterations / 5;
    status = settle(state, {times * drive.tension, drive.length, drive.law}, &from, patience);
    spent += iterations_;
  }
  // The answer counts all steps and the nodes of the first placement.
  iterations_ = spent;
  pushed_out_ = pushed_out;
  return status;
}

NetEquilibrium NetDescent::run(const TreeState<double>& state, const NetDrive& drive,
                               const Eigen::Matrix3Xd* start) {
  evaluations_ = 0;
  // Half of the steps directly; then from strong pulls; then the rest of the steps.
  NetStatus status = settle(state, drive, start, options_.max_iterations / 2);
  if (status == NetStatus::kStalled && far_side_bands().empty())
    status = load_continuation(state, drive);
  if (status == NetStatus::kStalled && far_side_bands().empty())
    status = descend(options_.max_iterations);
  return report(status);
}

// What presses the nodes of a net on the bones, and what is left out of balance.

namespace {

// Least lift from a bone that doubles can distinguish from none [m]
constexpr double kNoLift = 1e-11;
constexpr double kLiftRounding = 1e-17;  // Rounding of a lift [m]

}  // namespace

/// Returns the force with which bands that bend over a surface hold a node on it, at the least lift
/// that its place can resolve [N]: their slope along the normal grows as  sqrt(2 lift / radius)
/// times their tension S, and rounding of the lift by kLiftRounding changes it by S kLiftRounding /
/// sqrt(2 lift radius).
double NetDescent::wrap_slop(int k, int surface) const {
  // Tensions of the bands that bend over this surface.
  double sum = 0;
  for (int b : plan_.wrapping_bands[k]) {
    const NetBand& band = plan_.net.bands[b];
    if (band.over != surface) continue;
    const BandState now = band_state(plan_.net, scene_, b, here_.x[band.a], here_.x[band.b]);
    if (now.chord.bent) sum += now.pull.tension;
  }
  // Slop of the lift, at least what rounding makes of it.
  const double radius = plan_.net.surfaces[surface].size[0];
  return sum * std::max(std::sqrt(2 * kNoLift / radius),
                        4 * kLiftRounding * sum / (options_.tolerance * radius));
}

/// The part along the normal of what bands that bend over a surface pull a node on it with: they
/// leave along the surface, so all of it is rounding of the node's lift, the same as in here_.E.g
/// [N].
double NetDescent::normal_rounding(int k, int surface, const Vector3d& normal) const {
  double sum = 0;
  // Bands over this surface, in closed form where they bend.
  for (int b : plan_.wrapping_bands[k]) {
    const NetBand& band = plan_.net.bands[b];
    BandGeometry run;
    if (band.over != surface || scene_.collapsed[b]) continue;
    const WrapState bend = wrap_over(scene_.bone[b], here_.x[band.a], here_.x[band.b], run);
    if (bend == WrapState::kStraight) continue;
    // A degenerate wrap: by its string.
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
    // Normal forces within the tolerance.
    const Vector3d& x = here_.x[plan_.node[k]];
    std::array<double, 3> slop{};
    slop.fill(options_.tolerance);
    const int touching = c.touching;
    balance_node(plan_.net, scene_, x, here_.E.g[k], slop, c);
    // A node that lets go of a bone may be held by bands that bend over it.
    if (c.pressed < touching && !plan_.wrapping_bands[k].empty()) {
      for (int i = 0; i < touching; ++i) slop[i] += wrap_slop(k, c.surface[i]);
      balance_node(plan_.net, scene_, x, here_.E.g[k], slop, c);
    }
    residual_ = std::max(residual_, c.residual.norm());
  }
}

// In which direction the nodes of a net go down, by Newton.

using Eigen::Matrix3d;

/// H - sum force curvature, turned so that pressed normals come first, and these pinned.
void NetDescent::reduce() {
  for (int k = 0; k < rows(); ++k) {
    const NodeContact& c = here_.contact[k];
    Matrix3d& D = reduced_.diagonal[k];
    // Turned Hessian of the Lagrangian.
    D = c.Q * (here_.E.H.diagonal[k] - c.curvature) * c.Q.transpose();
    double scale = here_.E.H.diagonal[k].trace();
    if (scale <= 0) scale = 1, D.setIdentity();  // nothing holds it: it stays
    // Pinned directions keep a unit row of the same size.
    for (int r = 0; r < c.pinned; ++r) {
      D.row(r).setZero();
      D.col(r).setZero();
      D(r, r) = scale;
    }
  }
  // The same for blocks between two nodes.
  for (int s = 0; s < plan_.pattern.blocks(); ++s) {
    const auto [i, j] = plan_.pattern.rows_of(s);
    Matrix3d& B = reduced_.off[s];
    B = here_.contact[i].Q * here_.E.H.off[s] * here_.contact[j].Q.transpose();
    B.topRows(here_.contact[i].pinned).setZero();
    B.leftCols(here_.contact[j].pinned).setZero();
  }
}

/// Solves for the step. @return the longest move of a node [m]
double NetDescent::solve_step() {
  // Forces along the free directions.
  for (int k = 0; k < rows(); ++k) {
    step_[k] = -(here_.contact[k].Q * here_.E.g[k]);
    step_[k].head(here_.contact[k].pinned).setZero();
  }
  factor_.solve(step_);
  // Back to world axes.
  double longest = 0;
  for (int k = 0; k < rows(); ++k) {
    step_[k] = here_.contact[k].Q.transpose() * step_[k].eval();
    longest = std::max(longest, step_[k].norm());
  }
  return longest;
}

/// Newton's step, shifted where the stiffness is not positive definite or the step leaves the
/// radius within which the last steps were good.
bool NetDescent::direction() {
  // Factor; semidefinite to rounding is good enough.
  reduce();
  definite_ = factor_.factorise(reduced_, 0);
  largest_move_ = std::numeric_limits<double>::infinity();
  if (definite_ || factor_.factorise(reduced_, options_.tolerance / kStiffnessDistance, 1e-9))
    largest_move_ = solve_step();
  // Shift the stiffness until the step stays within the radius.
  for (double shift = 0.1 * residual_ / radius_; largest_move_ > radius_; shift *= 4) {
    if (!(shift < 1e30)) return false;
    if (factor_.factorise(reduced_, shift)) largest_move_ = solve_step();
  }
  return true;
}

/// Gives the bands that a too long step stretches the secant stiffness over it, slack bands too, so
/// that the next direction accounts for them.
/// @return whether there were any
bool NetDescent::add_secant_stiffness() {
  bool any = false;
  for (int b = 0; b < static_cast<int>(plan_.bands.size()); ++b) {
    // Tension and length that the step has added.
    const double more = next_.E.tension[b] - here_.E.tension[b],
                 dL = next_.E.length[b] - here_.E.length[b];
    if (scene_.pull[b] >= 0 || !(more > 0) || !(dL > 0)) continue;
    const BandPlan& at = plan_.bands[b];
    const NetBand& band = plan_.net.bands[b];
    // Secant stiffness, where it exceeds the tangent one by far.
    const BandState now = band_state(plan_.net, scene_, b, here_.x[band.a], here_.x[band.b]);
    const double k = more / dL - now.pull.stiffness;
    if (!(k > 1e-3 * now.pull.stiffness)) continue;
    // Rank-one terms in the Hessian.
    const Vector3d ua = now.chord.slope.head<3>(), ub = now.chord.slope.tail<3>();
    if (at.ka >= 0) here_.E.H.diagonal[at.ka] += k * ua * ua.transpose();
    if (at.kb >= 0) here_.E.H.diagonal[at.kb] += k * ub * ub.transpose();
    if (at.slot >= 0)
      here_.E.H.off[at.slot] += at.flip ? k * ub * ua.transpose() : k * ua * ub.transpose();
    any = true;
  }
  return any;
}

// How far they go.

namespace {

// Lift over radius below which clasping bands follow the root law [1]
constexpr double kNearLift = 1e-3;
// Steps shorter than this may add the secant stiffness of slack bands [m]
constexpr double kKinkStep = 1e-4;

}  // namespace

/// Corrects Newton's step where bands clasp a node. They pull at its lift h as sqrt(h), so the step
/// dh is taken in sqrt(h), which makes it  h (1 + dh / 2h)^2  and exact.
void NetDescent::lift(int k, Vector3d& there) const {
  const NodeContact& c = here_.contact[k];
  const Vector3d& x = here_.x[plan_.node[k]];
  int before = -1;
  // One surface after the other, those that press already left out.
  for (int b : plan_.wrapping_bands[k]) {
    const int s = plan_.net.bands[b].over;
    const int* last = c.surface.data() + c.pressed;
    if (s == before || std::find(c.surface.data(), last, s) != last) continue;
    before = s;
    // Lift of the node, and Newton's step in it.
    const double radius = plan_.net.surfaces[s].size[0];
    const SurfaceGap at = gap_world(plan_.net, scene_, s, x);
    if (at.gap > kNearLift * radius) continue;
    const double h = std::max(at.gap, 0.5e-14 * radius), dh = at.normal.dot(there - x);
    if (dh <= -2 * h) continue;
    // The correction ends where the root law ends.
    const double more = dh * dh / (4 * h), most = kNearLift * radius;
    if (h + dh + more <= most)
      there += more * at.normal;
    else if (h + dh < most)
      there += (most - h - dh) * at.normal;
  }
}

/// Moves along the step by `part`, staying outside bones; `slope` is that of E along it [J].
bool NetDescent::try_step(double part, double& slope) {
  slope = 0;
  for (int k = 0; k < rows(); ++k) {
    const int i = plan_.node[k];
    // Node and contacts at the end of the step.
    next_.contact[k] = here_.contact[k];
    next_.x[i] = here_.x[i] + part * step_[k];
    // Slope of the energy along the straight step.
    const double straight = part * here_.E.g[k].dot(step_[k]);
    if (here_.contact[k].collapsed > 0 || plan_.net.nodes[i].surfaces.empty()) {
      slope += straight;
      continue;
    }
    // Out of the bones; a node that hits one takes another way.
    if (!plan_.wrapping_bands[k].empty()) lift(k, next_.x[i]);
    if (!project_node(plan_.net, scene_, plan_.net.nodes[i], next_.x[i], next_.contact[k]))
      return false;
    const bool hit = next_.contact[k].touching > here_.contact[k].pressed;
    slope += hit ? here_.E.g[k].dot(next_.x[i] - here_.x[i]) : straight;
  }
  measure(next_);
  return true;
}

/// Part of the step at which the first band of constant pull passes its exit; 1 if none does.
double NetDescent::step_to_exit() const {
  double part = 1;
  for (std::size_t b = 0; b < plan_.bands.size(); ++b) {
    // Bands of constant pull with their ends' relative move.
    if (!(scene_.pull[b] > 0)) continue;
    const BandPlan& at = plan_.bands[b];
    const NetBand& band = plan_.net.bands[b];
    Vector3d move = Vector3d::Zero();
    if (at.ka >= 0) move += step_[at.ka];
    if (at.kb >= 0) move -= step_[at.kb];
    const Vector3d d = here_.x[band.a] - here_.x[band.b];
    if (is_regularised(scene_, static_cast<int>(b), d.norm())) continue;  // it is there
    // Part of the move at which the length would pass zero.
    const double way = -d.dot(move), whole = move.squaredNorm();
    if (way > 0 && way < whole && whole > 0.1 * d.squaredNorm()) part = std::min(part, way / whole);
  }
  return part;
}

/// Returns the largest change of E by rounding of places: tension times the last digits of places
/// [J].
double NetDescent::rounding() const {
  double reach = 0, sum = 0;
  for (const Vector3d& x : here_.x) reach = std::max(reach, x.norm());
  for (double T : here_.E.tension) sum += T;
  return 2e-16 * reach * sum + 1e-15 * here_.E.size;
}

/// Shortens the step until E falls. @return whether it did
bool NetDescent::line_search() {
  // First trial: the whole step, or up to the first exit.
  const double noise = rounding();
  const double exit = step_to_exit();
  double part = exit > 1e-3 && exit < 0.9 ? exit : 1;
  bool at_exit = part < 1;
  int looks = iterations_ % 2 == 0 ? 5 : 0;  // every other time: either way alone may creep
  for (int tries = 0; tries < 60; ++tries) {
    double slope = 0;
    const bool possible = try_step(part, slope);
    // Armijo's condition, up to rounding.
    if (possible && next_.E.energy <= here_.E.energy + 1e-4 * std::min(slope, 0.0) + noise) {
      // Radius for the next step.
      accept();
      if (part < 0.3)
        radius_ =
            std::max({2 * part * largest_move_, 0.1 * std::min(largest_move_, radius_), 1e-7});
      else
        radius_ = std::min(std::max(radius_, 4 * largest_move_), kMaxStep);
      largest_move_ *= part;
      return true;
    }
    // A long first step: bands that it makes taut get their secant stiffness.
    if (part == 1 && possible && largest_move_ < kKinkStep && looks-- > 0 &&
        add_secant_stiffness()) {
      if (!direction()) return false;
      definite_ = false;  // of what it was made to be
      continue;
    }
    // Shorten.
    part = at_exit ? 1 : 0.5 * part;
    at_exit = false;
  }
  return false;
}

}  // namespace thenar::internal
