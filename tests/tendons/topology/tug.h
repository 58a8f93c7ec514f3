#pragma once

/// A muscle that pulls a knot held by parallel bands, of which only the first turns the hinge. They
/// are of one length, so they share the pull as their EA:
///   tau = -arm t EA_0 / sum EA.

#include <string>
#include <vector>

#include "tendons/topology/candidate_net.h"

namespace thenar::tug {

constexpr double kArm = 0.01, kLength = 0.03, kEA = 100;  // [m], [m], [N]

inline CandidateNet candidate(int bands) {
  CandidateNet out;
  out.net.name = "tug";
  out.net.nodes.push_back({"knot", true, -1, {0, kArm, 0}, {}});
  out.net.nodes.push_back({"exit", false, -1, {0.05, kArm, 0}, {}});
  for (int b = 0; b < bands; ++b) {
    const int link = b == 0 ? 0 : -1;
    out.net.nodes.push_back({"end", false, link, {-kLength, kArm, 0}, {}});
    NetBand band{"band " + std::to_string(b), 0, b + 2};
    band.slack = 0.95 * kLength;
    band.EA = kEA;
    out.net.bands.push_back(band);
  }
  NetBand pull{"pull", 0, 1};
  pull.muscle = 0;
  out.net.bands.push_back(pull);
  out.net.muscles = {"muscle"};
  out.tree = {{-1, 0, 1, 0, {0, 0, 1}, {0, 0, 0}}};
  out.coordinates = 1;
  out.candidates = passive_candidates(out.net);
  return out;
}

/// Joint torque under one tension.
inline TendonTest test(double tension) {
  TendonTest out;
  out.name = "pull";
  out.q = Eigen::VectorXd::Zero(1);
  out.tension = Eigen::VectorXd::Constant(1, tension);
  out.map = Eigen::MatrixXd::Identity(1, 1);
  return out;
}

inline TendonRecord record(double tension, double torque, double sd) {
  return {test(tension), Eigen::VectorXd::Constant(1, torque), Eigen::VectorXd::Constant(1, sd)};
}

}  // namespace thenar::tug
