#include "ew/export/dicom_study.h"

#include <algorithm>
#include <array>
#include <random>
#include <span>

#include "ew/library/checksums.h"

namespace ew {
namespace {

/// The decimal digits of a number of 128 bits.
std::string decimalOf(std::array<std::uint32_t, 4> words) {
  std::string digits;
  while (std::any_of(words.begin(), words.end(), [](std::uint32_t word) { return word != 0; })) {
    std::uint64_t rest = 0;
    for (std::uint32_t& word : words) {
      rest = (rest << 32U) | word;
      word = static_cast<std::uint32_t>(rest / 10);
      rest %= 10;
    }
    digits.insert(digits.begin(), static_cast<char>('0' + rest));
  }
  return digits.empty() ? "0" : digits;
}

DicomStudy begun(std::chrono::sys_seconds now) {
  DicomStudy study;
  study.studyUid = newDicomUid();
  study.imagesUid = newDicomUid();
  study.reportsUid = newDicomUid();
  study.begun = now;
  return study;
}

}  // namespace

std::string dicomUidOf(std::uint64_t high, std::uint64_t low) {
  high = (high & ~0xF000ULL) | 0x4000ULL;                       // version 4: random (RFC 4122, 4.4)
  low = (low & 0x3FFFFFFFFFFFFFFFULL) | 0x8000000000000000ULL;  // variant of RFC 4122
  return "2.25." + decimalOf({static_cast<std::uint32_t>(high >> 32U), static_cast<std::uint32_t>(high),
                              static_cast<std::uint32_t>(low >> 32U), static_cast<std::uint32_t>(low)});
}

std::string newDicomUid() {
  std::random_device device;
  const auto half = [&device] { return (static_cast<std::uint64_t>(device()) << 32U) | device(); };
  const std::uint64_t high = half();
  return dicomUidOf(high, half());
}

bool isDicomUid(std::string_view text) {
  if (text.empty() || text.size() > 64 || text.back() == '.') return false;
  char before = '.';
  for (std::size_t n = 0; n < text.size(); ++n) {
    const char c = text[n];
    if (c != '.' && (c < '0' || c > '9')) return false;
    if (c == '.' && before == '.') return false;
    const bool isAlone = n + 1 == text.size() || text[n + 1] == '.';
    if (c == '0' && before == '.' && !isAlone) return false;
    before = c;
  }
  return true;
}

namespace {

/// The same for all examinations of a case. A case with a title for trainees hides its finding, which its id often names.
std::string patientIdOf(const Case& examined) {
  constexpr std::size_t kDigits = 10;
  if (titleForTrainees(examined) == examined.title) return "EWSIM-" + examined.id;
  Sha256 sum;
  sum.add(std::as_bytes(std::span(examined.id)));
  return "EWSIM-" + sum.hex().substr(0, kDigits);
}

}  // namespace

DicomStudy beginStudy(const Case& examined, std::chrono::sys_seconds now) {
  DicomStudy study = begun(now);
  study.patient = {examined.patient.name, patientIdOf(examined), examined.patient.sex, examined.patient.age_years};
  if (study.patient.name.empty()) study.patient.name = "Simulation";
  study.title = titleForTrainees(examined);
  study.region = examined.region;
  return study;
}

DicomStudy beginStudy(const std::string& title, std::chrono::sys_seconds now) {
  DicomStudy study = begun(now);
  study.patient = {"Simulation", "EWSIM", "", std::nullopt};
  study.title = title;
  return study;
}

}  // namespace ew
