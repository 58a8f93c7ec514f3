#pragma once

/// JSON-RPC 2.0: messages read without trust in them, requests answered from a table of methods.
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

/// Error codes of the protocol: reasons why a request has no result.
enum class RpcCode {
  kParse = -32700,           // no JSON
  kInvalidRequest = -32600,  // JSON, but no request
  kNoMethod = -32601,
  kInvalidParams = -32602,
  kInternal = -32603,  // a fault of ours
  kRefused = -32000,   // what thenar itself says no to
  kStopped = -32001,
  kTooLarge = -32002,  // too long, too deep, or too many values
};

/// Limits of a message.
struct RpcLimits {
  std::size_t bytes = 64UL << 20U;  // of a message
  std::size_t depth = 32;           // of lists and objects in each other
  std::size_t values = 1'000'000;   // numbers, texts, lists .. in all
  std::size_t requests = 1000;      // of a batch
};

/// An error that a client is told.
struct RpcFailure {
  RpcCode code = RpcCode::kRefused;
  std::string text;
  std::string field = {};  // of the request that is wrong (Error::field()); "": not known
};

/// One request of a message; where it cannot be answered, why.
struct RpcRequest {
  Json id;                    // number, text or null
  bool notification = false;  // no reply is wanted
  std::string method;
  Json params = Json::object();
  std::optional<RpcFailure> failure;  // found while it was read
};

/// A message: a request, or a batch of them.
struct RpcMessage {
  bool batch = false;
  std::vector<RpcRequest> requests;
};

/// Reads a message. What is wrong with it stands in its requests; nothing is thrown but bad_alloc.
[[nodiscard]] RpcMessage read_rpc(const std::string& text, const RpcLimits& limits);

/// Result of a request, or its failure.
struct RpcAnswer {
  OrderedJson result;
  std::optional<RpcFailure> failure;
};

/// Executes a request. Whatever a handler throws is a failure.
[[nodiscard]] RpcAnswer answer_request(const RpcRequest& request, const MethodTable& table,
                                       Session& session, const Progress& progress);

/// The reply to a request: {"jsonrpc": "2.0", "id", "result" or "error": {"code", "message",
/// "data": {"field"} where a field is wrong}}.
[[nodiscard]] OrderedJson rpc_reply(const Json& id, const RpcAnswer& answer);

/// Returns the result of session.status. @param method  of the request that runs; "": none
/// @param seconds  since it began;  @param waiting  requests behind it
[[nodiscard]] OrderedJson status_json(const std::string& method, double seconds, double fraction,
                                      const std::string& text, std::size_t waiting);

/// A message to a client that wants no reply, as text.
[[nodiscard]] std::string rpc_notification(const std::string& method, const OrderedJson& params);

/// Returns the request if a message is one request of this method, read only if it is short: for
/// the few methods that cannot wait for the request before them. Empty otherwise.
[[nodiscard]] std::optional<RpcRequest> short_request(const std::string& text,
                                                      const std::string& method);

}  // namespace thenar
