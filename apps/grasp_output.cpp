#include "apps/grasp_output.h"

#include <algorithm>
#include <ctime>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/data_folder.h"
#include "apps/grasp_measures.h"
#include "apps/grasp_report.h"
#include "apps/grasp_robustness.h"
#include "apps/print_table.h"
#include "apps/progress_bar.h"
#include "apps/to_json.h"
#include "grasp/closing_drives.h"
#include "grasp/compare/centre.h"
#include "grasp/draw_start.h"
#include "grasp/quality/pyramid.h"
#include "grasp/quality/wrench_picture.h"
#include "viewer/grasp_words.h"

namespace thenar {
namespace {

using Ordered = nlohmann::ordered_json;

constexpr std::array<GraspOutcome, 6> kOutcomes{GraspOutcome::kGrasped, GraspOutcome::kOverlaps,
                                                GraspOutcome::kMissed,  GraspOutcome::kBlocked,
                                                GraspOutcome::kTooLong, GraspOutcome::kEmpty};

/// Grasps before those that are none, and the better ones of them first.
bool is_better(const Grasp& a, const Grasp& b) {
  const bool has = a.outcome == GraspOutcome::kGrasped, had = b.outcome == GraspOutcome::kGrasped;
  return has != had ? has : has && a.quality.lower > b.quality.lower;
}

GraspOptions options_of(const GraspQuestion& question, double way) {
  GraspOptions options;
  options.way = way;
  options.pads.contact = question.hand.named.contact;
  options.epsilon.limit = question.limit;
  options.epsilon.gap = question.gap;
  options.close.rates = question.hand.named.rates;
  return options;
}

/// One start, measured as was asked.
Grasp grasp_from(const GraspQuestion& question, const TouchingHand& touching,
                 const Pose<double>& X_WH, double way, const Scene& scene) {
  const GraspOptions options = options_of(question, way);
  Grasp found = grasp(touching, X_WH, question.hand.q, scene, options);
  if (question.edges > 0 && found.outcome == GraspOutcome::kGrasped)
    found.quality = epsilon(wrenches_of(question, found.contacts), options.epsilon);
  return found;
}

/// Counts a start, and keeps it if it is the best so far.
void note(GraspAnswer& found, Grasp grasp, int number, const Pose<double>& X_start, double way) {
  ++found.outcomes[static_cast<std::size_t>(grasp.outcome)];
  found.closures += grasp.outcome == GraspOutcome::kGrasped && grasp.quality.force_closure ? 1 : 0;
  if (number > 0 && !is_better(grasp, found.grasp)) return;
  found.grasp = std::move(grasp);
  found.best = number;
  found.X_start = X_start;
  found.way = way;
}

Ordered stopped_json(const GraspQuestion& question, const TouchingHand& touching,
                     const std::vector<JointRow>& rows) {
  Ordered list = Ordered::array();
  const HandLayout& layout = question.hand.named.hand->layout();
  for (std::size_t c = 0; c < rows.size(); ++c)
    list.push_back(
        {{"coordinate", layout.coordinates[c]},
         {"kind",
          slides(*touching.hand, question.hand.q, static_cast<int>(c)) ? "slides" : "turns"},
         {"value", rows[c].value},
         {"stopped_by", rows[c].stopped_by},
         {"why", rows[c].why}});
  return list;
}

Ordered contacts_json(const TouchingHand& touching, const std::vector<HandContact>& contacts) {
  Ordered list = Ordered::array();
  for (const HandContact& found : contacts) {
    const LinkSurface& surface = touching.hand->surfaces()[static_cast<std::size_t>(found.surface)];
    list.push_back({{"surface", surface.name},
                    {"digit", surface.digit},
                    {"position_m", to_json(found.contact.p)},
                    {"normal", to_json(found.contact.n)},
                    {"friction", found.contact.friction},
                    {"torsion_m", found.contact.torsion}});
  }
  return list;
}

Ordered quality_json(const Epsilon& e) {
  Ordered missing;
  if (e.has_missing_direction) missing = to_json(e.missing_direction);
  return {
      {"epsilon", {{"lower", e.lower}, {"upper", e.upper}}},
      {"force_closure", e.force_closure},
      {"rank", e.rank},
      {"missing_direction", missing},
      {"missing_direction_words",
       e.has_missing_direction ? Ordered(direction_words(e.missing_direction)) : Ordered(nullptr)},
      {"worst_wrench", to_json(e.worst_wrench)},
      {"worst_wrench_words", direction_words(e.worst_wrench)},
      {"converged", e.converged}};
}

Ordered starts_json(const GraspQuestion& question, const GraspAnswer& answer) {
  Ordered outcomes = Ordered::object();
  for (std::size_t i = 0; i < kOutcomes.size(); ++i)
    outcomes[name_of(kOutcomes[i])] = answer.outcomes[i];
  return {{"count", question.starts},
          {"seed", question.seed},
          {"best", answer.best},
          {"outcomes", outcomes},
          {"force_closures", answer.closures}};
}

std::string quality_text(const Epsilon& e) {
  std::string text = fmt::format("  {:<18}{}\n", "force closure", e.force_closure ? "yes" : "no");
  text += fmt::format("  {:<18}between {:.6g} and {:.6g}{}\n", "epsilon", e.lower, e.upper,
                      e.converged ? "" : " (gave up early)");
  if (e.has_missing_direction)
    text += fmt::format("  {:<18}{}\n", "cannot make", direction_words(e.missing_direction));
  return text + fmt::format("  {:<18}{}\n",
                            e.has_missing_direction ? "not withstood" : "withstood least",
                            direction_words(e.worst_wrench));
}

Ordered mesh_json(const WrenchPicture& picture) {
  if (picture.failed > 0) return nullptr;  // unbounded, or without the origin
  return {{"vertices_N", to_json(Eigen::MatrixXd(picture.mesh.vertices.transpose()))},
          {"triangles", to_json(Eigen::MatrixXi(picture.mesh.triangles.transpose()))}};
}

/// Projections onto forces and onto torques, and the slices where the others are zero.
Ordered wrench_set_json(const WrenchSet& wrenches, ForceLimit limit) {
  const ForceSet forces = unit_forces(wrenches, limit);
  const auto mesh = [&](int first, PictureKind kind) {
    return mesh_json(wrench_picture(forces, {first, first + 1, first + 2}, kind));
  };
  return {{"forces", mesh(0, PictureKind::kProjection)},
          {"forces_without_torque", mesh(0, PictureKind::kSlice)},
          {"torques_over_reach", mesh(3, PictureKind::kProjection)},
          {"torques_over_reach_without_force", mesh(3, PictureKind::kSlice)}};
}

/// Up to what tells one warning of a kind from the next.
std::string kind_of(const std::string& warning) {
  return warning.substr(0, warning.find_first_of(",:"));
}

std::string measures_text(const std::vector<MeasureRow>& rows) {
  std::string text;
  for (const MeasureRow& each : rows)
    text += fmt::format("  {:<28}{}{}\n", each.name, each.value,
                        each.note.empty() ? "" : " (" + each.note + ")");
  return text;
}

std::string starts_text(const GraspQuestion& question, const GraspAnswer& answer) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < kOutcomes.size(); ++i)
    if (answer.outcomes[i] > 0)
      parts.push_back(fmt::format("{} {}", answer.outcomes[i], name_of(kOutcomes[i])));
  return fmt::format("  {:<18}{} of seed {}: {}; {} with force closure\n", "starts",
                     question.starts, question.seed, fmt::join(parts, ", "), answer.closures);
}

