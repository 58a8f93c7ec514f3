#include "report/pages/forces.h"

namespace thenar {
namespace {

/// The two components of a force that one plane shows; [horizontal, vertical].
struct Plane {
  const char* name;
  const char* x_label;
  const char* y_label;
  int x, y;  // components
};
constexpr Plane kPlanes[] = {
    {"flexion plane", "distal \u2190 \u2192 proximal [N]", "palmar \u2190 \u2192 dorsal [N]", 0, 1},
    {"lateral plane", "ulnar \u2190 \u2192 radial [N]", "palmar \u2190 \u2192 dorsal [N]", 2, 1}};

Json arrow(const PredictedTrial& trial, const Plane& plane) {
  const auto pick = [&](const Eigen::Vector3d& v) { return Json::array({v[plane.x], v[plane.y]}); };
  Json out{{"group", trial.loads},
           {"measured", pick(trial.measured)},
           {"predicted", pick(trial.predicted)}};
  if (trial.sd.minCoeff() > 0) out["predicted_sd"] = pick(trial.sd);
  return out;
}

/// Panels in the order in which postures first appear.
Json panels(const Prediction& prediction, const Plane& plane) {
  Json out = Json::array();
  for (const PredictedTrial& trial : prediction.trials) {
    Json* panel = nullptr;
    for (Json& known : out)
      if (known["title"] == trial.posture) panel = &known;
    if (panel == nullptr) {
      out.push_back({{"title", trial.posture}, {"arrows", Json::array()}});
      panel = &out.back();
    }
    (*panel)["arrows"].push_back(arrow(trial, plane));
  }
  return out;
}

}  // namespace

Json force_panels(const Prediction& prediction, const std::string& caption) {
  Json planes = Json::array();
  for (const Plane& plane : kPlanes)
    planes.push_back({{"name", plane.name},
                      {"x_label", plane.x_label},
                      {"y_label", plane.y_label},
                      {"panels", panels(prediction, plane)}});
  return {{"type", "vectors"}, {"caption", caption}, {"planes", planes}};
}

}  // namespace thenar
