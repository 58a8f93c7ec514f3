#pragma once

/// Parameters that questions about one digit of a subject share.

#include "api/named/digits.h"
#include "base/rung_names.h"
#include "questions/request_table.h"

namespace thenar {

/// Returns the parameters of a digit with linear tendons or a tip map: subject, digit, posture,
/// frozen joints, paths, passive moments, data, map.
[[nodiscard]] RequestTable<DigitRequest> linear_digit_params();
/// Returns the parameters of a digit with an extensor hood or net instead of a map.
/// @param hood  hood of the question by default, for the description
[[nodiscard]] RequestTable<DigitRequest> tendon_params(const std::string& hood);

namespace internal {
[[nodiscard]] Schema posture_schema();
[[nodiscard]] Schema vary_schema();
[[nodiscard]] PostureRequest posture_from_json(const Json& json, PostureUnit unit);
[[nodiscard]] Json posture_to_json(const PostureRequest& posture, PostureUnit unit);
[[nodiscard]] std::vector<Vary> vary_from_json(const Json& json);
[[nodiscard]] Json vary_to_json(const std::vector<Vary>& vary);
}  // namespace internal

/// Adds a posture as KEY_deg and KEY_rad: angles by joint, or a list in the order of the joints.
/// @param about  description of the parameter
template <typename Request>
void add_posture(RequestTable<Request>& table, const std::string& key,
                 PostureRequest Request::*member, const std::string& about) {
  // Add two keys for the same member: degrees for users, radians for programs.
  for (const PostureUnit unit : {PostureUnit::kTyped, PostureUnit::kSI}) {
    const bool typed = unit == PostureUnit::kTyped;
    Param& param = table.add(
        {{key + (typed ? "_deg" : "_rad"), internal::posture_schema(),
          typed ? about : "The same in radians, slides in metres."},
         units::kOne},
        [=](Request& request, const Json& value) {
          require_field(key.c_str(), (request.*member).empty(), "'{}' is given twice, in two units",
                        key);
          request.*member = internal::posture_from_json(value, unit);
        },
        [=](const Request& request) { return internal::posture_to_json(request.*member, unit); });
    // Make only the key in degrees an option of the command.
    param.option = typed ? key : "";
    param.form = "JOINT=degrees";
    param.is_twin = !typed;
  }
}

/// Adds joints that vary over a grid as "vary_deg" and "vary_rad", in the unit of the posture.
template <typename Request>
void add_vary(RequestTable<Request>& table, std::vector<Vary> Request::*member,
              PostureRequest Request::*posture) {
  // Add two keys; the grid must have the unit of the posture.
  for (const PostureUnit unit : {PostureUnit::kTyped, PostureUnit::kSI}) {
    const bool typed = unit == PostureUnit::kTyped;
    Param& param = table.add(
        {{typed ? "vary_deg" : "vary_rad", internal::vary_schema(),
          typed ? "Joints that vary over a grid; the last one varies fastest."
                : "The same in radians."},
         units::kOne},
        [=](Request& request, const Json& value) {
          require_field("vary", (request.*member).empty(), "'vary' is given twice, in two units");
          require_field("vary", (request.*posture).empty() || (request.*posture).unit == unit,
                        "wanted a posture and what varies in one unit");
          (request.*posture).unit = unit;
          request.*member = internal::vary_from_json(value);
        },
        [=](const Request& request) {
          return (request.*posture).unit == unit ? internal::vary_to_json(request.*member) : Json();
        });
    param.option = typed ? "vary" : "";
    param.is_twin = !typed;
  }
}

/// Adds the folder of the user's own data, "data".
template <typename Request>
void add_data(RequestTable<Request>& table, std::string Request::*member) {
  table
      .add("data", text_schema(), member,
           "Data folder (with robots/, objects/, ...), searched before THENAR_DATA, ./data and the "
           "data installed with thenar.")
      .scope = ParamScope::kLocal;
}

/// Adds the kind of tendon paths, "path".
template <typename Request>
void add_path(RequestTable<Request>& table, std::optional<Path> Request::*member) {
  table.add_word("path", kPathNames, member,
                 "Tendon paths: straight between via points, polynomials fitted to wrapped ones, "
                 "or wrapped over the subject's surfaces; default: wrapped where the subject "
                 "defines wrapping surfaces, via otherwise.");
}

}  // namespace thenar
