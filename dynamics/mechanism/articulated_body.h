#pragma once

/// Forward dynamics by the articulated-body algorithm, in time linear in the number of links.

#include <vector>

#include <Eigen/Cholesky>

#include "base/error.h"
#include "dynamics/mechanism/tree_motion.h"

namespace thenar {

namespace internal {

/// Symmetric 3 x 3 matrix stored as its upper triangle: half the work of a full one.
template <typename T>
struct Symmetric3 {
  T xx, xy, xz, yy, yz, zz;

  [[nodiscard]] Vec3<T> operator*(const Vec3<T>& v) const {
    return {xx * v.x() + xy * v.y() + xz * v.z(), xy * v.x() + yy * v.y() + yz * v.z(),
            xz * v.x() + yz * v.y() + zz * v.z()};
  }
  void operator+=(const Symmetric3& other) {
    xx += other.xx, xy += other.xy, xz += other.xz;
    yy += other.yy, yz += other.yz, zz += other.zz;
  }
  /// Subtracts a b', which must be symmetric.
  void subtract(const Vec3<T>& a, const Vec3<T>& b) {
    xx -= a.x() * b.x(), xy -= a.x() * b.y(), xz -= a.x() * b.z();
    yy -= a.y() * b.y(), yz -= a.y() * b.z(), zz -= a.z() * b.z();
  }
  /// Adds a symmetric matrix.
  void add(const Mat3<T>& full) {
    xx += full(0, 0), xy += full(0, 1), xz += full(0, 2);
    yy += full(1, 1), yz += full(1, 2), zz += full(2, 2);
  }
  [[nodiscard]] Mat3<T> full() const {
    Mat3<T> out;
    out << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return out;
  }
};

}  // namespace internal

/// Forward dynamics of a tree whose links share no coordinates:
///   M(q) v_dot + h(q, v) = tau + loads.
/// Calls do not allocate memory. Source: [Featherstone2008] section 7.3, here with accelerations of
/// the joint origins. The accelerations at v_dot = 0 and the wrenches that they need are computed
/// link by link first, so that articulated inertias carry no velocity products.
template <typename T>
class ArticulatedBody {
 public:
  /// @param model  must outlive the object. @throws InputError if links share a coordinate.
  explicit ArticulatedBody(const TreeModel& model) : bodies_(model.links.size()) {
    require(!model.has_couplings, "links that share a coordinate have no articulated inertia");
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (is_scalar(model.links[i].kind)) continue;
      bodies_[i].multi_axis_index = multi_axis_.size();
      multi_axis_.emplace_back();
    }
  }

  /// Computes accelerations.
  /// @param motion   motion after set_speed(), with its loads
  /// @param gravity  acceleration of free fall [m/s^2] (3)
  /// @param tau      generalized forces, indexable [N m] or [N] (v)
  /// @param v_dot    accelerations, indexable [rad/s^2] or [m/s^2] (v)
  template <typename Tau, typename Acceleration>
  void accelerations(const TreeMotion<T>& motion, const Vec3<T>& gravity, const Tau& tau,
                     Acceleration&& v_dot) {
    initialise(motion, gravity);
    for (std::size_t i = bodies_.size(); i-- > 0;) eliminate_joint(motion, i, tau);
    for (std::size_t i = 0; i < bodies_.size(); ++i) propagate(motion, i, v_dot);
  }

 private:
  /// Articulated inertia [[A, B], [B', C]] and bias wrench at the link's origin, and terms of its
  /// joint.
  struct Body {
    internal::Symmetric3<T> A, C;
    Mat3<T> B;
    Vec3<T> m, f;                      // bias wrench at v_dot = 0
    Vec3<T> U_m, U_f;                  // inertia times the axis of a hinge or slide
    T D_inverse, u;                    // its inverse axis inertia, and its effort beyond the bias
    Vec3<T> a_w, a_v;                  // acceleration at v_dot = 0, then its increase by v_dot
    std::size_t multi_axis_index = 0;  // index in multi_axis_ of a ball or free joint
  };
  /// Matrices of a ball or free joint.
  struct MultiAxisJoint {
    Eigen::Matrix<T, 6, 6> U;  // inertia times the axes
    Eigen::Matrix<T, 6, 6> D;  // inverse of the inertia seen by the axes
    Eigen::Matrix<T, 6, 1> effort;
  };

