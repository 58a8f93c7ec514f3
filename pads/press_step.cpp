#include "pads/press_step.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "pads/skin_springs.h"
#include "solvers/anderson_mixing.h"
#include "solvers/sparse/gmres.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kMostConeNodes = 60;  // that touch, of which cones cost less than Newton's method

constexpr double kStiffer = 100;    // of the augmentation than of tissue under a node [1]
constexpr double kStifferNow = 10;  // and than of the body at a node [1]
constexpr double kStiffest = 5000;  // but no more than this of tissue under a node [1]

constexpr double kLongest = 0.25;  // motion to a force in an iteration, over distances of nodes [1]

constexpr double kReach = 20;   // distance from which a force is sought, over that motion [1]
constexpr double kBack = 0.01;  // depth at which it touches again, over that motion [1]

constexpr double kCoupling = 1e-6;  // of a step, in what neighbours add to gaps [1]
constexpr int kMaxCoupling = 40;    // iterations for it

constexpr double kWell = 0.3;       // of what is left after an iteration, that keeps a tangent [1]
constexpr double kFirm = 0.2;       // what is left, over forces, below which one is kept [1]
constexpr double kSlipping = 1e-6;  // below its cone's bound, friction that slips [1]
constexpr double kTurned = -0.5;    // cosine of normals on two sides of an object [1]
constexpr int kMostCuts = 10;       // halvings of a motion that turns an element inside out
constexpr double kGives = 0.2;      // of springs of skin, over the distance of nodes [1]
constexpr int kPatience = 2;        // iterations before steps are shortened
constexpr double kArmijo = 1e-4;    // of a fall that slopes promise [1]
constexpr double kRoundedEnergy = 1e-11;  // of a potential, whose parts are rounded [1]
constexpr double kRoundedStrain = 1e-15;  // of squares of stretches less 3, in an energy [1]
constexpr double kSameWay = 0.95;         // cosine of steps that go one way [1]
constexpr double kFarther = 16;           // by how much these grow at most [1]
constexpr int kRounds = 8;                // iterations in which a residual must fall
constexpr double kFallsAgain = 0.5;       // to this share [1]
constexpr double kSkinStiffer = 2;        // springs of skin than the augmentation [1]
constexpr double kMuchStiffer = 8;        // than springs were made for, so that they change [1]
constexpr double kSpring = 1e-2;          // of a drive, over that of tissue under a node [1]

constexpr double kLeastHold = 1e-6;  // springs that hold nodes, over the tangent's diagonal [1]
constexpr double kMostHold = 1;

constexpr double kCreeps = 0.4;    // ratio of motions that shrink slowly [1]
constexpr double kSettled = 0.02;  // what is left, over forces, from which on motions are mixed [1]
constexpr std::size_t kMixed = 3;  // motions that foretell what they tend to
constexpr double kTurning = 0.1;   // of the distance of nodes, over which a normal turns [1]

constexpr double kRounding = 1e-14;      // of strains of volume, in the forces of an element [1]
constexpr double kRoundedPlace = 2e-16;  // of objects of up to a metre [m]

/// Contact at an iterate.
struct TouchingNode {
  double push = 0;          // normal force [N]
  Vector3d shear{0, 0, 0};  // [N]
  bool slips = false;
  Vector3d way{0, 0, 0};   // of friction on a node that slips, unit
  Vector3d last{0, 0, 0};  // the same of the last iterate, over the bound: at most as long
  double cut = 1;          // what its cone leaves of the force of a node that would stick [1]
};

class PressSolver {
 public:
  PressSolver(const TissueBody& body, const ContactSurface& surface, const RigidObject& object,
              const PressGoal& goal, const PressOptions& options, PressFactors& factors,
              const PressState& start)
      : body_(body),
        surface_(surface),
        object_(object),
        goal_(goal),
        options_(options),
        factors_(factors),
        start_(start),
        now_(start),
        gaps_(surface),
        contacts_(surface.nodes.size()) {
    now_.X_PO = goal.X_PO;
    longest_ = kLongest * std::sqrt(surface.area.mean());
  }

  /// By the augmented Lagrangian without friction or where many nodes touch, else by cones; where
  /// one fails, by the other.
  PressOutcome solve() {
    if (meets_edge(surface_, *object_.shape, start_.X_PO, start_.x) ||
        meets_edge(surface_, *object_.shape, goal_.X_PO, start_.x))
      return solve_by_springs();
    const bool augments = object_.friction <= 0 || nodes_to_touch() > kMostConeNodes;
    PressOutcome out = augments ? solve_by_augmentation() : solve_by_cones();
    if (out.status == Status::kSolved || out.status == Status::kStopped) return out;
    const int iterations = out.iterations;
    now_ = start_;
    now_.X_PO = goal_.X_PO;
    stiffer_.clear();
    out = augments ? solve_by_cones() : solve_by_augmentation();
    out.iterations += iterations;
    return out;
  }

