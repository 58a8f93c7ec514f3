#pragma once

/// Parts of a subject file, in the order in which they are read. Every reference is checked where
/// it stands, against the parts read before.

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/lists.h"
#include "data/io/subject.h"
#include "data/io/toml_table.h"

namespace thenar::internal {

/// Frame in which a publication gives path points:  p = origin + axes' * c.
struct PointFrame {
  std::string segment;                                 // segment that carries the frame
  Eigen::Vector3d origin{0, 0, 0};                     // [m] (3)
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // rows: its axes in the subject (3, 3)
  double unit = 0;  // length of which ratios are multiples [m]; 0: none
};

/// A subject that is being read.
struct SubjectDraft {
  Subject subject;
  double specific_tension = 0;                 // specific tension of muscles without their own [Pa]
  std::map<std::string, std::string> aliases;  // other name of a segment -> its name
  std::map<std::string, PointFrame> frames;
  std::map<std::string, Eigen::Vector3d> chain_ends;  // digit -> end of its DH chain [m] (3)
};

/// Readers of the parts: segments, joints and their passive moments, frames, surfaces, strands,
/// muscles, digits and tip maps.
void read_segments(TomlTable& top, SubjectDraft& draft);
void read_joints(TomlTable& top, SubjectDraft& draft);
void read_dh_chains(TomlTable& top, SubjectDraft& draft);
void read_passive(TomlTable& top, SubjectDraft& draft);
void read_frames(TomlTable& top, SubjectDraft& draft);
void read_surfaces(TomlTable& top, SubjectDraft& draft);
void read_strands(TomlTable& top, SubjectDraft& draft);
void read_muscles(TomlTable& top, SubjectDraft& draft);
void read_digits(TomlTable& top, SubjectDraft& draft);
void read_tip_maps(TomlTable& top, SubjectDraft& draft);

/// Adds a joint. @throws DataError unless the joints still form a tree, in order.
void add_joint(TomlTable& table, const JointAxis& joint, SubjectDraft& draft);

/// Reads `range_deg = [lower, upper]`, if given, into the joint.
void read_range(TomlTable& table, JointAxis& joint);

/// Reads a hood under a digit.
[[nodiscard]] HoodRule read_hood(TomlTable& table, const SubjectDraft& draft);

/// Reads one element of a path: a point, or a surface over which the strand bends.
[[nodiscard]] PathPoint read_path_element(TomlTable& table, const SubjectDraft& draft);

/// Refuses impossible paths: surfaces at the ends, or an origin that rides on a strand far away.
void check_path(const TomlTable& table, const Strand& strand, const SubjectDraft& draft);

/// Reads the table's `name`, which no earlier part of its kind may have.
[[nodiscard]] std::string new_name(TomlTable& table, const std::vector<std::string>& taken);

/// Refuses a name that is not in `names`; `what` is "segment", `key` the place of the name.
void check_reference(const TomlTable& table, const std::string& key, const std::string& what,
                     const std::string& name, const std::vector<std::string>& names);

/// Reads the value of `key`, which must be in `names`.
[[nodiscard]] std::string reference(TomlTable& table, const std::string& key,
                                    const std::string& what, const std::vector<std::string>& names);

/// Reads the value of `key`, a segment or an alias of one.
[[nodiscard]] std::string segment_reference(TomlTable& table, const std::string& key,
                                            const SubjectDraft& draft);

}  // namespace thenar::internal
