#include "pads/pad_fit_problem.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "base/lists.h"
#include "geometry/primitives.h"
#include "pads/build_pad.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// Words for constants in data files.
constexpr std::array kConstantWords{EnumName{PadConstantKind::kShearModulus, "shear_modulus"},
                                    EnumName{PadConstantKind::kExponent, "exponent"},
                                    EnumName{PadConstantKind::kPoissonRatio, "poisson_ratio"},
                                    EnumName{PadConstantKind::kShare, "share"},
                                    EnumName{PadConstantKind::kThickness, "thickness"},
                                    EnumName{PadConstantKind::kBoneHeight, "bone_height"}};

/// Returns whether any press takes time.
bool has_timed_press(const PadData& data) {
  return any_of(data.presses, [](const PadDataPress& press) { return press.ramp > 0; });
}

/// Returns the constant that a data file names. Files count layers from the outside, tissues from
/// the pulp outwards.
PadConstant constant_of(const PadData& data, const PadDataConstant& named, const PadSpec& pad) {
  const auto layers = static_cast<int>(pad.layers.size());
  const auto fail = [&](const std::string& what) { throw DataError(data.path, named.line, what); };
  // Check that the layer exists.
  if (named.layer > layers)
    fail(fmt::format("pad '{}' has {} layers of skin, wanted layer {}", pad.name, layers,
                     named.layer));
  PadConstant out;
  out.kind = value_in(kConstantWords, named.constant, "constant");
  out.tissue = named.layer == 0 ? 0 : layers - named.layer + 1;
  // Check that the tissue has such a constant.
  const PadTissueSpec& tissue =
      named.layer == 0 ? pad.pulp : pad.layers[static_cast<std::size_t>(named.layer) - 1];
  if (out.kind == PadConstantKind::kExponent && !has_exponent(tissue.law))
    fail(fmt::format("the law '{}' has no exponent", tissue.law));
  // Check that a share has its term, starts above 0, and that a press takes time.
  if (out.kind == PadConstantKind::kShare) {
    out.term = named.term - 1;
    const std::size_t terms = tissue.relaxation_share.size();
    if (static_cast<std::size_t>(named.term) > terms)
      fail(
          fmt::format("this tissue has {} terms of relaxation, wanted term {}", terms, named.term));
    if (!(tissue.relaxation_share[out.term] > 0))
      fail("a share of 0 cannot be fitted: begin above it");
    if (!has_timed_press(data))
      fail("no press takes time, and none tells of relaxation: give one a pace");
  }
  return out;
}

/// Object of a press.
struct TurnedObject {
  std::shared_ptr<const Shape> shape;
  double top;  // distance of its surface from its origin towards the pad [m]
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  // rotation before the press's angle (3, 3)
};

/// Builds the object of a press.
/// @param size  largest length of the pad [m]
TurnedObject object_of(const PadDataPress& press, double size) {
  if (press.object == "sphere") return {build_sphere(press.radius), press.radius};
  // The axis of a cylinder, z of the shape, lies along y.
  if (press.object == "cylinder")
    return {build_cylinder(press.radius, 4 * size), press.radius,
            rotation_about<double>(Vector3d(1, 0, 0), EIGEN_PI / 2)};
  return {build_box(Vector3d::Constant(4 * size)), 2 * size};
}

