#include "grasp/quality/grasp_matrix.h"

#include "grasp/contact/wrench_set.h"
#include "grasp/quality/manipulability.h"

namespace thenar {

Eigen::Matrix<double, 6, Eigen::Dynamic> grasp_matrix(const std::vector<Contact>& contacts,
                                                      const Eigen::Vector3d& centre,
                                                      double torque_scale) {
  // Caps with unit coefficients have unit components as axes.
  std::vector<Contact> unit = contacts;
  for (Contact& contact : unit) {
    if (contact.friction > 0) contact.friction = 1;
    if (contact.torsion > 0) contact.torsion = torque_scale;
  }
  return wrench_columns(wrench_set(unit, centre, torque_scale));
}

GraspMatrixMeasures grasp_matrix_measures(const Eigen::MatrixXd& G) {
  const Manipulability of_G = manipulability(G);
  return {of_G.rank, of_G.min_singular_value, of_G.isotropy, of_G.volume,
          static_cast<int>(G.cols()) - of_G.rank};
}

}  // namespace thenar
