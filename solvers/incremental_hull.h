#pragma once

/// Incremental convex hull in six dimensions with bounds of its rounding errors.

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace thenar::internal {

using HullPoint = Eigen::Matrix<double, 6, 1>;

/// Convex hull by the beneath-beyond method with simplicial facets, without joggling.
///
/// A new facet contains the horizon ridge between a visible facet (n1, d1) and a hidden one (n2,
/// d2), and the new point p. With s = n'p - d, s1 > 0 >= s2, its plane is the pencil's
///     (n, d) ~ -s2 (n1, d1) + s1 (n2, d2),
/// a sum with weights >= 0. Facets that are coplanar with p, to rounding, count as hidden and have
/// s2 = 0, so they need no special case. Every plane carries a bound of |n'v - d| over its vertices
/// v, which is propagated with the same weights. If the bound exceeds 1e-13 of the size, the
/// residual is computed and, if it is still too large, the plane is solved for again.
///
/// The bounds hold because the facets are a closed surface about an inner point even if rounding
/// makes it nonconvex: each ray from inside meets a facet in a point x of the true hull, and there
/// n'x >= d - error.
class Hull {
 public:
  struct Plane {
    HullPoint n;   // unit outward normal
    double d;      // offset: n'x <= d inside
    double error;  // upper bound of |n'v - d| over its vertices
  };

  /// Starts from a simplex. @param simplex  seven affinely independent points
  explicit Hull(const std::array<HullPoint, 7>& simplex);

  /// Sets the offset from which facets are no longer queued. It must never be raised.
  void set_offset_limit(double limit) { offset_limit_ = limit; }

  /// Removes the facet with the smallest offset from the queue and returns it; -1 if none is left
  /// below the limit.
  int pop_nearest();

  /// Adds a point beyond `facet`, which is replaced.
  /// @return false if the point is not beyond it, to rounding; the hull is unchanged
  bool insert(const HullPoint& p, int facet);

  [[nodiscard]] const Plane& plane(int facet) const { return planes_[facet]; }
  [[nodiscard]] int facets() const { return facet_count_; }
  [[nodiscard]] double error() const { return error_; }  // largest plane error so far
  [[nodiscard]] double volume() const;        // sum of signed simplex volumes: folds cancel
  [[nodiscard]] double inner_radius() const;  // minimum distance of a facet from the inner point

 private:
  struct Links {
    std::array<int, 6> vertex;
    std::array<int, 6> neighbour;  // facet across the ridge opposite the vertex of the same index
    std::array<std::int8_t, 6> back;  // index of this facet in that neighbour
    std::uint32_t insertion;          // number of the insertion that visited the facet last
    std::uint32_t serial;             // serial number of the facet; 0: unused entry
    double s;                         // n'p - d of the point of that insertion
  };
  struct Queued {
    double d;
    int facet;
    std::uint32_t serial;
  };
  struct Slot {
    std::uint64_t key;
    std::uint32_t insertion;
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
  int add_facet(const Ridge& ridge, int point);
  void match_ridges(int facet, int place_of_point);
  void match_ridge(int facet, std::int8_t place, std::uint64_t key);
  [[nodiscard]] Plane pencil_plane(const Links& seen, const Plane& a, const Links& hidden,
                                   const Plane& b) const;
  void check_plane(int facet);
  [[nodiscard]] double residual(const Plane& plane, const Links& links) const;
  [[nodiscard]] Plane solve(const Links& links) const;

  std::vector<HullPoint> points_;
  // Random codes of points: a ridge is identified by the sum of its points' codes
  std::vector<std::uint64_t> codes_;
  std::vector<Plane> planes_;
  std::vector<Links> links_;
  std::vector<int> free_;
  std::vector<Queued> queue_;
  std::vector<int> visible_;
  std::vector<Ridge> horizon_;
  std::vector<Slot> table_;
  HullPoint inside_ = HullPoint::Zero();
  double offset_limit_, size_ = 0, error_ = 0;
  std::uint32_t insertion_ = 0, last_serial_ = 0;
  int facet_count_ = 0;
};

}  // namespace thenar::internal
