#include "hand/segment_mass.h"

#include "base/units.h"

namespace thenar {
namespace {

/// Solid capsule: a cylinder of length h with two half balls. The transverse moment adds
/// the parallel-axis terms of the half balls, whose centres lie 3/8 r beyond the cylinder.
LinkMass capsule(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double r) {
  const double h = (b - a).norm();
  const double cylinder = kHandDensity * kPi * r * r * h;
  const double balls = kHandDensity * 4.0 / 3.0 * kPi * r * r * r;
  const double along = cylinder * r * r / 2 + balls * 2 * r * r / 5;
  const double across =
      cylinder * (h * h / 12 + r * r / 4) + balls * (2 * r * r / 5 + h * h / 4 + 3 * h * r / 8);
  const Eigen::Vector3d d = h > 0 ? Eigen::Vector3d((b - a) / h) : Eigen::Vector3d::UnitX();
  const Eigen::Matrix3d dd = d * d.transpose();
  return {
      cylinder + balls, (a + b) / 2, along * dd + across * (Eigen::Matrix3d::Identity() - dd), {}};
}

/// Inertia that a point mass at offset r adds.
Eigen::Matrix3d point_inertia(double mass, const Eigen::Vector3d& r) {
  return mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
}

}  // namespace

LinkMass segment_mass(const Segment& segment) {
  LinkMass body;
  if (segment.radius > 0) body = capsule(segment.proximal, segment.distal, segment.radius);
  if (segment.mass == 0) return body;
  if (!segment.inertia.isZero(0)) return {segment.mass, segment.com, segment.inertia, {}};
  if (segment.radius == 0) return {segment.mass, segment.com, segment.inertia, segment.name};
  return {segment.mass, segment.com, body.inertia * (segment.mass / body.mass), {}};
}

LinkMass combine(const LinkMass& a, const LinkMass& b) {
  const double mass = a.mass + b.mass;
  if (mass == 0) return {};
  const Eigen::Vector3d com = (a.mass * a.com + b.mass * b.com) / mass;
  return {mass, com,
          a.inertia + b.inertia + point_inertia(a.mass, a.com - com) +
              point_inertia(b.mass, b.com - com),
          a.no_inertia.empty() ? b.no_inertia : a.no_inertia};
}

LinkMass displace(const Pose<double>& X, const LinkMass& body) {
  return {body.mass, X * body.com, X.R * body.inertia * X.R.transpose(), body.no_inertia};
}

}  // namespace thenar
