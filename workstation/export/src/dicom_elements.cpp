#include "dicom_elements.h"

#include <dcmtk/dcmdata/dcostrmb.h>
#include <dcmtk/oflog/oflog.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <mutex>

#include "ew/core/contract.h"
#include "ew/core/version.h"

namespace ew::exporting {
namespace {

std::string twoDigits(unsigned value) { return {static_cast<char>('0' + value / 10), static_cast<char>('0' + value % 10)}; }

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

std::string sexOf(const std::string& sex) { return sex == "female" ? "F" : sex == "male" ? "M" : sex == "other" ? "O" : ""; }

std::string ageOf(const std::optional<int>& age_years) {
  if (!age_years || *age_years < 0 || *age_years > 999) return {};
  std::string digits = std::to_string(*age_years);
  return std::string(3 - digits.size(), '0') + digits + "Y";
}

}  // namespace

Message quoted(const std::filesystem::path& file) { return verbatim("'" + file.string() + "'"); }

void quietDcmtk() {
  static std::once_flag once;
  std::call_once(once, [] { OFLog::configure(OFLogger::OFF_LOG_LEVEL); });
}

std::string fitting(std::string_view text, std::size_t most, bool isParted) {
  if (text.size() > most) {
    while (most > 0 && continues(text[most])) --most;
    text = text.substr(0, most);
  }
  std::string fitted;
  for (const char c : text) {
    const bool isControl = static_cast<unsigned char>(c) < 0x20U || c == 0x7F;
    fitted += isControl || (isParted && c == '\\') ? ' ' : c;
  }
  while (!fitted.empty() && fitted.back() == ' ') fitted.pop_back();
  return fitted;
}

std::string personName(std::string_view name) {
  std::string plain = fitting(name, 62);
  for (char& c : plain)
    if (c == '^' || c == '=') c = ' ';
  const auto last = plain.rfind(' ');
  return last == std::string::npos ? plain : plain.substr(last + 1) + "^" + plain.substr(0, last);
}

std::string dicomDate(std::chrono::sys_seconds time) {
  const std::chrono::year_month_day day(std::chrono::floor<std::chrono::days>(time));
  std::string year = std::to_string(static_cast<int>(day.year()));
  year.insert(0, 4 - std::min<std::size_t>(4, year.size()), '0');
  return year + twoDigits(static_cast<unsigned>(day.month())) + twoDigits(static_cast<unsigned>(day.day()));
}

std::string dicomTime(std::chrono::sys_seconds time) {
  const std::chrono::hh_mm_ss clock(time - std::chrono::floor<std::chrono::days>(time));
  return twoDigits(static_cast<unsigned>(clock.hours().count())) + twoDigits(static_cast<unsigned>(clock.minutes().count())) +
         twoDigits(static_cast<unsigned>(clock.seconds().count()));
}

std::string decimalString(double value) {
  EW_EXPECTS(std::isfinite(value));
  constexpr int kMost = 16;
  std::array<char, 40> digits{};
  for (int precision = 15; precision > 0; --precision) {
    const auto [end, status] = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, precision);
    if (status == std::errc() && end - digits.data() <= kMost) return {digits.data(), end};
  }
  return "0";
}

void Elements::keep(const OFCondition& condition, const char* what) {
  if (condition.bad() && refused_.empty()) refused_ = std::string(what) + ": " + condition.text();
}

void Elements::text(const DcmTag& tag, const std::string& value) {
  DcmTag named(tag);
  keep(item_.putAndInsertOFStringArray(tag, OFString(value.c_str())), named.getTagName());
}

void Elements::whole(const DcmTag& tag, std::uint32_t value) {
  DcmTag named(tag);
  if (named.getEVR() == EVR_UL)
    keep(item_.putAndInsertUint32(tag, value), named.getTagName());
  else
    keep(item_.putAndInsertUint16(tag, static_cast<Uint16>(value)), named.getTagName());
}

void Elements::signedWhole(const DcmTag& tag, std::int32_t value) {
  DcmTag named(tag);
  keep(item_.putAndInsertSint32(tag, value), named.getTagName());
}

void Elements::real(const DcmTag& tag, double value) {
  DcmTag named(tag);
  keep(item_.putAndInsertFloat64(tag, value), named.getTagName());
}

void Elements::attribute(const DcmTag& tag, const DcmTagKey& names) {
  DcmTag named(tag);
  keep(item_.putAndInsertTagKey(tag, names), named.getTagName());
}

Result<void> Elements::check() const {
  if (refused_.empty()) return {};
  return failure(ErrorCode::internal,
                 say<"A DICOM object could not be made (%1); check that DCMTK and its dictionary are installed.">(verbatim(refused_)));
}

