#include "live/scene_tendons.h"

#include <utility>

#include "base/error.h"
#include "base/lists.h"
#include "base/numbers.h"

namespace thenar {
namespace {

/// Returns the first body of the hand that has a coordinate: its frame is the hand's frame.
/// @param place  entry of the scene's q
int hand_base_body(const BuiltScene& built, int place) {
  const Mechanism& mechanism = built.scene.mechanism;
  const MechanismLayout layout = layout_of(mechanism);
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i)
    if (is_scalar(mechanism.joints[i].kind) && layout.first_q[i] == place)
      return place_in(built.owner, built.owner[i]);
  throw InputError("wanted a joint for every coordinate that tendons move");
}

/// Computes the tension of every strand [N] (strands).
/// @param t  tensions of muscles; NaN: unknown [N] (muscles)
Eigen::VectorXd strand_tensions_of(const TendonDigit& digit, const Eigen::VectorXd& q,
                                   const Eigen::VectorXd& t) {
  // t_strand = S t, where S distributes the muscle tensions over strands as the hood does.
  const Eigen::MatrixXd S = strand_matrix(digit.model, q);
  Eigen::VectorXd out = Eigen::VectorXd::Zero(S.rows());
  for (Eigen::Index s = 0; s < S.rows(); ++s) {
    const bool pulled = !S.row(s).isZero(0);
    if (!pulled && digit.net != nullptr) out[s] = kNaN;
    // Skip zeros of S: muscles that do not pull on this strand may be unknown.
    for (Eigen::Index m = 0; m < S.cols(); ++m)
      if (S(s, m) != 0) out[s] += S(s, m) * t[m];
  }
  return out;
}

}  // namespace

SceneTendons::SceneTendons(const BuiltScene& built) {
  for (const std::shared_ptr<const ForceElement>& element : built.scene.elements)
    if (const auto* pull = dynamic_cast<const DigitPull*>(element.get())) add_digits(built, *pull);
}

void SceneTendons::add_digits(const BuiltScene& built, const DigitPull& pull) {
  // Append the muscles of this hand to the list of all hands.
  const DigitPullModel& model = pull.model();
  const auto first = static_cast<Eigen::Index>(muscles_.size());
  for (const std::string& muscle : pull.muscles()) muscles_.push_back(pull.name() + "/" + muscle);
  // Add each digit with its coordinates, muscles and lines.
  for (const TendonGroup::Digit& digit : model.tendons->digits()) {
    DigitPart part{digit.tendons, 0, {}, {}, strand_paths(digit.tendons->digit())};
    for (const int c : digit.coordinates) part.q.push_back(model.indices.q[c]);
    for (const int m : digit.muscles) part.muscle.push_back(first + m);
    if (part.q.empty()) continue;
    part.base = hand_base_body(built, part.q.front());
    const std::string& hand = built.owner[part.base];
    for (const StrandPath& path : part.paths)
      lines_.push_back({path.name, hand + "/" + digit_name(digit.tendons->digit()), false,
                        static_cast<int>(path.nodes.size())});
    parts_.push_back(std::move(part));
  }
}

std::vector<Eigen::Vector3d> SceneTendons::points(const Eigen::VectorXd& q,
                                                  const std::vector<Pose<double>>& X_WB) const {
  std::vector<Eigen::Vector3d> points;
  // Compute the points in the hand's frame, and transform them to the world.
  for (const DigitPart& part : parts_) {
    const Eigen::VectorXd own = q(part.q);
    const TreeState<double> state = pose_tree(part.tendons->digit().model.tree, own);
    const Pose<double>& X_WH = X_WB[part.base];
    for (const StrandPath& path : part.paths)
      for (const PathNode<double>& node : path.nodes)
        points.push_back(X_WH * moved(state, node.link, node.p));
  }
  return points;
}

std::vector<double> SceneTendons::tensions(const Eigen::VectorXd& q,
                                           const Eigen::VectorXd& t) const {
  std::vector<double> tensions;
  for (const DigitPart& part : parts_) {
    const Eigen::VectorXd strands =
        strand_tensions_of(part.tendons->digit(), q(part.q), t(part.muscle));
    for (const StrandPath& path : part.paths) tensions.push_back(strands[path.strand]);
  }
  return tensions;
}

}  // namespace thenar
