#pragma once

#include "ew/io/image_file.h"
#include "ew/library/step_answer.h"
#include "reports/reports_world.h"

namespace ew::test {

/// A class of nine in the world's lesson, scored, rated by two people and commented; the first attempt is the expert's.
inline std::vector<std::filesystem::path> exampleClass(const AssessedWorld& world) {
  std::vector<std::filesystem::path> folders;
  for (int n = 0; n < 9; ++n) {
    const double wander = 3.0 * n;
    const auto scan = [wander](double aside) {
      return scanAlong(
          [=](double t) {
            return heldAt(30.0 * std::cos(0.5 * t) * (1.0 - t / 20.0) + 0.3 * wander * std::sin(3.0 * t) * (1.0 - t / 20.0) + aside,
                          0.4 * wander * (1.0 - t / 20.0), 40.0 * (1.0 - t / 20.0) + wander * std::sin(1.7 * t) * (1.0 - t / 20.0));
          },
          20.0);
    };
    const auto sweep =
        scanAlong([wander](double t) { return heldAt(-25.0 + (2.5 - 0.05 * wander) * t, 0.0, 0.5 * wander * std::sin(t)); }, 20.0);
    const double off_mm = 0.4 * wander;
    folders.push_back(world.keep("20261101-1" + std::to_string(n) + "0000-aaaaaaaa",
                                 {{.step = "read", .verdict = StepVerdict::passed, .score = 1.0},
                                  {.step = "plane", .scan = scan(off_mm), .seconds = 20.0 + 9.0 * n},
                                  {.step = "sweep", .scan = sweep, .seconds = 35.0 + 5.0 * n},
                                  {.step = "measure",
                                   .scan = scan(0.0),
                                   .answer = MeasurementAnswer{40.0 + off_mm, "mm", "distance", {{-20, 0, 0}, {20.0 + off_mm, 0, 0}}}},
                                  {.step = "point", .scan = scan(0.0), .answer = PointAnswer{{off_mm, 0.0, 0.0}}},
                                  {.step = "answer", .answer = OptionsAnswer{{n % 3 == 2 ? 1U : 0U}}}}));
  }
  AssessmentPlan plan = *readPlan(world.library(), "ball", "about-balls");
  plan.expertAttempt = folders[0].filename();
  EXPECT_TRUE(succeeded(keepPlan(world.library(), plan)));
  (void)assess(folders, world.library());
  plan.at("plane").metrics = {{"path_length", 1.0, 600.0, 100.0}};
  EXPECT_TRUE(succeeded(keepPlan(world.library(), plan)));
  (void)assess(folders, world.library());
  for (std::size_t n = 0; n < folders.size(); ++n) {
    const int good = 5 - static_cast<int>(n / 2);
    EXPECT_TRUE(succeeded(keepRating(folders[n], *someForm(), ratedBy("Rita", good, std::max(1, good - 1)).rating)));
    EXPECT_TRUE(succeeded(keepRating(folders[n], *someForm(), ratedBy("Sven", std::max(1, good - static_cast<int>(n % 2)), good).rating)));
  }
  ReviewComment comment;
  comment.id = "a";
  comment.stepId = "plane";
  comment.time_s = 12.4;
  comment.text = "Here the probe slides off the plane that it had found already; <wait> & look.";
  EXPECT_TRUE(succeeded(writeComments(folders[4], {"Rita", {comment}, {}})));
  std::vector<std::uint8_t> grey(320 * 240);
  for (std::size_t n = 0; n < grey.size(); ++n) grey[n] = static_cast<std::uint8_t>((n % 320) * (n / 320) / 300);
  EXPECT_TRUE(succeeded(writeImage(ImageView<const std::uint8_t>{grey.data(), 320, 240, 320}, 0.3, folders[4] / "stored.png")));
  const auto kept = AttemptFolder::open(folders[4]);
  Attempt illustrated = kept->attempt();
  for (StepOutcome& outcome : illustrated.outcomes)
    if (outcome.stepId == "plane") outcome.images = {"stored.png"};
  writeText(folders[4] / "attempt.json", jsonOf(illustrated).dump());
  (void)assess(folders, world.library());
  return folders;
}

/// Where a person may look at what tests write: EW_SCREENSHOTS, as the window's images. Empty: nobody does.
inline std::filesystem::path lookedAt() {
  const char* folder = std::getenv("EW_SCREENSHOTS");
  return folder == nullptr ? std::filesystem::path() : std::filesystem::path(folder);
}

}  // namespace ew::test
