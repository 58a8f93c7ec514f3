#pragma once

/// Parameters that questions about one digit of a subject share.

#include "api/named/digits.h"
#include "base/rung_names.h"
#include "questions/request_table.h"

namespace thenar {

/// A posture, "posture_deg" or "posture_rad": angles by joint, or a list in the order of the
/// joints.
/// @param about  what is done with joints that are not named
template <typename Request>
void add_posture(RequestTable<Request>& table, const std::string& key,
                 PostureRequest Request::*member, const std::string& about);

/// Joints that vary over a grid, in the unit of the posture: "vary_deg" or "vary_rad".
template <typename Request>
void add_vary(RequestTable<Request>& table, std::vector<Vary> Request::*member,
              PostureRequest Request::*posture);

/// Folder with data of one's own.
template <typename Request>
void add_data(RequestTable<Request>& table, std::string Request::*member);

/// Tendon paths of digits that state none.
template <typename Request>
void add_path(RequestTable<Request>& table, std::optional<Path> Request::*member);

/// Subject, digit, posture, frozen joints, paths, passive moments, map, data: linear tendons, or a
/// tip map.
[[nodiscard]] RequestTable<DigitRequest> linear_digit_params();
/// The same with a hood and a net in place of a map. @param hood  of the question if left out
[[nodiscard]] RequestTable<DigitRequest> tendon_params(const std::string& hood);

namespace internal {
[[nodiscard]] Schema posture_schema();
[[nodiscard]] Schema vary_schema();
[[nodiscard]] PostureRequest posture_from(const Json& json, PostureUnit unit);
[[nodiscard]] Json posture_to(const PostureRequest& posture, PostureUnit unit);
[[nodiscard]] std::vector<Vary> vary_from(const Json& json);
[[nodiscard]] Json vary_to(const std::vector<Vary>& vary);
}  // namespace internal

template <typename Request>
void add_posture(RequestTable<Request>& table, const std::string& key,
                 PostureRequest Request::*member, const std::string& about) {
  // Two keys set the same member: one in degrees for people, one in radians for programs.
  for (const PostureUnit unit : {PostureUnit::kTyped, PostureUnit::kSI}) {
    const bool typed = unit == PostureUnit::kTyped;
    Param& param = table.add(
        {{key + (typed ? "_deg" : "_rad"), internal::posture_schema(),
          typed ? about : "The same in radians, slides in metres."},
         units::kOne},
        [=](Request& request, const Json& value) {
          request.*member = internal::posture_from(value, unit);
        },
        [=](const Request& request) { return internal::posture_to(request.*member, unit); });
    // Only the key in degrees is an option of the command.
    param.option = typed ? key : "";
    param.form = "JOINT=degrees";
    param.is_twin = !typed;
  }
}

template <typename Request>
void add_vary(RequestTable<Request>& table, std::vector<Vary> Request::*member,
              PostureRequest Request::*posture) {
  // A posture and its sweep share one unit, so that a grid never mixes degrees with radians.
  for (const PostureUnit unit : {PostureUnit::kTyped, PostureUnit::kSI}) {
    const bool typed = unit == PostureUnit::kTyped;
    Param& param = table.add(
        {{typed ? "vary_deg" : "vary_rad", internal::vary_schema(),
          typed ? "Joints that vary over a grid; the last one varies fastest."
                : "The same in radians."},
         units::kOne},
        [=](Request& request, const Json& value) {
          require_field("vary", (request.*posture).empty() || (request.*posture).unit == unit,
                        "wanted a posture and what varies in one unit");
          (request.*posture).unit = unit;
          request.*member = internal::vary_from(value);
        },
        [=](const Request& request) {
          return (request.*posture).unit == unit ? internal::vary_to(request.*member) : Json();
        });
    param.option = typed ? "vary" : "";
    param.is_twin = !typed;
  }
}

template <typename Request>
void add_data(RequestTable<Request>& table, std::string Request::*member) {
  table
      .add("data", text_schema(), member,
           "Folder with robots/, objects/.., before THENAR_DATA, ./data and what came with the "
           "program.")
      .scope = ParamScope::kLocal;
}

template <typename Request>
void add_path(RequestTable<Request>& table, std::optional<Path> Request::*member) {
  table.add_word("path", kPathNames, member,
                 "Tendon paths: straight between via points, polynomials fitted to wrapped ones, "
                 "or wrapped over the subject's surfaces; default: wrapped where the subject "
                 "defines wrapping surfaces, via otherwise.");
}

}  // namespace thenar
