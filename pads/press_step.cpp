#include "pads/press_step.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "solvers/sparse/gmres.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kStiffer = 100;    // of the augmentation than of tissue under a node [1]
constexpr double kStifferNow = 10;  // and than of the body at a node [1]
constexpr double kStiffest = 5000;  // but no more than this of tissue under a node [1]

constexpr double kLongest = 0.25;  // motion to a force in an iteration, over distances of nodes [1]

constexpr double kReach = 20;   // distance from which a force is sought, over that motion [1]
constexpr double kBack = 0.01;  // depth at which it touches again, over that motion [1]

constexpr double kConeSlack = 1e-10;  // of the friction cone, for rounding [1]

constexpr double kCoupling = 1e-6;  // of a step in the coupling of friction and normal forces [1]
constexpr int kMaxCoupling = 40;    // iterations for it

constexpr double kRounding = 1e-14;      // of strains of volume, in the forces of an element [1]
constexpr double kRoundedPlace = 2e-16;  // of objects of up to a metre [m]

/// Contact at an iterate.
struct TouchingNode {
  Vector3d slip{0, 0, 0};            // since the last step, tangential [m]
  double push = 0;                   // normal force [N]
  Vector3d shear{0, 0, 0};           // [N]
  Matrix3d hold = Matrix3d::Zero();  // -d shear / d x at the same normal force [N/m]
  bool sticks = true;                // from the first until friction cannot hold it
  bool slides = false;
  Vector3d against{0, 0, 0};  // unit, of the shear of a node that slips
};

class PressSolver {
 public:
  PressSolver(const TissueBody& body, const ContactSurface& surface, const RigidObject& object,
              const PressGoal& goal, const PressOptions& options, SparseCholesky& factor,
              const PressState& start)
      : body_(body),
        surface_(surface),
        object_(object),
        goal_(goal),
        options_(options),
        factor_(factor),
        start_(start),
        now_(start),
        gaps_(surface),
        contacts_(surface.nodes.size()) {
    now_.X_PO = goal.X_PO;
    longest_ = kLongest * std::sqrt(surface.area.mean());
  }

  PressOutcome solve() {
    PressOutcome out;
    for (out.iterations = 0; out.iterations < options_.max_iterations; ++out.iterations) {
      if (options_.stop && options_.stop()) {
        out.status = Status::kStopped;
        out.message = "stopped";
        return out;
      }
      const Matrix3Xd u = body_.spread(now_.x, {});
      body_.respond(u, goal_.time, start_.history, now_.pressure, ElementAsk::kStiffness, tissue_);
      if (tissue_.inverted) {
        out.message = "an element turned inside out";
        return out;
      }
      if (out.iterations == 0) find_stiffness();
      find_contacts();
      first_ = false;
      measure(out);
      if (is_solved(out)) {
        out.message = passed_through(u);
        if (out.message.empty()) out.status = Status::kSolved;
        return out;
      }
      if (goal_.force && scale_ == 0) {
        // Not far off, or off what it touched, it goes to where it touches.
        double nearest = 1e300;
        for (std::size_t k = 0; k < contacts_.size(); ++k)
          nearest = std::min(nearest, gaps_.gap(k));
        if (nearest > kReach * longest_) {
          out.message = "the object does not touch: move it until it does";
          return out;
        }
        now_.X_PO.p += (nearest + kBack * longest_) * goal_.along;
        continue;
      }
      if (!take_step(u)) {
        out.message = "the stiffness is not positive definite";
        return out;
      }
    }
    out.status = Status::kLimit;
    out.message = "too many iterations";
    return out;
  }

  /// Slope of the push by motions of the object, at the state where it began.
  Eigen::Matrix<double, 6, 6> stiffness() {
    Eigen::Matrix<double, 6, 6> out = Eigen::Matrix<double, 6, 6>::Zero();
    const Matrix3Xd u = body_.spread(now_.x, {});
    body_.respond(u, 0, start_.history, now_.pressure, ElementAsk::kStiffness, tissue_);
    find_stiffness();
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      contacts_[k].sticks = node_sticks(start_, static_cast<Eigen::Index>(k), object_.friction);
    find_contacts();
    PressOutcome unused;
    measure(unused);
    add_own_slopes();
    if (scale_ == 0 || !factor_.factor(tissue_.values)) return out;
    for (int column = 0; column < 6; ++column) {
      // Object, normals and friction turn with it, while tissue resists.
      Matrix3Xd rigid = Matrix3Xd::Zero(3, static_cast<Eigen::Index>(contacts_.size()));
      const Vector3d axis = Vector3d::Unit(column % 3);
      Matrix3Xd turned = rigid;
      for (std::size_t k = 0; k < contacts_.size(); ++k) {
        const auto node = static_cast<Eigen::Index>(k);
        if (column >= 3)
          rigid.col(node) = axis;
        else
          rigid.col(node) = axis.cross(place_of(k));
        if (column < 3) turned.col(node) = axis.cross(Vector3d(forces_.col(node)));
      }
      const Matrix3Xd moved = on_surface(solve(on_body(contact_slope(rigid, false) + turned)));
      const Matrix3Xd gained = turned - contact_slope(moved - rigid, false);
      for (std::size_t k = 0; k < contacts_.size(); ++k) {
        const auto node = static_cast<Eigen::Index>(k);
        out.block<3, 1>(0, column) += place_of(k).cross(Vector3d(gained.col(node))) +
                                      Vector3d(moved.col(node)).cross(Vector3d(forces_.col(node)));
        out.block<3, 1>(3, column) += gained.col(node);
      }
    }
    return out;
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
    now_.history = body_.advance(body_.spread(now_.x, {}), goal_.time, start_.history);
    return now_;
  }

