#include "tendons/wrapping/path_tangency.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kMaxUnknowns = 4 * kMaxWraps;
using System = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxUnknowns, kMaxUnknowns>;
using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxUnknowns, 1>;
using Row4 = Eigen::Matrix<double, 1, 4>;
using Map34 = Eigen::Matrix<double, 3, 4>;

using internal::ArcEnd;
using internal::ArcEnds;

/// Computes an end of an arc, with the change of its frame by shift (sigma along, eta across) and
/// turn omega:
///   dp = sigma t + eta b,  dn = S dp,  db = -omega t - (b . dn) n.
ArcEnd end_of(const ChainArc& link, const SurfaceRay& ray, const Row4& sigma, const Row4& eta,
              const Row4& omega) {
  // Compute position and frame in the world.
  const SurfaceCurvature at = surface_curvature(*link.surface, ray.p);
  ArcEnd end;
  end.p = link.X * ray.p;
  end.t = link.X.R * ray.t;
  end.n = link.X.R * at.n;
  end.b = end.t.cross(end.n);
  // Compute derivatives by shift and turn, through the shape operator.
  const Vector3d St = link.X.R * (at.S * ray.t);
  const Vector3d Sb = link.X.R * (at.S * (link.X.R.transpose() * end.b));
  end.dp = end.t * sigma + end.b * eta;
  end.dn = St * sigma + Sb * eta;
  end.db = -end.t * omega - end.n * (end.b.transpose() * end.dn);
  return end;
}

ArcEnds ends_of(const ChainArc& link) {
  const GeodesicEnd far = follow_geodesic(*link.surface, link.arc.start, link.arc.length);
  const Row4 along(1, 0, 0, 0), across(0, 1, 0, 0), turn(0, 0, 1, 0);
  return {end_of(link, link.arc.start, along, across, turn),
          end_of(link, far.ray, Row4(1, 0, 0, 1), Row4(0, far.a, far.r, 0),
                 Row4(0, far.da, far.dr, 0))};
}

/// Residuals of the tangency conditions of a chain, and their Jacobian.
struct Tangency {
  Unknowns f;
  System J;
};

/// Opposite end of a run: a fixed point, or the end of an arc.
struct RunEnd {
  Vector3d p;       // world [m] (3)
  const Map34* dp;  // derivative by its arc's variations; null: it is fixed
  int column;       // first column of its arc's unknowns
};

/// Adds the two conditions of a unit run e = +-(end - other) / d against n and b of `end`.
/// @param sign  1 if the run arrives at the end, -1 if it leaves
void add_rows(Tangency& system, int row, int own, const ArcEnd& end, const RunEnd& other,
              double sign) {
  const Vector3d run = sign * (end.p - other.p);
  const double d = run.norm();
  const Vector3d e = run / d;
  for (int k = 0; k < 2; ++k) {
    const Vector3d& v = k == 0 ? end.n : end.b;
    const Map34& dv = k == 0 ? end.dn : end.db;
    const Vector3d slope = sign * (v - e * e.dot(v)) / d;
    system.f[row + k] = e.dot(v);
    system.J.block<1, 4>(row + k, own) += slope.transpose() * end.dp + e.transpose() * dv;
    if (other.dp) system.J.block<1, 4>(row + k, other.column) -= slope.transpose() * *other.dp;
  }
}

/// Computes residuals and Jacobian of a chain. @param ends  ends of all arcs (arcs)
template <typename Ends>
Tangency tangency_of(const Vector3d& a, const Vector3d& b, const Ends& ends, int m) {
  // Set four conditions for each surface; its runs end at its neighbours, or at a and b.
  Tangency system{Unknowns::Zero(4 * m), System::Zero(4 * m, 4 * m)};
  for (int i = 0; i < m; ++i) {
    const ArcEnds& here = ends[i];
    const ArcEnd* before = i > 0 ? &ends[static_cast<std::size_t>(i) - 1].off : nullptr;
    const ArcEnd* after = i + 1 < m ? &ends[static_cast<std::size_t>(i) + 1].on : nullptr;
    const RunEnd to_before =
        before ? RunEnd{before->p, &before->dp, 4 * (i - 1)} : RunEnd{a, nullptr, 0};
    const RunEnd to_after =
        after ? RunEnd{after->p, &after->dp, 4 * (i + 1)} : RunEnd{b, nullptr, 0};
    add_rows(system, 4 * i, 4 * i, here.on, to_before, 1);
    add_rows(system, 4 * i + 2, 4 * i, here.off, to_after, -1);
  }
  return system;
}

