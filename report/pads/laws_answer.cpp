#include "report/pads/laws_answer.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/units.h"
#include "report/pads/press_answer.h"

namespace thenar {
namespace {

/// A law by the name of its table in files, and its errors.
struct ErrorsOfLaw {
  const char* name;
  const char* key;
  LawError CalibratedLaws::*error;
};
constexpr std::array<ErrorsOfLaw, 4> kErrorsOfLaws{
    {{"power law", "power_law", &CalibratedLaws::power_error},
     {"soft finger", "soft_finger", &CalibratedLaws::soft_finger_error},
     {"elastic foundation", "elastic_foundation", &CalibratedLaws::foundation_error},
     {"foundation bed", "foundation_bed", &CalibratedLaws::bed_error}}};

struct QuantityOfLaw {
  const char* name;
  RelativeError LawError::*error;
};
constexpr std::array<QuantityOfLaw, 5> kQuantitiesOfLaws{{{"force", &LawError::force},
                                                          {"area", &LawError::area},
                                                          {"radius", &LawError::radius},
                                                          {"torsion", &LawError::torsion},
                                                          {"shear", &LawError::shear}}};

std::size_t count_of(const PadLaws& found, bool fitted) {
  return static_cast<std::size_t>(
      std::count_if(found.presses.begin(), found.presses.end(),
                    [&](const LawPress& press) { return press.fitted == fitted; }));
}

OrderedJson errors_json(const CalibratedLaws& laws) {
  OrderedJson json = OrderedJson::object();
  for (const ErrorsOfLaw& law : kErrorsOfLaws)
    for (const QuantityOfLaw& quantity : kQuantitiesOfLaws) {
      const RelativeError& error = laws.*law.error.*quantity.error;
      json[law.key][quantity.name] = {{"rms", error.rms}, {"worst", error.worst}};
    }
  return json;
}

/// Constants by their keys in files of laws.
Fields constant_fields(const CalibratedLaws& laws) {
  // Keys and units are those of the file, so that the answer can be turned into one.
  const PowerLawConstants& power = laws.power;
  const SoftFingerConstants& finger = laws.soft_finger;
  const FoundationConstants& bed = laws.foundation;
  return {{"power_law", Fields{{"force", units::kNewton, power.force},
                               {"depth_exponent", power.depth_exponent},
                               {"patch", units::kMetre, power.patch},
                               {"patch_exponent", power.patch_exponent},
                               {"torsion", power.torsion},
                               {"shear", units::kPascal, power.shear}}},
          {"soft_finger", Fields{{"force", units::kNewton, finger.force},
                                 {"depth_exponent", finger.depth_exponent},
                                 {"radius_exponent", finger.radius_exponent},
                                 {"patch", units::kMetre, finger.patch},
                                 {"patch_exponent", finger.patch_exponent},
                                 {"patch_radius", finger.patch_radius},
                                 {"aspect", finger.aspect},
                                 {"torsion", finger.torsion},
                                 {"shear", units::kPascal, finger.shear}}},
          {"elastic_foundation", Fields{{"modulus", units::kPascal, bed.modulus},
                                        {"exponent", bed.exponent},
                                        {"stiffening", bed.stiffening},
                                        {"surround", bed.surround},
                                        {"spread", bed.spread},
                                        {"thickness", units::kMetre, bed.thickness},
                                        {"shear", units::kPascal, bed.shear}}}};
}

std::vector<Fields> press_fields(const PadLaws& found) {
  // Lengths in mm and areas in mm2, as pads are measured.
  return fields_of_each(found.presses, [&](const LawPress& press) {
    const MeasuredPress& by = press.elements;
    Fields each{{"press", by.trial},
                {"fitted", press.fitted},
                {"depth", units::kMillimetre, by.depth},
                {"gap_radius", units::kMillimetre, internal::radius_of(by.gap).radius},
                {"force", units::kNewton, by.force},
                {"force_error", by.force_error},
                {"area", units::kSquareMillimetre, by.area},
                {"aspect", by.aspect},
                {"arm", units::kMillimetre, by.arm},
                {"shear", units::kNewtonPerMillimetre, by.shear}};
    if (press.laws)
      each.add("laws",
               Fields{{"power_law", units::kNewton, press.laws->power},
                      {"soft_finger", units::kNewton, press.laws->soft_finger},
                      {"foundation_bed", units::kNewton, press.laws->bed},
                      {"foundation_bed_area", units::kSquareMillimetre, press.laws->bed_area},
                      {"foundation_bed_arm", units::kMillimetre, press.laws->bed_arm}});
    return each;
  });
}

std::vector<double> depths_mm(const PadLaws& found) {
  return transformed(found.depths, [](double depth) { return depth / kMm; });
}

}  // namespace

std::string title_of(const PadLaws& found) {
  const std::string& name = found.pad.spec.name;
  if (!found.has_laws())
    return fmt::format("{}: no laws; presses of its elements that were solved: {}", name,
                       found.presses.size());
  return fmt::format("{}: laws fitted to presses ({}), checked on others ({})", name,
                     count_of(found, true), count_of(found, false));
}

std::string conditions_of(const PadLaws& found) {
  return fmt::format("pressed to {:.4g} mm; {}; presses {:.1f} s, fits {:.1f} s",
                     fmt::join(depths_mm(found), ", "), name_of(found.calibration.status),
                     found.press_s, found.fit_s);
}

Table table_of(const PadLaws& found) {
  Table table{{"law", "error", "force_%", "area_%", "radius_%", "torsion_%", "shear_%"}};
  if (!found.has_laws()) return table;
  for (const ErrorsOfLaw& law : kErrorsOfLaws)
    for (const auto& [name, kind] :
         {std::pair{"rms", &RelativeError::rms}, std::pair{"worst", &RelativeError::worst}}) {
      std::vector<std::string> row{law.name, name};
      for (const QuantityOfLaw& quantity : kQuantitiesOfLaws)
        row.push_back(shown(100 * (found.calibration.laws.*law.error.*quantity.error.*kind), 1));
      table.add(std::move(row));
    }
  return table;
}

std::string errors_note() {
  return "Errors at given depths, of the presses that were checked.\n"
         "radius: longer semi-axis of the patch; torsion: largest torque per force and friction;\n"
         "shear: stiffness across while all sticks. The bed is over the pad's skin, the elastic\n"
         "foundation the same springs by curvatures.\n";
}

Table press_table(const PadLaws& found) {
  Table table{{"press", "for", "depth_mm", "gap_radius_mm", "force_N", "force_error_%", "area_mm2",
               "aspect", "arm_mm", "power_law_N", "soft_finger_N", "bed_N", "bed_area_mm2",
               "bed_arm_mm"}};
  for (const LawPress& press : found.presses) {
    const MeasuredPress& by = press.elements;
    std::vector<std::string> row{by.trial,
                                 press.fitted ? "fit" : "check",
                                 shown(by.depth / kMm),
                                 shown(internal::radius_of(by.gap).radius / kMm),
                                 shown(by.force),
                                 shown(100 * by.force_error, 1),
                                 shown(by.area / kSquareMm),
                                 shown(by.aspect, 3),
                                 shown(by.arm / kMm)};
    const auto add = [&](double LawForces::*value, double unit) {
      row.push_back(press.laws ? shown(*press.laws.*value / unit) : "-");
    };
    add(&LawForces::power, 1);
    add(&LawForces::soft_finger, 1);
    add(&LawForces::bed, 1);
    add(&LawForces::bed_area, kSquareMm);
    add(&LawForces::bed_arm, kMm);
    table.add(std::move(row));
  }
  return table;
}

std::string text_of(const PadLaws& found) {
  std::string text = fmt::format("{}\n{}\n\n", title_of(found), conditions_of(found));
  text += titled("Presses", press_table(found));
  if (!found.has_laws()) return text;
  return text + titled("Errors", table_of(found)) + errors_note();
}

Fields fields_of(const PadLaws& found) {
  // Status and times of both parts: presses, then fits.
  const LawCalibration& calibration = found.calibration;
  return {
      {"pad", found.pad.spec.name},
      {"pad_file", found.pad.path},
      {"pad_digest", calibration.laws.pad_digest},
      {"status", name_of(calibration.status)},
      {"message", calibration.message},
      {"press", units::kSecond, found.press_s},
      {"fit", units::kSecond, found.fit_s},
      {"depths", units::kMillimetre, found.depths},
      {"fitted", count_of(found, true)},
      {"checked", count_of(found, false)},
      {"errors", found.has_laws() ? errors_json(calibration.laws) : OrderedJson()},
      found.has_laws() ? Field("laws", constant_fields(calibration.laws)) : Field("laws", nullptr),
      {"presses", press_fields(found)},
      {"failures", calibration.failures},
      {"assumed", assumed_words(found.pad.spec)},
      {"warnings", found.outcome.warnings}};
}

FileDigests files_of(const PadLaws& found) { return found.pad.spec.files; }

}  // namespace thenar