  /// Slope of the push by motions of the object, at the state where it began.
  Eigen::Matrix<double, 6, 6> stiffness() {
    const Matrix3Xd u = body_.spread(now_.x, {});
    body_.respond(u, 0, start_.history, now_.pressure, ElementAsk::kStiffness, tissue_);
    if (start_.by_springs) return stiffness_by_springs();
    gaps_.find(*object_.shape, now_.X_PO, now_.x);
    TouchingNodes touching;
    touching.along_normal.resize(3, now_.normal.size());
    for (Eigen::Index k = 0; k < now_.normal.size(); ++k) {
      if (now_.normal[k] <= 0) continue;
      touching.along_normal.col(static_cast<Eigen::Index>(touching.nodes.size())) =
          now_.shear.col(k) / now_.normal[k];
      touching.nodes.push_back(static_cast<int>(k));
      touching.sticks.push_back(node_sticks(start_, k, object_.friction));
    }
    if (touching.nodes.empty() || tissue_.inverted || !factors_.moment.factor(tissue_.values))
      return Eigen::Matrix<double, 6, 6>::Zero();
    return contact_stiffness(factors_.moment, surface_, gaps_, touching,
                             places_of(surface_, now_.x), gaps_.spread(now_.normal) + now_.shear);
  }

  /// The new state, once solved.
  PressState finish() {
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      now_.normal[column] = contacts_[k].push;
      // Bounded by the force of this iteration, from which that of the last differs by the
      // tolerance.
      const double bound = object_.friction * contacts_[k].push, size = contacts_[k].shear.norm();
      now_.shear.col(column) = (size > bound ? bound / size : 1.0) * contacts_[k].shear;
      now_.anchor.col(column) = now_.X_PO.inverse() * place_of(k);
    }
    now_.push = push_;
    now_.by_springs = springs_.has_value();
    now_.spring_energy = springs_ ? springs_->energy() : 0;
    if (springs_ && !stiffer_.empty()) now_.spring_stiffness = stiffer_;
    now_.history = body_.advance(body_.spread(now_.x, {}), goal_.time, start_.history);
    return now_;
  }

 private:
  /// Newton's method; contact is as stiff as its augmentation, and forces become what a step
  /// predicts. Each iteration leaves a share of what was left, so a tangent that does as well is
  /// kept.
  PressOutcome solve_by_augmentation() {
    PressOutcome out;
    VectorXd dx;
    bool keeps = false;
    double before = kInfinity;
    for (; goes_on(out); ++out.iterations) {
      Matrix3Xd u;
      if (!respond(keeps ? ElementAsk::kForce : ElementAsk::kStiffness, dx, u, out)) return out;
      if (out.iterations == 0) find_stiffness(tissue_.values);
      const std::vector<int> touched = touching();
      find_contacts();
      measure(out);
      if (is_solved(out)) return ended(u, out);
      if (goal_.force && scale_ == 0) {
        if (!go_to_touch(out)) return out;
        continue;
      }
      const double left = std::max({out.residual, change_, std::abs(missing_)});
      const bool same = touching() == touched;
      // A tangent that was kept is taken anew where it serves no more.
      if (keeps && !(same && left < kWell * before)) {
        keeps = false;
        body_.respond(u, goal_.time, start_.history, now_.pressure, ElementAsk::kStiffness,
                      tissue_);
      }
      if ((!keeps && !factor_here()) || !take_step(u)) {
        out.message = "the stiffness is not positive definite";
        return out;
      }
      before = left;
      keeps = same && left < kFirm * scale_;
    }
    return out;
  }

  /// The slope with springs: the object moves, and forces turn with it, while tissue resists.
  Eigen::Matrix<double, 6, 6> stiffness_by_springs() {
    Eigen::Matrix<double, 6, 6> out = Eigen::Matrix<double, 6, 6>::Zero();
    if (tissue_.inverted) return out;
    residual_ = VectorXd::Zero(body_.unknowns());
    find_spring_stiffness();
    springs_.emplace(body_, surface_);
    find_springs(object_.friction * (1 - kSlipping));
    springs_->add_slopes(tissue_.values);
    if (!factored([&] { return factors_.moment.factor(tissue_.values); })) return out;
    return push_slope(places_of(surface_, now_.x), springs_->push() + springs_->shear(),
                      [&](const Matrix3Xd& rigid, const Matrix3Xd& turned) {
                        const Matrix3Xd pushed = springs_->loss(rigid) + turned;
                        const Matrix3Xd moved = on_surface(solve(on_body(pushed)));
                        return PushAnswer{pushed - springs_->loss(moved), moved};
                      });
  }

  /// Springs that stay as they were unless tissue has become much stiffer or softer, as a change
  /// makes energy from nothing.
  void find_spring_stiffness() {
    find_stiffness(tissue_.values);
    for (double& each : stiffer_) each *= kSkinStiffer;
    for (std::size_t k = 0; k < start_.spring_stiffness.size(); ++k) {
      const double was = start_.spring_stiffness[k];
      if (std::max(was / stiffer_[k], stiffer_[k] / was) < kMuchStiffer) stiffer_[k] = was;
    }
  }

  /// Sets springs, and what they make of contacts.
  void find_springs(double friction) {
    springs_->find(*object_.shape, now_.X_PO, now_.x, stiffer_, friction,
                   {start_.anchor, now_.shear});
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      contacts_[k].push = springs_->push().col(column).norm();
      contacts_[k].shear = springs_->shear().col(column);
    }
  }

  /// Newton's method with springs on the skin. Without friction forces are slopes of one potential,
  /// and a step is shortened until that falls.
  PressOutcome solve_by_springs() {
    PressOutcome out;
    springs_.emplace(body_, surface_);
    if (is_off_at_rest()) {
      // Skin that hangs on an edge would be another answer.
      now_.x.setZero();
      now_.pressure.clear();
      return ended(body_.spread(now_.x, {}), out);
    }
    VectorXd dx, last;
    LineSearch line;
    double least = kInfinity;  // residual [N]
    int fell = 0;              // the iteration in which it became that
    for (; goes_on(out); ++out.iterations) {
      Matrix3Xd u;
      if (!respond(ElementAsk::kStiffness, dx, u, out)) return out;
      if (out.iterations == 0) find_spring_stiffness();
      find_springs(object_.friction);
      if (out.iterations > kPatience && !search_line(line, dx, u, out)) return out;
      measure(out);
      if (is_solved(out)) return ended(u, out);
      // With friction steps may go round for ever.
      if (out.residual < kFallsAgain * least) {
        least = out.residual;
        fell = out.iterations;
      }
      if (object_.friction > 0 && out.iterations > fell + kRounds) {
        out.message = "steps go round";
        return out;
      }
      if (goal_.force && scale_ == 0) {
        gaps_.find(*object_.shape, now_.X_PO, now_.x);
        if (!go_to_touch(out)) return out;
        line.before = kInfinity;
        continue;
      }
      springs_->add_slopes(tissue_.values);
      dx.resize(0);
      line = {potential(), 0, 0};
      if (factored([&] { return factors_.moment.factor(tissue_.values); })) {
        dx = solve(-residual_);
        if (goal_.force && !reach_force(dx, line.motion)) dx.resize(0);
      }
      if (dx.size() == 0) {
        out.message = "the stiffness is not positive definite";
        return out;
      }
      line.promise = residual_.dot(dx) - missing_ * line.motion;
      const bool runs = out.iterations > kPatience && runs_off(last, dx);
      last = dx;
      if (runs) dx *= std::clamp(longest_ / dx.lpNorm<Eigen::Infinity>(), 1.0, kFarther);
      now_.pressure = body_.pressure_after(u, body_.spread(dx, {}));
      if (object_.friction > 0) {
        Matrix3Xd moved = on_surface(dx);
        moved.colwise() -= line.motion * goal_.along;
        now_.shear = springs_->shear() - springs_->friction_loss(moved);
      }
      now_.x += dx;
      now_.X_PO.p += line.motion * goal_.along;
    }
    return out;
  }

  /// Of the last step: the potential before it, what slopes promise of its change, and the object's
  /// motion.
  struct LineSearch {
    double before = kInfinity, promise = 0;  // [J]
    double motion = 0;                       // [m]
  };
  /// Halves the last step until the potential falls as slopes promise (Armijo's rule); with
  /// friction there is none.
  /// @return false if tissue gives no answer
  bool search_line(LineSearch& line, VectorXd& dx, Matrix3Xd& u, PressOutcome& out) {
    if (object_.friction > 0) return true;
    for (int cut = 0; cut < kMostCuts; ++cut) {
      if (potential() <= line.before + kArmijo * line.promise + rounded_potential()) break;
      line.promise /= 2;
      line.motion /= 2;
      dx /= 2;
      now_.x -= dx;
      now_.X_PO.p -= line.motion * goal_.along;
      if (!respond(ElementAsk::kStiffness, dx, u, out)) return false;
      find_springs(0);
    }
    return true;
  }

  /// Whether the object, which does not wait for a force, is off the skin at rest.
  [[nodiscard]] bool is_off_at_rest() {
    if (goal_.force || body_.relaxes()) return false;
    const std::vector<double> any(surface_.nodes.size(), 1);
    springs_->find(*object_.shape, now_.X_PO, VectorXd::Zero(now_.x.size()), any, 0,
                   {start_.anchor, now_.shear});
    return springs_->deepest() <= 0;
  }

  /// Energy of tissue and springs, less the work of the force on the object [J].
  [[nodiscard]] double potential() const {
    return tissue_.energy + springs_->energy() -
           goal_.force.value_or(0) * goal_.along.dot(now_.X_PO.p - start_.X_PO.p);
  }
  [[nodiscard]] double rounded_potential() const {
    return kRoundedEnergy * std::abs(potential()) +
           kRoundedStrain * body_.largest_modulus() * std::pow(surface_.area.sum(), 1.5);
  }

  /// Whether steps go on in one direction and grow, as off an equilibrium that is not stable.
  [[nodiscard]] bool runs_off(const VectorXd& last, const VectorXd& dx) const {
    return object_.friction <= 0 && !goal_.force && last.size() > 0 && dx.norm() > last.norm() &&
           dx.dot(last) > kSameWay * dx.norm() * last.norm();
  }

  /// Each iteration brings the body, linear at where it is, to rest under exact cones. Its tangent
  /// is kept while iterations go on well.
  PressOutcome solve_by_cones() {
    PressOutcome out;
    ContactCones& cones = factors_.cones;
    const CondensedBody& tangent = cones.body();
    double before = kInfinity;
    VectorXd dx, last;
    AndersonMixing mixing(kMixed);
    for (; goes_on(out); ++out.iterations) {
      Matrix3Xd u;
      const bool has_factor = tangent.has_factor();
      if (!respond(has_factor ? ElementAsk::kForce : ElementAsk::kStiffness, dx, u, out))
        return out;
      if (stiffer_.empty()) find_stiffness(has_factor ? tangent.values() : tissue_.values);
      find_contacts();
      measure(out);
      if (is_solved(out)) return ended(u, out);
      if (goal_.force && scale_ == 0) {
        if (!go_to_touch(out)) return out;
        continue;
      }
      // A tangent of elsewhere serves while what is left falls well.
      const double left = std::max(out.residual, change_);
      const bool well = out.iterations == 0 || left < kWell * std::min(before, scale_);
      if (!(has_factor && well) && !renew(u)) {
        out.message = "the stiffness is not positive definite";
        return out;
      }
      before = left;
      const Matrix3Xd slip = slips();
      std::optional<ContactCones::Drive> drive;
      if (goal_.force)
        drive = {goal_.along, *goal_.force,
                 kSpring * body_.largest_modulus() * std::sqrt(surface_.area.mean()), longest_};
      const ContactCones::Rest rest = cones.solve(
          surface_, {tissue_.force, gaps_, slip, now_.normal, now_.shear, object_.friction, drive});
      if (rest.status != Status::kSolved) {
        out.message = "no forces of contact were found";
        return out;
      }
      dx = rest.dx;
      // Where motions shrink slowly, as where friction turns with normals, all of what they tend
      // to.
      const bool creeps = last.size() > 0 && rest.dx.norm() > kCreeps * last.norm();
      last = rest.dx;
      if (goal_.force || !creeps || left > kSettled * scale_) mixing.clear();
      dx = mixing.next(rest.dx);
      now_.pressure = body_.pressure_after(u, body_.spread(dx, {}));
      now_.x += dx;
      now_.X_PO.p += rest.motion * goal_.along;
      now_.normal = rest.normal;
      now_.shear = rest.shear;
    }
    return out;
  }

  /// Nodes that touch or, if no tissue moves, will be inside the object.
  [[nodiscard]] int nodes_to_touch() {
    gaps_.find(*object_.shape, now_.X_PO, now_.x);
    int count = 0;
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      count += now_.normal[static_cast<Eigen::Index>(k)] > 0 || gaps_.gap(k) < 0 ? 1 : 0;
    return count;
  }

  /// Whether there is another iteration.
  [[nodiscard]] bool goes_on(PressOutcome& out) const {
    if (out.iterations >= options_.max_iterations) {
      out.status = Status::kLimit;
      out.message = "too many iterations";
      return false;
    }
    if (options_.stop && options_.stop()) {
      out.status = Status::kStopped;
      out.message = "stopped";
      return false;
    }
    return true;
  }

  /// What tissue answers where it is, or, where an element would turn inside out, less far on.
  /// @param dx  the last motion, may be empty: becomes what is left of it
  bool respond(ElementAsk ask, VectorXd& dx, Matrix3Xd& u, PressOutcome& out) {
    for (int cut = 0; cut <= kMostCuts; ++cut) {
      u = body_.spread(now_.x, {});
      body_.respond(u, goal_.time, start_.history, now_.pressure, ask, tissue_);
      if (!tissue_.inverted) return true;
      if (dx.size() == 0) break;
      dx *= 0.5;
      now_.x -= dx;
    }
    out.message = "an element turned inside out";
    return false;
  }

  /// A step that is solved, unless the object jumped through the surface.
  PressOutcome ended(const Matrix3Xd& u, PressOutcome& out) const {
    out.message = passed_through(u);
    if (out.message.empty()) out.status = Status::kSolved;
    return out;
  }

  /// Not far off, or off what it touched, the object goes to where it touches.
  bool go_to_touch(PressOutcome& out) {
    double nearest = 1e300;
    for (std::size_t k = 0; k < contacts_.size(); ++k) nearest = std::min(nearest, gaps_.gap(k));
    if (nearest > kReach * longest_) {
      out.message = "the object does not touch: move it until it does";
      return false;
    }
    now_.X_PO.p += (nearest + kBack * longest_) * goal_.along;
    return true;
  }

  [[nodiscard]] Vector3d place_of(std::size_t k) const {
    return surface_.places.col(static_cast<Eigen::Index>(k)) +
           now_.x.segment<3>(3 * surface_.nodes[k]);
  }
  /// Stiffness of the augmentation at a node [N/m].
  [[nodiscard]] double stiffer(std::size_t k) const { return stiffer_[k]; }

  /// Above that of tissue at rest, and above that of the body as it is: a squeezed body is stiffer
  /// by its law and by its bulk modulus, and may be stable by the contact alone.
  /// @param values  of a tangent
  void find_stiffness(const std::vector<double>& values) {
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const double at_rest =
          body_.largest_modulus() * std::sqrt(surface_.area[static_cast<Eigen::Index>(k)]);
      double now = 0;
      for (int c = 0; c < 3; ++c)
        now = std::max(now, values[body_.diagonal_entry(surface_.nodes[k], c, c)]);
      // No more than leaves forces exact to rounding of places.
      stiffer_.push_back(std::clamp(kStifferNow * now, kStiffer * at_rest, kStiffest * at_rest));
    }
  }

  /// Takes the tangent here, with what forces do whose normals turn. Where the body is stable by
  /// its contacts alone, they have springs.
  bool renew(const Matrix3Xd& u) {
    body_.respond(u, goal_.time, start_.history, now_.pressure, ElementAsk::kStiffness, tissue_);
    const Matrix3Xd none(3, 0);
    const std::vector<double> tissue = tissue_.values;
    add_turning_slopes();
    if (factors_.cones.factor(tissue_.values, none)) return true;
    tissue_.values = tissue;
    if (factors_.cones.factor(tissue_.values, none)) return true;
    Matrix3Xd springs = Matrix3Xd::Zero(3, static_cast<Eigen::Index>(contacts_.size()));
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      if (contacts_[k].push > 0)
        springs.col(static_cast<Eigen::Index>(k)) = std::sqrt(stiffer(k)) * gaps_.own_slope(k);
    add_own_slopes();
    return factored([&] { return factors_.cones.factor(tissue_.values, springs); });
  }

  /// A node that slides over a curved object has its normal force turn: - normal d2 distance / dx2,
  /// by differences over a part of the way between nodes, as if all force were the node's own.
  void add_turning_slopes() {
    const double step = kTurning * std::sqrt(surface_.area.mean());
    const Pose<double> X_OP = now_.X_PO.inverse();
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const double normal = now_.normal[static_cast<Eigen::Index>(k)];
      if (normal <= 0) continue;
      const auto normal_at = [&](const Vector3d& p) {
        return Vector3d(now_.X_PO.R * object_.shape->nearest(X_OP * p).normal);
      };
      Matrix3d slope;
      for (int c = 0; c < 3; ++c) {
        const Vector3d way = step * Vector3d::Unit(c);
        slope.col(c) = (normal_at(place_of(k) + way) - normal_at(place_of(k) - way)) / (2 * step);
      }
      add_block(k, -0.5 * normal * (slope + slope.transpose()));
    }
  }

  /// Slip of every node since the last step, tangential [m] (3, nodes).
  [[nodiscard]] Matrix3Xd slips() const {
    Matrix3Xd out(3, static_cast<Eigen::Index>(contacts_.size()));
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      out.col(static_cast<Eigen::Index>(k)) = slip_of(k);
    return out;
  }
  [[nodiscard]] Vector3d slip_of(std::size_t k) const {
    const Vector3d anchor = start_.anchor.col(static_cast<Eigen::Index>(k));
    return across(k, place_of(k) - now_.X_PO * anchor);
  }
  /// Part of a vector across the normal of a node.
  [[nodiscard]] Vector3d across(std::size_t k, const Vector3d& v) const {
    const Vector3d normal = gaps_.normal(k);
    return v - v.dot(normal) * normal;
  }

  /// Nodes inside the object tell that it jumped through the surface; hanging nodes of the surface
  /// may be inside a little, as all between nodes.
  [[nodiscard]] std::string passed_through(const Matrix3Xd& u) const {
    const Pose<double> X_OP = now_.X_PO.inverse();
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      if (contacts_[k].push > 0 && changed_sides(k, X_OP)) return "the object jumped through skin";
    // Springs give way by a part of what they hold.
    const double gives = springs_ ? kGives * std::sqrt(surface_.area.mean()) : 0;
    if (springs_ && springs_->deepest() > gives) return "the skin is inside the object";
    if (springs_ &&
        springs_->changed_sides(*object_.shape, start_.X_PO, now_.X_PO, start_.x, kTurned))
      return "the object jumped through skin";
    std::vector<double> allowed(body_.free_nodes().size(), options_.gap_tolerance + gives);
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      allowed[static_cast<std::size_t>(surface_.nodes[k])] += std::max(0.0, gaps_.more(k));
    for (const int node : body_.nodes()) {
      const Vector3d p = body_.place(node) + u.col(node);
      const int free = body_.free_place(node);
      const double most =
          free >= 0 ? allowed[static_cast<std::size_t>(free)] : options_.gap_tolerance;
      if (!body_.hangs(node) && object_.shape->distance(X_OP * p) < -most)
        return fmt::format("the object is inside the tissue at ({:g}, {:g}, {:g}) mm", p[0] * 1e3,
                           p[1] * 1e3, p[2] * 1e3);
    }
    // A small one may be all under the skin, where it meets no node and no face.
    const Vector3d middle = object_.shape->bounds().center();
    if (object_.shape->distance(middle) < 0 && body_.contains(now_.X_PO * middle, u))
      return "the object is inside the tissue";
    return "";
  }

  /// Whether a node touches a side of the object that faces away from the one where it was: steps
  /// of a press are too short to go around it.
  [[nodiscard]] bool changed_sides(std::size_t k, const Pose<double>& X_OP) const {
    const Vector3d was = surface_.places.col(static_cast<Eigen::Index>(k)) +
                         start_.x.segment<3>(3 * surface_.nodes[k]);
    return object_.shape->nearest(X_OP * place_of(k))
               .normal.dot(object_.shape->nearest(start_.X_PO.inverse() * was).normal) < kTurned;
  }

  /// Forces that the laws of contact make of the last ones, of gaps and of slips: at an answer they
  /// are the last ones.
  void find_contacts() {
    gaps_.find(*object_.shape, now_.X_PO, now_.x);
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      TouchingNode& c = contacts_[k];
      const auto column = static_cast<Eigen::Index>(k);
      c.push = std::max(0.0, now_.normal[column] - stiffer(k) * gaps_.gap(k));
      c.shear.setZero();
      c.slips = c.push > 0;
      c.cut = 0;
      if (c.push <= 0 || object_.friction <= 0) continue;
      // The force within the cone that is nearest to the last less the slip.
      const Vector3d trial = across(k, Vector3d(now_.shear.col(column))) - stiffer(k) * slip_of(k);
      const double bound = object_.friction * c.push, size = trial.norm();
      c.slips = size > bound;
      c.cut = c.slips ? bound / size : 1;
      c.way = c.last = Vector3d(0, 0, 0);
      if (c.slips) {
        c.way = trial / size;
        const Vector3d last = across(k, Vector3d(now_.shear.col(column)));
        c.last = last / std::max(bound, last.norm());
      }
      c.shear = c.cut * trial;
    }
  }

  /// Out of balance: forces on free nodes, and the push along the goal's direction.
  void measure(PressOutcome& out) {
    residual_ = tissue_.force;
    out.gap = change_ = rounding_ = 0;
    out.push = {};
    scale_ = 0;
    VectorXd push(static_cast<Eigen::Index>(contacts_.size()));
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      push[static_cast<Eigen::Index>(k)] = contacts_[k].push;
    const Matrix3Xd forces = springs_ ? springs_->push() : gaps_.spread(push);
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const TouchingNode& c = contacts_[k];
      const auto column = static_cast<Eigen::Index>(k);
      const Vector3d force = forces.col(column) + c.shear;
      if (force.isZero(0)) continue;
      residual_.segment<3>(3 * surface_.nodes[k]) -= force;
      out.push += wrench_of_force(place_of(k), force);
      scale_ += force.norm();
      if (c.push <= 0) continue;
      rounding_ = std::max(rounding_, stiffer(k) * kRoundedPlace);
      // Forces that still move tell of nodes that should stick or open.
      change_ = std::max(change_, (c.shear - Vector3d(now_.shear.col(column))).norm());
      if (springs_) continue;  // which leave no gap to close
      out.gap = std::max(out.gap, std::abs(gaps_.gap(k)));
      change_ = std::max(change_, std::abs(c.push - now_.normal[column]));
    }
    push_ = out.push;
    out.residual = residual_.lpNorm<Eigen::Infinity>();
    missing_ = goal_.force ? *goal_.force - goal_.along.dot(out.push.force) : 0;
  }

  [[nodiscard]] bool is_solved(const PressOutcome& out) const {
    // No better than rounding of the forces within elements, which bulk moduli make large, and of
    // the places that forces of contact come from.
    const double rounding = std::max(kRounding * body_.largest_pressure_force(), rounding_);
    const double small = std::max(options_.force_tolerance * scale_, rounding);
    return out.residual <= small && std::abs(missing_) <= std::max(small, 1e-9) &&
           out.gap <= options_.gap_tolerance && change_ <= small;
  }

  /// The factor has contacts as blocks on the diagonal.
  void add_own_slopes() {
    for (std::size_t k = 0; k < contacts_.size(); ++k) add_block(k, own_slope(k));
  }
  void add_block(std::size_t k, const Matrix3d& block) {
    for (int c = 0; c < 3; ++c)
      for (int r = c; r < 3; ++r)
        tissue_.values[body_.diagonal_entry(surface_.nodes[k], r, c)] += block(r, c);
  }

  bool factor_here() {
    add_own_slopes();
    return factored([&] { return factors_.moment.factor(tissue_.values); });
  }

  /// Factors the tangent, or, where it is not positive definite, the tangent with the least springs
  /// of some powers of ten that hold all nodes where they are: steps become shorter.
  bool factored(const std::function<bool()>& factor) {
    if (factor()) return true;
    const double mean = mean_diagonal();
    double held = 0;
    for (double share = kLeastHold; share <= kMostHold; share *= 10) {
      add_to_diagonal(share * mean - held);
      held = share * mean;
      if (factor()) return true;
    }
    return false;
  }
  [[nodiscard]] double mean_diagonal() const {
    double sum = 0;
    for (std::size_t i = 0; i < body_.free_nodes().size(); ++i)
      for (int c = 0; c < 3; ++c)
        sum += tissue_.values[body_.diagonal_entry(static_cast<int>(i), c, c)];
    return sum / body_.unknowns();
  }
  void add_to_diagonal(double more) {
    for (std::size_t i = 0; i < body_.free_nodes().size(); ++i)
      for (int c = 0; c < 3; ++c)
        tissue_.values[body_.diagonal_entry(static_cast<int>(i), c, c)] += more;
  }

  /// Of each node whether it is open (0), sticks (1) or slips (2).
  [[nodiscard]] std::vector<int> touching() const {
    std::vector<int> out;
    for (const TouchingNode& c : contacts_) out.push_back(c.push <= 0 ? 0 : c.slips ? 2 : 1);
    return out;
  }

  bool take_step(const Matrix3Xd& u) {
    VectorXd dx = solve(-residual_);
    double motion = 0;
    if (goal_.force && !reach_force(dx, motion)) return false;
    // What the step predicts becomes the new pressure and the new contact forces.
    now_.pressure = body_.pressure_after(u, body_.spread(dx, {}));
    Matrix3Xd moved = on_surface(dx);
    moved.colwise() -= motion * goal_.along;
    const VectorXd closed = gaps_.change(moved);
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      const TouchingNode& c = contacts_[k];
      const double before = c.push - stiffer(k) * closed[column];
      now_.normal[column] = c.push > 0 ? std::max(0.0, before) : 0;
      now_.shear.col(column) =
          now_.normal[column] > 0
              ? Vector3d(c.shear - lost_shear(k, moved.col(column), stiffer(k) * closed[column]))
              : Vector3d(0, 0, 0);
    }
    now_.x += dx;
    now_.X_PO.p += motion * goal_.along;
    return true;
  }

  /// Displacements of the nodes of the surface (3, nodes).
  [[nodiscard]] Matrix3Xd on_surface(const VectorXd& x) const {
    return places_of(surface_, x) - surface_.places;
  }
  /// And back (3 free nodes).
  [[nodiscard]] VectorXd on_body(const Matrix3Xd& forces) const {
    VectorXd out = VectorXd::Zero(residual_.size());
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      out.segment<3>(3 * surface_.nodes[k]) = forces.col(static_cast<Eigen::Index>(k));
    return out;
  }

  /// What of the slope of contact forces the factor has: a node's own, less the friction that a
  /// normal force brings, which is not symmetric.
  [[nodiscard]] Matrix3d own_slope(std::size_t k) const {
    const TouchingNode& c = contacts_[k];
    if (c.push <= 0) return Matrix3d::Zero();
    const Vector3d own = gaps_.own_slope(k), normal = gaps_.normal(k);
    const Matrix3d plane = Matrix3d::Identity() - normal * normal.transpose() -
                           c.last.dot(c.way) * c.way * c.way.transpose();
    return stiffer(k) * (own * own.transpose() + c.cut * plane);
  }

  /// Loss of friction on a node that touches, as it moves and loses normal force [N] (3).
  [[nodiscard]] Vector3d lost_shear(std::size_t k, const Vector3d& moved, double lost) const {
    const TouchingNode& c = contacts_[k];
    const Vector3d slid = across(k, moved);
    return stiffer(k) * c.cut * (slid - c.way.dot(slid) * c.last) + object_.friction * lost * c.way;
  }

  /// Loss of contact forces as nodes move (3, nodes); symmetric without slip.
  [[nodiscard]] Matrix3Xd contact_slope(const Matrix3Xd& moved) const {
    if (springs_) return springs_->loss(moved);
    VectorXd lost = gaps_.change(moved);
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      lost[static_cast<Eigen::Index>(k)] *= contacts_[k].push > 0 ? stiffer(k) : 0;
    Matrix3Xd out = gaps_.spread(lost);
    for (std::size_t k = 0; object_.friction > 0 && k < contacts_.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      if (contacts_[k].push > 0)
        out.col(column) += lost_shear(k, Vector3d(moved.col(column)), lost[column]);
    }
    return out;
  }

  /// Solves with the matrix of this iteration: most of it has a factor, and what contacts add
  /// between nodes comes by iterations.
  [[nodiscard]] VectorXd solve(const VectorXd& b) const {
    VectorXd first = factors_.moment.solve(b);
    if (springs_ ? object_.friction <= 0 : !gaps_.neighbours_matter() && !some_slip()) return first;
    return gmres(
        [&](const VectorXd& x) {
          const Matrix3Xd moved = on_surface(x);
          if (springs_)
            return VectorXd(x + factors_.moment.solve(on_body(springs_->loss_left_out(moved))));
          Matrix3Xd more = contact_slope(moved);
          for (std::size_t k = 0; k < contacts_.size(); ++k) {
            const auto column = static_cast<Eigen::Index>(k);
            more.col(column) -= own_slope(k) * moved.col(column);
          }
          return VectorXd(x + factors_.moment.solve(on_body(more)));
        },
        first, kCoupling, kMaxCoupling);
  }

  /// Whether friction follows normal forces somewhere.
  [[nodiscard]] bool some_slip() const {
    return object_.friction > 0 && std::any_of(contacts_.begin(), contacts_.end(),
                                               [](const TouchingNode& c) { return c.slips; });
  }

  /// The object's motion along the goal's direction is one more unknown: its share of a step.
  /// @param dx  in: with the object at rest
  bool reach_force(VectorXd& dx, double& motion) {
    const Matrix3Xd lost =
        contact_slope(goal_.along.replicate(1, static_cast<Eigen::Index>(contacts_.size())));
    const VectorXd follows = solve(on_body(lost));
    const auto lost_along = [&](const Matrix3Xd& forces) {
      return goal_.along.dot(forces.rowwise().sum());
    };
    const double schur = lost_along(lost) - lost_along(contact_slope(on_surface(follows)));
    if (!(schur > 0)) return false;
    motion = std::clamp((missing_ + lost_along(contact_slope(on_surface(dx)))) / schur, -longest_,
                        longest_);
    dx += motion * follows;
    return true;
  }

  const TissueBody& body_;
  const ContactSurface& surface_;
  const RigidObject& object_;
  const PressGoal& goal_;
  const PressOptions& options_;
  PressFactors& factors_;
  const PressState& start_;
  PressState now_;
  MeanGaps gaps_;
  std::optional<SkinSprings> springs_;  // where there are edges
  std::vector<TouchingNode> contacts_;
  std::vector<double> stiffer_;  // of the augmentation [N/m] (surface nodes)
  TissueResponse tissue_;
  VectorXd residual_;
  Wrench push_;
  double scale_ = 0, missing_ = 0, change_ = 0;
  double rounding_ = 0;  // of contact forces [N]
  double longest_ = 0;   // motion of the object in an iteration [m]
};

