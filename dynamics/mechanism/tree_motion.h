#pragma once

/// Kinematics of all links, for any scalar type.

#include <vector>

#include "dynamics/mechanism/joint_turns.h"
#include "dynamics/mechanism/tree_model.h"

namespace thenar {

/// Motion and loads of a link. Vectors are in world axes; moments and velocities refer to the
/// origin o of the link's joint frame M, so that a link far from the world's origin loses no
/// digits.
template <typename T>
struct MovingLink {
  Mat3<T> R;               // rotation of M in the world (3, 3)
  Vec3<T> o;               // origin of M [m] (3)
  Vec3<T> r;               // o minus the parent's o [m] (3)
  Mat3<T> E;               // rotation of F in the world; z is the axis of hinges and slides (3, 3)
  T slope, bend;           // first and second derivative of the joint value by its coordinate
  Mat3<T> inertia;         // inertia about o [kg m^2] (3, 3)
  Vec3<T> moment;          // mass times (centre of mass - o) [kg m] (3)
  Vec3<T> w, vel;          // angular velocity [rad/s], velocity of o [m/s] (3)
  Vec3<T> zeta_w, zeta_v;  // acceleration relative to the parent at v_dot = 0: angular [rad/s^2],
                           // of o [m/s^2] (3)
  Vec3<T> gyro_m, gyro_f;  // gyroscopic wrench at o [N m], [N] (3)
  Vec3<T> load_m, load_f;  // wrench of external loads at o [N m], [N] (3)
};

/// Positions, velocities and loads of all links of a model. Calls do not allocate memory. Source of
/// the recursions: [Featherstone2008] chapters 4 and 5, here with the velocity and acceleration of
/// each link's joint origin.
template <typename T>
class TreeMotion {
 public:
  /// @param model  must outlive the object
  explicit TreeMotion(const TreeModel& model)
      : model_(&model), links_(model.links.size()), turns_(model.links.size()) {}

  /// Computes the poses of all links. @param q  positions with unit quaternions (q)
  template <typename Q>
  void set_position(const Q& q);

  /// Computes the velocities of all links. Call after set_position(). @param v  velocities (v)
  template <typename V>
  void set_speed(const V& v);

  /// Removes all loads.
  void clear_loads() {
    for (MovingLink<T>& link : links_) link.load_m = link.load_f = Vec3<T>::Zero();
  }
  /// Adds a force and a moment on a link; ignored on the world (-1).
  /// @param p  point of application [m] (3);  @param f  [N] (3);  @param m  [N m] (3)
  void add_load(int link, const Vec3<T>& p, const Vec3<T>& f, const Vec3<T>& m) {
    if (link < 0) return;
    MovingLink<T>& at = links_[link];
    at.load_m += m + (p - at.o).cross(f);
    at.load_f += f;
  }

  [[nodiscard]] const TreeModel& model() const { return *model_; }
  [[nodiscard]] const std::vector<MovingLink<T>>& links() const { return links_; }

  /// Returns the link of a body of the mechanism; -1: the world. @param body  -1: the world
  [[nodiscard]] int link_of(int body) const { return body < 0 ? -1 : model_->bodies[body].link; }

  /// Returns the pose of a body of the mechanism in the world.
  [[nodiscard]] Pose<T> pose(int body) const {
    const BodyInLink& at = model_->bodies[body];
    Pose<T> X_LB{at.X_LB.R.template cast<T>(), at.X_LB.p.template cast<T>()};
    if (at.link < 0) return X_LB;
    const MovingLink<T>& link = links_[at.link];
    return Pose<T>{link.R, link.o} * X_LB;
  }

  /// Returns the velocity of a link's point [m/s].
  /// @param link  -1: the world;  @param p  point, world [m] (3)
  [[nodiscard]] Vec3<T> velocity(int link, const Vec3<T>& p) const {
    if (link < 0) return Vec3<T>::Zero();
    const MovingLink<T>& at = links_[link];
    return at.vel + at.w.cross(p - at.o);
  }

