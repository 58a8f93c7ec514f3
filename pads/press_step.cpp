#include "pads/press_step.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "solvers/sparse/gmres.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kStiffer = 100;  // of the augmentation than of tissue under a node [1]

constexpr double kLongest = 0.25;  // motion to a force in an iteration, over distances of nodes [1]

constexpr double kConeSlack = 1e-10;  // of the friction cone, for rounding [1]

constexpr double kFar = 10;  // gap that cannot matter, over distances of points of a surface [1]

constexpr double kCoupling = 1e-6;  // of a step in the coupling of friction and normal forces [1]
constexpr int kMaxCoupling = 40;    // iterations for it

constexpr double kRounding = 1e-15;  // of displacements, over distances of nodes [1]

/// Contact at an iterate.
struct TouchingNode {
  double gap = 0;                        // [m]
  Vector3d normal{0, 0, 1};              // of the object, towards the body
  Vector3d slip{0, 0, 0};                // since the last step, tangential [m]
  double push = 0;                       // normal force [N]
  Vector3d shear{0, 0, 0};               // [N]
  Matrix3d slope = Matrix3d::Zero();     // -d force / d x, its symmetric part [N/m]
  Matrix3d coupling = Matrix3d::Zero();  // and the rest: of friction by the normal force [N/m]
  bool sticks = false;
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
        contacts_(surface.nodes.size()),
        more_(surface.nodes.size()) {
    now_.X_PO = goal.X_PO;
    // Nodes that touch begin by sticking.
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      contacts_[k].sticks = start.normal[static_cast<Eigen::Index>(k)] > 0;
    longest_ = kLongest * std::sqrt(surface.area.mean());
  }

  PressOutcome solve() {
    PressOutcome out;
    const TissuePressure none;
    for (out.iterations = 0; out.iterations < options_.max_iterations; ++out.iterations) {
      const Matrix3Xd u = body_.spread(now_.x, {});
      body_.respond(u, goal_.time, start_.history, now_.pressure, ElementAsk::kStiffness, tissue_);
      if (tissue_.inverted) {
        out.message = "an element turned inside out";
        return out;
      }
      stiffest_ = *std::max_element(tissue_.values.begin(), tissue_.values.end());
      find_contacts();
      measure(out);
      if (is_solved(out)) {
        out.message = passed_through(u);
        if (out.message.empty()) out.status = Status::kSolved;
        return out;
      }
      if (goal_.force && scale_ == 0) {
        out.message = "the object does not touch: move it until it does";
        return out;
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
  [[nodiscard]] double stiffer(std::size_t k) const {
    return kStiffer * body_.largest_modulus() *
           std::sqrt(surface_.area[static_cast<Eigen::Index>(k)]);
  }

  /// Nodes inside the object tell that it jumped through the surface; hanging nodes of the surface
  /// may be inside a little, as all between nodes.
  [[nodiscard]] std::string passed_through(const Matrix3Xd& u) const {
    const Pose<double> X_OP = now_.X_PO.inverse();
    std::vector<double> allowed(body_.free_nodes().size(), options_.gap_tolerance);
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      allowed[static_cast<std::size_t>(surface_.nodes[k])] +=
          std::max(0.0, more_[k][3] / surface_.area[static_cast<Eigen::Index>(k)]);
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
    find_gaps();
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      TouchingNode& c = contacts_[k];
      const auto column = static_cast<Eigen::Index>(k);
      const double r = stiffer(k);
      c.push = std::max(0.0, now_.normal[column] - r * c.gap);
      c.shear.setZero();
      c.slope.setZero();
      c.coupling.setZero();
      if (c.push <= 0) continue;
      c.slope = r * c.normal * c.normal.transpose();
      if (object_.friction > 0) find_shear(k, place_of(k), r);
    }
  }

  /// Gaps of nodes, and what they are more in the mean around a node: the true surface is curved
  /// between nodes, and so is the object.
  void find_gaps() {
    const Pose<double> X_OP = now_.X_PO.inverse();
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const NearestSurface near = object_.shape->nearest(X_OP * place_of(k));
      contacts_[k].gap = near.distance;
      contacts_[k].normal = now_.X_PO.R * near.normal;
      more_[k].setZero();
    }
    for (const SurfacePoint& point : surface_.points) {
      Vector3d p = point.offset;
      Eigen::Vector4d mean = Eigen::Vector4d::Zero();  // normal and gap, linear between nodes
      double nearest = 1e300;
      for (const NodeWeight& each : point.nodes) {
        const TouchingNode& c = contacts_[static_cast<std::size_t>(each.node)];
        p += each.weight * place_of(static_cast<std::size_t>(each.node));
        mean += each.weight * Eigen::Vector4d(c.normal[0], c.normal[1], c.normal[2], c.gap);
        nearest = std::min(nearest, c.gap);
      }
      if (nearest > kFar * std::sqrt(point.area)) continue;
      const NearestSurface near = object_.shape->nearest(X_OP * p);
      Eigen::Vector4d here;
      here << now_.X_PO.R * near.normal, near.distance;
      for (const NodeWeight& each : point.nodes)
        more_[static_cast<std::size_t>(each.node)] += each.weight * point.area * (here - mean);
    }
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const Eigen::Vector4d more = more_[k] / surface_.area[static_cast<Eigen::Index>(k)];
      const Vector3d normal = contacts_[k].normal + more.head<3>();
      if (normal.norm() > 0.1) contacts_[k].normal = normal.normalized();
      contacts_[k].gap += more[3];
    }
  }

