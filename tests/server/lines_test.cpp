// Lines out of bytes that come in pieces.

#include "server/lines.h"

#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace thenar {
namespace {

/// Lines of a text that comes in pieces of any size; "!" stands for one that is too long.
std::vector<std::string> lines_of(const std::string& text, std::size_t most, unsigned seed) {
  std::mt19937 rng(seed);
  LineSplitter splitter(most);
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t count = std::min<std::size_t>(text.size() - at, 1 + rng() % 7);
    splitter.add(text.data() + at, count);
    at += count;
    while (const auto line = splitter.next_line())
      lines.push_back(line->too_long ? "!" : line->text);
  }
  if (const auto line = splitter.take_rest()) lines.push_back(line->text);
  return lines;
}

TEST(LineSplitter, DoesNotDependOnThePieces) {
  const std::string text =
      "one\n\n  \r\ntwo\r\n" + std::string(30, 'x') + "\nthree\n" + std::string(11, 'y') + "\nfour";
  for (unsigned seed = 0; seed < 200; ++seed)
    EXPECT_THAT(lines_of(text, 10, seed),
                testing::ElementsAre("one", "two\r", "!", "three", "!", "four"));
}

TEST(LineSplitter, DropsTheRestOfALineThatIsTooLong) {
  EXPECT_THAT(lines_of(std::string(100, 'x'), 10, 1), testing::ElementsAre("!"));
  EXPECT_THAT(lines_of("", 10, 1), testing::IsEmpty());
  EXPECT_THAT(lines_of("\n\n", 10, 1), testing::IsEmpty());
}

TEST(StreamStart, TellsRequestsFromEverythingElse) {
  for (const char* text : {"{", "[", " {", "\r\n\t[1]"})
    EXPECT_EQ(stream_start(text), StreamStart::kRequest) << text;
  for (const char* text : {"", " ", "\r\n\t "}) EXPECT_EQ(stream_start(text), StreamStart::kBlank);
  for (const char* text :
       {"GET /", " POST", "\x16\x03\x01", "SSH-2.0", "\"x\"", "1", "\xEF\xBB\xBF{"})
    EXPECT_EQ(stream_start(text), StreamStart::kOther) << text;
  EXPECT_EQ(stream_start(std::string_view("\0{", 2)), StreamStart::kOther);
}

}  // namespace
}  // namespace thenar
