#pragma once

/// What `thenar quality` says of the contacts of one file.

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "apps/contact_file.h"
#include "grasp/quality/epsilon.h"
#include "grasp/quality/grasp_matrix.h"
#include "grasp/quality/task_margin.h"
#include "grasp/quality/volume.h"

namespace thenar {

struct ContactQuestion {
  ForceNorm limit = ForceNorm::kL1;
  double gap = 1e-3;      // of epsilon, in unit forces [1]
  int edges = 0;          // of friction pyramids; 0: cones
  double first_edge = 0;  // about the normal, from the first tangent [deg]
  bool volume = true;
};

/// How much of a task contacts withstand whose normal forces are limited to 1 N.
struct TaskAnswer {
  TaskMargin margin;             // worst_load in N and N m
  std::vector<double> squeezes;  // of each load: the least limit that withstands it; infinite: none
                                 // does; not a number: the programme did not end (N)
};

struct ContactAnswer {
  Epsilon epsilon;
  std::optional<Volume> volume;                     // none: not asked, or not known of a plane
  std::optional<GraspMatrixMeasures> grasp_matrix;  // none where a contact has wrenches of its own
  std::optional<TaskAnswer> task;
  double epsilon_cpu, volume_cpu;  // the first with the making of the wrenches [s]
};

[[nodiscard]] ContactAnswer answer(const ContactFile& file, const ContactQuestion& question);

[[nodiscard]] nlohmann::ordered_json json_of(const std::string& path, const ContactFile& file,
                                             const ContactAnswer& answer);

[[nodiscard]] std::string text_of(const std::string& path, const ContactFile& file,
                                  const ContactAnswer& answer);

}  // namespace thenar
