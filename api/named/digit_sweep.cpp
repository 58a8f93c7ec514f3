#include "api/named/digit_sweep.h"

#include <exception>

#include <fmt/format.h>

#include "base/error.h"
#include "base/units.h"

namespace thenar {
namespace {

/// Event at some of the postures: its first occurrence, and their number.
struct Occurrence {
  std::string first_text, first_angles;
  std::size_t count = 0;

  void add(const std::string& text, const std::string& angles) {
    if (count++ > 0) return;
    first_text = text;
    first_angles = angles;
  }

  /// @param kind  "" or "no answer"
  void tell(const std::string& kind, std::size_t of, std::vector<std::string>& warnings) const {
    if (count == 0) return;
    warnings.push_back(of == 1 ? first_text
                               : fmt::format("{}at {} of {} postures, first at {}: {}", kind, count,
                                             of, first_angles, first_text));
  }
};

}  // namespace

DigitSweep sweep_of(const DigitCase& at) {
  DigitSweep sweep;
  sweep.subject = at.subject.name;
  sweep.digit = at.digit;
  sweep.map = at.map;
  sweep.sources = at.sources;
  sweep.warnings = at.warnings;
  if (!at.map.empty()) {
    const DigitAtPosture map = digit_at(at, {});
    sweep.built = map.built;
    sweep.rows = map.rows;
    sweep.muscles = map.statics.muscles;
    return sweep;
  }
  require(at.net == nullptr, "wanted tendons whose torque is linear in tensions, got a net");
  sweep.built = describe(at.bones().fidelity);
  sweep.rows = at.bones().names.coordinates;
  sweep.muscles = at.bones().names.muscles;
  sweep.grid = at.grid;
  sweep.tendons = at.tendons;
  return sweep;
}

void ask_postures(DigitSweep& sweep, const AskPosture& ask, const NoAnswer& fail,
                  const Progress& progress) {
  const std::size_t count = sweep.asked();
  Occurrence doubts, failures;
  std::exception_ptr first_failure;
  for (; sweep.done < count && !progress.stop(); ++sweep.done) {
    const Eigen::VectorXd q =
        sweep.map.empty() ? sweep.grid.postures[sweep.done] : Eigen::VectorXd();
    const std::string angles = varied_angles(sweep.rows, sweep.grid, q);
    try {
      const std::vector<std::string> warnings = ask(q);
      if (!warnings.empty()) doubts.add(warnings.front(), angles);
    } catch (const InputError& error) {
      if (failures.count == 0) first_failure = std::current_exception();
      failures.add(error.what(), angles);
      fail(q, error.what());
    }
    progress(static_cast<double>(sweep.done + 1) / static_cast<double>(count),
             fmt::format("posture {} of {}", sweep.done + 1, count));
  }
  if (first_failure && failures.count == sweep.done) std::rethrow_exception(first_failure);
  doubts.tell("", sweep.done, sweep.warnings);
  failures.tell("no answer ", sweep.done, sweep.warnings);
}

std::string varied_angles(const std::vector<std::string>& joints, const PostureGrid& grid,
                          const Eigen::VectorXd& q) {
  std::string text;
  for (const int joint : grid.varied)
    text += fmt::format("{}={:.4g} ", joints[static_cast<std::size_t>(joint)], q[joint] / kDegree);
  return text + "deg";
}

}  // namespace thenar
