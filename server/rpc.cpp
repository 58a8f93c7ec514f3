#include "server/rpc.h"

#include <exception>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/progress_parts.h"
#include "base/stop_scope.h"

namespace thenar {
namespace {

constexpr std::size_t kMaxShortRequest = 512;  // largest message for short_request() [bytes]

/// Returns the reason why a text is too large to be parsed; counts brackets and commas outside of
/// its strings.
std::optional<std::string> size_error(const std::string& text, const RpcLimits& limits) {
  if (text.size() > limits.bytes)
    return fmt::format("a message of {} bytes, at most {} are read", text.size(), limits.bytes);
  // Scan the text without parsing: deep or long texts must not reach the parser.
  std::size_t depth = 0, values = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '\\') {
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && (c == '[' || c == '{')) {
      ++values;
      if (++depth > limits.depth)
        return fmt::format("lists or objects more than {} deep", limits.depth);
    } else if (!quoted && (c == ']' || c == '}')) {
      depth -= depth > 0 ? 1 : 0;
    } else if (!quoted && c == ',') {
      ++values;
    }
  }
  if (values > limits.values) return fmt::format("more than {} values", limits.values);
  return std::nullopt;
}

RpcMessage refusal(RpcCode code, std::string text) {
  RpcMessage message;
  message.requests.emplace_back();
  message.requests.front().failure = RpcFailure{code, std::move(text)};
  return message;
}

/// Returns a message about wrong members of a request; nothing if all are valid.
std::optional<std::string> request_error(const Json& value) {
  if (!value.is_object()) return "wanted a request, an object";
  if (value.value("jsonrpc", Json()) != "2.0") return "wanted \"jsonrpc\": \"2.0\"";
  if (!value.contains("method") || !value["method"].is_string()) return "wanted \"method\", a text";
  if (value.contains("params") && !value["params"].is_object())
    return "wanted \"params\" by name, an object";
  for (const auto& [name, entry] : value.items())
    if (name != "jsonrpc" && name != "method" && name != "params" && name != "id")
      return fmt::format("a request has no member '{}'", name.substr(0, 40));
  return std::nullopt;
}

RpcRequest request_of(Json value) {
  RpcRequest request;
  // Read the id first, so that errors are reported with it.
  const bool has_id = value.is_object() && value.contains("id");
  if (has_id) {
    request.id = value["id"];
    if (!request.id.is_number() && !request.id.is_string() && !request.id.is_null()) {
      request.id = nullptr;
      request.failure = {RpcCode::kInvalidRequest, "wanted \"id\", a number or a text"};
      return request;
    }
  }
  // Check the members, and copy them.
  if (const auto error = request_error(value)) {
    request.failure = {RpcCode::kInvalidRequest, *error};
    return request;
  }
  request.notification = !has_id;
  request.method = value["method"].get<std::string>();
  if (value.contains("params")) request.params = std::move(value["params"]);
  return request;
}

}  // namespace

RpcMessage read_rpc(const std::string& text, const RpcLimits& limits) {
  if (const auto error = size_error(text, limits)) return refusal(RpcCode::kTooLarge, *error);
  // Parse; the parser refuses numbers beyond the range of doubles and invalid UTF-8.
  Json value;
  try {
    value = Json::parse(text);
  } catch (const Json::exception& error) {
    // Remove the name of the exception from the message.
    const std::string message = error.what();
    return refusal(RpcCode::kParse, "wanted JSON: " + message.substr(message.find(']') + 2));
  }
  // Convert a single request.
  RpcMessage message;
  if (!value.is_array()) {
    message.requests.push_back(request_of(std::move(value)));
    return message;
  }
  // Convert a batch.
  if (value.empty()) return refusal(RpcCode::kInvalidRequest, "a batch without requests");
  if (value.size() > limits.requests)
    return refusal(RpcCode::kTooLarge, fmt::format("a batch of {} requests, at most {} are read",
                                                   value.size(), limits.requests));
  message.batch = true;
  for (Json& entry : value) message.requests.push_back(request_of(std::move(entry)));
  return message;
}

RpcAnswer answer_request(const RpcRequest& request, const MethodTable& table, Session& session,
                         const Progress& progress) {
  if (request.failure) return {{}, request.failure};
  RpcCode code = RpcCode::kNoMethod;  // error code of the next exception
  try {
    const RpcMethod& method = table.method_named(request.method);
    code = RpcCode::kInvalidParams;
    const Json params = validated(method.params, request.params, "params");
    code = RpcCode::kRefused;
    const StopScope scope(progress);
    return {method.handler(session, params, progress), std::nullopt};
  } catch (const Stopped& stopped) {
    return {{}, RpcFailure{RpcCode::kStopped, stopped.what()}};
  } catch (const Error& error) {
    return {{}, RpcFailure{code, error.what(), error.field()}};
  } catch (const std::bad_alloc&) {
    return {{}, RpcFailure{RpcCode::kTooLarge, "it needs more memory than there is"}};
  } catch (const std::exception& error) {
    return {{}, RpcFailure{RpcCode::kInternal, fmt::format("a fault of thenar: {}", error.what())}};
  }
}

OrderedJson rpc_reply(const Json& id, const RpcAnswer& answer) {
  OrderedJson reply{{"jsonrpc", "2.0"}, {"id", id}};
  if (!answer.failure) {
    reply["result"] = answer.result;
    return reply;
  }
  OrderedJson& error = reply["error"];
  error = {{"code", static_cast<int>(answer.failure->code)}, {"message", answer.failure->text}};
  if (!answer.failure->field.empty()) error["data"] = {{"field", answer.failure->field}};
  return reply;
}

OrderedJson status_json(const std::string& method, double seconds, double fraction,
                        const std::string& text, std::size_t waiting) {
  return {{"runs", method.empty() ? OrderedJson() : OrderedJson(method)},
          {"seconds", seconds},
          {"fraction", number_or_null(fraction)},
          {"text", text},
          {"waiting", waiting}};
}

std::string rpc_notification(const std::string& method, const OrderedJson& params) {
  return json_text(OrderedJson{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}}, -1);
}

std::optional<RpcRequest> short_request(const std::string& text, const std::string& method) {
  if (text.size() > kMaxShortRequest || text.find(method) == std::string::npos) return std::nullopt;
  RpcMessage message = read_rpc(text, {});
  if (message.batch || message.requests.front().method != method) return std::nullopt;
  return message.requests.front();
}

}  // namespace thenar
