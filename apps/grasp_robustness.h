#pragma once

/// How sure a grasp is: thenar grasp --robustness N.

#include <nlohmann/json.hpp>

#include "apps/grasp_answer.h"
#include "base/progress.h"
#include "grasp/quality/robustness.h"
#include "report/pages/grasp.h"

namespace thenar {

/// What is not known, and how often it is drawn.
struct RobustnessQuestion {
  int draws = 0;
  unsigned seed = 1;
  ContactUncertainty contacts{0.2, 2e-3, 0.1};  // friction by a fifth, 2 mm, 0.1 rad
  double place = 5e-3;                          // of the object, standard deviation an axis [m]
  double turn = 0.05;                           // of the object, standard deviation an axis [rad]
};

struct GraspRobustness {
  RobustnessQuestion question;
  Robustness contacts;  // the same contacts with other friction, places and normals
  Robustness pose;      // the object moved and turned: approached, closed and touched anew
};

/// Both, each from a generator of the seed. Moves of the object are normal along and about each of
/// its axes, about its centre of mass; one after which the hand does not grasp is a miss, which is
/// no force closure and below every epsilon. Closing moves the object between jaws, but does not
/// turn it: a box that is off by angles touches flat jaws along edges or at corners, where it may
/// turn about their line, and epsilon is near zero; real jaws would turn it flush. So of flat faces
/// the second says how sure the grasp is before it settles. Pyramids and the gap are the
/// question's.
/// @throws Stopped where progress says stop
[[nodiscard]] GraspRobustness robustness_of(const GraspQuestion& question,
                                            const CollisionHand& touching,
                                            const GraspAnswer& answer,
                                            const RobustnessQuestion& asked,
                                            const Progress& progress);

[[nodiscard]] nlohmann::ordered_json robustness_json(const GraspRobustness& robustness);
[[nodiscard]] std::vector<MeasureRow> robustness_rows(const GraspRobustness& robustness);

}  // namespace thenar
