#include "report/pads/press_answer.h"

#include <fmt/format.h>

#include "base/numbers.h"
#include "base/units.h"

namespace thenar {
namespace {

const char* word_of(SkinContact contact) {
  return contact == SkinContact::kSticks  ? "sticks"
         : contact == SkinContact::kSlips ? "slips"
                                          : "free";
}

/// "a plane", "an edge of 0.5 mm"; of files their names alone.
std::string with_article(const std::string& object) {
  const std::string first = object.substr(0, object.find(' '));
  if (!contains(press_object_names(), first)) return object;
  return (first == "edge" ? "an " : "a ") + object;
}

std::string rate_words(const PressResult& pressed) {
  const PressRequest& request = pressed.request;
  if (!request.rate) return "instantaneous (no relaxation)";
  if (*request.rate == 0) return "quasi-static (fully relaxed)";
  std::string words = fmt::format("at {:g} mm/s", *request.rate / kMm);
  if (request.hold > 0) words += fmt::format(", then held for {:g} s", request.hold);
  if (!pressed.relaxes()) words += "; its tissues do not relax";
  return words;
}

Fields instant_fields(const PressInstant& now) {
  return {{"phase", name_of(now.phase)},
          {"time", units::kSecond, now.time},
          {"depth", units::kMillimetre, now.depth},
          {"force", units::kNewton, now.force},
          {"push", units::kNewton, now.push},
          {"area", units::kSquareMillimetre, now.area},
          {"stick", now.stick},
          {"largest_pressure", units::kKilopascal, now.pressure},
          {"force_error", now.force_error},
          {"penetration", units::kMillimetre, now.penetration},
          {"elements", now.elements},
          {"iterations", now.iterations},
          {"cpu", units::kCpuSecond, now.cpu}};
}

/// Nodes that touch.
std::vector<Fields> patch_fields(const PressedSkin& skin) {
  std::vector<Fields> nodes;
  for (Eigen::Index k = 0; k < skin.pressure.size(); ++k) {
    const SkinContact contact = nth(skin.contact, k);
    if (contact == SkinContact::kFree) continue;
    nodes.push_back({{"place", units::kMillimetre, skin.places.col(k)},
                     {"at_rest", units::kMillimetre, skin.at_rest.col(k)},
                     {"normal", units::kNewton, skin.normal[k]},
                     {"pressure", units::kKilopascal, skin.pressure[k]},
                     {"contact", word_of(contact)}});
  }
  return nodes;
}

std::vector<Fields> rung_fields(const std::vector<PressRung>& rungs) {
  return fields_of_each(rungs, [](const PressRung& rung) {
    // A rung that failed has no numbers, but a reason.
    const bool solved = rung.message.empty();
    return Fields{{"element", rung.element},
                  {"mesh", rung.mesh},
                  {"elements", rung.elements},
                  {"force", units::kNewton, solved ? rung.force : kNaN},
                  {"error", units::kOne, solved ? rung.error : kNaN},
                  {"area", units::kSquareMillimetre, rung.area},
                  {"torsion", units::kMillimetre, rung.torsion},
                  {"cpu", units::kCpuSecond, rung.cpu > 0 ? rung.cpu : kNaN},
                  {"finest", rung.finest},
                  {"reduced", rung.reduced},
                  {"note", rung.note},
                  {"failure", rung.message}};
  });
}

std::string ending_words(const PressResult& pressed) {
  if (pressed.instants.empty()) return "";
  const PressInstant& last = pressed.instants.back();
  return fmt::format(
      "{} elements; estimated error of the force {:.2g} %; the object penetrates faces of the "
      "skin by at most {:.2g} um\n{} iterations, CPU {:.3g} s\n",
      last.elements, 100 * last.force_error, 1e6 * last.penetration, last.iterations, pressed.cpu);
}

}  // namespace

std::string title_of(const PressResult& pressed) {
  const PressInstant* end = pressed.end_of_motion();
  const std::string what =
      fmt::format("{} under {}", pressed.pad.spec.name, with_article(pressed.object.name));
  return end == nullptr
             ? what + ": not pressed"
             : fmt::format("{}: {:.4g} N at {:.4g} mm", what, end->force, end->depth / kMm);
}

std::string conditions_of(const PressResult& pressed) {
  const PressRequest& request = pressed.request;
  std::string words = fmt::format("angle {:g} deg, friction {:g}, {}; {}, {}",
                                  degrees(request.angle), request.friction, rate_words(pressed),
                                  pressed.pad.spec.pulp.law, name_of(pressed.pad.model.element));
  if (request.turn != 0)
    words = fmt::format("object turned {:g} deg, ", degrees(request.turn)) + words;
  return words;
}

Table table_of(const PressResult& pressed) {
  Table table{{"phase", "time_s", "depth_mm", "force_N", "area_mm2", "stick",
               "largest_pressure_kPa", "force_error", "elements", "cpu_s"}};
  for (const PressInstant& now : pressed.instants)
    table.add({name_of(now.phase), shown(now.time), shown(now.depth / kMm), shown(now.force),
               shown(now.area / kSquareMm), shown(now.stick, 3), shown(now.pressure / kKilopascal),
               shown(now.force_error, 4), std::to_string(now.elements), shown(now.cpu)});
  return table;
}

Table rung_table(const PressResult& pressed) {
  Table table{{"element", "mesh", "elements", "force_N", "error", "area_mm2", "torsion_mm", "cpu_s",
               "note"}};
  for (const PressRung& rung : pressed.rungs) {
    const bool solved = rung.message.empty();
    table.add(
        {rung.element, rung.mesh, rung.reduced ? "-" : std::to_string(rung.elements),
         solved ? shown(rung.force) : "-", solved && !rung.finest ? shown(rung.error, 4) : "-",
         rung.area ? shown(*rung.area / kSquareMm) : "-",
         rung.torsion ? shown(*rung.torsion / kMm) : "-", rung.cpu > 0 ? shown(rung.cpu) : "-",
         rung.finest ? "the finest"
         : solved    ? rung.note
                     : rung.message});
  }
  return table;
}

std::string text_of(const PressResult& pressed) {
  std::string text = fmt::format("{}\n{}\n\n", title_of(pressed), conditions_of(pressed));
  text += titled("From first contact", table_of(pressed));
  if (!pressed.rungs.empty())
    text += titled("To the same depth at once, without friction, by laws, elements and meshes",
                   rung_table(pressed));
  return text + ending_words(pressed);
}

Fields fields_of(const PressResult& pressed) {
  // Conditions of the press, and how it ended.
  const PressRequest& request = pressed.request;
  Fields fields{{"pad", pressed.pad.spec.name},
                {"object", pressed.object.name},
                {"angle", units::kDegree, request.angle},
                {"turn", units::kDegree, request.turn},
                {"friction", request.friction},
                {"rate", units::kMillimetrePerSecondShort, request.rate},
                {"hold", units::kSecond, request.hold},
                {"law", pressed.pad.spec.pulp.law},
                {"element", name_of(pressed.pad.model.element)},
                {"assumed", assumed_words(pressed.pad.spec)},
                {"status", name_of(pressed.outcome.status)},
                {"message", pressed.message}};
  // State the last instant, then all.
  if (!pressed.instants.empty()) fields.append(instant_fields(pressed.instants.back()));
  fields.add("object_place", units::kMillimetre, pressed.X_PO.p);
  fields.add("along", units::kOne, pressed.touch.along);
  fields.add("instants", fields_of_each(pressed.instants, instant_fields));
  fields.add("patch", patch_fields(pressed.skin));
  if (!pressed.rungs.empty()) fields.add("rungs", rung_fields(pressed.rungs));
  fields.add("warnings", pressed.outcome.warnings);
  return fields;
}

FileDigests files_of(const PressResult& pressed) {
  FileDigests files = pressed.pad.spec.files;
  files.merge(FileDigests(pressed.object.files));
  return files;
}

std::string refusal_of(const PressResult& pressed) {
  if (pressed.outcome.status == Status::kSolved || pressed.outcome.stopped()) return "";
  const std::string got =
      pressed.instants.empty()
          ? "no step was solved"
          : fmt::format("it got to {:.4g} N at {:.4g} mm", pressed.instants.back().force,
                        pressed.instants.back().depth / kMm);
  return fmt::format("the press ended early ({}: {}); {}", name_of(pressed.outcome.status),
                     pressed.message, got);
}

}  // namespace thenar
