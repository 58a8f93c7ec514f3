// HDF5 and netCDF files that were made to overrun, not to hold anything: each is refused by a
// message before memory is taken. HDF5 itself makes them, since netCDF would refuse to.

#include <fstream>
#include <memory>

#include <gtest/gtest.h>
#include <hdf5.h>
#include <hdf5_hl.h>
#include <netcdf.h>

#include "base/error.h"
#include "data/io/hdf5_guard.h"
#include "data/io/inference_file.h"
#include "data/io/result_file.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

class CraftedHdf5 : public TemporaryFolder {
 protected:
  CraftedHdf5() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

  /// What read_result() says of a file that `fill` makes, behind the path.
  template <typename Fill>
  std::string refusal(const Fill& fill) {
    const std::string file = path("a.h5");
    const hid_t h5 = H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    fill(h5);
    H5Fclose(h5);
    const std::string said = message_of<DataError>([&] { (void)read_result(file); });
    return said.compare(0, file.size() + 4, file + ":1: ") == 0 ? said.substr(file.size() + 4)
                                                                : said;
  }
};

hid_t text_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);  // as ours are
  return type;
}

/// An attribute of so many texts.
void put_texts(hid_t at, const char* name, const std::vector<const char*>& texts) {
  const hsize_t length = texts.size();
  const hid_t type = text_type(), space = H5Screate_simple(1, &length, nullptr);
  const hid_t attribute = H5Acreate2(at, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, type, texts.data());
  H5Aclose(attribute);
  H5Sclose(space);
  H5Tclose(type);
}

/// Marks a file as ours, of a version without checksums.
void mark(hid_t h5) { put_texts(h5, "program", {"thenar"}); }

/// An array that is promised, not written.
hid_t promise(hid_t h5, const char* name, hid_t type, const std::vector<hsize_t>& shape,
              hid_t made = H5P_DEFAULT) {
  const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
  const hid_t dataset = H5Dcreate2(h5, name, type, space, H5P_DEFAULT, made, H5P_DEFAULT);
  H5Sclose(space);
  return dataset;
}

void write_ones(hid_t dataset, std::size_t count) {
  const std::vector<double> ones(count, 1.0);
  H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, ones.data());
}

// The library writes one pointer for each text to where there was room for one: the stack.
TEST_F(CraftedHdf5, AttributesOfManyTextsAreNotReadIntoOne) {
  const std::vector<const char*> many(400, "AAAAAAAA");
  EXPECT_EQ(refusal([&](hid_t h5) { put_texts(h5, "program", many); }),
            "wanted attribute 'program' as one text of variable length, got something else");
  EXPECT_EQ(refusal([&](hid_t h5) {
              mark(h5);
              const hid_t x = promise(h5, "x", H5T_NATIVE_DOUBLE, {1});
              write_ones(x, 1);
              put_texts(x, "units", many);
              H5Dclose(x);
            }),
            "wanted attribute 'units' as one text of variable length, got something else");
}

TEST_F(CraftedHdf5, AttributesThatAreNoTextAreRefused) {
  for (const bool number : {true, false})
    EXPECT_EQ(refusal([&](hid_t h5) {
                if (number) {
                  const double value = 1;
                  H5LTset_attribute_double(h5, "/", "program", &value, 1);
                } else {
                  H5LTset_attribute_string(h5, "/", "program", "thenar");  // of fixed length
                }
              }),
              "wanted attribute 'program' as one text of variable length, got something else");
}

