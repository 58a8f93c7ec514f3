#pragma once

/// Accelerations in time linear in the links, by articulated bodies.

#include <vector>

#include <Eigen/Cholesky>

#include "base/error.h"
#include "dynamics/mechanism/tree_motion.h"

namespace thenar {

/// Forward dynamics of a tree whose links share no coordinates:
///   M(q) v_dot + h(q, v) = tau + loads.
/// Calls allocate nothing. Source: [Featherstone2008] section 7.3, with accelerations of the points
/// that are the joints' origins.
template <typename T>
class ArticulatedBody {
 public:
  /// @param model  must live on. @throws InputError if links share a coordinate.
  explicit ArticulatedBody(const TreeModel& model) : bodies_(model.links.size()) {
    require(!model.has_couplings, "links that share a coordinate have no articulated inertia");
  }

  /// @param motion   after set_speed(), with its loads
  /// @param gravity  of free fall [m/s^2] (3)
  /// @param tau      efforts at the joints, indexable [N m] or [N] (v)
  /// @param v_dot    accelerations, indexable [rad/s^2] or [m/s^2] (v)
  template <typename Tau, typename Acceleration>
  void accelerations(const TreeMotion<T>& motion, const Vec3<T>& gravity, const Tau& tau,
                     Acceleration&& v_dot) {
    start(motion);
    for (std::size_t i = bodies_.size(); i-- > 0;) fold(motion, i, tau);
    for (std::size_t i = 0; i < bodies_.size(); ++i) unfold(motion, gravity, i, v_dot);
  }

 private:
  /// Inertia [[A, B], [B', C]] and bias wrench at the link's origin, and what the joint needs.
  struct Body {
    Mat3<T> A, B, C;
    Vec3<T> m, f;              // wrench at zero acceleration of the joint
    Vec3<T> U_m, U_f;          // inertia times the axis, of a joint with one speed
    T D_inverse, u;            // of a joint with one speed
    Eigen::Matrix<T, 6, 6> U;  // inertia times the axes, of a ball or free joint
    Eigen::Matrix<T, 6, 6> D;  // its inverse
    Eigen::Matrix<T, 6, 1> effort;
    Vec3<T> a_w, a_v;  // acceleration
  };

