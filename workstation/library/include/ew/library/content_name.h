#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/io/sequence.h"

namespace ew {

/// How a volume of a case is called: "volumes/" + the first 16 hexadecimal digits of the SHA-256 of its file + ending, "volumes/
/// 9f86d081884c7d65.mha". So the same content has one name, another content another one, and no file is ever written over: what a case, a
/// revision or an undo step names stays what it was.
[[nodiscard]] std::string contentName(std::string_view sha256, std::string_view ending = ".mha");
[[nodiscard]] bool isContentNamed(std::string_view path);
[[nodiscard]] bool namesItsContent(std::string_view path, std::string_view sha256);

/// Puts a volume file into a case folder, under the name of its content, sample for sample as it is: .mha, .nrrd, .nii and .nii.gz are
/// copied, of a .mhd its header and its samples become one .mha.
/// @return the path relative to the case folder; adding the same again gives the same and writes nothing
/// @error as readVolumeHeader (also for recordings: unsupported), unsupported (samples in several files, or in another file than the
///        header's of another format), notWritable (also when a file of that name holds something else), cancelled; then nothing is written
[[nodiscard]] Result<std::string> addVolumeFile(const std::filesystem::path& file, const std::filesystem::path& caseFolder,
                                                Progress& progress = noProgress());

/// The same with recorded images, written as .igs.mha: those that a volume was made of (CaseVolume::frames).
/// @error as writeSequence, notWritable, cancelled
[[nodiscard]] Result<std::string> addSequence(const Sequence& images, const std::filesystem::path& caseFolder,
                                              Progress& progress = noProgress());

/// The same with a volume in memory, written as .mha. @error as writeVolume, notWritable, cancelled
[[nodiscard]] Result<std::string> addVolume(const Volume& volume, const std::filesystem::path& caseFolder,
                                            Progress& progress = noProgress());

}  // namespace ew
