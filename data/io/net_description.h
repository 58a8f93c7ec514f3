#pragma once

/// Description of an extensor mechanism as plain data, for the finger of any subject.
///
/// Places are stated on the four bones of one reference finger, by role, so that the same net can
/// be laid on any finger: along bones as fractions of their lengths, across them as fractions of
/// the heights of the extensor over the joints. Lines of bones run between joint centres.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "data/io/subject.h"

namespace thenar {

/// Bones of a finger, from the palm outwards.
enum class BoneRole { kMetacarpal, kProximal, kMiddle, kDistal };
inline constexpr std::array kBoneRoleNames{
    EnumName{BoneRole::kMetacarpal, "metacarpal"}, EnumName{BoneRole::kProximal, "proximal"},
    EnumName{BoneRole::kMiddle, "middle"}, EnumName{BoneRole::kDistal, "distal"}};

/// Joints between the bones.
enum class FingerJoint { kMcp, kPip, kDip };
inline constexpr std::array kFingerJointNames{EnumName{FingerJoint::kMcp, "MCP"},
                                              EnumName{FingerJoint::kPip, "PIP"},
                                              EnumName{FingerJoint::kDip, "DIP"}};

/// A place on a bone.
struct NetPlace {
  BoneRole bone = BoneRole::kProximal;
  double along = 0;   // 0 at the bone's proximal end, 1 at its distal end; from -1 to 2 [1]
  double angle = 0;   // angle about the bone: 0 dorsal, +90 degrees radial, 180 palmar [rad]
  double height = 0;  // distance from the bone's line, in the reference finger [m]
};

/// A point of a strand of the subject.
struct StrandPoint {
  std::vector<std::string> strands;  // possible names of the strand; empty: no such point
  int point = 0;                     // counted from the insertion; negative: from the origin
};

/// A surface on which nodes may rest and over which bands may bend.
struct NetSurface {
  std::string name;
  SurfaceShape shape = SurfaceShape::kSphere;  // sphere, cylinder or capsule
  NetPlace center;
  double radius = 0;       // radius in the reference finger [m]
  bool across = false;     // axis along the joint's axis instead of the bone
  double half_length = 0;  // half length of the axis, reference finger [m]
};

/// A node of the net.
struct NetNodePlan {
  std::string name;
  bool floating = true;
  NetPlace place;                     // place, or start of a floating node
  StrandPoint strand;                 // replaces `place` in subjects that have it
  std::vector<std::string> surfaces;  // surfaces on which a floating node may rest
};

/// A band between two nodes.
struct NetBandPlan {
  std::string name;
  std::string from, to;      // nodes
  double slack = 0;          // length in the reference finger [m]; 0: fitted to the straight finger
  std::string strains_like;  // band whose strain it is fitted to have in the straight finger
  double EA = 0;             // tension per strain [N]
  double toe = 0;            // strain up to which fibres are recruited [1]
  double max_strain = 0.1;   // largest admissible strain [1]
  std::string over;          // surface over which it bends; empty: straight
  double side = 0;           // direction from that surface's centre to the band, about the bone, as
                             // NetPlace::angle [rad]
};

/// One node at which a muscle pulls on the net.
struct NetPullPlan {
  std::string node;
  double share = 1;      // share of the muscle's tension [1]
  bool relayed = false;  // hands on, over a bone, what other pulls have given to the net already:
                         // it does not count as a share
  StrandPoint exit;      // exit of its path from the net, in subjects that have it; otherwise:
  std::optional<NetPlace> exit_place;  // absent: at the exit of the muscle's own path
  std::string over;                    // surface over which it bends; empty: straight
  double EA = 0;  // axial stiffness of the part inside the net, for muscles given by length [N]
};

/// A muscle that pulls on the net. If its shares do not add up to one, the rest pulls on the bone,
/// along the whole path of the muscle.
struct NetMusclePlan {
  std::string role;                       // "EDC"
  std::vector<std::string> names;         // muscles of the subject that may have this role
  BoneRole exit = BoneRole::kMetacarpal;  // last bone of the muscle's own path
  bool optional = false;                  // a finger without this muscle still has the net
  bool hood_share = false;  // the subject's own fraction into the hood, if it has a rule, replaces
                            // the shares given here
  std::vector<NetPullPlan> pulls;
};

/// Bands whose tensions add up to those of the slips of the hood.
struct NetSlips {
  std::vector<std::string> central, radial, ulnar, terminal;
};

/// An extensor mechanism, on the reference finger.
struct NetDescription {
  std::string name;
  std::string description;
  std::string source;                      // citation keys, "A, B"
  std::map<BoneRole, double> bone_length;  // bone lengths of the reference finger [m]
  std::map<FingerJoint, double> height;    // height of its extensor over the joints' axes [m]
  /// Strands whose moment arm in the straight finger is that height in a subject; if the subject
  /// has none of them, the strand of the first muscle.
  std::map<FingerJoint, std::vector<std::string>> height_strands;
  double friction = 0;  // friction coefficient of nodes on bone, at most 1 [1]
  std::vector<NetSurface> surfaces;
  std::vector<NetNodePlan> nodes;
  std::vector<NetBandPlan> bands;
  std::vector<NetMusclePlan> muscles;
  NetSlips slips;
};

/// Reads a net from TOML; the format is in docs/data_format.md.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] NetDescription read_net(const std::string& path);

/// Parses a net from text already in memory; `path` only names it in messages.
[[nodiscard]] NetDescription parse_net(const std::string& text, const std::string& path);

}  // namespace thenar
