#include "apps/compare_file.h"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "api/files.h"
#include "api/hands.h"
#include "base/error.h"
#include "base/numbers.h"
#include "base/provenance.h"
#include "data/io/json_text.h"
#include "report/answers/comparison.h"
#include "report/json.h"

namespace thenar {
namespace {

constexpr const char* kInfinite = "infinite";

/// JSON has no infinity; what is not known is null.
OrderedJson number_json(double value) {
  if (std::isinf(value)) return kInfinite;
  return std::isnan(value) ? OrderedJson() : OrderedJson(value);
}

// ---- what a cell may hold: whoever seals a file anew may write anything

constexpr double kLargestScale = 1000;      // of an object, and the inverse of the smallest [1]
constexpr double kFarthest = 1000;          // of a place [m]
constexpr double kStrongest = 1e12;         // of loads and qualities [N], [1], [N m]
constexpr double kUnit = 1e-6;              // by which directions may be off [1]
constexpr int kMaxApproaches = 10'000'000;  // of approaches

[[noreturn]] void refuse(const std::string& name, const std::string& wanted,
                         const nlohmann::json& got) {
  constexpr std::size_t kQuoted = 100;
  throw InputError(
      fmt::format("'{}': wanted {}, got {}", name, wanted, json_text(got, -1).substr(0, kQuoted)));
}

/// A finite number between two.
double within(const nlohmann::json& value, const std::string& name, double low, double high) {
  if (value.is_number() && value.get<double>() >= low && value.get<double>() <= high)
    return value.get<double>();
  refuse(name, fmt::format("a number from {} to {}", low, high), value);
}

/// A whole number between two.
int whole(const nlohmann::json& value, const std::string& name, int low, int high) {
  if (value.is_number_integer() && value.get<double>() >= low && value.get<double>() <= high)
    return value.get<int>();
  refuse(name, fmt::format("a whole number from {} to {}", low, high), value);
}

/// A load or a quality: >= 0, may be infinite, or not known.
double load_of(const nlohmann::json& value, const std::string& name) {
  if (value.is_null()) return kNaN;
  return value == kInfinite ? kInfinity : within(value, name, 0, kStrongest);
}

/// Loads of at most `most` grasps, ascending.
Eigen::VectorXd loads_of(const nlohmann::json& list, const std::string& name, int most) {
  if (!list.is_array() || list.size() > static_cast<std::size_t>(most))
    refuse(name, fmt::format("at most {} numbers", most), list);
  Eigen::VectorXd out(static_cast<Eigen::Index>(list.size()));
  for (Eigen::Index i = 0; i < out.size(); ++i) {
    out[i] = load_of(list[static_cast<std::size_t>(i)], name);
    if (!(out[i] >= (i > 0 ? out[i - 1] : 0))) refuse(name, "numbers that do not fall", list);
  }
  return out;
}

/// Finite numbers, none beyond `most`.
Eigen::VectorXd vector(const nlohmann::json& list, const std::string& name, double most) {
  if (!list.is_array()) refuse(name, "a list of numbers", list);
  Eigen::VectorXd out(static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i)
    out[static_cast<Eigen::Index>(i)] = within(list[i], name, -most, most);
  return out;
}

/// Three numbers, as every place and direction has.
Eigen::Vector3d vector3(const nlohmann::json& list, const std::string& name, double most) {
  const Eigen::VectorXd read = vector(list, name, most);
  if (read.size() != 3) refuse(name, "3 numbers", list);
  return read;
}

Eigen::Matrix3d rotation_of(const nlohmann::json& rows) {
  Eigen::Matrix3d R;
  for (int i = 0; i < 3; ++i) R.row(i) = vector3(rows.at(i), "rotation", 1 + kUnit).transpose();
  if (!(R * R.transpose()).isIdentity(kUnit) || R.determinant() < 0)
    refuse("rotation", "the rows of a rotation", rows);
  return R;
}

OrderedJson margin_json(const std::map<std::string, double>& margins) {
  OrderedJson out = OrderedJson::object();
  for (const auto& [task, margin] : margins) out[load_key(grasp_task(task))] = number_json(margin);
  return out;
}

std::map<std::string, double> margins_of(const nlohmann::json& json) {
  std::map<std::string, double> margins;
  for (const GraspTask task :
       {GraspTask::kForceClosure, GraspTask::kHoldWeight, GraspTask::kPull, GraspTask::kTurn}) {
    const auto found = json.find(load_key(task));
    if (found != json.end()) margins[name_of(task)] = load_of(*found, load_key(task));
  }
  return margins;
}

OrderedJson list_json(const Eigen::VectorXd& values) {
  OrderedJson list = OrderedJson::array();
  for (const double value : values) list.push_back(number_json(value));
  return list;
}

OrderedJson contact_json(const HandContact& contact) {
  return {{"position_m", to_json(contact.contact.p)},
          {"normal", to_json(contact.contact.n)},
          {"friction", contact.contact.friction},
          {"torsion_m", contact.contact.torsion},
          {"surface", contact.surface},
          {"depth_m", contact.depth}};
}

HandContact contact_of(const nlohmann::json& json) {
  HandContact contact;
  constexpr double kRoughest = 100;  // nothing real has more friction [1]
  contact.contact.p = vector3(json.at("position_m"), "position_m", kFarthest);
  contact.contact.n = vector3(json.at("normal"), "normal", 1 + kUnit);
  if (std::abs(contact.contact.n.norm() - 1) > kUnit)
    refuse("normal", "a direction of length 1", json.at("normal"));
  contact.contact.friction = within(json.at("friction"), "friction", 0, kRoughest);
  contact.contact.torsion = within(json.at("torsion_m"), "torsion_m", 0, kFarthest);
  contact.surface = whole(json.at("surface"), "surface", -1, kMaxApproaches);
  contact.depth = within(json.at("depth_m"), "depth_m", -kFarthest, kFarthest);
  return contact;
}

OrderedJson best_json(const BestGrasp& best) {
  OrderedJson out{{"approach", best.approach},
                  {"epsilon", best.epsilon},
                  {"type", best.type},
                  {"hold_N", number_json(best.min_grasp_force)},
                  {"hand_epsilon_N", number_json(best.hand_epsilon)},
                  {"margin", margin_json(best.margin)},
                  {"reasons", best.reasons},
                  {"rotation", to_json(best.X_WH.R)},
                  {"position_m", to_json(best.X_WH.p)},
                  {"q", to_json(best.q)}};
  for (const HandContact& contact : best.contacts) out["contacts"].push_back(contact_json(contact));
  return out;
}

BestGrasp best_of(const nlohmann::json& json, int approaches) {
  constexpr double kLongest = 1000;  // of a posture's entries [rad] or [m]
  BestGrasp best;
  best.approach = whole(json.at("approach"), "approach", 0, approaches - 1);
  best.epsilon = within(json.at("epsilon"), "epsilon", 0, kStrongest);
  best.type = json.at("type");
  best.min_grasp_force = load_of(json.at("hold_N"), "hold_N");
  best.hand_epsilon = load_of(json.at("hand_epsilon_N"), "hand_epsilon_N");
  best.margin = margins_of(json.at("margin"));
  best.reasons = json.at("reasons").get<std::map<std::string, std::string>>();
  best.X_WH.R = rotation_of(json.at("rotation"));
  best.X_WH.p = vector3(json.at("position_m"), "position_m", kFarthest);
  best.q = vector(json.at("q"), "q", kLongest);
  for (const auto& contact : json.at("contacts")) best.contacts.push_back(contact_of(contact));
  return best;
}

OrderedJson cell_json(const HandOnObject& cell) {
  OrderedJson outcomes = OrderedJson::object();
  for (std::size_t i = 0; i < cell.outcomes.size(); ++i)
    outcomes[name_of(static_cast<GraspOutcome>(i))] = cell.outcomes[i];
  OrderedJson out{{"hand", cell.hand},
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
                  {"best", OrderedJson::array()}};
  for (const BestGrasp& best : cell.best) out["best"].push_back(best_json(best));
  return out;
}

/// Counts of a cell, which must add up.
void read_counts(const nlohmann::json& json, HandOnObject& cell) {
  cell.approaches = whole(json.at("approaches"), "approaches", 1, kMaxApproaches);
  int ended = 0;
  for (std::size_t i = 0; i < cell.outcomes.size(); ++i) {
    const std::string name = name_of(static_cast<GraspOutcome>(i));
    cell.outcomes[i] = whole(json.at("outcomes").at(name), name, 0, cell.approaches - ended);
    ended += cell.outcomes[i];
  }
  cell.closures = whole(json.at("closures"), "closures", 0, cell.approaches);
  int typed = 0;
  for (const auto& [name, count] : json.at("types").items()) {
    cell.types[name] = whole(count, "types", 1, cell.closures - typed);
    typed += cell.types[name];
  }
  const double share = static_cast<double>(cell.closures) / cell.approaches;
  cell.success = within(json.at("success"), "success", share - kUnit, share + kUnit);
  cell.interval.lower = within(json.at("success_lower"), "success_lower", 0, 1);
  cell.interval.upper = within(json.at("success_upper"), "success_upper", cell.interval.lower, 1);
}

HandOnObject cell_of(const nlohmann::json& json) {
  HandOnObject cell;
  cell.hand = json.at("hand");
  cell.object = json.at("object");
  cell.scale = within(json.at("scale"), "scale", 1 / kLargestScale, kLargestScale);
  read_counts(json, cell);
  cell.epsilon = loads_of(json.at("epsilon"), "epsilon", cell.closures);
  if (cell.epsilon.size() != cell.closures)
    refuse("epsilon", fmt::format("{} numbers", cell.closures), json.at("epsilon"));
  cell.hand_epsilon = loads_of(json.at("hand_epsilon_N"), "hand_epsilon_N", cell.closures);
  const nlohmann::json& best = json.at("best");
  if (!best.is_array() || best.size() > static_cast<std::size_t>(cell.closures))
    refuse("best", fmt::format("at most {} grasps", cell.closures), best);
  for (const auto& grasp : best) cell.best.push_back(best_of(grasp, cell.approaches));
  return cell;
}

OrderedJson digit_json(const DigitAbility& digit) {
  OrderedJson out{{"digit", digit.digit}, {"dimension", digit.dimension}};
  if (digit.dimension > 0) {
    const std::string unit = digit.dimension == 1 ? "m" : fmt::format("m{}", digit.dimension);
    out["workspace_" + unit] = digit.workspace;
    out["workspace_error_" + unit] = digit.workspace_error;
  }
  out["closing_force_N"] = number_json(digit.closing_force);
  out["largest_force_N"] = number_json(digit.max_tip_force);
  return out;
}

OrderedJson abilities_json(const HandAbilities& hand) {
  const bool places = is_kapandji(hand);
  OrderedJson out{
      {"hand", hand.hand},
      {"reach_m", hand.reach},
      {"kapandji_of_10", places ? number_json(hand.opposition) : OrderedJson(nullptr)},
      {"tips_met_share", places ? OrderedJson(nullptr) : number_json(hand.opposition / 10)},
      {"opposition_scale", hand.opposition_scale},
      {"reached", hand.reached},
      {"overlap_m3", hand.overlap},
      {"types", hand.types},
      {"digits", OrderedJson::array()}};
  for (const DigitAbility& digit : hand.digits) out["digits"].push_back(digit_json(digit));
  return out;
}

/// Hands by their names of today: files of older versions call the human's tier1 .. tier4.
void rename_hands(nlohmann::json& file) {
  const auto rename = [](nlohmann::json& name) {
    if (name.is_string()) name = current_hand_name(name);
  };
  nlohmann::json& inputs = file["inputs"];
  if (!inputs.is_object()) return;
  if (inputs.contains("hands"))
    for (nlohmann::json& hand : inputs["hands"]) rename(hand);
  if (inputs.contains("contents")) {
    nlohmann::json contents = nlohmann::json::object();
    for (const auto& [name, hash] : inputs["contents"].items())
      contents[name.rfind("hand ", 0) == 0 ? current_hand_name(name) : name] = hash;
    inputs["contents"] = contents;
  }
  for (nlohmann::json& cell : file["cells"])
    if (cell.is_object() && cell.contains("hand")) rename(cell["hand"]);
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

OrderedJson comparison_json(const Comparison& comparison) {
  OrderedJson out{{"complete", comparison.complete},
                  {"warnings", comparison.warnings},
                  {"abilities", OrderedJson::array()},
                  {"cells", OrderedJson::array()}};
  for (const HandAbilities& hand : comparison.abilities)
    out["abilities"].push_back(abilities_json(hand));
  for (const HandOnObject& cell : comparison.cells) out["cells"].push_back(cell_json(cell));
  return out;
}

std::string comparison_checksum(const nlohmann::json& file) {
  nlohmann::json rest = file;
  rest.erase("sha256");
  return sha256(json_text(rest, -1));
}

std::vector<HandOnObject> parse_cells(const nlohmann::json& list, const std::string& path) {
  std::vector<HandOnObject> cells;
  try {
    for (const auto& cell : list) cells.push_back(cell_of(cell));
  } catch (const nlohmann::json::exception& error) {
    throw DataError(path, 1, std::string("a cell of the comparison is broken: ") + error.what());
  } catch (const InputError& error) {
    throw DataError(path, 1, std::string("a cell of the comparison is broken: ") + error.what());
  }
  return cells;
}

std::vector<HandOnObject> read_cells(const std::string& path, const OrderedJson& inputs) {
  std::error_code none;
  if (!std::filesystem::exists(path, none)) return {};
  nlohmann::json file = parse_json(path, read_source(path).text);
  require(file.is_object() && file.contains("inputs") && file.contains("cells"),
          "'{}' is no comparison of hands: name another file", path);
  if (const auto sum = file.find("sha256"); sum == file.end())
    throw DataError(path, 1,
                    "its checksum (SHA-256) is missing: it was damaged, or written by an older "
                    "version; remove it, or name another file");
  else if (*sum != comparison_checksum(file))
    throw DataError(path, 1, "its checksum (SHA-256) does not hold: it was damaged or changed");
  rename_hands(file);
  for (const auto& [name, value] : inputs.items()) {
    const bool same =
        file["inputs"].contains(name) && file["inputs"][name] == nlohmann::json(value);
    require(same, "'{}' holds a comparison with another '{}': name another file, or remove it",
            path, name);
  }
  return parse_cells(file["cells"], path);
}

}  // namespace thenar
