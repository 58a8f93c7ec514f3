#pragma once

/// Quality of a grasp, computed from its contacts alone, without hand or motors.
///
///     ContactQualityRequest request;
///     request.contacts = "two_soft_fingers";
///     const double epsilon = measure_contacts(request).epsilon.lower;

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "grasp/contact/wrench_set.h"
#include "grasp/quality/epsilon.h"
#include "grasp/quality/grasp_matrix.h"
#include "grasp/quality/volume.h"
#include "solvers/status.h"

namespace thenar {

/// Options of a question for grasp quality: the contacts and the measures.
struct ContactQualityRequest {
  std::string contacts;  // a file, or the name of one of contacts/; required, unless `text`
  std::string text;      // content of the contacts file (JSON); empty: it is read
  int line = 1;          // number of the first line of `text`, for messages
  std::string data;      // folder with contacts/; empty: the usual ones
  ForceNorm norm = ForceNorm::kL1;  // norm that limits all contact forces together
  double gap = 1e-3;                // maximum of upper - lower for unit contact forces, > 0 [1]
  int edges = 0;                    // edges of friction pyramids, 3 to 1000; 0: the true cones
  double first_edge = 0;  // angle of the first edge about the normal, from the first tangent [rad]
  bool volume = true;     // compute the volume, which takes 80 to 5,000 times as long as epsilon
};

/// Largest multiple of a task that contacts withstand if their normal forces are limited to 1 N.
struct TaskQuality {
  Status status = Status::kSolved;  // how the computation ended
  std::optional<double> lower,
      upper;  // bounds of the multiple [1]; absent: not converged; infinite: there is no load
  Wrench worst_load;    // load with the smallest multiple [N m], [N]
  double residual = 0;  // largest KKT residual of the programs [1]
  std::vector<std::optional<double>>
      grasp_forces;  // least limit for each load [N]; infinite: none; absent: not known (loads)
};

/// Qualities of a contact set.
struct ContactQualityResult {
  ContactQualityRequest request;  // request that was answered
  Outcome outcome;                // warnings: ignored keys, normalised normals, probable mistakes
  std::string contacts;           // file that was read
  std::size_t count = 0;          // number of contacts
  double torque_scale = 0;        // length that divides torques [m]
  bool planar = false;            // forces in a plane, torques about its normal
  Epsilon epsilon{};              // bounds of epsilon [unit forces]
  std::optional<Volume> volume;   // absent: not requested, or not defined in a plane
  std::optional<GraspMatrixMeasures> grasp_matrix;  // absent where a contact has its own wrenches
  std::optional<TaskQuality> task;                  // absent: the file has no task
  double epsilon_cpu = 0, volume_cpu = 0;  // processor time; the first includes the wrenches [s]
};

/// Checks all options that do not depend on the contacts.
/// @throws InputError for a gap that is not positive, or edges out of range.
void require_valid(const ContactQualityRequest& request);

/// Reads contacts and computes their epsilon, volume, grasp matrix and task margin.
/// @throws InputError as require_valid(), or if there are no such contacts; DataError if the file
///         is wrong.
[[nodiscard]] ContactQualityResult measure_contacts(const ContactQualityRequest& request);

}  // namespace thenar
