// Tests for data/io/mesh/bounded_process.cpp and reader_answer.cpp: programs that misbehave.

#include "data/io/mesh/bounded_process.h"

#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fcntl.h>

#include "base/error.h"
#include "data/io/mesh/reader_answer.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::EndsWith;

ProcessEnd run_shell(const std::string& script, double seconds = 20) {
  return run_bounded({"/bin/sh", "-c", script}, seconds, 1000);
}

TEST(BoundedProcess, GivesOutputAndStatus) {
  const ProcessEnd good = run_shell("echo one; echo two");
  EXPECT_EQ(good.output, "one\ntwo\n");
  EXPECT_EQ(good.failure(), "");
  EXPECT_EQ(run_shell("exit 3").failure(), "ended with status 3");
  EXPECT_THROW((void)run_bounded({"/nowhere/program"}, 1, 1), InputError);
}

TEST(BoundedProcess, SurvivesACrash) {
  EXPECT_EQ(run_shell("kill -SEGV $$").failure(), "crashed (Segmentation fault)");
  EXPECT_EQ(run_shell("kill -KILL $$").failure(), "was killed");
}

TEST(BoundedProcess, EndsWhatTakesTooLongOrSaysTooMuch) {
  EXPECT_EQ(run_shell("exec sleep infinity", 0.1).failure(), "took too long");
  const ProcessEnd endless = run_shell("while :; do echo more; done");
  EXPECT_EQ(endless.failure(), "gave too much");
  EXPECT_LE(endless.output.size(), 1000U + (1U << 16));
}

// Neither files that we hold open nor signals that we ignore come along.
TEST(BoundedProcess, InheritsNothing) {
  const int open_file = open("/dev/null", O_RDONLY);  // without O_CLOEXEC
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  EXPECT_EQ(run_shell("for i in 3 4 5 6 7 8 9; do [ -e /proc/$$/fd/$i ] && echo $i; done").output,
            "");
  // A mask in hexadecimal digits, in which SIGPIPE is bit 12.
  EXPECT_THAT(run_shell("grep SigIgn /proc/self/status").output, EndsWith("0000\n"));
  (void)std::signal(SIGPIPE, before);
  (void)close(open_file);
}

TEST(ReaderAnswer, ComesBack) {
  TriangleSoup soup;
  for (int i = 0; i < 6; ++i) soup.corners.emplace_back(i, 0.5 * i, -i);
  EXPECT_EQ(parse_answer(answer_of(soup), "a.dae").corners, soup.corners);
}

TEST(ReaderAnswer, KeepsTheLineOfAMessage) {
  const auto refusal = [](const std::string& message) {
    return message_of<DataError>([&] { (void)parse_answer(answer_of(message), "a:b.dae"); });
  };
  EXPECT_EQ(refusal("a:b.dae:12: no\nmesh"), "a:b.dae:12: no mesh");
  EXPECT_EQ(refusal("out of memory"), "a:b.dae:1: out of memory");
  EXPECT_LT(refusal(std::string(100'000, 'x')).size(), 1000U);
}

// No byte of a damaged answer does harm.
TEST(ReaderAnswer, IsNotTrusted) {
  TriangleSoup soup;
  soup.corners.assign(3, {1, 2, 3});
  const std::string answer = answer_of(soup);
  for (std::size_t i = 0; i < answer.size(); ++i) {
    EXPECT_THROW((void)parse_answer(answer.substr(0, i), "a"), DataError);
    const bool number = i >= 25 && i < 25 + 36;  // any float may stand there
    std::string other = answer;
    other[i] = static_cast<char>(~other[i]);
    if (number) continue;
    EXPECT_THROW((void)parse_answer(other, "a"), DataError) << i;
  }
}

}  // namespace
}  // namespace thenar
