#include "logic/review_tracks.h"

#include <gtest/gtest.h>

#include "ew/library/step_answer.h"
#include "ew/scanning/contact.h"
#include "made_log.h"

namespace ew::review {
namespace {

using test::allOf;
using test::logOf;

const Track& of(const std::vector<Track>& tracks, TrackKind kind) { return tracks[static_cast<std::size_t>(kind)]; }

TEST(ReviewTracks, SayWhenThePoseWasKnown) {
  const ScanLog log = logOf(11, 1.0, [](int n, ScanState& state) {
    if (n >= 3 && n < 5) state.pose.status = PoseStatus::invalid;
    if (n == 8) state.pose.status = PoseStatus::missing;
  });
  const auto tracks = tracksOf(log, allOf(log));
  ASSERT_EQ(tracks.size(), static_cast<std::size_t>(kTrackKinds));
  EXPECT_EQ(of(tracks, TrackKind::pose).spans, (std::vector<TrackSpan>{{0.0, 3.0, 1.0}, {5.0, 8.0, 1.0}, {9.0, 10.0, 1.0}}));
}

TEST(ReviewTracks, SayHowMuchOfTheFaceTouched) {
  std::vector<float> half(kPointsOfFace, 0.0F), none(kPointsOfFace, 20.0F);
  for (int n = 0; n < 8; ++n) half[static_cast<std::size_t>(n)] = 20.0F;
  const ScanLog log = logOf(7, 1.0, [&](int n, ScanState& state) { state.gaps_mm = n < 2 ? half : n < 4 ? none : std::vector<float>{}; });
  const auto tracks = tracksOf(log, allOf(log));
  const auto& spans = of(tracks, TrackKind::contact).spans;
  EXPECT_EQ(spans, (std::vector<TrackSpan>{{0.0, 2.0, contactShare(half)}, {4.0, 6.0, 1.0}}));
}

TEST(ReviewTracks, SayWhichSettingWasChangedAndFromWhat) {
  const ScanLog log = logOf(4, 1.0, [](int n, ScanState& state) {
    state.knobs.depth_mm = n < 2 ? 60.0 : 85.0;
    state.knobs.zoom = n < 3 ? 1.0 : 2.0;
  });
  const auto tracks = tracksOf(log, allOf(log));
  const auto& marks = of(tracks, TrackKind::settings).marks;
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_EQ(marks[0].time_s, 2.0);
  EXPECT_EQ(marks[0].what.english(), "depth 8.5 cm, was 6.0 cm; focus 4.2 cm, was 3.0 cm");
  EXPECT_EQ(marks[1].time_s, 3.0);
  EXPECT_EQ(marks[1].what.english(), "zoom × 2.0, was × 1.0");
}

TEST(ReviewTracks, SayWhenItWasFrozenAndGoOnToTheEnd) {
  ScanLog log = logOf(3, 1.0, [](int, ScanState&) {});
  log.setFrozen(2.0, true);
  log.setFrozen(4.0, false);
  ScanState more;
  more.probe = test::straightProbe();
  more.time_s = 5.0;
  log.addFrame(more);
  log.setFrozen(6.0, true);
  log.addNote(7.5, "mark", nullptr);
  const auto tracks = tracksOf(log, {0.0, 7.5});
  EXPECT_EQ(of(tracks, TrackKind::freeze).spans, (std::vector<TrackSpan>{{2.0, 4.0, 1.0}, {6.0, 7.5, 1.0}}));
  EXPECT_EQ(freezesOf(log, {3.0, 6.5}), (std::vector<TrackSpan>{{3.0, 4.0, 1.0}, {6.0, 6.5, 1.0}}));
}

TEST(ReviewTracks, AFreezeThatIsToldTwiceBeganAtTheFirst) {
  ScanLog log = logOf(1, 1.0, [](int, ScanState&) {});
  log.add({1.0, FreezeChanged{true}});
  log.add({2.0, FreezeChanged{true}});
  log.add({3.0, FreezeChanged{false}});
  EXPECT_EQ(freezesOf(log, {0.0, 5.0}), (std::vector<TrackSpan>{{1.0, 3.0, 1.0}}));
}

TEST(ReviewTracks, HoldNotesMarksAnswersAndComments) {
  ScanLog log = logOf(3, 1.0, [](int, ScanState&) {});
  log.addNote(2.0, "measurement", {{"name", "aorta, across"}});
  log.addNote(2.0, "mark", nullptr);
  StepOutcome outcome;
  outcome.answer = OptionsAnswer{{0}};
  ReviewComment spoken, drawn;
  spoken.time_s = 1.0;
  spoken.text = "Too far to the left.";
  drawn.time_s = 0.5;
  const auto tracks = tracksOf(log, allOf(log), {&outcome, {{0.5, "Here is the gall bladder."}, {9.0, "Cut off."}}, {spoken, drawn}});
  EXPECT_EQ(of(tracks, TrackKind::measurement).marks, (std::vector<TrackMark>{{2.0, verbatim("aorta, across")}}));
  EXPECT_EQ(of(tracks, TrackKind::mark).marks,
            (std::vector<TrackMark>{{0.5, verbatim("Here is the gall bladder.")}, {2.0, verbatim("mark")}}));
  ASSERT_EQ(of(tracks, TrackKind::answer).marks.size(), 1U);
  EXPECT_EQ(of(tracks, TrackKind::answer).marks[0].time_s, 2.0);
  ASSERT_EQ(of(tracks, TrackKind::comment).marks.size(), 2U);
  EXPECT_EQ(of(tracks, TrackKind::comment).marks[0].time_s, 0.5);
  EXPECT_EQ(of(tracks, TrackKind::comment).marks[1].what.english(), "Too far to the left.");
  EXPECT_EQ(eventsOf(tracks), (std::vector<double>{0.5, 1.0, 2.0}));
}

TEST(ReviewTracks, LookAtAPartAlone) {
  const ScanLog log = logOf(11, 1.0, [](int n, ScanState& state) { state.knobs.gain_db = n; });
  const auto tracks = tracksOf(log, {3.0, 5.0});
  EXPECT_EQ(of(tracks, TrackKind::pose).spans, (std::vector<TrackSpan>{{3.0, 5.0, 1.0}}));
  for (const TrackMark& mark : of(tracks, TrackKind::settings).marks) {
    EXPECT_GE(mark.time_s, 3.0);
    EXPECT_LE(mark.time_s, 5.0);
  }
}

TEST(ReviewSettings, AreTheSameOnesInTheSameOrder) {
  ScanState a, b;
  b.knobs.depth_mm = 90.0;
  const auto first = settingsOf(a), second = settingsOf(b);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t n = 0; n < first.size(); ++n) EXPECT_EQ(first[n].name, second[n].name);
}

}  // namespace
}  // namespace ew::review
