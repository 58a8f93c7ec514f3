#pragma once

/// Options of a question for the poses of a subject or a robot.

#include <string>
#include <vector>

#include "api/named/posture.h"

namespace thenar {

/// Options of a question for poses: a model and its postures.
struct PoseRequest {
  std::string model;                // a subject or a robot: its name, or its file; required
  std::string data;                 // folder with subjects/, robots/ ..; empty: the usual ones
  std::vector<std::string> digits;  // digits of a subject to keep; empty: all
  PostureRequest posture;           // joints that are not named are at 0
  PostureRequest frozen;            // joints of a subject that are welded at these angles
  std::vector<Vary> vary;           // in the unit of the posture; the last one varies fastest
};

}  // namespace thenar
