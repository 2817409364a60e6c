#include <nlohmann/json.hpp>

#include "ew/core/data_file.h"
#include "ew/core/json_fields.h"
#include "ew/io/json_files.h"
#include "ew/io/safe_file.h"
#include "ew/trackers/marker_sheet.h"

namespace ew {
namespace {

constexpr int kScaleFormat = 1;
constexpr const char* kScaleFile = "printed.json";

}  // namespace

Result<double> readPrintedScale(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kScaleFile;
  const Message where = say<"the measured scale %1">(file.string());
  const auto read = readJsonFile(file, where);
  if (!read && read.error().code == ErrorCode::notFound) return 100.0;
  if (!read) return passOn(read.error());
  JsonReading reading(where, {"note"});
  const JsonFields document(*read, reading);
  requireFormat(document, kScaleFormat);
  document.only({"format", "measured_scale_mm"});
  const double measured_mm = document.number("measured_scale_mm", 90.0, 110.0);
  if (reading.problem()) return passOn(*reading.problem());
  return measured_mm;
}

Result<void> keepPrintedScale(const std::filesystem::path& folder, double measured_mm) {
  if (auto factor = printedFactor(measured_mm); !factor) return passOn(factor.error());
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem)
    return failure(ErrorCode::notWritable,
                   say<"The folder %1 cannot be made (%2); check its permissions.">(folder.string(), verbatim(problem.message())),
                   {{"file", folder.string()}});
  return writeFileSafely(folder / kScaleFile, nlohmann::json{{"format", kScaleFormat}, {"measured_scale_mm", measured_mm}}.dump(2) + "\n");
}

}  // namespace ew
