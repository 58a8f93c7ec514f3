#include "tendons/tip_map.h"

#include "base/error.h"
#include "tendons/tip_balance.h"

namespace thenar {

TipStatics statics_of_map(const Eigen::Ref<const Eigen::MatrixXd>& A,
                          const Eigen::Ref<const Eigen::Matrix3Xd>& axes,
                          const Eigen::Ref<const Eigen::VectorXd>& max_tension) {
  const Eigen::Index rows = A.rows(), moments = axes.cols();
  require(rows == 3 + moments, "a map with {} moment axes needs {} rows, got {}", moments,
          3 + moments, rows);
  TipStatics statics;
  statics.J = Eigen::Matrix3Xd::Zero(3, rows);
  statics.J.leftCols<3>().setIdentity();
  if (moments > 0) {
    statics.W = Eigen::Matrix3Xd::Zero(3, rows);
    statics.W.rightCols(moments) = axes;
  }
  statics.R = A.transpose();
  statics.tau_0 = Eigen::VectorXd::Zero(rows);
  statics.max_tension = max_tension;
  internal::require_statics(statics);
  return statics;
}

}  // namespace thenar
