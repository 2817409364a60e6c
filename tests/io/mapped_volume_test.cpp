#include "ew/io/mapped_volume.h"

#include "ew/io/volume_file.h"
#include "files.h"

namespace ew::mapped_volume_test {
namespace {
using namespace test;

constexpr const char* kMeta = "ObjectType = Image\nNDims = 3\nDimSize = 5 4 3\nElementSpacing = 0.5 0.6 0.7\nOffset = 1 2 3\n";

std::string samples(std::size_t count = 60) {
  std::string bytes(count, '\0');
  for (std::size_t n = 0; n < count; ++n) bytes[n] = static_cast<char>(n * 37 + 11);
  return bytes;
}

std::filesystem::path localMeta(const TempFolder& folder, const std::string& bytes, const std::string& more = "") {
  return folder.put("a.mha", kMeta + more + "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + bytes);
}

void expectAsRead(const std::filesystem::path& file) {
  const auto read = readVolume(file);
  ASSERT_TRUE(read) << read.error();
  const auto mapped = mapVolume(file);
  ASSERT_TRUE(mapped) << mapped.error();
  EXPECT_EQ(mapped->view().grid, read->volume.grid) << file;
  const auto* first = mapped->view().data;
  EXPECT_EQ(std::vector<std::uint8_t>(first, first + read->volume.echo.size()), read->volume.echo) << file;
  EXPECT_EQ(mappableBytes(file), read->volume.echo.size());
  EXPECT_TRUE(mapped->unchanged());
}

TEST(MappedVolume, HoldsTheVoxelsOfEveryUncompressedFormatAsReadingThemDoes) {
  const TempFolder folder;
  expectAsRead(localMeta(folder, samples()));
  expectAsRead(localMeta(folder, samples(), "HeaderSize = -1\n"));
  static_cast<void>(folder.put("a.raw", samples()));
  expectAsRead(folder.put("b.mhd", std::string(kMeta) + "ElementType = MET_UCHAR\nElementDataFile = a.raw\n"));
  const std::string nrrd = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 5 4 3\nspace: LPS\nspace directions: (1,0,0) (0,2,0) (0,0,3)\n";
  expectAsRead(folder.put("a.nrrd", nrrd + "encoding: raw\n\n" + samples()));
  expectAsRead(folder.put("a.nhdr", nrrd + "encoding: raw\ndata file: a.raw\n"));
  static_cast<void>(folder.put("c.raw", "ahead" + samples()));
  expectAsRead(folder.put("c.nhdr", nrrd + "encoding: raw\nbyte skip: 5\ndata file: c.raw\n"));
  expectAsRead(folder.put("d.nhdr", nrrd + "encoding: raw\nbyte skip: -1\ndata file: c.raw\n"));
}

TEST(MappedVolume, BeginsWhereTheSamplesDoHoweverFarIntoAPage) {
  const TempFolder folder;
  for (const std::size_t ahead : {0u, 1u, 4095u, 4096u, 4097u, 12288u}) {
    static_cast<void>(folder.put("a.raw", std::string(ahead, '#') + samples()));
    expectAsRead(folder.put(
        "a.mhd", std::string(kMeta) + "HeaderSize = " + std::to_string(ahead) + "\nElementType = MET_UCHAR\nElementDataFile = a.raw\n"));
  }
}

TEST(MappedVolume, LeavesToReadingWhatDoesNotLieInTheFileAsInMemory) {
  const TempFolder folder;
  const std::string packed = deflated(samples());
  const auto compressed = localMeta(folder, packed, "CompressedData = True\nCompressedDataSize = " + std::to_string(packed.size()) + "\n");
  const auto wide = folder.put("w.mha", std::string(kMeta) + "ElementType = MET_USHORT\nElementDataFile = LOCAL\n" + samples(120));
  const auto text = folder.put("t.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 1 1 2\nencoding: ascii\n\n1 2\n");
  for (const auto& file : {compressed, wide, text}) {
    ASSERT_TRUE(readVolume(file)) << file;
    const auto mapped = mapVolume(file);
    ASSERT_FALSE(mapped) << file;
    EXPECT_EQ(mapped.error().code, ErrorCode::unsupported) << mapped.error();
    EXPECT_EQ(mappableBytes(file), 0u);
  }
}

TEST(MappedVolume, RefusesAFileShorterThanItsHeaderPromisesAndTakesALongerOne) {
  const TempFolder folder;
  for (const std::size_t length : {0u, 1u, 59u}) {
    const auto mapped = mapVolume(localMeta(folder, samples(length)));
    ASSERT_FALSE(mapped) << length;
    EXPECT_EQ(mapped.error().code, ErrorCode::truncated) << mapped.error();
  }
  EXPECT_TRUE(mapVolume(localMeta(folder, samples(61))));
  EXPECT_EQ(mapVolume(folder / "none.mha").error().code, ErrorCode::notFound);
}

TEST(MappedVolume, TellsThatItsFileWasChangedAndIsUntouchedByOneRenamedOntoIt) {
  const TempFolder folder;
  const auto file = localMeta(folder, samples());
  const auto mapped = mapVolume(file);
  ASSERT_TRUE(mapped) << mapped.error();
  const std::uint8_t before = mapped->view().data[7];
  std::filesystem::rename(folder.put("new", std::string(1000, '\7')), file);
  EXPECT_TRUE(mapped->unchanged());
  EXPECT_EQ(mapped->view().data[7], before);

  const auto other = localMeta(folder, samples());
  const auto changed = mapVolume(other);
  ASSERT_TRUE(changed);
  std::ofstream(other, std::ios::binary | std::ios::app) << "more";
  const auto said = changed->unchanged();
  ASSERT_FALSE(said);
  EXPECT_EQ(said.error().code, ErrorCode::notReadable);
}

TEST(MappedVolume, KeepsItsVoxelsWhenItIsMovedAndWhenItsPagesAreGivenBack) {
  const TempFolder folder;
  auto mapped = mapVolume(localMeta(folder, samples()));
  ASSERT_TRUE(mapped);
  const MappedVolume moved = *std::move(mapped);
  const auto before = std::vector<std::uint8_t>(moved.view().data, moved.view().data + 60);
  moved.release();
  EXPECT_EQ(std::vector<std::uint8_t>(moved.view().data, moved.view().data + 60), before);
}

}  // namespace
}  // namespace ew::mapped_volume_test
