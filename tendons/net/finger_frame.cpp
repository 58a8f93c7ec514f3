#include "tendons/net/finger_frame.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/ranges.h>
#include <Eigen/Geometry>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMcp = 0, kPip = 1, kDip = 2;
// Smallest cosine between a flexing joint's axis and the flexion direction, see tendon_model.cpp
// [1]
constexpr double kFlexionCosine = 0.7071;

/// Straight run of a tendon across a joint.
struct Run {
  PathNode<double> distal, proximal;
};

/// Point of an axis nearest to a run, and their distance.
struct Nearest {
  Vector3d on_axis;
  double distance;
};

Nearest nearest(const Vector3d& axis_point, const Vector3d& axis, const Run& run) {
  // Solve for the nearest points of two lines in general position.
  const Vector3d u = (run.proximal.p - run.distal.p).normalized();
  const Vector3d w = run.distal.p - axis_point;
  const double cosine = axis.dot(u), square = 1 - cosine * cosine;
  const double s = (w.dot(axis) - cosine * w.dot(u)) / square;
  const Vector3d across = axis.cross(u).normalized();
  return {axis_point + s * axis, std::abs(w.dot(across))};
}

/// Builder of the frame of a finger.
class FrameBuilder {
 public:
  FrameBuilder(const Subject& subject, const TendonDigit& digit, const NetDescription& net)
      : subject_(subject), digit_(digit), net_(net), skeleton_(digit.skeleton) {
    // Find the digit, its flexion axis and its radial side.
    tip_digit_ = find_named(subject.digits, skeleton_.tips.front().digit);
    require(tip_digit_->name != "thumb", "net '{}' is for fingers and cannot be used for the thumb",
            net.name);
    flexion_ = tip_digit_->proximal.cross(tip_digit_->dorsal);
    side_ = tip_digit_->radial.dot(flexion_) < 0 ? -1 : 1;
    find_joints();
    find_extensor();
  }

  /// Builds the frame.
  FingerFrame take() {
    // Place joint centres and bones at the reference posture, then measure heights when straight.
    for (std::size_t j = 0; j < 3; ++j) centre_[j] = nearest_at_reference(j).on_axis;
    set_bones();
    set_straight();
    const TreeState<double> state = pose_tree(skeleton_.tree, frame_.straight);
    for (std::size_t j = 0; j < 3; ++j) set_height(j, state);
    set_ratios();
    return frame_;
  }

 private:
  /// Finds the joints of the finger, walking up from the tip.
  void find_joints() {
    // Collect joints whose axis flexes, from the tip to the base.
    std::string segment = tip_digit_->tip_segment;
    for (auto joint = subject_.joints.rbegin(); joint != subject_.joints.rend(); ++joint) {
      if (joint->child != segment) continue;
      if (std::abs(joint->direction.dot(flexion_)) > kFlexionCosine && found_ < 3)
        joint_[2 - found_++] = &*joint;
      segment = joint->parent;
      chain_.push_back(joint->child);
    }
    chain_.push_back(segment);
    require(found_ == 3, "net '{}' needs three flexion joints in the {}, subject '{}' has {}",
            net_.name, tip_digit_->name, subject_.name, found_);
  }

  /// Finds the strand of the extensor, the net's first muscle.
  void find_extensor() {
    require(!net_.muscles.empty(), "net '{}' has no muscle", net_.name);
    const std::vector<std::string> names = muscles_of(digit_, net_.muscles.front());
    require(!names.empty(), "net '{}' needs muscle '{}' ({}), and none crosses the {} of '{}'",
            net_.name, net_.muscles.front().role, fmt::join(net_.muscles.front().names, ", "),
            tip_digit_->name, subject_.name);
    extensor_ = &pulled_strand(subject_, names.front());
  }

  /// Returns the place of a segment in the digit, counted from the base; -1: not in the digit.
  [[nodiscard]] int depth(const std::string& segment) const {
    const int place = place_in(chain_, segment);
    return place < 0 ? -1 : static_cast<int>(chain_.size()) - place;
  }

  /// Returns the run of a strand across joint j, if it has one.
  [[nodiscard]] std::optional<Run> run_across(const Strand& strand, std::size_t j) const {
    // Find consecutive points on both sides of the joint.
    const int child = depth(joint_[j]->child);
    const PathPoint* a = nullptr;
    for (const PathPoint& b : strand.path) {
      if (!b.surface.empty() || depth(b.segment) < 0) continue;
      if (a != nullptr && depth(a->segment) >= child && depth(b.segment) < child)
        return Run{carried(*a), carried(b)};
      a = &b;
    }
    return std::nullopt;
  }

