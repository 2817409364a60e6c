#pragma once

#include "ew/assessment/judging.h"
#include "ew/assessment/organ_coverage.h"
#include "ew/assessment/step_work.h"
#include "ew/core/figures.h"
#include "ew/library/case_truth.h"
#include "ew/library/step_answer.h"

namespace ew {

// The work of the kinds of steps, for workOf(), which has looked whether the case has what they ask for.
using Work = std::unique_ptr<StepWork>;

// Of the probe on the body, judged against what the case knows (scan_works.cpp).
[[nodiscard]] Work planeWork(const PlaneTask& task, const ReferencePlane& target, std::shared_ptr<const CaseGround> ground);
[[nodiscard]] Work sweepWork(const SweepTask& task, std::shared_ptr<const OrganVoxels> organ);
[[nodiscard]] Work freeWork(const FreeTask& task, std::shared_ptr<const CaseGround> ground);

// Of the frozen image (image_works.cpp).
/// @param tolerance in the unit of what is expected
[[nodiscard]] Work measureWork(const ReferenceMeasurement& expected, double tolerance);
[[nodiscard]] Work pointWork(const ReferencePoint& point);
[[nodiscard]] Work pointWork(std::shared_ptr<const OrganVoxels> organ);

// Without the body's truth (desk_works.cpp).
[[nodiscard]] Work readWork();
[[nodiscard]] Work watchWork();
[[nodiscard]] Work settingsWork(const SettingsTask& task);
[[nodiscard]] Work answerWork(const AnswerTask& task);

// What several of them share.
[[nodiscard]] Message noImage();
/// What was measured in an image, as an attempt keeps it.
[[nodiscard]] CaliperReading inWorld(const MeasurementSubmission& handed, const ScanState& image);

}  // namespace ew
