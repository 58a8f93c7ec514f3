// Tests for data/io/mesh/reader_answer.cpp: what one side writes the other reads, and nothing else.

#include "data/io/mesh/reader_answer.h"

#include <gmock/gmock.h>

#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::HasSubstr;

TriangleSoup two_triangles() {
  TriangleSoup soup;
  for (int i = 0; i < 6; ++i) soup.corners.emplace_back(0.5 * i, -0.25 * i, 8);  // exact floats
  ShapeSpec ball;
  ball.kind = ShapeKind::kSphere;
  ball.size.x() = 0.1;
  ball.X_BS.p = {1, 2, 3};
  soup.exact = {ball};
  return soup;
}

std::string answer_refusal(const std::string& answer) {
  return message_of<DataError>([&] { (void)parse_answer(answer, "m.wrl"); });
}

TEST(ReaderAnswer, CarriesTrianglesAndShapes) {
  const TriangleSoup sent = two_triangles(), got = parse_answer(answer_of(sent), "m.wrl");
  EXPECT_EQ(got.corners, sent.corners);
  ASSERT_EQ(got.exact.size(), 1U);
  EXPECT_EQ(got.exact[0].size, sent.exact[0].size);
  EXPECT_EQ(got.exact[0].X_BS.p, sent.exact[0].X_BS.p);
}

TEST(ReaderAnswer, MessagesKeepTheirLine) {
  EXPECT_EQ(answer_refusal(answer_of(std::string("m.wrl:12: no mesh"))), "m.wrl:12: no mesh");
  EXPECT_EQ(answer_refusal(answer_of(std::string("no mesh"))), "m.wrl:1: no mesh");
}

TEST(ReaderAnswer, EveryCutIsFound) {
  const std::string whole = answer_of(two_triangles());
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_THAT(answer_refusal(whole.substr(0, size)), HasSubstr("broke off")) << size;
  EXPECT_THAT(answer_refusal(whole + "x"), HasSubstr("broke off"));
}

}  // namespace
}  // namespace thenar
