#include "api/close.h"

#include <utility>

namespace thenar {

CloseResult close_in_world(const CloseRequest& request, const Progress& progress) {
  GraspRequest grasp;
  grasp.world = request.world;
  grasp.approach = false;
  GraspResult found = measure_grasp(grasp, progress);
  return {request, found.outcome, std::move(found)};
}

}  // namespace thenar
