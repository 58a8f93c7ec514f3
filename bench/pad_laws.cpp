// Reduced laws of a pad, fitted to its finite elements; their errors on other presses.
//
//   bench/pad_laws [FORCE_ERROR [PAD [LAWS]]]
//
// FORCE_ERROR  of the elements, 0.04 unless given
// PAD          a file of data/pads; the default pad, elastic, unless given
// LAWS         the laws as TOML

#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "data/io/pad/law_file.h"
#include "data/io/pad/pad.h"
#include "pads/build_pad.h"
#include "pads/calibrate_laws.h"
#include "pads/pad_shape.h"

namespace thenar {
namespace {

void print(const char* law, const LawError& error) {
  const auto pair = [](const RelativeError& e) {
    return fmt::format("{:5.1f} {:5.1f}", 100 * e.rms, 100 * e.worst);
  };
  fmt::print("| {:20} | {} | {} | {} | {} | {} |\n", law, pair(error.force), pair(error.area),
             pair(error.radius), pair(error.torsion), pair(error.shear));
}

void print(const MeasuredPresses& found, const CalibratedLaws& laws, const FoundationBed& bed) {
  fmt::print("{:26} {:>8} {:>7} {:>7} {:>8} {:>7} {:>8} {:>7} | {:>24} | {:>16}\n", "press",
             "depth_mm", "force_N", "err_%", "area_mm2", "aspect", "arm_mm", "R_mm",
             "force: power finger bed N", "bed area arm");
  for (const MeasuredPress& p : found.presses) {
    const BedContact contact = bed.press(*p.object, p.X_PO, 1);
    fmt::print(
        "{:26} {:8.3f} {:7.4f} {:7.1f} {:8.2f} {:7.3f} {:8.3f} {:7.2f} | {:8.4f} {:8.4f} {:8.4f} | "
        "{:8.2f} {:7.3f}\n",
        p.trial, 1e3 * p.depth, p.force, 100 * p.force_error, 1e6 * p.area, p.aspect, 1e3 * p.arm,
        1e3 * internal::radius_of(p.gap).radius,
        PowerLaw(laws.power).at_depth(p.gap, p.depth, 1).force,
        SoftFinger(laws.soft_finger).at_depth(p.gap, p.depth, 1).force, contact.force,
        1e6 * contact.area, 1e3 * contact.torsion);
  }
}

/// A pad to calibrate.
struct NamedPad {
  std::string name, words;  // `words` for the file's source
  PadModel model;
};

NamedPad default_pad() {
  NamedPad pad{"default pad",
               "the default pad (neo-Hookean, shear modulus 12 kPa, Poisson's ratio 0.49)",
               {}};
  pad.model.tissues.resize(1);
  pad.model.tissues[0].shear_modulus = 12e3;
  return pad;
}

NamedPad pad_of_file(const std::string& file) {
  const PadSpec spec = read_pad(file);
  std::string words = fmt::format("the pad '{}'", spec.name);
  if (const std::vector<std::string> assumed = assumed_words(spec); !assumed.empty())
    words += fmt::format(" (assumed in it: {})", fmt::join(assumed, ", "));
  return {spec.name, words, build_pad(spec)};
}

int run(double force_error, const std::string& pad_file, const std::string& laws_file) {
  const NamedPad pad = pad_file.empty() ? default_pad() : pad_of_file(pad_file);
  const PadModel& model = pad.model;
  PadPressOptions press;
  press.force_error = force_error;
  press.max_penetration = 20e-6;
  press.max_elements = 4000;
  const LawTrials trials = standard_trials(model.shape, {0.5e-3, 1e-3, 1.5e-3, 2e-3});
  const auto start = std::chrono::steady_clock::now();
  const MeasuredPresses fit = measure_presses(model, trials.fit, press);
  const MeasuredPresses check = measure_presses(model, trials.check, press);
  const auto pressed = std::chrono::steady_clock::now();
  LawCalibration found = fit_laws(model, fit, check, {});
  const auto fitted = std::chrono::steady_clock::now();
  found.laws.name = pad.name;
  const FoundationBed bed(pad_columns(model.shape, LawFitOptions{}.rings), found.laws.foundation);
  fmt::print("fitted:\n");
  print(fit, found.laws, bed);
  fmt::print("checked:\n");
  print(check, found.laws, bed);
  for (const std::string& failure : found.failures) fmt::print("failed: {}\n", failure);
  fmt::print(
      "\n| errors in %: rms, worst | force | area | radius | torsion | shear "
      "|\n|---|---|---|---|---|---|\n");
  print("power law", found.laws.power_error);
  print("soft finger", found.laws.soft_finger_error);
  print("foundation, local", found.laws.foundation_error);
  print("foundation, bed", found.laws.bed_error);
  fmt::print("\n{} {}\npresses {:.1f} s, fits {:.1f} s\n", name_of(found.status), found.message,
             std::chrono::duration<double>(pressed - start).count(),
             std::chrono::duration<double>(fitted - pressed).count());
  const std::string source =
      fmt::format("Fitted to {} presses of finite elements of {} and checked on {} others",
                  fit.presses.size(), pad.words, check.presses.size());
  fmt::print("\n{}", laws_text(found.laws, source));
  if (!laws_file.empty()) write_laws(laws_file, found.laws, source);
  return found.status == Status::kSolved ? 0 : 1;
}

}  // namespace
}  // namespace thenar

int main(int argc, char** argv) {
  return thenar::run(argc > 1 ? std::atof(argv[1]) : 0.04, argc > 2 ? argv[2] : "",
                     argc > 3 ? argv[3] : "");
}
