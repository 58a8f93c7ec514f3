// What is answered to requests of HTTP.

#include "server/web_pages.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace thenar {
namespace {

using testing::HasSubstr;

const ServerAccess kFree{"127.0.0.1", 0, ""};
const ServerAccess kGuarded{"127.0.0.1", 0, "0123456789abcdef"};

HttpRequest get(const std::string& target) { return {"GET", target, "127.0.0.1:80", "", ""}; }

HttpResponse ask(const HttpRequest& question, const ServerAccess& access = kFree) {
  return respond_to(access, 80, question, [](const std::string& id) {
    return id == "abc" ? std::make_shared<const std::string>("bytes") : nullptr;
  });
}

std::string header(const HttpResponse& answer, const std::string& name) {
  for (const auto& [key, value] : answer.headers)
    if (key == name) return value;
  return "";
}

TEST(HttpStart, WaitsForAMethodAndHangsUpOnAnythingElse) {
  for (const char* text : {"", "G", "GET", "O", "OPTIONS", "P", "PA"})
    EXPECT_EQ(http_start(text), HttpStart::kOpen) << text;
  for (const char* text : {"GET ", "GET / HTTP/1.1\r\n", "HEAD /", "PATCH / "})
    EXPECT_EQ(http_start(text), HttpStart::kMethod) << text;
  for (const char* text :
       {"get ", "GETS /", "GET\t/", "\x16\x03\x01", "SSH-2.0", "EHLO x", "{", "\r\nGET /"})
    EXPECT_EQ(http_start(text), HttpStart::kOther) << text;
}

TEST(WebPages, GivesThePageWithItsHeaders) {
  const HttpResponse answer = ask(get("/"));
  EXPECT_EQ(answer.status, 200);
  EXPECT_THAT(answer.body, HasSubstr("live.js"));
  EXPECT_THAT(header(answer, "Content-Security-Policy"), HasSubstr("default-src 'self'"));
  EXPECT_THAT(header(answer, "Content-Security-Policy"), HasSubstr("ws://127.0.0.1:80"));
  EXPECT_THAT(header(answer, "Content-Type"), HasSubstr("text/html"));
  EXPECT_THAT(header(ask(get("/live.js")), "Content-Type"), HasSubstr("text/javascript"));
  EXPECT_THAT(header(ask(get("/live.css")), "Content-Type"), HasSubstr("text/css"));
  EXPECT_EQ(ask(get("/favicon.ico")).status, 204);
}

TEST(WebPages, GivesMeshesAndNothingElse) {
  const HttpResponse answer = ask(get("/mesh/abc"));
  EXPECT_EQ(*answer.mesh, "bytes");
  EXPECT_THAT(header(answer, "Cache-Control"), HasSubstr("immutable"));
  for (const char* target :
       {"/mesh/", "/mesh/abcd", "/mesh/../live.js", "/..", "", "*", "/etc/passwd", "//"})
    EXPECT_EQ(ask(get(target)).status, 404) << target;
}

TEST(WebPages, PutsNothingOfTheQuestionIntoARefusal) {
  HttpRequest question = get("/");
  question.host = "evil.example\r\nX: y";
  const HttpResponse answer = ask(question);
  EXPECT_EQ(answer.status, 403);
  for (const auto& [key, value] : answer.headers) EXPECT_EQ(value.find("evil"), std::string::npos);
  EXPECT_EQ(answer.body.find("evil"), std::string::npos);
}

TEST(WebPages, WantsTheTokenForEveryFile) {
  for (const char* target : {"/", "/live.js", "/mesh/abc", "/nothing"})
    EXPECT_EQ(ask(get(target), kGuarded).status, 401) << target;
  const HttpResponse page = ask(get("/?token=0123456789abcdef"), kGuarded);
  EXPECT_EQ(page.status, 200);
  EXPECT_THAT(header(page, "Set-Cookie"), HasSubstr("thenar_80=0123456789abcdef; "));
  EXPECT_EQ(header(ask(get("/")), "Set-Cookie"), "");
  HttpRequest question = get("/live.js");
  question.cookie = "other=1; thenar_80=0123456789abcdef";
  EXPECT_EQ(ask(question, kGuarded).status, 200);
  question.cookie = "thenar_81=0123456789abcdef";  // of a server at another port
  EXPECT_EQ(ask(question, kGuarded).status, 401);
}

TEST(WebPages, TakesNoOtherMethods) {
  HttpRequest question = get("/");
  for (const char* method : {"POST", "OPTIONS", "PUT", "", "get"}) {
    question.method = method;
    EXPECT_EQ(ask(question).status, 405) << method;
  }
}

TEST(WebPages, OpensSocketsToItsOwnPages) {
  HttpRequest question = get("/ws");
  EXPECT_FALSE(socket_refusal_of(kFree, 80, question));
  question.origin = "http://127.0.0.1:80";
  EXPECT_FALSE(socket_refusal_of(kFree, 80, question));
  EXPECT_EQ(socket_refusal_of(kGuarded, 80, question)->status, 401);
  question.origin = "http://evil.example";
  EXPECT_EQ(socket_refusal_of(kFree, 80, question)->status, 403);
  // A name that was turned into this machine's address is the origin of its own page.
  question.host = "evil.example:80";
  question.origin = "http://evil.example:80";
  EXPECT_EQ(socket_refusal_of(kFree, 80, question)->status, 403);
}

}  // namespace
}  // namespace thenar
