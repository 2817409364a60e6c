#include "ew/export/examination_files.h"

#include "ew/core/contract.h"
#include "ew/export/measurement_report.h"

namespace ew {
namespace {

std::string threeDigits(std::size_t number) {
  const std::string digits = std::to_string(number);
  return std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
}

}  // namespace

Result<std::vector<std::filesystem::path>> writeExamination(const ExaminationFiles& examination, const std::filesystem::path& folder,
                                                            Progress& progress) {
  std::vector<std::filesystem::path> files;
  std::vector<DicomReference> images;
  const auto report = [&] {
    progress.report(say<"Writing images and reports">(), static_cast<double>(files.size()) / static_cast<double>(examination.count()));
    return !progress.cancelRequested();
  };
  const auto stopped = [] { return failure(ErrorCode::cancelled, say<"Stopped as asked; nothing was written.">()); };
  for (const auto& [still, options] : examination.images) {
    if (!report()) return stopped();
    files.push_back(folder / ("picture_" + threeDigits(files.size() + 1) + ".dcm"));
    auto written = writeDicomImage(still, options, examination.study, files.back());
    if (!written) return passOn(written.error());
    images.push_back(std::move(*written));
  }
  int number = 0;
  for (const ExaminationFiles::Report& each : examination.reports) {
    if (!report()) return stopped();
    files.push_back(folder / (each.worksheet.package + ".dcm"));
    const MeasurementReportOptions options{.instanceUid = each.instanceUid, .number = ++number, .made = each.made, .images = images};
    if (auto written = writeMeasurementReport(each.worksheet, options, examination.study, files.back()); !written)
      return passOn(written.error());
  }
  return files;
}

Result<DicomReference> writeDicomScan(const ScanLog& log, const std::vector<std::size_t>& frames,
                                      const std::function<Result<std::pair<DisplayImage, DisplayGeometry>>(std::size_t n)>& make,
                                      const DicomStudy& study, const std::filesystem::path& file, Progress& progress) {
  EW_EXPECTS(!frames.empty());
  DisplayGeometry geometry;
  const auto stillAt = [&](std::size_t n) -> Result<Still> {
    const auto made = make(n);
    if (!made) return passOn(made.error());
    geometry = made->second;
    const ScanState state = log.frame(frames[n]);
    return stillOf(made->first, {}, geometry, state.probe, state.knobs);
  };
  auto first = stillAt(0);
  if (!first) return passOn(first.error());
  DicomClip clip;
  clip.size_px = first->size_px();
  clip.isColour = first->isColour();
  clip.regions = first->regions;
  for (const std::size_t frame : frames) clip.times_s.push_back(log.frameTime_s(frame));
  clip.still = [&](std::size_t n) -> Result<Still> {
    if (n == 0) return std::move(*first);
    auto still = stillAt(n);
    if (still && still->regions != clip.regions)
      return failure(ErrorCode::badField,
                     say<"In image %1 depth, zoom or orientation are not those of the first image, and all images of a DICOM clip have one "
                         "scale; write a film (.mp4) or single images instead.">(n + 1));
    return still;
  };
  const ScanState begun = log.frame(frames.front());
  return writeDicomClip(clip, imageOptions(begun.probe, begun.knobs, geometry, 1, study.begun), study, file, progress);
}

}  // namespace ew
