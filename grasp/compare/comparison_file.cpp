#include "grasp/compare/comparison_file.h"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "base/numbers.h"
#include "data/io/file_guard.h"

namespace thenar {
namespace {

constexpr const char* kInfinite = "infinite";
constexpr const char* kEarlierRuns = "earlier_runs";
const std::string kFileMark = "sha256 ";  // before the hash of a file, as in all provenance

/// JSON has no infinity; what is not known is null.
JsonNode number_node(double value) {
  if (std::isinf(value)) return JsonNode(kInfinite);
  return std::isnan(value) ? JsonNode() : JsonNode(value);
}

// ---- Ranges of a cell's values, which are checked as files may be edited and sealed again

// Maximum scale of an object, and inverse of the minimum [1]
constexpr double kMaxScale = 1000;
constexpr double kMaxDistance = 1000;       // maximum coordinate of a point [m]
constexpr double kMaxLoad = 1e12;           // maximum load or quality [N], [1], [N m]
constexpr double kUnitTolerance = 1e-6;     // error of unit directions and shares [1]
constexpr int kMaxApproaches = 10'000'000;  // maximum number of approaches

/// Error of a cell, with its line.
struct BrokenCell {
  int line;
  std::string complaint;
};

[[noreturn]] void refuse(const std::string& name, const std::string& wanted, const JsonNode& got) {
  constexpr std::size_t kQuotedCharacters = 100;  // maximum length of a value in a message
  throw BrokenCell{got.line, fmt::format("'{}': wanted {}, got {}", name, wanted,
                                         canonical_text(got).substr(0, kQuotedCharacters))};
}

const JsonNode& member(const JsonNode& node, const std::string& name) {
  const JsonNode* found = node.find(name);
  if (found == nullptr) throw BrokenCell{node.line, fmt::format("there is no '{}'", name)};
  return *found;
}

/// Reads a finite number within a range.
double number_within(const JsonNode& value, const std::string& name, double low, double high) {
  if (value.kind == JsonKind::kNumber && value.number >= low && value.number <= high)
    return value.number;
  refuse(name, fmt::format("a number from {} to {}", low, high), value);
}

/// Reads a whole number within a range.
int whole_within(const JsonNode& value, const std::string& name, int low, int high) {
  if (value.kind == JsonKind::kNumber && value.whole && value.number >= low && value.number <= high)
    return static_cast<int>(value.number);
  refuse(name, fmt::format("a whole number from {} to {}", low, high), value);
}

const std::string& text(const JsonNode& value, const std::string& name) {
  if (value.kind != JsonKind::kText) refuse(name, "a text", value);
  return value.text;
}

/// Reads a member that is a finite number within a range.
double number_in(const JsonNode& node, const std::string& name, double low, double high) {
  return number_within(member(node, name), name, low, high);
}

/// Reads a member that is a whole number within a range.
int whole_in(const JsonNode& node, const std::string& name, int low, int high) {
  return whole_within(member(node, name), name, low, high);
}

/// Reads a load or a quality: >= 0, infinite, or unknown.
double load_of(const JsonNode& value, const std::string& name) {
  if (value.kind == JsonKind::kNull) return kNaN;
  if (value.kind == JsonKind::kText && value.text == kInfinite) return kInfinity;
  return number_within(value, name, 0, kMaxLoad);
}

/// Reads ascending loads of at most `max_count` grasps.
Eigen::VectorXd loads_of(const JsonNode& list, const std::string& name, int max_count) {
  if (list.kind != JsonKind::kArray || list.items.size() > static_cast<std::size_t>(max_count))
    refuse(name, fmt::format("at most {} numbers", max_count), list);
  Eigen::VectorXd out(static_cast<Eigen::Index>(list.items.size()));
  for (Eigen::Index i = 0; i < out.size(); ++i) {
    out[i] = load_of(list.items[i], name);
    if (!(out[i] >= (i > 0 ? out[i - 1] : 0))) refuse(name, "numbers that do not fall", list);
  }
  return out;
}

/// Reads finite numbers of magnitude up to `max`.
Eigen::VectorXd vector(const JsonNode& list, const std::string& name, double max) {
  if (list.kind != JsonKind::kArray) refuse(name, "a list of numbers", list);
  Eigen::VectorXd out(static_cast<Eigen::Index>(list.items.size()));
  for (std::size_t i = 0; i < list.items.size(); ++i)
    out[i] = number_within(list.items[i], name, -max, max);
  return out;
}

/// Reads three numbers, such as a position or direction.
Eigen::Vector3d vector3(const JsonNode& list, const std::string& name, double max) {
  const Eigen::VectorXd read = vector(list, name, max);
  if (read.size() != 3) refuse(name, "3 numbers", list);
  return read;
}

Eigen::Matrix3d rotation_of(const JsonNode& rows) {
  Eigen::Matrix3d R;
  if (rows.items.size() != 3) refuse("rotation", "3 rows", rows);
  for (int i = 0; i < 3; ++i)
    R.row(i) = vector3(rows.items[i], "rotation", 1 + kUnitTolerance).transpose();
  if (!(R * R.transpose()).isIdentity(kUnitTolerance) || R.determinant() < 0)
    refuse("rotation", "the rows of a rotation", rows);
  return R;
}

JsonNode margin_node(const std::map<std::string, double>& margins) {
  JsonNode out(JsonKind::kObject);
  for (const auto& [task, margin] : margins)
    out.set(load_key(grasp_task(task)), number_node(margin));
  return out;
}

std::map<std::string, double> margins_of(const JsonNode& json) {
  std::map<std::string, double> margins;
  for (const auto& [task, name] : kGraspTaskNames)
    if (const JsonNode* found = json.find(load_key(task)))
      margins[name] = load_of(*found, load_key(task));
  return margins;
}

/// Converts each entry of a list.
template <typename List, typename Convert>
JsonNode list_node(const List& list, const Convert& convert) {
  JsonNode out(JsonKind::kArray);
  out.items = transformed(list, convert);
  return out;
}

/// Converts numbers that may be infinite or unknown.
JsonNode numbers_node(const Eigen::VectorXd& values) { return list_node(values, number_node); }

JsonNode rows_node(const Eigen::Matrix3d& R) {
  return list_node(R.rowwise(), [](const auto& row) { return numbers_node(row); });
}

template <typename Value>
JsonNode map_node(const std::map<std::string, Value>& values) {
  JsonNode out(JsonKind::kObject);
  for (const auto& [name, value] : values) out.set(name, value);
  return out;
}

JsonNode contact_node(const HandContact& contact) {
  JsonNode out;
  out.set("position_m", numbers_node(contact.contact.p))
      .set("normal", numbers_node(contact.contact.n))
      .set("friction", contact.contact.friction)
      .set("torsion_m", contact.contact.torsion)
      .set("surface", contact.surface)
      .set("depth_m", contact.depth);
  return out;
}

HandContact contact_of(const JsonNode& json) {
  HandContact contact;
  constexpr double kMaxFriction = 100;  // coefficient above that of any real pair [1]
  contact.contact.p = vector3(member(json, "position_m"), "position_m", kMaxDistance);
  contact.contact.n = vector3(member(json, "normal"), "normal", 1 + kUnitTolerance);
  if (std::abs(contact.contact.n.norm() - 1) > kUnitTolerance)
    refuse("normal", "a direction of length 1", member(json, "normal"));
  contact.contact.friction = number_in(json, "friction", 0, kMaxFriction);
  contact.contact.torsion = number_in(json, "torsion_m", 0, kMaxDistance);
  contact.surface = whole_in(json, "surface", -1, kMaxApproaches);
  contact.depth = number_in(json, "depth_m", -kMaxDistance, kMaxDistance);
  return contact;
}

JsonNode best_node(const BestGrasp& best) {
  JsonNode out;
  out.set("approach", best.approach)
      .set("epsilon", best.epsilon)
      .set("type", best.type)
      .set("hold_N", number_node(best.min_grasp_force))
      .set("hold_standing_N", number_node(best.standing_grasp_force))
      .set("hand_epsilon_N", number_node(best.hand_epsilon))
      .set("margin", margin_node(best.margin))
      .set("margin_with_structure", margin_node(best.with_structure))
      .set("reasons", map_node(best.reasons))
      .set("rotation", rows_node(best.X_WH.R))
      .set("position_m", numbers_node(best.X_WH.p))
      .set("q", numbers_node(best.q))
      .set("contacts", list_node(best.contacts, contact_node));
  return out;
}

BestGrasp best_of(const JsonNode& json, int approaches) {
  constexpr double kMaxPosture = 1000;  // maximum entry of a posture [rad] or [m]
  BestGrasp best;
  // Read each number within its range.
  best.approach = whole_in(json, "approach", 0, approaches - 1);
  best.epsilon = number_in(json, "epsilon", 0, kMaxLoad);
  best.type = text(member(json, "type"), "type");
  best.min_grasp_force = load_of(member(json, "hold_N"), "hold_N");
  const JsonNode* standing = json.find("hold_standing_N");  // older files lack it
  best.standing_grasp_force = standing == nullptr ? kNaN : load_of(*standing, "hold_standing_N");
  best.hand_epsilon = load_of(member(json, "hand_epsilon_N"), "hand_epsilon_N");
  best.margin = margins_of(member(json, "margin"));
  if (const JsonNode* with = json.find("margin_with_structure")) {
    best.with_structure = margins_of(*with);
  } else {  // older files: loads of efforts alone are unknown
    best.with_structure.swap(best.margin);
    for (const auto& [task, load] : best.with_structure) best.margin[task] = kNaN;
  }
  const JsonNode& reasons = member(json, "reasons");
  for (std::size_t i = 0; i < reasons.names.size(); ++i)
    best.reasons[reasons.names[i]] = text(reasons.items[i], "reasons");
  best.X_WH.R = rotation_of(member(json, "rotation"));
  best.X_WH.p = vector3(member(json, "position_m"), "position_m", kMaxDistance);
  best.q = vector(member(json, "q"), "q", kMaxPosture);
  best.contacts = transformed(member(json, "contacts").items, contact_of);
  return best;
}

JsonNode cell_node(const HandOnObject& cell) {
  JsonNode outcomes(JsonKind::kObject);
  for (const auto& [outcome, name] : kGraspOutcomeNames)
    outcomes.set(name, cell.outcomes[static_cast<std::size_t>(outcome)]);
  JsonNode out;
  out.set("hand", cell.hand)
      .set("object", cell.object)
      .set("scale", cell.scale)
      .set("approaches", cell.approaches)
      .set("outcomes", outcomes)
      .set("closures", cell.closures)
      .set("held_between_two", cell.between_two)
      .set("success", cell.success)
      .set("success_lower", cell.interval.lower)
      .set("success_upper", cell.interval.upper)
      .set("epsilon", numbers_node(cell.epsilon))
      .set("hand_epsilon_N", numbers_node(cell.hand_epsilon))
      .set("types", map_node(cell.types))
      .set("best", list_node(cell.best, best_node));
  return out;
}

/// Reads the counts of a cell, which must be consistent.
void read_counts(const JsonNode& json, HandOnObject& cell) {
  // Outcomes must add up to no more than the approaches, types to no more than the closures.
  cell.approaches = whole_in(json, "approaches", 1, kMaxApproaches);
  int ended = 0;
  for (const auto& [outcome, name] : kGraspOutcomeNames) {
    int& count = cell.outcomes[static_cast<std::size_t>(outcome)];
    count = whole_in(member(json, "outcomes"), name, 0, cell.approaches - ended);
    ended += count;
  }
  cell.closures = whole_in(json, "closures", 0, cell.approaches);
  // Older files lack this count.
  const int others =
      std::max(0, cell.outcomes[static_cast<std::size_t>(GraspOutcome::kGrasped)] - cell.closures);
  if (const JsonNode* two = json.find("held_between_two"))
    cell.between_two = whole_within(*two, "held_between_two", 0, others);
  int typed = 0;
  const JsonNode& types = member(json, "types");
  for (std::size_t i = 0; i < types.names.size(); ++i) {
    const int count = whole_within(types.items[i], "types", 1, cell.closures - typed);
    cell.types[types.names[i]] = count;
    typed += count;
  }
  const double share = static_cast<double>(cell.closures) / cell.approaches;
  cell.success = number_in(json, "success", share - kUnitTolerance, share + kUnitTolerance);
  cell.interval.lower = number_in(json, "success_lower", 0, 1);
  cell.interval.upper = number_in(json, "success_upper", cell.interval.lower, 1);
}

HandOnObject cell_of(const JsonNode& json) {
  HandOnObject cell;
  cell.hand = text(member(json, "hand"), "hand");
  cell.object = text(member(json, "object"), "object");
  cell.scale = number_in(json, "scale", 1 / kMaxScale, kMaxScale);
  read_counts(json, cell);
  cell.epsilon = loads_of(member(json, "epsilon"), "epsilon", cell.closures);
  if (cell.epsilon.size() != cell.closures)
    refuse("epsilon", fmt::format("{} numbers", cell.closures), member(json, "epsilon"));
  cell.hand_epsilon = loads_of(member(json, "hand_epsilon_N"), "hand_epsilon_N", cell.closures);
  const JsonNode& best = member(json, "best");
  if (best.kind != JsonKind::kArray || best.items.size() > static_cast<std::size_t>(cell.closures))
    refuse("best", fmt::format("at most {} grasps", cell.closures), best);
  for (const JsonNode& grasp : best.items) cell.best.push_back(best_of(grasp, cell.approaches));
  return cell;
}

JsonNode digit_node(const DigitAbility& digit) {
  JsonNode out;
  out.set("digit", digit.digit).set("dimension", digit.dimension);
  if (digit.dimension > 0) {
    const std::string unit = digit.dimension == 1 ? "m" : fmt::format("m{}", digit.dimension);
    out.set("workspace_" + unit, digit.workspace);
    out.set("workspace_error_" + unit, digit.workspace_error);
  }
  out.set("closing_force_N", number_node(digit.closing_force));
  out.set("largest_force_N", number_node(digit.max_tip_force));
  return out;
}

JsonNode abilities_node(const HandAbilities& hand) {
  const bool places = is_kapandji(hand);
  JsonNode out;
  out.set("hand", hand.hand)
      .set("reach_m", hand.reach)
      .set("kapandji_of_10", places ? number_node(hand.opposition) : JsonNode())
      .set("tips_met_share", places ? JsonNode() : number_node(hand.opposition / 10))
      .set("opposition_scale", hand.opposition_scale)
      .set("reached", hand.reached)
      .set("overlap_m3", number_node(hand.overlap))
      .set("types", hand.types)
      .set("digits", list_node(hand.digits, digit_node));
  return out;
}

using HandName = std::function<std::string(const std::string&)>;

/// Gives hands their present names; broken nodes are left unchanged.
void rename_hands(JsonNode& file, const HandName& name) {
  const auto rename = [&](JsonNode& hand) {
    if (hand.kind == JsonKind::kText) hand.text = name(hand.text);
  };
  if (JsonNode* inputs = file.find("inputs")) {
    if (JsonNode* hands = inputs->find("hands"))
      for (JsonNode& hand : hands->items) rename(hand);
    if (JsonNode* contents = inputs->find("contents"))
      for (std::string& what : contents->names)
        if (what.rfind("hand ", 0) == 0) what = name(what);
  }
  if (JsonNode* cells = file.find("cells"))
    for (JsonNode& cell : cells->items)
      if (JsonNode* hand = cell.find("hand")) rename(*hand);
}

/// Lists files that a provenance records with another hash: "'cone.stl' (SHA-256 0123abcd then,
/// 4567ef01 now)".
std::vector<std::string> changed_files(const JsonNode* provenance, const FileDigests& files) {
  constexpr std::size_t kShownDigits = 8;  // number of digits of a hash in messages
  std::vector<std::string> changed;
  for (const auto& [path, digest] : files) {
    const JsonNode* then = provenance == nullptr ? nullptr : provenance->find(path);
    if (then == nullptr || then->text.rfind(kFileMark, 0) != 0 || then->text == kFileMark + digest)
      continue;
    changed.push_back(fmt::format("'{}' (SHA-256 {} then, {} now)", path,
                                  then->text.substr(kFileMark.size(), kShownDigits),
                                  digest.substr(0, kShownDigits)));
  }
  return changed;
}

/// Describes the difference of two comparisons: "'seed'", "hand 'barrett'", a changed file.
/// @param then  value of the file; null: it has none
std::string difference(const std::string& name, const JsonNode& now, const JsonNode* then,
                       const std::vector<std::string>& changed) {
  if (name == "program") return "build of thenar ('program')";
  if (name != "contents" || then == nullptr) return fmt::format("'{}'", name);
  if (!changed.empty()) return fmt::format("{}", fmt::join(changed, ", "));
  // Without a recorded file, name the content that differs.
  for (std::size_t i = 0; i < now.names.size(); ++i) {
    const JsonNode* other = then->find(now.names[i]);
    const std::size_t blank = now.names[i].find(' ');
    if (other == nullptr || *other != now.items[i])
      return fmt::format("{} '{}'", now.names[i].substr(0, blank), now.names[i].substr(blank + 1));
  }
  return "set of hands and objects";
}

/// Checks that the content of a file matches its checksum.
void check_checksum(const std::string& path, const JsonNode& file) {
  const JsonNode* sum = file.find("sha256");
  if (sum == nullptr)
    throw DataError(path, 1,
                    "its checksum (SHA-256) is missing: it was damaged, or written by an older "
                    "version; remove it, or name another file");
  if (*sum != JsonNode(comparison_checksum(file)))
    throw DataError(path, 1, "its checksum (SHA-256) does not hold: it was damaged or changed");
}

}  // namespace

JsonNode comparison_node(const Comparison& comparison) {
  JsonNode out;
  out.set("complete", comparison.complete)
      .set("warnings", comparison.warnings)
      .set("abilities", list_node(comparison.abilities, abilities_node))
      .set("cells", list_node(comparison.cells, cell_node));
  return out;
}

std::string comparison_checksum(const JsonNode& file) {
  JsonNode rest = file;
  rest.erase("sha256");
  return sha256(canonical_text(rest));
}

std::vector<HandOnObject> parse_cells(const JsonNode& list, const std::string& path) {
  try {
    return transformed(list.items, cell_of);
  } catch (const BrokenCell& broken) {
    throw DataError(path, broken.line, "a cell of the comparison is broken: " + broken.complaint);
  }
}

SavedComparison read_comparison(const std::string& path, const JsonNode& inputs,
                                const HandName& name, const FileDigests& files) {
  std::error_code none;
  if (!std::filesystem::exists(path, none)) return {};
  JsonNode file = parse_json(path, read_guarded(path, GuardedKind::kJson));
  require(file.find("inputs") != nullptr && file.find("cells") != nullptr,
          "'{}' is not a comparison of hands: name another file", path);
  check_checksum(path, file);
  rename_hands(file, name);
  const JsonNode *its_inputs = file.find("inputs"), *cells = file.find("cells");
  const JsonNode* provenance = file.find("provenance");
  // The inputs must be the same, or the file cannot be continued.
  for (std::size_t i = 0; i < inputs.names.size(); ++i) {
    const JsonNode* other = its_inputs->find(inputs.names[i]);
    require(other != nullptr && *other == inputs.items[i],
            "'{}' holds a comparison with another {}: name another file, or remove it", path,
            difference(inputs.names[i], inputs.items[i], other, changed_files(provenance, files)));
  }
  return {parse_cells(*cells, path), provenance == nullptr ? JsonNode() : *provenance};
}

JsonNode continued_provenance(const JsonNode& before, const RunRecord& run,
                              const FileDigests& files) {
  // List the earlier runs, the oldest first.
  JsonNode earlier(JsonKind::kArray), last = before;
  if (const JsonNode* runs = before.find(kEarlierRuns)) earlier = *runs;
  last.erase(kEarlierRuns);
  if (last.kind == JsonKind::kObject) earlier.items.push_back(last);
  // Add this run.
  JsonNode next;
  for (const auto& [name, text] : texts_of(run))
    if (!text.empty()) next.set(name, text);
  next.set("thenar", versions().at("thenar"));
  for (const auto& [path, digest] : files) next.set(path, kFileMark + digest);
  if (!earlier.items.empty()) next.set(kEarlierRuns, earlier);
  return next;
}

void write_comparison(const std::string& path, const Comparison& comparison, const JsonNode& inputs,
                      const JsonNode& provenance) {
  JsonNode file = comparison_node(comparison);
  file.set("inputs", inputs);
  if (provenance.kind == JsonKind::kObject) file.set("provenance", provenance);
  file.set("sha256", comparison_checksum(file));
  write_file(path, written(file, 1) + "\n");
}

}  // namespace thenar
