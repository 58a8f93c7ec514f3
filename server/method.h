#pragma once

/// Methods that a page, a script or a robot calls: one table says what each is named, what it takes
/// and what it does. Validation, the list that clients are given, and docs/remote.md come from it.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/progress.h"
#include "questions/schema.h"
#include "report/json.h"

namespace thenar {

class Session;

/// Files that a method writes. The folder of files dropped into a session is removed with the
/// session.
enum class MethodWrites { kNothing, kFiles };

/// One method of JSON-RPC.
struct RpcMethod {
  /// @param params    validated, defaults filled in
  /// @param progress  heard by the client that asked, and where it is asked to stop
  /// @returns the result
  /// @throws Error with what the client is told; Stopped
  using Handler =
      std::function<OrderedJson(Session& session, const Json& params, const Progress& progress)>;

  std::string name;     // "hand.close"
  std::string about;    // one sentence: what it does
  Schema params;        // an object
  std::string returns;  // what the result holds, with units
  std::string example;  // params as JSON, which tests send
  Handler handler;
  MethodWrites writes = MethodWrites::kNothing;
};

/// A member of names and numbers; empty if it was left out. @param params  validated
[[nodiscard]] std::map<std::string, double> named_numbers(const Json& params,
                                                          const std::string& member);

/// A table of methods by name, in the order in which they are documented.
class MethodTable {
 public:
  /// @throws InputError if there is one of that name already.
  void add(RpcMethod method);
  /// The method of that name. @throws InputError with the nearest name if there is none.
  [[nodiscard]] const RpcMethod& at(const std::string& name) const;
  [[nodiscard]] bool has(const std::string& name) const;
  [[nodiscard]] const std::vector<RpcMethod>& all() const { return methods_; }

 private:
  std::vector<RpcMethod> methods_;
};

}  // namespace thenar