  /// Friction of a node that touches: it sticks where it was at the last step, or slips against a
  /// force of friction times the normal force.
  void find_shear(std::size_t k, const Vector3d& p, double r) {
    TouchingNode& c = contacts_[k];
    const auto column = static_cast<Eigen::Index>(k);
    const Matrix3d flat = Matrix3d::Identity() - c.normal * c.normal.transpose();
    c.slip = flat * (p - now_.X_PO * Vector3d(start_.anchor.col(column)));
    if (c.sticks) {
      c.shear = flat * Vector3d(now_.shear.col(column)) - r * c.slip;
      c.slope += r * flat;
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
    c.slope += hold * across;
    c.coupling = object_.friction * r * c.against * c.normal.transpose();
  }

  /// Out of balance: forces on free nodes, and the push along the goal's direction.
  void measure(PressOutcome& out) {
    residual_ = tissue_.force;
    out.gap = change_ = 0;
    out.push = {};
    scale_ = 0;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const TouchingNode& c = contacts_[k];
      if (c.push <= 0) continue;
      const Vector3d force = c.push * c.normal + c.shear;
      residual_.segment<3>(3 * surface_.nodes[k]) -= force;
      out.gap = std::max(out.gap, std::abs(c.gap));
      // Forces that still move tell of nodes that should stick or open.
      const auto column = static_cast<Eigen::Index>(k);
      change_ = std::max({change_, (c.shear - Vector3d(now_.shear.col(column))).norm(),
                          std::abs(c.push - now_.normal[column])});
      scale_ += force.norm();
      out.push += wrench_of_force(place_of(k), force);
    }
    push_ = out.push;
    out.residual = residual_.lpNorm<Eigen::Infinity>();
    missing_ = goal_.force ? *goal_.force - goal_.along.dot(out.push.force) : 0;
  }

  [[nodiscard]] bool is_solved(const PressOutcome& out) const {
    // No better than rounding of the forces within elements, which bulk moduli make large.
    const double rounding = kRounding * stiffest_ * std::sqrt(surface_.area.mean());
    const double small = std::max(options_.force_tolerance * scale_, rounding);
    return out.residual <= small && std::abs(missing_) <= std::max(small, 1e-9) &&
           out.gap <= options_.gap_tolerance && change_ <= small && !changed_;
  }

  bool take_step(const Matrix3Xd& u) {
    // Contacts are on the diagonal.
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      for (int c = 0; c < 3; ++c)
        for (int r = c; r < 3; ++r)
          tissue_.values[body_.diagonal_entry(surface_.nodes[k], r, c)] += contacts_[k].slope(r, c);
    if (!factor_.factor(tissue_.values)) return false;
    VectorXd dx = solve(-residual_);
    double motion = 0;
    if (goal_.force && !reach_force(dx, motion)) return false;
    // What the step predicts becomes the new pressure and the new contact forces.
    now_.pressure = body_.pressure_after(u, body_.spread(dx, {}));
    changed_ = false;
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      predict(k, dx.segment<3>(3 * surface_.nodes[k]) - motion * goal_.along);
    now_.x += dx;
    now_.X_PO.p += motion * goal_.along;
    return true;
  }

