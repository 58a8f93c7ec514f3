#pragma once

/// An explanation as sections of lines and a table, for people and as fields alike.

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

/// Returns one digit of a subject: what is built, what it costs, what can be asked, what a fit may
/// move.
[[nodiscard]] Explanation explain(const Subject& subject, const DigitExplained& says);
[[nodiscard]] Explanation explain(const Experiment& experiment);
[[nodiscard]] Explanation explain(const Fit& fit, const FitExplained& found);
/// Returns an extensor net: its nodes, bands, muscles and surfaces, and what a hood that is a net
/// assumes.
[[nodiscard]] Explanation explain(const NetDescription& net);
/// Explains an object, a world or materials: bodies, materials and friction.
[[nodiscard]] Explanation explain(const BodySpec& body);
[[nodiscard]] Explanation explain(const WorldSpec& world);
[[nodiscard]] Explanation explain(const Materials& materials);
/// Returns a scene that moves: what is in it, which pads meet what, and what nobody measured of
/// them.
[[nodiscard]] Explanation explain(const SceneSpec& scene);
/// Returns links, joints and the motors that drive them.
[[nodiscard]] Explanation explain(const RobotSpec& robot);

[[nodiscard]] std::string text_of(const ThingExplained& explained);
[[nodiscard]] Fields fields_of(const ThingExplained& explained);

}  // namespace thenar
