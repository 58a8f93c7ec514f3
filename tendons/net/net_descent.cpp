#include "tendons/net/net_descent.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tendons/net/world_surface.h"

namespace thenar::internal {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kCarried = 1e-9;  // gap of a start that counts as lying on the bone [m]
constexpr double kLongest = 0.02;  // longest move of a node in one step [m]
constexpr double kLift = 1e-11;    // lift from a bone that no number here can tell from none [m]
constexpr double kNear = 1e-3;     // lift over radius below which clasping bands go as its root [1]
constexpr double kDigit = 1e-17;   // rounding of a lift [m]
constexpr double kCut = 1e-6;      // angle from the half-plane opposite to a band's side [rad]
constexpr double kHard = 10;       // pull at which taut nets swing freely [N]
constexpr double kSoft = 1e-4;   // a push beyond the tolerance within this counts as stiffness [m]
constexpr double kKinks = 1e-4;  // steps below which slack bands that become taut decide [m]
constexpr double kDrawn = 1e-9;  // length at which a pull has drawn its node in [m]

}  // namespace

NetDescent::NetDescent(const Net& net, const NetSolverOptions& options)
    : plan_(net),
      options_(options),
      at_(plan_),
      next_(plan_),
      reduced_(plan_.pattern),
      factor_(plan_.pattern),
      x_(net.nodes.size()),
      x_next_(net.nodes.size()),
      step_(plan_.pattern.size()),
      contact_(plan_.pattern.size()),
      contact_next_(plan_.pattern.size()) {}

void NetDescent::settle_start(int k) {
  const int i = plan_.node[k];
  const NetNode& node = plan_.net.nodes[i];
  NodeContact& touch = contact_[k];
  touch.pressed = touch.touching = 0;
  touch.drawn = 0;
  double depth = 0;
  for (int s : node.surfaces) {
    const double gap = gap_world(plan_.net, scene_, s, x_[i]).gap;
    depth = std::min(depth, gap);
    if (std::abs(gap) <= kCarried && touch.pressed < 3) touch.surface[touch.pressed++] = s;
  }
  const Vector3d before = x_[i];
  if (!settle_node(plan_.net, scene_, node, x_[i], touch)) {
    x_[i] = before;
    touch.pressed = touch.touching = 0;
  }
  if (depth < -kCarried) pushed_out_.push_back(i);
}

void NetDescent::place(const TreeState<double>& state, const Eigen::Matrix3Xd* start) {
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const NetNode& node = plan_.net.nodes[i];
    x_[i] = node.free && start ? Vector3d(start->col(static_cast<Eigen::Index>(i)))
                               : moved(state, node.link, node.p);
  }
  pushed_out_.clear();
  for (int k = 0; k < rows(); ++k) settle_start(k);
  x_next_ = x_;
}

/// What bands that bend over a surface hold a node on it with, at the least lift that its place can
/// tell: their slope along the normal grows as  sqrt(2 lift / radius)  times their tension S, and
/// rounding of the lift by kDigit changes it by S kDigit / sqrt(2 lift radius).
double NetDescent::clasp(int k, int surface) const {
  double sum = 0;
  for (int b : plan_.clasps[k]) {
    const NetBand& band = plan_.net.bands[b];
    if (band.over != surface) continue;
    const BandState now = band_state(plan_.net, scene_, b, x_[band.a], x_[band.b]);
    if (now.chord.bent) sum += now.pull.tension;
  }
  const double radius = plan_.net.surfaces[surface].size[0];
  return sum *
         std::max(std::sqrt(2 * kLift / radius), 4 * kDigit * sum / (options_.tolerance * radius));
}