/// End of the string, which may lie on the surface over which the string bends next.
struct StringEnd {
  Vector3d p;         // world [m] (3)
  bool near = false;  // within kNearbyDistance of that surface
  double height = 0;  // signed distance from it [m]
};

constexpr double kNearbyDistance = 1e-6;  // distance within which an end lies on the surface [m]
// Height above a surface that rounding gives a point on it [m]
constexpr double kHeightRounding = 4e-18;
constexpr double kClearRun = 1e-6;  // smallest run whose length is accurate [m]

double min_size(const BoneSurface& surface) {
  return surface.shape == SurfaceShape::kEllipsoid ? surface.size.minCoeff() : surface.size[0];
}

/// Replaces the two rows of add_rows() at an end of the string that is near the surface: its run is
/// too short to define a direction. With s the distance along the string from there to the touch
/// point, D the height of the end over the tangent plane and c the curvature along the string,
///   s = sqrt(s^2 + 2 D / c)  if and only if  D = 0,
/// where the right side is constant as the touch point moves along a circle. An end on the surface,
/// or inside it, is the touch point: s = 0. Rounding of D changes short runs as 1 / s, so the
/// equation has a smaller weight there.
/// @param scale  size of the surface [m]
/// @param sign   1 if the string starts at that end, -1 if it ends there
void set_near_rows(Tangency& system, int row, int own, const ArcEnd& end, const StringEnd& at,
                   double scale, double sign) {
  const Vector3d off = end.p - at.p;
  const double s = sign * off.dot(end.t), curvature = end.t.dot(end.dn.col(0));
  const bool lifted = curvature > 0 && at.height > kHeightRounding;
  const double square = lifted ? s * s - 2 * off.dot(end.n) / curvature : 0;
  const double run = std::sqrt(std::max(square, 0.0));
  const double weight =
      lifted ? std::min(1.0, std::sqrt(2 * at.height * scale) / kClearRun) / scale : 1 / scale;
  // Fill the row along the string.
  Row4 slope = sign * end.t.transpose() * end.dp;
  if (run > 0) slope -= (s * slope - off.transpose() * end.dn / curvature) / run;
  system.J.middleRows<2>(row).setZero();
  system.f[row] = weight * (s - run);
  system.J.block<1, 4>(row, own) = weight * slope;
  // Fill the row across it.
  system.f[row + 1] = off.dot(end.b) / scale;
  system.J.block<1, 4>(row + 1, own) =
      (end.b.transpose() * end.dp + off.transpose() * end.db) / scale;
}

/// Computes residuals and Jacobian of a chain whose ends may lie near their surfaces.
Tangency tangency(const StringEnd& a, const StringEnd& b, const std::vector<ChainArc>& chain) {
  std::array<ArcEnds, kMaxWraps> ends;
  const std::size_t last = chain.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) ends[i] = ends_of(chain[i]);
  Tangency system = tangency_of(a.p, b.p, ends, static_cast<int>(chain.size()));
  // Replace the rows of ends that are near their surfaces.
  const int own = 4 * static_cast<int>(last);
  if (a.near) set_near_rows(system, 0, 0, ends[0].on, a, min_size(*chain[0].surface), 1);
  if (b.near)
    set_near_rows(system, own + 2, own, ends[last].off, b, min_size(*chain[last].surface), -1);
  return system;
}

/// Classifies an end p of the string against the adjacent arc of the chain.
StringEnd string_end(const ChainArc& link, const Vector3d& p) {
  const Vector3d p_S = link.X.inverse() * p;
  if (!(std::abs(level(*link.surface, p_S)) < kNearbyDistance)) return {p};
  return {p, true, probe(*link.surface, p_S).gap};
}

/// Moves one arc by its natural variations (along, across, turn, lengthen).
void vary(ChainArc& link, const Eigen::Vector4d& by) {
  const SurfaceRay& was = link.arc.start;
  const Vector3d n = surface_curvature(*link.surface, was.p).n, across = was.t.cross(n);
  link.arc.start = project_to_surface(
      *link.surface,
      {was.p + by[0] * was.t + by[1] * across, std::cos(by[2]) * was.t + std::sin(by[2]) * across});
  link.arc.length += by[3];
}

