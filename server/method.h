#pragma once

/// Table of the methods that clients call. Validation, the list for clients and docs/remote.md are
/// generated from it.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/progress.h"
#include "questions/schema.h"
#include "report/fields.h"
#include "report/json.h"

namespace thenar {

class Session;

/// Files that a method writes, apart from temporary files of the session.
enum class MethodWrites { kNothing, kFiles };

/// Method of JSON-RPC.
struct RpcMethod {
  /// Executes the method, and returns its result.
  /// @param params    validated parameters with default values
  /// @param progress  reports progress to the client, and passes on stop requests
  /// @throws Error with the message for the client; Stopped
  using Handler =
      std::function<OrderedJson(Session& session, const Json& params, const Progress& progress)>;

  std::string name;         // "hand.close"
  std::string description;  // one sentence
  Schema params;            // schema of the parameters, an object
  std::string returns;      // description of the result, with units
  std::string example;      // valid parameters as JSON; tests send them
  Handler handler;
  MethodWrites writes = MethodWrites::kNothing;
};

/// Returns a member that maps names to numbers; empty if it is missing.
/// @param params  validated parameters
[[nodiscard]] std::map<std::string, double> named_numbers(const Json& params,
                                                          const std::string& member);

/// Returns a reply in SI, the unit in each key: "gap_m". A field whose key had no unit in earlier
/// versions (units::kMetreBare) is also written under that key: "gap".
[[nodiscard]] OrderedJson reply_json(const Fields& fields);

/// Table of methods by name, in the order of the documentation.
class MethodTable {
 public:
  /// Adds a method. @throws InputError if there is already one of that name
  void add(RpcMethod method);
  /// Finds a method by name. @throws InputError with the nearest name if there is none
  [[nodiscard]] const RpcMethod& method_named(const std::string& name) const;
  [[nodiscard]] bool has_method(const std::string& name) const;
  [[nodiscard]] const std::vector<RpcMethod>& methods() const { return methods_; }

 private:
  std::vector<RpcMethod> methods_;
};

}  // namespace thenar