/// The part along the normal of what bands that bend over a surface pull a node on it with: they
/// leave along the surface, so all of it is rounding of the node's lift, the same as in at_.g [N].
double NetDescent::stray(int k, int surface, const Vector3d& normal) const {
  double sum = 0;
  for (int b : plan_.clasps[k]) {
    const NetBand& band = plan_.net.bands[b];
    BandRun run;
    if (band.over != surface || scene_.drawn[b]) continue;
    const Bend bend = bend_over(scene_.bone[b], x_[band.a], x_[band.b], run);
    if (bend == Bend::kClear) continue;
    if (bend == Bend::kOdd) {
      const Chord chord = band_state(plan_.net, scene_, b, x_[band.a], x_[band.b]).chord;
      if (!chord.bent) continue;
      run.ua = chord.slope.head<3>(), run.ub = chord.slope.tail<3>();
    }
    sum += at_.tension[b] * normal.dot(plan_.bands[b].ka == k ? run.ua : run.ub);
  }
  return sum;
}

void NetDescent::balance() {
  residual_ = 0;
  for (int k = 0; k < rows(); ++k) {
    NodeContact& c = contact_[k];
    const Vector3d& x = x_[plan_.node[k]];
    std::array<double, 3> slop{};
    slop.fill(options_.tolerance);
    const int touching = c.touching;
    balance_node(plan_.net, scene_, x, at_.g[k], slop, c);
    if (c.pressed < touching && !plan_.clasps[k].empty()) {
      for (int i = 0; i < touching; ++i) slop[i] += clasp(k, c.surface[i]);
      balance_node(plan_.net, scene_, x, at_.g[k], slop, c);
    }
    residual_ = std::max(residual_, c.left.norm());
  }
}

/// H - sum force curvature, turned so that pressed normals come first, and these pinned.
void NetDescent::reduce() {
  for (int k = 0; k < rows(); ++k) {
    const NodeContact& c = contact_[k];
    Matrix3d& D = reduced_.diagonal[k];
    D = c.Q * (at_.H.diagonal[k] - c.bend) * c.Q.transpose();
    double scale = at_.H.diagonal[k].trace();
    if (scale <= 0) scale = 1, D.setIdentity();  // nothing holds it: it stays
    for (int r = 0; r < c.pinned; ++r) {
      D.row(r).setZero();
      D.col(r).setZero();
      D(r, r) = scale;
    }
  }
  for (int s = 0; s < plan_.pattern.blocks(); ++s) {
    const auto [i, j] = plan_.pattern.rows_of(s);
    Matrix3d& B = reduced_.off[s];
    B = contact_[i].Q * at_.H.off[s] * contact_[j].Q.transpose();
    B.topRows(contact_[i].pinned).setZero();
    B.leftCols(contact_[j].pinned).setZero();
  }
}

/// Solves for the step. @return the longest move of a node [m]
double NetDescent::solve_step() {
  for (int k = 0; k < rows(); ++k) {
    step_[k] = -(contact_[k].Q * at_.g[k]);
    step_[k].head(contact_[k].pinned).setZero();
  }
  factor_.solve(step_);
  double longest = 0;
  for (int k = 0; k < rows(); ++k) {
    step_[k] = contact_[k].Q.transpose() * step_[k].eval();
    longest = std::max(longest, step_[k].norm());
  }
  return longest;
}

/// Newton's step, shifted where the stiffness is not positive definite or the step leaves the
/// radius within which the last steps were good.
bool NetDescent::direction() {
  reduce();
  definite_ = factor_.factorise(reduced_, 0);
  longest_ = std::numeric_limits<double>::infinity();
  if (definite_ || factor_.factorise(reduced_, options_.tolerance / kSoft, 1e-9))
    longest_ = solve_step();
  for (double shift = 0.1 * residual_ / radius_; longest_ > radius_; shift *= 4) {
    if (!(shift < 1e30)) return false;
    if (factor_.factorise(reduced_, shift)) longest_ = solve_step();
  }
  return true;
}

