#pragma once

/// Pads pressed by objects of all sorts, and what must hold whatever happens.

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "pads/pad_press.h"

namespace thenar {

/// A way to press a pad: towards it, sideways, back, and off again.
struct StabilityTrial {
  std::string name;
  PadModel model;
  RigidObject object;
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  // of the object in the pad's frame (3, 3)
  Eigen::Vector3d above{0, 0, 0};                   // over which point it comes down [m] (3)
  Eigen::Vector3d along{0, 0, -1};                  // towards the pad; unit (3)
  double depth = 1e-3;                              // from the first touch [m]
  int steps = 1;
  Eigen::Vector3d sideways{0, 0, 0};  // after that [m] (3)
  int steps_sideways = 1;
  bool back = false;     // the same way back and off the pad
  int max_elements = 1;  // 1: never refined
  double step_time = 0;  // of each step [s]
};

/// What came of it.
struct PressReport {
  int solved = 0, failed = 0;  // steps
  std::string message;         // of the first step that failed
  bool touches = true;         // the object came near the pad
  // Breaches of what must hold.
  bool finite = true;              // all numbers of states and results
  bool told = true;                // each failure has a message
  bool intact = true;              // a failed step left the state as it was
  double unbalanced = 0;           // push against the reactions at the bone, largest [1]
  double beyond_cone = 0;          // shear over friction times normal force, less 1, largest [1]
  double pulls = 0;                // most negative normal force [N]
  double depth = 0;                // of the object within faces, largest after a solved step [m]
  double work = 0, most_work = 0;  // of the object on the pad: at the end, and the most before [J]
  double drives = 0;               // what friction did with the slip of a step instead of against
                                   // it, over all friction times the object's way, largest [1]
  double left = 0;                 // displacement after the object left the pad, largest [m]
  double push = 0;                 // largest force [N]
  std::size_t elements = 0;
  int iterations = 0;
};

[[nodiscard]] PressReport run_trial(const StabilityTrial& trial);

/// A default pad with a tissue of 12 kPa.
[[nodiscard]] PadModel trial_pad(double poisson_ratio);

/// Objects by name: "wall", "ball", "pearl" (smaller than a face of the skin), "rod" (along y),
/// "edge", "corner", "blade", "pin", "mesh"; turned so that what names them points down.
struct TrialObject {
  std::shared_ptr<const Shape> shape;
  Eigen::Matrix3d R;
};
[[nodiscard]] TrialObject trial_object(const std::string& name);
[[nodiscard]] const std::vector<std::string>& trial_object_names();

/// Any object, Poisson's ratio, depth to 60 % of the thickness, friction, direction and steps.
[[nodiscard]] StabilityTrial random_trial(std::mt19937& random);

}  // namespace thenar
