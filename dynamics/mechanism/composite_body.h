#pragma once

/// Mass matrix, its factor, and the efforts that a motion needs.

#include <vector>

#include "dynamics/mechanism/tree_motion.h"

namespace thenar {

/// Inverse dynamics: efforts tau of  M v_dot + h = tau + loads  [N m] or [N].
/// @param motion   after set_speed(), with its loads
/// @param gravity  of free fall [m/s^2] (3)
/// @param v_dot    accelerations, indexable (v)
/// @param tau      efforts, indexable (v)
/// Source: [Featherstone2008] section 5.3 (recursive Newton-Euler).
template <typename T>
class InverseDynamics {
 public:
  explicit InverseDynamics(const TreeModel& model) : bodies_(model.links.size()) {}

  template <typename Acceleration, typename Tau>
  void efforts(const TreeMotion<T>& motion, const Vec3<T>& gravity, const Acceleration& v_dot,
               Tau&& tau) {
    const std::vector<TreeLink>& constants = motion.model().links;
    for (int k = 0; k < motion.model().layout.v; ++k) tau[k] = T(0);
    // Outwards: accelerations, and the wrench that each link needs.
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const MovingLink<T>& link = motion.links()[i];
      const TreeLink& constant = constants[i];
      Body& body = bodies_[i];
      body.a_w = link.zeta_w;
      body.a_v = link.zeta_v - gravity;
      if (constant.parent >= 0) {
        const Body& parent = bodies_[static_cast<std::size_t>(constant.parent)];
        body.a_w = parent.a_w + link.zeta_w;
        body.a_v = parent.a_v + parent.a_w.cross(link.r) + link.zeta_v;
      }
      add_joint(constant, link, v_dot, body);
      body.m = link.inertia * body.a_w + link.moment.cross(body.a_v) + link.gyro_m - link.load_m;
      body.f =
          T(constant.mass) * body.a_v - link.moment.cross(body.a_w) + link.gyro_f - link.load_f;
    }
    // Inwards: what passes through each joint.
    for (std::size_t i = bodies_.size(); i-- > 0;) {
      const MovingLink<T>& link = motion.links()[i];
      const TreeLink& constant = constants[i];
      const Body& body = bodies_[i];
      if (constant.parent >= 0) {
        Body& parent = bodies_[static_cast<std::size_t>(constant.parent)];
        parent.m += body.m + link.r.cross(body.f);
        parent.f += body.f;
      }
      internal::add_along_axes<T>(constant, link, body.m, body.f, tau);
    }
  }

 private:
  struct Body {
    Vec3<T> a_w, a_v, m, f;
  };

  template <typename Acceleration>
  static void add_joint(const TreeLink& constant, const MovingLink<T>& link,
                        const Acceleration& v_dot, Body& body) {
    switch (constant.kind) {
      case JointKind::kHinge:
        body.a_w += (link.slope * v_dot[constant.v]) * link.E.col(2);
        break;
      case JointKind::kSlide:
        body.a_v += (link.slope * v_dot[constant.v]) * link.E.col(2);
        break;
      default:
        for (int k = 0; k < 3; ++k) body.a_w += v_dot[constant.v + k] * link.E.col(k);
        if (constant.kind == JointKind::kBall) break;
        for (int k = 0; k < 3; ++k) body.a_v += v_dot[constant.v + 3 + k] * link.E.col(k);
    }
  }

  std::vector<Body> bodies_;
};

/// Mass matrix by composite rigid bodies, and its factor  M = L' D L,  L with ones on its diagonal
/// and entries only where the tree has them. Calls allocate nothing.
/// Source: [Featherstone2008] sections 6.2 and 6.5.
template <typename T>
class MassMatrix {
 public:
  explicit MassMatrix(const TreeModel& model)
      : bodies_(model.links.size()),
        size_(static_cast<std::size_t>(model.layout.v)),
        M_(size_ * size_, T(0)),
        L_(M_),
        D_inverse_(size_, T(0)),
        root_(size_, T(0)) {}

  /// M(q) and its factor, after motion.set_position().
  /// @return false if a pivot is not positive: masses too unequal for doubles.
  bool set(const TreeMotion<T>& motion) {
    assemble(motion);
    return factorise(motion.model());
  }
  /// Sets M(q) and its factor with numbers added to the diagonal, such as  h damping + h^2
  /// stiffness  of an implicit step. @param diagonal  indexable (v)
  template <typename Diagonal>
  bool set(const TreeMotion<T>& motion, const Diagonal& diagonal) {
    assemble(motion);
    for (std::size_t k = 0; k < size_; ++k) M_[k * size_ + k] += diagonal[at(k)];
    return factorise(motion.model());
  }
  /// Sets M(q) and its factor with a diagonal and a symmetric matrix added; only entries that the
  /// tree has count.
  /// @param added  indexable by (i, j) (v, v)
  template <typename Diagonal, typename Added>
  bool set(const TreeMotion<T>& motion, const Diagonal& diagonal, const Added& added) {
    assemble(motion);
    // Entries of added matrices that the tree has not are left out.
    for (std::size_t k = 0; k < size_; ++k) {
      M_[k * size_ + k] += diagonal[at(k)] + added(at(k), at(k));
      for (const int i : motion.model().coupled_to[k]) {
        entry(static_cast<int>(k), i) += added(at(k), i);
        entry(i, static_cast<int>(k)) += added(at(k), i);
      }
    }
    return factorise(motion.model());
  }

  /// Entry of M.
  [[nodiscard]] const T& operator()(int i, int j) const {
    return M_[static_cast<std::size_t>(i) * size_ + static_cast<std::size_t>(j)];
  }

