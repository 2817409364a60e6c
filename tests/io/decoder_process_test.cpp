// Packed frames are unpacked in a process of their own: how it ends, and who is told.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>

#include "dicom_files.h"
#include "ew/io/dicom.h"
#include "ew/io/image_stack.h"
#include "packed_images.h"

namespace ew::decoder_process_test {
namespace {
using namespace test;

CineOf packedCine(int frames, int damagedFrame = -1) {
  CineOf of;
  of.syntax = kJpegLossless;
  of.columns = of.rows = 64;
  of.frames = static_cast<std::uint16_t>(frames);
  of.regions = {{0, 0, 63, 63}};
  const std::string whole = packedBy<gdcm::JPEGCodec>(std::string(64 * 64, '\x55'), 64, 64, 1, 8);
  of.packed.assign(static_cast<std::size_t>(frames), whole);
  if (damagedFrame >= 0) of.packed[static_cast<std::size_t>(damagedFrame)] = whole.substr(0, whole.size() / 2);
  return of;
}

/// SIGCHLD ignored, as some daemons and container starters pass it on to their children.
class ChildrenIgnored {
 public:
  ChildrenIgnored() : before_(signal(SIGCHLD, SIG_IGN)) {}
  ~ChildrenIgnored() { signal(SIGCHLD, before_); }
  ChildrenIgnored(const ChildrenIgnored&) = delete;
  ChildrenIgnored& operator=(const ChildrenIgnored&) = delete;

 private:
  void (*before_)(int);
};

TEST(DecoderProcess, WhoseEndNobodyIsToldOfGivesItsImageOrAnErrorAndNeverABlackOne) {
  const TempFolder folder;
  const auto good = folder.put("good.dcm", cineFile(packedCine(3)));
  const auto bad = folder.put("bad.dcm", cineFile(packedCine(3, 1)));
  const ChildrenIgnored ignored;
  const auto read = readDicomCine(good);
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->sequence.pixels, std::vector<std::uint8_t>(3 * 64 * 64, 0x55));
  const auto refused = readDicomCine(bad);
  if (refused) {
    EXPECT_EQ(refused->sequence.pixels, std::vector<std::uint8_t>(3 * 64 * 64, 0x55)) << "a frame that could not be unpacked is not black";
  }
}

/// As the command line hears Ctrl-C.
class Interrupt final : public Progress {
 public:
  Interrupt() {
    heard = 0;
    struct sigaction action {};
    action.sa_handler = [](int) { heard = 1; };
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
  }
  void report(const Message&, double) override {}
  [[nodiscard]] bool cancelRequested() const override { return heard != 0; }

 private:
  static volatile sig_atomic_t heard;
};
volatile sig_atomic_t Interrupt::heard = 0;

TEST(DecoderProcess, InterruptedTogetherWithTheProgramIsAWishToStopAndNoDamage) {
  const TempFolder folder;
  const auto file = folder.put("long.dcm", cineFile(packedCine(2000)));
  for (int attempt = 0; attempt < 3; ++attempt) {
    int started[2];
    ASSERT_EQ(pipe(started), 0);
    const pid_t reader = fork();
    ASSERT_GE(reader, 0);
    if (reader == 0) {
      setpgid(0, 0);  // a terminal's group of its own: the program and whatever it starts
      Interrupt interrupt;
      static_cast<void>(write(started[1], "x", 1));
      const auto read = readDicomCine(file, {}, interrupt);
      _exit(read ? 1 : read.error().code == ErrorCode::cancelled ? 0 : 2);
    }
    char byte = 0;
    ASSERT_EQ(::read(started[0], &byte, 1), 1);
    usleep(static_cast<useconds_t>(30000 + 7000 * attempt));
    kill(-reader, SIGINT);
    int status = -1;
    ASSERT_EQ(waitpid(reader, &status, 0), reader);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_NE(WEXITSTATUS(status), 2) << "Ctrl-C was taken for a damaged frame";
    close(started[0]);
    close(started[1]);
  }
}

TEST(DecoderProcess, IsNotWaitedForAfterTheWishToStop) {
  const TempFolder folder;
  const auto jpeg = packedBy<gdcm::JPEGCodec>(std::string(64 * 64, '\x55'), 64, 64, 1, 8, false);
  static_cast<void>(folder.put("a1.jpg", jpeg));
  StackOptions options;
  options.spacing_mm = glm::dvec3(1.0);
  EXPECT_TRUE(readImageStack(folder.path(), options));
  // Asked once before the image; every later question comes while its decoder is at work.
  StopAfter atOnce(0);
  EXPECT_TRUE(failedWith(readImageStack(folder.path(), options, atOnce), ErrorCode::cancelled));
  StopAfter meanwhile(1);
  const auto read = readImageStack(folder.path(), options, meanwhile);
  if (!read) {  // a decoder may be done before anybody asks
    EXPECT_EQ(read.error().code, ErrorCode::cancelled) << read.error();
  }
}

}  // namespace
}  // namespace ew::decoder_process_test
