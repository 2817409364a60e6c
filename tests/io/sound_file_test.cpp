#include "ew/io/sound_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <limits>
#include <vector>

#include "library/temporary_folder.h"

namespace ew::sound_file_test {
namespace {

using test::TemporaryFolder;

TEST(SoundFile, HasItsHeadAndEverySample) {
  const TemporaryFolder folder;
  const std::vector<glm::vec2> sound{{0.0F, 1.0F}, {-1.0F, 0.5F}, {2.0F, std::numeric_limits<float>::quiet_NaN()}};
  ASSERT_TRUE(writeSound(sound, 48000, folder / "a.wav"));
  std::ifstream in(folder / "a.wav", std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  ASSERT_EQ(bytes.size(), 44U + 12U);
  const auto at = [&](std::size_t place, int count) {
    std::uint32_t value = 0;
    for (int n = 0; n < count; ++n)
      value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[place + static_cast<std::size_t>(n)])) << (8 * n);
    return value;
  };
  EXPECT_EQ(bytes.substr(0, 4) + bytes.substr(8, 8) + bytes.substr(36, 4), "RIFFWAVEfmt data");
  EXPECT_EQ(at(4, 4), 48U);  // what follows
  EXPECT_EQ(at(20, 2), 1U);  // PCM
  EXPECT_EQ(at(22, 2), 2U);  // channels
  EXPECT_EQ(at(24, 4), 48000U);
  EXPECT_EQ(at(28, 4), 192000U);  // bytes a second
  EXPECT_EQ(at(34, 2), 16U);
  EXPECT_EQ(at(40, 4), 12U);
  const auto sample = [&](std::size_t n) { return static_cast<std::int16_t>(at(44 + 2 * n, 2)); };
  EXPECT_EQ(sample(0), 0);
  EXPECT_EQ(sample(1), 32767);
  EXPECT_EQ(sample(2), -32767);
  EXPECT_EQ(sample(3), 16384);
  EXPECT_EQ(sample(4), 32767);
  EXPECT_EQ(sample(5), 0);
}

TEST(SoundFile, SaysWhereItCannotBeWritten) {
  const TemporaryFolder folder;
  const auto written = writeSound({}, 8000, folder / "nowhere/a.wav");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::notWritable);
}

}  // namespace
}  // namespace ew::sound_file_test
