// Who may come in.

#include "server/access.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace thenar {
namespace {

const ServerAccess kHere{"127.0.0.1", 0, ""};

TEST(Access, KnowsItsOwnNames) {
  // A port that is forwarded from another machine keeps that machine's number.
  for (const char* host : {"127.0.0.1:80", "localhost:80", "[::1]:80", "localhost:9000",
                           "127.0.0.1", "localhost", "[::1]"})
    EXPECT_TRUE(is_host_ours(kHere, host)) << host;
  for (const char* host : {"", ":80", "evil.example:80", "evil.example",
                           "127.0.0.1.evil.example:80", "localhost:80:80", "localhost:80a",
                           "localhost.evil.example", "192.0.2.1:80", "[::1]evil:80", "evil:[::1]"})
    EXPECT_FALSE(is_host_ours(kHere, host)) << host;
}

TEST(Access, TakesNumbersAloneWhereItListensEverywhere) {
  const ServerAccess everywhere{"0.0.0.0", 0, "0123456789abcdef"};
  EXPECT_TRUE(is_host_ours(everywhere, "192.0.2.1:80"));
  EXPECT_TRUE(is_host_ours(everywhere, "localhost:80"));
  EXPECT_FALSE(is_host_ours(everywhere, "evil.example:80"));  // it may have been rebound
  const ServerAccess one{"192.0.2.1", 0, "0123456789abcdef"};
  EXPECT_TRUE(is_host_ours(one, "192.0.2.1:80"));
  EXPECT_FALSE(is_host_ours(one, "127.0.0.1:80"));
}

TEST(Access, LetsItsOwnPagesAndNoOthersOpenSockets) {
  EXPECT_TRUE(is_origin_ours("http://localhost:80", "localhost:80"));
  EXPECT_TRUE(is_origin_ours("", "localhost:80"));
  for (const char* origin : {"null", "http://localhost", "https://localhost:80",
                             "http://localhost:80.evil.example", "http://127.0.0.1:80"})
    EXPECT_FALSE(is_origin_ours(origin, "localhost:80")) << origin;
}

TEST(Access, ComparesWholeTokens) {
  EXPECT_TRUE(same_token("abc", "abc"));
  EXPECT_FALSE(same_token("", "abc"));
  EXPECT_FALSE(same_token("ab", "abc"));
  EXPECT_FALSE(same_token("abcabc", "abc"));
  EXPECT_FALSE(same_token("abd", "abc"));
}

TEST(Access, MakesTokensThatDiffer) {
  EXPECT_EQ(random_token().size(), 32U);
  EXPECT_NE(random_token(), random_token());
}

TEST(Access, RefusesOtherMachinesWithoutToken) {
  for (const char* address : {"127.0.0.1", "127.1.2.3", "::1"})
    EXPECT_NO_THROW(require_safe({address, 0, ""})) << address;
  for (const char* address : {"0.0.0.0", "::", "192.0.2.1", "127.evil", "localhost"})
    EXPECT_THROW(require_safe({address, 0, ""}), InputError) << address;
  EXPECT_NO_THROW(require_safe({"0.0.0.0", 0, "0123456789abcdef"}));
  EXPECT_THROW(require_safe({"0.0.0.0", 0, "0123456789abcde"}), InputError);
  EXPECT_THROW(require_safe({"0.0.0.0", 0, "0123456789abcd&f"}), InputError);
}

TEST(Access, FindsValuesByTheirWholeName) {
  EXPECT_EQ(value_in("a=1&token=xyz&b=2", '&', "token"), "xyz");
  EXPECT_EQ(value_in("thenar_1=a; thenar_12=b", ';', "thenar_12"), "b");
  EXPECT_EQ(value_in("mytoken=1", '&', "token"), "");
  EXPECT_EQ(value_in("token", '&', "token"), "");
  EXPECT_EQ(value_in("", '&', "token"), "");
  EXPECT_EQ(value_in("&&;==&token=", '&', "token"), "");
}

}  // namespace
}  // namespace thenar
