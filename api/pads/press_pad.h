#pragma once

/// A finger pad pressed by a rigid object: force, contact area, pressure, stick and time.
/// Example: examples/16_pressed_pad.cpp.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "api/named/pads.h"
#include "api/pads/press_object.h"
#include "api/pads/press_rungs.h"
#include "base/enum_names.h"
#include "base/progress.h"
#include "pads/press_surface.h"
#include "solvers/status.h"

namespace thenar {

/// Options of press_pad(): the pad, the object, and its motion into the pad. Exactly one of `force`
/// and `depth` is given.
struct PressRequest {
  PadRequest pad;               // pad that is pressed
  PressObjectRequest object;    // object that presses it
  double angle = 0;             // angle between pad and object, see touch_pad() [rad]
  double turn = 0;              // rotation of the object about its direction of motion [rad]
  std::optional<double> force;  // force along the motion at its end [N]
  std::optional<double> depth;  // displacement of the object after first touch [m]
  std::optional<double> rate;  // speed of the object [m/s]; 0: quasi-static, fully relaxed; absent:
                               // instantaneous, without relaxation
  double hold = 0;             // time at rest after the motion, for a rate above 0 [s]
  double friction = 0.6;       // friction coefficient of skin on aluminium [Seo2009] [1]
  int points = 12;             // points during the motion, evenly spread in depth
  int hold_points = 12;        // points while the object is at rest, at growing intervals
  double force_error = 0.05;   // largest estimated error of the force of an accepted mesh [1]
  int max_elements = 20000;    // limit of refinement
  bool rungs = false;          // compare laws, elements and meshes, which takes minutes
};

/// Phase of the object's motion.
enum class PressPhase { kWay, kHold };
inline constexpr std::array kPressPhaseNames{EnumName{PressPhase::kWay, "way"},
                                             EnumName{PressPhase::kHold, "hold"}};
[[nodiscard]] inline std::string name_of(PressPhase phase) {
  return name_in(kPressPhaseNames, phase);
}

/// State of a press at one instant.
struct PressInstant {
  PressPhase phase = PressPhase::kWay;  // motion or hold
  double time = 0;                      // time since first touch [s]; 0 without a rate
  double depth = 0;                     // displacement of the object since first touch [m]
  double force = 0;                     // force of the object on the pad along its motion [N]
  Eigen::Vector3d push{0, 0, 0};        // force of the object on the pad, pad's frame [N] (3)
  double area = 0;                      // area of the deformed patch [m^2]
  double stick = 0;                     // share of the normal force on nodes that stick [1]
  double pressure = 0;       // largest nodal pressure, at least the mean over the patch [Pa]
  double force_error = 0;    // estimated relative error of the force [1]
  double penetration = 0;    // largest penetration of a face [m]
  std::size_t elements = 0;  // number of elements of the mesh
  int iterations = 0;        // iterations since the press began
  double cpu = 0;            // processor time since the press began [s]
};

/// Result of press_pad().
struct [[nodiscard]] PressResult {
  PressRequest request;                // request that was answered
  Outcome outcome;                     // done: steps; status of the failed step, if there is one
  NamedPad pad;                        // pad that was pressed
  PressObject object;                  // object that pressed it
  PadTouch touch;                      // object at first touch
  Pose<double> X_PO;                   // final pose of the object, pad's frame
  std::vector<PressInstant> instants;  // solved instants
  PressedSkin skin;                    // skin at the last instant
  std::vector<PressRung> rungs;        // comparison, if requested
  std::string message;                 // why it failed; empty: it did not
  double cpu = 0;                      // processor time of the press, without rungs [s]

  [[nodiscard]] bool relaxes() const;  // tissue relaxes: time matters
  [[nodiscard]] const PressInstant* end_of_motion()
      const;  // last instant of the motion; null: none
};

/// Presses a pad.
///
/// With a depth d the object moves to d in even steps. With a force F, forces rise with the power
/// 3/2 of the step number, so that depths are about even; there may be fewer points than requested.
/// With a rate v, time is depth / v; with a force and a rate, the object moves to the depths that
/// Hertz's power law through the previous steps predicts for these forces, and finally to F itself,
/// whose time is predicted: a warning states its error. During the first third of the motion the
/// estimated error of the force may be three times the requested one. A step that fails or is
/// stopped ends the press; the steps before it are kept.
/// @throws InputError if a number is out of range, not exactly one of force and depth is given, or
/// an input is not found; DataError for a wrong file.
[[nodiscard]] PressResult press_pad(const PressRequest& request, const Progress& progress = {});

}  // namespace thenar
