#include <algorithm>
#include <array>
#include <cmath>
#include <pugixml.hpp>

#include "ew/core/numbers.h"
#include "ew/io/safe_file.h"
#include "ew/io/sequence.h"
#include "files/header_fields.h"
#include "files/image_header.h"
#include "sweeps/field_statements.h"

namespace ew {
namespace {
using namespace detail;
namespace fs = std::filesystem;

/// What VolumeReconstruction of device sets is known to say. What is not here is told as not known.
constexpr std::array kReconstructionFields{
    FieldTableRow{"ImageCoordinateFrame", FieldTouches::geometry},
    FieldTableRow{"OutputOrigin", FieldTouches::geometry},
    FieldTableRow{"OutputExtent", FieldTouches::geometry},
    FieldTableRow{"EnableFanAnglesAutoDetect", FieldTouches::geometry},
    FieldTableRow{"PixelRejectionThreshold", FieldTouches::levels},
    FieldTableRow{"ImportanceMaskFilename", FieldTouches::levels},
    FieldTableRow{"SkipInterval", FieldTouches::count},
    FieldTableRow{"Optimization"},
    FieldTableRow{"FillHoles"},
    FieldTableRow{"NumberOfThreads"},
    FieldTableRow{"OutputVolumeFilename"},
    FieldTableRow{"OutputVolDeviceName"},
};

/// Takes the fields one after another, and what goes together of them.
Result<void> takeStated(std::span<const SetField> fields, const FieldStatements& from, DeviceSet& set) {
  bool statesSize = false;
  for (const SetField field : fields) {
    const auto taken = takeField(field, from, set);
    if (!taken) return passOn(taken.error());
    if (field == SetField::clipSize) statesSize = *taken != FieldState::absent;
  }
  if (!set.clipOrigin_px || set.clipSize_px) return {};
  const glm::dvec2 origin_px = *set.clipOrigin_px;
  if (!statesSize && origin_px != glm::dvec2(0.0) && origin_px != glm::dvec2(-1.0))
    set.notes.push_back(say<"The clip rectangle begins at (%1) but has no size; unless a clip is given, the whole images are taken.">(
        textOf(origin_px.x) + " " + textOf(origin_px.y)));
  set.clipOrigin_px.reset();
  return {};
}

Result<void> readTransform(const fs::path& file, const pugi::xml_node& node, DeviceSet& set) {
  const std::string from = node.attribute("From").value();
  const std::string to = node.attribute("To").value();
  if (from.empty() || to.empty())
    return failure(
        ErrorCode::badField,
        say<"In %1, Transform is \"%2 to %3\", but two frame names (From and To) are needed; correct the header or export the file again.">(
            quoted(file), shortened(from), shortened(to)),
        {{"file", file.string()},
         {"field", "Transform"},
         {"found", shortened(from + " to " + to)},
         {"expected", "two frame names (From and To)"}});
  const auto matrix = node.attribute("Matrix");
  const auto numbers = parseNumbers(matrix.value());
  if (!numbers || numbers->size() != 16 ||
      std::any_of(numbers->begin(), numbers->end(), [](double value) { return !std::isfinite(value); }))
    return badField(file, say<"the Matrix of %1 to %2">(from, to), verbatim(matrix.value()),
                    say<"16 finite numbers (4 x 4, row by row)">());
  std::array<double, 16> rows{};
  std::copy_n(numbers->begin(), 16, rows.begin());
  set.transforms.push_back({from, to, matrixFromRows(rows), PoseStatus::ok});
  return {};
}

Result<void> readReconstruction(const fs::path& file, const pugi::xml_node& node, DeviceSet& set) {
  HeaderFields fields(kReconstructionFields, FieldTouches::nobodyKnows, FieldsOf::deviceSet);
  for (const auto& attribute : node.attributes()) fields.meet(attribute.name(), attribute.value());
  FieldStatements stated;
  stated.look = [&](const std::string& name) -> std::optional<std::string> {
    const auto attribute = node.attribute(name.c_str());
    if (!attribute) return std::nullopt;
    fields.use(name);
    return attribute.value();
  };
  stated.refusal = [&](const std::string& name, const std::string& found, const Message& needed) {
    return badField(file, verbatim(name), verbatim(found), needed).value();
  };
  constexpr std::array all{SetField::spacing,  SetField::clipOrigin, SetField::clipSize,      SetField::fanAngles,   SetField::fanOrigin,
                           SetField::fanStart, SetField::fanStop,    SetField::interpolation, SetField::compounding, SetField::reference};
  if (auto taken = takeStated(all, stated, set); !taken) return taken;
  fields.use("Compounding");  // device sets that know modes still write the switch
  if (fields.stated("ImageCoordinateFrame") == std::optional<std::string>("Image")) fields.use("ImageCoordinateFrame");
  if (lowerCase(fields.stated("EnableFanAnglesAutoDetect").value_or("")) != "true") fields.use("EnableFanAnglesAutoDetect");
  // Without an extent the origin is that of no grid: PLUS writes it so by default.
  if (!fields.stated("OutputExtent")) fields.use("OutputOrigin");
  for (Message& note : fields.unused()) set.notes.push_back(std::move(note));
  return {};
}

}  // namespace

Result<DeviceSet> readDeviceSet(const fs::path& file) {
  const auto text = readTextFile(file);
  if (!text) return passOn(text.error());
  pugi::xml_document document;
  const auto parsed = document.load_buffer(text->data(), text->size());
  if (!parsed)
    return failure(ErrorCode::badHeader,
                   say<"%1 is not well-formed XML (%2 at byte %3); give the device set the sweep was recorded with.">(
                       quoted(file), verbatim(parsed.description()), parsed.offset),
                   {{"file", file.string()}});
  DeviceSet set;
  // The calibration program's own result file: the same transform, under another roof.
  if (const auto result = document.child("ProbeCalibrationResult")) {
    for (const auto& node : result.child("CalibrationResults").children("Transform"))
      if (auto read = readTransform(file, node, set); !read) return passOn(read.error());
    return set;
  }
  const auto root = document.child("PlusConfiguration");
  if (!root)
    return failure(
        ErrorCode::badHeader,
        say<"%1 is XML but no device set: it has no PlusConfiguration; give the device set the sweep was recorded with.">(quoted(file)),
        {{"file", file.string()}});
  for (const auto& definitions : root.children("CoordinateDefinitions"))
    for (const auto& node : definitions.children("Transform"))
      if (auto read = readTransform(file, node, set); !read) return passOn(read.error());
  if (const auto conversion = root.find_node([](const pugi::xml_node& node) { return std::string_view(node.name()) == "ScanConversion"; }))
    for (const auto& attribute : conversion.attributes()) set.scanConversion.emplace_back(attribute.name(), attribute.value());
  // Of a whole device set, or inside the device that reconstructs while it records.
  auto reconstruction = root.child("VolumeReconstruction");
  if (!reconstruction)
    reconstruction = root.find_node([](const pugi::xml_node& node) { return std::string_view(node.name()) == "VolumeReconstruction"; });
  if (reconstruction)
    if (auto read = readReconstruction(file, reconstruction, set); !read) return passOn(read.error());
  return set;
}

Result<DeviceSet> readDeviceSets(std::span<const std::filesystem::path> files) {
  DeviceSet joined;
  const auto fill = [](auto& field, auto& from) {
    if (!field) field = std::move(from);
  };
  for (const auto& file : files) {
    auto read = readDeviceSet(file);
    if (!read) return passOn(read.error());
    for (auto& transform : read->transforms) {
      const bool known = std::any_of(joined.transforms.begin(), joined.transforms.end(), [&](const FrameTransform& each) {
        return (each.from == transform.from && each.to == transform.to) || (each.from == transform.to && each.to == transform.from);
      });
      if (!known) joined.transforms.push_back(std::move(transform));
    }
    fill(joined.outputSpacing_mm, read->outputSpacing_mm);
    fill(joined.clipOrigin_px, read->clipOrigin_px);
    fill(joined.clipSize_px, read->clipSize_px);
    fill(joined.fanAngles_deg, read->fanAngles_deg);
    fill(joined.fanOrigin_px, read->fanOrigin_px);
    fill(joined.fanRadiusStart_px, read->fanRadiusStart_px);
    fill(joined.fanRadiusStop_px, read->fanRadiusStop_px);
    fill(joined.interpolation, read->interpolation);
    fill(joined.compounding, read->compounding);
    if (joined.referenceFrame.empty()) joined.referenceFrame = std::move(read->referenceFrame);
    joined.notes.insert(joined.notes.end(), read->notes.begin(), read->notes.end());
    if (joined.scanConversion.empty()) joined.scanConversion = std::move(read->scanConversion);
  }
  return joined;
}

Result<DeviceSet> clipStatedIn(const Sequence& sequence) {
  FieldStatements stated{.isRecording = true};
  stated.look = [&](const std::string& name) -> std::optional<std::string> {
    for (const auto& [field, value] : sequence.otherFields)
      if (field == name) return value;
    return std::nullopt;
  };
  stated.refusal = [](const std::string& name, const std::string& found, const Message& needed) {
    return failure(ErrorCode::badField, say<"The recording's %1 is \"%2\"; expected %3.">(name, shortened(found), needed),
                   {{"field", name}, {"found", shortened(found)}})
        .value();
  };
  constexpr std::array clip{SetField::clipOrigin, SetField::clipSize, SetField::fanAngles,
                            SetField::fanOrigin,  SetField::fanStart, SetField::fanStop};
  DeviceSet set;
  if (auto taken = takeStated(clip, stated, set); !taken) return passOn(taken.error());
  return set;
}

Result<void> writeDeviceSet(const DeviceSet& set, const fs::path& file) {
  if (lowerCase(file.extension().string()) != ".xml")
    return failure(ErrorCode::unsupported, say<"%1 has an ending that is not written; end its name in .xml.">(quoted(file)),
                   {{"file", file.string()}});
  pugi::xml_document document;
  auto root = document.append_child("PlusConfiguration");
  root.append_attribute("version") = "2.9";
  auto definitions = root.append_child("CoordinateDefinitions");
  const auto textOfAll = [](std::initializer_list<double> numbers) {
    std::string text;
    for (const double number : numbers) text += (text.empty() ? "" : " ") + textOf(number);
    return text;
  };
  for (const FrameTransform& transform : set.transforms) {
    auto node = definitions.append_child("Transform");
    node.append_attribute("From") = transform.from.c_str();
    node.append_attribute("To") = transform.to.c_str();
    std::string matrix;
    for (const double number : rowsOf(transform.matrix)) matrix += (matrix.empty() ? "" : " ") + textOf(number);
    node.append_attribute("Matrix") = matrix.c_str();
  }
  auto reconstruction = root.append_child("VolumeReconstruction");
  const auto add = [&](const char* name, const std::string& text) { reconstruction.append_attribute(name) = text.c_str(); };
  const auto addPair = [&](const char* name, const std::optional<glm::dvec2>& pair) {
    if (pair) add(name, textOfAll({pair->x, pair->y}));
  };
  if (const auto& spacing = set.outputSpacing_mm) add("OutputSpacing", textOfAll({spacing->x, spacing->y, spacing->z}));
  addPair("ClipRectangleOrigin", set.clipOrigin_px);
  addPair("ClipRectangleSize", set.clipSize_px);
  addPair("FanAnglesDeg", set.fanAngles_deg);
  addPair("FanOriginPixel", set.fanOrigin_px);
  if (set.fanRadiusStart_px) add("FanRadiusStartPixel", textOf(*set.fanRadiusStart_px));
  if (set.fanRadiusStop_px) add("FanRadiusStopPixel", textOf(*set.fanRadiusStop_px));
  if (set.interpolation) add("Interpolation", *set.interpolation);
  if (set.compounding) add("CompoundingMode", *set.compounding);
  if (!set.referenceFrame.empty()) add("ReferenceCoordinateFrame", set.referenceFrame);
  if (!set.scanConversion.empty()) {
    auto conversion = root.append_child("ScanConversion");
    for (const auto& [name, value] : set.scanConversion) conversion.append_attribute(name.c_str()) = value.c_str();
  }
  return writeFileSafely(file, [&](std::ostream& out) -> Result<void> {
    document.save(out, "  ");
    return {};
  });
}

}  // namespace ew
