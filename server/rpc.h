#pragma once

/// JSON-RPC 2.0: parsing of untrusted messages, and execution of requests by a table of methods.
/// Source: JSON-RPC 2.0 Specification, www.jsonrpc.org/specification.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "report/json.h"
#include "server/method.h"
#include "server/session.h"

namespace thenar {

/// Error codes of JSON-RPC and of thenar.
enum class RpcCode {
  kParse = -32700,           // not valid JSON
  kInvalidRequest = -32600,  // not a valid request
  kNoMethod = -32601,        // unknown method
  kInvalidParams = -32602,   // parameters that do not match the schema
  kInternal = -32603,        // internal error
  kRefused = -32000,         // request that thenar refuses, with a reason
  kStopped = -32001,         // request that was stopped
  kTooLarge = -32002,        // message too long, too deep, or with too many values
};

/// Limits of a message.
struct RpcLimits {
  std::size_t bytes = 64UL << 20U;  // largest length [bytes]
  std::size_t depth = 32;           // largest nesting of lists and objects
  std::size_t values = 1'000'000;   // largest number of values
  std::size_t requests = 1000;      // largest number of requests of a batch
};

/// Error of a request.
struct RpcFailure {
  RpcCode code = RpcCode::kRefused;
  std::string text;        // message for the client
  std::string field = {};  // invalid field of the request (Error::field()); "": unknown
};

/// Request of a message, or the error found while parsing it.
struct RpcRequest {
  Json id;                    // number, text or null
  bool notification = false;  // true: the client expects no reply
  std::string method;
  Json params = Json::object();
  std::optional<RpcFailure> failure;  // error found while parsing
};

/// Message: a request, or a batch of requests.
struct RpcMessage {
  bool batch = false;
  std::vector<RpcRequest> requests;
};

/// Parses a message. Errors are returned in the requests; throws only std::bad_alloc.
[[nodiscard]] RpcMessage read_rpc(const std::string& text, const RpcLimits& limits);

/// Result of a request, or its error.
struct RpcAnswer {
  OrderedJson result;
  std::optional<RpcFailure> failure;
};

/// Executes a request. Converts all exceptions of the handler to errors.
[[nodiscard]] RpcAnswer answer_request(const RpcRequest& request, const MethodTable& table,
                                       Session& session, const Progress& progress);

/// Returns the reply to a request: {"jsonrpc": "2.0", "id", "result" or "error": {"code",
/// "message", "data": {"field"} if a field is invalid}}.
[[nodiscard]] OrderedJson rpc_reply(const Json& id, const RpcAnswer& answer);

/// Returns the result of session.status.
/// @param method    method of the running request; "": none
/// @param seconds   time since its start [s]
/// @param fraction  progress [1];  @param text  activity
/// @param waiting   number of requests in the queue
[[nodiscard]] OrderedJson status_json(const std::string& method, double seconds, double fraction,
                                      const std::string& text, std::size_t waiting);

/// Returns a notification to a client, as text.
[[nodiscard]] std::string rpc_notification(const std::string& method, const OrderedJson& params);

/// Parses a message that is a single short request of a method; empty for all other messages. For
/// the methods that the engine executes without queueing.
[[nodiscard]] std::optional<RpcRequest> short_request(const std::string& text,
                                                      const std::string& method);

}  // namespace thenar
