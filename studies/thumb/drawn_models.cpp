#include "studies/thumb/drawn_models.h"

#include "kinematics_fit/model/predict_forces.h"

namespace thenar::internal {

DrawnModels::DrawnModels(const HandPosterior& posterior, const Eigen::Ref<const Eigen::MatrixXd>& x)
    : posterior_(posterior),
      moving_(posterior.moving_parameters()),
      values_(posterior.values(x).specimens.front()) {}

TendonModel<double> DrawnModels::at(Eigen::Index k) const {
  const FitProblem& problem = posterior_.problem();
  return specimen_model(problem.digit(), problem.parameters(),
                        values_with(problem.parameters(), moving_, values_.col(k)))
      .digit;
}

std::vector<TendonModel<double>> DrawnModels::all() const {
  std::vector<TendonModel<double>> models;
  for (Eigen::Index k = 0; k < count(); ++k) models.push_back(at(k));
  return models;
}

Eigen::MatrixXd DrawnModels::values(ParameterKind kind) const {
  const std::vector<Parameter>& all = posterior_.problem().parameters().all;
  std::vector<int> rows;
  for (std::size_t i = 0; i < moving_.size(); ++i)
    if (all[static_cast<std::size_t>(moving_[i])].kind == kind) rows.push_back(static_cast<int>(i));
  return values_(rows, Eigen::all);
}

std::vector<std::string> DrawnModels::names(ParameterKind kind) const {
  std::vector<std::string> found;
  for (const int p : moving_) {
    const Parameter& parameter = posterior_.problem().parameters().all[static_cast<std::size_t>(p)];
    if (parameter.kind == kind) found.push_back(parameter.name);
  }
  return found;
}

}  // namespace thenar::internal
