#include "kinematics_fit/outside_scale.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

// Smallest and largest size over that of the subject's hand [1]
constexpr double kMinSizeRatio = 0.5, kMaxSizeRatio = 2;
constexpr double kNoBone = 1e-6;  // length below which joints meet, without a bone between them [m]

/// Motion of the points of one link, see scale_to_outside().
struct BoneScale {
  Vector3d from, to;         // position of its joint, before and after [m] (3)
  Vector3d along;            // direction of the bone; zero where joints meet (3)
  double length = 0;         // length before [m]
  double stretch = 1;        // factor s on the length [1]
  double near = 1, far = 1;  // factors w across, at its joint and at the far end [1]
};

Vector3d scaled(const BoneScale& bone, const Vector3d& p) {
  const Vector3d r = p - bone.from;
  const double x = r.dot(bone.along);
  const double part = bone.length > 0 ? std::clamp(x / bone.length, 0.0, 1.0) : 0;
  const double across = bone.near + (bone.far - bone.near) * part;
  return bone.to + bone.stretch * x * bone.along + across * (r - x * bone.along);
}

/// Scales of one digit, link by link from the base to the tip.
class OutsideScale {
 public:
  OutsideScale(const TendonDigit& digit, const std::map<std::string, double>& length)
      : digit_(digit), length_(length) {
    find_bones();
    stretch_bones();
    widen_bones();
    place_joints();
  }

  [[nodiscard]] Vector3d operator()(int link, const Vector3d& p) const {
    return scaled(link < 0 ? base_ : bones_[link], p);
  }

 private:
  /// Finds the bones from the point of each hinge to that of the next, or to the tip.
  void find_bones() {
    const TendonModel<double>& model = digit_.model;
    bones_.resize(model.tree.size());
    Vector3d end = model.tip;
    for_each_hinge_to_base(model.tree, model.tip_link, [&](int i) {
      chain_.insert(chain_.begin(), static_cast<std::size_t>(i));
      BoneScale& bone = bones_[chain_.front()];
      bone.from = bone.to = model.tree[chain_.front()].point;
      const Vector3d run = end - bone.from;
      bone.length = run.norm() > kNoBone ? run.norm() : 0;
      bone.along = bone.length > 0 ? Vector3d(run / bone.length) : Vector3d::Zero();
      end = bone.from;
    });
    require(chain_.size() == bones_.size(), "only a digit of one chain of joints can be scaled");
  }

  void stretch_bones() {
    // Set the stretch of the measured bones.
    double sum = 0;
    std::vector<std::string> measured(bones_.size());
    for (const auto& [segment, length] : length_) {
      const auto found = digit_.skeleton.link_of_segment.find(segment);
      require(found != digit_.skeleton.link_of_segment.end(), "the digit has no segment '{}'",
              segment);
      const auto link = static_cast<std::size_t>(found->second);
      require(found->second >= 0 && bones_[link].length > 0,
              "'{}' is not a bone from a joint of this digit to the next", segment);
      require(measured[link].empty(), "'{}' and '{}' are one bone in this digit", measured[link],
              segment);
      measured[link] = segment;
      const double ratio = length / bones_[link].length;
      require(
          ratio >= kMinSizeRatio && ratio <= kMaxSizeRatio,
          "{} of {:.4g} mm is {:.3g} times that of the subject, {:.4g} mm; wanted {} to {} times",
          segment, length * 1e3, ratio, bones_[link].length * 1e3, kMinSizeRatio, kMaxSizeRatio);
      bones_[link].stretch = ratio;
      sum += std::log(bones_[link].stretch);
    }
    // Stretch the others by their geometric mean.
    for (std::size_t i = 0; i < bones_.size(); ++i)
      if (measured[i].empty())
        bones_[i].stretch = std::exp(sum / static_cast<double>(length_.size()));
  }

  /// Sets the factors across at each joint from the bones that meet there; joints in one place
  /// count as one.
  void widen_bones() {
    double before = 0;  // s of the previous bone; 0 if there is none
    // Find joints in one place, from `first` to `last`.
    for (std::size_t first = 0; first < chain_.size();) {
      std::size_t last = first;
      while (last + 1 < chain_.size() && bones_[chain_[last]].length == 0) ++last;
      // Widen by the geometric mean of the bones that meet.
      const double after = bones_[chain_[last]].stretch;
      const double across = before == 0 ? after : std::sqrt(before * after);
      for (std::size_t k = first; k <= last; ++k)
        bones_[chain_[k]].near = bones_[chain_[k]].far = across;
      if (first > 0) bones_[chain_[first - 1]].far = across;
      before = bones_[chain_[last]].far = after;
      first = last + 1;
    }
  }

  /// Places the joints: the first one stays, and each next one moves with the bone before it.
  void place_joints() {
    for (std::size_t k = 1; k < chain_.size(); ++k)
      bones_[chain_[k]].to = scaled(bones_[chain_[k - 1]], bones_[chain_[k]].from);
    const BoneScale& first = bones_[chain_.front()];
    base_ = {first.from, first.from, Vector3d::Zero(), 0, 1, first.near, first.near};
  }

  const TendonDigit& digit_;
  const std::map<std::string, double>& length_;  // segment -> measured [m]
  std::vector<BoneScale> bones_;                 // scale of each link
  std::vector<std::size_t> chain_;               // links from the base to the tip
  BoneScale base_;
};

void require_scalable(const TendonDigit& digit, const Experiment& experiment) {
  require(!experiment.outside_length.empty(),
          "nothing was measured on its outside: state [outside] in its file, or fit "
          "with the sizes of the subject");
  require(!digit.net, "a net is laid for the subject's bones and cannot be scaled with them");
  const TendonModel<double>& model = digit.model;
  for (std::size_t s = 0; s < model.paths.size(); ++s)
    require(
        !model.paths[s].empty() || model.constant_arms.row(static_cast<Eigen::Index>(s)).isZero(0),
        "'{}' is known by its moment arms alone, which do not say how they grow with bones",
        digit.names.strands[s]);
  for (const Trial& trial : experiment.trials)
    require(!trial.site || !trial.site->point,
            "'at_mm' is a place in the subject's own size: state 'at_fraction' of the bone");
}

}  // namespace

TendonDigit scale_to_outside(const TendonDigit& digit, const Experiment& experiment) try {
  require_scalable(digit, experiment);
  const OutsideScale scale(digit, experiment.outside_length);
  TendonDigit out = digit;
  // Scale joints, tip and tendon paths.
  for (std::size_t i = 0; i < out.model.tree.size(); ++i)
    out.model.tree[i].point = scale(static_cast<int>(i), out.model.tree[i].point);
  out.model.tip = scale(out.model.tip_link, out.model.tip);
  out.skeleton.tree = out.model.tree;
  out.skeleton.tips.front().p = out.model.tip;
  for (TendonPath<double>& path : out.model.paths)
    for (PathNode<double>& node : path) node.p = scale(node.link, node.p);
  return out;
} catch (const InputError& e) {
  throw InputError(fmt::format("experiment '{}': {}", experiment.name, e.what()));
}

}  // namespace thenar