  void start(const TreeMotion<T>& motion) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const MovingLink<T>& link = motion.links()[i];
      const T mass(motion.model().links[i].mass);
      Body& body = bodies_[i];
      // A rigid body:  m = I alpha + c x a,  f = mass a - c x alpha,  c its moment of mass.
      const Vec3<T>& c = link.moment;
      body.A = link.inertia;
      body.B << T(0), -c.z(), c.y(), c.z(), T(0), -c.x(), -c.y(), c.x(), T(0);
      body.C = mass * Mat3<T>::Identity();
      body.m = link.gyro_m - link.load_m;
      body.f = link.gyro_f - link.load_f;
    }
  }

  /// Takes the joint out of the inertia of link i, and adds what is left to the parent.
  template <typename Tau>
  void fold(const TreeMotion<T>& motion, std::size_t i, const Tau& tau) {
    const TreeLink& constant = motion.model().links[i];
    const MovingLink<T>& link = motion.links()[i];
    Body& body = bodies_[i];
    const bool passes = constant.parent >= 0;
    if (is_scalar(constant.kind)) {
      // One axis.
      const Vec3<T> axis = link.slope * link.E.col(2);
      const bool turns = constant.kind == JointKind::kHinge;
      if (turns) {
        body.U_m.noalias() = body.A * axis;
        body.U_f.noalias() = body.B.transpose() * axis;
      } else {
        body.U_m.noalias() = body.B * axis;
        body.U_f.noalias() = body.C * axis;
      }
      body.D_inverse = T(1) / axis.dot(turns ? body.U_m : body.U_f);
      body.u = tau[constant.v] - axis.dot(turns ? body.m : body.f);
      if (!passes) return;
      const Vec3<T> Um = body.D_inverse * body.U_m, Uf = body.D_inverse * body.U_f;
      body.A.noalias() -= body.U_m * Um.transpose();
      body.B.noalias() -= body.U_m * Uf.transpose();
      body.C.noalias() -= body.U_f * Uf.transpose();
      body.m += body.u * Um;
      body.f += body.u * Uf;
    } else {
      fold_many(constant, link, body, tau);
      if (!passes) return;
    }
    body.m.noalias() += body.A * link.zeta_w + body.B * link.zeta_v;
    body.f.noalias() += body.B.transpose() * link.zeta_w + body.C * link.zeta_v;
    add_to_parent(link.r, body, bodies_[static_cast<std::size_t>(constant.parent)]);
  }

  template <typename Tau>
  static void fold_many(const TreeLink& constant, const MovingLink<T>& link, Body& body,
                        const Tau& tau) {
    const int n = speeds_of(constant.kind);
    // The axes are those of F.
    body.U.setZero();
    body.U.template block<3, 3>(0, 0).noalias() = body.A * link.E;
    body.U.template block<3, 3>(3, 0).noalias() = body.B.transpose() * link.E;
    if (n == 6) {
      body.U.template block<3, 3>(0, 3).noalias() = body.B * link.E;
      body.U.template block<3, 3>(3, 3).noalias() = body.C * link.E;
    }
    Eigen::Matrix<T, 6, 6> D = Eigen::Matrix<T, 6, 6>::Identity();
    D.topLeftCorner(3, n).noalias() = link.E.transpose() * body.U.topLeftCorner(3, n);
    if (n == 6) D.bottomRows(3).noalias() = link.E.transpose() * body.U.bottomRows(3);
    body.D = D.llt().solve(Eigen::Matrix<T, 6, 6>::Identity());
    // Efforts less what the bias wrench needs.
    body.effort.setZero();
    for (int k = 0; k < n; ++k) body.effort[k] = tau[constant.v + k];
    body.effort.template head<3>().noalias() -= link.E.transpose() * body.m;
    if (n == 6) body.effort.template tail<3>().noalias() -= link.E.transpose() * body.f;
    if (constant.parent < 0) return;
    const Eigen::Matrix<T, 6, 6> UD = body.U.leftCols(n) * body.D.topRows(n);
    const Eigen::Matrix<T, 6, 6> lost = UD.leftCols(n) * body.U.leftCols(n).transpose();
    body.A -= lost.template topLeftCorner<3, 3>();
    body.B -= lost.template topRightCorner<3, 3>();
    body.C -= lost.template bottomRightCorner<3, 3>();
    const Eigen::Matrix<T, 6, 1> pushed = UD * body.effort;
    body.m += pushed.template head<3>();
    body.f += pushed.template tail<3>();
  }

  /// Moves an inertia and a wrench by -r, to the parent's origin.
  static void add_to_parent(const Vec3<T>& r, const Body& body, Body& parent) {
    Mat3<T> B_moved, turned;
    for (int k = 0; k < 3; ++k) B_moved.col(k) = body.B.col(k) + r.cross(body.C.col(k));
    // A - B [r] + [r] B_moved'
    for (int k = 0; k < 3; ++k) turned.col(k) = r.cross(body.B.row(k).transpose());
    parent.A += body.A + turned.transpose();
    for (int k = 0; k < 3; ++k) parent.A.col(k) += r.cross(B_moved.row(k).transpose());
    parent.B += B_moved;
    parent.C += body.C;
    parent.m += body.m + r.cross(body.f);
    parent.f += body.f;
  }

  template <typename Acceleration>
  void unfold(const TreeMotion<T>& motion, const Vec3<T>& gravity, std::size_t i,
              Acceleration& v_dot) {
    const TreeLink& constant = motion.model().links[i];
    const MovingLink<T>& link = motion.links()[i];
    Body& body = bodies_[i];
    // With the parent. A world that falls upwards stands for weights.
    if (constant.parent < 0) {
      body.a_w = link.zeta_w;
      body.a_v = link.zeta_v - gravity;
    } else {
      const Body& parent = bodies_[static_cast<std::size_t>(constant.parent)];
      body.a_w = parent.a_w + link.zeta_w;
      body.a_v = parent.a_v + parent.a_w.cross(link.r) + link.zeta_v;
    }
    // And by the joint.
    if (is_scalar(constant.kind)) {
      // At the world the velocity product was not folded in.
      const T rate = body.D_inverse * (body.u - body.U_m.dot(body.a_w) - body.U_f.dot(body.a_v));
      v_dot[constant.v] = rate;
      const Vec3<T> axis = (link.slope * rate) * link.E.col(2);
      if (constant.kind == JointKind::kHinge)
        body.a_w += axis;
      else
        body.a_v += axis;
      return;
    }
    const int n = speeds_of(constant.kind);
    Eigen::Matrix<T, 6, 1> acceleration;
    acceleration << body.a_w, body.a_v;
    const Eigen::Matrix<T, 6, 1> rate = body.D * (body.effort - body.U.transpose() * acceleration);
    for (int k = 0; k < n; ++k) v_dot[constant.v + k] = rate[k];
    body.a_w.noalias() += link.E * rate.template head<3>();
    if (n == 6) body.a_v.noalias() += link.E * rate.template tail<3>();
  }

  std::vector<Body> bodies_;
};

}  // namespace thenar