/// Computes the largest factor up to 1 that moves no arc by more than half its surface's radius or
/// half a radian.
double max_step_factor(const std::vector<ChainArc>& chain, const Unknowns& step) {
  double most = 1;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const auto by = step.segment<4>(4 * static_cast<Eigen::Index>(i));
    const double radius = min_size(*chain[i].surface);
    const double shift = std::max({std::abs(by[0]), std::abs(by[1]), std::abs(by[3])}) / radius;
    most = std::max({most, 2 * shift, 2 * std::abs(by[2])});
  }
  return 1 / most;
}

/// Computes the largest kink [rad]; 1, the maximum, if the residuals are not finite.
double largest_kink(const Unknowns& f) { return f.allFinite() ? f.lpNorm<Eigen::Infinity>() : 1; }

}  // namespace

ChainFit solve_tangency(const Vector3d& from, const Vector3d& to, std::vector<ChainArc>& chain) {
  constexpr int kTangencySteps = 60;  // largest number of Newton steps
  const StringEnd a = string_end(chain.front(), from), b = string_end(chain.back(), to);
  // Start the first arc at an end that is near its surface.
  if (a.near) {
    ChainArc& first = chain.front();
    first.arc.start =
        project_to_surface(*first.surface, {first.X.inverse() * from, first.arc.start.t});
  }
  Tangency now = tangency(a, b, chain);
  double size = now.f.squaredNorm();
  ChainFit fit{largest_kink(now.f), 0};
  std::array<WrapArc, kMaxWraps> best;
  for (; fit.iterations < kTangencySteps && fit.error > 1e-15; ++fit.iterations) {
    // Compute the Newton step and bound it to moderate moves of the arcs.
    const Unknowns step = -Eigen::PartialPivLU<System>(now.J).solve(now.f);
    if (!step.allFinite()) break;
    for (std::size_t i = 0; i < chain.size(); ++i) best[i] = chain[i].arc;
    double factor = max_step_factor(chain, step);
    // Halve the step until the residual decreases.
    bool better = false;
    for (int halving = 0; halving < 12 && !better; ++halving, factor *= 0.5) {
      for (std::size_t i = 0; i < chain.size(); ++i) {
        chain[i].arc = best[i];
        vary(chain[i], factor * step.segment<4>(4 * static_cast<Eigen::Index>(i)));
      }
      const Tangency next = tangency(a, b, chain);
      better = next.f.squaredNorm() < size;
      if (better) {
        now = next;
        size = now.f.squaredNorm();
        fit.error = largest_kink(now.f);
      }
    }
    // Restore the best arcs if no step decreases the residual.
    if (better) continue;
    for (std::size_t i = 0; i < chain.size(); ++i) chain[i].arc = best[i];
    break;
  }
  return fit;
}

namespace internal {
namespace {

/// Computes the rates of two tangency conditions under rigid motion: of a run e = sign (end -
/// other) / d  against n and b of an end that a surface carries.
Eigen::Vector2d carried_rate(const ArcEnd& end, const BodyTwist& on, const Vector3d& other,
                             const Vector3d& other_dot, double sign) {
  const Vector3d run = sign * (end.p - other);
  const double d = run.norm();
  const Vector3d e = run / d, move = sign * (on.velocity_at(end.p) - other_dot);
  const Vector3d e_dot = (move - e * e.dot(move)) / d;
  return {e_dot.dot(end.n) + e.dot(on.w.cross(end.n)), e_dot.dot(end.b) + e.dot(on.w.cross(end.b))};
}

}  // namespace

ChainTangent::ChainTangent(Vector3d a, Vector3d b, const std::vector<ChainArc>& chain)
    : a_(std::move(a)), b_(std::move(b)) {
  constexpr double kSingularCondition = 1e-12;  // reciprocal condition number [1]
  ends_.reserve(chain.size());
  for (const ChainArc& link : chain) ends_.push_back(ends_of(link));
  // Factor the Jacobian; the chain is regular only if it is well conditioned.
  const System J = tangency_of(a_, b_, ends_, static_cast<int>(ends_.size())).J;
  if (!J.allFinite()) return;
  factor_.compute(J);
  regular_ = factor_.rcond() > kSingularCondition;
}

void ChainTangent::rates(const Vector3d& a_dot, const Vector3d& b_dot,
                         const std::vector<BodyTwist>& on, std::vector<TouchRate>& out) const {
  const std::size_t m = ends_.size();
  // Compute the rates of the conditions while surfaces and ends move and arcs are fixed.
  Unknowns f(4 * static_cast<Eigen::Index>(m));
  for (std::size_t i = 0; i < m; ++i) {
    const auto row = 4 * static_cast<Eigen::Index>(i);
    const Vector3d& before = i > 0 ? ends_[i - 1].off.p : a_;
    const Vector3d& after = i + 1 < m ? ends_[i + 1].on.p : b_;
    f.segment<2>(row) =
        carried_rate(ends_[i].on, on[i], before, i > 0 ? on[i - 1].velocity_at(before) : a_dot, 1);
    f.segment<2>(row + 2) = carried_rate(ends_[i].off, on[i], after,
                                         i + 1 < m ? on[i + 1].velocity_at(after) : b_dot, -1);
  }
  // Solve for the variations of the arcs that keep the conditions satisfied.
  const Unknowns x = -factor_.solve(f);
  // Add the motion along each surface to that of the surface.
  out.clear();
  for (std::size_t i = 0; i < m; ++i) {
    const Eigen::Vector4d vary = x.segment<4>(4 * static_cast<Eigen::Index>(i));
    out.push_back({on[i].velocity_at(ends_[i].on.p) + ends_[i].on.dp * vary,
                   on[i].velocity_at(ends_[i].off.p) + ends_[i].off.dp * vary});
  }
}

}  // namespace internal

