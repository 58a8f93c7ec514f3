// thumb_mug RESULT.json
//
// The founding paper's figure 8: angle of the thumb's pad over the force of the grip, on pins and
// on joints that give, how that changes with what is assumed, and surfaces to draw it from
// (docs/images/draw_thumb_mug.py). Prints the table of docs/benchmarks/thumb_mug.md.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "base/file_io.h"
#include "base/units.h"
#include "bench/run_program.h"
#include "data/io/subject.h"
#include "dynamics/stepping/contact_step.h"
#include "hand/skin/human_surfaces.h"
#include "hand/skin/skin_body.h"
#include "report/json.h"
#include "tests/data_folder.h"
#include "tests/dynamics/ligament/thumb_on_mug.h"

namespace thenar::bench {
namespace {

using Options = sample::ThumbOnMugOptions;

constexpr int kDrawnTriangles = 700;
constexpr int kSamples = 60;                             // of a run: one each 0.5 N
constexpr std::array<double, 4> kTold{1.5, 10, 20, 30};  // forces of the table [N]
constexpr double kTellsApart = 0.25;  // force of a state from that of the table, at most [N]

/// The state whose force is that of the table.
const sample::ThumbOnMugState& state_at(const std::vector<sample::ThumbOnMugState>& states,
                                        double force) {
  const auto nearest =
      std::min_element(states.begin(), states.end(),
                       [&](const sample::ThumbOnMugState& a, const sample::ThumbOnMugState& b) {
                         return std::abs(a.force - force) < std::abs(b.force - force);
                       });
  require(nearest != states.end() && std::abs(nearest->force - force) < kTellsApart,
          "no instant of the run has a force of {} N", force);
  return *nearest;
}

/// One change of the options.
struct Variant {
  std::string name;
  std::function<void(Options&)> change;
};

std::vector<Variant> variants() {
  const auto posture = [](const std::string& joint, double degrees) {
    return [=](Options& options) { options.posture[joint] = degrees; };
  };
  return {
      {"as assumed", [](Options&) {}},
      {"pins", [](Options& o) { o.compliant = false; }},
      {"capsules 0.5 times as stiff", [](Options& o) { o.stiffer = 0.5; }},
      {"2 times", [](Options& o) { o.stiffer = 2; }},
      {"4 times", [](Options& o) { o.stiffer = 4; }},
      {"10 times", [](Options& o) { o.stiffer = 10; }},
      {"100 times", [](Options& o) { o.stiffer = 100; }},
      {"muscles of 5 N m/rad", [](Options& o) { o.muscle = 5; }},
      {"muscles of 100 N m/rad", [](Options& o) { o.muscle = 100; }},
      {"friction 0.3", [](Options& o) { o.friction = 0.3; }},
      {"friction 1.2", [](Options& o) { o.friction = 1.2; }},
      {"mug across the bone (90 deg)", [](Options& o) { o.tilt = 90; }},
      {"mug along the bone (0 deg)", [](Options& o) { o.tilt = 0; }},
      {"mug tilted the other way (-45 deg)", [](Options& o) { o.tilt = -45; }},
      {"contact 90 deg from the pad", [](Options& o) { o.from_pad = 90; }},
      {"contact 50 deg from the pad", [](Options& o) { o.from_pad = 50; }},
      {"IP straight", posture("IP1", -23.8)},
      {"IP flexed by 40 deg", posture("IP1", 16.2)},
      {"MCP flexed by 20 deg", posture("MCP1_FE", 26)},
      {"CMC flexed by 11 deg", posture("CMC1_FE", 20)},
      {"skin of 8000 triangles", [](Options& o) { o.triangles = 8000; }},
  };
}

OrderedJson json_of_state(const sample::ThumbOnMugState& state) {
  OrderedJson out{{"force_N", state.force},
                  {"pad_angle_deg", number_or_null(state.pad_angle / kDegree)},
                  {"roll_deg", state.roll / kDegree}};
  for (const auto& [name, value] : state.moved) out["moved"][name] = value;
  return out;
}

/// Surfaces and poses of one run, for pictures.
OrderedJson picture_of(const sample::ThumbOnMug& made, const SceneRun& run) {
  const Subject subject = read_subject(kData + "/subjects/human_hand.toml");
  const auto flesh = skin_bodies(find_anatomy(subject));
  ContactStep step(made.scene);
  OrderedJson out;
  for (const auto& [segment, body] :
       {std::pair("DP1", "IP1"), {"PP1", "MCP1_FE"}, {"MC1", "CMC1_AA"}}) {
    const TriangleMesh skin = skin_mesh(flesh.at(segment), kDrawnTriangles);
    OrderedJson poses = OrderedJson::array();
    std::vector<Pose<double>> X;
    for (const SceneSample& sample : run.samples) {
      step.compute_poses({sample.t, sample.q, sample.v, sample.z}, X);
      const Pose<double>& at = X[static_cast<std::size_t>(body_named(made.scene.mechanism, body))];
      poses.push_back({{"R", to_json(at.R)}, {"p", to_json(at.p)}});
    }
    out["bodies"].push_back({{"name", segment},
                             {"vertices", to_json(skin.vertices.transpose())},
                             {"triangles", to_json(skin.triangles.transpose())},
                             {"poses", poses}});
  }
  OrderedJson mug = OrderedJson::array();
  std::vector<Pose<double>> X;
  for (const SceneSample& sample : run.samples) {
    step.compute_poses({sample.t, sample.q, sample.v, sample.z}, X);
    const Pose<double>& at = X[static_cast<std::size_t>(made.mug)];
    mug.push_back({{"R", to_json(at.R)}, {"p", to_json(at.p)}});
  }
  out["mug"] = mug;
  out["pad"] = to_json(made.pad);
  out["bone"] = to_json(made.bone);
  return out;
}

void run(const std::string& path) {
  OrderedJson out;
  fmt::print(
      "| what is changed | pad from the mug at 1.5 N, 10, 20, 30 N [deg] | turned about the bone "
      "[deg] |\n");
  for (const Variant& variant : variants()) {
    Options options;
    variant.change(options);
    sample::ThumbOnMug made = sample::thumb_on_mug(options);
    made.options.sample_interval = made.options.duration / kSamples;
    const SceneRun run = simulate_scene(made.scene, made.options);
    const std::vector<sample::ThumbOnMugState> states = states_of(made, run);
    OrderedJson row{{"name", variant.name},
                    {"status", name_of(run.status)},
                    {"unsolved", run.cost.unsolved},
                    {"deepest_m", run.cost.max_penetration},
                    {"cpu_s", run.cost.cpu_seconds}};
    for (const sample::ThumbOnMugState& state : states)
      row["states"].push_back(json_of_state(state));
    if (variant.name == "pins" || variant.name == "as assumed")
      row["picture"] = picture_of(made, run);
    out["runs"].push_back(std::move(row));
    std::vector<std::string> angles;
    for (const double force : kTold)
      angles.push_back(fmt::format("{:.1f}", state_at(states, force).pad_angle / kDegree));
    fmt::print("| {} | {} | {:.1f} |\n", variant.name, fmt::join(angles, ", "),
               states.back().roll / kDegree);
  }
  write_file(path, out.dump() + "\n");
}

}  // namespace
}  // namespace thenar::bench

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: thumb_mug RESULT.json\n");
    return 2;
  }
  return thenar::bench::run_program("thumb_mug", [&] { thenar::bench::run(argv[1]); });
}
