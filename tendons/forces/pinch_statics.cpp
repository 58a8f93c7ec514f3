#include "tendons/forces/pinch_statics.h"

#include "base/error.h"

namespace thenar {
namespace {

/// Removes the effect of a load on these joints from J and W.
void take_load_off(const std::vector<int>& joints, Eigen::Matrix3Xd& J, Eigen::Matrix3Xd& W) {
  for (const int joint : joints) {
    require(joint >= 0 && joint < J.cols(), "no joint {}, there are {}", joint, J.cols());
    J.col(joint).setZero();
    if (W.cols() > 0) W.col(joint).setZero();
  }
}

}  // namespace

TipStatics without_load_on(TipStatics statics, const std::vector<int>& joints) {
  take_load_off(joints, statics.J, statics.W);
  return statics;
}

std::vector<StaticsDerivative> without_load_on(std::vector<StaticsDerivative> slopes,
                                               const std::vector<int>& joints) {
  for (StaticsDerivative& slope : slopes) take_load_off(joints, slope.J, slope.W);
  for (const int joint : joints) {
    StaticsDerivative& slope = slopes.at(static_cast<std::size_t>(joint));
    slope.J.setZero();
    slope.W.setZero();
  }
  return slopes;
}

}  // namespace thenar
