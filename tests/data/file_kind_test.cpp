// Tests for data/io/file_kind.cpp.

#include "data/io/file_kind.h"

#include <fstream>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/data_folder.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

class FileKinds : public TemporaryFolder {
 protected:
  [[nodiscard]] std::string written(const std::string& text) const {
    const std::string file = path("some.toml");
    std::ofstream(file) << text;
    return file;
  }
};

TEST_F(FileKinds, AreToldByWhatDataFilesHold) {
  EXPECT_EQ(find_file_kind(kData + "/subjects/an_chao_middle.toml"), FileKind::kSubject);
  EXPECT_EQ(find_file_kind(kData + "/subjects/valero_cuevas_index.toml"), FileKind::kSubject);
  EXPECT_EQ(find_file_kind(kData + "/experiments/synek2019_H01.toml"), FileKind::kExperiment);
  EXPECT_EQ(find_file_kind(kData + "/fits/finger.toml"), FileKind::kFitSettings);
  EXPECT_EQ(find_file_kind(kData + "/anthropometry/buchholz1992.toml"), FileKind::kProportions);
  EXPECT_EQ(find_file_kind(kData + "/studies/thumb_axes_variability.toml"),
            FileKind::kAxisVariability);
  EXPECT_EQ(find_file_kind(kData + "/studies/key_pinch_blocks.toml"), FileKind::kPinchLosses);
  EXPECT_EQ(find_file_kind(kData + "/nets/winslow.toml"), FileKind::kNet);
  EXPECT_EQ(find_file_kind(kData + "/objects/mug.toml"), FileKind::kObject);
  EXPECT_EQ(find_file_kind(kData + "/worlds/jaw_box.toml"), FileKind::kWorld);
  EXPECT_EQ(find_file_kind(kData + "/scenes/pinch.toml"), FileKind::kScene);
  EXPECT_EQ(find_file_kind(kData + "/pads/index_pad.toml"), FileKind::kPad);
  EXPECT_EQ(find_file_kind(kData + "/pads/laws/index_pad.toml"), FileKind::kPadLaws);
  EXPECT_EQ(find_file_kind(kData + "/presses/index_published.toml"), FileKind::kPadPresses);
  EXPECT_EQ(find_file_kind(kData + "/materials.toml"), FileKind::kMaterials);
  EXPECT_EQ(find_file_kind(kData + "/robots/barrett.toml"), FileKind::kRobot);
}

TEST_F(FileKinds, OfResultsAreToldByTheirFirstBytes) {
  EXPECT_EQ(find_file_kind(written("\x89HDF\r\n\x1a\n and more")), FileKind::kResult);
}

TEST_F(FileKinds, AreRefusedWhereThereIsNone) {
  EXPECT_THROW((void)find_file_kind(written("name = \"x\"\n")), DataError);
  EXPECT_THROW((void)find_file_kind(kData + "/nowhere.toml"), DataError);
}

}  // namespace
}  // namespace thenar
