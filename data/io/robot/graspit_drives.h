#pragma once

/// Degrees of freedom of a GraspIt! robot, and the joints that they drive.

#include <set>
#include <string>

#include "data/io/robot/import_xml.h"
#include "data/io/robot/robot.h"

namespace thenar {

/// Drive of a joint parameter, "d2*0.333+40": the degree of freedom, ratio and offset.
struct GraspitDrive {
  int dof = -1;          // -1: a constant, in `offset`
  double ratio = 1;      // [1]
  double offset = 0;     // offset in the file's unit [deg] or [mm]
  bool ignored = false;  // the offset follows '-' alone, for which GraspIt! itself takes 0
};

/// Parses "d0", "d1*0.5", "d1+40", "d1*0.5-2", "0.5*d1", or a number.
/// @throws InputError for anything else.
[[nodiscard]] GraspitDrive parse_graspit_drive(const std::string& text);

}  // namespace thenar

namespace thenar::internal {

/// Records the elements in an element that are not read.
/// @param read  names of the elements that are read
void note_others(UnreadElements& unread, const pugi::xml_node& node,
                 const std::set<std::string>& read);

/// Reads degrees of freedom and joints of a robot. Methods throw DataError `path:line: ..`.
class GraspitDrives {
 public:
  GraspitDrives(const XmlFile& file, UnreadElements& unread, RobotSpec& robot)
      : file_(file), unread_(unread), robot_(robot) {}

  /// Adds the degree of freedom of a <dof>, at first without limits.
  void add_dof(const pugi::xml_node& node);
  /// Reads a <joint> with frame Rz(theta) Tz(d) Tx(a) Rx(alpha), of which theta or d is driven.
  [[nodiscard]] RobotJoint read_joint(const pugi::xml_node& node);
  /// Gives each degree of freedom the range of its joints, and its effort their unit.
  void settle();

 private:
  [[nodiscard]] double number(const pugi::xml_node& parent, const char* name,
                              double otherwise) const;
  [[nodiscard]] GraspitDrive drive(const pugi::xml_node& joint, const char* name);
  void set_drive(RobotJoint& joint, const pugi::xml_node& node, const GraspitDrive& driven,
                 bool turns);

  const XmlFile& file_;
  UnreadElements& unread_;
  RobotSpec& robot_;
};

}  // namespace thenar::internal
