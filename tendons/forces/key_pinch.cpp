#include "tendons/forces/key_pinch.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/lists.h"
#include "base/numbers.h"
#include "base/units.h"
#include "data/io/toml_node.h"
#include "data/io/toml_table.h"
#include "tendons/forces/max_tip_load.h"

namespace thenar {
namespace {

/// Reads one nerve block.
NerveBlock read_block(TomlTable& table) {
  // Read the weakened muscles and the measured loss.
  NerveBlock block;
  block.nerve = table.text("nerve");
  block.left = table.named(Dimension::kNumber, "left", Range::kFraction);
  if (block.left.empty()) table.fail("wanted muscles that the block weakens, got none", "left");
  block.loss = table.number(Dimension::kNumber, "loss", Range::kFraction);
  block.sd = table.number(Dimension::kNumber, "sd", Range::kPositive);
  block.source = table.source();
  block.line = table.line();

  // Check that assumed keys are in this table.
  if (table.has("assumed")) block.assumed = table.texts("assumed");
  for (const std::string& key : block.assumed)
    if (!table.has(key)) table.fail(fmt::format("there is no '{}' to assume", key), "assumed");
  table.done();
  return block;
}

/// Reads posture and direction of the pinch.
void read_pinch(TomlTable& table, PinchLosses& losses) {
  losses.posture = {table.text("posture"), table.named(Dimension::kAngle, "angles")};
  // Convert the name of the direction to components in the digit.
  const std::map<std::string, Eigen::Vector3d> directions{
      {"palmar", {0, -1, 0}}, {"distal", {-1, 0, 0}}, {"radial", {0, 0, 1}}, {"ulnar", {0, 0, -1}}};
  losses.direction =
      directions.at(table.choice("direction", {"palmar", "distal", "radial", "ulnar"}));
  losses.tolerance = table.number(Dimension::kAngle, "tolerance", Range::kNotNegative);
  if (losses.tolerance >= kPi / 2) table.fail("wanted a cone below 90 deg", "tolerance");
  losses.of_pinch = table.line();
  table.done();
}

/// Rounds a loss to the accuracy of two certified forces, so that equal losses are equal [1].
double rounded_loss(double loss) { return std::clamp(std::round(loss * 1e9), 0.0, 1e9) / 1e9; }

/// Computes the largest component of the tip's force along d in a cone; 0 where no force is in
/// balance, NaN where it is unbounded or was not found [N].
double strength(const TipStatics& statics, const Eigen::Vector3d& d, double tolerance) {
  const MaxTipForce largest = max_tip_load(statics, d, {TipLoad::kForce, tolerance}).largest;
  if (largest.status == Status::kInfeasible) return 0;
  return largest.status == Status::kSolved ? std::max(0.0, largest.component) : kNaN;
}

/// Throws an error that names the entry that does not fit the digit, and its line.
[[noreturn]] void refuse(const PinchLosses& losses, int line, const std::string& what) {
  if (losses.path.empty()) throw InputError(what);
  throw DataError(losses.path, line, what);
}

/// Returns the posture of the pinch [rad] (n).
Eigen::VectorXd angles_of_pinch(const TendonDigit& digit, const PinchLosses& losses) {
  const std::string& built = digit.skeleton.tips.front().digit;
  if (losses.digit != built)
    refuse(losses, losses.line,
           fmt::format("losses of pinch are of the {}, but the digit built is the {}", losses.digit,
                       built));
  try {
    return posture(digit.skeleton, losses.posture.angles);
  } catch (const InputError& error) {
    refuse(losses, losses.of_pinch, error.what());
  }
}

/// Returns the statics with the muscle strengths that remain under a block.
TipStatics blocked(TipStatics statics, const PinchLosses& losses, const NerveBlock& block,
                   const std::vector<std::string>& muscles) {
  for (const auto& [muscle, left] : block.left) {
    const int at = place_in(muscles, muscle);
    if (at < 0)
      refuse(losses, block.line,
             fmt::format("the block of the {} nerve weakens '{}', which the digit has not",
                         block.nerve, muscle));
    statics.max_tension[at] *= left;
  }
  return statics;
}

}  // namespace

PinchLosses parse_pinch_losses(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  PinchLosses losses;
  losses.name = top.text("name");
  losses.description = top.text_or("description", "");
  losses.digit = top.text("digit");
  losses.path = path;
  losses.line = top.line();
  // Read posture and direction of the pinch.
  std::optional<TomlTable> pinch = top.table("pinch");
  if (!pinch) top.fail("wanted [pinch]: posture, direction and tolerance, got none");
  read_pinch(*pinch, losses);
  // Read the measured losses.
  for (TomlTable& block : top.tables("block")) losses.blocks.push_back(read_block(block));
  if (losses.blocks.empty()) top.fail("wanted at least one [[block]], got none");
  top.done();
  return losses;
}

PinchLosses read_pinch_losses(const std::string& path) {
  return parse_pinch_losses(read_text_file(path), path);
}

PinchStrength measure_pinch(const TendonDigit& digit, const PinchLosses& losses) {
  // Compute the force of the intact digit in the posture of the pinch.
  const Eigen::VectorXd q = angles_of_pinch(digit, losses);
  const TipStatics statics = tip_statics(digit, q);
  const Eigen::Vector3d d = tip_axes(digit, q) * losses.direction;
  PinchStrength out;
  out.intact = strength(statics, d, losses.tolerance);
  out.undecided = std::isnan(out.intact) ? 1 : 0;
  out.loss = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(losses.blocks.size()), kNaN);

  // Compute the loss under each block.
  for (std::size_t b = 0; b < losses.blocks.size(); ++b) {
    const TipStatics weakened = blocked(statics, losses, losses.blocks[b], digit.names.muscles);
    if (!(out.intact >= kMinPinchForce)) continue;
    const double pinch = strength(weakened, d, losses.tolerance);
    if (std::isnan(pinch))
      ++out.undecided;
    else
      out.loss[b] = rounded_loss(1 - pinch / out.intact);
  }
  return out;
}

}  // namespace thenar