  /// Solves with the matrix of this iteration: its symmetric part has a factor, and the coupling of
  /// friction and normal forces comes by iterations.
  [[nodiscard]] VectorXd solve(const VectorXd& b) const {
    VectorXd first = factor_.solve(b);
    if (std::all_of(contacts_.begin(), contacts_.end(),
                    [](const TouchingNode& c) { return c.coupling.isZero(0); }))
      return first;
    return gmres(
        [&](const VectorXd& x) {
          VectorXd coupled = VectorXd::Zero(x.size());
          for (std::size_t k = 0; k < contacts_.size(); ++k)
            coupled.segment<3>(3 * surface_.nodes[k]) +=
                contacts_[k].coupling * x.segment<3>(3 * surface_.nodes[k]);
          return VectorXd(x + factor_.solve(coupled));
        },
        first, kCoupling, kMaxCoupling);
  }

  /// The object's motion along the goal's direction is one more unknown: its share of a step.
  /// @param dx  in: with the object at rest
  bool reach_force(VectorXd& dx, double& motion) {
    VectorXd column = VectorXd::Zero(residual_.size()), row = column;
    double own = 0;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const Matrix3d slope = contacts_[k].slope + contacts_[k].coupling;
      column.segment<3>(3 * surface_.nodes[k]) -= slope * goal_.along;
      row.segment<3>(3 * surface_.nodes[k]) -= slope.transpose() * goal_.along;
      own += goal_.along.dot(slope * goal_.along);
    }
    const VectorXd follows = solve(column);
    const double schur = own - row.dot(follows);
    if (!(schur > 0)) return false;
    motion = std::clamp((missing_ - row.dot(dx)) / schur, -longest_, longest_);
    dx -= motion * follows;
    return true;
  }

  /// What an iteration that moves a node relative to the object makes of its forces.
  void predict(std::size_t k, const Vector3d& moved) {
    TouchingNode& c = contacts_[k];
    const auto column = static_cast<Eigen::Index>(k);
    if (c.push <= 0) {
      now_.normal[column] = 0;
      now_.shear.col(column).setZero();
      c.sticks = false;
      c.against.setZero();
      return;
    }
    const Vector3d force = c.push * c.normal + c.shear - (c.slope + c.coupling) * moved;
    now_.normal[column] = std::max(0.0, force.dot(c.normal));
    if (object_.friction <= 0) return;
    const Vector3d shear = force - force.dot(c.normal) * c.normal;
    const double bound = object_.friction * now_.normal[column], size = shear.norm();
    if (c.sticks) {
      // Sticks while friction can hold it.
      c.sticks = size <= bound * (1 + kConeSlack);
      changed_ = changed_ || !c.sticks;
      c.against = size > 0 ? Vector3d(shear / size) : Vector3d(0, 0, 0);
    } else {
      // Slips while it moves against the force.
      const Vector3d slip = c.slip + moved - moved.dot(c.normal) * c.normal;
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
  std::vector<TouchingNode> contacts_;
  std::vector<Eigen::Vector4d> more_;  // of normal and gap in the mean around a node, times area
  TissueResponse tissue_;
  VectorXd residual_;
  Wrench push_;
  bool changed_ = true;  // a node began or ceased to stick in the last iteration
  double scale_ = 0, missing_ = 0, change_ = 0;
  double stiffest_ = 0;  // entry of the tissue's stiffness [N/m]
  double longest_ = 0;   // motion of the object in an iteration [m]
};

}  // namespace