namespace {

constexpr std::size_t kSurfaceBeads = 24;  // beads per surface
// Factor on the moves of beads in the first three quarters of the sweeps [1]
constexpr double kOverRelaxation = 1.7;

/// Bead of a discretised string.
struct Bead {
  Vector3d p;
  int on = -1;  // surface in contact; -1: none
};
using Beads = std::array<Bead, kSurfaceBeads * kMaxWraps + 2>;

/// Places evenly spaced beads on the polygon from a through the start of every arc to b. Returns
/// their number.
std::size_t place_beads(const Vector3d& a, const Vector3d& b, const std::vector<ChainArc>& chain,
                        Beads& beads) {
  std::size_t count = 0;
  beads[count++] = {a};
  Vector3d from = a;
  // Place the same number of beads on each leg of the polygon.
  const std::size_t legs = chain.size() + 1, each = kSurfaceBeads * chain.size() / legs;
  for (std::size_t leg = 0; leg < legs; ++leg) {
    const Vector3d to = leg + 1 == legs ? b : Vector3d(chain[leg].X * chain[leg].arc.start.p);
    for (std::size_t i = 1; i <= each; ++i)
      beads[count++] = {from + static_cast<double>(i) / static_cast<double>(each) * (to - from)};
    from = to;
  }
  return count;
}

/// Projects a bead out of the surfaces that it penetrates.
void push_out(Bead& bead, const std::vector<ChainArc>& chain) {
  bead.on = -1;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const ChainArc& link = chain[i];
    const Vector3d p = link.X.R.transpose() * (bead.p - link.X.p);
    if (level(*link.surface, p) >= 0) continue;
    bead.p = link.X * project_to_surface(*link.surface, {p, Vector3d::UnitX()}).p;
    bead.on = static_cast<int>(i);
  }
}

}  // namespace

void contract_beads(const Vector3d& a, const Vector3d& b, int sweeps,
                    std::vector<ChainArc>& chain) {
  // Relax the beads by Gauss-Seidel sweeps.
  Beads beads;
  const std::size_t count = place_beads(a, b, chain, beads);
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (std::size_t i = 1; i + 1 < count; ++i) {
      const Vector3d middle = 0.5 * (beads[i - 1].p + beads[i + 1].p);
      // Drop over-relaxation at the end: it makes beads leave the surface and return.
      beads[i].p += (sweep < sweeps * 3 / 4 ? kOverRelaxation : 1.0) * (middle - beads[i].p);
      push_out(beads[i], chain);
    }
  // Turn surfaces in contact with beads into arcs of the chain.
  std::size_t kept = 0;
  for (std::size_t s = 0; s < chain.size(); ++s) {
    std::size_t first = 0, last = 0;
    double length = 0;
    for (std::size_t i = 1; i + 1 < count; ++i) {
      if (beads[i].on != static_cast<int>(s)) continue;
      if (first == 0) first = i;
      last = i;
    }
    // Span the arc from the first bead on the surface to the last one.
    if (first == 0) continue;
    for (std::size_t i = first; i < last; ++i) length += (beads[i + 1].p - beads[i].p).norm();
    ChainArc link = chain[s];
    const Pose<double> to_S = link.X.inverse();
    link.arc = {
        project_to_surface(*link.surface, {to_S * beads[first].p,
                                           to_S.R * (beads[first + 1].p - beads[first - 1].p)}),
        length};
    chain[kept++] = link;
  }
  chain.resize(kept);
}

}  // namespace thenar
