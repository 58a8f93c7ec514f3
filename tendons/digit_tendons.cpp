#include "tendons/digit_tendons.h"

#include <array>
#include <cmath>

namespace thenar {

Eigen::MatrixXd DigitTendons::torque_by_posture(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                                const TendonTorque& at) const {
  // Use the closed form where it exists, otherwise central differences.
  if (TendonDerivatives known = derivatives(q, t); known.exist) return known.by_posture;
  constexpr double kAngleStep = 1e-5;  // step of an angle [rad]
  Eigen::MatrixXd slope(q.size(), q.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const Eigen::VectorXd step = kAngleStep * Eigen::VectorXd::Unit(q.size(), j);
    slope.col(j) = (evaluate(q + step, t, at.nodes).tau - evaluate(q - step, t, at.nodes).tau) /
                   (2 * kAngleStep);
  }
  return slope;
}

Excursion excursion(const DigitTendons& tendons, const Eigen::VectorXd& from,
                    const Eigen::VectorXd& to, const Eigen::VectorXd& t) {
  struct Node {
    double at, weight;  // position on -1..1, and weight
  };
  static constexpr std::array<Node, 5> kGauss{{{-0.90617984593866399280, 0.23692688505618908751},
                                               {-0.53846931010568309104, 0.47862867049936646804},
                                               {0, 0.56888888888888888889},
                                               {0.53846931010568309104, 0.47862867049936646804},
                                               {0.90617984593866399280, 0.23692688505618908751}}};
  // Divide the line into pieces of at most kPieceAngle.
  constexpr double kPieceAngle = 0.1;  // largest rotation of a joint in a piece [rad]
  const Eigen::VectorXd way = to - from;
  const double longest = way.size() > 0 ? way.cwiseAbs().maxCoeff() : 0;
  const int pieces = static_cast<int>(std::ceil(longest / kPieceAngle));

  Excursion sum{Eigen::VectorXd::Zero(t.size()), {}};
  Eigen::Matrix3Xd nodes;
  for (int k = 0; k < pieces; ++k)
    for (const Node& node : kGauss) {
      // Evaluate the arms at a Gauss point; start a net from the previous point.
      const double s = (k + (1 + node.at) / 2) / pieces;
      const TendonTorque pull = tendons.evaluate(from + s * way, t, nodes);
      sum.e -= node.weight / (2 * pieces) * (pull.R * way);
      if (sum.warning.empty()) sum.warning = pull.warning;
      nodes = pull.nodes;
    }
  return sum;
}

}  // namespace thenar
