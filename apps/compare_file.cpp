#include "apps/compare_file.h"

#include <cmath>
#include <filesystem>
#include <limits>

#include <fmt/format.h>

#include "apps/json_line.h"
#include "apps/read_source.h"
#include "apps/to_json.h"
#include "base/error.h"
#include "base/provenance.h"
#include "viewer/compare_words.h"

namespace thenar {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr const char* kInfinite = "infinite";
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// JSON has no infinity; what is not known is null.
Json number_json(double value) {
  if (std::isinf(value)) return kInfinite;
  return std::isnan(value) ? Json() : Json(value);
}

double number(const nlohmann::json& value) {
  if (value.is_null()) return kUnknown;
  return value == kInfinite ? kInfinity : value.get<double>();
}

Eigen::VectorXd vector(const nlohmann::json& list) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) out[static_cast<Eigen::Index>(i)] = number(list[i]);
  return out;
}

/// Three numbers, as every place and direction has.
Eigen::Vector3d vector3(const nlohmann::json& list) {
  const Eigen::VectorXd read = vector(list);
  if (read.size() != 3) throw InputError(fmt::format("wanted 3 numbers, got {}", list.dump()));
  return read;
}

Json margin_json(const std::map<std::string, double>& margins) {
  Json out = Json::object();
  for (const auto& [task, margin] : margins) out[load_key(grasp_task(task))] = number_json(margin);
  return out;
}

std::map<std::string, double> margins_of(const nlohmann::json& json) {
  std::map<std::string, double> margins;
  for (const GraspTask task :
       {GraspTask::kForceClosure, GraspTask::kHoldWeight, GraspTask::kPull, GraspTask::kTurn}) {
    const auto found = json.find(load_key(task));
    if (found != json.end()) margins[name_of(task)] = number(*found);
  }
  return margins;
}

Json list_json(const Eigen::VectorXd& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number_json(value));
  return list;
}

Json contact_json(const HandContact& contact) {
  return {{"position_m", to_json(contact.contact.p)},
          {"normal", to_json(contact.contact.n)},
          {"friction", contact.contact.friction},
          {"torsion_m", contact.contact.torsion},
          {"surface", contact.surface},
          {"depth_m", contact.depth}};
}

HandContact contact_of(const nlohmann::json& json) {
  HandContact contact;
  contact.contact.p = vector3(json.at("position_m"));
  contact.contact.n = vector3(json.at("normal"));
  contact.contact.friction = json.at("friction");
  contact.contact.torsion = json.at("torsion_m");
  contact.surface = json.at("surface");
  contact.depth = json.at("depth_m");
  return contact;
}

Json best_json(const BestGrasp& best) {
  Json out{{"approach", best.approach},
           {"epsilon", best.epsilon},
           {"type", best.type},
           {"hold_N", number_json(best.hold)},
           {"hand_epsilon_N", number_json(best.hand_epsilon)},
           {"margin", margin_json(best.margin)},
           {"reasons", best.reasons},
           {"rotation", to_json(best.X_WH.R)},
           {"position_m", to_json(best.X_WH.p)},
           {"q", to_json(best.q)}};
  for (const HandContact& contact : best.contacts) out["contacts"].push_back(contact_json(contact));
  return out;
}

BestGrasp best_of(const nlohmann::json& json) {
  BestGrasp best;
  best.approach = json.at("approach");
  best.epsilon = json.at("epsilon");
  best.type = json.at("type");
  best.hold = number(json.at("hold_N"));
  best.hand_epsilon = number(json.at("hand_epsilon_N"));
  best.margin = margins_of(json.at("margin"));
  best.reasons = json.at("reasons").get<std::map<std::string, std::string>>();
  for (int i = 0; i < 3; ++i) best.X_WH.R.row(i) = vector3(json.at("rotation").at(i)).transpose();
  best.X_WH.p = vector3(json.at("position_m"));
  best.q = vector(json.at("q"));
  for (const auto& contact : json.at("contacts")) best.contacts.push_back(contact_of(contact));
  return best;
}

Json cell_json(const HandOnObject& cell) {
  Json outcomes = Json::object();
  for (std::size_t i = 0; i < cell.outcomes.size(); ++i)
    outcomes[name_of(static_cast<GraspOutcome>(i))] = cell.outcomes[i];
  Json out{{"hand", cell.hand},
           {"object", cell.object},
           {"scale", cell.scale},
           {"approaches", cell.approaches},
           {"outcomes", outcomes},
           {"closures", cell.closures},
           {"success", cell.success},
           {"success_lower", cell.interval.lower},
           {"success_upper", cell.interval.upper},
           {"epsilon", to_json(cell.epsilon)},
           {"hand_epsilon_N", list_json(cell.hand_epsilon)},
           {"types", cell.types},
           {"best", Json::array()}};
  for (const BestGrasp& best : cell.best) out["best"].push_back(best_json(best));
  return out;
}

