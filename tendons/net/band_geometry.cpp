#include "tendons/net/band_geometry.h"

#include <algorithm>
#include <cmath>

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

constexpr double kTwoPi = 6.283185307179586;

/// End of a band: distance rho from the centre, free run f, and the cosine and sine of the angle
/// between the end and its tangent point.
struct End {
  double rho, inverse, f, c, s;
};

/// Computes the free run of an end at distance rho; returns false if the end lies inside.
bool set_free_run(double r, double rho, End& end) {
  if (!(rho >= r * (1 - 1e-9))) return false;
  end.rho = rho;
  end.inverse = 1 / rho;
  end.f = std::sqrt(std::max((rho - r) * (rho + r), 0.0));
  end.c = std::min(r * end.inverse, 1.0);
  end.s = end.f * end.inverse;
  return true;
}

/// Computes the arc between the tangent points of ends theta apart; negative if the band misses the
/// bone. @param wide  theta > pi
double arc_of(const End& a, const End& b, double cos_theta, double sin_theta, bool wide) {
  const double c = a.c * b.c - a.s * b.s, s = a.s * b.c + a.c * b.s;  // alpha_a + alpha_b < pi
  const double sin_arc = sin_theta * c - cos_theta * s, cos_arc = cos_theta * c + sin_theta * s;
  if (!wide && sin_arc <= 0 && (sin_arc < 0 || cos_arc > 0)) return -1;  // clear of the bone
  const double arc = std::atan2(sin_arc, cos_arc);
  return arc < 0 ? arc + kTwoPi : arc;
}

/// Computes 1 / f, bounded for an end on the surface [1/m].
double inverse_run(double r, double f) { return 1 / std::max(f, 1e-7 * r); }

/// Computes the band over a sphere.
WrapState over_sphere(const RoundBone& bone, const Vector3d& a, const Vector3d& b,
                      BandGeometry& run) {
  // Express the ends in polar form about the centre.
  const double r = bone.radius;
  const Vector3d pa = a - bone.center, pb = b - bone.center;
  End A, B;
  if (!set_free_run(r, pa.norm(), A) || !set_free_run(r, pb.norm(), B))
    return WrapState::kDegenerate;
  // Compute the angle between them and the arc.
  const Vector3d ea = A.inverse * pa, eb = B.inverse * pb, cross = ea.cross(eb);
  const double sine = cross.norm(), cosine = ea.dot(eb);
  if (sine < 1e-12) return WrapState::kDegenerate;
  const double arc = arc_of(A, B, cosine, sine, false);
  if (!(arc > 0)) return WrapState::kStraight;
  // Compute directions in the plane of both ends and the centre.
  const Vector3d m = cross / sine, ta = ea.cross(m), tb = m.cross(eb);
  // Compute the length and its gradient.
  run.length = A.f + B.f + r * arc;
  run.ua = A.s * ea + A.c * ta;
  run.ub = B.s * eb + B.c * tb;
  // Compute the second derivatives across the free runs, and out of the plane.
  run.na = A.c * ea - A.s * ta;
  run.nb = B.c * eb - B.s * tb;
  run.wa = inverse_run(r, A.f);
  run.wb = inverse_run(r, B.f);
  run.va = run.vb = m;
  const double cot = cosine / sine;
  run.vaa = (A.f + r * cot) * A.inverse * A.inverse;
  run.vbb = (B.f + r * cot) * B.inverse * B.inverse;
  run.vab = -r * A.inverse * B.inverse / sine;
  return WrapState::kBent;
}

/// Computes a number that increases with the angle of (x, y) over (-pi, pi].
double turn_order(double x, double y) {
  const double t = y / (std::abs(x) + std::abs(y));
  return x >= 0 ? t : (y >= 0 ? 2 - t : -2 - t);
}

/// Computes the band over a cylinder.
WrapState over_cylinder(const RoundBone& bone, const Vector3d& a, const Vector3d& b,
                        BandGeometry& run) {
  // Split the ends into parts across and along the axis.
  const double r = bone.radius;
  const Vector3d pa = a - bone.center, pb = b - bone.center;
  const double ax = bone.e1.dot(pa), ay = bone.e2.dot(pa), bx = bone.e1.dot(pb),
               by = bone.e2.dot(pb), dz = bone.d.dot(a - b);
  End A, B;
  if (!set_free_run(r, std::sqrt(ax * ax + ay * ay), A) ||
      !set_free_run(r, std::sqrt(bx * bx + by * by), B))
    return WrapState::kDegenerate;
  // Choose the sense of rotation, counted over the side, and compute the arc.
  const double way = turn_order(bx, by) < turn_order(ax, ay) ? -1 : 1;
  const double scale = A.inverse * B.inverse;
  const double cosine = (ax * bx + ay * by) * scale, sine = way * (ax * by - ay * bx) * scale;
  const double arc = arc_of(A, B, cosine, sine, sine < 0);
  // Compute the length from planar run and climb.
  if (!(arc > 0)) return WrapState::kStraight;
  const double P = A.f + B.f + r * arc, L = std::sqrt(P * P + dz * dz);
  // Compute planar tangents and normals, then derivatives of L^2 = P^2 + dz^2.
  const double ia = A.inverse * A.inverse, ib = B.inverse * B.inverse, l = 1 / L;
  const double ra = way * r, rb = -way * r;
  const Vector3d ta = (A.f * ax + ra * ay) * ia * bone.e1 + (A.f * ay - ra * ax) * ia * bone.e2;
  const Vector3d tb = (B.f * bx + rb * by) * ib * bone.e1 + (B.f * by - rb * bx) * ib * bone.e2;
  run.na = bone.d.cross(ta);
  run.nb = bone.d.cross(tb);
  run.length = L;
  run.ua = l * (P * ta + dz * bone.d);
  run.ub = l * (P * tb - dz * bone.d);
  run.va = dz * ta - P * bone.d;
  run.vb = dz * tb + P * bone.d;
  run.vaa = run.vab = run.vbb = l * l * l;
  run.wa = P * l * inverse_run(r, A.f);
  run.wb = P * l * inverse_run(r, B.f);
  return WrapState::kBent;
}

}  // namespace

RoundBone round_bone(const BoneSurface& surface, const Pose<double>& X, const Vector3d& side_S) {
  RoundBone bone;
  bone.sphere = surface.shape == SurfaceShape::kSphere;
  bone.radius = surface.size[0];
  bone.center = X.p;
  bone.side = X.R * side_S;
  bone.d = X.R.col(2);
  bone.e1 = (bone.side - bone.d * bone.d.dot(bone.side)).normalized();
  bone.e2 = bone.d.cross(bone.e1);
  return bone;
}

WrapState wrap_over(const RoundBone& bone, const Vector3d& a, const Vector3d& b,
                    BandGeometry& run) {
  return bone.sphere ? over_sphere(bone, a, b, run) : over_cylinder(bone, a, b, run);
}

}  // namespace thenar::internal
