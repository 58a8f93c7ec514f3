#include "apps/grasp_output.h"

#include <ctime>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/data_folder.h"
#include "apps/grasp_report.h"
#include "apps/print_table.h"
#include "apps/to_json.h"
#include "grasp/closing_drives.h"
#include "grasp/draw_start.h"
#include "grasp/quality/pyramid.h"
#include "viewer/grasp_words.h"

namespace thenar {
namespace {

using Json = nlohmann::ordered_json;

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
  return options;
}

/// One start, measured as was asked.
Grasp grasp_from(const GraspQuestion& question, const TouchingHand& touching,
                 const Pose<double>& X_WH, double way) {
  const GraspOptions options = options_of(question, way);
  Grasp found = grasp(touching, X_WH, question.hand.q, question.scene, options);
  if (question.edges > 0 && found.outcome == GraspOutcome::kGrasped)
    found.quality = epsilon(wrenches_of(question, found.contacts), options.epsilon);
  return found;
}

Json stopped_json(const GraspQuestion& question, const TouchingHand& touching,
                  const std::vector<JointRow>& rows) {
  Json list = Json::array();
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

Json contacts_json(const TouchingHand& touching, const std::vector<HandContact>& contacts) {
  Json list = Json::array();
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

Json quality_json(const Epsilon& e) {
  Json missing;
  if (e.has_missing_direction) missing = to_json(e.missing_direction);
  return {{"epsilon", {{"lower", e.lower}, {"upper", e.upper}}},
          {"force_closure", e.force_closure},
          {"rank", e.rank},
          {"missing_direction", missing},
          {"worst_wrench", to_json(e.worst_wrench)},
          {"converged", e.converged}};
}

Json starts_json(const GraspQuestion& question, const GraspAnswer& answer) {
  Json outcomes = Json::object();
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

WrenchSet wrenches_of(const GraspQuestion& question, const std::vector<HandContact>& contacts) {
  std::vector<Contact> plain;
  for (const HandContact& found : contacts) plain.push_back(found.contact);
  const SceneBody& object = question.scene.object;
  const WrenchSet set = wrench_set(plain, object.com, object.reach);
  return question.edges > 0 ? pyramids(set, question.edges) : set;
}

GraspAnswer answer(const GraspQuestion& question, const TouchingHand& touching, double way) {
  const std::clock_t start = std::clock();
  GraspAnswer found;
  const auto note = [&](Grasp grasp, int number) {
    ++found.outcomes[static_cast<std::size_t>(grasp.outcome)];
    found.closures +=
        grasp.outcome == GraspOutcome::kGrasped && grasp.quality.force_closure ? 1 : 0;
    if (number <= 0 || is_better(grasp, found.grasp)) {
      found.grasp = std::move(grasp);
      found.best = number;
    }
  };
  if (question.starts == 0) note(grasp_from(question, touching, question.hand.X_WH, way), -1);
  std::mt19937 random(question.seed);
  for (int i = 0; i < question.starts; ++i) {
    const SceneBody& object = question.scene.object;
    const Pose<double> X_WH = draw_start(touching, question.hand.q, object, random);
    const double past = way_past(touching, question.hand.q, object);
    note(grasp_from(question, touching, X_WH, past), i);
  }
  found.wrenches = wrenches_of(question, found.grasp.contacts);
  found.cpu = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return found;
}

Json grasp_json(const GraspQuestion& question, const TouchingHand& touching,
                const GraspAnswer& answer) {
  const Grasp& grasp = answer.grasp;
  const Pose<double>& X = grasp.approached.X_WH;
  Json json{{"world", question.path},
            {"hand", question.hand.named.name},
            {"object", question.scene.object.name},
            {"outcome", name_of(grasp.outcome)},
            {"explanation", outcome_words(grasp)}};
  if (grasp.outcome == GraspOutcome::kGrasped) {
    json.update(quality_json(grasp.quality));
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
  Table joints{{"coordinate", "value", "stopped by"}, {}};
  for (const JointRow& row : joint_rows(question, touching, answer))
    joints.rows.push_back({row.name, row.shown, row.why});
  if (!joints.rows.empty()) text += "\n" + aligned(joints);
  if (!grasp.contacts.empty()) text += "\n" + aligned(contact_table(touching, grasp.contacts));
  for (const std::string& warning : question.hand.named.warnings)
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
  question.hand.q = open_posture(question.hand.named.hand->layout());
  return question;
}

bool has_hand(const WorldChoice& choice) {
  for (const PlacedHand& hand : read_world(world_file(choice)).hands)
    if (hand.name == choice.hand) return true;
  return false;
}

}  // namespace thenar