  /// Adds the Jacobian row of  direction . (velocity of the link's point p) + spin . (its angular
  /// velocity).
  /// @param p  point, world [m] (3);  @param direction, spin  world (3)
  /// @param row  indexable, increased (v)
  template <typename Row>
  void add_jacobian_row(int link, const Vec3<T>& p, const Vec3<T>& direction, const Vec3<T>& spin,
                        Row&& row) const;
  /// Adds the Jacobian row of the velocity of one link relative to another, at the point p.
  template <typename Row>
  void add_relative_jacobian_row(int link, int other, const Vec3<T>& p, const Vec3<T>& direction,
                                 const Vec3<T>& spin, Row&& row) const {
    add_jacobian_row(link, p, direction, spin, row);
    add_jacobian_row(other, p, Vec3<T>(-direction), Vec3<T>(-spin), row);
  }

  /// Computes the kinetic energy [J]. Call after set_speed().
  [[nodiscard]] T kinetic_energy() const;
  /// Computes the gravitational energy [J]. @param gravity  acceleration of free fall [m/s^2] (3)
  [[nodiscard]] T weight_energy(const Vec3<T>& gravity) const;

 private:
  const TreeModel* model_;
  std::vector<MovingLink<T>> links_;
  internal::JointTurns<T> turns_;  // joint values with their sines and cosines
};

namespace internal {

/// Returns the rotation of a unit quaternion (w, x, y, z). @param first  its first entry in q
template <typename T, typename Q>
Mat3<T> rotation_of(const Q& q, int first) {
  const T w = q[first], x = q[first + 1], y = q[first + 2], z = q[first + 3];
  Mat3<T> R;
  R << T(1) - T(2) * (y * y + z * z), T(2) * (x * y - w * z), T(2) * (x * z + w * y),
      T(2) * (x * y + w * z), T(1) - T(2) * (x * x + z * z), T(2) * (y * z - w * x),
      T(2) * (x * z - w * y), T(2) * (y * z + w * x), T(1) - T(2) * (x * x + y * y);
  return R;
}

/// Adds the components of a wrench at a link's origin along its joint axes to a row (v).
template <typename T, typename Row>
void add_along_axes(const TreeLink& constant, const MovingLink<T>& link, const Vec3<T>& m,
                    const Vec3<T>& f, Row&& row) {
  switch (constant.kind) {
    case JointKind::kHinge:
      row[constant.first_v] += link.slope * link.E.col(2).dot(m);
      break;
    case JointKind::kSlide:
      row[constant.first_v] += link.slope * link.E.col(2).dot(f);
      break;
    default:
      for (int k = 0; k < 3; ++k) row[constant.first_v + k] += link.E.col(k).dot(m);
      if (constant.kind == JointKind::kBall) break;
      for (int k = 0; k < 3; ++k) row[constant.first_v + 3 + k] += link.E.col(k).dot(f);
  }
}

}  // namespace internal

template <typename T>
template <typename Q>
void TreeMotion<T>::set_position(const Q& q) {
  // Evaluate joint values, and all sines and cosines at once.
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const TreeLink& constant = model_->links[i];
    JointValueOn<T> at{T(0), T(1), T(0)};
    if (is_scalar(constant.kind)) at = joint_value<T>(constant.joint, q[constant.first_q]);
    links_[i].slope = at.slope;
    links_[i].bend = at.bend;
    turns_.set(i, at.value);
  }
  turns_.compute();
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const TreeLink& constant = model_->links[i];
    MovingLink<T>& link = links_[i];
    // Compute frame F, which moves with the parent.
    if (constant.parent < 0) {
      link.E = constant.X_PF.R.template cast<T>();
      link.o = link.r = constant.X_PF.p.template cast<T>();
    } else {
      const MovingLink<T>& parent = links_[constant.parent];
      link.E.noalias() = parent.R * constant.X_PF.R.template cast<T>();
      link.r.noalias() = parent.R * constant.X_PF.p.template cast<T>();
      link.o = parent.o + link.r;
    }
    // Compute frame M by the joint's motion in F.
    switch (constant.kind) {
      case JointKind::kHinge: {
        const T c = turns_.cosine(i), s = turns_.sine(i);
        link.R.col(0) = c * link.E.col(0) + s * link.E.col(1);
        link.R.col(1) = c * link.E.col(1) - s * link.E.col(0);
        link.R.col(2) = link.E.col(2);
        break;
      }
      case JointKind::kSlide: {
        link.R = link.E;
        const Vec3<T> shift = turns_.value(i) * link.E.col(2);
        link.r += shift;
        link.o += shift;
        break;
      }
      case JointKind::kFree: {
        const Vec3<T> local(q[constant.first_q + 4], q[constant.first_q + 5],
                            q[constant.first_q + 6]);
        const Vec3<T> shift = link.E * local;
        link.r += shift;
        link.o += shift;
        link.R = link.E * internal::rotation_of<T>(q, constant.first_q);
        break;
      }
      default:
        link.R = link.E * internal::rotation_of<T>(q, constant.first_q);
    }
    // Rotate the mass moment and the symmetric inertia to world axes.
    link.moment.noalias() = link.R * constant.moment.template cast<T>();
    const Mat3<T> half = link.R * constant.inertia.template cast<T>();
    for (int row = 0; row < 3; ++row)
      for (int k = row; k < 3; ++k)
        link.inertia(k, row) = link.inertia(row, k) = half.row(row).dot(link.R.row(k));
  }
}

