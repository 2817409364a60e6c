#include <gtest/gtest.h>

#include "dicom_files.h"
#include "ew/io/dicom.h"
#include "ew/io/image_stack.h"
#include "ew/io/mapped_volume.h"
#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"
#include "files.h"
#include "open_files_limit.h"

// A program that has as many files open as it may have: neither permissions nor room on the disk are what is missing.

namespace ew::open_files_test {
namespace {
using namespace test;

constexpr const char* kTooMany = "too many files are open at the moment; close other windows or programs and try again.";

/// What went wrong; of what did not, nothing.
template <class T>
Error errorOf(const Result<T>& result) {
  return result ? Error{} : result.error();
}

/// What `work` gives while no file can be opened. Nothing is checked meanwhile: a failing check writes files.
template <class Work>
auto withoutFiles(const Work& work) {
  const NoMoreOpenFiles none;
  EXPECT_TRUE(none.isTight());
  return work();
}

TEST(OpenFiles, ReadersSayThatTooManyAreOpen) {
  if (kSanitizerOpensFiles) GTEST_SKIP() << "the sanitizer needs files of its own";
  const TempFolder folder;
  CineOf cine;
  cine.pixels = ramp(144);
  const auto dicom = folder.put("a.dcm", cineFile(cine));
  const auto nrrd =
      folder.put("a.nrrd", "NRRD0005\ntype: uchar\ndimension: 3\nsizes: 2 3 2\nencoding: raw\nspacings: 2 2 2\n\n" + ramp(12));
  const auto nifti = folder.put("a.nii", std::string(400, '\0'));
  const auto text = folder.put("a.txt", "words");
  const auto reads = withoutFiles([&] {
    return std::vector<Error>{errorOf(readDicomCine(dicom)), errorOf(readVolume(nrrd)),          errorOf(readVolume(nifti)),
                              errorOf(readTextFile(text)),   errorOf(stackFiles(folder.path())), errorOf(mapVolume(nrrd))};
  });
  for (const Error& error : reads) {
    EXPECT_EQ(error.code, ErrorCode::notReadable) << error;
    EXPECT_TRUE(error.sentence().ends_with(kTooMany)) << error;
  }
  EXPECT_TRUE(succeeded(readDicomCine(dicom))) << "and afterwards they read";
  EXPECT_TRUE(succeeded(readVolume(nrrd)));
}

TEST(OpenFiles, WritersSayThatTooManyAreOpenAndLeaveWhatWasThere) {
  if (kSanitizerOpensFiles) GTEST_SKIP() << "the sanitizer needs files of its own";
  const TempFolder folder;
  const auto file = folder / "a.txt";
  ASSERT_TRUE(succeeded(writeFileSafely(file, "before"))) << "which also finds what this machine is called";
  const auto written = withoutFiles([&] { return writeFileSafely(file, "after"); });
  EXPECT_TRUE(failedWith(written, ErrorCode::notWritable));
  EXPECT_TRUE(says(written, kTooMany));
  EXPECT_EQ(bytesOfFile(file), "before");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.txt"});
  EXPECT_TRUE(succeeded(writeFileSafely(file, "after")));
  EXPECT_EQ(bytesOfFile(file), "after");
}

}  // namespace
}  // namespace ew::open_files_test
