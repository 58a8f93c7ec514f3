#pragma once

/// A second opinion on nets at rest: places and reported forces put into the published laws.

#include <algorithm>
#include <cmath>
#include <vector>

#include "tendons/net/solve_net.h"
#include "tendons/wrapping/wrapped_string.h"
#include "tests/tendons/net/sample_nets.h"

namespace thenar {

/// What is left at the floating node where most is left.
struct NetJudgement {
  double residual = 0;   // out-of-balance force less what rounding explains [N]
  double rounding = 0;   // the most that rounding explains at a node [N]
  double overdrawn = 0;  // the most by which a force of a collapsed band exceeds its pull [N]
  double glued = 0;      // the most by which a bone pulls a node harder than bands can clasp it [N]
};

/// Tension and stiffness by the law as it is published in net.h.
struct LawfulPull {
  double tension, stiffness;
};

inline LawfulPull lawful_pull(const NetBand& band, const NetDrive& drive, double length) {
  double slack = band.slack;
  if (band.muscle >= 0) {
    if (drive.length.size() == 0 || !std::isfinite(drive.length(band.muscle)))
      return {drive.tension(band.muscle), 0};
    slack = drive.length(band.muscle);
  }
  const double e = (length - slack) / slack;
  if (e <= 0) return {0, band.EA / slack};
  if (e < band.toe) return {band.EA * e * e / (2 * band.toe), band.EA / slack};
  return {band.EA * (e - band.toe / 2), band.EA / slack};
}

/// A place is rounded by 1e-16 m (coordinates below 10 cm, turned to the frame of a bone and back);
/// that changes a band's tension by its stiffness, and turns it by 1 / (its free run). A node that
/// lies on a bone has no free run over it: a band that bends over the same bone leaves along it.
inline NetJudgement judge(const SampleNet& sample, const NetEquilibrium& rest) {
  constexpr double kPlace = 1e-16, kTolerance = 1e-9;
  const Net& net = sample.net;
  const TreeState<double> state = sample.state();
  NetJudgement out;
  Eigen::Matrix3Xd F = Eigen::Matrix3Xd::Zero(3, rest.x.cols());
  Eigen::VectorXd rounding = Eigen::VectorXd::Zero(rest.x.cols());
  std::vector<double> clasped(rest.contacts.size(), 0);
  std::vector<bool> collapsed(net.bands.size(), false);
  for (const CollapsedBand& d : rest.collapsed) {
    const NetBand& band = net.bands[d.band];
    collapsed[d.band] = true;
    F.col(band.a) += d.force;
    F.col(band.b) -= d.force;
    const double pull = sample.drive.tension(band.muscle);
    out.overdrawn = std::max(out.overdrawn, d.force.norm() - pull * (1 + 1e-15) - kTolerance);
  }
  for (std::size_t b = 0; b < net.bands.size(); ++b) {
    if (collapsed[b]) continue;
    const NetBand& band = net.bands[b];
    WrappedString chord = straight_string(rest.x.col(band.a), rest.x.col(band.b));
    Eigen::Vector2d run = Eigen::Vector2d::Constant(chord.length);
    if (band.over >= 0) {
      const BoneSurface& s = net.surfaces[band.over];
      const Pose<double> X = s.link < 0 ? s.X : state[s.link].X * s.X, to_S = X.inverse();
      const Eigen::Vector3d a = to_S * Eigen::Vector3d(rest.x.col(band.a)),
                            e = to_S * Eigen::Vector3d(rest.x.col(band.b));
      chord = wrap_string(s, a, e, band.side);
      if (chord.bent) run << (a - chord.touch_a).norm(), (e - chord.touch_b).norm();
      for (int i : {0, 3}) chord.slope.segment<3>(i) = X.R * chord.slope.segment<3>(i).eval();
    }
    const LawfulPull pull = lawful_pull(band, sample.drive, chord.length);
    for (int end : {0, 1}) {
      const int i = end == 0 ? band.a : band.b;
      Eigen::Vector3d f = -pull.tension * chord.slope.segment<3>(3 * end);
      for (std::size_t c = 0; chord.bent && c < rest.contacts.size(); ++c) {
        const NetContact& touch = rest.contacts[c];
        if (touch.node != i || touch.surface != band.over) continue;
        f -= touch.normal.dot(f) * touch.normal;
        clasped[c] += pull.tension;
        run(end) = net.surfaces[band.over].size[0];
      }
      F.col(i) += f;
      const double along = pull.tension > 0 ? pull.stiffness : 0;
      rounding(i) += kPlace * (along + pull.tension / std::max(run(end), 1e-12));
    }
  }
  for (std::size_t c = 0; c < rest.contacts.size(); ++c) {
    const NetContact& touch = rest.contacts[c];
    F.col(touch.node) += touch.force * touch.normal;
    const double S = clasped[c], r = S > 0 ? net.surfaces[touch.surface].size[0] : 1;
    const double clasp = S * std::max(std::sqrt(2e-11 / r), 4e-17 * S / (kTolerance * r));
    out.glued = std::max(out.glued, -touch.force - clasp * (1 + 1e-6) - 2 * kTolerance);
  }
  for (std::size_t i = 0; i < net.nodes.size(); ++i) {
    if (!net.nodes[i].free) continue;
    const auto k = static_cast<Eigen::Index>(i);
    out.residual = std::max(out.residual, F.col(k).norm() - rounding(k));
    out.rounding = std::max(out.rounding, rounding(k));
  }
  return out;
}

}  // namespace thenar
