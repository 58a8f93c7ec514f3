#include "api/close.h"

namespace thenar {

CloseResult close_in_world(const CloseRequest& request, const Progress& progress) {
  GraspRequest grasp;
  grasp.world = request.world;
  grasp.approach = false;
  return {measure_grasp(grasp, progress)};
}

}  // namespace thenar
