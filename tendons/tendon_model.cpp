#include "tendons/tendon_model.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "tendons/name_conventions.h"

namespace thenar {
namespace {

/// Returns a digit of the subject. @throws InputError if there is none
const Digit& digit_of(const Subject& subject, const std::string& name) {
  if (const Digit* digit = find_named(subject.digits, name)) return *digit;
  throw InputError(fmt::format("subject '{}' has no digit '{}'; there are {}", subject.name, name,
                               listed(names_of(subject.digits))));
}

/// Builds a path from the points on kept links, without surfaces.
TendonPath<double> kept_path(const Skeleton& skeleton, const Strand& strand) {
  TendonPath<double> path = carried_points(skeleton, strand);
  // Check that runs across a joint have a length.
  for (std::size_t k = 1; k < path.size(); ++k)
    require(path[k].link == path[k - 1].link || (path[k].p - path[k - 1].p).norm() > 1e-9,
            "path of strand '{}' has a zero-length run across a joint at point {}", strand.name, k);
  return path;
}

/// Cosine between a joint's axis and the digit's flexion direction above which the joint
/// flexes [1]: 45 degrees, half way to a joint that purely abducts or pronates, so every joint
/// counts by its larger part. Our choice, not a measurement.
constexpr double kFlexionCosine = 0.7071;

bool crosses_a_joint(const TendonPath<double>& path) {
  return any_of(path, [&](const PathNode<double>& node) { return node.link != path.front().link; });
}

/// Returns the joints frozen by name, and the wrist unless it is free.
std::map<std::string, double> frozen_joints(const Subject& subject, const TendonOptions& options) {
  // Freeze a welded wrist at its reference posture.
  std::map<std::string, double> frozen = options.frozen;
  if (options.wrist_mode == WristMode::kWelded)
    for (const std::string& joint : shared_joints(subject)) frozen.emplace(joint, 0);
  return frozen;
}

/// Builder of one digit: bones, strands, muscles and hood, in this order.
class DigitBuilder {
 public:
  DigitBuilder(const Subject& subject, const std::string& name, const TendonOptions& options)
      : subject_(subject), digit_(digit_of(subject, name)), options_(options) {
    // Build bones, then strands, muscles and the hood.
    built_.skeleton = build_skeleton(subject, {{name}, frozen_joints(subject, options)});
    built_.calibrated_on = subject.calibrated_on;
    set_bones();
    set_bends();
    for (const Strand& strand : subject.strands) add_strand(strand);
    for (const MuscleUnit& muscle : subject.muscles) add_muscle(muscle);
    set_actions();
    if (digit_.hood && options.hood == Hood::kFractions) add_hood_rule(*digit_.hood);
    // Fill the arrays, and store the actual level of detail.
    built_.max_tension = Eigen::Map<const Eigen::VectorXd>(
        max_tension_.data(), static_cast<Eigen::Index>(max_tension_.size()));
    built_.model.friction = Eigen::VectorXd::Zero(built_.model.constant_arms.rows());
    built_.fidelity = Fidelity(Motion::kStatic, built_path(),
                               built_.model.hood ? Hood::kFractions : Hood::kSeparate);
  }

  TendonDigit take() { return std::move(built_); }

 private:
  /// Copies tree, tip and names of the skeleton.
  void set_bones() {
    const Skeleton& skeleton = built_.skeleton;
    const SkeletonTip& tip = thenar::tip(skeleton, digit_.name);
    built_.model.tree = skeleton.tree;
    built_.model.coordinates = skeleton.coordinates();
    built_.model.tip_link = tip.link;
    built_.model.tip = tip.p;
    built_.model.tip_axes = tip.axes;
    built_.names.coordinates = skeleton.coordinate_names;
    built_.names.hinges = skeleton.hinge_names;
  }

  /// Returns whether the segment that a joint moves is kept.
  [[nodiscard]] bool kept(const JointAxis& joint) const {
    return built_.skeleton.link_of_segment.count(joint.child) > 0;
  }