 private:
  [[nodiscard]] Vector3d place_of(std::size_t k) const {
    return surface_.places.col(static_cast<Eigen::Index>(k)) +
           now_.x.segment<3>(3 * surface_.nodes[k]);
  }
  /// Stiffness of the augmentation at a node [N/m].
  [[nodiscard]] double stiffer(std::size_t k) const { return stiffer_[k]; }

  /// Above that of tissue at rest, and above that of the body as it is: a squeezed body is stiffer
  /// by its law and by its bulk modulus, and may be stable by the contact alone.
  void find_stiffness() {
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const double at_rest =
          body_.largest_modulus() * std::sqrt(surface_.area[static_cast<Eigen::Index>(k)]);
      double now = 0;
      for (int c = 0; c < 3; ++c)
        now = std::max(now, tissue_.values[body_.diagonal_entry(surface_.nodes[k], c, c)]);
      // No more than leaves forces exact to rounding of places.
      stiffer_.push_back(std::clamp(kStifferNow * now, kStiffer * at_rest, kStiffest * at_rest));
    }
  }

  /// Nodes inside the object tell that it jumped through the surface; hanging nodes of the surface
  /// may be inside a little, as all between nodes.
  [[nodiscard]] std::string passed_through(const Matrix3Xd& u) const {
    const Pose<double> X_OP = now_.X_PO.inverse();
    std::vector<double> allowed(body_.free_nodes().size(), options_.gap_tolerance);
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
    return "";
  }

  void find_contacts() {
    gaps_.find(*object_.shape, now_.X_PO, now_.x);
    coupled_ = gaps_.neighbours_matter();
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      TouchingNode& c = contacts_[k];
      const auto column = static_cast<Eigen::Index>(k);
      c.push = std::max(0.0, now_.normal[column] - stiffer(k) * gaps_.gap(k));
      c.shear.setZero();
      c.hold.setZero();
      c.slides = false;
      if (c.push > 0 && object_.friction > 0) find_shear(k);
    }
  }

  /// Friction of a node that touches: it sticks where it was at the last step, or slips against a
  /// force of friction times the normal force.
  void find_shear(std::size_t k) {
    TouchingNode& c = contacts_[k];
    const double r = stiffer(k);
    const Vector3d normal = gaps_.normal(k);
    const auto column = static_cast<Eigen::Index>(k);
    const Matrix3d flat = Matrix3d::Identity() - normal * normal.transpose();
    c.slip = flat * (place_of(k) - now_.X_PO * Vector3d(start_.anchor.col(column)));
    // What slipped and goes on the same way begins slipping.
    if (first_)
      c.sticks = node_sticks(start_, column, object_.friction) ||
                 c.slip.dot(Vector3d(start_.shear.col(column))) >= 0;
    if (c.sticks) {
      c.shear = flat * Vector3d(now_.shear.col(column)) - r * c.slip;
      c.hold = r * flat;
      return;
    }
    // Along what the last force becomes by the slip: a slip that is not much yet turns it little.
    // Across that it holds the node, the less the more it slips.
    const double bound = object_.friction * c.push;
    const Vector3d trial = flat * Vector3d(now_.shear.col(column)) - r * c.slip;
    const double size = trial.norm();
    if (size > 0) c.against = trial / size;
    const double share = size > 2 * bound ? bound / size : 0.5, hold = r * share / (1 - share);
    const Matrix3d across = flat - c.against * c.against.transpose();
    c.shear = bound * c.against - hold * (across * c.slip);
    c.hold = hold * across;
    c.slides = coupled_ = true;
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
    forces_ = gaps_.spread(push);
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const TouchingNode& c = contacts_[k];
      const auto column = static_cast<Eigen::Index>(k);
      forces_.col(column) += c.shear;
      const Vector3d force = forces_.col(column);
      if (force.isZero(0)) continue;
      residual_.segment<3>(3 * surface_.nodes[k]) -= force;
      out.push += wrench_of_force(place_of(k), force);
      scale_ += force.norm();
      if (c.push <= 0) continue;
      out.gap = std::max(out.gap, std::abs(gaps_.gap(k)));
      rounding_ = std::max(rounding_, stiffer(k) * kRoundedPlace);
      // Forces that still move tell of nodes that should stick or open.
      change_ = std::max({change_, (c.shear - Vector3d(now_.shear.col(column))).norm(),
                          std::abs(c.push - now_.normal[column])});
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
           out.gap <= options_.gap_tolerance && change_ <= small && !changed_;
  }

  /// The factor has contacts as blocks on the diagonal.
  void add_own_slopes() {
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const Matrix3d block = own_slope(k);
      for (int c = 0; c < 3; ++c)
        for (int r = c; r < 3; ++r)
          tissue_.values[body_.diagonal_entry(surface_.nodes[k], r, c)] += block(r, c);
    }
  }

  bool take_step(const Matrix3Xd& u) {
    add_own_slopes();
    if (!factor_.factor(tissue_.values)) return false;
    VectorXd dx = solve(-residual_);
    double motion = 0;
    if (goal_.force && !reach_force(dx, motion)) return false;
    // What the step predicts becomes the new pressure and the new contact forces.
    now_.pressure = body_.pressure_after(u, body_.spread(dx, {}));
    Matrix3Xd moved = on_surface(dx);
    moved.colwise() -= motion * goal_.along;
    const VectorXd closed = gaps_.change(moved);
    changed_ = false;
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      predict(k, moved.col(static_cast<Eigen::Index>(k)), closed[static_cast<Eigen::Index>(k)]);
    now_.x += dx;
    now_.X_PO.p += motion * goal_.along;
    return true;
  }

  /// Displacements of the nodes of the surface (3, nodes).
  [[nodiscard]] Matrix3Xd on_surface(const VectorXd& x) const {
    Matrix3Xd out(3, static_cast<Eigen::Index>(contacts_.size()));
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      out.col(static_cast<Eigen::Index>(k)) = x.segment<3>(3 * surface_.nodes[k]);
    return out;
  }
  /// And back (3 free nodes).
  [[nodiscard]] VectorXd on_body(const Matrix3Xd& forces) const {
    VectorXd out = VectorXd::Zero(residual_.size());
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      out.segment<3>(3 * surface_.nodes[k]) = forces.col(static_cast<Eigen::Index>(k));
    return out;
  }

  /// What of the slope of contact forces the factor has: a node's own.
  [[nodiscard]] Matrix3d own_slope(std::size_t k) const {
    if (contacts_[k].push <= 0) return Matrix3d::Zero();
    const Vector3d own = gaps_.own_slope(k);
    return stiffer(k) * own * own.transpose() + contacts_[k].hold;
  }

  /// Loss of contact forces as nodes move (3, nodes); transposed: the other way round.
  [[nodiscard]] Matrix3Xd contact_slope(const Matrix3Xd& moved, bool transposed) const {
    VectorXd lost = gaps_.change(moved);
    Matrix3Xd out(3, moved.cols());
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const TouchingNode& c = contacts_[k];
      const auto column = static_cast<Eigen::Index>(k);
      const Vector3d follows =
          c.slides ? Vector3d(object_.friction * c.against) : Vector3d(0, 0, 0);
      if (transposed) lost[column] += follows.dot(moved.col(column));
      lost[column] *= c.push > 0 ? stiffer(k) : 0;
      out.col(column) = c.hold * moved.col(column);
      if (!transposed) out.col(column) += lost[column] * follows;
    }
    return out + gaps_.spread(lost);
  }

  /// Solves with the matrix of this iteration: most of it has a factor, and what contacts add
  /// between nodes, and between friction and normal forces, comes by iterations.
  [[nodiscard]] VectorXd solve(const VectorXd& b) const {
    VectorXd first = factor_.solve(b);
    if (!coupled_) return first;
    return gmres(
        [&](const VectorXd& x) {
          const Matrix3Xd moved = on_surface(x);
          Matrix3Xd more = contact_slope(moved, false);
          for (std::size_t k = 0; k < contacts_.size(); ++k) {
            const auto column = static_cast<Eigen::Index>(k);
            more.col(column) -= own_slope(k) * moved.col(column);
          }
          return VectorXd(x + factor_.solve(on_body(more)));
        },
        first, kCoupling, kMaxCoupling);
  }

  /// The object's motion along the goal's direction is one more unknown: its share of a step.
  /// @param dx  in: with the object at rest
  bool reach_force(VectorXd& dx, double& motion) {
    const Matrix3Xd along = goal_.along.replicate(1, static_cast<Eigen::Index>(contacts_.size()));
    const Matrix3Xd lost = contact_slope(along, false);
    const VectorXd column = -on_body(lost), row = -on_body(contact_slope(along, true));
    const double own = goal_.along.dot(lost.rowwise().sum());
    const VectorXd follows = solve(column);
    const double schur = own - row.dot(follows);
    if (!(schur > 0)) return false;
    motion = std::clamp((missing_ - row.dot(dx)) / schur, -longest_, longest_);
    dx -= motion * follows;
    return true;
  }

  /// What an iteration that moves a node relative to the object makes of its forces.
  /// @param closed  change of its gap [m]
  void predict(std::size_t k, const Vector3d& moved, double closed) {
    TouchingNode& c = contacts_[k];
    const auto column = static_cast<Eigen::Index>(k);
    if (c.push <= 0) {
      now_.normal[column] = 0;
      now_.shear.col(column).setZero();
      c.sticks = false;
      c.against.setZero();
      return;
    }
    const double before = c.push - stiffer(k) * closed;
    now_.normal[column] = std::max(0.0, before);
    if (object_.friction <= 0) return;
    Vector3d shear = c.shear - c.hold * moved;
    if (c.slides) shear += object_.friction * (before - c.push) * c.against;
    const double bound = object_.friction * now_.normal[column], size = shear.norm();
    if (c.sticks) {
      // Sticks while friction can hold it.
      c.sticks = size <= bound * (1 + kConeSlack);
      changed_ = changed_ || !c.sticks;
      c.against = size > 0 ? Vector3d(shear / size) : Vector3d(0, 0, 0);
    } else {
      // Slips while it moves against the force.
      const Vector3d normal = gaps_.normal(k);
      const Vector3d slip = c.slip + moved - moved.dot(normal) * normal;
      c.sticks = slip.dot(c.against) > 0;
      changed_ = changed_ || c.sticks;
    }
    now_.shear.col(column) = size > bound && size > 0 ? Vector3d(bound / size * shear) : shear;
  }

  const TissueBody& body_;
  const ContactSurface& surface_;
  const RigidObject& object_;
  const PressGoal& goal_;
  const PressOptions& options_;
  SparseCholesky& factor_;
  const PressState& start_;
  PressState now_;
  MeanGaps gaps_;
  std::vector<TouchingNode> contacts_;
  std::vector<double> stiffer_;  // of the augmentation [N/m] (surface nodes)
  bool first_ = true;            // no iteration is done
  bool coupled_ = false;         // the slope of contact forces is more than blocks on the diagonal
  TissueResponse tissue_;
  VectorXd residual_;
  Matrix3Xd forces_;  // of contact on nodes [N] (3, nodes)
  Wrench push_;
  bool changed_ = true;  // a node began or ceased to stick in the last iteration
  double scale_ = 0, missing_ = 0, change_ = 0;
  double rounding_ = 0;  // of contact forces [N]
  double longest_ = 0;   // motion of the object in an iteration [m]
};

}  // namespace

