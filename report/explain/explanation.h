#pragma once

/// Explanations as sections of lines and a table, for text and for fields.

#include <string>
#include <vector>

#include "api/explain.h"
#include "report/fields.h"

namespace thenar {

struct Section {
  std::string key;                      // key in JSON: "cost"
  std::string title;                    // title for people
  Table table = {};                     // content; may be empty
  std::vector<std::string> lines = {};  // sentences above the table
};

using Explanation = std::vector<Section>;

/// Explains one digit of a subject: its parts, costs, possible questions, and free parameters of a
/// fit.
[[nodiscard]] Explanation explain(const Subject& subject, const DigitExplained& says);
[[nodiscard]] Explanation explain(const Experiment& experiment);
[[nodiscard]] Explanation explain(const Fit& fit, const FitExplained& found);
/// Explains an extensor net: its nodes, bands, muscles and surfaces, and the assumptions of a hood
/// that is a net.
[[nodiscard]] Explanation explain(const NetDescription& net);
/// Explains an object, a world or materials: bodies, materials and friction.
[[nodiscard]] Explanation explain(const BodySpec& body);
[[nodiscard]] Explanation explain(const WorldSpec& world);
[[nodiscard]] Explanation explain(const Materials& materials);
/// Explains a scene: its parts, the pairs of its pads, and their assumed properties.
[[nodiscard]] Explanation explain(const SceneSpec& scene);
/// Explains a robot: links, joints and motors.
[[nodiscard]] Explanation explain(const RobotSpec& robot);

[[nodiscard]] std::string text_of(const ThingExplained& explained);
[[nodiscard]] Fields fields_of(const ThingExplained& explained);

}  // namespace thenar
