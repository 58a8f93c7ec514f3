#pragma once

/// Inverse dynamics, and the mass matrix with its factorisation.

#include <vector>

#include "dynamics/mechanism/tree_motion.h"

namespace thenar {

/// Inverse dynamics  tau = M v_dot + h - loads  by the recursive Newton-Euler algorithm. Calls do
/// not allocate memory. Source: [Featherstone2008] section 5.3.
template <typename T>
class InverseDynamics {
 public:
  explicit InverseDynamics(const TreeModel& model) : bodies_(model.links.size()) {}

  /// Computes the generalized forces of a motion.
  /// @param motion   motion after set_speed(), with its loads
  /// @param gravity  acceleration of free fall [m/s^2] (3)
  /// @param v_dot    accelerations, indexable [rad/s^2] or [m/s^2] (v)
  /// @param tau      generalized forces, indexable [N m] or [N] (v)
  template <typename Acceleration, typename Tau>
  void efforts(const TreeMotion<T>& motion, const Vec3<T>& gravity, const Acceleration& v_dot,
               Tau&& tau) {
    const std::vector<TreeLink>& constants = motion.model().links;
    for (int k = 0; k < motion.model().layout.v; ++k) tau[k] = T(0);
    // Outward pass: compute accelerations, and the wrench that each link needs.
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const MovingLink<T>& link = motion.links()[i];
      const TreeLink& constant = constants[i];
      Body& body = bodies_[i];
      body.a_w = link.zeta_w;
      body.a_v = link.zeta_v - gravity;
      if (constant.parent >= 0) {
        const Body& parent = bodies_[constant.parent];
        body.a_w = parent.a_w + link.zeta_w;
        body.a_v = parent.a_v + parent.a_w.cross(link.r) + link.zeta_v;
      }
      add_joint_acceleration(constant, link, v_dot, body);
      body.m = link.inertia * body.a_w + link.moment.cross(body.a_v) + link.gyro_m - link.load_m;
      body.f =
          T(constant.mass) * body.a_v - link.moment.cross(body.a_w) + link.gyro_f - link.load_f;
    }
    // Inward pass: sum the wrenches, and project them on the joint axes.
    for (std::size_t i = bodies_.size(); i-- > 0;) {
      const MovingLink<T>& link = motion.links()[i];
      const TreeLink& constant = constants[i];
      const Body& body = bodies_[i];
      if (constant.parent >= 0) {
        Body& parent = bodies_[constant.parent];
        parent.m += body.m + link.r.cross(body.f);
        parent.f += body.f;
      }
      internal::add_along_axes<T>(constant, link, body.m, body.f, tau);
    }
  }

 private:
  struct Body {
    Vec3<T> a_w, a_v, m, f;  // acceleration and wrench of a link at its origin
  };

  template <typename Acceleration>
  static void add_joint_acceleration(const TreeLink& constant, const MovingLink<T>& link,
                                     const Acceleration& v_dot, Body& body) {
    switch (constant.kind) {
      case JointKind::kHinge:
        body.a_w += (link.slope * v_dot[constant.first_v]) * link.E.col(2);
        break;
      case JointKind::kSlide:
        body.a_v += (link.slope * v_dot[constant.first_v]) * link.E.col(2);
        break;
      default:
        for (int k = 0; k < 3; ++k) body.a_w += v_dot[constant.first_v + k] * link.E.col(k);
        if (constant.kind == JointKind::kBall) break;
        for (int k = 0; k < 3; ++k) body.a_v += v_dot[constant.first_v + 3 + k] * link.E.col(k);
    }
  }

  std::vector<Body> bodies_;
};

/// Mass matrix by composite rigid bodies, and its sparse factorisation  M = L' D L  with a unit
/// lower triangular L. Calls do not allocate memory. Source: [Featherstone2008] sections 6.2
/// and 6.5.
template <typename T>
class MassMatrix {
 public:
  explicit MassMatrix(const TreeModel& model)
      : bodies_(model.links.size()),
        size_(static_cast<std::size_t>(model.layout.v)),
        M_(size_ * size_, T(0)),
        L_(M_),
        D_inverse_(size_, T(0)),
        D_inverse_root_(size_, T(0)) {}

