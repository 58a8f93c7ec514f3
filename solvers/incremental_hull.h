#pragma once

/// Convex hull in six dimensions that grows point by point, with bounds of its rounding errors.

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace thenar::internal {

using HullPoint = Eigen::Matrix<double, 6, 1>;

/// Beneath-beyond method with simplicial facets, without joggling.
///
/// A new facet contains the horizon ridge between a visible facet (n1, d1) and a hidden one (n2,
/// d2), and the new point p. With s = n'p - d, s1 > 0 >= s2, its plane is the pencil's
///     (n, d) ~ -s2 (n1, d1) + s1 (n2, d2),
/// a sum with weights >= 0. Facets that p is coplanar with, to rounding, are hidden and have s2 =
/// 0: no special case, either. Every plane carries a bound of |n'v - d| over its vertices v, which
/// grows by the same weights; where it exceeds 1e-13 of the size it is measured, and if need be the
/// plane solved anew.
///
/// Why the bounds hold: facets are a closed surface about an inner point whatever rounding does to
/// its convexity, so each ray from inside meets a facet in a point x of the true hull, and there
/// n'x >= d - error.
class Hull {
 public:
  struct Plane {
    HullPoint n;   // unit outward normal
    double d;      // offset: n'x <= d inside
    double error;  // |n'v - d| of its vertices is at most this
  };

  /// Starts from a simplex. @param simplex  seven points, affinely independent
  explicit Hull(const std::array<HullPoint, 7>& simplex);

  /// Facets at or beyond `bar` need no visit: they are no longer queued. Never raise it.
  void set_bar(double bar) { bar_ = bar; }

  /// Removes the facet of least offset from the queue and returns it; -1 when none is left below
  /// the bar.
  int pop_nearest();

  /// Adds a point beyond `facet`, which is replaced. @returns false if it is not, to rounding, and
  /// nothing was done
  bool insert(const HullPoint& p, int facet);

  [[nodiscard]] const Plane& plane(int facet) const { return planes_[facet]; }
  [[nodiscard]] int facets() const { return alive_; }
  [[nodiscard]] double error() const { return error_; }  // largest of all planes so far
  [[nodiscard]] double volume() const;                   // signed simplices: folds cancel
  [[nodiscard]] double inner_radius() const;             // least distance of a facet from inside

 private:
  struct Links {
    std::array<int, 6> vertex;
    std::array<int, 6> neighbour;     // across the ridge without the vertex of that place
    std::array<std::int8_t, 6> back;  // the place of this facet there
    std::uint32_t stamp;              // of the insertion that saw it last
    std::uint32_t birth;              // 0: free
    double s;                         // n'p - d in that insertion
  };
  struct Queued {
    double d;
    int facet;
    std::uint32_t birth;
  };
  struct Slot {
    std::uint64_t key;
    std::uint32_t stamp;
    int facet;  // -1: matched
    std::int8_t place;
  };
  struct Ridge {
    int facet;
    int place;
  };

  int new_facet();
  void queue(int facet);
  void find_visible(const HullPoint& p, int facet);
  int raise_facet(const Ridge& ridge, int point);
  void match_ridges(int facet, int place_of_point);
  void join(int facet, std::int8_t place, std::uint64_t key);
  [[nodiscard]] Plane pencil(const Links& seen, const Plane& a, const Links& hidden,
                             const Plane& b) const;
  void settle(int facet);
  [[nodiscard]] double residual(const Plane& plane, const Links& links) const;
  [[nodiscard]] Plane solve(const Links& links) const;

  std::vector<HullPoint> points_;
  std::vector<std::uint64_t> code_;  // of points: ridges are told apart by their sum
  std::vector<Plane> planes_;
  std::vector<Links> links_;
  std::vector<int> free_;
  std::vector<Queued> queue_;
  std::vector<int> visible_;
  std::vector<Ridge> horizon_;
  std::vector<Slot> table_;
  HullPoint inside_ = HullPoint::Zero();
  double bar_, size_ = 0, error_ = 0;
  std::uint32_t stamp_ = 0, births_ = 0;
  int alive_ = 0;
};

}  // namespace thenar::internal
