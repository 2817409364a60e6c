#include "ew/io/sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "ew/core/numbers.h"
#include "files/image_header.h"
#include "sweeps/usable_transform.h"

namespace ew {
namespace {

constexpr std::string_view kImage = "Image";
constexpr std::string_view kImagePlane = "Picture";  ///< of an imported image: mm from its upper left pixel

bool sameFrames(const FrameTransform& a, const FrameTransform& b) {
  return (a.from == b.from && a.to == b.to) || (a.from == b.to && a.to == b.from);
}

/// All transforms that hold for a frame: the calibration's, and the frame's own where the calibration says nothing.
std::vector<FrameTransform> transformsOf(const SequenceFrame& frame, std::span<const FrameTransform> calibration) {
  std::vector<FrameTransform> all(calibration.begin(), calibration.end());
  for (const FrameTransform& own : frame.transforms)
    if (std::none_of(calibration.begin(), calibration.end(), [&](const FrameTransform& given) { return sameFrames(given, own); })) {
      all.push_back(own);
      detail::giveThickness(all.back());
    }
  return all;
}

/// The names alone: every transform counts, whatever its status and numbers are.
std::vector<FrameTransform> namesOnly(std::span<const FrameTransform> transforms) {
  std::vector<FrameTransform> names;
  std::set<std::pair<std::string_view, std::string_view>> known;
  for (const FrameTransform& transform : transforms)
    if (known.emplace(transform.from, transform.to).second)
      names.push_back({transform.from, transform.to, glm::dmat4(1.0), PoseStatus::ok});
  return names;
}

std::vector<FrameTransform> allNames(const Sequence& sequence, std::span<const FrameTransform> calibration) {
  std::vector<FrameTransform> names = namesOnly(calibration);
  std::set<std::pair<std::string, std::string>> known;
  for (const FrameTransform& transform : names) known.emplace(transform.from, transform.to);
  for (const SequenceFrame& frame : sequence.frames)
    for (const FrameTransform& transform : frame.transforms)
      if (known.emplace(transform.from, transform.to).second)
        names.push_back({transform.from, transform.to, glm::dmat4(1.0), PoseStatus::ok});
  return names;
}

/// "A", "A and B", "A, B and C".
Message listed(const std::vector<std::string>& names) {
  std::vector<Message> all;
  for (const std::string& name : names) all.push_back(verbatim(name));
  if (all.size() < 2) return joined(std::move(all));
  Message last = std::move(all.back());
  all.pop_back();
  return say<"%1 and %2">(joined(std::move(all), ", "), std::move(last));
}

/// @param reachable, others frames that a chain from Image leads to, and those beside them
Message noWay(const std::vector<std::string>& reachable, const std::set<std::string>& others, const Message& goal, const Message& advice) {
  const Message apart = listed({others.begin(), others.end()});
  if (reachable.empty())
    return others.empty()
               ? say<"There is no way from the pixels (frame Image) to %1: nothing can be reached from Image; %2.">(goal, advice)
               : say<"There is no way from the pixels (frame Image) to %1: nothing can be reached from Image, and %2 stand apart; %3.">(
                     goal, apart, advice);
  return others.empty()
             ? say<"There is no way from the pixels (frame Image) to %1: from Image only %2 can be reached; %3.">(goal, listed(reachable),
                                                                                                                  advice)
             : say<"There is no way from the pixels (frame Image) to %1: from Image only %2 can be reached, and %3 stand apart; %4.">(
                   goal, listed(reachable), apart, advice);
}

tl::unexpected<Error> noChain(const Sequence& sequence, std::span<const FrameTransform> names, bool calibrated, std::string_view toFrame) {
  const auto reachable = reachableFrom(names, kImage);
  std::set<std::string> others;
  for (const FrameTransform& name : names) {
    others.insert(name.from);
    others.insert(name.to);
  }
  for (const std::string& name : reachable) others.erase(name);
  others.erase(std::string(kImage));
  const bool tracked =
      std::any_of(sequence.frames.begin(), sequence.frames.end(), [](const SequenceFrame& frame) { return !frame.transforms.empty(); });
  // Imported images know the size of a pixel and nothing else: brought "to the frame" they reach, they would all lie in one place.
  const bool unplaced = tracked && std::all_of(names.begin(), names.end(),
                                               [&](const FrameTransform& one) { return one.from == kImage && one.to == kImagePlane; });
  const Message goal = toFrame.empty() ? say<"Reference, Tracker or World">() : verbatim(std::string(toFrame));
  if (unplaced)
    return failure(ErrorCode::missingCalibration,
                   say<"The images of this recording know the size of their pixels, but not where the probe was; say how it moved, as a "
                       "motor file or a file of poses does.">(),
                   {{"from", std::string(kImage)}, {"to", goal.english()}, {"ask", "motor"}});
  Message advice;
  if (!tracked)
    advice = say<
        "the recording holds no tracked poses, so it cannot be placed: choose one recorded with a tracker, give the file that holds its "
        "poses, or say how a motor moved the probe">();
  else if (reachable.empty() && !calibrated)
    advice = others.contains("Probe") ? say<"give the device set (.xml) with the calibration from Image to Probe">()
                                      : say<"give the device set (.xml) with the calibration from Image to the tracked probe">();
  else if (reachable.empty())
    advice = say<"the device set given has no transform from or to Image, give the one this sweep was recorded with">();
  else if (!toFrame.empty())
    advice = say<"choose one of those frames, or give the device set (.xml) that leads on">();
  else
    advice = say<"name one of those frames as the target, or give the device set (.xml) that leads on">();
  std::string targets;
  for (const std::string& name : reachable) targets += (targets.empty() ? "" : ",") + name;
  return failure(ErrorCode::missingCalibration, noWay(reachable, others, goal, advice),
                 {{"to", std::string(toFrame)},
                  {"reachable", targets},
                  {"ask", !tracked            ? "motor"
                          : reachable.empty() ? "calibration"
                                              : "frame"},
                  {"frames", std::to_string(sequence.frames.size())}});
}

SweepPoses posesTo(const Sequence& sequence, std::span<const FrameTransform> calibration, std::string_view toFrame) {
  SweepPoses poses;
  poses.toFrame = toFrame;
  poses.imageToWorld.resize(sequence.frames.size());
  for (std::size_t i = 0; i < sequence.frames.size(); ++i) {
    const SequenceFrame& frame = sequence.frames[i];
    const auto transforms = transformsOf(frame, calibration);
    const auto found = chain(transforms, kImage, toFrame);
    if (found && frame.imageStatus != PoseStatus::invalid) {
      poses.imageToWorld[i] = Transform<frame::World, frame::Image>{*found};
      ++poses.usable;
    } else if (found) {
      ++poses.invalid;
    } else {
      // A transform marked MISSING is as good as not written: what is left tells a broken chain from an absent one.
      std::vector<FrameTransform> written;
      std::copy_if(transforms.begin(), transforms.end(), std::back_inserter(written),
                   [](const FrameTransform& transform) { return transform.status != PoseStatus::missing; });
      ++(chain(namesOnly(written), kImage, toFrame) ? poses.invalid : poses.missing);
    }
  }
  return poses;
}

/// Percent by which the worst pair of columns is off the right angle.
double skewPercent(const glm::dmat4& matrix) {
  double worst = 0.0;
  for (int a = 0; a < 3; ++a)
    for (int b = a + 1; b < 3; ++b)
      worst = std::max(worst, std::abs(glm::dot(glm::normalize(glm::dvec3(matrix[a])), glm::normalize(glm::dvec3(matrix[b])))));
  return 100.0 * worst;
}

std::string withOneDecimal(double value) { return textOf(std::round(value * 10.0) / 10.0); }

void noteGeometry(const glm::dmat4& imageToWorld, std::vector<Message>& notes) {
  if (const double skew = skewPercent(imageToWorld); skew > 1.0)
    notes.push_back(say<"The calibration's axes are up to %1 % off the right angle; they were used as they are.">(withOneDecimal(skew)));
  if (glm::determinant(glm::dmat3(imageToWorld)) < 0.0)
    notes.push_back(say<"The calibration is mirrored (a left-handed frame); it was used as it is.">());
}

void noteTimes(const Sequence& sequence, std::vector<Message>& notes) {
  std::size_t equal = 0;
  std::size_t backwards = 0;
  std::optional<double> before_s;
  for (const SequenceFrame& frame : sequence.frames) {
    if (!frame.time_s) continue;
    if (before_s && *frame.time_s == *before_s) ++equal;
    if (before_s && *frame.time_s < *before_s) ++backwards;
    before_s = frame.time_s;
  }
  if (equal > 0)
    notes.push_back(
        detail::counted<"%1 frame carries the same time as the frame before.", "%1 frames carry the same time as the frame before.">(
            equal));
  if (backwards > 0)
    notes.push_back(detail::counted<"Time runs backwards at %1 frame; the order in the file was kept.",
                                    "Time runs backwards at %1 frames; the order in the file was kept.">(backwards));
}

void noteOverride(const Sequence& sequence, std::span<const FrameTransform> calibration, std::vector<Message>& notes) {
  std::set<std::pair<std::string, std::string>> replaced;
  for (const SequenceFrame& frame : sequence.frames)
    for (const FrameTransform& own : frame.transforms)
      if (std::any_of(calibration.begin(), calibration.end(), [&](const FrameTransform& given) { return sameFrames(given, own); }))
        replaced.emplace(own.from, own.to);
  for (const auto& [from, to] : replaced)
    notes.push_back(say<"The recording and the device set both say %1 to %2; the device set was used.">(from, to));
}

/// The calibration's transforms, flat images given their thickness.
std::vector<FrameTransform> givenBy(const DeviceSet* calibration, const Sequence& sequence, std::vector<Message>& notes) {
  std::vector<FrameTransform> given;
  if (calibration != nullptr) given = calibration->transforms;
  std::set<std::string> thickened;
  for (FrameTransform& transform : given)
    if (detail::giveThickness(transform)) thickened.insert(transform.to);
  for (const SequenceFrame& frame : sequence.frames)
    for (const FrameTransform& own : frame.transforms)
      if (FrameTransform copy = own; own.from == kImage && detail::giveThickness(copy)) thickened.insert(own.to);
  for (const std::string& to : thickened)
    notes.push_back(
        say<"The matrix of Image to %1 has 0 in its third column, as people write for flat images; it was given the thickness of a pixel.">(
            to));
  return given;
}

tl::unexpected<Error> uselessMatrix(const FrameTransform& transform, Message sentence) {
  return failure(ErrorCode::badField, std::move(sentence),
                 {{"field", transform.from + " to " + transform.to}, {"found", detail::problemOf(transform).english()}});
}

/// The matrix that no frame could do without and that cannot be used, where that is why none has a pose.
std::optional<Error> matrixToBlame(const Sequence& sequence, std::span<const FrameTransform> given, std::string_view toFrame) {
  std::vector<FrameTransform> usable;
  for (const FrameTransform& transform : given)
    if (detail::isUsable(transform)) usable.push_back(transform);
  if (usable.size() < given.size() && !chain(allNames(sequence, usable), kImage, toFrame)) {
    const auto blamed = std::find_if(given.begin(), given.end(), [](const auto& transform) { return !detail::isUsable(transform); });
    return uselessMatrix(*blamed, say<"The matrix of %1 to %2 in the device set cannot be used: %3; correct it, or calibrate again.">(
                                      blamed->from, blamed->to, detail::problemOf(*blamed)))
        .value();
  }
  // A tracker that says OK and writes no pose.
  const auto useless = [](const FrameTransform& own) { return own.status == PoseStatus::ok && !detail::isUsable(own); };
  const FrameTransform* blamed = nullptr;
  for (const SequenceFrame& frame : sequence.frames) {
    const auto found = std::find_if(frame.transforms.begin(), frame.transforms.end(), [&](const FrameTransform& own) {
      return useless(own) && (blamed == nullptr || sameFrames(own, *blamed));
    });
    if (found == frame.transforms.end()) return std::nullopt;
    if (blamed == nullptr) blamed = &*found;
  }
  if (blamed == nullptr) return std::nullopt;
  return uselessMatrix(*blamed,
                       say<"The recording's matrix of %1 to %2 cannot be used in any frame although it is marked as valid: %3; export the "
                           "recording again.">(blamed->from, blamed->to, detail::problemOf(*blamed)))
      .value();
}

}  // namespace

Result<SweepPoses> sweepPoses(const Sequence& sequence, const DeviceSet* calibration, std::string_view toFrame) {
  std::vector<Message> thickness;
  const std::vector<FrameTransform> given = givenBy(calibration, sequence, thickness);
  const auto names = allNames(sequence, given);
  constexpr std::array<std::string_view, 3> usual{"Reference", "Tracker", "World"};
  const std::span<const std::string_view> wanted = toFrame.empty() ? std::span<const std::string_view>(usual) : std::span(&toFrame, 1);
  std::optional<SweepPoses> best;
  std::vector<Message> notes;
  for (const std::string_view target : wanted) {
    if (!chain(names, kImage, target)) continue;
    SweepPoses found = posesTo(sequence, given, target);
    if (found.usable == 0 && toFrame.empty())
      notes.push_back(say<"No frame has a valid way to %1, so it was not used.">(std::string(target)));
    const bool better = !best || (best->usable == 0 && found.usable > 0);
    if (better) best = std::move(found);
    if (best->usable > 0) break;
  }
  if (!best) return noChain(sequence, names, calibration != nullptr, toFrame);
  if (best->usable == 0) {
    if (auto blamed = matrixToBlame(sequence, given, best->toFrame)) return passOn(*std::move(blamed));
    return failure(
        ErrorCode::noValidPose,
        detail::counted<
            "Of %1 frame, none has a usable pose to %2: %3; check that the tracker saw the probe, or choose another target frame.",
            "Of %1 frames, none has a usable pose to %2: %3; check that the tracker saw the probe, or choose another target frame.">(
            sequence.frames.size(), best->toFrame,
            detail::counted<"%1 is INVALID and %2 missing", "%1 are INVALID and %2 missing">(best->invalid, best->missing)),
        {{"to", best->toFrame}, {"invalid", std::to_string(best->invalid)}, {"missing", std::to_string(best->missing)}});
  }
  best->notes = std::move(notes);
  best->notes.insert(best->notes.end(), thickness.begin(), thickness.end());
  if (toFrame.empty()) best->notes.push_back(say<"The poses of the images are those in the recording's frame %1.">(best->toFrame));
  if (best->invalid + best->missing > 0)
    best->notes.push_back(detail::counted<"%1 frame with an INVALID and %2 with a missing pose were left out; %3.",
                                          "%1 frames with an INVALID and %2 with a missing pose were left out; %3.">(
        best->invalid, best->missing, detail::counted<"%1 is used", "%1 are used">(best->usable)));
  const auto first = std::find_if(best->imageToWorld.begin(), best->imageToWorld.end(), [](const auto& pose) { return pose.has_value(); });
  noteGeometry((*first)->matrix, best->notes);
  noteOverride(sequence, given, best->notes);
  noteTimes(sequence, best->notes);
  return *std::move(best);
}

}  // namespace ew