  /// Returns the extensor's run across joint j.
  [[nodiscard]] Run extensor_run(std::size_t j) const {
    // Prefer a strand named for this joint to the extensor's own run.
    const auto named = net_.height_strands.find(static_cast<FingerJoint>(j));
    if (named != net_.height_strands.end())
      if (const Strand* strand = find_strand(subject_, digit_, named->second))
        if (const auto run = run_across(*strand, j)) return *run;
    const auto run = run_across(*extensor_, j);
    require(run.has_value(),
            "net '{}' needs the extensor's run over the {} of the {}: strand '{}' of subject '{}' "
            "has no points on both sides of it",
            net_.name, name_in(kFingerJointNames, static_cast<FingerJoint>(j)), tip_digit_->name,
            extensor_->name, subject_.name);
    return *run;
  }

  /// Poses a path point at the reference posture.
  [[nodiscard]] PathNode<double> carried(const PathPoint& point) const {
    return {skeleton_.link_of_segment.at(point.segment),
            skeleton_.segment_at.at(point.segment) * point.p};
  }

  [[nodiscard]] const Pose<double>& at_joint(std::size_t j) const {
    return skeleton_.segment_at.at(joint_[j]->parent);
  }
  [[nodiscard]] Vector3d axis(std::size_t j) const { return at_joint(j).R * joint_[j]->direction; }

  [[nodiscard]] Nearest nearest_at_reference(std::size_t j) const {
    return nearest(at_joint(j) * joint_[j]->point, axis(j), extensor_run(j));
  }

  /// Sets one bone.
  void set_bone(BoneRole role, const std::string& segment, const Vector3d& proximal,
                const Vector3d& distal, const Vector3d& flexion) {
    FingerBone& bone = frame_.bones[static_cast<std::size_t>(role)];
    bone.segment = segment;
    bone.link = skeleton_.link_of_segment.at(segment);
    bone.proximal = proximal;
    // Set length and direction of its line.
    bone.distal = distal;
    bone.length = (proximal - distal).norm();
    require(bone.length > 0, "a bone of the {} of subject '{}' has no length: segment '{}'",
            tip_digit_->name, subject_.name, segment);
    bone.along = (proximal - distal) / bone.length;
    // Set the dorsal direction, square to the mean of the flexion axes, and the radial one.
    bone.dorsal = flexion.cross(bone.along).normalized();
    bone.radial = side_ * bone.along.cross(bone.dorsal);
  }

  /// Sets all bones and the scale of the finger.
  void set_bones() {
    const Vector3d tip = skeleton_.tips.front().p;
    // Set the phalanges between joint centres and the tip.
    set_bone(BoneRole::kProximal, joint_[kPip]->parent, centre_[kMcp], centre_[kPip],
             axis(kMcp) + axis(kPip));
    set_bone(BoneRole::kMiddle, joint_[kDip]->parent, centre_[kPip], centre_[kDip],
             axis(kPip) + axis(kDip));
    set_bone(BoneRole::kDistal, joint_[kDip]->child, centre_[kDip], tip, axis(kDip));
    // Compute the scale against the reference finger.
    double length = 0, reference = 0;
    for (BoneRole role : {BoneRole::kProximal, BoneRole::kMiddle, BoneRole::kDistal}) {
      length += frame_.bone(role).length;
      reference += net_.bone_length.at(role);
    }
    frame_.scale = length / reference;
    // Set the metacarpal with the scaled length.
    const double metacarpal = frame_.scale * net_.bone_length.at(BoneRole::kMetacarpal);
    set_bone(BoneRole::kMetacarpal, joint_[kMcp]->parent,
             centre_[kMcp] + metacarpal * metacarpal_direction(), centre_[kMcp], axis(kMcp));
  }

  /// Computes the direction of the metacarpal, unit, towards the wrist.
  [[nodiscard]] Vector3d metacarpal_direction() const {
    const std::string& segment = joint_[kMcp]->parent;
    // Use the points of the extensor on the metacarpal if they are far enough apart.
    std::vector<Vector3d> points;
    for (const PathPoint& point : extensor_->path)
      if (point.segment == segment && point.surface.empty()) points.push_back(carried(point).p);
    // Smallest length of a run that gives the direction of the bone [m]
    constexpr double kMinDirectionLength = 0.01;
    if (points.size() > 1 && (points.back() - points.front()).norm() > kMinDirectionLength)
      return (points.back() - points.front()).normalized();
    // Otherwise use its segment, then the axes of the digit.
    for (const Segment& s : subject_.segments)
      if (s.name == segment && (s.proximal - s.distal).norm() > kMinDirectionLength)
        return (skeleton_.segment_at.at(segment).R * (s.proximal - s.distal)).normalized();
    return skeleton_.tips.front().axes.col(0);
  }

