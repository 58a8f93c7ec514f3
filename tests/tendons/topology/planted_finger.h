#pragma once

/// A finger whose extensor net has bands that are known to exist and others that might.

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "tendons/net/solve_net.h"
#include "tendons/topology/candidate_net.h"
#include "tendons/topology/net_forward_model.h"
#include "tendons/topology/rank_tests.h"
#include "tendons/wrapping/wrapped_string.h"

namespace thenar::planted {

using Eigen::Vector3d;

constexpr double kPip = -0.047, kDip = -0.0758, kTip = -0.0948;  // places along the finger [m]
constexpr double kMcpRadius = 0.00917, kPipRadius = 0.00557, kDipRadius = 0.00396;
constexpr double kPretension = 0.04;  // strain of every band in the straight finger [1]
constexpr double kCellNoise = 0.02;   // sd [N]
enum Link { kBase = -1, kMcp, kProximal, kMiddle, kDistal };

/// Builds a net by the names of its nodes.
struct Sketch {
  Net net;
  int node(const std::string& name, bool free, int link, const Vector3d& p) {
    net.nodes.push_back({name, free, link, p, {}});
    return static_cast<int>(net.nodes.size()) - 1;
  }
  /// A band that is taut in the straight finger.
  int band(const std::string& name, int a, int b, double EA, int over = -1) {
    const Vector3d &pa = net.nodes[a].p, &pb = net.nodes[b].p;
    NetBand band{name, a, b};
    band.over = over;
    band.EA = EA;
    band.slack = (pa - pb).norm();
    if (over >= 0) {
      const Vector3d centre = net.surfaces[over].X.p;
      band.slack = wrap_string(net.surfaces[over], pa - centre, pb - centre, band.side).length;
    }
    band.slack *= 1 - kPretension;
    net.bands.push_back(band);
    return static_cast<int>(net.bands.size()) - 1;
  }
  void muscle(const std::string& name, int from, int exit, int over) {
    net.bands[band(name, from, exit, 100, over)].muscle = static_cast<int>(net.muscles.size());
    net.muscles.push_back(name);
  }
};

inline Tree<double> finger_tree() {
  const Vector3d flexion(0, 0, 1), abduction(0, 1, 0);
  return {{-1, 0, 1, 0, flexion, {0, 0, 0}},
          {0, 1, 1, 0, abduction, {0, 0, 0}},
          {1, 2, 1, 0, flexion, {kPip, 0, 0}},
          {2, 3, 1, 0, flexion, {kDip, 0, 0}}};
}

/// Extensor, radial and ulnar interosseous and lumbrical pull a hood with a frame that is sure
/// (terminal slip, lateral bands, central slip) and 14 bands that may exist.
inline CandidateNet candidate_finger() {
  Sketch s;
  s.net.name = "planted";
  const auto sphere = [&](const char* name, int link, double x, double radius) {
    BoneSurface head;
    head.name = name;
    head.link = link;
    head.shape = SurfaceShape::kSphere;
    head.size = {radius, 0, 0};
    head.X.p = {x, 0, 0};
    s.net.surfaces.push_back(head);
  };
  sphere("MCP_head", kBase, 0, kMcpRadius);
  sphere("PIP_head", kProximal, kPip, kPipRadius);
  sphere("DIP_head", kMiddle, kDip, kDipRadius);
  const int terminal = s.node("terminal", false, kDistal, {-0.080, 0.0036, 0});
  const int central = s.node("central", false, kMiddle, {-0.0528, 0.0058, 0});
  const int base = s.node("base", false, kProximal, {-0.008, 0.0095, 0});
  const int lig[] = {s.node("ligament_u", false, kProximal, {-0.043, -0.0045, -0.0045}),
                     s.node("ligament_r", false, kProximal, {-0.043, -0.0045, 0.0045})};
  const int junction = s.node("junction", true, kMiddle, {-0.0685, 0.0047, 0});
  const int centre = s.node("centre", true, kProximal, {-0.0355, 0.0066, 0});
  const int extensor = s.node("extensor", true, kProximal, {-0.0235, 0.0075, 0});
  int beyond[2], side[2], wing[2];
  for (int i = 0; i < 2; ++i) {
    const double z = i ? 1 : -1;
    const std::string end = i ? "_r" : "_u";
    beyond[i] = s.node("beyond" + end, true, kMiddle, {-0.056, 0.0045, 0.0045 * z});
    side[i] = s.node("side" + end, true, kProximal, {-0.0375, 0.0035, 0.0058 * z});
    wing[i] = s.node("wing" + end, true, kProximal, {-0.0270, 0.0030, 0.0066 * z});
  }
  // The frame.
  s.band("terminal", terminal, junction, 90, 2);
  s.band("central_slip", central, centre, 170, 1);
  for (int i = 0; i < 2; ++i) {
    const std::string end = i ? "_r" : "_u";
    s.band("lateral_distal" + end, junction, beyond[i], 150);
    s.band("lateral" + end, beyond[i], side[i], 150, 1);
  }
  // What may exist.
  const int first = static_cast<int>(s.net.bands.size());
  s.band("extensor_central", centre, extensor, 170);
  s.band("extensor_base", extensor, base, 100);
  s.band("triangular", beyond[0], beyond[1], 45);
  s.band("transverse", side[0], side[1], 60);
  for (int i = 0; i < 2; ++i) {
    const std::string end = i ? "_r" : "_u";
    s.band("extensor_lateral" + end, extensor, side[i], 150);
    s.band("interosseous_lateral" + end, wing[i], side[i], 150);
    s.band("interosseous_medial" + end, wing[i], centre, 150);
    s.band("hood" + end, extensor, wing[i], 70);
    s.band("retinacular" + end, beyond[i], lig[i], 45);
  }
  const int last = static_cast<int>(s.net.bands.size());
  // What pulls.
  s.muscle("EDC", extensor, s.node("EDC", false, kBase, {0.025, 0.0095, 0}), 0);
  s.muscle("RI", wing[1], s.node("RI", false, kBase, {0.0064, -0.0044, 0.011}), -1);
  s.muscle("UI", wing[0], s.node("UI", false, kBase, {0.0092, -0.0057, -0.0085}), -1);
  s.muscle("LU", wing[1], s.node("LU", false, kBase, {0.0097, -0.0141, 0.010}), -1);
  CandidateNet out{s.net, finger_tree(), 4, {}};
  for (int b = first; b < last; ++b)
    out.candidates.push_back({b, 0.25 * s.net.bands[b].EA, 4 * s.net.bands[b].EA});
  return out;
}

/// One test: angles in degrees, tensions of EDC, RI, UI, LU [N]; measured is the force of a pinned
/// tip,  J' f = tau  in least squares.
inline TendonTest finger_test(const Eigen::Vector4d& angles_deg, const Eigen::Vector4d& tension) {
  constexpr double kDegree = 3.14159265358979323846 / 180;
  TendonTest test;
  test.q = kDegree * angles_deg;
  test.tension = tension;
  const Tree<double> tree = finger_tree();
  const TreeState<double> state = pose_tree(tree, test.q);
  const Vector3d tip = moved<double>(state, kDistal, {kTip, 0, 0});
  const Eigen::MatrixXd Jt = position_jacobian(tree, state, kDistal, tip, 4).transpose();
  test.map = Jt.completeOrthogonalDecomposition().pseudoInverse();
  return test;
}

/// Postures (degrees: MCP flexion, abduction, PIP, DIP) and loads (N: EDC, RI, UI, LU). The last
/// six are those of 140 that rank_tests() found to tell most of nets that the others leave alike:
/// they tension the ligaments between and beside the lateral bands.
inline std::vector<TendonTest> finger_tests() {
  std::vector<TendonTest> tests;
  for (const Eigen::Vector4d& q : {Eigen::Vector4d(10, 0, 10, 30), Eigen::Vector4d(30, 8, 20, 60),
                                   Eigen::Vector4d(20, -8, 5, 15), Eigen::Vector4d(50, 0, 30, 70),
                                   Eigen::Vector4d(-5, 5, 15, 45), Eigen::Vector4d(40, -5, 45, 20)})
    for (const Eigen::Vector4d& t : {Eigen::Vector4d(1, 5, 0, 0), Eigen::Vector4d(1, 0, 5, 0),
                                     Eigen::Vector4d(4, 3, 3, 0), Eigen::Vector4d(6, 1, 0, 2)})
      tests.push_back(finger_test(q, t));
  tests.push_back(finger_test({0, 0, 80, 40}, {0.5, 0, 8, 4}));
  tests.push_back(finger_test({0, 0, 80, 40}, {0.5, 0, 0, 6}));
  tests.push_back(finger_test({-5, 5, 15, 45}, {12, 0, 0, 0}));
  tests.push_back(finger_test({0, 0, -8, 0}, {12, 0, 0, 0}));
  tests.push_back(finger_test({0, 0, 60, 0}, {0.5, 0, 8, 4}));
  tests.push_back(finger_test({30, -12, 0, 5}, {8, 0.5, 0.5, 0}));
  return tests;
}

/// Bands drawn with this chance and stiffnesses between half and twice the typical, until the net
/// carries all loads.
inline Eigen::VectorXd plant(const CandidateNet& candidate, const std::vector<TendonTest>& tests,
                             std::mt19937& random, double chance = 0.6) {
  std::bernoulli_distribution exists(chance);
  std::uniform_real_distribution<double> octave(-1, 1);
  NetForwardModel forward(candidate, tests);
  for (;;) {
    Eigen::VectorXd EA(static_cast<Eigen::Index>(candidate.candidates.size()));
    for (Eigen::Index c = 0; c < EA.size(); ++c) {
      const double typical = candidate.net.bands[candidate.candidates[c].band].EA;
      const double drawn = typical * std::exp2(octave(random));
      EA(c) = exists(random) ? drawn : 0;
    }
    if (forward.predict(EA, Sensitivities::kWithout).holds) return EA;
  }
}

/// Readings with normal noise of `relative` times the force of each test, and of the load cell.
inline std::vector<TendonRecord> measure(const CandidateNet& candidate, const Eigen::VectorXd& EA,
                                         const std::vector<TendonTest>& tests, double relative,
                                         std::mt19937& random) {
  const NetPrediction truth =
      NetForwardModel(candidate, tests).predict(EA, Sensitivities::kWithout);
  std::normal_distribution<double> normal;
  std::vector<TendonRecord> records;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    TendonRecord record{tests[i], truth.value.segment(3 * static_cast<Eigen::Index>(i), 3), {}};
    record.sd = reading_sd({relative, kCellNoise}, record.measured);
    for (int k = 0; k < 3; ++k) record.measured(k) += record.sd(k) * normal(random);
    records.push_back(record);
  }
  return records;
}

}  // namespace thenar::planted
