#include "tendons/tendon_model.h"

#include <algorithm>
#include <limits>

#include "base/error.h"

namespace thenar {
namespace {

/// Index of a name, or -1.
int find(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

const Digit& digit_of(const Subject& subject, const std::string& name) {
  for (const Digit& digit : subject.digits)
    if (digit.name == name) return digit;
  throw InputError(fmt::format("subject '{}' has no digit '{}'", subject.name, name));
}

/// Path with points on the kept links; points on dropped segments end it.
TendonPath<double> kept_path(const Skeleton& skeleton, const Strand& strand) {
  TendonPath<double> path;
  for (const PathPoint& point : strand.path) {
    const auto link = skeleton.link_of_segment.find(point.segment);
    if (link == skeleton.link_of_segment.end()) continue;
    path.push_back({link->second, skeleton.segment_at.at(point.segment) * point.p});
  }
  for (std::size_t k = 1; k < path.size(); ++k)
    require(path[k].link == path[k - 1].link || (path[k].p - path[k - 1].p).norm() > 1e-9,
            "path of strand '{}' has a zero-length run across a joint at point {}", strand.name, k);
  return path;
}

/// Cosine to the digit's radial direction above which a hinge counts as flexion: 45 degrees.
constexpr double kFlexion = 0.7071;

bool crosses_a_joint(const TendonPath<double>& path) {
  return std::any_of(path.begin(), path.end(),
                     [&](const PathNode<double>& node) { return node.link != path.front().link; });
}

/// Joints frozen by name, and the trunk unless it is free.
std::map<std::string, double> frozen_joints(const Subject& subject, const TendonOptions& options) {
  std::map<std::string, double> frozen = options.frozen;
  if (options.trunk == Trunk::kWelded)
    for (const std::string& joint : shared_joints(subject)) frozen.emplace(joint, 0);
  return frozen;
}

/// Builds the parts of one digit in order: strands, muscles, hood.
class DigitBuilder {
 public:
  DigitBuilder(const Subject& subject, const std::string& name, const TendonOptions& options)
      : subject_(subject), digit_(digit_of(subject, name)), options_(options) {
    built_.skeleton = build_skeleton(subject, {{name}, frozen_joints(subject, options)});
    set_bones();
    for (const Strand& strand : subject.strands) add_strand(strand);
    for (const MuscleUnit& muscle : subject.muscles) add_muscle(muscle);
    if (digit_.hood && options.hood == Hood::kFractions) add_hood_rule(*digit_.hood);
    built_.max_tension = Eigen::Map<const Eigen::VectorXd>(
        max_tension_.data(), static_cast<Eigen::Index>(max_tension_.size()));
    built_.model.friction = Eigen::VectorXd::Zero(built_.model.constant_arms.rows());
    built_.fidelity = Fidelity(Motion::kStatic, built_path(),
                               built_.model.hood ? Hood::kFractions : Hood::kSeparate);
  }

  TendonDigit take() { return std::move(built_); }

 private:
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
    for (const Hinge<double>& hinge : skeleton.tree)
      if (std::abs(hinge.direction.dot(tip.axes.col(2))) > kFlexion)
        if (built_.model.flexions.empty() || built_.model.flexions.back() != hinge.coordinate)
          built_.model.flexions.push_back(hinge.coordinate);
  }

  /// The rung that the paths are really on, which the subject's data may keep below the one asked.
  Path built_path() const {
    const auto& paths = built_.model.paths;
    if (paths.empty()) return Path::kNone;
    const bool constant = std::all_of(paths.begin(), paths.end(),
                                      [](const TendonPath<double>& path) { return path.empty(); });
    return constant ? Path::kConstant : options_.path;
  }

  /// Constant arms of a strand at the kept coordinates [m/rad].
  Eigen::RowVectorXd arms_of(const Strand& strand) const {
    Eigen::RowVectorXd arms = Eigen::RowVectorXd::Zero(built_.model.coordinates);
    for (const auto& [joint, arm] : strand.arms) {
      const int j = find(built_.names.coordinates, joint);
      if (j >= 0) arms[j] = arm;
    }
    return arms;
  }

  /// A band of the hood, or what a muscle of the hood pulls, counts even where its own joint is
  /// frozen: the tension goes on to the other bands.
  bool in_hood(const std::string& strand) const {
    if (!digit_.hood || options_.hood != Hood::kFractions) return false;
    const HoodRule& rule = *digit_.hood;
    const auto pulls = [&](const HoodBranch& branch) {
      return std::any_of(subject_.muscles.begin(), subject_.muscles.end(), [&](const auto& m) {
        return m.name == branch.muscle && m.strand == strand;
      });
    };
    return strand == rule.central_slip || strand == rule.radial_band || strand == rule.ulnar_band ||
           strand == rule.terminal_slip ||
           std::any_of(rule.branches.begin(), rule.branches.end(), pulls);
  }

  void add_strand(const Strand& strand) {
    TendonModel<double>& model = built_.model;
    const Eigen::RowVectorXd arms = arms_of(strand);
    TendonPath<double> path;
    if (options_.path != Path::kConstant || strand.arms.empty())
      path = kept_path(built_.skeleton, strand);
    if (!crosses_a_joint(path)) path.clear();
    if (path.empty() && arms.isZero(0) && !in_hood(strand.name)) return;
    require(path.empty() || options_.path != Path::kConstant,
            "strand '{}' of subject '{}' has no constant moment arms (arms_mm)", strand.name,
            subject_.name);
    model.paths.push_back(std::move(path));
    model.constant_arms.conservativeResize(static_cast<Eigen::Index>(model.paths.size()),
                                           model.coordinates);
    model.constant_arms.bottomRows<1>() = arms;
    built_.names.strands.push_back(strand.name);
  }

  void add_muscle(const MuscleUnit& muscle) {
    const int strand = find(built_.names.strands, muscle.strand);
    if (strand < 0) return;
    built_.model.pulls.push_back(strand);
    built_.names.muscles.push_back(muscle.name);
    max_tension_.push_back(muscle.max_force.value_or(std::numeric_limits<double>::infinity()));
  }

  int hood_row(const std::string& strand) const {
    const int row = find(built_.names.strands, strand);
    require(row >= 0, "hood of digit '{}' names strand '{}', which crosses none of its joints",
            digit_.name, strand);
    return row;
  }

  void add_hood_rule(const HoodRule& rule) {
    built_.model.hood = HoodRows{hood_row(rule.central_slip), hood_row(rule.radial_band),
                                 hood_row(rule.ulnar_band), hood_row(rule.terminal_slip)};
    for (const HoodBranch& branch : rule.branches) {
      const int muscle = find(built_.names.muscles, branch.muscle);
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

TendonDigit build_tendon_digit(const Subject& subject, const std::string& digit,
                               const TendonOptions& options) {
  return DigitBuilder(subject, digit, options).take();
}

TipStatics tip_statics(const TendonDigit& digit, const Eigen::VectorXd& q) {
  const TendonModel<double>& model = digit.model;
  require(q.size() == model.coordinates, "posture has {} angles, the digit {} joints", q.size(),
          model.coordinates);
  require(q.allFinite(), "posture has an angle that is not finite");
  const TreeState<double> state = pose_tree(model.tree, q);
  const Eigen::Vector3d tip = moved(state, model.tip_link, model.tip);
  return {position_jacobian(model.tree, state, model.tip_link, tip, model.coordinates),
          rotation_jacobian(model.tree, state, model.tip_link, model.coordinates),
          muscle_arms(model, state, q),
          passive_torque(digit.skeleton, q),
          digit.max_tension,
          digit.names.muscles};
}

}  // namespace thenar
