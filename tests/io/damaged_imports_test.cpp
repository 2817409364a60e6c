#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "dicom_files.h"
#include "ew/io/dicom.h"
#include "ew/io/image_stack.h"
#include "ew/io/kretz.h"
#include "kretz_files.h"

namespace ew::damaged_imports_test {
namespace {
using namespace test;

constexpr ReaderLimits kSmall{8u << 20};

std::string smallCine(const char* syntax) {
  CineOf of;
  of.syntax = syntax;
  of.pixels = ramp(144);
  of.undefinedLengths = true;
  return cineFile(of);
}

std::string smallEnhanced() {
  EnhancedOf of;
  of.pixels = ramp(60);
  of.positions[2] = {1, 2, 8};
  of.times = {0, 0, 0};
  return enhancedFile(of);
}

std::string smallKretz() {
  KretzOf of;
  of.samples = 6;
  of.beams = 5;
  of.planes = 4;
  of.step_mm = 3.0;
  of.fill([](double x, double, double) { return 100.0 + x; });
  return kretzFile(of);
}

std::vector<std::pair<std::string, std::string>> seeds() {
  return {{"implicit.dcm", smallCine(kImplicitLittle)},
          {"explicit.dcm", smallCine(kExplicitLittle)},
          {"big.dcm", smallCine(kExplicitBig)},
          {"deflated.dcm", smallCine(kDeflated)},
          {"enhanced.dcm", smallEnhanced()},
          {"beams.vol", smallKretz()},
          {"p.pgm", "P5\n4 3\n255\n" + ramp(12)}};
}

template <class Read>
::testing::AssertionResult tells(const Result<Read>& read) {
  if (read || (read.error().sentence().ends_with('.') && read.error().code != ErrorCode::internal)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << read.error();
}

/// Reads in every way the program could; true when one of them made something of it.
bool anythingRead(const std::filesystem::path& file) {
  CineOptions options;
  options.colour = ColourRule::keepGrey;
  options.keepText = true;
  StackOptions stack;
  stack.spacing_mm = glm::dvec3(1.0);
  KretzOptions kretz;
  kretz.threads = 1;
  const auto summary = inspectDicom(file, kSmall);
  const auto cine = readDicomCine(file, options, noProgress(), kSmall);
  const auto volume = readDicomVolume(file, {.timeStep = 1}, noProgress(), kSmall);
  const auto planes = readDicomPlanes(file, {.timeStep = 1}, noProgress(), kSmall);
  const auto beams = readKretz(file, kretz, noProgress(), kSmall);
  EXPECT_TRUE(tells(summary) && tells(cine) && tells(volume) && tells(planes) && tells(beams));
  EXPECT_TRUE(!cine || cine->sequence.pixels.size() == static_cast<std::size_t>(cine->sequence.width) *
                                                           static_cast<std::size_t>(cine->sequence.height) * cine->sequence.frames.size());
  EXPECT_TRUE(!volume || volume->volume.echo.size() == volume->volume.grid.voxelCount());
  EXPECT_TRUE(!beams || beams->volume.echo.size() == beams->volume.grid.voxelCount());
  bool image = false;
  if (file.extension() == ".pgm") {
    const auto images = readImageStack(file, stack, noProgress(), kSmall);
    EXPECT_TRUE(tells(images));
    image = images.has_value();
  }
  return cine || volume || planes || beams || image;
}

TEST(DamagedImports, WholeTheyAreReadAndCutBeforeTheirLastSampleTheyAreRefused) {
  const TempFolder folder;
  for (const auto& [name, bytes] : seeds()) {
    EXPECT_TRUE(anythingRead(folder.put(name, bytes))) << name;
    // After the samples of a Kretz file only its end marker comes.
    const std::size_t needed = name.ends_with(".vol") ? bytes.size() - 8 : bytes.size();
    for (std::size_t length = 0; length < needed; length += 1 + length / 97)
      EXPECT_FALSE(anythingRead(folder.put(name, bytes.substr(0, length)))) << name << " cut after " << length << " of " << bytes.size();
  }
}

RC_GTEST_PROP(DamagedImports, WithAnyBytesChangedTheyEndInAResultOrASentence, ()) {
  static const TempFolder folder;
  static const auto all = seeds();
  const auto& [name, bytes] = all[*rc::gen::inRange<std::size_t>(0, all.size())];
  std::string damaged = bytes;
  const auto changes = *rc::gen::container<std::vector<std::pair<std::uint32_t, std::uint8_t>>>(
      rc::gen::pair(rc::gen::arbitrary<std::uint32_t>(), rc::gen::arbitrary<std::uint8_t>()));
  for (const auto& [at, value] : changes) damaged[at % damaged.size()] = static_cast<char>(value);
  static_cast<void>(anythingRead(folder.put(name, damaged)));
  RC_ASSERT(!::testing::Test::HasFailure());
}

}  // namespace
}  // namespace ew::damaged_imports_test
