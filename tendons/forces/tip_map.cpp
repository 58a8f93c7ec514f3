#include "tendons/forces/tip_map.h"

#include <limits>

#include "base/error.h"
#include "base/lists.h"
#include "tendons/forces/tip_balance.h"

namespace thenar {
namespace {

/// Returns F0 of a muscle; infinite where the subject does not state it [N].
double max_tension(const Subject& subject, const std::string& name) {
  for (const MuscleUnit& muscle : subject.muscles)
    if (muscle.name == name && muscle.max_force) return *muscle.max_force;
  return std::numeric_limits<double>::infinity();
}

/// Returns the axis of a moment row: "ty" turns about y.
Eigen::Vector3d axis_of(const std::string& row) { return Eigen::Vector3d::Unit(row[1] - 'x'); }

}  // namespace

const TipMap& find_tip_map(const Subject& subject, const std::string& digit,
                           const std::string& name) {
  std::string known;
  for (const TipMap& map : subject.tip_maps) {
    if (map.digit != digit) continue;
    if (name.empty() || map.name == name) return map;
    known += (known.empty() ? "" : ", ") + map.name;
  }
  throw InputError(fmt::format("digit '{}' of subject '{}' has no tip map '{}'; there are {}",
                               digit, subject.name, name, known.empty() ? "none" : known));
}

std::vector<std::string> moment_rows(const TipMap& map) {
  std::vector<std::string> rows;
  for (const std::string name : {"tx", "ty", "tz"})
    if (place_in(map.rows, name) >= 0) rows.push_back(name);
  return rows;
}

TipStatics statics_from_tip_map(const Subject& subject, const TipMap& map) {
  const std::vector<std::string> moments = moment_rows(map);
  std::vector<std::string> rows{"Fx", "Fy", "Fz"};
  append_all(rows, moments);

  Eigen::MatrixXd A(static_cast<Eigen::Index>(rows.size()), map.A.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Eigen::Index row = place_in(map.rows, rows[i]);
    require(row >= 0, "tip map '{}' of subject '{}' has no row '{}'; forces need Fx, Fy and Fz",
            map.name, subject.name, rows[i]);
    A.row(static_cast<Eigen::Index>(i)) = map.A.row(row);
  }
  Eigen::Matrix3Xd axes(3, static_cast<Eigen::Index>(moments.size()));
  for (std::size_t k = 0; k < moments.size(); ++k)
    axes.col(static_cast<Eigen::Index>(k)) = axis_of(moments[k]);

  Eigen::VectorXd F0(map.A.cols());
  for (Eigen::Index i = 0; i < F0.size(); ++i) F0[i] = max_tension(subject, map.muscles[i]);
  TipStatics statics = statics_from_matrix(A, axes, F0);
  statics.muscles = map.muscles;
  return statics;
}

TipStatics statics_from_matrix(const Eigen::Ref<const Eigen::MatrixXd>& A,
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