HandOnObject cell_of(const nlohmann::json& json) {
  HandOnObject cell;
  cell.hand = json.at("hand");
  cell.object = json.at("object");
  cell.scale = json.at("scale");
  cell.approaches = json.at("approaches");
  for (std::size_t i = 0; i < cell.outcomes.size(); ++i)
    cell.outcomes[i] = json.at("outcomes").at(name_of(static_cast<GraspOutcome>(i)));
  cell.closures = json.at("closures");
  cell.success = json.at("success");
  cell.interval = {json.at("success_lower"), json.at("success_upper")};
  cell.epsilon = vector(json.at("epsilon"));
  cell.hand_epsilon = vector(json.at("hand_epsilon_N"));
  cell.types = json.at("types").get<std::map<std::string, int>>();
  for (const auto& best : json.at("best")) cell.best.push_back(best_of(best));
  return cell;
}

Json digit_json(const DigitAbility& digit) {
  Json out{{"digit", digit.digit}, {"dimension", digit.dimension}};
  if (digit.dimension > 0) {
    const std::string unit = digit.dimension == 1 ? "m" : fmt::format("m{}", digit.dimension);
    out["workspace_" + unit] = digit.workspace;
    out["workspace_error_" + unit] = digit.workspace_error;
  }
  out["closing_force_N"] = number_json(digit.closing_force);
  out["largest_force_N"] = number_json(digit.largest_force);
  return out;
}

Json abilities_json(const HandAbilities& hand) {
  const bool places = is_kapandji(hand);
  Json out{{"hand", hand.hand},
           {"reach_m", hand.reach},
           {"kapandji_of_10", places ? number_json(hand.opposition) : Json(nullptr)},
           {"tips_met_share", places ? Json(nullptr) : number_json(hand.opposition / 10)},
           {"opposition_scale", hand.opposition_scale},
           {"reached", hand.reached},
           {"overlap_m3", hand.overlap},
           {"types", hand.types},
           {"digits", Json::array()}};
  for (const DigitAbility& digit : hand.digits) out["digits"].push_back(digit_json(digit));
  return out;
}

}  // namespace

std::string load_key(GraspTask task) {
  switch (task) {
    case GraspTask::kHoldWeight:
      return "hold_weights";
    case GraspTask::kPull:
      return "pull_N";
    case GraspTask::kTurn:
      return "turn_Nm";
    case GraspTask::kForceClosure:
      break;
  }
  return "force_closure";
}

Json comparison_json(const Comparison& comparison) {
  Json out{{"complete", comparison.complete},
           {"warnings", comparison.warnings},
           {"abilities", Json::array()},
           {"cells", Json::array()}};
  for (const HandAbilities& hand : comparison.abilities)
    out["abilities"].push_back(abilities_json(hand));
  for (const HandOnObject& cell : comparison.cells) out["cells"].push_back(cell_json(cell));
  return out;
}

std::string comparison_checksum(const nlohmann::json& file) {
  nlohmann::json rest = file;
  rest.erase("sha256");
  return sha256(rest.dump());
}

std::vector<HandOnObject> read_cells(const std::string& path, const Json& inputs) {
  if (!std::filesystem::exists(path)) return {};
  const nlohmann::json file = parse_json(path, read_source(path).text);
  require(file.is_object() && file.contains("inputs") && file.contains("cells"),
          "'{}' is no comparison of hands: name another file", path);
  if (const auto sum = file.find("sha256"); sum == file.end())
    fmt::print(stderr, "{}: warning: it has no checksum, so that damage cannot be noticed\n", path);
  else if (*sum != comparison_checksum(file))
    throw DataError(path, 1, "its checksum (SHA-256) does not hold: it was damaged or changed");
  for (const auto& [name, value] : inputs.items()) {
    const bool same =
        file["inputs"].contains(name) && file["inputs"][name] == nlohmann::json(value);
    require(same, "'{}' holds a comparison with another '{}': name another file, or remove it",
            path, name);
  }
  std::vector<HandOnObject> cells;
  try {
    for (const auto& cell : file["cells"]) cells.push_back(cell_of(cell));
  } catch (const nlohmann::json::exception& error) {
    throw DataError(path, 1, std::string("a cell of the comparison is broken: ") + error.what());
  } catch (const InputError& error) {
    throw DataError(path, 1, std::string("a cell of the comparison is broken: ") + error.what());
  }
  return cells;
}

}  // namespace thenar