  /// Computes the cosine between a joint's axis and the direction about which the digit flexes: the
  /// radial one of a right hand, the ulnar one of a left hand.
  [[nodiscard]] double flexion_cosine(const JointAxis& joint) const {
    return joint.direction.dot(digit_.proximal.cross(digit_.dorsal));
  }

  /// Returns the angle of a joint of the digit, as a function of posture or frozen.
  [[nodiscard]] PostureAngle angle_of(const JointAxis& joint) const {
    const int i = place_in(built_.names.hinges, joint.name);
    if (i >= 0) {
      const Hinge<double>& hinge = built_.model.tree[i];
      return {hinge.coordinate, hinge.ratio, hinge.offset};
    }
    const auto& frozen = built_.skeleton.frozen;
    const auto at = frozen.find(joint.name);
    return at == frozen.end() ? PostureAngle{} : PostureAngle{-1, 0, at->second};
  }

  /// Sets the sheath bends.
  void set_bends() {
    // Add every flexion joint, frozen ones included.
    std::vector<SheathBend>& bends = built_.model.bends;
    for (const JointAxis& joint : subject_.joints)
      if (kept(joint) && std::abs(flexion_cosine(joint)) > kFlexionCosine)
        bends.push_back({angle_of(joint), built_.model.coordinates});
    // Find the first coordinate all of whose joints lie beyond each bend.
    int before = -1;
    for (std::size_t k = 0; k < bends.size(); ++k) {
      before = std::max(before, bends[k].angle.coordinate);
      const auto beyond =
          std::find_if(bends.begin() + static_cast<std::ptrdiff_t>(k) + 1, bends.end(),
                       [&](const SheathBend& later) { return later.angle.coordinate > before; });
      if (beyond != bends.end()) bends[k].first_coordinate_beyond = beyond->angle.coordinate;
    }
  }

  /// Returns whether the strand reaches the segment that the joint moves.
  static bool reaches(const Strand& strand, const JointAxis& joint) {
    if (strand.path.empty()) return strand.arms.count(joint.name) > 0;
    return any_of(strand.path, [&](const PathPoint& point) {
      return point.surface.empty() && point.segment == joint.child;
    });
  }

  /// Finds the metacarpophalangeal angle: that of the flexion joint before the last one that the
  /// central slip crosses.
  [[nodiscard]] PostureAngle knuckle(const std::string& central_slip) const {
    // Collect flexion joints from the wrist outwards, and count those that the slip crosses.
    const Strand* slip = find_named(subject_.strands, central_slip);
    std::vector<PostureAngle> flexions;  // flexion positive
    std::size_t crossed = 0;             // number of flexion joints up to the middle phalanx
    for (const JointAxis& joint : subject_.joints) {
      if (!kept(joint)) continue;
      if (std::abs(flexion_cosine(joint)) > kFlexionCosine) {
        const PostureAngle angle = angle_of(joint);
        const double sign = flexion_cosine(joint) > 0 ? 1 : -1;
        flexions.push_back({angle.coordinate, sign * angle.ratio, sign * angle.offset});
      }
      if (reaches(*slip, joint)) crossed = flexions.size();
    }
    return crossed < 2 ? PostureAngle{} : flexions[crossed - 2];
  }

  /// Returns the actual path model, which the subject's data may keep below the requested one.
  [[nodiscard]] Path built_path() const {
    const auto& paths = built_.model.paths;
    if (paths.empty()) return Path::kNone;
    const bool constant =
        all_of(paths, [](const TendonPath<double>& path) { return path.empty(); });
    return constant ? Path::kConstant : std::min(options_.path, Path::kViaPoint);
  }

  /// Computes the constant arms of a strand at the kept coordinates; a coupled joint adds its own,
  /// times its ratio, to its leader's [m/rad].
  [[nodiscard]] Eigen::RowVectorXd arms_of(const Strand& strand) const {
    Eigen::RowVectorXd arms = Eigen::RowVectorXd::Zero(built_.model.coordinates);
    for (const auto& [joint, arm] : strand.arms) {
      const int i = place_in(built_.names.hinges, joint);
      if (i < 0) continue;  // welded
      const Hinge<double>& hinge = built_.model.tree[i];
      arms[hinge.coordinate] += hinge.ratio * arm;
    }
    return arms;
  }

