#include <algorithm>
#include <array>
#include <cmath>
#include <pugixml.hpp>
#include <type_traits>

#include "ew/core/numbers.h"
#include "ew/io/gating_fields.h"
#include "ew/io/safe_file.h"
#include "ew/io/sequence.h"
#include "files/header_fields.h"
#include "files/image_header.h"

namespace ew {
namespace {
using namespace detail;
namespace fs = std::filesystem;

/// The first attribute of these names, newest name first; null when there is none.
pugi::xml_attribute attributeOf(const pugi::xml_node& node, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const auto attribute = node.attribute(name)) return attribute;
  return {};
}

/// What VolumeReconstruction of device sets is known to say. What is not here is told as not known.
constexpr std::array kReconstructionFields{
    KnownField{"ImageCoordinateFrame", FieldTouches::geometry},
    KnownField{"OutputOrigin", FieldTouches::geometry},
    KnownField{"OutputExtent", FieldTouches::geometry},
    KnownField{"EnableFanAnglesAutoDetect", FieldTouches::geometry},
    KnownField{"PixelRejectionThreshold", FieldTouches::levels},
    KnownField{"ImportanceMaskFilename", FieldTouches::levels},
    KnownField{"SkipInterval", FieldTouches::count},
    KnownField{"Optimization"},
    KnownField{"FillHoles"},
    KnownField{"NumberOfThreads"},
    KnownField{"OutputVolumeFilename"},
    KnownField{"OutputVolDeviceName"},
};

Result<std::vector<double>> numbersOf(const fs::path& file, const pugi::xml_attribute& attribute, std::size_t count) {
  if (!attribute) return std::vector<double>();
  auto stated = statedNumbers(attribute.value(), count);
  if (!stated.isUsable)
    return badField(file, verbatim(attribute.name()), verbatim(attribute.value()), counted<"%1 finite number", "%1 finite numbers">(count));
  return std::move(stated.values);
}

/// Takes away what only says that nothing is set.
void dropUnset(DeviceSet& set) {
  const auto pairText = [](const glm::dvec2& pair) { return textOf(pair.x) + " " + textOf(pair.y); };
  if (set.clipSize_px && (set.clipSize_px->x <= 0.0 || set.clipSize_px->y <= 0.0)) {
    if (set.clipSize_px->x > 0.0 || set.clipSize_px->y > 0.0)
      set.notes.push_back(
          say<"The clip rectangle has the size %1, which is none; the whole images were taken.">(pairText(*set.clipSize_px)));
    set.clipSize_px.reset();
    set.clipOrigin_px.reset();
  }
  if (set.clipOrigin_px && !set.clipSize_px) {
    if (*set.clipOrigin_px != glm::dvec2(0.0) && *set.clipOrigin_px != glm::dvec2(-1.0))
      set.notes.push_back(
          say<"The clip rectangle begins at (%1) but has no size; the whole images were taken.">(pairText(*set.clipOrigin_px)));
    set.clipOrigin_px.reset();
  }
  if (set.fanAngles_deg && set.fanAngles_deg->x == set.fanAngles_deg->y) set.fanAngles_deg.reset();
  if (set.fanRadiusStart_px && *set.fanRadiusStart_px < 0.0) set.fanRadiusStart_px.reset();
  if (set.fanRadiusStop_px && *set.fanRadiusStop_px <= 0.0) set.fanRadiusStop_px.reset();
}

Result<void> readTransform(const fs::path& file, const pugi::xml_node& node, DeviceSet& set) {
  const std::string from = node.attribute("From").value();
  const std::string to = node.attribute("To").value();
  if (from.empty() || to.empty())
    return failure(
        ErrorCode::badField,
        say<"In %1, Transform is \"%2 to %3\", but two frame names (From and To) is needed; correct the header or export the file again.">(
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

/// Takes numbers out of VolumeReconstruction, each by its first name that is there.
class ReconstructionReader {
 public:
  ReconstructionReader(const fs::path& file, const pugi::xml_node& node)
      : file_(file), node_(node), fields_(kReconstructionFields, FieldTouches::nobodyKnows) {
    for (const auto& attribute : node.attributes()) fields_.meet(attribute.name(), attribute.value());
  }

  Result<void> take(std::optional<glm::dvec2>& target, std::initializer_list<const char*> names) {
    return take(names, 2, [&](const std::vector<double>& values) { target = glm::dvec2(values[0], values[1]); });
  }
  Result<void> take(std::optional<double>& target, std::initializer_list<const char*> names) {
    return take(names, 1, [&](const std::vector<double>& values) { target = values[0]; });
  }
  Result<void> takeSpacing(DeviceSet& set) {
    return take({"OutputSpacing"}, 3, [&](const std::vector<double>& mm) -> Result<void> {
      if (mm[0] > 0.0 && mm[1] > 0.0 && mm[2] > 0.0) {
        set.outputSpacing_mm = glm::dvec3(mm[0], mm[1], mm[2]);
      } else if (mm[0] <= 0.0 && mm[1] <= 0.0 && mm[2] <= 0.0) {
        set.notes.push_back(say<"The OutputSpacing of the device set is \"%1\", which is none; it was not used.">(
            shortened(node_.attribute("OutputSpacing").value())));
      } else {
        return badField(file_, verbatim("OutputSpacing"), verbatim(node_.attribute("OutputSpacing").value()),
                        say<"three numbers above 0 (mm)">());
      }
      return {};
    });
  }
  std::optional<std::string> text(const char* name) { return fields_.take(name); }
  HeaderFields& fields() { return fields_; }

 private:
  template <class Use>
  Result<void> take(std::initializer_list<const char*> names, std::size_t count, Use use) {
    const auto attribute = attributeOf(node_, names);
    const auto numbers = numbersOf(file_, attribute, count);
    if (!numbers) return passOn(numbers.error());
    fields_.use(attribute.name());
    if (numbers->empty()) return {};
    if constexpr (std::is_void_v<decltype(use(*numbers))>) {
      use(*numbers);
      return {};
    } else {
      return use(*numbers);
    }
  }

  const fs::path& file_;
  const pugi::xml_node& node_;
  HeaderFields fields_;
};

Result<void> readReconstruction(const fs::path& file, const pugi::xml_node& node, DeviceSet& set) {
  ReconstructionReader reader(file, node);
  if (auto read = reader.takeSpacing(set); !read) return read;
  if (auto read = reader.take(set.clipOrigin_px, {"ClipRectangleOrigin"}); !read) return read;
  if (auto read = reader.take(set.clipSize_px, {"ClipRectangleSize"}); !read) return read;
  if (auto read = reader.take(set.fanAngles_deg, {"FanAnglesDeg", "FanAngles"}); !read) return read;
  if (auto read = reader.take(set.fanOrigin_px, {"FanOriginPixel", "FanOrigin"}); !read) return read;
  if (auto read = reader.take(set.fanRadiusStart_px, {"FanRadiusStartPixel"}); !read) return read;
  // Before fans had two radii, their depth was the radius at which they end, in pixels too.
  if (auto read = reader.take(set.fanRadiusStop_px, {"FanRadiusStopPixel", "FanDepth"}); !read) return read;
  set.interpolation = reader.text("Interpolation");
  set.compounding = reader.text("CompoundingMode");
  if (const auto older = reader.text("Compounding"); older && !set.compounding)
    set.compounding = older;  // a switch, before there were modes: On or Off
  set.referenceFrame = reader.text("ReferenceCoordinateFrame").value_or("");
  HeaderFields& fields = reader.fields();
  if (fields.stated("ImageCoordinateFrame") == std::optional<std::string>("Image")) fields.use("ImageCoordinateFrame");
  if (lowerCase(fields.stated("EnableFanAnglesAutoDetect").value_or("")) != "true") fields.use("EnableFanAnglesAutoDetect");
  // Without an extent the origin is that of no grid: PLUS writes it so by default.
  if (!fields.stated("OutputExtent")) fields.use("OutputOrigin");
  dropUnset(set);
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
      const bool known = std::any_of(joined.transforms.begin(), joined.transforms.end(), [&](const NamedTransform& each) {
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
  DeviceSet stated;
  const auto take = [&](auto& target, std::string_view name) -> Result<void> {
    constexpr bool isPair = std::is_same_v<std::remove_cvref_t<decltype(target)>, std::optional<glm::dvec2>>;
    constexpr std::size_t count = isPair ? 2 : 1;
    for (const auto& [field, value] : sequence.otherFields) {
      if (field != name) continue;
      const auto found = statedNumbers(value, count);
      if (!found.isUsable)
        return failure(ErrorCode::badField,
                       count == 1 ? say<"The recording's %1 is \"%2\"; expected 1 number.">(field, shortened(value))
                                  : say<"The recording's %1 is \"%2\"; expected %3 numbers.">(field, shortened(value), count),
                       {{"field", field}, {"found", shortened(value)}});
      if (!found.isSet) return {};
      if constexpr (isPair)
        target = glm::dvec2(found.values[0], found.values[1]);
      else
        target = found.values[0];
      return {};
    }
    return {};
  };
  if (auto taken = take(stated.clipOrigin_px, fields::kClipOrigin); !taken) return passOn(taken.error());
  if (auto taken = take(stated.clipSize_px, fields::kClipSize); !taken) return passOn(taken.error());
  if (auto taken = take(stated.fanAngles_deg, fields::kFanAngles); !taken) return passOn(taken.error());
  if (auto taken = take(stated.fanOrigin_px, fields::kFanOrigin); !taken) return passOn(taken.error());
  if (auto taken = take(stated.fanRadiusStart_px, fields::kFanRadiusStart); !taken) return passOn(taken.error());
  if (auto taken = take(stated.fanRadiusStop_px, fields::kFanRadiusStop); !taken) return passOn(taken.error());
  dropUnset(stated);
  return stated;
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
  for (const NamedTransform& transform : set.transforms) {
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
