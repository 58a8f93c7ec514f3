#include "api/close.h"

namespace thenar {

CloseResult close_in_world(const CloseRequest& request, const Progress& progress) {
  GraspRequest grasp;
  grasp.world = request.world;
  grasp.approach = false;
  return {grasp_in_world(grasp, progress)};
}

}  // namespace thenar
