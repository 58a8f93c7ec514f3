#pragma once

/// A finger pad pressed by a rigid object: force, contact area, pressure, stick and time.

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

/// Options of press_pad(): the pad, the object, and the way into the pad. One of `force` and
/// `depth` is given.
struct PressRequest {
  PadRequest pad;
  PressObjectRequest object;
  double angle = 0;             // angle between pad and object, see touch_pad() [rad]
  double turn = 0;              // rotation of the object about its direction of motion [rad]
  std::optional<double> force;  // force along the motion at its end [N]
  std::optional<double> depth;  // displacement of the object after first touch [m]
  std::optional<double> rate;  // speed of the object [m/s]; 0: so slow that all relaxes; absent: at
                               // once, before anything relaxes
  double hold = 0;             // time that the object then stands still, with a rate above 0 [s]
  double friction = 0.6;       // friction coefficient of skin on aluminium [Seo2009] [1]
  int points = 12;             // points during the motion, evenly spread in depth
  int hold_points = 12;        // while it stands still, ever farther apart
  double force_error = 0.05;   // estimated, below which the mesh does [1]
  int max_elements = 20000;    // a mesh is not refined beyond
  bool rungs = false;          // compare laws, elements and meshes, which takes minutes
};

/// Phase of the object's motion.
enum class PressPhase { kWay, kHold };
inline constexpr std::array kPressPhaseNames{EnumName{PressPhase::kWay, "way"},
                                             EnumName{PressPhase::kHold, "hold"}};
[[nodiscard]] inline std::string name_of(PressPhase phase) {
  return name_in(kPressPhaseNames, phase);
}

/// A press at one instant.
struct PressInstant {
  PressPhase phase = PressPhase::kWay;
  double time = 0;                // time since first touch [s]; 0 without a rate
  double depth = 0;               // displacement of the object since first touch [m]
  double force = 0;               // force of the object on the pad along its motion [N]
  Eigen::Vector3d push{0, 0, 0};  // force of the object on the pad, pad's frame [N] (3)
  double area = 0;                // area of the deformed patch [m^2]
  double stick = 0;               // share of the normal force on nodes that stick [1]
  double pressure = 0;            // largest at a node, at least the mean over the patch [Pa]
  double force_error = 0;         // estimated, relative [1]
  double penetration = 0;         // deepest point of the object within a face [m]
  std::size_t elements = 0;
  int iterations = 0;  // iterations since the press began
  double cpu = 0;      // processor time since the press began [s]
};

/// Result of press_pad().
struct [[nodiscard]] PressResult {
  PressRequest request;
  Outcome outcome;  // done: steps; its status is that of the step that failed, if one did
  NamedPad pad;
  PressObject object;
  PadTouch touch;                      // pose at first touch
  Pose<double> X_PO;                   // final pose of the object, pad's frame
  std::vector<PressInstant> instants;  // solved instants
  PressedSkin skin;                    // skin at the last instant
  std::vector<PressRung> rungs;        // comparison, if requested
  std::string message;                 // why it failed; empty: it did not
  double cpu = 0;                      // processor time of the press, without rungs [s]

  [[nodiscard]] bool relaxes() const;                    // tissue relaxes: time matters
  [[nodiscard]] const PressInstant* end_of_way() const;  // last instant of the motion; null: none
};

/// Presses a pad.
///
/// By depth d the object goes in even steps to d; by force F, to forces that rise with the power
/// 3/2 of the step, so that depths are about even; there may be fewer points than asked for. With a
/// rate v time is depth / v, and by force the object goes to depths that Hertz's power through the
/// steps before foretells of these forces, and at last to F itself, whose time is foretold: a
/// warning tells of its error. On the first third of the way the estimated error of the force may
/// be three times what was asked. A step that fails, or that is stopped, ends the press with what
/// was solved before.
/// @throws InputError where a number is out of range, or not one of force and depth is given, or
/// something is not to be found; DataError of files.
[[nodiscard]] PressResult press_pad(const PressRequest& request, const Progress& progress = {});

}  // namespace thenar
