#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/image.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/io/deidentify.h"
#include "ew/io/dicom.h"
#include "ew/io/raw_volume.h"
#include "ew/io/volume_file.h"

namespace ew {

/// What a file is, by its content where it says so and by its ending where it does not.
enum class FileKind {
  volume,       ///< .mha, .mhd, .nrrd, .nhdr, .nii, .nii.gz with a volume
  sweep,        ///< a tracked sequence: to be reconstructed
  dicomImages,  ///< a DICOM still or cine
  dicomVolume,  ///< an Enhanced US Volume
  dicomStack,   ///< a folder of DICOM stills: a volume, one slice a file
  kretz,        ///< a GE Kretz file, also inside DICOM
  images,       ///< a folder of images, or one of several numbered images
  film,         ///< a film, also inside DICOM, or a TIFF: a recorded screen, to be cleaned (ew/acquisition/screen_recording.h)
  raw           ///< nothing known: samples without a header
};
[[nodiscard]] const char* nameOf(FileKind kind);

/// @error notFound, notReadable, unsupported (another program's kind of file, a text: the sentence names it and says what to do), truncated
///        (empty), and what the reader of a known format says of a damaged header
[[nodiscard]] Result<FileKind> kindOfFile(const std::filesystem::path& file);

/// What a person said where the file says nothing or several things. What is empty is not guessed: the import asks.
struct ImportAnswers {
  std::optional<int> region;           ///< ultrasound region of a DICOM file, from 1; 0: the whole image
  std::optional<glm::dvec2> pixel_mm;  ///< size of a pixel of DICOM images
  std::optional<double> rate_hz = {};  ///< frames a second of DICOM images that do not say it
  std::optional<glm::dvec3>
      spacing_mm;  ///< of images and of volumes that do not know theirs; x is the spacing Kretz beams are converted to
  ColourRule colour = ColourRule::ask;
  std::vector<PixelRect> blank;
  bool keepText = false;
  std::optional<int> timeStep;   ///< from 1
  std::optional<RawLayout> raw;  ///< then the file is read as raw samples, whatever it is
  bool mirrored = false;         ///< Kretz: the elevational axis turned over
  bool acceptsSmall = false;  ///< a result with less than a tenth of the pixels is taken (Retention), stills with gaps, voxels of any size
  bool asSequence = false;    ///< an Enhanced US Volume as planes with poses instead of a volume
};

struct FileImportResult {
  FileKind kind = FileKind::volume;
  std::optional<Volume> volume;
  std::optional<Cine> images;  ///< a cine, or planes with poses; its removed and notes are those below
  Removed removed;
  std::vector<Message> notes;
  std::vector<Message> warnings = {};  ///< of the notes, those that make the result doubtful (VolumeReadResult): told before the others
};

/// Reads whatever a user brings into a volume or a sequence of images, without any field that names a patient. Where an answer is missing
/// the error's context entry "ask" says which: "region", "pixel-mm", "spacing", "colour", "blank", "time-step", "raw", "sequence",
/// "accept-small".
/// @error as readVolume, readDicomCine, readDicomVolume, readKretz, readImageStack, readRawVolume; unsupported (a sweep: reconstruct it)
[[nodiscard]] Result<FileImportResult> importFile(const std::filesystem::path& file, const ImportAnswers& answers,
                                                  Progress& progress = noProgress(), const ReaderLimits& limits = {});

/// What there is to ask about voxels that can hardly be meant, below 0.005 mm or above 20 mm along an axis, as of a spacing in another unit
/// than mm. Empty where there is nothing to ask.
[[nodiscard]] Message questionAboutVoxels(const std::filesystem::path& file, const glm::dvec3& spacing_mm);

/// The grid that importFile gives a volume file (FileKind::volume), found in its header. @error as importFile, as far as a header tells
[[nodiscard]] Result<Grid> volumeOf(const std::filesystem::path& file, const ImportAnswers& answers);

/// What a person has to see in order to answer, found without importing.
struct ImportPreview {
  std::uint64_t volumes = 1;             ///< one after the other in the file: ImportAnswers::timeStep is 1 to this; 0: not known
  std::optional<glm::dvec3> spacing_mm;  ///< that the file states
  std::optional<DicomSummary> dicom;     ///< of a DICOM file
  GreyImage image;                       ///< the first one, whole: region and blank count its pixels; width 0: there is none to show
  std::vector<std::uint8_t> coloured;    ///< like image.pixels: 1 where the source is coloured; empty: nowhere
};
/// @error as importFile
[[nodiscard]] Result<ImportPreview> previewImport(const std::filesystem::path& file, FileKind kind, Progress& progress = noProgress(),
                                                  const ReaderLimits& limits = {});

/// What an error asks for, or empty.
[[nodiscard]] std::string askedFor(const Error& error);

}  // namespace ew
