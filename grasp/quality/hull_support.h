#pragma once

/// The support function of a wrench set, laid out for being asked very often.

#include "grasp/quality/wrench_set.h"

namespace thenar::internal {

/// How far a set reaches in a direction, and where.
struct Reach {
  double h;  // support h(u)
  Wrench p;  // a point of the set with p' u = h
};

/// h(u) and its point for one set and limit:
///   L1:    the best cap, c + A A'u / |A'u|;
///   Linf:  the sum over contacts of their best caps, where these reach beyond 0.
class Support {
 public:
  struct Cap {
    Wrench c;
    Eigen::Matrix<double, 6, 3> A;
    int axes;              // columns of A in use; the others are 0
    int contact;           // number, 0, 1, ..
    bool last_of_contact;  // of the caps that share one limit
  };

  Support(const WrenchSet& set, ForceLimit limit);

  [[nodiscard]] Reach operator()(const Wrench& u) const;

  [[nodiscard]] double size() const { return size_; }          // no point is further off than this
  [[nodiscard]] double rounding() const { return rounding_; }  // of a computed h(u), |u| = 1
  [[nodiscard]] ForceLimit limit() const { return limit_; }
  [[nodiscard]] const std::vector<Cap>& caps() const { return caps_; }  // of a contact together

 private:
  [[nodiscard]] static double reach(const Cap& cap, const Wrench& u);
  static void add_point(const Cap& cap, const Wrench& u, Wrench& sum);

  std::vector<Cap> caps_;  // those of one contact side by side
  ForceLimit limit_;
  double size_ = 0, rounding_ = 0;
};

}  // namespace thenar::internal