namespace {

/// Corners of the faces of a mesh all of whose nodes are marked.
std::vector<std::array<int, 4>> marked_faces(const HexMesh& mesh, const std::vector<bool>& marked) {
  std::vector<std::array<int, 4>> out;
  for (const int index : mesh.active())
    for (const std::array<int, 4>& face : hex_faces()) {
      std::array<int, 4> nodes{};
      for (std::size_t i = 0; i < 4; ++i)
        nodes[i] = mesh.cells()[static_cast<std::size_t>(index)]
                       .corners[static_cast<std::size_t>(face[i])];
      if (std::all_of(nodes.begin(), nodes.end(),
                      [&](int node) { return marked[static_cast<std::size_t>(node)]; }))
        out.push_back(nodes);
    }
  return out;
}

/// Gauss points of a face, by nodes of the mesh; an empty list of nodes: some are fixed.
std::vector<SurfacePoint> face_points(const HexMesh& mesh, const TissueBody& body,
                                      const std::array<int, 4>& nodes, double area) {
  constexpr std::array<double, 3> kAt{0.112701665379258311, 0.5, 0.887298334620741689};
  constexpr std::array<double, 3> kShare{5.0 / 18, 4.0 / 9, 5.0 / 18};
  std::vector<SurfacePoint> out;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const double x = kAt[i], y = kAt[j];
      const std::array<double, 4> shape{(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
      Vector3d chart(0, 0, 0), mean(0, 0, 0);
      std::map<int, double> weights;
      for (std::size_t k = 0; k < 4; ++k) {
        chart += shape[k] * mesh.chart_point(nodes[k]);
        mean += shape[k] * mesh.place(nodes[k]);
        if (mesh.masters(nodes[k]).empty()) weights[body.free_place(nodes[k])] += shape[k];
        for (const NodeWeight& each : mesh.masters(nodes[k]))
          weights[body.free_place(each.node)] += shape[k] * each.weight;
      }
      if (weights.count(-1) != 0) return {};
      SurfacePoint point{mesh.chart().place(chart) - mean, {}, area * kShare[i] * kShare[j]};
      for (const auto& [node, weight] : weights) point.nodes.push_back({node, weight});
      out.push_back(std::move(point));
    }
  return out;
}

}  // namespace

ContactSurface contact_surface(const HexMesh& mesh, const TissueBody& body,
                               const std::vector<bool>& marked) {
  ContactSurface surface;
  std::map<int, double> area;  // by free place
  for (const std::array<int, 4>& nodes : marked_faces(mesh, marked)) {
    // A quarter of the face for each of its nodes.
    const double all = 0.5 * (mesh.place(nodes[3]) - mesh.place(nodes[0]))
                                 .cross(mesh.place(nodes[2]) - mesh.place(nodes[1]))
                                 .norm();
    for (const int node : nodes) {
      if (mesh.masters(node).empty()) area[body.free_place(node)] += all / 4;
      for (const NodeWeight& each : mesh.masters(node))
        area[body.free_place(each.node)] += all / 4 * each.weight;
    }
    if (!body.is_quadratic())
      for (SurfacePoint& point : face_points(mesh, body, nodes, all))
        surface.points.push_back(std::move(point));
  }
  area.erase(-1);
  const auto count = static_cast<Eigen::Index>(area.size());
  surface.places.resize(3, count);
  surface.area.resize(count);
  std::map<int, int> index;
  for (const auto& [node, share] : area) {
    const auto column = static_cast<Eigen::Index>(surface.nodes.size());
    surface.places.col(column) = mesh.place(body.free_nodes()[static_cast<std::size_t>(node)]);
    surface.area[column] = share;
    index[node] = static_cast<int>(column);
    surface.nodes.push_back(node);
  }
  for (SurfacePoint& point : surface.points)
    for (NodeWeight& each : point.nodes) each.node = index.at(each.node);
  return surface;
}

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

double smallest_gap(const ContactSurface& surface, const Shape& object, const PressState& state) {
  const Pose<double> X_OP = state.X_PO.inverse();
  Matrix3Xd places = surface.places;
  double gap = 1e300;
  for (std::size_t k = 0; k < surface.nodes.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    places.col(column) += state.x.segment<3>(3 * surface.nodes[k]);
    gap = std::min(gap, object.distance(X_OP * Vector3d(places.col(column))));
  }
  for (const SurfacePoint& point : surface.points) {
    Vector3d p = point.offset;
    for (const NodeWeight& each : point.nodes) p += each.weight * places.col(each.node);
    gap = std::min(gap, object.distance(X_OP * p));
  }
  return gap;
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