  /// Computes and factorises M(q). Call after motion.set_position().
  /// @return false if a pivot is not positive: masses are too unequal for doubles
  bool compute(const TreeMotion<T>& motion) {
    assemble(motion);
    return factorise(motion.model());
  }
  /// Computes and factorises M(q) plus a diagonal, such as  h damping + h^2 stiffness  of an
  /// implicit step. @param diagonal  indexable (v)
  template <typename Diagonal>
  bool compute(const TreeMotion<T>& motion, const Diagonal& diagonal) {
    assemble(motion);
    for (std::size_t k = 0; k < size_; ++k) M_[k * size_ + k] += diagonal[at(k)];
    return factorise(motion.model());
  }
  /// Computes and factorises M(q) plus a diagonal and a symmetric matrix, of which entries outside
  /// the tree's sparsity pattern are ignored.
  /// @param added  indexable by (i, j) (v, v)
  template <typename Diagonal, typename Added>
  bool compute(const TreeMotion<T>& motion, const Diagonal& diagonal, const Added& added) {
    assemble(motion);
    // Add the diagonals, and the entries within the sparsity pattern.
    for (std::size_t k = 0; k < size_; ++k) {
      M_[k * size_ + k] += diagonal[at(k)] + added(at(k), at(k));
      for (const int i : motion.model().coupled_to[k]) {
        entry(static_cast<int>(k), i) += added(at(k), i);
        entry(i, static_cast<int>(k)) += added(at(k), i);
      }
    }
    return factorise(motion.model());
  }

  /// Returns an entry of M.
  [[nodiscard]] const T& operator()(int i, int j) const {
    return M_[static_cast<std::size_t>(i) * size_ + static_cast<std::size_t>(j)];
  }

  /// Computes x = M^-1 x. @param x  indexable (v)
  template <typename X>
  void solve(const TreeModel& model, X&& x) const {
    solve_transposed_factor(model, x);
    for (std::size_t k = 0; k < size_; ++k) x[at(k)] *= D_inverse_[k];
    solve_factor(model, x);
  }

  /// Computes x = D^-1/2 L'^-1 x, so that the dot product of two results is  x' M^-1 y.
  template <typename X>
  void half_solve(const TreeModel& model, X&& x) const {
    solve_transposed_factor(model, x);
    for (std::size_t k = 0; k < size_; ++k) x[at(k)] *= D_inverse_root_[k];
  }

 private:
  struct Body {
    T mass;           // mass of the composite body [kg]
    Vec3<T> moment;   // mass times centre of mass from the origin [kg m]
    Mat3<T> inertia;  // inertia about the origin [kg m^2]
  };

  static Eigen::Index at(std::size_t k) { return static_cast<Eigen::Index>(k); }
  T& entry(int i, int j) {
    return M_[static_cast<std::size_t>(i) * size_ + static_cast<std::size_t>(j)];
  }

  void assemble(const TreeMotion<T>& motion) {
    const std::vector<TreeLink>& constants = motion.model().links;
    for (T& entry : M_) entry = T(0);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      bodies_[i] = {T(constants[i].mass), motion.links()[i].moment, motion.links()[i].inertia};
    // Inward pass: merge everything beyond a joint into one body.
    for (std::size_t i = bodies_.size(); i-- > 0;) {
      if (constants[i].parent >= 0)
        merge_into_parent(bodies_[i], motion.links()[i].r, bodies_[constants[i].parent]);
      add_link_columns(motion, i);
    }
  }

  /// Adds a body with origin at r, relative to the parent's origin, to the parent's body.
  static void merge_into_parent(const Body& body, const Vec3<T>& r, Body& parent) {
    parent.mass += body.mass;
    const Vec3<T> moved = body.moment + body.mass * r;
    parent.moment += moved;
    // -[r][c] - [c + m r][r],  with  -[a][b] = (a . b) 1 - b a'
    const T on_diagonal = r.dot(body.moment) + moved.dot(r);
    parent.inertia += body.inertia;
    parent.inertia.noalias() -= body.moment * r.transpose() + r * moved.transpose();
    for (int k = 0; k < 3; ++k) parent.inertia(k, k) += on_diagonal;
  }

