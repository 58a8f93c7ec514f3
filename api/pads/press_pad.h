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
  double angle = 0;             // of the pad to the object, as touch_pad() [rad]
  double turn = 0;              // of the object about its way into the pad [rad]
  std::optional<double> force;  // at the end of the way, along it [N]
  std::optional<double> depth;  // of the object since it touched [m]
  std::optional<double> rate;   // of the object [m/s]; 0: so slow that all relaxes; absent: at
                                // once, before anything relaxes
  double hold = 0;              // time that the object then stands still, with a rate above 0 [s]
  double friction = 0.6;        // of skin on aluminium [Seo2009] [1]
  int points = 12;              // on the way, evenly spread in depth
  int hold_points = 12;         // while it stands still, ever farther apart
  double force_error = 0.05;    // estimated, below which the mesh does [1]
  int max_elements = 20000;     // a mesh is not refined beyond
  bool rungs = false;           // whether laws, elements, meshes are compared, which takes minutes
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
  double time = 0;                // since the touch [s]; 0 without a rate
  double depth = 0;               // of the object since it touched [m]
  double force = 0;               // of the object on the pad, along its way [N]
  Eigen::Vector3d push{0, 0, 0};  // the same force, pad's frame [N] (3)
  double area = 0;                // of the patch, deformed [m^2]
  double stick = 0;               // share of the normal force on nodes that stick [1]
  double pressure = 0;            // largest at a node, at least the mean over the patch [Pa]
  double force_error = 0;         // estimated, relative [1]
  double penetration = 0;         // deepest point of the object within a face [m]
  std::size_t elements = 0;
  int iterations = 0;  // since the press began
  double cpu = 0;      // processor time since the press began [s]
};

/// Result of press_pad().
struct [[nodiscard]] PressResult {
  PressRequest request;
  Outcome outcome;  // done: steps; its status is that of the step that failed, if one did
  NamedPad pad;
  PressObject object;
  PadTouch touch;                      // where it began
  Pose<double> X_PO;                   // of the object where it ended, pad's frame
  std::vector<PressInstant> instants;  // those that were solved
  PressedSkin skin;                    // at the last of them
  std::vector<PressRung> rungs;        // if asked
  std::string message;                 // why it failed; empty: it did not
  double cpu = 0;                      // processor time of the press, without rungs [s]

  [[nodiscard]] bool relaxes() const;                    // whether time counts
  [[nodiscard]] const PressInstant* end_of_way() const;  // its last instant; null: there is none
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
