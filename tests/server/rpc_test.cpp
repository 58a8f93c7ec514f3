// Messages of JSON-RPC 2.0, read without trust.

#include "server/rpc.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/progress_parts.h"
#include "tests/server/small_model.h"

namespace thenar {
namespace {

std::optional<RpcCode> code_of(const std::string& text, const RpcLimits& limits = {}) {
  const RpcMessage message = read_rpc(text, limits);
  if (!message.requests.front().failure) return std::nullopt;
  return message.requests.front().failure->code;
}

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

TEST(ReadRpc, CountsBeforeItParses) {
  RpcLimits limits;
  limits.bytes = 100;
  EXPECT_EQ(code_of(std::string(101, ' '), limits), RpcCode::kTooLarge);
  EXPECT_EQ(code_of(std::string(100, ' '), limits), RpcCode::kParse);
  EXPECT_EQ(code_of(nested(33)), RpcCode::kTooLarge);
  EXPECT_EQ(code_of(nested(32)), RpcCode::kInvalidRequest);
  EXPECT_EQ(code_of(std::string(1'000'000, '[')), RpcCode::kTooLarge);  // no end, no stack
  limits.bytes = 1000;
  limits.values = 10;
  EXPECT_EQ(code_of("[1,2,3,4,5,6,7,8,9,10]", limits), RpcCode::kInvalidRequest);
  EXPECT_EQ(code_of("[1,2,3,4,5,6,7,8,9,10,11]", limits), RpcCode::kTooLarge);
}

// Brackets and commas in a text are no structure, whatever quotes are escaped in it.
TEST(ReadRpc, CountsNothingInsideOfTexts) {
  RpcLimits limits;
  limits.values = 10;
  const std::string text = R"({"jsonrpc":"2.0","id":1,"method":"[[[[\"]]]{{\\"})";
  EXPECT_EQ(code_of(text, limits), std::nullopt);
  EXPECT_EQ(read_rpc(text, limits).requests.front().method, "[[[[\"]]]{{\\");
}

TEST(ReadRpc, TellsRequestsFromNotifications) {
  const RpcMessage message =
      read_rpc(R"([{"jsonrpc":"2.0","method":"a"},{"jsonrpc":"2.0","method":"b","id":null}])", {});
  ASSERT_EQ(message.requests.size(), 2U);
  EXPECT_TRUE(message.batch);
  EXPECT_TRUE(message.requests[0].notification);
  EXPECT_FALSE(message.requests[1].notification);
}

TEST(ReadRpc, RefusesMembersThatNoRequestHas) {
  EXPECT_EQ(code_of(R"({"jsonrpc":"2.0","id":1,"method":"a","parms":{}})"),
            RpcCode::kInvalidRequest);
  RpcLimits limits;
  limits.requests = 2;
  EXPECT_EQ(code_of("[1,2,3]", limits), RpcCode::kTooLarge);
}

/// The answer of a method that throws.
template <typename Thrown>
RpcAnswer answer_thrown(const Thrown& thrown) {
  MethodTable table;
  table.add({"a.b", "Throws.", object_schema({}), "", "{}",
             [&](Session&, const Json&, const Progress&) -> OrderedJson { throw thrown; }});
  RpcRequest request;
  request.method = "a.b";
  Session session({});
  return answer_request(request, table, session, {});
}

template <typename Thrown>
int code_of_thrown(const Thrown& thrown) {
  return static_cast<int>(answer_thrown(thrown).failure->code);
}

TEST(AnswerRequest, TurnsWhatIsThrownIntoItsCode) {
  EXPECT_EQ(code_of_thrown(InputError("no")), -32000);
  EXPECT_EQ(code_of_thrown(DataError("f", 1, "no")), -32000);
  EXPECT_EQ(code_of_thrown(Stopped("stopped")), -32001);
  EXPECT_EQ(code_of_thrown(std::bad_alloc()), -32002);
  EXPECT_EQ(code_of_thrown(std::logic_error("fault")), -32603);
}

TEST(AnswerRequest, TellsParamsFromWhatIsRefused) {
  const MethodTable table = small_table();
  Session session({});
  RpcRequest request;
  request.method = "small.lift";
  request.params = {{"height", "x"}};
  EXPECT_EQ(answer_request(request, table, session, {}).failure->code, RpcCode::kInvalidParams);
  request.params = {{"height", 0.1}};  // nothing is open
  EXPECT_EQ(answer_request(request, table, session, {}).failure->code, RpcCode::kRefused);
}

TEST(RpcReply, NamesTheFieldThatIsWrong) {
  const auto error_of = [](const InputError& thrown) {
    return rpc_reply(1, answer_thrown(thrown))["error"];
  };
  const OrderedJson error = error_of(InputError("wanted a digit", "digit"));
  EXPECT_EQ(error["message"], "wanted a digit");
  EXPECT_EQ(error["data"]["field"], "digit");
  EXPECT_FALSE(error_of(InputError("no")).contains("data"));
}

// Whatever bytes come in a name of a method, the reply is JSON.
TEST(RpcReply, IsJsonWhateverCame) {
  const RpcAnswer answer{{}, RpcFailure{RpcCode::kRefused, "\xff\xfe\x01\n"}};
  const std::string text = json_text(rpc_reply("\xed\xa0\x80", answer), -1);
  EXPECT_EQ(Json::parse(text)["error"]["code"], -32000);
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST(ShortRequest, IsReadOnlyIfItIsThatMethodAlone) {
  EXPECT_TRUE(short_request(R"({"jsonrpc":"2.0","id":1,"method":"session.stop"})", "session.stop"));
  EXPECT_FALSE(short_request(
      R"({"jsonrpc":"2.0","id":1,"method":"a","params":{"x":"session.stop"}})", "session.stop"));
  EXPECT_FALSE(
      short_request(R"([{"jsonrpc":"2.0","id":1,"method":"session.stop"}])", "session.stop"));
  EXPECT_FALSE(short_request(std::string(600, ' ') + "session.stop", "session.stop"));
  EXPECT_FALSE(short_request("session.stop", "session.stop"));
}

}  // namespace
}  // namespace thenar