  /// x = M^-1 x. @param x  indexable (v)
  template <typename X>
  void solve(const TreeModel& model, X&& x) const {
    down(model, x);
    for (std::size_t k = 0; k < size_; ++k) x[at(k)] *= D_inverse_[k];
    up(model, x);
  }

  /// x = D^-1/2 L'^-1 x, so that the product of two such is  x' M^-1 y.
  template <typename X>
  void half_solve(const TreeModel& model, X&& x) const {
    down(model, x);
    for (std::size_t k = 0; k < size_; ++k) x[at(k)] *= root_[k];
  }

 private:
  struct Body {
    T mass;
    Vec3<T> moment;
    Mat3<T> inertia;
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
    // Inwards: everything beyond a joint as one body.
    for (std::size_t i = bodies_.size(); i-- > 0;) {
      if (constants[i].parent >= 0)
        merge(bodies_[i], motion.links()[i].r,
              bodies_[static_cast<std::size_t>(constants[i].parent)]);
      columns_of(motion, i);
    }
  }

  /// Adds a body whose origin is at r to one at the parent's origin.
  static void merge(const Body& body, const Vec3<T>& r, Body& parent) {
    parent.mass += body.mass;
    const Vec3<T> moved = body.moment + body.mass * r;
    parent.moment += moved;
    // -[r][c] - [c + m r][r],  with  -[a][b] = (a . b) 1 - b a'
    const T on_diagonal = r.dot(body.moment) + moved.dot(r);
    parent.inertia += body.inertia;
    parent.inertia.noalias() -= body.moment * r.transpose() + r * moved.transpose();
    for (int k = 0; k < 3; ++k) parent.inertia(k, k) += on_diagonal;
  }

  /// Entries of the speeds of link i with its own and with those nearer to the root.
  void columns_of(const TreeMotion<T>& motion, std::size_t i) {
    const TreeLink& constant = motion.model().links[i];
    const MovingLink<T>& link = motion.links()[i];
    const Body& body = bodies_[i];
    const bool scalar = is_scalar(constant.kind);
    const int n = speeds_of(constant.kind);
    for (int k = 0; k < n; ++k) {
      // Wrench at the origin that accelerates speed k by 1.
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
      // With the speeds of the same joint, then inwards.
      spread_row(motion, static_cast<int>(i), constant.v + k, m, f);
    }
  }

  void spread_row(const TreeMotion<T>& motion, int first, int row, Vec3<T> m, const Vec3<T>& f) {
    int at = first;
    // Each joint on the way to the root takes the wrench along its axes.
    while (at >= 0) {
      const TreeLink& constant = motion.model().links[static_cast<std::size_t>(at)];
      const MovingLink<T>& link = motion.links()[static_cast<std::size_t>(at)];
      const bool own = at == first;
      switch (constant.kind) {
        case JointKind::kHinge:
          add_pair(row, constant.v, link.slope * link.E.col(2).dot(m), own);
          break;
        case JointKind::kSlide:
          add_pair(row, constant.v, link.slope * link.E.col(2).dot(f), own);
          break;
        default:
          for (int k = 0; k < 3; ++k) add_pair(row, constant.v + k, link.E.col(k).dot(m), own);
          if (constant.kind == JointKind::kBall) break;
          for (int k = 0; k < 3; ++k) add_pair(row, constant.v + 3 + k, link.E.col(k).dot(f), own);
      }
      m += link.r.cross(f);
      at = constant.parent;
    }
  }

  /// The pair (row, column) of one link, or of two: then both orders are meant, and a shared
  /// coordinate counts twice.
  void add_pair(int row, int column, const T& value, bool own) {
    entry(row, column) += value;
    if (!own) entry(column, row) += value;
  }

  bool factorise(const TreeModel& model) {
    // Entries of M that the tree has.
    for (std::size_t k = 0; k < size_; ++k) L_[k * size_ + k] = M_[k * size_ + k];
    for (std::size_t k = 0; k < size_; ++k)
      for (const int i : model.coupled_to[k]) {
        const std::size_t at_ki = k * size_ + static_cast<std::size_t>(i);
        L_[at_ki] = M_[at_ki];
      }
    // Elimination from the last speed: its pivot, then its row out of the rows coupled to it.
    bool positive = true;
    for (std::size_t k = size_; k-- > 0;) {
      T* row = &L_[k * size_];
      positive = positive && row[k] > T(0);
      D_inverse_[k] = T(1) / row[k];
      using std::sqrt;
      root_[k] = sqrt(D_inverse_[k]);
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

  /// x = L'^-1 x. Rows of contacts are zero but for one branch of the tree.
  template <typename X>
  void down(const TreeModel& model, X& x) const {
    for (std::size_t k = size_; k-- > 0;) {
      const T value = x[at(k)];
      if (value == T(0)) continue;
      const T* row = &L_[k * size_];
      for (const int i : model.coupled_to[k]) x[i] -= row[static_cast<std::size_t>(i)] * value;
    }
  }
  /// x = L^-1 x.
  template <typename X>
  void up(const TreeModel& model, X& x) const {
    for (std::size_t k = 0; k < size_; ++k) {
      const T* row = &L_[k * size_];
      for (const int i : model.coupled_to[k]) x[at(k)] -= row[static_cast<std::size_t>(i)] * x[i];
    }
  }

  std::vector<Body> bodies_;
  std::size_t size_;
  std::vector<T> M_, L_;  // row-major (v, v)
  std::vector<T> D_inverse_, root_;
};

}  // namespace thenar