/// Where bands clasp a node, its lift h is pulled at as sqrt(h): Newton's step dh is taken in
/// sqrt(h), which makes it  h (1 + dh / 2h)^2  and exact.
void NetDescent::lift(int k, Vector3d& there) const {
  const NodeContact& c = contact_[k];
  const Vector3d& x = x_[plan_.node[k]];
  int before = -1;
  for (int b : plan_.clasps[k]) {
    const int s = plan_.net.bands[b].over;
    const int* last = c.surface.data() + c.pressed;
    if (s == before || std::find(c.surface.data(), last, s) != last) continue;
    before = s;
    const double radius = plan_.net.surfaces[s].size[0];
    const SurfaceGap at = gap_world(plan_.net, scene_, s, x);
    if (at.gap > kNear * radius) continue;
    const double h = std::max(at.gap, 0.5e-14 * radius), dh = at.normal.dot(there - x);
    if (dh <= -2 * h) continue;
    const double more = dh * dh / (4 * h), most = kNear * radius;
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
    contact_next_[k] = contact_[k];
    x_next_[i] = x_[i] + part * step_[k];
    const double straight = part * at_.g[k].dot(step_[k]);
    if (contact_[k].drawn > 0 || plan_.net.nodes[i].surfaces.empty()) {
      slope += straight;
      continue;
    }
    if (!plan_.clasps[k].empty()) lift(k, x_next_[i]);
    if (!settle_node(plan_.net, scene_, plan_.net.nodes[i], x_next_[i], contact_next_[k]))
      return false;
    const bool hit = contact_next_[k].touching > contact_[k].pressed;
    slope += hit ? at_.g[k].dot(x_next_[i] - x_[i]) : straight;
  }
  evaluate(plan_, scene_, x_next_, next_);
  return true;
}

void NetDescent::accept() {
  x_.swap(x_next_);
  contact_.swap(contact_next_);
  std::swap(at_, next_);
}

/// Part of the step at which the first band of constant pull passes its exit; 1 if none does.
double NetDescent::part_at_exit() const {
  double part = 1;
  for (std::size_t b = 0; b < plan_.bands.size(); ++b) {
    if (!(scene_.pull[b] > 0)) continue;
    const BandPlan& at = plan_.bands[b];
    const NetBand& band = plan_.net.bands[b];
    Vector3d move = Vector3d::Zero();
    if (at.ka >= 0) move += step_[at.ka];
    if (at.kb >= 0) move -= step_[at.kb];
    const Vector3d d = x_[band.a] - x_[band.b];
    if (gripped(scene_, static_cast<int>(b), d.norm())) continue;  // it is there
    const double way = -d.dot(move), whole = move.squaredNorm();
    if (way > 0 && way < whole && whole > 0.1 * d.squaredNorm()) part = std::min(part, way / whole);
  }
  return part;
}

/// What rounding of places may change E by: tension times the last digits of places [J].
double NetDescent::rounding() const {
  double reach = 0, sum = 0;
  for (const Vector3d& x : x_) reach = std::max(reach, x.norm());
  for (double T : at_.tension) sum += T;
  return 2e-16 * reach * sum + 1e-15 * at_.size;
}

/// After a step too long: bands that it stretches get the stiffness that they show over it, slack
/// ones too, so that the next direction knows them. @return whether there were any
bool NetDescent::look_ahead() {
  bool any = false;
  for (int b = 0; b < static_cast<int>(plan_.bands.size()); ++b) {
    const double more = next_.tension[b] - at_.tension[b], dL = next_.length[b] - at_.length[b];
    if (scene_.pull[b] >= 0 || !(more > 0) || !(dL > 0)) continue;
    const BandPlan& at = plan_.bands[b];
    const NetBand& band = plan_.net.bands[b];
    const BandState now = band_state(plan_.net, scene_, b, x_[band.a], x_[band.b]);
    const double k = more / dL - now.pull.stiffness;
    if (!(k > 1e-3 * now.pull.stiffness)) continue;
    const Vector3d ua = now.chord.slope.head<3>(), ub = now.chord.slope.tail<3>();
    if (at.ka >= 0) at_.H.diagonal[at.ka] += k * ua * ua.transpose();
    if (at.kb >= 0) at_.H.diagonal[at.kb] += k * ub * ub.transpose();
    if (at.slot >= 0)
      at_.H.off[at.slot] += at.flip ? k * ub * ua.transpose() : k * ua * ub.transpose();
    any = true;
  }
  return any;
}