  /// Returns whether a strand is a band of the hood or pulled by a muscle of the hood: it is kept
  /// even if its own joint is frozen, since its tension continues into other bands.
  [[nodiscard]] bool in_hood(const std::string& strand) const {
    if (!digit_.hood || options_.hood != Hood::kFractions) return false;
    const HoodRule& rule = *digit_.hood;
    const auto pulls = [&](const HoodBranch& branch) {
      return any_of(subject_.muscles,
                    [&](const auto& m) { return m.name == branch.muscle && m.strand == strand; });
    };
    return strand == rule.central_slip || strand == rule.radial_band || strand == rule.ulnar_band ||
           strand == rule.terminal_slip || any_of(rule.branches, pulls);
  }

  /// Returns whether a muscle of `options.kept` pulls the strand.
  [[nodiscard]] bool is_kept(const std::string& strand) const {
    const std::vector<std::string>& kept = options_.kept;
    return any_of(subject_.muscles,
                  [&](const auto& m) { return m.strand == strand && contains(kept, m.name); });
  }

  /// Adds a strand that crosses a joint or that is needed otherwise.
  void add_strand(const Strand& strand) {
    TendonModel<double>& model = built_.model;
    // Find path and constant arms; leave out a strand with neither.
    const Eigen::RowVectorXd arms = arms_of(strand);
    TendonPath<double> path;
    if (options_.path != Path::kConstant || strand.arms.empty())
      path = kept_path(built_.skeleton, strand);
    if (!crosses_a_joint(path)) path.clear();
    if (path.empty() && arms.isZero(0) && !in_hood(strand.name) && !is_kept(strand.name)) return;
    // Check that requested constant arms exist.
    require(path.empty() || options_.path != Path::kConstant,
            "strand '{}' of subject '{}' has no constant moment arms (arms_mm)", strand.name,
            subject_.name);
    // Append a row.
    model.paths.push_back(std::move(path));
    model.constant_arms.conservativeResize(static_cast<Eigen::Index>(model.paths.size()),
                                           model.coordinates);
    model.constant_arms.bottomRows<1>() = arms;
    built_.names.strands.push_back(strand.name);
  }

  /// Adds a muscle if its strand is kept.
  void add_muscle(const MuscleUnit& muscle) {
    const int strand = place_in(built_.names.strands, muscle.strand);
    if (strand < 0) return;
    built_.model.pulls.push_back(strand);
    built_.names.muscles.push_back(muscle.name);
    max_tension_.push_back(muscle.max_force.value_or(std::numeric_limits<double>::infinity()));
  }

  /// Sets the expected action of each muscle at each joint.
  void set_actions() {
    const TendonNames& names = built_.names;
    built_.actions.setZero(static_cast<Eigen::Index>(names.muscles.size()),
                           built_.model.coordinates);
    const std::vector<std::string> shared = shared_joints(subject_);
    for (const JointAxis& joint : subject_.joints) {
      const int j = place_in(names.coordinates, joint.name);
      if (j < 0) continue;
      // Ignore the sense of flexion of joints that digits share.
      const double flexes = place_in(shared, joint.name) < 0 ? flexion_cosine(joint) : 0;
      for (std::size_t m = 0; m < names.muscles.size(); ++m) {
        const int strand = built_.model.pulls[m];
        int& action = built_.actions(static_cast<Eigen::Index>(m), j);
        // Use the sign of a stated arm, or the muscle's name at a flexion joint.
        const double arm = stated_arm(names.strands[strand], joint.name);
        if (arm != 0)
          action = arm > 0 ? 1 : -1;
        else if (std::abs(flexes) > kFlexionCosine)
          action = (flexes > 0 ? 1 : -1) * named_action(names.muscles[m], joint.name);
      }
    }
  }