  /// Turns every joint that may back by the angle between its bones.
  void set_straight() {
    frame_.straight = Eigen::VectorXd::Zero(skeleton_.coordinates());
    // Skip coupled joints, which have no coordinate of their own.
    for (std::size_t j = 0; j < 3; ++j) {
      const int place = place_in(skeleton_.coordinate_names, joint_[j]->name);
      if (place < 0) continue;
      // Compute the angle between the two bones about the joint's axis.
      const Vector3d d = axis(j), u = frame_.bones[j].along, v = frame_.bones[j + 1].along;
      const double bent = std::atan2(d.dot(u.cross(v)), u.dot(v) - d.dot(u) * d.dot(v));
      frame_.straight[place] = -bent;
    }
  }

  void set_height(std::size_t j, const TreeState<double>& state) {
    // Run and axis of the joint in the straight finger.
    Run run = extensor_run(j);
    for (PathNode<double>* point : {&run.distal, &run.proximal})
      point->p = moved(state, point->link, point->p);
    const int link = skeleton_.link_of_segment.at(joint_[j]->parent);
    const Vector3d at = moved(state, link, Vector3d(at_joint(j) * joint_[j]->point));
    const Vector3d d = link < 0 ? axis(j) : Vector3d(state[link].X.R * axis(j));
    frame_.height[j] = nearest(at, d, run).distance;
  }

  void set_ratios() {
    // Compute the ratios at the joints, then at both ends of each bone.
    std::array<double, 3> ratio;
    for (std::size_t j = 0; j < 3; ++j)
      ratio[j] = frame_.height[j] / net_.height.at(static_cast<FingerJoint>(j));
    for (std::size_t b = 0; b < 4; ++b) {
      frame_.bones[b].ratio[0] = ratio[b == 0 ? 0 : b - 1];
      frame_.bones[b].ratio[1] = ratio[std::min<std::size_t>(b, 2)];
    }
  }

  const Subject& subject_;
  const TendonDigit& digit_;
  const NetDescription& net_;
  const Skeleton& skeleton_;
  const Digit* tip_digit_ = nullptr;
  Vector3d flexion_;
  double side_ = 1;
  int found_ = 0;
  std::array<const JointAxis*, 3> joint_{};
  std::vector<std::string> chain_;  // segments from the tip to the base
  const Strand* extensor_ = nullptr;
  std::array<Vector3d, 3> centre_;
  FingerFrame frame_;
};

}  // namespace

FingerFrame finger_frame(const Subject& subject, const TendonDigit& digit,
                         const NetDescription& description) {
  return FrameBuilder(subject, digit, description).take();
}

FingerFrame reference_finger(const NetDescription& description) {
  FingerFrame frame;
  frame.scale = 1;
  // Place the bones end to end along x.
  double end = description.bone_length.at(BoneRole::kMetacarpal);
  for (std::size_t b = 0; b < 4; ++b) {
    FingerBone& bone = frame.bones[b];
    bone.length = description.bone_length.at(static_cast<BoneRole>(b));
    bone.proximal = end * Vector3d::UnitX();
    end -= bone.length;
    bone.distal = end * Vector3d::UnitX();
    bone.along = Vector3d::UnitX();
    bone.dorsal = Vector3d::UnitY();
    bone.radial = Vector3d::UnitZ();
    bone.ratio[0] = bone.ratio[1] = 1;
  }
  for (std::size_t j = 0; j < 3; ++j)
    frame.height[j] = description.height.at(static_cast<FingerJoint>(j));
  return frame;
}

double height_ratio(const FingerBone& bone, double along) {
  const double s = std::min(1.0, std::max(0.0, along));
  return bone.ratio[0] + s * (bone.ratio[1] - bone.ratio[0]);
}

Vector3d direction_around(const FingerBone& bone, double angle) {
  return std::cos(angle) * bone.dorsal + std::sin(angle) * bone.radial;
}

Vector3d place_position(const FingerFrame& frame, const NetPlace& place) {
  const FingerBone& bone = frame.bone(place.bone);
  return bone.proximal + place.along * (bone.distal - bone.proximal) +
         height_ratio(bone, place.along) * place.height * direction_around(bone, place.angle);
}

const Strand& pulled_strand(const Subject& subject, const std::string& muscle) {
  for (const MuscleUnit& unit : subject.muscles)
    if (unit.name == muscle)
      for (const Strand& strand : subject.strands)
        if (strand.name == unit.strand) return strand;
  throw InputError(
      fmt::format("subject '{}' has no muscle '{}' with a strand", subject.name, muscle));
}

const Strand* find_strand(const Subject& subject, const TendonDigit& digit,
                          const std::vector<std::string>& names) {
  const std::vector<std::string>& here = digit.names.strands;
  for (const std::string& name : names)
    for (const Strand& strand : subject.strands)
      if (strand.name == name && contains(here, name)) return &strand;
  return nullptr;
}

std::vector<std::string> muscles_of(const TendonDigit& digit, const NetMusclePlan& role) {
  std::vector<std::string> found;
  for (const std::string& muscle : digit.names.muscles)
    if (contains(role.names, muscle)) found.push_back(muscle);
  return found;
}

}  // namespace thenar