/// Shortens the step until E falls. @return whether it did
bool NetDescent::search() {
  const double noise = rounding();
  const double exit = part_at_exit();
  double part = exit > 1e-3 && exit < 0.9 ? exit : 1;
  bool at_exit = part < 1;
  int looks = iterations_ % 2 == 0 ? 5 : 0;  // every other time: either way alone may creep
  for (int tries = 0; tries < 60; ++tries) {
    double slope = 0;
    const bool possible = try_step(part, slope);
    if (possible && next_.energy <= at_.energy + 1e-4 * std::min(slope, 0.0) + noise) {
      accept();
      if (part < 0.3)
        radius_ = std::max({2 * part * longest_, 0.1 * std::min(longest_, radius_), 1e-7});
      else
        radius_ = std::min(std::max(radius_, 4 * longest_), kLongest);
      longest_ *= part;
      return true;
    }
    if (part == 1 && possible && longest_ < kKinks && looks-- > 0 && look_ahead()) {
      if (!direction()) return false;
      definite_ = false;  // of what it was made to be
      continue;
    }
    part = at_exit ? 1 : 0.5 * part;
    at_exit = false;
  }
  return false;
}

/// Puts the free end of a band of constant pull into its exit, if the other end is fixed and the
/// exit is outside of bones. @return whether it did
bool NetDescent::draw_in(int b) {
  const BandPlan& at = plan_.bands[b];
  const NetBand& band = plan_.net.bands[b];
  if ((at.ka >= 0) == (at.kb >= 0) || draws_[b] > 2) return false;
  const int k = std::max(at.ka, at.kb), i = plan_.node[k];
  const Vector3d exit = x_[at.ka >= 0 ? band.b : band.a];
  for (int s : plan_.net.nodes[i].surfaces)
    if (gap_world(plan_.net, scene_, s, exit).gap < 0) return false;
  x_[i] = exit;
  contact_[k].drawn += scene_.pull[b];
  contact_[k].touching = contact_[k].pressed = 0;
  scene_.drawn[b] = true;
  ++draws_[b];
  return true;
}

/// Lets go of nodes that more than their pull drags out of an exit. @return whether there were any
bool NetDescent::let_out() {
  bool any = false;
  for (std::size_t b = 0; b < plan_.bands.size(); ++b) {
    if (!scene_.drawn[b]) continue;
    NodeContact& c = contact_[std::max(plan_.bands[b].ka, plan_.bands[b].kb)];
    if (c.left.norm() <= options_.tolerance) continue;
    scene_.drawn[b] = false;
    any = true;
  }
  for (std::size_t b = 0; any && b < plan_.bands.size(); ++b) {
    const int k = std::max(plan_.bands[b].ka, plan_.bands[b].kb);
    if (k < 0) continue;  // between two bones
    NodeContact& c = contact_[k];
    if (c.drawn > 0 && !scene_.drawn[b] && c.left.norm() > options_.tolerance) c.drawn = 0;
  }
  return any;
}

/// Notes the force of bands of constant pull that have no length. @return whether one changed
bool NetDescent::grip() {
  bool changed = false;
  for (int b = 0; b < static_cast<int>(plan_.bands.size()); ++b) {
    const NetBand& band = plan_.net.bands[b];
    const Vector3d d = x_[band.a] - x_[band.b];
    if (scene_.drawn[b] || !gripped(scene_, b, d.norm())) continue;
    Vector3d p = scene_.hold[b] + scene_.grip[b] * d;
    const double excess = p.norm() / scene_.pull[b];
    if (excess < 1 && draw_in(b)) {
      changed = true;
      continue;
    }
    if (excess > 1) p /= excess;
    if (excess > 1 && d.norm() * scene_.grip[b] > scene_.pull[b]) p.setZero();
    if ((p - scene_.hold[b]).norm() < 0.1 * options_.tolerance) continue;
    scene_.hold[b] = p;
    changed = true;
  }
  return changed;
}

