#include "ew/library/file_import.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>

#include "ew/core/figures.h"
#include "ew/core/word_table.h"
#include "ew/io/cine_reader.h"
#include "ew/io/dicom_stack.h"
#include "ew/io/image_stack.h"
#include "ew/io/kretz.h"
#include "ew/io/sequence.h"
#include "ew/io/volume_series.h"
#include "making/foreign_files.h"

namespace ew {
namespace {
namespace fs = std::filesystem;

std::string endingOf(const fs::path& file) {
  std::string name = file.filename().string();
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (name.ends_with(".nii.gz")) return ".nii";
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? std::string() : name.substr(dot);
}

bool among(const std::string& ending, std::initializer_list<const char*> endings) {
  return std::any_of(endings.begin(), endings.end(), [&](const char* one) { return ending == one; });
}

tl::unexpected<Error> ask(ErrorCode code, const char* what, Message message, const fs::path& file) {
  return failure(code, std::move(message), {{"file", file.string()}, {"ask", what}});
}

/// Analyze and two-file NIfTI: a header of 348 bytes whose first number says so, and the samples in a file of the other ending.
bool isHalfOfPair(const fs::path& file) {
  fs::path header = file;
  header.replace_extension(endingOf(file) == ".img" ? (file.extension() == ".IMG" ? ".HDR" : ".hdr") : file.extension());
  std::ifstream in(header, std::ios::binary);
  std::array<unsigned char, 4> first{};
  if (!in.read(reinterpret_cast<char*>(first.data()), 4)) return false;
  const auto is = [&](unsigned a, unsigned b, unsigned c, unsigned d) {
    return first[0] == a && first[1] == b && first[2] == c && first[3] == d;
  };
  return is(0x5C, 1, 0, 0) || is(0, 0, 1, 0x5C);
}

tl::unexpected<Error> headerAndImageApart(const fs::path& file) {
  return failure(
      ErrorCode::unsupported,
      say<"'%1' is one of the two files of an Analyze or NIfTI volume (.hdr + .img); convert it to a single .nii.">(file.filename()),
      {{"file", file.string()}});
}

tl::unexpected<Error> askForStep(const fs::path& file, std::uint64_t steps) {
  return ask(ErrorCode::missingCalibration, "time-step",
             say<"'%1' holds %2 volumes one after the other; choose one by its number, 1 to %2.">(file.filename(), steps), file);
}

/// @param problem why the spacing is not known although the file states one; empty: it states none
tl::unexpected<Error> askForSpacing(const fs::path& file, const Message& problem) {
  if (!problem.empty()) return ask(ErrorCode::missingCalibration, "spacing", problem, file);
  return ask(ErrorCode::missingCalibration, "spacing",
             say<"'%1' says 1 x 1 x 1 mm without place or rotation, as converters write when they do not know; give the spacing in mm.">(
                 file.filename()),
             file);
}

constexpr double kSmallestVoxel_mm = 0.005;
constexpr double kLargestVoxel_mm = 20.0;

Result<void> checkVoxels(const fs::path& file, const glm::dvec3& spacing_mm, const ImportAnswers& answers) {
  if (answers.acceptsSmall) return {};
  Message question = questionAboutVoxels(file, spacing_mm);
  if (question.empty()) return {};
  return ask(ErrorCode::unsupported, "accept-small", std::move(question), file);
}

Result<FileImportResult> fromVolume(const fs::path& file, const ImportAnswers& answers, Progress& progress, const ReaderLimits& limits) {
  VolumeReadOptions options;
  if (answers.timeStep) options.timeStep = static_cast<std::uint64_t>(std::max(*answers.timeStep, 0));
  auto read = readVolume(file, progress, limits, options);
  if (!read) return passOn(read.error());
  if (read->timeSteps > 1 && !answers.timeStep) return askForStep(file, read->timeSteps);
  FileImportResult made;
  made.notes = std::move(read->notes);
  made.warnings = std::move(read->warnings);
  if (answers.spacing_mm) {
    read->volume.grid.spacing_mm = *answers.spacing_mm;
    if (auto usable = checkGrid(read->volume.grid); !usable) return passOn(usable.error());
    std::erase(made.notes, say<"Spacing is 1 x 1 x 1 mm with the origin at 0 and no rotation: the true spacing is probably unknown.">());
    std::erase(made.notes, read->spacingProblem);
    made.notes.push_back(say<"The spacing was given and replaces that of the file; origin and directions are the file's.">());
  } else if (!read->spacingKnown) {
    return askForSpacing(file, read->spacingProblem);
  } else {
    made.notes.push_back(say<"Spacing, origin and directions are the file's own, in LPS.">());
  }
  made.volume = std::move(read->volume);
  return made;
}

Result<FileImportResult> fromCine(Result<Cine> cine) {
  if (!cine) return passOn(cine.error());
  FileImportResult made;
  made.removed = cine->removed;
  made.notes = cine->notes;
  made.images = *std::move(cine);
  return made;
}

template <class Read>
Result<FileImportResult> fromParts(Result<Read> read) {
  if (!read) return passOn(read.error());
  FileImportResult made;
  made.removed = std::move(read->removed);
  made.notes = std::move(read->notes);
  made.volume = std::move(read->volume);
  return made;
}

Result<FileImportResult> fromStills(const fs::path& folder, const ImportAnswers& answers, Progress& progress, const ReaderLimits& limits) {
  auto made = fromParts(readDicomStack(
      folder, {.colour = answers.colour, .blank = answers.blank, .keepText = answers.keepText, .acceptsSmall = answers.acceptsSmall},
      progress, limits));
  if (made && answers.spacing_mm)
    made->notes.push_back(say<"The spacing that was given is not used: the stills say where they lie and how large their pixels are.">());
  return made;
}

Result<FileImportResult> read(FileKind kind, const fs::path& file, const ImportAnswers& answers, Progress& progress,
                              const ReaderLimits& limits) {
  switch (kind) {
    case FileKind::volume:
      return fromVolume(file, answers, progress, limits);
    case FileKind::sweep:
      return ask(
          ErrorCode::unsupported, "reconstruct",
          say<"'%1' is a recording already, so there is nothing to import; with the poses of a tracker, or a file that says how a motor "
              "moved the probe, a volume can be made of it.">(file.filename()),
          file);
    case FileKind::dicomImages:
      return fromCine(readDicomCine(file,
                                    {.region = answers.region,
                                     .pixel_mm = answers.pixel_mm,
                                     .rate_hz = answers.rate_hz,
                                     .colour = answers.colour,
                                     .blank = answers.blank,
                                     .keepText = answers.keepText,
                                     .acceptsSmall = answers.acceptsSmall},
                                    progress, limits));
    case FileKind::dicomStack:
      return fromStills(file, answers, progress, limits);
    case FileKind::dicomVolume:
      if (answers.asSequence) return fromCine(readDicomPlanes(file, {.timeStep = answers.timeStep}, progress, limits));
      return fromParts(readDicomVolume(file, {.timeStep = answers.timeStep}, progress, limits));
    case FileKind::kretz: {
      KretzOptions options;
      if (answers.spacing_mm) options.spacing_mm = answers.spacing_mm->x;
      options.mirrored = answers.mirrored;
      options.timeStep = answers.timeStep;
      return fromParts(readKretz(file, options, progress, limits));
    }
    case FileKind::images:
      return fromParts(
          readImageStack(file, {.spacing_mm = answers.spacing_mm, .colour = answers.colour, .blank = answers.blank}, progress, limits));
    case FileKind::film:
      return ask(ErrorCode::unsupported, "screen",
                 say<"'%1' is a film or a TIFF, which may show more than a scan; clean it first (echoweave screen), or open it in the "
                     "window.">(file.filename()),
                 file);
    case FileKind::raw:
      break;
  }
  return ask(
      ErrorCode::missingCalibration, "raw",
      say<"'%1' is of no known kind; if it holds samples without a header, say how they are stored (dimensions, type, spacing, offset).">(
          file.filename()),
      file);
}

constexpr WordTable<FileKind, 9> kFileKindWords{{{"volume", FileKind::volume},
                                                 {"sweep", FileKind::sweep},
                                                 {"DICOM images", FileKind::dicomImages},
                                                 {"Enhanced US Volume", FileKind::dicomVolume},
                                                 {"folder of DICOM stills", FileKind::dicomStack},
                                                 {"Kretz volume", FileKind::kretz},
                                                 {"pictures", FileKind::images},
                                                 {"film", FileKind::film},
                                                 {"raw samples", FileKind::raw}}};

}  // namespace

const char* nameOf(FileKind kind) { return wordIn(kFileKindWords, kind); }

Result<FileKind> kindOfFile(const fs::path& file) {
  std::error_code ec;
  if (!fs::exists(file, ec))
    return failure(ErrorCode::notFound, say<"There is no file or folder '%1'; check the name.">(file), {{"file", file.string()}});
  if (fs::is_directory(file, ec)) {
    const auto images = stackFiles(file);
    if (!images && images.error().code == ErrorCode::notReadable) return passOn(images.error());
    const auto dicom = dicomFilesIn(file);
    if (dicom.empty()) return FileKind::images;
    if (!images) return FileKind::dicomStack;
    return failure(ErrorCode::unsupported,
                   say<"'%1' holds both images (.png, .jpg, .pgm: %2) and DICOM files (%3), and one volume is made of one kind; put them "
                       "into folders of their own.">(file.filename(), images->size(), dicom.size()),
                   {{"file", file.string()}});
  }
  // Opening a pipe to see what it begins with would wait for whoever writes into it.
  if (!fs::is_regular_file(file, ec))
    return failure(ErrorCode::notReadable,
                   say<"'%1' is a pipe or a device and not a file; save what comes out of it as a file first.">(file),
                   {{"file", file.string()}});
  const std::string ending = endingOf(file);
  if (among(ending, {".mha", ".mhd", ".nrrd", ".nhdr", ".nii"})) {
    if (ending == ".nii") return FileKind::volume;
    const auto sequence = isSequence(file);
    if (!sequence) return passOn(sequence.error());
    return *sequence ? FileKind::sweep : FileKind::volume;
  }
  if (among(ending, {".png", ".jpg", ".jpeg", ".pgm"})) return FileKind::images;
  if (among(ending, {".hdr", ".img"}) && isHalfOfPair(file)) return headerAndImageApart(file);
  // The free bytes before a DICOM data set may be those of a TIFF.
  if (isDicom(file) ? isDicomFilm(file) : isFilm(file) || isTiff(file)) return FileKind::film;
  if (isKretz(file)) return FileKind::kretz;
  if (isDicom(file)) {
    const auto summary = inspectDicom(file);
    if (!summary) return passOn(summary.error());
    switch (summary->kind) {
      case DicomKind::images:
        return FileKind::dicomImages;
      case DicomKind::enhancedVolume:
        return FileKind::dicomVolume;
      case DicomKind::kretz:
        return FileKind::kretz;
    }
  }
  if (auto none = whyNoSamples(file)) return tl::unexpected<Error>(*std::move(none));
  return FileKind::raw;
}

Result<FileImportResult> importFile(const fs::path& file, const ImportAnswers& answers, Progress& progress, const ReaderLimits& limits) {
  if (answers.raw) {
    auto raw = readRawVolume(file, *answers.raw, progress, limits);
    if (!raw) return passOn(raw.error());
    FileImportResult made;
    made.kind = FileKind::raw;
    made.notes = std::move(raw->notes);
    made.warnings = std::move(raw->warnings);
    made.volume = std::move(raw->volume);
    if (auto meant = checkVoxels(file, made.volume->grid.spacing_mm, answers); !meant) return passOn(meant.error());
    return made;
  }
  if (answers.spacing_mm)
    for (int axis = 0; axis < 3; ++axis)
      if (!((*answers.spacing_mm)[axis] > 0.0 && (*answers.spacing_mm)[axis] < 1e6))
        return failure(ErrorCode::badUsage, say<"The spacing must be above 0 mm along every axis.">(), {{"ask", "spacing"}});
  const auto kind = kindOfFile(file);
  if (!kind) return passOn(kind.error());
  auto made = read(*kind, file, answers, progress, limits);
  if (!made) return made;
  made->kind = *kind;
  if (made->volume)
    if (auto meant = checkVoxels(file, made->volume->grid.spacing_mm, answers); !meant) return passOn(meant.error());
  return made;
}

Message questionAboutVoxels(const fs::path& file, const glm::dvec3& spacing_mm) {
  const auto [least_mm, most_mm] = std::minmax({spacing_mm.x, spacing_mm.y, spacing_mm.z});
  const auto figure = [&](int axis) { return numeral(figureText(spacing_mm[axis], 3)); };
  if (least_mm < kSmallestVoxel_mm)
    return say<
        "A voxel of '%1' is %2 x %3 x %4 mm: is its spacing in metres or centimetres? Spacings count millimetres; give the true spacing, "
        "or "
        "say that voxels so small are meant.">(file.filename(), figure(0), figure(1), figure(2));
  if (most_mm > kLargestVoxel_mm)
    return say<
        "A voxel of '%1' is %2 x %3 x %4 mm: is its spacing in micrometres? Spacings count millimetres; give the true spacing, or say that "
        "voxels so large are meant.">(file.filename(), figure(0), figure(1), figure(2));
  return {};
}

Result<Grid> volumeOf(const fs::path& file, const ImportAnswers& answers) {
  const auto series = readVolumeSeries(file);
  if (!series) return passOn(series.error());
  if (series->volumes > 1 && !answers.timeStep) return askForStep(file, series->volumes);
  if (!series->spacingKnown && !answers.spacing_mm) return askForSpacing(file, series->spacingProblem);
  Grid grid = series->grid;
  if (answers.spacing_mm) grid.spacing_mm = *answers.spacing_mm;
  if (auto usable = checkGrid(grid); !usable) return passOn(usable.error());
  if (auto meant = checkVoxels(file, grid.spacing_mm, answers); !meant) return passOn(meant.error());
  return grid;
}

Result<ImportPreview> previewImport(const fs::path& file, FileKind kind, Progress& progress, const ReaderLimits& limits) {
  ImportPreview preview;
  switch (kind) {
    case FileKind::volume: {
      const auto series = readVolumeSeries(file);
      if (!series) return passOn(series.error());
      preview.volumes = series->volumes;
      if (series->spacingKnown) preview.spacing_mm = series->grid.spacing_mm;
      return preview;
    }
    case FileKind::dicomImages:
    case FileKind::dicomVolume: {
      auto summary = inspectDicom(file, limits);
      if (!summary) return passOn(summary.error());
      if (kind == FileKind::dicomVolume) {
        preview.volumes = std::max<std::uint64_t>(1, summary->timeSteps_s.size());
      } else {
        // Whole and with all text: the person who chooses what is kept has the file anyway.
        CineOptions whole;
        whole.region = 0;
        whole.pixel_mm = glm::dvec2(1.0);
        whole.colour = ColourRule::keepGrey;
        whole.keepText = true;
        whole.mostFrames = 1;
        auto first = readDicomCine(file, whole, progress, limits);
        if (!first) return passOn(first.error());
        preview.image.width = first->sequence.width;
        preview.image.height = first->sequence.height;
        preview.image.pixels = std::move(first->sequence.pixels);
        preview.coloured = std::move(first->coloured);
      }
      preview.dicom = *std::move(summary);
      return preview;
    }
    case FileKind::dicomStack: {
      auto first = readFirstOfDicomStack(file, progress, limits);
      if (!first) return passOn(first.error());
      preview.image = std::move(first->level);
      preview.spacing_mm = first->spacing_mm;
      return preview;
    }
    case FileKind::images: {
      auto first = readFirstOfStack(file);
      if (!first) return passOn(first.error());
      preview.image = std::move(first->level);
      preview.coloured = std::move(first->coloured);
      return preview;
    }
    case FileKind::kretz:
      preview.volumes = 0;
      return preview;
    case FileKind::sweep:
    case FileKind::film:
    case FileKind::raw:
      break;
  }
  return preview;
}

std::string askedFor(const Error& error) {
  const auto found = std::find_if(error.context.begin(), error.context.end(), [](const auto& fact) { return fact.first == "ask"; });
  return found == error.context.end() ? std::string() : found->second;
}

}  // namespace ew