template <typename T>
template <typename V>
void TreeMotion<T>::set_speed(const V& v) {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const TreeLink& constant = model_->links[i];
    MovingLink<T>& link = links_[i];
    // Start with the velocity and acceleration by the parent's motion.
    Vec3<T> base = Vec3<T>::Zero();
    link.vel = link.zeta_v = base;
    if (constant.parent >= 0) {
      const MovingLink<T>& parent = links_[constant.parent];
      base = parent.w;
      const Vec3<T> turned = base.cross(link.r);
      link.vel = parent.vel + turned;
      link.zeta_v = base.cross(turned);
    }
    link.w = base;
    link.zeta_w = Vec3<T>::Zero();
    // Add those by the joint's motion.
    switch (constant.kind) {
      case JointKind::kHinge: {
        const T rate = v[constant.first_v];
        const Vec3<T> turn = (link.slope * rate) * link.E.col(2);
        link.w += turn;
        link.zeta_w = base.cross(turn) + (link.bend * rate * rate) * link.E.col(2);
        break;
      }
      case JointKind::kSlide: {
        const T rate = v[constant.first_v];
        const Vec3<T> shift = (link.slope * rate) * link.E.col(2);
        link.vel += shift;
        link.zeta_v += T(2) * base.cross(shift) + (link.bend * rate * rate) * link.E.col(2);
        break;
      }
      default: {
        const Vec3<T> turn =
            link.E * Vec3<T>(v[constant.first_v], v[constant.first_v + 1], v[constant.first_v + 2]);
        link.w += turn;
        link.zeta_w = base.cross(turn);
        if (constant.kind == JointKind::kBall) break;
        const Vec3<T> shift = link.E * Vec3<T>(v[constant.first_v + 3], v[constant.first_v + 4],
                                               v[constant.first_v + 5]);
        link.vel += shift;
        link.zeta_v += T(2) * base.cross(shift);
      }
    }
    // Compute the gyroscopic moment and the centripetal force.
    link.gyro_m = link.w.cross(link.inertia * link.w);
    link.gyro_f = link.w.cross(link.w.cross(link.moment));
  }
}

template <typename T>
template <typename Row>
void TreeMotion<T>::add_jacobian_row(int link, const Vec3<T>& p, const Vec3<T>& direction,
                                     const Vec3<T>& spin, Row&& row) const {
  while (link >= 0) {
    const TreeLink& constant = model_->links[link];
    const MovingLink<T>& at = links_[link];
    // Shift the wrench to the joint's origin, and project it on the joint's axes.
    internal::add_along_axes<T>(constant, at, (p - at.o).cross(direction) + spin, direction, row);
    link = constant.parent;
  }
}

template <typename T>
T TreeMotion<T>::kinetic_energy() const {
  T energy(0);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const MovingLink<T>& link = links_[i];
    energy += T(0.5) * link.w.dot(link.inertia * link.w) + link.vel.dot(link.w.cross(link.moment)) +
              T(0.5 * model_->links[i].mass) * link.vel.squaredNorm();
  }
  return energy;
}

template <typename T>
T TreeMotion<T>::weight_energy(const Vec3<T>& gravity) const {
  T energy(0);
  for (std::size_t i = 0; i < links_.size(); ++i)
    energy -= gravity.dot(links_[i].moment + T(model_->links[i].mass) * links_[i].o);
  return energy;
}

}  // namespace thenar
