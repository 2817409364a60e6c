#include "ew/export/image_record.h"

#include <nlohmann/json.hpp>

#include "ew/core/data_file.h"
#include "ew/core/json_fields.h"
#include "ew/core/word_table.h"
#include "ew/imaging/settings_json.h"

namespace ew {
namespace {

using nlohmann::json;
using Kind = RegionCalibration::Kind;

constexpr std::size_t kLongestStoredText = 10000;
constexpr double kLatest_s = 253402300799.0;  // the end of the year 9999
constexpr WordTable<Kind, 4> kRegionWords{
    {{"picture", Kind::image}, {"strip", Kind::strip}, {"colour", Kind::colour}, {"spectrum", Kind::spectrum}}};

json jsonOfDoppler(const RegionCalibration::Doppler& doppler) {
  json written = {{"prf_hz", doppler.prf_hz},
                  {"carrier_hz", doppler.carrier_hz},
                  {"steering_deg", doppler.steering_deg},
                  {"angle_deg", doppler.angle_deg}};
  if (doppler.volume_px) written["volume_px"] = {doppler.volume_px->x, doppler.volume_px->y};
  return written;
}

RegionCalibration::Doppler dopplerIn(const JsonFields& fields) {
  RegionCalibration::Doppler doppler{.prf_hz = fields.number("prf_hz", 0.0, 1e6),
                                     .carrier_hz = fields.number("carrier_hz", 0.0, 1e9),
                                     .steering_deg = fields.number("steering_deg", -90.0, 90.0),
                                     .angle_deg = fields.number("angle_deg", -90.0, 90.0)};
  if (const auto at = fields.numbers("volume_px", 2, 2, -65535, 65535, false); at.size() == 2)
    doppler.volume_px = {static_cast<int>(at[0]), static_cast<int>(at[1])};
  return doppler;
}

json jsonOfRegion(const RegionCalibration& region) {
  json written = {{"kind", wordIn(kRegionWords, region.kind)},
                  {"rect_px", {region.rect.x, region.rect.y, region.rect.width, region.rect.height}},
                  {"delta", {region.delta.x, region.delta.y}},
                  {"reference_px", {region.reference_px.x, region.reference_px.y}},
                  {"reference_value", {region.referenceValue.x, region.referenceValue.y}}};
  if (region.doppler) written["doppler"] = jsonOfDoppler(*region.doppler);
  return written;
}

RegionCalibration regionIn(const JsonFields& fields) {
  constexpr double kFarthest = 1e9;
  RegionCalibration region;
  region.kind = fields.word("kind", kRegionWords);
  const auto rect = fields.numbers("rect_px", 4, 4, -65535, 65535);
  const auto delta = fields.numbers("delta", 2, 2, -kFarthest, kFarthest);
  const auto reference = fields.numbers("reference_px", 2, 2, -kFarthest, kFarthest);
  const auto value = fields.numbers("reference_value", 2, 2, -kFarthest, kFarthest);
  if (!fields.good()) return region;
  region.rect = {static_cast<int>(rect[0]), static_cast<int>(rect[1]), static_cast<int>(rect[2]), static_cast<int>(rect[3])};
  region.delta = {delta[0], delta[1]};
  region.reference_px = {static_cast<int>(reference[0]), static_cast<int>(reference[1])};
  region.referenceValue = {value[0], value[1]};
  if (fields.has("doppler")) region.doppler = dopplerIn(fields.object("doppler"));
  return region;
}

json jsonOfStudy(const DicomStudy& study) {
  json patient = {{"name", study.patient.name}, {"id", study.patient.id}, {"sex", study.patient.sex}};
  if (study.patient.age_years) patient["age_years"] = *study.patient.age_years;
  return {{"patient", std::move(patient)},   {"title", study.title},
          {"region", study.region},          {"operators", study.operators},
          {"study_uid", study.studyUid},     {"pictures_uid", study.imagesUid},
          {"reports_uid", study.reportsUid}, {"begun_s", study.begun.time_since_epoch().count()}};
}

std::string textIn(const JsonFields& fields, std::string_view key) { return fields.text(key, "", 0, kLongestStoredText); }

std::string uidIn(const JsonFields& fields, std::string_view key) {
  std::string uid = fields.text(key);
  if (fields.good() && !isDicomUid(uid)) fields.refuse(key, say<"a unique identifier of DICOM">());
  return uid;
}

std::chrono::sys_seconds momentIn(const JsonFields& fields, std::string_view key) {
  return std::chrono::sys_seconds(std::chrono::seconds(fields.whole(key, 0, static_cast<long long>(kLatest_s))));
}

DicomStudy studyIn(const JsonFields& fields) {
  DicomStudy study;
  const JsonFields patient = fields.object("patient");
  study.patient = {textIn(patient, "name"), textIn(patient, "id"), textIn(patient, "sex"), {}};
  if (patient.has("age_years")) study.patient.age_years = static_cast<int>(patient.whole("age_years", 0, 200));
  study.title = textIn(fields, "title");
  study.region = textIn(fields, "region");
  study.operators = textIn(fields, "operators");
  study.studyUid = uidIn(fields, "study_uid");
  study.imagesUid = uidIn(fields, "pictures_uid");
  study.reportsUid = uidIn(fields, "reports_uid");
  study.begun = momentIn(fields, "begun_s");
  return study;
}

}  // namespace

json toJson(const ImageRecord& image) {
  const DicomImageOptions& options = image.options;
  json regions = json::array();
  for (const RegionCalibration& region : image.regions) regions.push_back(jsonOfRegion(region));
  return {{"format", kStoredImageFormat},
          {"instance_uid", options.instanceUid},
          {"number", options.number},
          {"probe", toJson(options.probe)},
          {"probe_id", options.probe.id},
          {"carrier_hz", options.carrier_hz},
          {"depth_mm", options.depth_mm},
          {"label", options.label},
          {"taken_s", options.taken.time_since_epoch().count()},
          {"regions", std::move(regions)},
          {"caption", image.caption},
          {"has_left", image.hasLeft},
          {"study", jsonOfStudy(image.study)}};
}

Result<ImageRecord> storedImageFromJson(const json& document, const Message& where) {
  JsonReading reading(where);
  const JsonFields fields(document, reading);
  requireFormat(fields, kStoredImageFormat);
  ImageRecord image;
  image.options.instanceUid = uidIn(fields, "instance_uid");
  image.options.number = static_cast<int>(fields.whole("number", 1, 1000000));
  image.options.carrier_hz = fields.number("carrier_hz", 0.0, 1e9);
  image.options.depth_mm = fields.number("depth_mm", 0.0, 1e5);
  image.options.label = textIn(fields, "label");
  image.options.taken = momentIn(fields, "taken_s");
  for (const JsonFields& each : fields.objects("regions", 0, 100)) image.regions.push_back(regionIn(each));
  image.caption = textIn(fields, "caption");
  image.hasLeft = fields.flag("has_left");
  image.study = studyIn(fields.object("study"));
  const JsonFields probe = fields.object("probe");
  if (reading.problem()) return passOn(*reading.problem());
  auto read = probeFromJson(probe.value(), textIn(fields, "probe_id"), where);
  if (!read) return passOn(read.error());
  image.options.probe = std::move(*read);
  return image;
}

}  // namespace ew