PressOutcome press_step(const TissueBody& body, const ContactSurface& surface,
                        const RigidObject& object, const PressGoal& goal,
                        const PressOptions& options, SparseCholesky& factor, PressState& state) {
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
              state.shear.cols() == nodes && state.anchor.cols() == nodes,
          "a state of {} unknowns and {} nodes does not fit a body of {} and {}", state.x.size(),
          state.normal.size(), body.unknowns(), nodes);
  PressSolver solver(body, surface, object, goal, options, factor, state);
  PressOutcome out = solver.solve();
  if (out.status == Status::kSolved) state = solver.finish();
  return out;
}

Eigen::Matrix<double, 6, 6> press_stiffness(const TissueBody& body, const ContactSurface& surface,
                                            const RigidObject& object, const PressOptions& options,
                                            SparseCholesky& factor, const PressState& state) {
  require(state.x.size() == body.unknowns() &&
              state.normal.size() == static_cast<Eigen::Index>(surface.nodes.size()),
          "a state of {} unknowns does not fit a body of {}", state.x.size(), body.unknowns());
  PressGoal here;
  here.X_PO = state.X_PO;
  return PressSolver(body, surface, object, here, options, factor, state).stiffness();
}

bool node_sticks(const PressState& state, Eigen::Index node, double friction) {
  constexpr double kSlipping = 1e-6;
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