std::string world_file(const WorldChoice& choice) {
  return named_file("world", choice.world, "worlds", ".toml", data_folders(choice.data));
}

GraspQuestion question_of(const WorldChoice& choice) {
  GraspQuestion question;
  question.path = world_file(choice);
  question.world = read_world(question.path);
  question.data = data_for(question.world.folder, choice.data);
  question.scene = build_scene(question.world, choice.object);
  return question;
}

}  // namespace

std::vector<std::string> folded(const std::vector<std::string>& warnings) {
  std::vector<std::string> kinds, lines;
  std::vector<int> counts;
  for (const std::string& warning : warnings) {
    const auto found = std::find(kinds.begin(), kinds.end(), kind_of(warning));
    if (found != kinds.end()) {
      ++counts[static_cast<std::size_t>(found - kinds.begin())];
      continue;
    }
    kinds.push_back(kind_of(warning));
    lines.push_back(warning);
    counts.push_back(1);
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (counts[i] > 1) lines[i] += fmt::format(" (and {} more of the kind)", counts[i] - 1);
  return lines;
}

WrenchSet wrenches_of(const GraspQuestion& question, const std::vector<HandContact>& contacts) {
  std::vector<Contact> plain;
  for (const HandContact& found : contacts) plain.push_back(found.contact);
  const SceneBody& object = question.scene.object;
  const WrenchSet set = wrench_set(plain, object.com, object.reach);
  return question.edges > 0 ? pyramids(set, question.edges) : set;
}

GraspAnswer answer(const GraspQuestion& question, const TouchingHand& touching, double way,
                   const Progress& progress) {
  const std::clock_t start = std::clock();
  const Scene& scene = question.scene;
  GraspAnswer found;
  if (question.starts == 0) {
    const Pose<double>& X_WH = question.hand.X_WH;
    note(found, grasp_from(question, touching, X_WH, way, scene), -1, X_WH, way);
  }
  std::mt19937 random(question.seed);
  for (int i = 0; i < question.starts; ++i) {
    if (progress.stop())
      throw Interrupted(fmt::format("stopped after {} of {} starts", i, question.starts));
    progress(static_cast<double>(i) / question.starts, "starts");
    const Pose<double> X_WH = draw_start(touching, question.hand.q, scene.object, random);
    const double past = way_past(touching, question.hand.q, scene.object);
    note(found, grasp_from(question, touching, X_WH, past, scene), i, X_WH, past);
  }
  found.wrenches = wrenches_of(question, found.grasp.contacts);
  found.cpu = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return found;
}

Grasp regrasp(const GraspQuestion& question, const TouchingHand& touching,
              const GraspAnswer& answer, const Scene& scene) {
  return centred_grasp(touching, answer.X_start, question.hand.q, scene,
                       options_of(question, answer.way));
}

Ordered grasp_json(const GraspQuestion& question, const TouchingHand& touching,
                   const GraspAnswer& answer, bool pictures) {
  const Grasp& grasp = answer.grasp;
  const Pose<double>& X = grasp.approached.X_WH;
  Ordered json{{"world", question.path},
               {"hand", question.hand.named.name},
               {"object", question.scene.object.name},
               {"outcome", name_of(grasp.outcome)},
               {"explanation", outcome_words(grasp)}};
  if (grasp.outcome == GraspOutcome::kGrasped) {
    json.update(quality_json(grasp.quality));
    if (answer.measures) json.update(measures_json(*answer.measures));
    json["robustness"] = answer.robustness ? robustness_json(*answer.robustness) : Ordered(nullptr);
    if (pictures) json["wrench_set"] = wrench_set_json(answer.wrenches, question.limit);
    json["contacts"] = contacts_json(touching, grasp.contacts);
  }
  json["hand_pose"] = {{"position_m", to_json(X.p)}, {"rotation", to_json(X.R)}};
  json["coordinates"] = stopped_json(question, touching, joint_rows(question, touching, answer));
  if (question.starts > 0) json["starts"] = starts_json(question, answer);
  json["warnings"] = question.hand.named.warnings;
  json["cpu_s"] = answer.cpu;
  return json;
}

std::string grasp_text(const GraspQuestion& question, const TouchingHand& touching,
                       const GraspAnswer& answer) {
  const Grasp& grasp = answer.grasp;
  std::string text = fmt::format("{} and {}: {}\n", question.hand.named.name,
                                 question.scene.object.name, outcome_words(grasp));
  if (question.starts > 0) text += starts_text(question, answer);
  if (grasp.outcome == GraspOutcome::kGrasped) text += quality_text(grasp.quality);
  if (answer.measures) text += "\n" + measures_text(measure_rows(*answer.measures));
  if (answer.robustness) text += measures_text(robustness_rows(*answer.robustness));
  Table joints{{"coordinate", "value", "stopped by"}, {}};
  for (const JointRow& row : joint_rows(question, touching, answer))
    joints.rows.push_back({row.name, row.shown, row.why});
  if (!joints.rows.empty()) text += "\n" + aligned(joints);
  if (!grasp.contacts.empty()) text += "\n" + aligned(contact_table(touching, grasp.contacts));
  for (const std::string& warning : folded(question.hand.named.warnings))
    text += fmt::format("warning: {}\n", warning);
  return text;
}

GraspQuestion ask_world(const WorldChoice& choice) {
  GraspQuestion question = question_of(choice);
  question.hand = hand_of_world(question.world, choice.hand, question.path, question.data);
  return question;
}

GraspQuestion ask_stranger(const WorldChoice& choice) {
  GraspQuestion question = question_of(choice);
  question.hand.named = hand_by_name(choice.hand, question.data);
  question.hand.q = open_posture(*question.hand.named.hand);
  return question;
}

bool has_hand(const WorldChoice& choice) {
  for (const PlacedHand& hand : read_world(world_file(choice)).hands)
    if (hand.name == choice.hand) return true;
  return false;
}

}  // namespace thenar
