#include "apps/motion_output.h"

#include <filesystem>

#include <fmt/format.h>

#include "api/files.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/provenance.h"
#include "base/units.h"
#include "data/io/result_file.h"
#include "report/json.h"
#include "report/page.h"
#include "report/pages/motion.h"
#include "report/provenance.h"
#include "report/table.h"
#include "tendons/muscle/trajectory_table.h"

namespace thenar {
namespace {

std::string ending(const std::string& path) { return std::filesystem::path(path).extension(); }

std::string name_of(MotionStatus status) {
  switch (status) {
    case MotionStatus::kCompleted:
      return "done";
    case MotionStatus::kStopped:
      return "stopped";
    case MotionStatus::kLimit:
    case MotionStatus::kIntegratorFailed:
      return "stuck";
    case MotionStatus::kNoProgress:
      return "no progress";
    case MotionStatus::kUnbalanced:
      return "energy does not balance";
  }
  return "";
}

ResultFile result_file(const MotionAnswer& motion) {
  const Trajectory& t = motion.trajectory;
  ResultFile file;
  file.add("format", "thenar motion 1");
  file.add("status", name_of(t.status));
  file.add("trouble", t.warning);
  file.add("subject", motion.subject);
  file.add("digit", motion.digit);
  file.add("name/joint", t.joints);
  file.add("name/muscle", t.muscles);
  file.add("time", t.time, "s", {"instant"});
  file.add("angle", t.angle, "rad", {"instant", "joint"});
  file.add("speed", t.speed, "rad/s", {"instant", "joint"});
  file.add("excitation", t.excitation, "1", {"instant", "muscle"});
  file.add("activation", t.activation, "1", {"instant", "muscle"});
  file.add("tension", t.tension, "N", {"instant", "muscle"});
  file.add("excursion", t.excursion, "m", {"instant", "muscle"});
  if (t.fibre.size() > 0) file.add("fibre", t.fibre, "1", {"instant", "muscle"});
  file.add("slips", t.slips, "N", {"instant", "slip"});
  file.add("name/slip", std::vector<std::string>{"central", "radial", "ulnar", "terminal"});
  file.add("tip", t.tip, "m", {"instant", "axis"});
  file.add("energy", t.energy, "J", {"instant"});
  file.add("work", t.work, "J", {"instant"});
  file.add("lost", t.dissipated, "J", {"instant"});
  file.add("energy_error", t.balance.error, "J");
  file.add("turned_over", t.balance.turned_over, "J");
  file.add("stray", t.drift, "m");
  file.add("tolerance", t.tolerance, "1");
  int k = 0;
  for (const auto& [path, text] : motion.inputs) {
    const std::string key = fmt::format("inputs/{}", ++k);
    file.add(key + "/path", path);
    file.add(key + "/text", text);
    file.add(key + "/sha256", sha256(text));
  }
  for (const auto& [name, version] : versions()) file.add("provenance/versions/" + name, version);
  file.add("provenance/fidelity", describe(t.fidelity));
  return file;
}

nlohmann::json page(const MotionAnswer& motion) {
  std::vector<SourceText> sources;
  for (const auto& [path, text] : motion.inputs) sources.push_back({path, text});
  return {{"title", fmt::format("thenar: {} of {} in motion", motion.digit, motion.subject)},
          {"subtitle", describe(motion.trajectory.fidelity)},
          {"provenance", provenance_json(sources, motion.trajectory.fidelity)},
          {"sections", motion_page(motion.tendons, motion.trajectory)}};
}

}  // namespace

void require_motion_path(const std::string& path) {
  const std::string kind = ending(path);
  require(kind == ".csv" || kind == ".h5" || kind == ".html",
          "wanted an output that ends in .csv, .h5 or .html, got '{}'", path);
  kind == ".h5" ? require_result_path(path) : require_writable(path);
}

void write_motion(const MotionAnswer& motion, const std::string& path) {
  const std::string kind = ending(path);
  if (kind == ".csv") write_file(path, as_csv(trajectory_table(motion.trajectory)));
  if (kind == ".h5") write_result(result_file(motion), path);
  if (kind == ".html") write_report(page(motion), path);
}

void print_text(const MotionAnswer& motion) {
  const Trajectory& t = motion.trajectory;
  const Eigen::Index last = t.time.size() - 1;
  fmt::print("{} of {}: {} after {:.4g} s\nmodel: {}\n\n", motion.digit, motion.subject,
             name_of(t.status), t.time[last], describe(t.fidelity));
  Table joints{{"joint", "first_deg", "last_deg", "least_deg", "largest_deg", "last_deg_s"}, {}};
  for (Eigen::Index j = 0; j < t.angle.cols(); ++j) {
    const Eigen::VectorXd angle = t.angle.col(j) / kDegree;
    joints.rows.push_back({t.joints[static_cast<std::size_t>(j)], shown(angle[0], 2),
                           shown(angle[last], 2), shown(angle.minCoeff(), 2),
                           shown(angle.maxCoeff(), 2), shown(t.speed(last, j) / kDegree, 2)});
  }
  fmt::print("{}", titled("Joints", joints));
  Table muscles{{"muscle", "last_activation", "last_tension_N", "largest_tension_N",
                 "last_excursion_mm", "last_fibre"},
                {}};
  for (Eigen::Index m = 0; m < t.tension.cols(); ++m)
    muscles.rows.push_back({t.muscles[static_cast<std::size_t>(m)], shown(t.activation(last, m), 4),
                            shown(t.tension(last, m), 3), shown(t.tension.col(m).maxCoeff(), 3),
                            shown(t.excursion(last, m) / kMm, 3),
                            t.fibre.size() > 0 ? shown(t.fibre(last, m), 3) : "-"});
  fmt::print("{}", titled("Muscles", muscles));
  fmt::print("tip at the end: ({}) mm\n",
             fmt::join(cells(Eigen::Vector3d(t.tip.row(last).transpose() / kMm), 2), ", "));
  fmt::print("work {:.4g} mJ, lost {:.4g} mJ; out of nothing {:.2g} mJ of {:.4g} mJ turned over\n",
             1e3 * t.work[last], 1e3 * t.dissipated[last], 1e3 * t.balance.error,
             1e3 * t.balance.turned_over);
  fmt::print("{} steps to a tolerance of {:.2g}\n", t.counts.steps, t.tolerance);
}

nlohmann::ordered_json json_of(const MotionAnswer& motion) {
  const Trajectory& t = motion.trajectory;
  const Eigen::Index last = t.time.size() - 1;
  nlohmann::ordered_json json{
      {"subject", motion.subject},   {"digit", motion.digit}, {"fidelity", describe(t.fidelity)},
      {"status", name_of(t.status)}, {"trouble", t.warning},  {"instants", t.time.size()}};
  json["last"] = {{"time_s", t.time[last]},
                  {"posture_deg", to_json(t.joints, t.angle.row(last).transpose() / kDegree)},
                  {"speed_deg_s", to_json(t.joints, t.speed.row(last).transpose() / kDegree)},
                  {"activation", to_json(t.muscles, t.activation.row(last).transpose())},
                  {"tension_N", to_json(t.muscles, t.tension.row(last).transpose())},
                  {"excursion_mm", to_json(t.muscles, t.excursion.row(last).transpose() / kMm)},
                  {"slips_N", to_json({"central", "radial", "ulnar", "terminal"},
                                      t.slips.row(last).transpose())},
                  {"tip_mm", to_json(t.tip.row(last).transpose() / kMm)}};
  json["work_J"] = t.work[last];
  json["lost_J"] = t.dissipated[last];
  json["energy_error_J"] = t.balance.error;
  json["turned_over_J"] = t.balance.turned_over;
  json["stray_mm"] = t.drift / kMm;
  json["tolerance"] = t.tolerance;
  json["steps"] = t.counts.steps;
  json["slopes"] = t.counts.slopes;
  return json;
}

}  // namespace thenar