  /// Adds the entries of link i's velocities with its own and with those towards the root.
  void add_link_columns(const TreeMotion<T>& motion, std::size_t i) {
    const TreeLink& constant = motion.model().links[i];
    const MovingLink<T>& link = motion.links()[i];
    const Body& body = bodies_[i];
    const bool scalar = is_scalar(constant.kind);
    const int n = speed_count(constant.kind);
    for (int k = 0; k < n; ++k) {
      // Compute the wrench at the origin for unit acceleration of velocity k.
      const Vec3<T> axis =
          scalar ? Vec3<T>(link.slope * link.E.col(2)) : Vec3<T>(link.E.col(k % 3));
      const bool turns = scalar ? constant.kind == JointKind::kHinge : k < 3;
      Vec3<T> m, f;
      if (turns) {
        m.noalias() = body.inertia * axis;
        f = axis.cross(body.moment);
      } else {
        f = body.mass * axis;
        m = body.moment.cross(axis);
      }
      // Project it on the axes of this joint and of all joints towards the root.
      add_row_to_root(motion, static_cast<int>(i), constant.first_v + k, m, f);
    }
  }

  /// Adds one row of M: a wrench projected on the axes of each joint from a link to the root.
  void add_row_to_root(const TreeMotion<T>& motion, int first, int row, Vec3<T> m,
                       const Vec3<T>& f) {
    int at = first;
    while (at >= 0) {
      const TreeLink& constant = motion.model().links[at];
      const MovingLink<T>& link = motion.links()[at];
      const bool own = at == first;
      switch (constant.kind) {
        case JointKind::kHinge:
          add_entry_pair(row, constant.first_v, link.slope * link.E.col(2).dot(m), own);
          break;
        case JointKind::kSlide:
          add_entry_pair(row, constant.first_v, link.slope * link.E.col(2).dot(f), own);
          break;
        default:
          for (int k = 0; k < 3; ++k)
            add_entry_pair(row, constant.first_v + k, link.E.col(k).dot(m), own);
          if (constant.kind == JointKind::kBall) break;
          for (int k = 0; k < 3; ++k)
            add_entry_pair(row, constant.first_v + 3 + k, link.E.col(k).dot(f), own);
      }
      m += link.r.cross(f);
      at = constant.parent;
    }
  }

  /// Adds an entry of M, and its transpose if it belongs to two links; a coordinate that both share
  /// then counts twice.
  void add_entry_pair(int row, int column, const T& value, bool own) {
    entry(row, column) += value;
    if (!own) entry(column, row) += value;
  }

  bool factorise(const TreeModel& model) {
    // Copy the entries of M within the sparsity pattern.
    for (std::size_t k = 0; k < size_; ++k) L_[k * size_ + k] = M_[k * size_ + k];
    for (std::size_t k = 0; k < size_; ++k)
      for (const int i : model.coupled_to[k]) {
        const std::size_t at_ki = k * size_ + static_cast<std::size_t>(i);
        L_[at_ki] = M_[at_ki];
      }
    // Eliminate from the last velocity: invert its pivot, then update the rows coupled to it.
    bool positive = true;
    for (std::size_t k = size_; k-- > 0;) {
      T* row = &L_[k * size_];
      positive = positive && row[k] > T(0);
      D_inverse_[k] = T(1) / row[k];
      using std::sqrt;
      D_inverse_root_[k] = sqrt(D_inverse_[k]);
      const std::vector<int>& below = model.coupled_to[k];
      for (std::size_t a = below.size(); a-- > 0;) {
        const auto i = static_cast<std::size_t>(below[a]);
        const T share = row[i] * D_inverse_[k];
        for (std::size_t b = 0; b <= a; ++b) {
          const auto j = static_cast<std::size_t>(below[b]);
          L_[i * size_ + j] -= share * row[j];
        }
        row[i] = share;
      }
    }
    return positive;
  }

  /// Computes x = L'^-1 x. Skips zeros: rows of contacts have entries in one or two branches only.
  template <typename X>
  void solve_transposed_factor(const TreeModel& model, X& x) const {
    for (std::size_t k = size_; k-- > 0;) {
      const T value = x[at(k)];
      if (value == T(0)) continue;
      const T* row = &L_[k * size_];
      for (const int i : model.coupled_to[k]) x[i] -= row[i] * value;
    }
  }
  /// Computes x = L^-1 x.
  template <typename X>
  void solve_factor(const TreeModel& model, X& x) const {
    for (std::size_t k = 0; k < size_; ++k) {
      const T* row = &L_[k * size_];
      for (const int i : model.coupled_to[k]) x[at(k)] -= row[i] * x[i];
    }
  }

  std::vector<Body> bodies_;
  std::size_t size_;
  std::vector<T> M_, L_;                       // row-major (v, v)
  std::vector<T> D_inverse_, D_inverse_root_;  // 1 / D and its square root (v)
};

}  // namespace thenar
