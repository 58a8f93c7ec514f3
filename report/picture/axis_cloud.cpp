#include "report/picture/axis_cloud.h"

#include "base/error.h"
#include "kinematics_fit/model/predict_forces.h"
#include "kinematics_fit/model/specimen_model.h"
#include "report/picture/digit_layers.h"
#include "tendons/neighbouring_axes.h"

namespace thenar {
namespace {

constexpr double kAxisLength = 0.03;   // Length of an axis as drawn [m]
constexpr double kLineOpacity = 0.12;  // Opacity of one line of a cloud [1]
const char* const kCloudColors[] = {"#0072b2", "#d55e00", "#cc79a7", "#e69f00", "#56b4e9"};

/// Ends of one axis of a digit, a tenth of a millimetre exact.
Json ends(const Eigen::Vector3d& point, const Eigen::Vector3d& axis) {
  const auto end = [&](double s) {
    const Eigen::Vector3d p = 1000 * (point + s * kAxisLength * axis);
    return rounded(p, 100);
  };
  return Json::array({end(-0.5), end(0.5)});
}

/// One item for each hinge: a line for each draw.
Json cloud_layer(const TendonDigit& start, const Eigen::VectorXd& q, const AxisCloud& cloud,
                 const std::string& color) {
  std::vector<Json> positions(start.names.hinges.size(), Json::array());
  for (const TendonModel<double>& drawn : cloud.drawn) {
    const TreeState<double> state = pose_tree(drawn.tree, q);
    require(state.size() == positions.size(), "a draw of {} has {} hinges, the digit has {}",
            cloud.name, state.size(), positions.size());
    const std::vector<Eigen::Vector3d> points = axis_points(drawn, state);
    for (std::size_t i = 0; i < state.size(); ++i)
      for (const Json& end : ends(points[i], state[i].axis)) positions[i].push_back(end);
  }
  return layer(cloud.name, color, list_of_each(positions, [](const Json& of_hinge) {
                 return Json{{"kind", "lines"}, {"positions", of_hinge}, {"opacity", kLineOpacity}};
               }));
}

}  // namespace

AxisCloud axis_cloud(const std::string& name, const TendonDigit& digit,
                     const FitParameters& parameters, const std::vector<int>& moving,
                     const Eigen::Ref<const Eigen::MatrixXd>& values, Eigen::Index most) {
  AxisCloud cloud{name, {}};
  for (const Eigen::Index j : spread(values.cols(), most))
    cloud.drawn.push_back(
        specimen_model(digit, parameters, values_with(parameters, moving, values.col(j))).digit);
  return cloud;
}

Json axis_cloud_picture(const TendonDigit& start, const Eigen::VectorXd& q,
                        const std::vector<AxisCloud>& clouds,
                        const std::optional<TendonModel<double>>& truth,
                        const std::string& caption) {
  // The axes at the start, the clouds of draws, and the true axes if they are known.
  Json layers = Json::array({bone_layer(start, q, "#b8a48a"),
                             axis_layer(start, q, "axes before", "#777777", kAxisLength, true)});
  for (std::size_t k = 0; k < clouds.size(); ++k)
    layers.push_back(cloud_layer(start, q, clouds[k], kCloudColors[k % std::size(kCloudColors)]));
  if (truth) {
    TendonDigit true_digit = start;
    true_digit.model = *truth;
    layers.push_back(axis_layer(true_digit, q, "true axes", "#009e73", 1.2 * kAxisLength, false));
  }
  return with(digit_scene_block(caption, start.model.tip_axes, layers), {{"link", "axis-clouds"}});
}

}  // namespace thenar