/// Returns the course of a press.
PressCourse course_of(const PadDataPress& press, const PadSpec& pad) {
  PressCourse out;
  // Place the object far enough away, turned by its angle, with its top towards the pad.
  const double size = std::max({pad.length, pad.width, pad.height});
  const TurnedObject object = object_of(press, size);
  out.object = {object.shape, press.friction};
  out.along = -Vector3d(std::sin(press.angle), 0, std::cos(press.angle));
  out.X_PO.R = rotation_about<double>(Vector3d(0, 1, 0), press.angle) * object.turn;
  out.X_PO.p = -(object.top + 2 * size) * out.along;
  // Collect the loads in rising order, with those that ratios refer to.
  std::set<double> loads;
  for (const PadDataRows& rows : press.rows) {
    loads.insert(rows.loads.begin(), rows.loads.end());
    if (rows.part_at) loads.insert(*rows.part_at);
  }
  // Add each load with its share of the ramp's time.
  double before = 0;
  for (const double load : loads) {
    PressLoad next;
    if (press.by_force)
      next.force = load;
    else
      next.indentation = load;
    next.time =
        std::isinf(press.ramp) ? press.ramp : press.ramp * (load - before) / *loads.rbegin();
    before = load;
    out.loads.push_back(next);
  }
  return out;
}

/// Returns the record of a press with its data.
PressRecord record_of(const PadDataPress& press, const PadSpec& pad) {
  PressRecord out;
  out.name = press.name;
  out.course = course_of(press, pad);
  // Returns the index of a load by its value.
  const auto load_of = [&](double value) {
    const auto found =
        std::find_if(out.course.loads.begin(), out.course.loads.end(), [&](const PressLoad& load) {
          return (press.by_force ? *load.force : load.indentation) == value;
        });
    return static_cast<int>(found - out.course.loads.begin());
  };
  // Add each value of a row as a datum, absolute or over that at another load.
  for (const PadDataRows& rows : press.rows)
    for (std::size_t i = 0; i < rows.loads.size(); ++i) {
      PressDatum datum;
      datum.quantity = value_in(kPressQuantityNames, rows.quantity, "quantity");
      datum.load = load_of(rows.loads[i]);
      if (rows.part_at) datum.over = load_of(*rows.part_at);
      datum.value = rows.values[i];
      datum.sd = rows.sds[i];
      datum.source = rows.source;
      out.data.push_back(datum);
    }
  return out;
}

/// Returns the key of a constant in a pad's file, without its unit.
std::string key_of(PadConstantKind kind) {
  return kind == PadConstantKind::kShare ? "relaxation_share" : name_in(kConstantWords, kind);
}

/// Marks a constant as assumed or not: removes its key, with any unit, from the assumed keys, and
/// adds it with the unit of pad_toml() if it is not determined. A list of shares stays assumed.
void mark_assumed(std::vector<std::string>& assumed, PadConstantKind kind, bool determined) {
  const std::string key = key_of(kind);
  if (kind == PadConstantKind::kShare && determined) return;
  erase_where(assumed, [&](const std::string& each) { return each.rfind(key, 0) == 0; });
  const std::string& unit = display_unit(kind).name;
  if (!determined) assumed.push_back(unit.empty() ? key : key + "_" + unit);
}

double& tissue_entry(PadTissueSpec& spec, const PadConstant& constant) {
  switch (constant.kind) {
    case PadConstantKind::kShearModulus:
      return spec.shear_modulus;
    case PadConstantKind::kExponent:
      return spec.exponent;
    case PadConstantKind::kPoissonRatio:
      return spec.poisson_ratio;
    case PadConstantKind::kShare:
      return spec.relaxation_share[constant.term];
    default:
      return spec.thickness;
  }
}

/// Returns the citation keys of both lists, each once.
std::string joined(const std::string& a, const std::string& b) {
  std::vector<std::string> out;
  for (const std::string& list : {a, b}) {
    std::size_t from = 0;
    while (from < list.size()) {
      const std::size_t to = std::min(list.find(", ", from), list.size());
      const std::string key = list.substr(from, to - from);
      if (!contains(out, key)) out.push_back(key);
      from = to + 2;
    }
  }
  return fmt::format("{}", fmt::join(out, ", "));
}

/// Adds definitions of citation keys; a key with another definition gets both.
void add_sources(const std::map<std::string, std::string>& more,
                 std::map<std::string, std::string>& sources) {
  for (const auto& [key, text] : more) {
    std::string& known = sources.try_emplace(key, text).first->second;
    if (known.find(text) == std::string::npos) known += "; " + text;
  }
}

}  // namespace

