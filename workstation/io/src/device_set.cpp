#include <algorithm>
#include <array>
#include <cmath>
#include <pugixml.hpp>

#include "ew/core/numbers.h"
#include "ew/io/safe_file.h"
#include "ew/io/sequence.h"
#include "image_header.h"

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

Result<std::optional<std::vector<double>>> numbersOf(const fs::path& file, const pugi::xml_attribute& attribute, std::size_t count) {
  if (!attribute) return std::optional<std::vector<double>>();
  auto numbers = parseNumbers(attribute.value());
  if (!numbers || numbers->size() != count ||
      std::any_of(numbers->begin(), numbers->end(), [](double value) { return !std::isfinite(value); }))
    return badField(file, verbatim(attribute.name()), verbatim(attribute.value()), counted<"%1 finite number", "%1 finite numbers">(count));
  return std::optional(*std::move(numbers));
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

Result<void> readReconstruction(const fs::path& file, const pugi::xml_node& node, DeviceSet& set) {
  const auto vector2 = [&](std::optional<glm::dvec2>& target, std::initializer_list<const char*> names) -> Result<void> {
    const auto numbers = numbersOf(file, attributeOf(node, names), 2);
    if (!numbers) return passOn(numbers.error());
    if (*numbers) target = glm::dvec2((**numbers)[0], (**numbers)[1]);
    return {};
  };
  const auto scalar = [&](std::optional<double>& target, std::initializer_list<const char*> names) -> Result<void> {
    const auto numbers = numbersOf(file, attributeOf(node, names), 1);
    if (!numbers) return passOn(numbers.error());
    if (*numbers) target = (**numbers)[0];
    return {};
  };
  const auto spacing = node.attribute("OutputSpacing");
  const auto numbers = numbersOf(file, spacing, 3);
  if (!numbers) return passOn(numbers.error());
  if (*numbers) {
    const auto& mm = **numbers;
    if (!(mm[0] > 0.0 && mm[1] > 0.0 && mm[2] > 0.0))
      return badField(file, verbatim("OutputSpacing"), verbatim(spacing.value()), say<"three numbers above 0 (mm)">());
    set.outputSpacing_mm = glm::dvec3(mm[0], mm[1], mm[2]);
  }
  if (auto read = vector2(set.clipOrigin_px, {"ClipRectangleOrigin"}); !read) return read;
  if (auto read = vector2(set.clipSize_px, {"ClipRectangleSize"}); !read) return read;
  if (auto read = vector2(set.fanAngles_deg, {"FanAnglesDeg", "FanAngles"}); !read) return read;
  if (auto read = vector2(set.fanOrigin_px, {"FanOriginPixel", "FanOrigin"}); !read) return read;
  if (auto read = scalar(set.fanRadiusStart_px, {"FanRadiusStartPixel"}); !read) return read;
  if (auto read = scalar(set.fanRadiusStop_px, {"FanRadiusStopPixel"}); !read) return read;
  if (const auto text = node.attribute("Interpolation")) set.interpolation = text.value();
  if (const auto text = node.attribute("CompoundingMode")) {
    set.compounding = text.value();
  } else if (const auto older = node.attribute("Compounding")) {
    set.compounding = older.value();  // a switch, before there were modes: On or Off
  }
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
  if (const auto reconstruction = root.child("VolumeReconstruction"))
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
    if (joined.scanConversion.empty()) joined.scanConversion = std::move(read->scanConversion);
  }
  return joined;
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
