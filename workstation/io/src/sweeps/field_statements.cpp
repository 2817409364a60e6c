#include "sweeps/field_statements.h"

#include <algorithm>
#include <vector>

#include "ew/core/numbers.h"
#include "files/image_header.h"

namespace ew::detail {
namespace {

/// How a field is called and what stands in it.
struct FieldRule {
  std::vector<std::string> names;  ///< newest first; a recording knows the newest alone
  std::size_t count = 0;           ///< of numbers; 0: it is a text
  NumbersKind kind = NumbersKind::place;
};

FieldRule ruleOf(SetField field) {
  switch (field) {
    case SetField::spacing:
      return {{"OutputSpacing"}, 3, NumbersKind::lengths};
    case SetField::clipOrigin:
      return {{"ClipRectangleOrigin"}, 2, NumbersKind::place};
    case SetField::clipSize:
      return {{"ClipRectangleSize"}, 2, NumbersKind::rectangle};
    case SetField::fanAngles:
      return {{"FanAnglesDeg", "FanAngles"}, 2, NumbersKind::interval};
    case SetField::fanOrigin:
      return {{"FanOriginPixel", "FanOrigin"}, 2, NumbersKind::place};
    case SetField::fanStart:
      return {{"FanRadiusStartPixel"}, 1, NumbersKind::distance};
    case SetField::fanStop:
      // Before fans had two radii, their depth was the radius at which they end, in pixels too.
      return {{"FanRadiusStopPixel", "FanDepth"}, 1, NumbersKind::reach};
    case SetField::interpolation:
      return {.names = {"Interpolation"}};
    case SetField::compounding:
      return {.names = {"CompoundingMode", "Compounding"}};  // a switch, before there were modes: On or Off
    case SetField::reference:
      return {.names = {"ReferenceCoordinateFrame"}};
  }
  return {};
}

/// What holds where nobody else says it either.
Message withoutIt(SetField field) {
  switch (field) {
    case SetField::spacing:
      return say<"unless it is given, the size of a voxel comes from the frames">();
    case SetField::clipOrigin:
      return say<"a clip begins at the first pixel">();
    case SetField::clipSize:
      return say<"unless a clip is given, the whole images are taken">();
    case SetField::fanAngles:
      return say<"unless a fan is given, none is cut out">();
    case SetField::fanOrigin:
      return say<"the apex of a fan is taken to be the first pixel">();
    case SetField::fanStart:
      return say<"a fan begins at its apex">();
    case SetField::fanStop:
      return say<"a fan ends with the image">();
    case SetField::interpolation:
      return say<"unless it is given, pixels are shared linearly">();
    case SetField::compounding:
      return say<"unless it is given, the mean of all views is taken">();
    case SetField::reference:
      return say<"unless a frame is named, the first of Reference, Tracker and World is taken">();
  }
  return {};
}

/// A size of which one side alone is none.
bool isClipOfOneSide(SetField field, const std::string& found) {
  if (field != SetField::clipSize) return false;
  const auto sides = parseNumbers(found);
  return sides && sides->size() == 2 && std::any_of(sides->begin(), sides->end(), [](double side) { return side > 0.0; });
}

Message noteOfUnset(SetField field, const FieldStatements& from, const std::string& name, const std::string& found) {
  if (isClipOfOneSide(field, found))
    return say<"The clip rectangle has the size %1, which is none; unless a clip is given, the whole images are taken.">(shortened(found));
  return from.isRecording ? say<"The recording states %1 \"%2\", which sets nothing; %3.">(name, shortened(found), withoutIt(field))
                          : say<"The device set states %1 \"%2\", which sets nothing; %3.">(name, shortened(found), withoutIt(field));
}

/// Older names that a device set states beside the one that counts. The switch of compounding is not told: device sets that know its modes
/// still write it.
void noteOutranked(SetField field, const FieldStatements& from, const std::vector<std::string>& names, const std::string& used,
                   DeviceSet& set) {
  if (field == SetField::compounding) return;
  const auto after = std::find(names.begin(), names.end(), used);
  for (auto older = std::next(after); older != names.end(); ++older)
    if (const auto found = from.look(*older); found && !trimmed(*found).empty())
      set.notes.push_back(say<"%1 \"%2\" of the device set is not used, because its %3 says it.">(*older, shortened(*found), used));
}

Message neededFor(SetField field, std::size_t count) {
  switch (field) {
    case SetField::spacing:
      return say<"three numbers above 0 (mm)">();
    case SetField::clipOrigin:
    case SetField::clipSize:
    case SetField::fanAngles:
    case SetField::fanOrigin:
    case SetField::fanStart:
    case SetField::fanStop:
    case SetField::interpolation:
    case SetField::compounding:
    case SetField::reference:
      return counted<"%1 finite number", "%1 finite numbers">(count);
  }
  return {};
}

void assign(SetField field, const std::vector<double>& numbers, const std::string& text, DeviceSet& set) {
  const auto pair = [&] { return glm::dvec2(numbers[0], numbers[1]); };
  switch (field) {
    case SetField::spacing:
      set.outputSpacing_mm = glm::dvec3(numbers[0], numbers[1], numbers[2]);
      return;
    case SetField::clipOrigin:
      set.clipOrigin_px = pair();
      return;
    case SetField::clipSize:
      set.clipSize_px = pair();
      return;
    case SetField::fanAngles:
      set.fanAngles_deg = pair();
      return;
    case SetField::fanOrigin:
      set.fanOrigin_px = pair();
      return;
    case SetField::fanStart:
      set.fanRadiusStart_px = numbers[0];
      return;
    case SetField::fanStop:
      set.fanRadiusStop_px = numbers[0];
      return;
    case SetField::interpolation:
      set.interpolation = text;
      return;
    case SetField::compounding:
      set.compounding = text;
      return;
    case SetField::reference:
      set.referenceFrame = text;
      return;
  }
}

}  // namespace

Result<FieldState> takeField(SetField field, const FieldStatements& from, DeviceSet& set) {
  FieldRule rule = ruleOf(field);
  if (from.isRecording) rule.names.resize(1);
  FieldState state = FieldState::absent;
  for (const std::string& name : rule.names) {
    const auto found = from.look(name);
    if (!found) continue;
    FieldNumbers stated;
    if (rule.count > 0)
      stated = statedNumbers(found, rule.count, rule.kind);
    else
      stated.state = trimmed(*found).empty() ? FieldState::notSet : FieldState::value;
    if (stated.state == FieldState::unusable) return tl::unexpected(from.refusal(name, *found, neededFor(field, rule.count)));
    state = stated.state;
    if (state == FieldState::notSet) {
      set.notes.push_back(noteOfUnset(field, from, name, *found));
      continue;  // an older name may say it
    }
    assign(field, stated.values, std::string(trimmed(*found)), set);
    noteOutranked(field, from, rule.names, name, set);
    return state;
  }
  return state;
}

}  // namespace ew::detail
