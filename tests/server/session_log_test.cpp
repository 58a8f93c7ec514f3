// Tests for server/session_log.cpp: logs that are read as they were written.

#include "server/session_log.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file_io.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using SessionLogTest = TemporaryFolder;

LoggedRequest lift(double height) {
  LoggedRequest request;
  request.client = 2;
  request.method = "small.lift";
  request.params = {{"height", height}};
  request.reply = reply_hash({{"height", height}});
  return request;
}

// SHA-256 of the two characters {}, and of a number down to its last bit.
TEST_F(SessionLogTest, HashesAreOfTheText) {
  EXPECT_EQ(reply_hash(OrderedJson::object()),
            "44136fa355b3678a1146ad16f7e8649e94fb4fc21fe77e8310c060f61caaff8a");
  EXPECT_EQ(reply_hash({{"a", 0.1}}), reply_hash({{"a", 0.1}}));
  EXPECT_NE(reply_hash({{"a", 0.1}}), reply_hash({{"a", std::nextafter(0.1, 1)}}));
}

TEST_F(SessionLogTest, LeavesOutWhatChangesNothing) {
  EXPECT_FALSE(is_logged("session.status"));
  EXPECT_FALSE(is_logged("job.result"));
  EXPECT_TRUE(is_logged("session.undo"));
  EXPECT_TRUE(is_logged(kJobEnd));
}

// What was added before the file was named stands in it, then each line at once.
TEST_F(SessionLogTest, ReadsWhatItWrote) {
  const std::string file = path("session.log");
  SessionLog log;
  LoggedRequest stopped = lift(0.1);
  stopped.stopped_at = 7;
  log.add(stopped);
  log.open(file);
  log.add(lift(1.0 / 3));
  const std::vector<LoggedRequest> read = read_log(file);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].stopped_at, 7);
  EXPECT_EQ(read[0].client, 2);
  EXPECT_FALSE(read[1].stopped_at.has_value());
  EXPECT_EQ(read[1].params["height"].get<double>(), 1.0 / 3);
  EXPECT_EQ(read[1].method, "small.lift");
  EXPECT_EQ(read[1].reply, lift(1.0 / 3).reply);
  EXPECT_EQ(log.text(), read_file(file, 10000));
}

TEST_F(SessionLogTest, IsEmptyBeforeAnyRequest) { EXPECT_EQ(SessionLog().text(), ""); }

// A named file holds whole lines up to its limit, says once that it is full, and stays as it is.
TEST_F(SessionLogTest, EndsWhereItIsFull) {
  const std::string file = path("full.log");
  SessionLog first;
  first.add(lift(0.5));
  const std::size_t line = first.text().size();
  SessionLog log(3 * line);
  log.open(file);
  for (int i = 0; i < 3; ++i) log.add(lift(0.5));
  EXPECT_EQ(message_of([&] { log.add(lift(0.5)); }),
            "the log " + file + " is full (" + std::to_string(3 * line) +
                " bytes): this request and those after it are not in it");
  EXPECT_EQ(message_of([&] { log.add(lift(0.5)); }), "nothing was thrown");
  EXPECT_EQ(read_log(file).size(), 3U);
}

TEST_F(SessionLogTest, NamesTheLineThatIsNone) {
  const std::string file = path("broken.log");
  SessionLog log;
  log.add(lift(0.5));
  std::ofstream(file) << log.text() << "{\"client\": 1}\n";
  const std::string message = message_of<DataError>([&] { (void)read_log(file); });
  EXPECT_EQ(message.find(file + ":2: no line of a session's log"), 0U) << message;
}

// A log cannot take the place of a folder, nor go where a link leads that leads nowhere yet.
TEST_F(SessionLogTest, RefusesFoldersAndLinksToNowhere) {
  SessionLog log;
  const std::string folder = message_of([&] { log.open(folder_.string()); });
  EXPECT_NE(folder.find(folder_.string()), std::string::npos) << folder;
  std::filesystem::create_symlink(path("nowhere"), path("link"));
  EXPECT_EQ(message_of([&] { log.open(path("link")); }),
            "cannot write " + path("link") + ": it is a link to a file that is not there");
}

}  // namespace
}  // namespace thenar