PadFitProblem pad_fit_problem(const PadData& data, const PadSpec& pad) {
  PadFitProblem out;
  out.pad = build_pad(pad);
  out.pad.cells = {data.cells.across, data.cells.around, data.cells.through};
  // Drop relaxation, which costs time, if no press takes time.
  if (!has_timed_press(data))
    for (Tissue& tissue : out.pad.tissues) tissue.relaxation.clear();
  // Add the free constants, each once, with their starts.
  for (const PadDataConstant& named : data.constants) {
    FreeConstant free{constant_of(data, named, pad), named.lower_factor, named.upper_factor,
                      named.prior_factor};
    for (const FreeConstant& other : out.constants)
      if (other.constant.kind == free.constant.kind &&
          other.constant.tissue == free.constant.tissue &&
          other.constant.term == free.constant.term)
        throw DataError(data.path, named.line,
                        fmt::format("{} is free already", name_of(out.pad, free.constant)));
    if (named.start) set_value(out.pad, free.constant, *named.start);
    out.constants.push_back(free);
  }
  // Check the pad at which the search begins.
  const std::string impossible = why_impossible(out.pad);
  if (!impossible.empty()) throw DataError(data.path, data.constants[0].line, impossible);
  for (const PadDataPress& press : data.presses) out.records.push_back(record_of(press, pad));
  return out;
}

PadSpec fitted_pad(const PadSpec& pad, const PadData& data, const PadFitProblem& problem,
                   const PadFitResult& result) {
  PadSpec out = pad;
  out.across = data.cells.across;
  out.around = data.cells.around;
  out.through = data.cells.through;
  // Collect the sources of all data.
  std::string cited;
  for (const PadDataPress& press : data.presses)
    for (const PadDataRows& rows : press.rows) cited = joined(cited, rows.source);
  add_sources(data.own_sources, out.own_sources);
  // Set each estimate in the shape or in its tissue; files count layers from the outside.
  for (std::size_t i = 0; i < result.estimates.size(); ++i) {
    const PadConstant& constant = problem.constants[i].constant;
    const ConstantEstimate& estimate = result.estimates[i];
    const bool of_shape = constant.kind == PadConstantKind::kBoneHeight;
    PadTissueSpec& tissue =
        constant.tissue == 0
            ? out.pulp
            : out.layers[out.layers.size() - static_cast<std::size_t>(constant.tissue)];
    (of_shape ? out.bone_height : tissue_entry(tissue, constant)) = estimate.value;
    // Mark determined constants as no longer assumed, and cite the data.
    mark_assumed(of_shape ? out.shape_assumed : tissue.assumed, constant.kind, estimate.determined);
    if (!estimate.determined) continue;
    std::string& source = of_shape ? out.shape_source : tissue.source;
    source = joined(source, cited);
  }
  return out;
}

std::string fit_comment(const PadData& data, const PadFitProblem& problem,
                        const PadFitResult& result) {
  std::string out = fmt::format("Fitted to {}: {}.\n", data.title, data.path);
  for (std::size_t i = 0; i < result.estimates.size(); ++i) {
    const ConstantEstimate& each = result.estimates[i];
    const DisplayUnit unit = display_unit(problem.constants[i].constant.kind);
    out += fmt::format(
        "  {} {:.4g}{}{}, {}{}\n", name_of(problem.pad, problem.constants[i].constant),
        each.value * unit.per_si, unit.name.empty() ? "" : " ", unit.name,
        std::isinf(each.sd) ? std::string("any value fits")
                            : fmt::format("one sd a factor of {:.3g}", std::exp(each.sd)),
        each.determined ? "" : "; the data alone do not determine it");
  }
  out += fmt::format("Misfit {:.3g} with {} degrees of freedom; search {}.\n", result.misfit,
                     result.degrees_of_freedom, convergence_word(result.solution));
  return out;
}

}  // namespace thenar