/// Whether springs of a state, where there are some, are those of the surface's nodes.
bool has_springs_of(const PressState& state, const ContactSurface& surface) {
  return state.spring_stiffness.empty() || state.spring_stiffness.size() == surface.nodes.size();
}

}  // namespace

PressOutcome press_step(const TissueBody& body, const ContactSurface& surface,
                        const RigidObject& object, const PressGoal& goal,
                        const PressOptions& options, PressFactors& factors, PressState& state) {
  const auto nodes = static_cast<Eigen::Index>(surface.nodes.size());
  require(object.shape != nullptr, "an object without a shape presses on nothing");
  require(object.friction >= 0 && std::isfinite(object.friction),
          "friction must be finite and >= 0, got {}", object.friction);
  require(goal.X_PO.p.allFinite() && goal.X_PO.R.allFinite(), "a goal's pose is not finite");
  require(goal.time >= 0, "a step takes 0 s or more, got {}", goal.time);
  require(!goal.force || (std::isfinite(*goal.force) && *goal.force > 0),
          "a force to reach must be above 0, got {} N", goal.force.value_or(0));
  require(!goal.force || std::abs(goal.along.norm() - 1) < 1e-9,
          "the direction of a force is no unit vector");
  require(nodes > 0, "a body has no surface that may touch");
  require(state.x.size() == body.unknowns() && state.normal.size() == nodes &&
              state.shear.cols() == nodes && state.anchor.cols() == nodes &&
              has_springs_of(state, surface),
          "a state of {} unknowns and {} nodes does not fit a body of {} and {}", state.x.size(),
          state.normal.size(), body.unknowns(), nodes);
  PressSolver solver(body, surface, object, goal, options, factors, state);
  PressOutcome out = solver.solve();
  if (out.status == Status::kSolved) state = solver.finish();
  return out;
}

