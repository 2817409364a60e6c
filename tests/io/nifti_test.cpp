#include <gtest/gtest.h>

#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "ew/io/volume_file.h"
#include "files.h"

namespace ew::nifti_test {
namespace {
using namespace test;

/// A NIfTI-1 header put together field by field.
struct Header1 {
  std::string bytes = std::string(352, '\0');
  bool big = false;

  template <class T>
  void set(std::size_t offset, T value) {
    const std::string raw = bytesOf(std::vector<T>{value}, big);
    bytes.replace(offset, raw.size(), raw);
  }
  explicit Header1(std::vector<std::int16_t> sizes, std::int16_t type = 2, bool bigEndian = false) : big(bigEndian) {
    set<std::int32_t>(0, 348);
    set<std::int16_t>(40, static_cast<std::int16_t>(sizes.size()));
    for (std::size_t i = 0; i < sizes.size(); ++i) set<std::int16_t>(42 + 2 * i, sizes[i]);
    set<std::int16_t>(70, type);
    for (std::size_t i = 0; i < 8; ++i) set<float>(76 + 4 * i, 1.0F);
    set<float>(108, 352.0F);
    bytes.replace(344, 4, std::string("n+1\0", 4));
  }
  void affine(const std::array<float, 12>& rows) {
    set<std::int16_t>(254, 1);
    for (std::size_t i = 0; i < 12; ++i) set<float>(280 + 4 * i, rows[i]);
  }
};

TEST(NiftiVolume, TheAffineIsTurnedFromRightAnteriorToLeftPosterior) {
  const TempFolder folder;
  for (const bool big : {false, true}) {
    Header1 header({2, 3, 2}, 2, big);
    header.affine({0.5F, 0, 0, 10, 0, 0, -2, 20, 0, 0.25F, 0, 30});
    for (const auto& file :
         {folder.put("a.nii", header.bytes + ramp(12)), folder.put("a.nii.gz", deflated(header.bytes + ramp(12), true))}) {
      const auto loaded = readVolume(file);
      ASSERT_TRUE(succeeded(loaded)) << file;
      const Grid& grid = loaded->volume.grid;
      EXPECT_EQ(grid.dims, glm::ivec3(2, 3, 2));
      EXPECT_EQ((grid.voxelToWorld() * Point<frame::Voxel>{{0, 0, 0}}).at, glm::dvec3(-10, -20, 30));
      EXPECT_EQ((grid.voxelToWorld() * Point<frame::Voxel>{{1, 0, 0}}).at, glm::dvec3(-10.5, -20, 30));
      EXPECT_EQ((grid.voxelToWorld() * Point<frame::Voxel>{{0, 1, 0}}).at, glm::dvec3(-10, -20, 30.25));
      EXPECT_EQ((grid.voxelToWorld() * Point<frame::Voxel>{{0, 0, 1}}).at, glm::dvec3(-10, -18, 30));
      EXPECT_EQ(loaded->volume.echo[11], 11);
      EXPECT_TRUE(loaded->notes.empty());
    }
  }
}

TEST(NiftiVolume, TheQuaternionIsUsedWhenThereIsNoAffine) {
  const TempFolder folder;
  const glm::dquat q = glm::angleAxis(0.9, glm::normalize(glm::dvec3(1, -2, 3)));
  const glm::dmat3 rotation = glm::mat3_cast(q);
  for (const double hand : {1.0, -1.0}) {
    Header1 header({2, 2, 2});
    header.set<std::int16_t>(252, 1);
    header.set<float>(76, static_cast<float>(hand));
    header.set<float>(80, 0.5F);
    header.set<float>(84, 2.0F);
    header.set<float>(88, 4.0F);
    for (std::size_t i = 0; i < 3; ++i) header.set<float>(256 + 4 * i, static_cast<float>(std::array{q.x, q.y, q.z}[i]));
    for (std::size_t i = 0; i < 3; ++i) header.set<float>(268 + 4 * i, std::array{1.0F, 2.0F, 3.0F}[i]);
    const auto loaded = readVolume(folder.put("a.nii", header.bytes + ramp(8)));
    ASSERT_TRUE(succeeded(loaded));
    const glm::dvec3 expected = (glm::dvec3(1, 2, 3) + rotation * glm::dvec3(0.5, 2.0, 4.0 * hand)) * glm::dvec3(-1, -1, 1);
    EXPECT_LT(glm::length((loaded->volume.grid.voxelToWorld() * Point<frame::Voxel>{{1, 1, 1}}).at - expected), 1e-5);
  }
}

TEST(NiftiVolume, DummyGeometrySaysThatTheSpacingIsUnknown) {
  const TempFolder folder;
  const auto bare = readVolume(folder.put("a.nii", Header1({2, 2, 2}).bytes + ramp(8)));
  ASSERT_TRUE(succeeded(bare));
  EXPECT_TRUE(contains(bare->notes, "spacing is probably unknown"));
  Header1 identity({2, 2, 2});
  identity.affine({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
  const auto loaded = readVolume(folder.put("b.nii", identity.bytes + ramp(8)));
  ASSERT_TRUE(succeeded(loaded));
  EXPECT_TRUE(contains(loaded->notes, "spacing is probably unknown"));
}

TEST(NiftiVolume, OfSeveralTimeStepsTheFirstIsRead) {
  const TempFolder folder;
  Header1 header({2, 2, 2, 7});
  header.affine({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -3, 5});
  const auto loaded = readVolume(folder.put("a.nii", header.bytes + ramp(56)));
  ASSERT_TRUE(succeeded(loaded));
  EXPECT_EQ(loaded->volume.echo, (std::vector<std::uint8_t>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(loaded->volume.grid.directions[2], glm::dvec3(0, 0, -1));
  EXPECT_TRUE(contains(loaded->notes, "7 volumes"));
}

TEST(NiftiVolume, OtherTypesUnitsAndSlopesAreHonoured) {
  const TempFolder folder;
  Header1 header({3, 1, 1}, 4);
  header.set<float>(112, -2.0F);
  header.set<float>(116, 5.0F);
  header.set<std::uint8_t>(123, 3);
  header.affine({500, 0, 0, 0, 0, 500, 0, 0, 0, 0, 500, 1000});
  const auto loaded = readVolume(folder.put("a.nii", header.bytes + bytesOf(std::vector<std::int16_t>{-1, 0, 4})));
  ASSERT_TRUE(succeeded(loaded));
  EXPECT_EQ(loaded->volume.echo, (std::vector<std::uint8_t>{255, 204, 0}));
  EXPECT_EQ(loaded->volume.grid.spacing_mm, glm::dvec3(0.5));
  EXPECT_EQ(loaded->volume.grid.origin_mm.z, 1.0);
  EXPECT_TRUE(contains(loaded->notes, "from -3 to 7"));
}

TEST(NiftiVolume, ACodeOfNoUnitLeavesTheSpacingUnknown) {
  const TempFolder folder;
  const auto withUnits = [&](std::uint8_t units) {
    Header1 header({2, 2, 2});
    header.set<std::uint8_t>(123, units);
    header.affine({0.5F, 0, 0, 10, 0, 0.5F, 0, 20, 0, 0, 2, 30});
    return readVolume(folder.put("a.nii", header.bytes + ramp(8)));
  };
  for (const std::uint8_t code : {4, 5, 6, 7}) {
    const auto odd = withUnits(static_cast<std::uint8_t>(code | 8));  // of time: seconds
    ASSERT_TRUE(succeeded(odd)) << int{code};
    EXPECT_FALSE(odd->spacingKnown) << int{code};
    EXPECT_TRUE(contains(odd->notes, "as the code " + std::to_string(code) + ", which means nothing in NIfTI")) << int{code};
  }
  for (const std::uint8_t code : {0, 1, 2, 3}) {
    const auto known = withUnits(static_cast<std::uint8_t>(code | 8));
    ASSERT_TRUE(succeeded(known)) << int{code};
    EXPECT_TRUE(known->spacingKnown) << int{code};
    EXPECT_FALSE(contains(known->notes, "means nothing")) << int{code};
  }
}

TEST(NiftiVolume, LengthsAreTheDecimalsThatWereMeant) {
  const TempFolder folder;
  Header1 metres({2, 2, 2});
  metres.set<std::uint8_t>(123, 1);
  metres.affine({0.0005F, 0, 0, 0.01F, 0, 0.0005F, 0, 0.02F, 0, 0, 0.0003F, 0.03F});
  const auto read = readVolume(folder.put("m.nii", metres.bytes + ramp(8)));
  ASSERT_TRUE(succeeded(read));
  EXPECT_EQ(read->volume.grid.spacing_mm.x, 0.5);
  EXPECT_EQ(read->volume.grid.spacing_mm.y, 0.5);
  EXPECT_DOUBLE_EQ(read->volume.grid.spacing_mm.z, 0.3);
  Header1 bare({2, 2, 2});
  for (std::size_t axis = 0; axis < 3; ++axis) bare.set<float>(80 + 4 * axis, 0.3F);
  const auto sizes = readVolume(folder.put("b.nii", bare.bytes + ramp(8)));
  ASSERT_TRUE(succeeded(sizes));
  EXPECT_EQ(sizes->volume.grid.spacing_mm, glm::dvec3(0.3));
}

TEST(NiftiVolume, TheSecondVersionIsReadToo) {
  const TempFolder folder;
  std::string bytes(544, '\0');
  const auto set = [&](std::size_t offset, const std::string& raw) { bytes.replace(offset, raw.size(), raw); };
  set(0, bytesOf(std::vector<std::int32_t>{540}));
  set(4, std::string("n+2\0\r\n\x1a\n", 8));
  set(12, bytesOf(std::vector<std::int16_t>{2, 8}));
  set(16, bytesOf(std::vector<std::int64_t>{3, 2, 2, 1, 1, 1, 1, 1}));
  set(104, bytesOf(std::vector<double>{1, 0.5, 0.5, 2, 1, 1, 1, 1}));
  set(168, bytesOf(std::vector<std::int64_t>{544}));
  const auto loaded = readVolume(folder.put("a.nii", bytes + ramp(4)));
  ASSERT_TRUE(succeeded(loaded));
  EXPECT_EQ(loaded->volume.grid.dims, glm::ivec3(2, 2, 1));
  EXPECT_EQ(loaded->volume.grid.spacing_mm, glm::dvec3(0.5, 0.5, 2));
  EXPECT_TRUE(contains(loaded->notes, "no orientation"));
}

TEST(NiftiVolume, WrongHeadersAreRefusedInOneSentence) {
  const TempFolder folder;
  EXPECT_TRUE(failedWith(readVolume(folder.put("a.nii", "short")), ErrorCode::truncated));
  EXPECT_TRUE(failedWith(readVolume(folder.put("b.nii", std::string(600, 'x'))), ErrorCode::badHeader));
  EXPECT_TRUE(failedWith(readVolume(folder.put("c.nii", Header1({2, -2, 2}).bytes + ramp(8))), ErrorCode::badField));
  EXPECT_TRUE(failedWith(readVolume(folder.put("d.nii", Header1({2, 0, 2}).bytes)), ErrorCode::emptyVolume));
  EXPECT_TRUE(failedWith(readVolume(folder.put("e.nii", Header1({2, 2, 2}, 32).bytes + ramp(64))), ErrorCode::unsupported));
  EXPECT_TRUE(failedWith(readVolume(folder.put("f.nii", Header1({2, 2, 2}).bytes + ramp(7))), ErrorCode::truncated));
  Header1 two({2, 2, 2});
  two.bytes.replace(344, 4, std::string("ni1\0", 4));
  EXPECT_TRUE(failedWith(readVolume(folder.put("g.nii", two.bytes)), ErrorCode::unsupported));
  Header1 zero({2, 2, 2});
  zero.affine({0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
  EXPECT_TRUE(failedWith(readVolume(folder.put("h.nii", zero.bytes + ramp(8))), ErrorCode::badField));
  const auto huge = readVolume(folder.put("i.nii", Header1({32767, 32767, 32767}).bytes + ramp(8)));
  EXPECT_TRUE(failedWith(huge, ErrorCode::tooLarge));
}

TEST(NiftiVolume, MetresAndMicrometresHoldForSizesAndPlaces) {
  const TempFolder folder;
  for (const auto& [units, scale] : {std::pair(char{1}, 1e-3F), std::pair(char{2}, 1.0F), std::pair(char{3}, 1e3F)}) {
    Header1 header({2, 3, 2});
    header.affine({0.5F * scale, 0, 0, 10 * scale, 0, 0.5F * scale, 0, 20 * scale, 0, 0, 2 * scale, 30 * scale});
    header.set<char>(123, units);
    const auto loaded = readVolume(folder.put("a.nii", header.bytes + ramp(12)));
    ASSERT_TRUE(succeeded(loaded));
    EXPECT_LT(glm::length(loaded->volume.grid.spacing_mm - glm::dvec3(0.5, 0.5, 2.0)), 1e-6);
    EXPECT_LT(glm::length(loaded->volume.grid.origin_mm - glm::dvec3(-10, -20, 30)), 1e-5);
  }
}

TEST(NiftiVolume, TwoPlacesThatDifferAreTold) {
  const TempFolder folder;
  const auto notes = [&](float x) {
    Header1 header({2, 3, 2});
    header.affine({1, 0, 0, 10, 0, 1, 0, 20, 0, 0, 1, 30});
    header.set<std::int16_t>(252, 1);  // the quaternion of no rotation is 0 0 0
    header.set<float>(268, x);
    header.set<float>(272, 20.0F);
    header.set<float>(276, 30.0F);
    const auto loaded = readVolume(folder.put("a.nii", header.bytes + ramp(12)));
    EXPECT_TRUE(succeeded(loaded));
    return loaded ? loaded->notes : std::vector<Message>();
  };
  EXPECT_TRUE(notes(10.0F).empty());
  EXPECT_TRUE(contains(notes(15.0F), "differ by up to 5 mm (sform and qform)"));
}

TEST(NiftiVolume, VoxelSizesThatDifferFromTheAffineAreTold) {
  const TempFolder folder;
  const auto notes = [&](float size) {
    Header1 header({2, 3, 2});
    header.affine({0.5F, 0, 0, 10, 0, 0.5F, 0, 20, 0, 0, 0.5F, 30});
    for (std::size_t axis = 0; axis < 3; ++axis) header.set<float>(80 + 4 * axis, size);
    const auto loaded = readVolume(folder.put("a.nii", header.bytes + ramp(12)));
    EXPECT_TRUE(succeeded(loaded));
    return loaded ? loaded->notes : std::vector<Message>();
  };
  EXPECT_TRUE(notes(0.5F).empty());
  EXPECT_TRUE(contains(notes(2.0F), "0.5 x 0.5 x 0.5 mm by its sform, which was used, and 2 x 2 x 2 mm by its pixdim"));
}

TEST(NiftiVolume, ComponentsOfVectorsAreNoStepsOfTime) {
  const TempFolder folder;
  const auto vectors = readVolume(folder.put("a.nii", Header1({2, 2, 1, 1, 3}).bytes + ramp(12)));
  EXPECT_TRUE(failedWith(vectors, ErrorCode::unsupported));
  EXPECT_TRUE(says(vectors, "3 components"));
  const auto steps = readVolume(folder.put("b.nii", Header1({2, 2, 1, 3}).bytes + ramp(12)));
  ASSERT_TRUE(succeeded(steps));
  EXPECT_EQ(steps->timeSteps, 3u);
}

TEST(NiftiVolume, MoreComponentsThanCanBeCountedAreRefusedToo) {
  const TempFolder folder;
  std::string bytes(544, '\0');
  const auto set = [&](std::size_t offset, const std::string& raw) { bytes.replace(offset, raw.size(), raw); };
  set(0, bytesOf(std::vector<std::int32_t>{540}));
  set(4, std::string("n+2\0\r\n\x1a\n", 8));
  set(12, bytesOf(std::vector<std::int16_t>{2, 8}));
  set(104, bytesOf(std::vector<double>{1, 0.5, 0.5, 2, 1, 1, 1, 1}));
  set(168, bytesOf(std::vector<std::int64_t>{544}));
  constexpr std::int64_t kMany = std::int64_t{1} << 40;
  for (const auto& [fifth, others, said] :
       {std::tuple(kMany, std::int64_t{1}, "1099511627776 components"), std::tuple(kMany, kMany, "more than 10^19 components"),
        std::tuple(std::int64_t{1}, kMany, "more than 10^19 components")}) {
    set(16, bytesOf(std::vector<std::int64_t>{7, 2, 2, 1, 1, fifth, others, others}));
    const auto refused = readVolume(folder.put("a.nii", bytes + ramp(4)));
    EXPECT_TRUE(failedWith(refused, ErrorCode::unsupported)) << said;
    EXPECT_TRUE(says(refused, said));
  }
}

TEST(NiftiVolume, ARangeThatIsToBeShownIsTold) {
  const TempFolder folder;
  Header1 header({2, 3, 2});
  header.affine({1, 0, 0, 10, 0, 1, 0, 20, 0, 0, 1, 30});
  header.set<float>(124, 200.0F);
  header.set<float>(128, 20.0F);
  const auto loaded = readVolume(folder.put("a.nii", header.bytes + ramp(12)));
  ASSERT_TRUE(succeeded(loaded));
  EXPECT_TRUE(contains(loaded->notes, "cal_min cal_max \"20 200\", which touches the grey levels"));
}

}  // namespace
}  // namespace ew::nifti_test