/// Whether no small move lowers E: positive curvature, but for rounding, in all free directions.
bool NetDescent::steady() {
  if (definite_ && longest_ < 1e-6) return true;
  reduce();
  return factor_.factorise(reduced_, options_.tolerance / kSoft, 1e-9);
}

/// Leaves a saddle along a direction of negative curvature.
bool NetDescent::escape() {
  if (!factor_.negative_direction(step_)) return false;
  double longest = 0;
  for (int k = 0; k < rows(); ++k) {
    step_[k] = contact_[k].Q.transpose() * step_[k].eval();
    longest = std::max(longest, step_[k].norm());
  }
  const double noise = 1e-14 * at_.size;
  for (double size = 1e-3; size > 1e-7; size *= 0.3)
    for (double way : {size, -size}) {
      double slope = 0;
      if (!try_step(way / longest, slope) || next_.energy > at_.energy - noise) continue;
      accept();
      return true;
    }
  return false;
}

/// Steps on a ridge shrink as they near a saddle: leaves it before. @return whether it did
bool NetDescent::leave_ridge() {
  if (definite_ || iterations_ == 0 || longest_ > 1e-6 || residual_ <= options_.tolerance)
    return false;
  reduce();
  if (factor_.factorise(reduced_, options_.tolerance / kSoft, 1e-9) || !escape()) return false;
  definite_ = true;
  return true;
}

NetStatus NetDescent::descend(int patience) {
  definite_ = false;
  radius_ = kLongest;
  for (iterations_ = 0;; ++iterations_) {
    balance();
    if (let_out()) {
      evaluate(plan_, scene_, x_, at_);
      balance();
    }
    if (residual_ <= options_.tolerance) {
      if (grip()) {
        evaluate(plan_, scene_, x_, at_);
        balance();
      } else if (steady()) {
        return NetStatus::kBalanced;
      } else if (!escape()) {
        return NetStatus::kUnstable;
      } else {
        continue;
      }
    }
    if (iterations_ >= patience) return NetStatus::kStalled;
    if (leave_ridge()) continue;
    if (!direction() || !search()) return NetStatus::kStalled;
  }
}

/// Bands over cylinders with an end on the half-plane opposite to their side, where their length
/// jumps.
std::vector<int> NetDescent::wound() const {
  std::vector<int> found;
  for (std::size_t b = 0; b < plan_.bands.size(); ++b) {
    const RoundBone& bone = scene_.bone[b];
    if (plan_.net.bands[b].over < 0 || bone.sphere) continue;
    const auto beyond = [&](int node) {
      const Vector3d p = x_[node] - bone.center;
      const double along = bone.e1.dot(p), across = bone.e2.dot(p);
      return plan_.net.nodes[node].free && along < 0 && std::abs(across) < -kCut * along;
    };
    if (beyond(plan_.net.bands[b].a) || beyond(plan_.net.bands[b].b))
      found.push_back(static_cast<int>(b));
  }
  return found;
}

/// One descent from where the nodes are given.
NetStatus NetDescent::settle(const TreeState<double>& state, const NetDrive& drive,
                             const Eigen::Matrix3Xd* start, int patience) {
  scene_ = pose_scene(plan_.net, state, drive);
  draws_.assign(plan_.bands.size(), 0);
  place(state, start);
  evaluate(plan_, scene_, x_, at_);
  return descend(patience);
}

