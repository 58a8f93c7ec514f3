#include "posterior/kernel/layout.h"

namespace thenar::kernel {
namespace {

template <typename Matrix>
void append(const Matrix& values, std::vector<double>& row) {
  for (Eigen::Index i = 0; i < values.rows(); ++i)
    for (Eigen::Index j = 0; j < values.cols(); ++j) row.push_back(values(i, j));
}

/// The numbers of a model in the order of Layout; shifts of hood fractions are zero.
std::vector<double> row_of(const SpecimenModel<double>& model) {
  std::vector<double> row;
  for (const auto& hinge : model.digit.tree) append(hinge.direction, row);
  for (const auto& hinge : model.digit.tree) append(hinge.point, row);
  for (const auto& path : model.digit.paths)
    for (const auto& node : path) append(node.p, row);
  append(model.digit.constant_arms, row);
  append(model.digit.friction, row);
  for (const auto& share : model.digit.hood_shares) row.insert(row.end(), {0, 0, share.slope});
  append(model.digit.tip, row);
  append(model.sensor_tilt, row);
  append(model.angle_error, row);
  append(model.posture_error.transpose(), row);
  row.push_back(model.out_of_plane);
  append(model.gain, row);
  return row;
}

/// Hood fractions are no straight lines of their parameters, but their logits are.
void set_hood_shift(const Parameter& p, double value, const Layout& layout,
                    std::vector<double>& row) {
  if (p.kind == ParameterKind::kHoodEntry) row[layout.into(p.item)] = value;
  if (p.kind == ParameterKind::kHoodCentral) row[layout.central(p.item)] = value;
}

/// A digit of which every number is zero.
SpecimenModel<double> zeros(const TendonDigit& digit, int postures) {
  SpecimenModel<double> model = start_model<double>(digit.model, postures);
  for (auto& hinge : model.digit.tree) {
    hinge.direction.setZero();
    hinge.point.setZero();
  }
  for (auto& path : model.digit.paths)
    for (auto& node : path) node.p.setZero();
  for (auto& share : model.digit.hood_shares) share.slope = 0;
  model.digit.constant_arms.setZero();
  model.digit.friction.setZero();
  model.digit.tip.setZero();
  model.gain.setZero();
  return model;
}

}  // namespace

Layout::Layout(const TendonModel<double>& model, int posture_count)
    : hinges(static_cast<int>(model.tree.size())),
      coordinates(model.coordinates),
      postures(posture_count) {
  const int strands = static_cast<int>(model.paths.size());
  int count = 0;
  for (const auto& path : model.paths) {
    first_node.push_back(count);
    count += static_cast<int>(path.size());
  }
  directions = 0;
  points = directions + 3 * hinges;
  nodes = points + 3 * hinges;
  arms = nodes + 3 * count;
  frictions = arms + strands * coordinates;
  shares = frictions + strands;
  tip = shares + 3 * static_cast<int>(model.hood_shares.size());
  tilt = tip + 3;
  angle_errors = tilt + 3;
  posture_errors = angle_errors + coordinates;
  out_of_plane = posture_errors + coordinates * postures;
  gains = out_of_plane + 1;
  size = gains + static_cast<int>(model.pulls.size());
}

std::vector<double> start_numbers(const TendonDigit& digit, const FitParameters& parameters,
                                  const Layout& layout) {
  SpecimenModel<double> model = start_model<double>(digit.model, layout.postures);
  for (const Parameter& p : parameters.all) set_parameter(digit.model, p, p.mean, model);
  std::vector<double> row = row_of(model);
  for (const Parameter& p : parameters.all) set_hood_shift(p, p.mean, layout, row);
  return row;
}

std::vector<Move> number_moves(const TendonDigit& digit, const FitParameters& parameters,
                               const Layout& layout) {
  std::vector<Move> moves;
  for (std::size_t p = 0; p < parameters.all.size(); ++p) {
    if (parameters.coordinate[p] < 0) continue;
    SpecimenModel<double> model = zeros(digit, layout.postures);
    set_parameter(digit.model, parameters.all[p], parameters.ratio[p], model);
    std::vector<double> row = row_of(model);
    set_hood_shift(parameters.all[p], parameters.ratio[p], layout, row);
    for (int i = 0; i < layout.size; ++i)
      if (row[i] != 0) moves.push_back({i, parameters.coordinate[p], row[i]});
  }
  return moves;
}

}  // namespace thenar::kernel
