#pragma once

/// The extensor mechanism of a finger described once, as plain data, for the finger of any subject.
///
/// Places are stated on the four bones of one reference finger, by role, so that the same net can
/// be laid on any finger: along the bones in parts of their lengths, across them in parts of the
/// heights at which the extensor runs over the joints. Bones' lines run between joint centres.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "data/io/subject.h"

namespace thenar {

/// The bones of a finger, from the palm outwards.
enum class BoneRole { kMetacarpal, kProximal, kMiddle, kDistal };

/// The joints between them.
enum class FingerJoint { kMcp, kPip, kDip };

/// A place on a bone.
struct NetPlace {
  BoneRole bone = BoneRole::kProximal;
  double along = 0;   // 0 at the bone's proximal end, 1 at its distal end; from -1 to 2 [1]
  double angle = 0;   // about the bone: 0 dorsal, +90 degrees radial, 180 palmar [rad]
  double height = 0;  // from the bone's line, in the reference finger [m]
};

/// A point of a path of the subject.
struct StrandPoint {
  std::vector<std::string> strands;  // names that it may have; empty: no such point
  int point = 0;                     // from the insertion; negative: from the origin, -1 the last
};

/// A surface on which nodes may rest and over which bands may bend.
struct NetSurface {
  std::string name;
  SurfaceShape shape = SurfaceShape::kSphere;  // sphere, cylinder or capsule
  NetPlace center;
  double radius = 0;       // in the reference finger [m]
  bool across = false;     // its axis runs along the joint's axis, not along the bone
  double half_length = 0;  // of the axis, reference finger [m]
};

/// A knot of the net.
struct NetNodePlan {
  std::string name;
  bool floating = true;
  NetPlace place;                     // where it is, or where a floating node starts
  StrandPoint strand;                 // instead of `place`, in subjects that have it
  std::vector<std::string> surfaces;  // on which a floating node may rest
};

/// A band between two nodes.
struct NetBandPlan {
  std::string name;
  std::string from, to;      // nodes
  double slack = 0;          // in the reference finger [m]; 0: fitted to the straight finger
  std::string strains_like;  // band whose strain it is fitted to have in the straight finger
  double EA = 0;             // tension per strain [N]
  double toe = 0;            // strain up to which fibres are recruited [1]
  std::string over;          // surface that it bends over; empty: straight
  double side = 0;           // from that surface's centre towards the band, about the bone, as
                             // NetPlace::angle [rad]
};

/// One place where a muscle pulls on the net.
struct NetPullPlan {
  std::string node;
  double share = 1;      // of the muscle's tension [1]
  bool relayed = false;  // what other pulls have given to the net already, handed on over a bone:
                         // it does not count as a share
  StrandPoint exit;      // where it leaves the net, in subjects that have it; else there:
  std::optional<NetPlace> exit_place;  // absent: where the muscle's own path is left
  std::string over;                    // surface that it bends over; empty: straight
  double EA = 0;                       // of the run inside the net, for muscles given by length [N]
};

/// What pulls the net. Shares that do not add up to one leave the rest to the bone, along the whole
/// path of the muscle.
struct NetMusclePlan {
  std::string role;                       // "EDC"
  std::vector<std::string> names;         // of the subject's muscles that have this role
  BoneRole exit = BoneRole::kMetacarpal;  // its own path is left at its last point up to this bone
  bool optional = false;                  // a finger without it still has the net
  bool hood_share = false;  // the subject's own fraction into the hood, if it has a rule, goes
                            // before the shares here
  std::vector<NetPullPlan> pulls;
};

/// Bands whose tensions make up the slips of the hood.
struct NetSlips {
  std::vector<std::string> central, radial, ulnar, terminal;
};

struct NetDescription {
  std::string name;
  std::string description;
  std::string source;                      // citation keys, "A, B"
  std::map<BoneRole, double> bone_length;  // of the reference finger [m]
  std::map<FingerJoint, double> height;    // of its extensor over the joints' axes [m]
  std::map<FingerJoint, std::vector<std::string>>
      height_strands;   // whose arm in the straight
                        // finger is that height in a subject; the strand of the
                        // first muscle if the subject has none of them
  double friction = 0;  // of nodes on bone, at most 1 [1]
  std::vector<NetSurface> surfaces;
  std::vector<NetNodePlan> nodes;
  std::vector<NetBandPlan> bands;
  std::vector<NetMusclePlan> muscles;
  NetSlips slips;
};

/// Reads a net from TOML; the format is in docs/data_format.md.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] NetDescription read_net(const std::string& path);

/// The same from text already in memory; `path` only names it in messages.
[[nodiscard]] NetDescription parse_net(const std::string& text, const std::string& path);

}  // namespace thenar