/// Weak pulls swing a taut net like a linkage, in steps as short as (8 pull L^2 / stiffness)^(1/3):
/// where that is too slow, the net is first pulled hard, and then ten times less each time.
NetStatus NetDescent::ease(const TreeState<double>& state, const NetDrive& drive) {
  const double most = drive.tension.size() > 0 ? drive.tension.maxCoeff() : 0;
  if (!(most > 0) || most > kHard) return NetStatus::kStalled;
  const std::vector<int> pushed_out = pushed_out_;
  int spent = iterations_;
  NetStatus status = NetStatus::kStalled;
  for (double times = kHard / most; times > 0; times = times == 1 ? 0 : std::max(times / 10, 1.0)) {
    Eigen::Matrix3Xd from(3, static_cast<Eigen::Index>(x_.size()));
    for (std::size_t i = 0; i < x_.size(); ++i) from.col(static_cast<Eigen::Index>(i)) = x_[i];
    const int patience = times == 1 ? options_.max_iterations : options_.max_iterations / 5;
    status = settle(state, {times * drive.tension, drive.length}, &from, patience);
    spent += iterations_;
  }
  iterations_ = spent;
  pushed_out_ = pushed_out;
  return status;
}

NetEquilibrium NetDescent::run(const TreeState<double>& state, const NetDrive& drive,
                               const Eigen::Matrix3Xd* start) {
  NetStatus status = settle(state, drive, start, options_.max_iterations / 2);
  if (status == NetStatus::kStalled && wound().empty()) status = ease(state, drive);
  if (status == NetStatus::kStalled && wound().empty()) status = descend(options_.max_iterations);
  return report(status);
}

NetEquilibrium NetDescent::report(NetStatus status) const {
  NetEquilibrium out;
  out.status = status;
  out.residual = residual_;
  out.iterations = iterations_;
  out.energy = at_.energy;
  out.pushed_out = pushed_out_;
  if (status == NetStatus::kStalled) out.wound = wound();
  if (!out.wound.empty()) out.status = NetStatus::kWoundRound;
  const auto nodes = static_cast<Eigen::Index>(x_.size());
  const auto bands = static_cast<Eigen::Index>(plan_.bands.size());
  out.x.resize(3, nodes);
  for (Eigen::Index i = 0; i < nodes; ++i) out.x.col(i) = x_[static_cast<std::size_t>(i)];
  out.length.resize(bands);
  out.tension.resize(bands);
  std::vector<bool> held(x_.size(), false);
  for (int b = 0; b < bands; ++b) {
    const NetBand& band = plan_.net.bands[static_cast<std::size_t>(b)];
    const double length = (x_[band.a] - x_[band.b]).norm();
    if (scene_.drawn[b]) {
      const int k = std::max(plan_.bands[b].ka, plan_.bands[b].kb);
      // Several pulls that meet in one exit share what they hold.
      const double sign = plan_.bands[b].ka >= 0 ? -1 : 1;
      const Vector3d force = sign * scene_.pull[b] / contact_[k].drawn * at_.g[k];
      out.drawn.push_back({b, -force});
      out.length(b) = 0;
      out.tension(b) = force.norm();
      if (status == NetStatus::kBalanced) out.status = NetStatus::kDrawnIn;
      held[band.a] = held[band.b] = true;
      continue;
    }
    out.length(b) = at_.length[b];
    out.tension(b) = at_.tension[b];
    if (at_.tension[b] > 0) held[band.a] = held[band.b] = true;
    if (length > kDrawn || !gripped(scene_, b, length)) continue;
    const BandState now = band_state(plan_.net, scene_, b, x_[band.a], x_[band.b]);
    if (now.chord.bent) continue;
    out.drawn.push_back({b, -now.pull.tension * now.chord.slope.head<3>()});
    out.tension(b) = out.drawn.back().force.norm();
    if (status == NetStatus::kBalanced) out.status = NetStatus::kDrawnIn;
  }
  for (int k = 0; k < rows(); ++k)
    for (int c = 0; c < contact_[k].pressed; ++c)
      out.contacts.push_back(
          {plan_.node[k], contact_[k].surface[c],
           contact_[k].force[c] - stray(k, contact_[k].surface[c], contact_[k].normal[c]),
           contact_[k].normal[c]});
  for (std::size_t i = 0; i < x_.size(); ++i)
    if (plan_.row[i] >= 0 && !held[i]) out.loose.push_back(static_cast<int>(i));
  return out;
}

}  // namespace thenar::internal
