#include "logic/wrong_settings.h"

#include <gtest/gtest.h>

#include "ew/assessment/step_work.h"
#include "lessons/made_scene.h"

namespace ew::lessons::wrong_settings_test {
namespace {

using test::held;
using test::image;

Probe probeOf(const char* id) {
  Probe probe = image(held()).probe;
  probe.id = id;
  return probe;
}

TEST(WrongSettings, MissEveryBandAndTakeAnotherProbe) {
  const SettingsTask task{{"linear-7.5"},
                          {{"depth_mm", 60.0, 90.0}, {"gain_db", -6.0, 6.0}, {"dynamic_range_db", 40.0, 70.0}, {"focus_mm", 20.0, 60.0}}};
  ScanState state = image(held());
  state.knobs.dynamicRange_db = 60.0;
  const WrongSettings wrong = wrongSettings(task, state, {probeOf("linear-7.5"), probeOf("convex-3.5")});
  EXPECT_EQ(wrong.probe, "convex-3.5");
  state.knobs = wrong.knobs;
  for (const SettingBand& band : task.bands) {
    const double value = *settingOf(state, band.setting);
    EXPECT_TRUE(value < band.lowest || value > band.highest) << band.setting << " is " << value;
  }
  const auto work = workOf(test::step(task), test::scene().ground());
  (*work)->see(state);
  for (std::size_t n = 1; n < (*work)->live().size(); ++n) EXPECT_FALSE((*work)->live()[n].good) << n;
}

TEST(WrongSettings, LeaveWhatIsWrongAlready) {
  ScanState state = image(held());
  state.knobs.gain_db = 12.0;
  const SettingsTask task{{"convex-3.5"}, {{"gain_db", -6.0, 6.0}}};
  EXPECT_EQ(wrongSettings(task, state, {probeOf("linear-7.5"), probeOf("convex-3.5")}), (WrongSettings{"linear-7.5", state.knobs}));
  EXPECT_EQ(wrongSettings({{"linear-7.5"}, {}}, state, {probeOf("linear-7.5")}), (WrongSettings{"linear-7.5", state.knobs}))
      << "there is no other probe";
}

}  // namespace
}  // namespace ew::lessons::wrong_settings_test