void putPatientAndStudy(Elements& elements, const DicomStudy& study) {
  const PatientIdentity& patient = study.patient;
  elements.text(DCM_SpecificCharacterSet, "ISO_IR 192");
  elements.text(DCM_PatientName, personName(patient.name));
  elements.text(DCM_PatientID, fitting(patient.id, 64));
  elements.text(DCM_IssuerOfPatientID, "EchoWeave simulation");
  elements.text(DCM_PatientBirthDate, "");
  elements.text(DCM_PatientSex, sexOf(patient.sex));
  if (const std::string age = ageOf(patient.age_years); !age.empty()) elements.text(DCM_PatientAge, age);
  elements.text(DCM_PatientComments, std::string("Invented patient of a training case. ") + kSimulation);
  elements.text(DCM_StudyInstanceUID, study.studyUid);
  elements.text(DCM_StudyDate, dicomDate(study.begun));
  elements.text(DCM_StudyTime, dicomTime(study.begun));
  elements.text(DCM_TimezoneOffsetFromUTC, "+0000");
  elements.text(DCM_ReferringPhysicianName, "");
  elements.text(DCM_StudyID, "SIM");
  elements.text(DCM_AccessionNumber, "");
  elements.text(DCM_StudyDescription, fitting("Simulation: " + study.title, 64));
}

void putSeriesAndEquipment(Elements& elements, const DicomStudy& study, const ObjectHead& head) {
  elements.text(DCM_Modality, head.modality);
  elements.text(DCM_SeriesInstanceUID, head.seriesUid);
  elements.text(DCM_SeriesNumber, std::to_string(head.seriesNumber));
  elements.text(DCM_SeriesDate, dicomDate(study.begun));
  elements.text(DCM_SeriesTime, dicomTime(study.begun));
  elements.text(DCM_SeriesDescription, fitting(head.seriesTitle, 64));
  if (!study.operators.empty()) elements.text(DCM_OperatorsName, personName(study.operators));
  elements.text(DCM_Manufacturer, "EchoWeave");
  elements.text(DCM_ManufacturerModelName, "EchoWeave training simulator");
  elements.text(DCM_InstitutionName, "Simulation");
  elements.text(DCM_SoftwareVersions, kVersion);
  elements.text(DCM_SOPClassUID, head.classUid);
  elements.text(DCM_SOPInstanceUID, head.instanceUid);
  elements.text(DCM_InstanceNumber, std::to_string(head.number));
  elements.text(DCM_InstanceCreationDate, dicomDate(head.made));
  elements.text(DCM_InstanceCreationTime, dicomTime(head.made));
}

Result<void> checkIdentifiers(const DicomStudy& study, const std::string& seriesUid, const std::string& instanceUid) {
  for (const auto& [name, uid] :
       {std::pair<const char*, std::string>{"study", study.studyUid}, std::pair<const char*, std::string>{"series", seriesUid},
        std::pair<const char*, std::string>{"object", instanceUid}})
    if (!isDicomUid(uid))
      return failure(ErrorCode::badField,
                     say<"'%1' is no unique identifier of DICOM (%2); make one with newDicomUid.">(uid, verbatim(name)),
                     {{"field", name}, {"found", uid}});
  return {};
}

Result<std::vector<char>> bytesOf(DcmFileFormat& file) {
  const auto failed = [](const OFCondition& status) {
    return failure(ErrorCode::internal, say<"A DICOM object could not be written (%1).">(verbatim(status.text())));
  };
  if (const auto status = file.validateMetaInfo(EXS_LittleEndianExplicit); status.bad()) return failed(status);
  std::vector<char> bytes;
  for (std::size_t room = std::size_t{1} << 20; room <= std::size_t{1} << 28; room *= 4) {
    bytes.resize(room);
    DcmOutputBufferStream stream(bytes.data(), static_cast<offile_off_t>(bytes.size()));
    file.transferInit();
    const OFCondition status = file.write(stream, EXS_LittleEndianExplicit, EET_ExplicitLength, nullptr, EGL_recalcGL, EPD_noChange);
    file.transferEnd();
    if (status == EC_StreamNotifyClient) continue;  // more than there was room for
    if (status.bad()) return failed(status);
    stream.flush();
    void* begin = nullptr;
    offile_off_t length = 0;
    stream.flushBuffer(begin, length);
    bytes.resize(static_cast<std::size_t>(length));
    return bytes;
  }
  return failed(EC_MemoryExhausted);
}

}  // namespace ew::exporting
