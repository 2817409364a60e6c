#include <algorithm>

#include "drawn_anatomy.h"
#include "ew/phantom/flow.h"

namespace ew::neck_test {
namespace {

using testing::in;
using testing::inOrder;

const testing::DrawnPatient& neck() {
  static const testing::DrawnPatient patient("neck-carotid-thyroid");
  return patient;
}

TEST(Neck, HasTheNoduleOfTheStatedSizeInTheRightLobe) {
  const glm::dvec3 centre(-19.3, -15.4, 231);
  EXPECT_EQ(neck().organAt(centre), "thyroid nodule");
  // Its surface is a little uneven.
  EXPECT_NEAR(neck().diameter_mm("thyroid nodule", centre, {0, 0, 1}, 20), 14.0, 0.4);
  EXPECT_NEAR(neck().diameter_mm("thyroid nodule", centre, {1, 0, 0}, 20), 11.0, 0.4);
  EXPECT_NEAR(neck().diameter_mm("thyroid nodule", centre, {0, 1, 0}, 20), 10.0, 0.4);
  EXPECT_EQ(neck().organAt(centre + glm::dvec3(0, 0, 6.5)), "halo of the nodule");
  for (double angle = 0.0; angle < 6.28; angle += 0.2)
    EXPECT_EQ(neck().organAt(centre + 5.9 * glm::dvec3(std::cos(angle), std::sin(angle), 0.0)), "thyroid") << "at " << angle;
  EXPECT_EQ(neck().organAt(centre * glm::dvec3(-1, 1, 1)), "thyroid") << "the left lobe has none";
}

TEST(Neck, HasACarotidOf6MillimetresWithAThinWallBelowTheFork) {
  for (const char* side : {"left carotid", "right carotid"}) {
    const glm::dmat4 frame = neck().frame(side);
    const glm::dvec3 below = in(frame, {0, 0, -16});
    EXPECT_NEAR(neck().diameter_mm("carotid arteries", below, glm::dvec3(frame[0]), 10), 6.0, 0.02) << side;
    EXPECT_NEAR(neck().diameter_mm("carotid arteries", below, glm::dvec3(frame[1]), 10), 6.0, 0.02) << side;
    EXPECT_NEAR(neck().diameter_mm("intima and media", below, glm::dvec3(frame[0]), 10), 6.0 + 2 * 0.7, 0.02) << side;
    EXPECT_TRUE(inOrder(neck().organsAlong(in(frame, {60, 0, -16}), in(frame, {-10, 0, -16})),
                        {"skin", "platysma", "sternocleidomastoid muscles", "adventitia", "intima and media", "carotid arteries",
                         "intima and media", "adventitia"}))
        << side;
  }
}

TEST(Neck, HasAForkWithTheWiderBranchOutsideAndOnlyTheRightOneNarrowed) {
  const auto lumensAcross = [&](const char* side, double z) {
    const glm::dmat4 frame = neck().frame(side);
    const auto met = neck().organsAlong(in(frame, {14, 0, z}), in(frame, {-14, 0, z}));
    return std::count(met.begin(), met.end(), "carotid arteries");
  };
  for (const char* side : {"left carotid", "right carotid"}) {
    EXPECT_EQ(lumensAcross(side, -10), 1) << side;
    EXPECT_EQ(lumensAcross(side, 2), 1) << side;
    EXPECT_EQ(lumensAcross(side, 18), 2) << side;
    EXPECT_EQ(neck().organAt(in(neck().frame(side), {5.3, 0, 21})), "carotid arteries") << "internal, " << side;
    EXPECT_EQ(neck().organAt(in(neck().frame(side), {-6.2, 0, 21})), "carotid arteries") << "external, " << side;
  }
  EXPECT_EQ(neck().organAt(in(neck().frame("right carotid"), {5.9, 0, 9.6})), "plaque");
  EXPECT_EQ(neck().organAt(in(neck().frame("left carotid"), {5.9, 0, 9.6})), "carotid arteries");
}

TEST(Neck, ShowsTheLayersOverTheThyroidInTheRightOrder) {
  EXPECT_TRUE(inOrder(neck().organsAlong({-15, -56, 231}, {-15, 30, 231}),
                      {"", "skin", "subcutaneous fat", "platysma", "strap muscles", "thyroid", "thyroid nodule", "thyroid",
                       "long muscles of the neck", "cervical spine"}));
  EXPECT_TRUE(inOrder(neck().organsAlong({0, -56, 219}, {0, 30, 219}), {"skin", "platysma", "thyroid", "rings of the windpipe",
                                                                        "air of the windpipe", "wall of the windpipe", "cervical spine"}));
  EXPECT_TRUE(
      inOrder(neck().organsAlong({8.5, -10, 205}, {8.5, 30, 205}), {"wall of the windpipe", "gullet", "lumen of the gullet", "gullet"}));
}

TEST(Neck, KeepsVesselsAndNoduleClearOfAirAndBone) {
  const glm::dmat4 frame = neck().frame("right carotid");
  for (double z = -70; z < 30; z += 2.0)
    for (const std::string obstacle : {"wall of the windpipe", "cervical spine", "transverse processes", "larynx", "jugular veins"})
      EXPECT_LT(neck().depthIn_mm(obstacle, in(frame, {0, 0, z})), -3.5) << obstacle << " at " << z;
}

TEST(Neck, HasMeasurementsThatAgreeWithItsShapes) {
  const auto measured = neck().measured();
  EXPECT_NEAR(measured.at("nodule, length"), 14.0, 0.15);
  EXPECT_NEAR(measured.at("nodule, width"), 11.0, 0.15);
  EXPECT_NEAR(measured.at("nodule, depth"), 10.0, 0.15);
  EXPECT_NEAR(measured.at("nodule, volume"), std::numbers::pi / 6.0 * 14.0 * 11.0 * 10.0 / 1000.0, 0.02) << "with its halo";
  EXPECT_NEAR(measured.at("right common carotid artery, lumen 10 mm below the fork"), 6.0, 0.06);
  EXPECT_NEAR(measured.at("right common carotid artery, intima-media thickness"), 0.7, 0.06);
  const double walls = measured.at("right carotid bulb, between its walls");
  const double free = measured.at("right carotid bulb, free lumen at the plaque");
  EXPECT_NEAR(walls, 7.34, 0.06);
  EXPECT_NEAR(1.0 - free / walls, 0.36, 0.03) << "degree of stenosis by diameter (ECST)";
}

TEST(Neck, GrowsPlaqueAndNoduleWithItsParameters) {
  const testing::DrawnPatient changed("neck-carotid-thyroid", {{"plaque_mm", 4.5}, {"nodule_length_mm", 7.0}});
  const auto before = neck().measured(), after = changed.measured();
  EXPECT_NEAR(before.at("right carotid bulb, free lumen at the plaque") - after.at("right carotid bulb, free lumen at the plaque"), 1.9,
              0.06);
  EXPECT_NEAR(after.at("nodule, length"), 7.0, 0.2);
  EXPECT_NEAR(after.at("nodule, width"), 5.5, 0.2);
  EXPECT_NEAR(after.at("nodule, depth"), 5.0, 0.2);
}

TEST(Neck, WidensTheCarotidsWithThePulse) {
  const std::string lumen = "right common carotid artery, lumen 10 mm below the fork";
  EXPECT_NEAR(neck().measured({.pulse = 1.0}).at(lumen) - neck().measured().at(lumen), 0.5, 0.06);
}

TEST(Neck, IsShownByItsStandardPlanes) { neck().expectPlanesShowWhatTheySay(20.0, 45.0); }

/// The stream of a name, and what Doppler should find of it at a place of a carotid's frame.
TrueWaveform waveformAt(const std::string& name, const char* side, const glm::dvec3& place) {
  static const FlowTruth truth(flowOf(*neck()));
  const auto& streams = truth.field().streams;
  const auto found = std::find_if(streams.begin(), streams.end(), [&](const FlowStream& stream) { return stream.name == name; });
  const auto waveform =
      found == streams.end() ? std::nullopt : waveformNear(truth, static_cast<int>(found - streams.begin()), in(neck().frame(side), place));
  EXPECT_TRUE(waveform) << name;
  return waveform.value_or(TrueWaveform{});
}

TEST(Neck, HasBloodInItsCarotidsAsHealthyPeopleHaveIt) {
  const TrueWaveform common = waveformAt("left common carotid artery", "left carotid", {0, 0, -40});
  EXPECT_NEAR(common.flow_mm3PerS * 60e-3, 415.0, 1.0) << "ml/min";
  EXPECT_NEAR(common.peakSystolic_mmPerS, 640.0, 120.0);
  EXPECT_NEAR(common.resistiveIndex(), 0.76, 0.06);
  const TrueWaveform internal = waveformAt("left internal carotid artery", "left carotid", {5.3, 0, 30});
  EXPECT_NEAR(internal.peakSystolic_mmPerS, 730.0, 120.0);
  EXPECT_NEAR(internal.resistiveIndex(), 0.67, 0.05);
  const TrueWaveform external = waveformAt("left external carotid artery", "left carotid", {-6.6, 0, 28});
  EXPECT_NEAR(external.peakSystolic_mmPerS, 790.0, 160.0);
  EXPECT_NEAR(external.resistiveIndex(), 0.86, 0.05);
}

TEST(Neck, LetsBloodFlowWithinTheLumenAlone) {
  const FlowTruth truth(flowOf(*neck()));
  for (const FlowStream& stream : truth.field().streams)
    for (std::size_t n = 4; n + 4 < stream.line.size(); n += 4) {
      const std::string organ = neck().organAt(stream.line[n].place_mm);
      EXPECT_TRUE(organ == "carotid arteries" || organ == "plaque") << stream.name << ": " << organ;
    }
  const TrueWaveform narrow = waveformAt("right internal carotid artery", "right carotid", {5.2, 0, 9.6});
  const TrueWaveform open = waveformAt("left internal carotid artery", "left carotid", {5.2, 0, 9.6});
  EXPECT_GT(narrow.peakSystolic_mmPerS, 1.5 * open.peakSystolic_mmPerS) << "beside the plaque";
}

}  // namespace
}  // namespace ew::neck_test
