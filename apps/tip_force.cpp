// thenar tip-force SUBJECT --digit D --posture ... --tension FDP=10 ... [--hold pinned|rigid]
//
// The static force of one fingertip under given tendon tensions.

#include "tendons/forces/tip_force.h"

#include <memory>

#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/digit_question.h"
#include "apps/options.h"
#include "base/error.h"
#include "base/units.h"
#include "report/json.h"
#include "report/table.h"
#include "tendons/forces/posture_sensitivity.h"
#include "tendons/forces/tip_wrench.h"

namespace thenar {
namespace {

struct TipForceArguments {
  DigitRequest question;
  std::vector<std::string> tension;
  std::string hold = "pinned";
  double hold_length_mm = 1e3 * TipWrenchOptions().length;
  bool json = false;
};

/// A pinned or a held tip; a pinned one has no moment.
struct TipAnswer {
  Eigen::Vector3d force, moment;  // of the tip on the world, world axes [N], [N m] (3)
  Eigen::VectorXd left;           // torque that nothing balances [N m] (rows)
  double condition;
  Eigen::VectorXd change;  // size of the force's change by each joint [N/rad] (n); empty for a map
  std::string note;        // what to beware of; may be empty
};

void add_note(const std::string& note, TipAnswer& answer) {
  if (!note.empty()) answer.note += (answer.note.empty() ? "" : "; ") + note;
}

TipAnswer pinned(const DigitAtPosture& at, const Eigen::VectorXd& t) {
  const TipForce result = tip_force(at.statics, t);
  TipAnswer answer{result.f_W, Eigen::Vector3d::Zero(), result.tau_residual, result.condition, {},
                   ""};
  if (result.rank < 3)
    answer.note = "singular posture: of the forces that leave the least torque, this is the least";
  if (!at.map.empty()) return answer;
  answer.change = tip_force_jacobian(at.statics, at.slopes, t).colwise().norm();
  if (result.rank == 3) add_note(posture_note(at, result.condition, answer.change), answer);
  return answer;
}

TipAnswer held(const DigitAtPosture& at, const Eigen::VectorXd& t, double length) {
  const TipWrench result = tip_wrench(at.statics, t, {length});
  TipAnswer answer{result.f_W, result.m_W, result.tau_residual, result.condition, {}, ""};
  answer.change =
      tip_wrench_jacobian(at.statics, at.slopes, t, {length}).bottomRows<3>().colwise().norm();
  if (result.minimum_norm)
    answer.note = fmt::format(
        "minimum norm: {} joints leave the wrench of a held tip open, and of those that balance "
        "this one has the least |force|^2 + |moment / {:.4g} mm|^2 (--hold-length)",
        at.q.size(), 1e3 * length);
  add_note(posture_note(at, result.condition, answer.change), answer);
  return answer;
}

void print_json(const TipForceArguments& options, const DigitAtPosture& at,
                const Eigen::VectorXd& t, const TipAnswer& answer) {
  nlohmann::ordered_json json = json_header(at);
  json["hold"] = options.hold;
  json["tension_N"] = to_json(at.statics.muscles, t);
  json["force_N"] = to_json(answer.force);
  if (at.tip_axes)
    json["force_tip_axes_N"] =
        to_json({"proximal", "dorsal", "radial"}, at.tip_axes->transpose() * answer.force);
  json["magnitude_N"] = answer.force.norm();
  if (options.hold == "rigid") json["moment_N_mm"] = to_json(answer.moment / kNmm);
  if (at.map.empty()) {
    json["leftover_torque_N_mm"] = to_json(at.rows, answer.left / kNmm);
    json["condition"] = answer.condition;
    json["force_change_N_per_deg"] = to_json(at.rows, answer.change * kDegree);
  } else {
    const std::vector<std::string> moments(at.rows.begin() + 3, at.rows.end());
    json["tip_moment_N_mm"] = to_json(moments, answer.left.tail(answer.left.size() - 3) / kNmm);
  }
  if (!answer.note.empty()) json["note"] = answer.note;
  fmt::print("{}\n", json_text(json));
}

void print_text(const TipForceArguments& options, const DigitAtPosture& at,
                const TipAnswer& answer) {
  fmt::print("{}\n", text_header(at));
  Table force{{"axes", "1_N", "2_N", "3_N", "magnitude_N"}, {}};
  const auto add = [&](const std::string& axes, const Eigen::Vector3d& f) {
    force.rows.push_back(row({{axes}, cells(f, 4), {shown(f.norm(), 4)}}));
  };
  add(at.map.empty() ? "world x y z" : "map x y z", answer.force);
  if (at.tip_axes) add("proximal dorsal radial", at.tip_axes->transpose() * answer.force);
  fmt::print("{}", titled(at.map.empty()
                              ? fmt::format("Force of the tip on the world, hold {}", options.hold)
                              : "Force of the tip on the world",
                          force));

  if (options.hold == "rigid")
    fmt::print("{}", titled("Moment of the tip on the world, about the tip, world axes",
                            {{"x_N_mm", "y_N_mm", "z_N_mm"}, {cells(answer.moment / kNmm, 3)}}));
  // A map's first rows are forces, balanced exactly; the rest are moments the tip must pass on.
  Table left{{at.map.empty() ? "joint" : "moment", "N_mm"}, {}};
  for (std::size_t i = at.map.empty() ? 0 : 3; i < at.rows.size(); ++i)
    left.rows.push_back({at.rows[i], shown(answer.left[static_cast<Eigen::Index>(i)] / kNmm, 4)});
  fmt::print("{}", titled(at.map.empty() ? "Joint torque left over, that no tip load balances"
                                         : "Moment at the tip, that the hold must carry",
                          left));
  if (at.map.empty())
    fmt::print("condition: {:.4g}\nsize of the force's change, {}\n", answer.condition,
               change_line(at, answer.change));
  if (!answer.note.empty()) fmt::print("note: {}\n", answer.note);
}

void run_tip_force(const TipForceArguments& options) {
  const DigitAtPosture at = find_digit(options.question);
  require(at.map.empty() || options.hold == "pinned",
          "tip map '{}' gives forces whatever the hold; leave out --hold rigid", at.map);
  const Eigen::VectorXd t =
      in_order(parse_named_numbers(options.tension, "MUSCLE=newton"), at.statics.muscles, "muscle");
  for (Eigen::Index i = 0; i < t.size(); ++i)
    require(t[i] >= 0, "wanted a tension >= 0 of '{}', got {} N",
            at.statics.muscles[static_cast<std::size_t>(i)], t[i]);
  const TipAnswer answer =
      options.hold == "rigid" ? held(at, t, 1e-3 * options.hold_length_mm) : pinned(at, t);
  options.json ? print_json(options, at, t, answer) : print_text(options, at, answer);
}

}  // namespace

void add_tip_force(CLI::App& app) {
  auto options = std::make_shared<TipForceArguments>();
  CLI::App* command = app.add_subcommand("tip-force", "Force of a fingertip from tendon tensions");
  add_digit_options(*command, options->question);
  command->add_option("--tension", options->tension, "MUSCLE=newton ...; others are slack")
      ->required();
  command->add_option("--hold", options->hold, "pinned: no moment; rigid: clamped")
      ->check(CLI::IsMember({"pinned", "rigid"}));
  command->add_option("--hold-length", options->hold_length_mm,
                      "How the norm of a rigid hold weighs moments [mm]");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { run_tip_force(*options); });
}

}  // namespace thenar
