// peer_chart PAGE.html [SCENE or ENGINE...]
//
// Errors of moving scenes over processor time for every engine that is installed, as a table and as
// a page. A run that lost the object, or did not end, is marked as that.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include <fmt/format.h>

#include "bench/chart_main.h"
#include "bench/peers/peer_tasks.h"
#include "bench/ratios.h"

namespace thenar::bench {
namespace {

constexpr int kTurns = 3;           // of each run, for the median of its time
constexpr double kLongRun = 1;      // of runs that are not repeated [s]
constexpr double kFloor = 1e-16;    // of errors drawn
constexpr double kLostLine = 1000;  // where lost objects are drawn

/// An engine's answer at one knob.
struct Verdict {
  double knob = 0;  // step [s] or tolerance
  double cpu = 0;   // processor time per simulated second [ms]
  double error = 0;
  std::vector<double> further;
  std::string message;  // empty: none
};

/// All answers of one setting.
struct Course {
  const PeerSetting* setting;
  std::vector<Verdict> verdicts;
};

std::vector<PeerSetting> settings() {
  std::vector<PeerSetting> all = our_settings();
  const auto add = [&](const std::vector<PeerSetting>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
#ifdef THENAR_HAS_MUJOCO
  add(mujoco_settings());
#endif
#ifdef THENAR_HAS_ODE
  add(ode_settings());
#endif
#ifdef THENAR_HAS_BULLET
  add(bullet_settings());
#endif
#ifdef THENAR_HAS_DART
  add(dart_settings());
#endif
  add(simbody_settings());
  return all;
}

Verdict judge(const PeerTask& task, const PeerSetting& setting, double knob) {
  Verdict out;
  out.knob = knob;
  std::vector<double> seconds;
  for (int turn = 0; turn < kTurns; ++turn) {
    const PeerRun run = setting.run(task.peer, knob);
    seconds.push_back(run.cpu_seconds / std::max(run.samples.back().t, task.peer.sample));
    out.message = run.message;
    if (out.message.empty() && task.lost(run)) out.message = "LOST";
    out.error = task.error.of(run);
    out.further.clear();
    for (const PeerMeasure& measure : task.further) out.further.push_back(measure.of(run));
    if (run.cpu_seconds > kLongRun || !out.message.empty()) break;
  }
  out.cpu = 1e3 * median(seconds);
  return out;
}

std::string knob_text(const PeerSetting& setting, double knob) {
  return setting.adaptive ? fmt::format("tol {:g}", knob) : fmt::format("{:g} ms", 1e3 * knob);
}

void print(const PeerSetting& setting, const Verdict& verdict) {
  fmt::print("{:<44}{:>10}{:>11.4g}{:>12.3g}", setting.name(), knob_text(setting, verdict.knob),
             verdict.cpu, verdict.error);
  for (const double value : verdict.further) fmt::print("{:>12.3g}", value);
  fmt::print("  {}\n", verdict.message);
  std::fflush(stdout);
}

std::vector<Course> run_task(const PeerTask& task, const std::vector<PeerSetting>& all) {
  fmt::print("\n{}: {}\n{:<44}{:>10}{:>11}{:>12}", task.peer.name, task.about, "", "knob",
             "CPU [ms/s]", task.error.name);
  for (const PeerMeasure& measure : task.further) fmt::print("  {}", measure.name);
  fmt::print("\n");
  std::vector<Course> courses;
  for (const PeerSetting& setting : all) {
    if (setting.use == (task.touches ? PeerUse::kFree : PeerUse::kContacts)) continue;
    Course course{&setting, {}};
    for (const double knob : setting.adaptive ? task.tolerances : task.steps) {
      course.verdicts.push_back(judge(task, setting, knob));
      print(setting, course.verdicts.back());
    }
    courses.push_back(std::move(course));
  }
  return courses;
}

Json chart(const PeerTask& task, const std::vector<Course>& courses) {
  Json series = Json::array();
  Json lost_x = Json::array(), lost_y = Json::array(), lost_by = Json::array();
  for (const Course& course : courses) {
    Json x = Json::array(), y = Json::array(), hints = Json::array();
    for (const Verdict& verdict : course.verdicts) {
      const std::string hint = knob_text(*course.setting, verdict.knob);
      if (!verdict.message.empty()) {
        lost_x.push_back(verdict.cpu);
        lost_y.push_back(kLostLine);
        lost_by.push_back(fmt::format("{}, {}: {}", course.setting->name(), hint, verdict.message));
        continue;
      }
      x.push_back(verdict.cpu);
      y.push_back(std::max(verdict.error, kFloor));
      hints.push_back(hint);
    }
    if (x.empty()) continue;
    series.push_back({{"name", course.setting->name()},
                      {"style", "both"},
                      {"x", x},
                      {"y", y},
                      {"hints", hints}});
  }
  if (!lost_x.empty())
    series.push_back({{"name", "lost, or not ended"},
                      {"style", "points"},
                      {"x", lost_x},
                      {"y", lost_y},
                      {"hints", lost_by}});
  return {
      {"type", "lines"},
      {"caption", "Lower left is better; failures stand at the top, errors below 1e-16 at 1e-16"},
      {"x_label", "processor time per simulated second [ms]"},
      {"y_label", task.error.name},
      {"log_x", true},
      {"log_y", true},
      {"height", 420},
      {"series", series}};
}

Json table(const PeerTask& task, const std::vector<Course>& courses) {
  std::vector<BlockColumn> columns{{"engine, setting", ""},
                                   {"step or tolerance", ""},
                                   {"CPU for a second", "ms"},
                                   {task.error.name, ""}};
  for (const PeerMeasure& measure : task.further) columns.push_back({measure.name, ""});
  columns.push_back({"failure", ""});
  Json rows = Json::array();
  for (const Course& course : courses)
    for (const Verdict& verdict : course.verdicts) {
      // As text, since a column of numbers has one number of digits.
      Json row{course.setting->name(), knob_text(*course.setting, verdict.knob), verdict.cpu,
               fmt::format("{:.3g}", verdict.error)};
      for (const double value : verdict.further) row.push_back(fmt::format("{:.3g}", value));
      row.push_back(verdict.message.empty() ? "-" : verdict.message);
      rows.push_back(std::move(row));
    }
  return table_block("All runs", columns, rows);
}

/// What is asked for by name; all if nothing is.
template <typename Item, typename Name>
std::vector<Item> chosen(const std::vector<Item>& all, const std::vector<std::string>& wanted,
                         Name name) {
  std::vector<Item> out;
  for (const Item& item : all)
    if (std::count(wanted.begin(), wanted.end(), name(item)) > 0) out.push_back(item);
  return out.empty() ? all : out;
}

Json page(const std::vector<std::string>& wanted) {
  const std::vector<PeerSetting> all =
      chosen(settings(), wanted, [](const PeerSetting& setting) { return setting.engine; });
  const std::vector<PeerTask> tasks =
      chosen(contact_tasks(), wanted, [](const PeerTask& task) { return task.peer.name; });
  Json sections = Json::array();
  for (const PeerTask& task : tasks) {
    const std::vector<Course> courses = run_task(task, all);
    sections.push_back(section(fmt::format("scene-{}", sections.size() + 1), task.peer.name,
                               task.about, {chart(task, courses), table(task, courses)}));
  }
  return {{"title", "Moving scenes in several engines"}, {"sections", sections}};
}

}  // namespace
}  // namespace thenar::bench

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: peer_chart PAGE.html [SCENE or ENGINE...]\n");
    return 2;
  }
  const std::vector<std::string> wanted(argv + 2, argv + argc);
  return thenar::bench::write_chart("peer_chart", 2, argv,
                                    [&] { return thenar::bench::page(wanted); });
}