  /// Sets the inertias of single links and their bias wrenches at v_dot = 0.
  void initialise(const TreeMotion<T>& motion, const Vec3<T>& gravity) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const MovingLink<T>& link = motion.links()[i];
      const TreeLink& constant = motion.model().links[i];
      const T mass(constant.mass);
      Body& body = bodies_[i];
      // Compute the acceleration at v_dot = 0; weights become an upward acceleration of the world.
      if (constant.parent < 0) {
        body.a_w = link.zeta_w;
        body.a_v = link.zeta_v - gravity;
      } else {
        const Body& parent = bodies_[constant.parent];
        body.a_w = parent.a_w + link.zeta_w;
        body.a_v = parent.a_v + parent.a_w.cross(link.r) + link.zeta_v;
      }
      // Set up the rigid body:  m = I alpha + c x a,  f = mass a - c x alpha,  c its moment of
      // mass.
      const Vec3<T>& c = link.moment;
      const Mat3<T>& I = link.inertia;
      body.A = {I(0, 0), I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2)};
      body.B << T(0), -c.z(), c.y(), c.z(), T(0), -c.x(), -c.y(), c.x(), T(0);
      body.C = {mass, T(0), T(0), mass, T(0), mass};
      body.m = link.gyro_m - link.load_m + body.A * body.a_w + c.cross(body.a_v);
      body.f = link.gyro_f - link.load_f + mass * body.a_v - c.cross(body.a_w);
    }
  }

  /// Eliminates the joint of link i from its inertia, and adds the rest to the parent's.
  template <typename Tau>
  void eliminate_joint(const TreeMotion<T>& motion, std::size_t i, const Tau& tau) {
    const TreeLink& constant = motion.model().links[i];
    const MovingLink<T>& link = motion.links()[i];
    Body& body = bodies_[i];
    const bool passes = constant.parent >= 0;
    if (is_scalar(constant.kind)) {
      // Compute the terms of the single axis.
      const Vec3<T> axis = link.slope * link.E.col(2);
      const bool turns = constant.kind == JointKind::kHinge;
      if (turns) {
        body.U_m = body.A * axis;
        body.U_f.noalias() = body.B.transpose() * axis;
      } else {
        body.U_m.noalias() = body.B * axis;
        body.U_f = body.C * axis;
      }
      body.D_inverse = T(1) / axis.dot(turns ? body.U_m : body.U_f);
      body.u = tau[constant.first_v] - axis.dot(turns ? body.m : body.f);
      if (!passes) return;
      // Remove the axis from the inertia, and add the effort to the bias wrench.
      const Vec3<T> Um = body.D_inverse * body.U_m, Uf = body.D_inverse * body.U_f;
      body.A.subtract(body.U_m, Um);
      body.B.noalias() -= body.U_m * Uf.transpose();
      body.C.subtract(body.U_f, Uf);
      body.m += body.u * Um;
      body.f += body.u * Uf;
    } else {
      eliminate_multi_axis(constant, link, body, multi_axis_[body.multi_axis_index], tau);
      if (!passes) return;
    }
    add_to_parent(link.r, body, bodies_[constant.parent]);
  }

  template <typename Tau>
  static void eliminate_multi_axis(const TreeLink& constant, const MovingLink<T>& link, Body& body,
                                   MultiAxisJoint& multi, const Tau& tau) {
    const int n = speed_count(constant.kind);
    // Compute inertia times the axes of F, and the inverse of the inertia that the axes see.
    multi.U.setZero();
    multi.U.template block<3, 3>(0, 0).noalias() = body.A.full() * link.E;
    multi.U.template block<3, 3>(3, 0).noalias() = body.B.transpose() * link.E;
    if (n == 6) {
      multi.U.template block<3, 3>(0, 3).noalias() = body.B * link.E;
      multi.U.template block<3, 3>(3, 3).noalias() = body.C.full() * link.E;
    }
    Eigen::Matrix<T, 6, 6> D = Eigen::Matrix<T, 6, 6>::Identity();
    D.topLeftCorner(3, n).noalias() = link.E.transpose() * multi.U.topLeftCorner(3, n);
    if (n == 6) D.bottomRows(3).noalias() = link.E.transpose() * multi.U.bottomRows(3);
    multi.D = D.llt().solve(Eigen::Matrix<T, 6, 6>::Identity());
    // Subtract the bias wrench from the efforts.
    multi.effort.setZero();
    for (int k = 0; k < n; ++k) multi.effort[k] = tau[constant.first_v + k];
    multi.effort.template head<3>().noalias() -= link.E.transpose() * body.m;
    if (n == 6) multi.effort.template tail<3>().noalias() -= link.E.transpose() * body.f;
    if (constant.parent < 0) return;
    // Remove the axes from the inertia, and add the efforts to the bias wrench.
    const Eigen::Matrix<T, 6, 6> UD = multi.U.leftCols(n) * multi.D.topRows(n);
    const Eigen::Matrix<T, 6, 6> lost = UD.leftCols(n) * multi.U.leftCols(n).transpose();
    body.A.add(-lost.template topLeftCorner<3, 3>());
    body.B -= lost.template topRightCorner<3, 3>();
    body.C.add(-lost.template bottomRightCorner<3, 3>());
    const Eigen::Matrix<T, 6, 1> pushed = UD * multi.effort;
    body.m += pushed.template head<3>();
    body.f += pushed.template tail<3>();
  }

  /// Shifts an inertia and a wrench by -r to the parent's origin, and adds them to the parent's:
  ///   C,   M = B + [r] C,   A - B [r] + [r] M'.
  static void add_to_parent(const Vec3<T>& r, const Body& body, Body& parent) {
    const T x = r.x(), y = r.y(), z = r.z();
    const internal::Symmetric3<T>&A = body.A, &C = body.C;
    const Mat3<T>& B = body.B;
    // Compute  M = B + [r] C.
    Mat3<T> M;
    M(0, 0) = B(0, 0) + y * C.xz - z * C.xy;
    M(1, 0) = B(1, 0) + z * C.xx - x * C.xz;
    M(2, 0) = B(2, 0) + x * C.xy - y * C.xx;
    M(0, 1) = B(0, 1) + y * C.yz - z * C.yy;
    M(1, 1) = B(1, 1) + z * C.xy - x * C.yz;
    M(2, 1) = B(2, 1) + x * C.yy - y * C.xy;
    M(0, 2) = B(0, 2) + y * C.zz - z * C.yz;
    M(1, 2) = B(1, 2) + z * C.xz - x * C.zz;
    M(2, 2) = B(2, 2) + x * C.yz - y * C.xz;
    // Column k of -B [r], as a row, is r x (row k of B); column k of [r] M' is r x (row k of M).
    parent.A.xx += A.xx + (y * B(0, 2) - z * B(0, 1)) + (y * M(0, 2) - z * M(0, 1));
    parent.A.xy += A.xy + (z * B(0, 0) - x * B(0, 2)) + (y * M(1, 2) - z * M(1, 1));
    parent.A.xz += A.xz + (x * B(0, 1) - y * B(0, 0)) + (y * M(2, 2) - z * M(2, 1));
    parent.A.yy += A.yy + (z * B(1, 0) - x * B(1, 2)) + (z * M(1, 0) - x * M(1, 2));
    parent.A.yz += A.yz + (x * B(1, 1) - y * B(1, 0)) + (z * M(2, 0) - x * M(2, 2));
    parent.A.zz += A.zz + (x * B(2, 1) - y * B(2, 0)) + (x * M(2, 1) - y * M(2, 0));
    // Add the rest of the inertia, and the wrench with its lever arm.
    parent.B += M;
    parent.C += C;
    parent.m += body.m + r.cross(body.f);
    parent.f += body.f;
  }

  /// Computes the acceleration of joint i and of its link from that of the parent.
  template <typename Acceleration>
  void propagate(const TreeMotion<T>& motion, std::size_t i, Acceleration& v_dot) {
    const TreeLink& constant = motion.model().links[i];
    const MovingLink<T>& link = motion.links()[i];
    Body& body = bodies_[i];
    // Start with the acceleration of the parent.
    Vec3<T> a_w = Vec3<T>::Zero(), a_v = a_w;
    if (constant.parent >= 0) {
      const Body& parent = bodies_[constant.parent];
      a_w = parent.a_w;
      a_v = parent.a_v + a_w.cross(link.r);
    }
    // Add the acceleration of the joint.
    if (is_scalar(constant.kind)) {
      const T rate = body.D_inverse * (body.u - body.U_m.dot(a_w) - body.U_f.dot(a_v));
      v_dot[constant.first_v] = rate;
      const Vec3<T> axis = (link.slope * rate) * link.E.col(2);
      (constant.kind == JointKind::kHinge ? a_w : a_v) += axis;
    } else {
      const MultiAxisJoint& multi = multi_axis_[body.multi_axis_index];
      const int n = speed_count(constant.kind);
      Eigen::Matrix<T, 6, 1> moved;
      moved << a_w, a_v;
      const Eigen::Matrix<T, 6, 1> rate = multi.D * (multi.effort - multi.U.transpose() * moved);
      for (int k = 0; k < n; ++k) v_dot[constant.first_v + k] = rate[k];
      a_w.noalias() += link.E * rate.template head<3>();
      if (n == 6) a_v.noalias() += link.E * rate.template tail<3>();
    }
    body.a_w = a_w;
    body.a_v = a_v;
  }

  std::vector<Body> bodies_;
  std::vector<MultiAxisJoint> multi_axis_;
};

}  // namespace thenar
