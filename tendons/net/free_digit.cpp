#include "tendons/net/free_digit.h"

#include <map>
#include <utility>

#include "base/lists.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// Returns the digit with only the named muscles.
TendonDigit with_muscles(TendonDigit digit, const std::vector<std::string>& named) {
  const TendonDigit all = digit;
  digit.names.muscles.clear();
  digit.model.pulls.clear();
  for (std::size_t m = 0; m < all.names.muscles.size(); ++m) {
    if (!contains(named, all.names.muscles[m])) continue;
    digit.max_tension[digit.model.pulls.size()] = all.max_tension[m];
    digit.actions.row(static_cast<Eigen::Index>(digit.model.pulls.size())) =
        all.actions.row(static_cast<Eigen::Index>(m));
    digit.names.muscles.push_back(all.names.muscles[m]);
    digit.model.pulls.push_back(all.model.pulls[m]);
  }
  const auto muscles = static_cast<Eigen::Index>(digit.model.pulls.size());
  digit.max_tension.conservativeResize(muscles);
  digit.actions.conservativeResize(muscles, digit.actions.cols());
  return digit;
}

/// Transfers the parts of a net from a digit with all joints free to the same digit with frozen
/// joints, where bones are displaced.
class NetCarrier {
 public:
  NetCarrier(const TendonDigit& whole, const TendonDigit& digit) : whole_(whole), digit_(digit) {
    // Map every link that carries a bone to that bone's link and displacement in the other digit.
    for (const auto& [segment, link] : whole.skeleton.link_of_segment) {
      if (link < 0) continue;
      link_[link] = digit.skeleton.link_of_segment.at(segment);
      moved_[link] =
          digit.skeleton.segment_at.at(segment) * whole.skeleton.segment_at.at(segment).inverse();
    }
  }

  BuiltNet carry(BuiltNet built) const {
    for (NetNode& node : built.net.nodes) carry(node.link, node.p);
    for (BoneSurface& surface : built.net.surfaces) {
      if (surface.link >= 0) surface.X = moved_.at(surface.link) * surface.X;
      surface.link = link(surface.link);
    }
    carry_muscles(built);
    carry_frame(built.frame);
    return built;
  }

 private:
  [[nodiscard]] int link(int whole) const { return whole < 0 ? -1 : link_.at(whole); }

  void carry(int& on, Vector3d& p) const {
    if (on >= 0) p = moved_.at(on) * p;
    on = link(on);
  }

  /// Renumbers the muscles by the digit; those that it lacks have no pull.
  void carry_muscles(BuiltNet& built) const {
    const auto number = [&](int muscle) {
      return place_in(digit_.names.muscles, whole_.names.muscles[muscle]);
    };
    for (MuscleAttachment& pull : built.pulls) {
      pull.muscle = number(pull.muscle);
      if (pull.muscle < 0) pull = {0, 0};
    }
    std::vector<NetMuscle> muscles;
    for (NetMuscle& muscle : built.muscles) {
      muscle.muscle = number(muscle.muscle);
      for (PathNode<double>& point : muscle.own_path) carry(point.link, point.p);
      if (muscle.muscle >= 0) muscles.push_back(std::move(muscle));
    }
    built.muscles = std::move(muscles);
  }

  void carry_frame(FingerFrame& frame) const {
    for (FingerBone& bone : frame.bones) {
      if (bone.link >= 0)
        for (Vector3d* direction : {&bone.along, &bone.dorsal, &bone.radial})
          *direction = moved_.at(bone.link).R * *direction;
      int proximal = bone.link;
      carry(proximal, bone.proximal);
      carry(bone.link, bone.distal);
    }
    // Keep the angles of the straight posture that are coordinates of the digit.
    Eigen::VectorXd straight(digit_.model.coordinates);
    for (Eigen::Index j = 0; j < straight.size(); ++j)
      straight[j] = frame.straight[place_in(whole_.names.coordinates, digit_.names.coordinates[j])];
    frame.straight = straight;
  }

  const TendonDigit &whole_, &digit_;
  std::map<int, int> link_;
  std::map<int, Pose<double>> moved_;
};

}  // namespace

TendonDigit free_digit(const Subject& subject, const TendonDigit& digit) {
  TendonOptions options{Path::kViaPoint, Hood::kSeparate};
  for (const std::string& joint : shared_joints(subject)) {
    const auto at = digit.skeleton.frozen.find(joint);
    if (at == digit.skeleton.frozen.end() || at->second != 0) options.wrist_mode = WristMode::kFree;
  }
  const std::string& name = digit.skeleton.tips.front().digit;
  TendonDigit whole = build_tendon_digit(subject, name, options);
  if (options.wrist_mode == WristMode::kWelded) return whole;
  // Drop tendons of other fingers, which cross the wrist as well.
  const TendonDigit own = build_tendon_digit(subject, name, {Path::kViaPoint, Hood::kSeparate});
  return with_muscles(std::move(whole), own.names.muscles);
}

BuiltNet transferred(BuiltNet built, const TendonDigit& whole, const TendonDigit& digit) {
  return NetCarrier(whole, digit).carry(std::move(built));
}

}  // namespace thenar