  /// Returns the subject's constant arm of a strand at a joint, 0 without one [m/rad].
  [[nodiscard]] double stated_arm(const std::string& strand, const std::string& joint) const {
    const std::map<std::string, double>& arms = find_named(subject_.strands, strand)->arms;
    const auto arm = arms.find(joint);
    return arm == arms.end() ? 0 : arm->second;
  }

  /// Returns the row of a strand of the hood.
  [[nodiscard]] int hood_row(const std::string& strand) const {
    const int row = place_in(built_.names.strands, strand);
    require(row >= 0, "hood of digit '{}' names strand '{}', which crosses none of its joints",
            digit_.name, strand);
    return row;
  }

  /// Adds the hood.
  void add_hood_rule(const HoodRule& rule) {
    // Set the rows of the slips, and the joint that their shares depend on.
    built_.model.hood = HoodRows{hood_row(rule.central_slip), hood_row(rule.radial_band),
                                 hood_row(rule.ulnar_band), hood_row(rule.terminal_slip)};
    built_.model.knuckle = knuckle(rule.central_slip);
    // Add the shares of the muscles that feed the hood.
    for (const HoodBranch& branch : rule.branches) {
      const int muscle = place_in(built_.names.muscles, branch.muscle);
      require(muscle >= 0, "hood of digit '{}' names muscle '{}', which crosses none of its joints",
              digit_.name, branch.muscle);
      built_.model.hood_shares.push_back(
          {muscle, branch.side, branch.into_hood, branch.to_central, 0});
    }
  }

  const Subject& subject_;
  const Digit& digit_;
  const TendonOptions& options_;
  std::vector<double> max_tension_;
  TendonDigit built_;
};

}  // namespace

Path default_path(const Subject& subject) {
  const auto bends = [](const PathPoint& point) {
    return !point.surface.empty() || !point.rides_on.empty();
  };
  const bool more =
      any_of(subject.strands, [&](const Strand& strand) { return any_of(strand.path, bends); });
  return more ? Path::kWrapped : Path::kViaPoint;
}

TendonPath<double> carried_points(const Skeleton& skeleton, const Strand& strand) {
  TendonPath<double> points;
  for (const PathPoint& point : strand.path) {
    const auto link = skeleton.link_of_segment.find(point.segment);
    if (link == skeleton.link_of_segment.end() || !point.surface.empty()) continue;
    points.push_back({link->second, skeleton.segment_at.at(point.segment) * point.p});
  }
  return points;
}

TendonDigit build_tendon_digit(const Subject& subject, const std::string& digit,
                               const TendonOptions& options) {
  return DigitBuilder(subject, digit, options).take();
}

void check_posture(const TendonDigit& digit, const Eigen::VectorXd& q) {
  require(q.size() == digit.model.coordinates, "posture has {} angles, the digit {} joints",
          q.size(), digit.model.coordinates);
  require(q.allFinite(), "posture has an angle that is not finite");
}

TipStatics tip_statics(const TendonDigit& digit, const Eigen::VectorXd& q) {
  check_posture(digit, q);
  const TendonModel<double>& model = digit.model;
  // Compute Jacobians of the tip, moment arms and passive torque.
  const TreeState<double> state = pose_tree(model.tree, q);
  const Eigen::Vector3d tip = moved(state, model.tip_link, model.tip);
  return {position_jacobian(model.tree, state, model.tip_link, tip, model.coordinates),
          rotation_jacobian(model.tree, state, model.tip_link, model.coordinates),
          muscle_arms(model, state, q),
          passive_torque(digit.skeleton, q),
          digit.max_tension,
          digit.names.muscles};
}

Eigen::Matrix3d tip_axes(const TendonDigit& digit, const Eigen::VectorXd& q) {
  return pose_tree(digit.model.tree, q)[digit.model.tip_link].X.R * digit.model.tip_axes;
}

}  // namespace thenar
