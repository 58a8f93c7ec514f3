#include "apps/compare_file.h"

#include <filesystem>
#include <limits>

#include "apps/json_line.h"
#include "apps/read_source.h"
#include "apps/to_json.h"
#include "base/error.h"

namespace thenar {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A number, or what null stands for.
double number(const nlohmann::json& value, double otherwise = kInfinity) {
  return value.is_null() ? otherwise : value.get<double>();
}

Eigen::VectorXd vector(const nlohmann::json& list) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) out[static_cast<Eigen::Index>(i)] = number(list[i]);
  return out;
}

Json contact_json(const HandContact& contact) {
  return {{"position", to_json(contact.contact.p)},
          {"normal", to_json(contact.contact.n)},
          {"friction", contact.contact.friction},
          {"torsion", contact.contact.torsion},
          {"surface", contact.surface},
          {"depth", contact.depth}};
}

HandContact contact_of(const nlohmann::json& json) {
  HandContact contact;
  contact.contact.p = vector(json.at("position"));
  contact.contact.n = vector(json.at("normal"));
  contact.contact.friction = json.at("friction");
  contact.contact.torsion = json.at("torsion");
  contact.surface = json.at("surface");
  contact.depth = json.at("depth");
  return contact;
}

Json best_json(const BestGrasp& best) {
  Json out{{"approach", best.approach},
           {"epsilon", best.epsilon},
           {"type", best.type},
           {"hold_N", best.hold},
           {"margin", best.margin},
           {"rotation", to_json(best.X_WH.R)},
           {"position", to_json(best.X_WH.p)},
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
  for (const auto& [task, margin] : json.at("margin").items()) best.margin[task] = number(margin);
  for (int i = 0; i < 3; ++i) best.X_WH.R.row(i) = vector(json.at("rotation").at(i)).transpose();
  best.X_WH.p = vector(json.at("position"));
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
           {"types", cell.types},
           {"best", Json::array()},
           {"seconds", cell.seconds}};
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
  cell.types = json.at("types").get<std::map<std::string, int>>();
  for (const auto& best : json.at("best")) cell.best.push_back(best_of(best));
  cell.seconds = json.at("seconds");
  return cell;
}

Json abilities_json(const HandAbilities& hand) {
  Json out{{"hand", hand.hand},
           {"reach_mm", hand.reach * 1e3},
           {"opposition", hand.opposition},
           {"opposition_scale", hand.opposition_scale},
           {"reached", hand.reached},
           {"overlap_cm3", hand.overlap * 1e6},
           {"types", hand.types},
           {"digits", Json::array()}};
  for (const DigitAbility& digit : hand.digits)
    out["digits"].push_back({{"digit", digit.digit},
                             {"dimension", digit.dimension},
                             {"workspace_m", digit.workspace},
                             {"workspace_error_m", digit.workspace_error},
                             {"closing_force_N", digit.closing_force},
                             {"largest_force_N", digit.largest_force}});
  return out;
}

}  // namespace

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

std::vector<HandOnObject> read_cells(const std::string& path, const Json& inputs) {
  if (!std::filesystem::exists(path)) return {};
  const nlohmann::json file = parse_json(path, read_source(path).text);
  require(file.is_object() && file.contains("inputs") && file.contains("cells"),
          "'{}' is no comparison of hands: name another file", path);
  for (const auto& [name, value] : inputs.items()) {
    const bool same = file["inputs"].contains(name) && file["inputs"][name] == nlohmann::json(value);
    require(same, "'{}' holds a comparison with another '{}': name another file, or remove it",
            path, name);
  }
  std::vector<HandOnObject> cells;
  try {
    for (const auto& cell : file["cells"]) cells.push_back(cell_of(cell));
  } catch (const nlohmann::json::exception& error) {
    throw DataError(path, 1, std::string("a cell of the comparison is broken: ") + error.what());
  }
  return cells;
}

}  // namespace thenar
