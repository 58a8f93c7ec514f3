#pragma once

/// An explanation as sections of lines and a table, for people and as JSON alike.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "data/io/experiment.h"
#include "data/io/net_description.h"
#include "data/io/robot/robot.h"
#include "data/io/subject.h"
#include "data/io/world/world.h"
#include "kinematics_fit/fit.h"
#include "report/table.h"
#include "tendons/tendon_model.h"

namespace thenar {

struct Section {
  std::string key;                 // in JSON: "cost"
  std::string title;               // for people
  std::vector<std::string> lines;  // sentences above the table
  Table table;                     // may be empty
};

using Explanation = std::vector<Section>;

/// One digit of a subject: what is built, what it costs, what can be asked, what a fit may move.
/// @param path  rung of tendon paths
[[nodiscard]] Explanation explain(const Subject& subject, const std::string& digit,
                                  const SourceText& settings, Path path = Path::kViaPoint);
[[nodiscard]] Explanation explain(const Experiment& experiment);
[[nodiscard]] Explanation explain(const Fit& fit);
/// An extensor net: its nodes, bands, muscles and surfaces, and what a hood that is a net assumes.
[[nodiscard]] Explanation explain(const NetDescription& net);
/// What is in a scene, of what it is made, and how it slides.
[[nodiscard]] Explanation explain(const BodySpec& body);
[[nodiscard]] Explanation explain(const WorldSpec& world);
[[nodiscard]] Explanation explain(const Materials& materials);
/// Links, joints and the motors that drive them.
[[nodiscard]] Explanation explain(const RobotSpec& robot);

/// What a call of each question costs on this machine, now. Times are of the mid-range posture.
[[nodiscard]] Section explain_cost(const Subject& subject, const std::string& digit,
                                   const TendonDigit& built);

/// Every parameter of a fit with its prior under these settings.
[[nodiscard]] Section explain_parameters(const TendonDigit& built, const SourceText& settings);

[[nodiscard]] std::string text_of(const Explanation& explanation);
[[nodiscard]] nlohmann::ordered_json json_of(const Explanation& explanation);

}  // namespace thenar