Eigen::Matrix<double, 6, 6> press_stiffness(const TissueBody& body, const ContactSurface& surface,
                                            const RigidObject& object, const PressOptions& options,
                                            PressFactors& factors, const PressState& state) {
  require(state.x.size() == body.unknowns() &&
              state.normal.size() == static_cast<Eigen::Index>(surface.nodes.size()) &&
              has_springs_of(state, surface),
          "a state of {} unknowns does not fit a body of {}", state.x.size(), body.unknowns());
  PressGoal here;
  here.X_PO = state.X_PO;
  return PressSolver(body, surface, object, here, options, factors, state).stiffness();
}

bool node_sticks(const PressState& state, Eigen::Index node, double friction) {
  return state.shear.col(node).norm() < (1 - kSlipping) * friction * state.normal[node];
}

PressState rest_state(const TissueBody& body, const ContactSurface& surface,
                      const Pose<double>& X_PO) {
  PressState state;
  state.x = VectorXd::Zero(body.unknowns());
  state.X_PO = X_PO;
  const auto nodes = static_cast<Eigen::Index>(surface.nodes.size());
  state.normal = VectorXd::Zero(nodes);
  state.shear = Matrix3Xd::Zero(3, nodes);
  state.anchor.resize(3, nodes);
  for (Eigen::Index k = 0; k < nodes; ++k)
    state.anchor.col(k) = X_PO.inverse() * Vector3d(surface.places.col(k));
  return state;
}

}  // namespace thenar
