#include "apps/tendon_table.h"

#include <functional>

#include <fmt/format.h>

#include "apps/tendon_answer.h"
#include "base/units.h"
#include "report/json.h"

namespace thenar {
namespace {

/// A column: its name with the unit, and its value at a point.
struct Field {
  std::string name;
  std::function<double(const DigitPoint&)> value;
};

std::vector<Field> posture_fields(const TendonNames& names) {
  std::vector<Field> fields;
  for (std::size_t i = 0; i < names.coordinates.size(); ++i)
    fields.push_back({names.coordinates[i] + "_deg", [i](const DigitPoint& point) {
                        return point.q[static_cast<Eigen::Index>(i)] / kDegree;
                      }});
  return fields;
}

void add_slips(std::vector<Field>& fields) {
  fields.push_back({"central_N", [](const DigitPoint& p) { return p.pull.slips.central; }});
  fields.push_back({"radial_N", [](const DigitPoint& p) { return p.pull.slips.radial; }});
  fields.push_back({"ulnar_N", [](const DigitPoint& p) { return p.pull.slips.ulnar; }});
  fields.push_back({"terminal_N", [](const DigitPoint& p) { return p.pull.slips.terminal; }});
}

void add_net(const Net& net, std::vector<Field>& fields) {
  fields.push_back({"residual_N", [](const DigitPoint& p) { return p.rest.residual; }});
  for (std::size_t k = 0; k < net.bands.size(); ++k)
    fields.push_back({"tension_" + net.bands[k].name + "_N", [k](const DigitPoint& p) {
                        return p.rest.tension[static_cast<Eigen::Index>(k)];
                      }});
}

void add_arms(const TendonNames& names, std::vector<Field>& fields) {
  for (std::size_t j = 0; j < names.coordinates.size(); ++j)
    fields.push_back({"torque_" + names.coordinates[j] + "_N_mm", [j](const DigitPoint& p) {
                        return 1e3 * p.pull.tau[static_cast<Eigen::Index>(j)];
                      }});
  for (std::size_t m = 0; m < names.muscles.size(); ++m)
    for (std::size_t j = 0; j < names.coordinates.size(); ++j)
      fields.push_back({fmt::format("arm_{}_{}_mm", names.muscles[m], names.coordinates[j]),
                        [m, j](const DigitPoint& p) {
                          return 1e3 * p.pull.R(static_cast<Eigen::Index>(m),
                                                static_cast<Eigen::Index>(j));
                        }});
}

void add_force(const TendonCase& at, std::vector<Field>& fields) {
  const char* const names[] = {"proximal", "dorsal", "radial"};
  for (int k = 0; k < 3; ++k)
    fields.push_back({fmt::format("force_{}_N", names[k]),
                      [&at, k](const DigitPoint& p) { return force_in_tip_axes(at, p)[k]; }});
  fields.push_back({"condition", [](const DigitPoint& p) { return p.tip.condition; }});
}

std::vector<Field> number_fields(const TendonCase& at) {
  const TendonNames& names = at.bones().names;
  std::vector<Field> fields;
  if (at.net != nullptr || at.bones().model.hood) add_slips(fields);
  if (at.net != nullptr) add_net(at.net->net().net, fields);
  add_force(at, fields);
  add_arms(names, fields);
  return fields;
}

/// A cell of a CSV table, in quotes if it holds any text.
std::string quoted(const std::string& text) {
  if (text.empty()) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
  return cell + "\"";
}

/// How the search of a net ended; where it ended well, or there is none, how far to believe the
/// rest.
std::string status_of(const TendonCase& at, const DigitPoint& point) {
  const bool net = at.net != nullptr && (point.rest.status != NetStatus::kBalanced ||
                                         point.pull.status == TendonStatus::kValid);
  return net ? name_of(point.rest.status) : name_of(point.pull.status);
}

}  // namespace

std::string csv_of(const TendonCase& at, const std::vector<DigitPoint>& points) {
  const std::vector<Field> angles = posture_fields(at.bones().names), numbers = number_fields(at);
  std::string text;
  for (const Field& field : angles) text += field.name + ",";
  text += at.net == nullptr ? "status,trouble" : "status,snapped,trouble";
  for (const Field& field : numbers) text += "," + field.name;
  text += "\n";
  for (const DigitPoint& point : points) {
    for (const Field& field : angles) text += fmt::format("{:.10g},", field.value(point));
    text += status_of(at, point) + ",";
    if (at.net != nullptr) text += point.snapped ? "1," : "0,";
    text += quoted(warning_of(point));
    for (const Field& field : numbers) text += fmt::format(",{:.10g}", field.value(point));
    text += "\n";
  }
  return text;
}

nlohmann::ordered_json json_of(const TendonCase& at, const std::vector<DigitPoint>& points) {
  nlohmann::ordered_json json = json_header(at);
  std::vector<Field> fields = posture_fields(at.bones().names);
  for (Field& field : number_fields(at)) fields.push_back(std::move(field));
  for (const DigitPoint& point : points) {
    json["status"].push_back(status_of(at, point));
    if (at.net != nullptr) json["snapped"].push_back(point.snapped);
    json["trouble"].push_back(warning_of(point));
    for (const Field& field : fields) json[field.name].push_back(field.value(point));
  }
  return json;
}

}  // namespace thenar
