// thenar grasp WORLD.toml [--hand NAME] [--object NAME] [--no-approach] [--random N --seed S]
//              [--norm l1|linf] [--gap g] [--edges m] [--robustness N] [--json [--wrenches]]
//              [--report REPORT.html] [--save WORLD.toml] [--data DIR]
//
// Puts the hand of a world on its object, finds the contacts, and measures the grasp.

#include <algorithm>
#include <ctime>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "api/data_folders.h"
#include "apps/commands.h"
#include "apps/grasp_measures.h"
#include "apps/grasp_output.h"
#include "apps/grasp_robustness.h"
#include "apps/options.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/interrupt.h"
#include "base/progress_parts.h"
#include "grasp/closing/closing_drives.h"
#include "report/answers/grasp_words.h"
#include "report/json.h"

namespace thenar {
namespace {

struct GraspArguments {
  WorldRequest choice;
  std::string norm = "l1", out, save;
  bool approach = true, json = false, wrenches = false;
  int random = 0, edges = 0, robustness = 0;
  unsigned seed = 1;
  double gap = 1e-3, way = 1;
};

void check(const GraspArguments& options) {
  require(options.gap > 0, "wanted --gap above 0, got {}", options.gap);
  require(options.way > 0, "wanted --way above 0, got {}", options.way);
  require(options.random >= 0, "wanted --random of 0 or more, got {}", options.random);
  require(options.robustness >= 0, "wanted --robustness of 0 or more, got {}", options.robustness);
  constexpr int kMostEdges = 100;  // finer ones change nothing and take seconds that no signal ends
  require(options.edges == 0 || (options.edges >= 3 && options.edges <= kMostEdges),
          "wanted --edges of 3 to {}, got {}", kMostEdges, options.edges);
  require(options.approach || options.random == 0,
          "starts of --random are clear of the object: they want the approach");
  require_ending(options.out, {".html"});
  require_ending(options.save, {".toml"});
  for (const std::string& path : {options.out, options.save})
    if (!path.empty()) require_writable(path);
}

/// What parts take of a human hand, roughly [s]: of others they end sooner.
constexpr double kHand = 3, kStart = 0.3, kMeasures = 0.6, kDraw = 0.2, kPage = 0.6;

double seconds(const GraspArguments& options) {
  return kHand + kStart * std::max(1, options.random) + kMeasures + kDraw * options.robustness +
         (options.out.empty() ? 0 : kPage);
}

/// A hand that the world does not have may start at random.
GraspQuestion ask(const GraspArguments& options, const Progress& progress) {
  const bool stranger =
      !options.choice.hand.empty() && options.random > 0 && !has_hand(options.choice);
  return ask_world(options.choice, stranger, progress);
}

void save(const GraspQuestion& question, const GraspAnswer& found, const std::string& path) {
  require(found.grasp.outcome == GraspOutcome::kGrasped, "--save: {}; nothing is saved",
          outcome_words(found.grasp));
  const Pose<double>& X_WH = found.grasp.approached.X_WH;
  WorldSpec world = question.world;
  if (question.hand.parts.empty()) {
    PlacedHand placed{question.hand.named.name, "", X_WH, {}, "", ""};
    const std::vector<std::string>& names = question.hand.named.hand->layout().coordinates;
    for (std::size_t c = 0; c < names.size(); ++c)
      placed.posture[names[c]] = found.grasp.closed.q[static_cast<Eigen::Index>(c)];
    world.hands = {placed};
  }
  save_world(with_hand_at(std::move(world), question.hand, X_WH, found.grasp.closed.q), path);
}

void add_measures(const GraspArguments& options, const GraspQuestion& question,
                  const CollisionHand& touching, ProgressParts& schedule, GraspAnswer& found) {
  if (found.grasp.outcome != GraspOutcome::kGrasped) return;
  found.measures = std::make_shared<const GraspMeasures>(
      measure(question, touching, found, schedule.next(kMeasures)));
  if (options.robustness == 0) return;
  RobustnessQuestion asked;
  asked.draws = options.robustness;
  asked.seed = options.seed;
  found.robustness = std::make_shared<const GraspRobustness>(
      robustness_of(question, touching, found, asked, schedule.next(kDraw * options.robustness)));
}

/// Loads and efforts are no better than what the hand says of its torques.
void warn_of_tendons(const GraspAnswer& found, NamedHand& hand) {
  if (found.grasp.outcome != GraspOutcome::kGrasped) return;
  const Actuation here = hand.hand->actuation(found.grasp.closed.q);
  if (here.status < ActuationStatus::kDoubtful) return;
  hand.warnings.push_back(fmt::format(
      "the joint torques of this posture, and the loads and efforts that follow from them, {}: {}",
      here.status == ActuationStatus::kDoubtful ? "are doubtful" : "must not be used",
      here.warning));
}

void run_grasp(const GraspArguments& options) {
  check(options);
  ProgressParts schedule(terminal_progress(), seconds(options));
  GraspQuestion question = ask(options, schedule.next(kHand));
  question.limit = options.norm == "l1" ? ForceNorm::kL1 : ForceNorm::kLinf;
  question.gap = options.gap;
  question.edges = options.edges;
  question.starts = options.random;
  question.seed = options.seed;
  require(!question.hand.named.hand->surfaces().empty(),
          "hand '{}' has no surface that could touch", question.hand.named.name);
  const CollisionHand touching =
      collision_hand(*question.hand.named.hand, question.scene.materials);
  const bool mounted = question.hand.parts.size() > 1;  // an arm's foot does not fly
  require(!mounted || options.random == 0, "hand '{}' is mounted: it cannot start anywhere",
          question.hand.named.name);
  const std::clock_t start = std::clock();
  GraspAnswer found = answer(question, touching, options.approach && !mounted ? options.way : 0,
                             schedule.next(kStart * std::max(1, options.random)));
  require(found.grasp.outcome != GraspOutcome::kOverlaps, "{}: {}", question.path,
          outcome_words(found.grasp));
  try {
    add_measures(options, question, touching, schedule, found);
  } catch (const Stopped&) {  // what was found until then is told
  }
  found.cpu = cpu_since(start);
  warn_of_tendons(found, question.hand.named);
  if (!options.out.empty() && !interrupted()) {
    schedule.next(kPage)(0, options.out);
    write_grasp_report(question, touching, found, options.out);
  }
  schedule.finish();
  fmt::print("{}", options.json
                       ? json_text(grasp_json(question, touching, found, options.wrenches)) + "\n"
                       : grasp_text(question, touching, found));
  if (!options.save.empty()) save(question, found, options.save);
  if (interrupted()) throw Stopped("stopped: this is what was found by then");
}

}  // namespace

void add_grasp(CLI::App& app) {
  auto options = std::make_shared<GraspArguments>();
  CLI::App* command =
      app.add_subcommand("grasp", "Put the hand of a world on its object and measure the grasp");
  command
      ->add_option("world", options->choice.world,
                   "World file (TOML), or the name of one of DATA/worlds")
      ->required();
  command->add_option("--hand", options->choice.hand,
                      "Hand of the world; with --random any hand by name, as in 'thenar compare'");
  command->add_option("--object", options->choice.object, "Which object, where there are several");
  command->add_flag("--approach,!--no-approach", options->approach,
                    "Go along the palm's direction first (default), or close where the hand is");
  add_data_option(*command, options->choice.data);
  command->add_option("--way", options->way, "Farthest approach [m]");
  command->add_option("--random", options->random,
                      "Best of so many starts, drawn as in 'thenar compare'");
  command->add_option("--seed", options->seed, "Of --random and --robustness");
  command->add_option("--robustness", options->robustness,
                      "Draw friction, contacts and the object's place so many times");
  command->add_option("--norm", options->norm, "Limit of contact forces")
      ->check(CLI::IsMember({"l1", "linf"}));
  command->add_option("--gap", options->gap,
                      "Largest upper - lower of epsilon, also in --robustness");
  command->add_option("--edges", options->edges,
                      "Friction pyramids of so many edges in epsilon, volume, robustness and "
                      "wrench sets; 0: cones, as all other measures have");
  command->add_flag("--json", options->json, "Print JSON");
  command->add_flag("--wrenches", options->wrenches,
                    "With --json, also the wrench set as meshes: projected and cut");
  command->add_option("-o,--report,--out", options->out, "Also write a report (.html)");
  command->add_option("--save", options->save, "Also write the world with the hand as it ended");
  command->callback([options] {
    options->choice.pictures = !options->out.empty();
    run_grasp(*options);
  });
}

}  // namespace thenar
