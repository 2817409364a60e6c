#include <gtest/gtest.h>

#include <iostream>

#include "ew/door/host_parts.h"
#include "ew/imaging/probe.h"
#include "ew/io/sequence.h"
#include "ew/phantom/patient.h"
#include "ew/phantom/virtual_sweep.h"
#include "library/temporary_folder.h"
#include "logic/chain.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
const fs::path kSource(EW_SOURCE_DIR);

/// Six overlapping sweeps of one virtual patient, pressed in by different amounts, as a laboratory records them.
void recordAll(const fs::path& into) {
  const auto patient = readPatient(kSource / "cases/upper-abdomen-gall-stone/patient.json", kSource / "resources/mannequin");
  ASSERT_TRUE(patient) << patient.error();
  for (int n = 0; n < 6; ++n) {
    const std::string name = "view" + std::to_string(n);
    const auto recipe = readSweepRecipe(kSource / "tests/stitching/six_subvolumes" / (name + ".json"));
    ASSERT_TRUE(recipe) << recipe.error();
    const auto probe = readProbe(kSource / "resources/probes" / (recipe->probe + ".json"));
    ASSERT_TRUE(probe) << probe.error();
    const auto swept = recordSweep(*patient, *probe, *recipe, 0, noProgress());
    ASSERT_TRUE(swept) << swept.error();
    ASSERT_TRUE(writeDeviceSet(swept->deviceSet, into / (name + ".xml")));
    ASSERT_TRUE(writeSequence(swept->sequence, into / (name + ".igs.mha")));
  }
}

/// How far a view's place is from the truth, seen from the first view: the recordings share one world, so both should be the same.
double poseError_mm(const ChainState& state, std::size_t view) {
  const glm::dmat4 apart = glm::inverse(state.graph->toWorld[0]) * state.graph->toWorld[view];
  const Grid& grid = state.volumes[view]->grid;
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 p = grid.voxelToWorld().matrix * glm::dvec4((corner & 1) * (grid.dims.x - 1), ((corner >> 1) & 1) * (grid.dims.y - 1),
                                                                 (corner >> 2) * (grid.dims.z - 1), 1.0);
    sum += glm::distance(glm::dvec3(apart * p), glm::dvec3(p)) / 8.0;
  }
  return sum;
}

TEST(SixSubvolumes, BecomeOneFromRecordingsWithPerturbedPlaces) {
  const test::TemporaryFolder folder;
  recordAll(folder.path());
  if (HasFatalFailure()) return;
  door::FileVolumes volumes;
  door::TextFiles files;
  const auto text = files.readText(kSource / "tests/stitching/six_subvolumes/tracker-perturbed.json");
  ASSERT_TRUE(text);
  const auto project = parseProject(*text, folder.path(), files);
  ASSERT_TRUE(project) << project.error();
  const auto state = runChain(*project, folder / "out", {}, volumes, files, noProgress());
  ASSERT_TRUE(state) << state.error();
  EXPECT_EQ(state->verdict, registration::Verdict::aligned) << state->reason;
  EXPECT_TRUE(state->leftOut.empty());
  for (std::size_t view = 1; view < 6; ++view) {
    std::cout << "view " << view << ": " << poseError_mm(*state, view) << " mm at the corners\n";
    EXPECT_LT(poseError_mm(*state, view), 2.5) << view;  // the tissue is pressed 7 mm in one view and 10 in another
  }
  EXPECT_GT(state->bendSummary.smallestJacobian, 0.1);
  ASSERT_TRUE(state->report);
  const SeamVisibility& seam = state->report->seam;
  std::cout << "seam: derivative " << seam.derivativeRatio << ", speckle " << seam.speckleRatio << ", step " << seam.meanStep_db << " dB\n";
  EXPECT_NEAR(seam.derivativeRatio, 1.0, 0.15);
  EXPECT_NEAR(seam.speckleRatio, 1.0, 0.15);
  EXPECT_LT(std::abs(seam.meanStep_db), 1.0);
}

}  // namespace
}  // namespace ew::stitching
