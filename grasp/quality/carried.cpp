#include "grasp/quality/carried.h"

#include <algorithm>

#include "grasp/quality/stops.h"

namespace thenar::internal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Whether a number is no more than rounding beside the torques of unit forces.
constexpr double kNoTorque = 1e-12;

/// Who makes the forces of a contact.
struct Carrier {
  int held = -1;          // the outermost held coordinate that feels it; -1: none
  bool structure = true;  // no coordinate feels it but locked ones
};

Carrier carrier_of(const MatrixXd& torques, const Reactions& reactions, double zero) {
  Carrier carrier;
  for (Index j = 0; j < torques.rows(); ++j)
    if (torques.row(j).cwiseAbs().maxCoeff() > zero && !is_locked(reactions, j))
      carrier.structure = false;
  for (const int j : reactions.held)
    if (torques.row(j).cwiseAbs().maxCoeff() > zero) carrier.held = std::max(carrier.held, j);
  return carrier;
}

/// Splits the forces of one contact, at `column` of x, between what is pressed and what is borne.
void split(Felt& felt, const std::vector<int>& held, const Carrier& carrier, Index column,
           Index size) {
  VectorXd borne = felt.x.col(column);
  for (const int j : held) {
    borne(j) = 0;
    if (j != carrier.held) felt.x.row(j).segment(column, size).setZero();
  }
  felt.p.conservativeResize(felt.x.rows(), felt.p.cols() + 1);
  felt.p.rightCols(1) = borne;
}

}  // namespace

Felt felt_by(const WrenchSet& set, const MatrixXd& T, const Reactions& reactions) {
  const double zero = T.size() > 0 ? kNoTorque * T.cwiseAbs().maxCoeff() : 0;
  Felt felt{T, MatrixXd(T.rows(), 0), {}, {}, Eigen::RowVectorXd::Zero(T.cols())};
  std::vector<Carrier> carriers;
  std::vector<Index> columns;
  bool any_held = false;
  for (Index column = 0; carriers.size() < set.caps.size();) {
    const Index size = 1 + set.caps[carriers.size()].A.cols();
    columns.push_back(column);
    carriers.push_back(carrier_of(T.middleCols(column, size), reactions, zero));
    any_held = any_held || carriers.back().held >= 0;
    column += size;
  }
  for (std::size_t i = 0; i < carriers.size() && any_held; ++i) {
    felt.pushed_back(columns[i]) = carriers[i].structure ? 1 : -1;
    if (carriers[i].held < 0 && !carriers[i].structure) continue;
    split(felt, reactions.held, carriers[i], columns[i], 1 + set.caps[i].A.cols());
    felt.borne.push_back(static_cast<int>(i));
  }
  for (int j = 0; j < T.rows(); ++j) {
    const double x = felt.x.cols() > 0 ? felt.x.row(j).cwiseAbs().maxCoeff() : 0;
    const double p = felt.p.cols() > 0 ? felt.p.row(j).cwiseAbs().maxCoeff() : 0;
    if (std::max(x, p) > zero) felt.rows.push_back(j);
  }
  return felt;
}

}  // namespace thenar::internal