// 8 GB in a file of 2 kB: contiguous, or in pieces of which there is none.
TEST_F(CraftedHdf5, ArraysBeyondTheFileAreRefused) {
  const std::vector<hsize_t> large{1'000'000'000};
  const std::string beyond = "'x' promises more bytes than are left of the file's";
  EXPECT_EQ(refusal([&](hid_t h5) {
              mark(h5);
              H5Dclose(promise(h5, "x", H5T_NATIVE_DOUBLE, large));
            }).substr(0, beyond.size()),
            beyond);
  EXPECT_EQ(refusal([&](hid_t h5) {
              mark(h5);
              const hid_t made = H5Pcreate(H5P_DATASET_CREATE);
              const hsize_t piece = 1000;
              H5Pset_chunk(made, 1, &piece);
              H5Dclose(promise(h5, "x", H5T_NATIVE_DOUBLE, large, made));
              H5Pclose(made);
            }).substr(0, beyond.size()),
            beyond);
  // The product of its lengths is 0 modulo 2^64.
  EXPECT_EQ(refusal([&](hid_t h5) {
              mark(h5);
              const hid_t made = H5Pcreate(H5P_DATASET_CREATE);
              const hsize_t piece[] = {1, 1, 1};
              H5Pset_chunk(made, 3, piece);
              H5Dclose(promise(h5, "x", H5T_NATIVE_DOUBLE,
                               {hsize_t{1} << 31, hsize_t{1} << 31, hsize_t{1} << 31}, made));
              H5Pclose(made);
            }).substr(0, beyond.size()),
            beyond);
}

// A piece of 800 MB is unpacked for ten values.
TEST_F(CraftedHdf5, PiecesBeyondTheFileAreRefused) {
  const std::string said = refusal([&](hid_t h5) {
    mark(h5);
    const hid_t made = H5Pcreate(H5P_DATASET_CREATE);
    const hsize_t piece = 100'000'000, ten = 10, unlimited = H5S_UNLIMITED;
    H5Pset_chunk(made, 1, &piece);
    const hid_t space = H5Screate_simple(1, &ten, &unlimited);
    H5Dclose(H5Dcreate2(h5, "x", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, made, H5P_DEFAULT));
    H5Sclose(space);
    H5Pclose(made);
  });
  EXPECT_EQ(said.find("a piece of 'x' promises more bytes"), 0U) << said;
}

TEST_F(CraftedHdf5, WhatWasNeverWrittenIsNoResult) {
  EXPECT_EQ(refusal([&](hid_t h5) {
              mark(h5);
              H5Dclose(promise(h5, "x", H5T_NATIVE_DOUBLE, {4}));
            }),
            "'x' was never written");
}

TEST_F(CraftedHdf5, ArraysOfOtherFilesAreNotOpened) {
  std::ofstream(path("secret"), std::ios::binary) << "12345678";
  EXPECT_EQ(refusal([&](hid_t h5) {
              mark(h5);
              const hid_t made = H5Pcreate(H5P_DATASET_CREATE);
              H5Pset_external(made, path("secret").c_str(), 0, 8);
              H5Dclose(promise(h5, "x", H5T_NATIVE_DOUBLE, {1}, made));
              H5Pclose(made);
            }),
            "'x' does not lie in the file");
}

TEST_F(CraftedHdf5, OnlyNumbersOf64BitsAndListsOfTextsAreRead) {
  EXPECT_EQ(refusal([&](hid_t h5) {
              mark(h5);
              H5Dclose(promise(h5, "x", H5T_NATIVE_INT, {1}));
            }),
            "wanted 'x' as numbers of 64 bits or as texts, got something else");
  EXPECT_EQ(refusal([&](hid_t h5) {
              mark(h5);
              H5Dclose(promise(h5, "x", H5T_NATIVE_DOUBLE, {1, 1, 1, 1}));
            }),
            "'x' has 4 dimensions, wanted at most 3");
  EXPECT_EQ(refusal([&](hid_t h5) {
              mark(h5);
              const hid_t type = text_type();
              H5Dclose(promise(h5, "x", type, {2, 2}));
              H5Tclose(type);
            }),
            "the texts 'x' have 2 dimensions, wanted a list");
}

// The library walks over groups by recursion.
TEST_F(CraftedHdf5, GroupsThatNestDeepAreRefused) {
  EXPECT_EQ(refusal([&](hid_t h5) {
              mark(h5);
              hid_t at = H5Gcreate2(h5, "g", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
              for (int i = 0; i < 50; ++i) {
                const hid_t next = H5Gcreate2(at, "g", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
                H5Gclose(at);
                at = next;
              }
              H5Gclose(at);
            }),
            "groups nest deeper than 8");
}

// A group that holds itself has no end.
TEST_F(CraftedHdf5, GroupsWithinThemselvesAreRefused) {
  EXPECT_EQ(refusal([&](hid_t h5) {
              mark(h5);
              H5Gclose(H5Gcreate2(h5, "g", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
              H5Lcreate_hard(h5, "g", h5, "g/g", H5P_DEFAULT, H5P_DEFAULT);
            }),
            "groups nest deeper than 8");
}

/// netCDF files as ours were before they had checksums, with something odd in them.
class CraftedInference : public TemporaryFolder {
 protected:
  /// What read_inference() says of a file with a group that `fill` fills, behind the path.
  /// @param fill  is given the file and the group
  template <typename Fill>
  std::string refusal(const Fill& fill) {
    const std::string file = path("a.nc");
    int id = 0, group = 0;
    nc_create(file.c_str(), NC_NETCDF4 | NC_CLOBBER, &id);
    nc_put_att_text(id, NC_GLOBAL, "program", 6, "thenar");
    nc_def_grp(id, "posterior", &group);
    fill(id, group);
    nc_close(id);
    const std::string said = message_of<DataError>([&] { (void)read_inference(file); });
    return said.compare(0, file.size() + 4, file + ":1: ") == 0 ? said.substr(file.size() + 4)
                                                                : said;
  }
};

int put_dimension(int group, const char* name, std::size_t length) {
  int dimension = 0;
  nc_def_dim(group, name, length, &dimension);
  return dimension;
}

int put_variable(int group, const char* name, nc_type type, const std::vector<int>& over) {
  int variable = 0;
  nc_def_var(group, name, type, static_cast<int>(over.size()), over.data(), &variable);
  if (type != NC_STRING) nc_def_var_fill(group, variable, NC_NOFILL, nullptr);
  return variable;
}

TEST_F(CraftedInference, FilesWithoutChecksumAreReadAsBefore) {
  EXPECT_EQ(refusal([](int /*file*/, int group) {
              const int draw = put_dimension(group, "draw", 3);
              const int x = put_variable(group, "x", NC_DOUBLE, {draw});
              const double values[] = {1, 2, 3};
              nc_put_var_double(group, x, values);
            }),
            "nothing was thrown");
  EXPECT_EQ(read_inference(path("a.nc")).groups.at("posterior").arrays.at("x").values,
            (std::vector<double>{1, 2, 3}));
}

// A variable with the name of a dimension was taken to have its length: 998 of these thousand
// texts were written behind the end of the heap's block.
TEST_F(CraftedInference, CoordinatesLieAlongTheirOwnDimension) {
  EXPECT_EQ(refusal([](int /*file*/, int group) {
              const int chain = put_dimension(group, "chain", 2);
              const int draw = put_dimension(group, "draw", 500);
              const int labels = put_variable(group, "chain", NC_STRING, {chain, draw});
              std::vector<const char*> texts(1000, "AAAAAAAA");
              nc_put_var_string(group, labels, texts.data());
            }),
            "the coordinate 'chain' lies along 'chain', 'draw', not along its own dimension");
}

// The message was "map::at".
TEST_F(CraftedInference, DimensionsBelongToTheGroup) {
  EXPECT_EQ(refusal([](int file, int group) {
              const int outer = put_dimension(file, "outer", 3);
              const int x = put_variable(group, "x", NC_DOUBLE, {outer});
              const double values[] = {1, 2, 3};
              nc_put_var_double(group, x, values);
            }),
            "'x' lies along 'outer', which is not a dimension of its group");
}

TEST_F(CraftedInference, ArraysBeyondTheFileAreRefused) {
  for (const int power : {30, 32}) {  // 2^60 values, and 2^64, which is 0 in 64 bits
    const std::string said = refusal([&](int /*file*/, int group) {
      const int a = put_dimension(group, "a", std::size_t{1} << power);
      const int b = put_dimension(group, "b", std::size_t{1} << power);
      (void)put_variable(group, "x", NC_BYTE, {a, b});
    });
    EXPECT_NE(said.find("promises more"), std::string::npos) << said;
  }
}

TEST_F(CraftedInference, OnlyNumbersOfOursAreRead) {
  EXPECT_EQ(refusal([](int /*file*/, int group) { (void)put_variable(group, "x", NC_STRING, {}); }),
            "wanted 'x' as numbers of 64 bits or as bytes, got something else");
}

}  // namespace
namespace {

constexpr int kSeconds = 10;

std::string said_of(const std::function<void()>& work) {
  return message_of<DataError>([&] { try_in_fork("a.h5", kSeconds, work); });
}

// What is done in the copy is not seen here: the count stays.
TEST(TrialRun, LeavesNothingBehind) {
  int count = 0;
  EXPECT_EQ(said_of([&] { ++count; }), "nothing was thrown");
  EXPECT_EQ(count, 0);
}

#ifndef __SANITIZE_ADDRESS__  // under which there is no limit of memory
TEST(TrialRun, RefusesWhatNeedsMoreMemory) {
  const auto greedy = [] {
    constexpr std::size_t kBytes = std::size_t{3} << 30U;
    const std::unique_ptr<char[]> many(new char[kBytes]);  // NOLINT(*-avoid-c-arrays)
    *static_cast<volatile char*>(many.get()) = 1;
  };
  EXPECT_EQ(said_of(greedy), "a.h5:1: reading it takes more than 1000 MB of memory");
}
#endif

TEST(TrialRun, TellsWhatTheWorkThrew) {
  EXPECT_EQ(said_of([] { throw DataError("a.h5", 1, "wanted a number"); }),
            "a.h5:1: wanted a number");
  EXPECT_EQ(said_of([] { throw InputError("wanted a number"); }), "a.h5:1: wanted a number");
  const std::string endless(10'000, 'x');
  EXPECT_EQ(said_of([&] { throw InputError(endless); }), "a.h5:1: " + endless.substr(0, 4000));
}

TEST(TrialRun, SaysWhereItCrashes) {
  EXPECT_EQ(said_of([] { std::abort(); }), "a.h5:1: it is damaged: reading it crashes (Aborted)");
}

}  // namespace
}  // namespace thenar
