#include "ew/library/content_name.h"

#include <algorithm>
#include <array>
#include <functional>

#include "ew/core/output_set.h"
#include "ew/io/safe_file.h"
#include "ew/io/volume_file.h"
#include "files/file_pieces.h"
#include "files/guarded_case.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kVolumesFolder = "volumes/";
constexpr std::size_t kNameDigits = 16;
constexpr const char* kSequenceEnding = ".igs.mha";
constexpr std::array<std::string_view, 5> kVolumeEndings = {".mha", ".nrrd", ".nii", ".nii.gz", kSequenceEnding};

/// ".mha" of "Liver.MHA", ".nii.gz" of "a.b.nii.gz".
std::string volumeEnding(const fs::path& file) {
  std::string name = file.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (name.ends_with(".nii.gz")) return ".nii.gz";
  return fs::path(name).extension().string();
}

tl::unexpected<Error> cannotTakeIn(const fs::path& file) {
  return failure(ErrorCode::unsupported,
                 say<"The volume '%1' cannot be put into a case as it is; save it as .mha first and choose that.">(file),
                 {{"file", file.string()}});
}

/// Puts a complete file into the case under the name of its content.
/// @param write makes it as a new file; it is on the medium then
Result<std::string> putIn(const fs::path& caseFolder, const std::string& ending,
                          const std::function<Result<FileSum>(const fs::path&)>& write) {
  const fs::path folder = caseFolder / "volumes";
  OutputSet outputs(LateFile::refuse);
  if (auto made = outputs.announceFolder(folder); !made) return passOn(made.error());
  // Written under a name of its own first: the one it will have is known when it is there.
  const fs::path placeholder = folder / (".new" + ending);
  if (auto announced = outputs.announce(placeholder); !announced) return passOn(announced.error());
  const fs::path aside = outputs.staged(placeholder);
  const auto written = write(aside);
  if (!written) return passOn(outputs.inGivenNames(written.error()));
  std::string name = contentName(written->sha256, ending);
  const fs::path target = caseFolder / name;
  std::error_code problem;
  for (int attempt = 0; attempt < 2; ++attempt) {
    if (fs::exists(fs::symlink_status(target, problem))) {
      const auto there = sha256Of(target);
      if (there && *there == written->sha256) return name;
      return failure(ErrorCode::notWritable,
                     say<"'%1' is there and holds something else than its name says; move it away, or verify the case.">(target),
                     {{"file", target.string()}});
    }
    // Whoever adds the same at the same time wins or loses; there is one file either way.
    fs::create_hard_link(aside, target, problem);
    if (!problem) return name;
    if (problem != std::errc::file_exists) break;
  }
  OutputSet last;  // where there are no hard links
  if (auto announced = last.announce(target); !announced) return passOn(announced.error());
  fs::rename(aside, last.staged(target), problem);
  if (auto committed = last.commit(); !committed) return passOn(committed.error());
  return name;
}

/// The lines of a .mhd up to its samples, naming a file of its own: "ElementDataFile = LOCAL". Empty: they lie in a way that one file
/// cannot.
Result<std::string> localHeader(const fs::path& file) {
  constexpr std::size_t kLargest_bytes = 1u << 20;
  const auto text = readTextFile(file, kLargest_bytes);
  if (!text) return passOn(text.error());
  std::string header;
  for (std::size_t begin = 0; begin < text->size();) {
    const auto end = std::min(text->find('\n', begin), text->size());
    std::string line = text->substr(begin, end - begin);
    begin = end + 1;
    if (line.ends_with('\r')) line.pop_back();
    const std::string key = line.substr(0, line.find_first_of(" \t="));
    if (key == "HeaderSize" && line.substr(line.find('=') + 1).find_first_not_of(" \t0") != std::string::npos) return cannotTakeIn(file);
    if (key == "HeaderSize") continue;
    if (key == "ElementDataFile") return header + "ElementDataFile = LOCAL\n";
    header += line + "\n";
  }
  return cannotTakeIn(file);
}

Result<FileSum> joinHeaderAndSamples(const fs::path& headerFile, const fs::path& samples, const fs::path& to, ByteCount& count) {
  const auto header = localHeader(headerFile);
  if (!header) return passOn(header.error());
  auto out = PieceWriter::create(to);
  if (!out) return passOn(out.error());
  Sha256 sum;
  FileSum written;
  const auto put = [&](std::span<const std::byte> piece) {
    sum.add(piece);
    written.size_bytes += piece.size();
    return out->write(piece);
  };
  if (auto first = put(std::as_bytes(std::span(*header))); !first) return passOn(first.error());
  if (auto rest = readInPieces(samples, count, put); !rest) return passOn(rest.error());
  if (auto finished = out->finish(); !finished) return passOn(finished.error());
  written.sha256 = sum.hex();
  return written;
}

}  // namespace

std::string contentName(std::string_view sha256, std::string_view ending) {
  return std::string(kVolumesFolder) + std::string(sha256.substr(0, kNameDigits)) + std::string(ending);
}

bool isContentNamed(std::string_view path) {
  if (!path.starts_with(kVolumesFolder) || path.size() < kVolumesFolder.size() + kNameDigits) return false;
  const auto digits = path.substr(kVolumesFolder.size(), kNameDigits), ending = path.substr(kVolumesFolder.size() + kNameDigits);
  return digits.find_first_not_of("0123456789abcdef") == std::string_view::npos &&
         std::find(kVolumeEndings.begin(), kVolumeEndings.end(), ending) != kVolumeEndings.end();
}

bool namesItsContent(std::string_view path, std::string_view sha256) {
  return isContentNamed(path) && path.substr(kVolumesFolder.size(), kNameDigits) == sha256.substr(0, kNameDigits);
}

Result<std::string> addVolumeFile(const fs::path& file, const fs::path& caseFolder, Progress& progress) {
  return guardedCase(caseFolder, [&]() -> Result<std::string> {
    const auto header = readVolumeHeader(file);
    if (!header) return passOn(header.error());
    if (header->sequence) return cannotTakeIn(file);
    std::uint64_t bytes = 0;
    std::error_code ignored;
    for (const fs::path& each : header->files) bytes += fs::file_size(each, ignored);
    if (auto room = checkRoom(caseFolder, bytes); !room) return passOn(room.error());
    ByteCount count(say<"Putting a volume into the case">(), bytes, progress);
    const std::string ending = volumeEnding(file);
    if (header->files.size() == 1 && std::find(kVolumeEndings.begin(), kVolumeEndings.end(), ending) != kVolumeEndings.end())
      return putIn(caseFolder, ending, [&](const fs::path& to) { return copyInPieces(file, to, count); });
    if (header->files.size() == 2 && ending == ".mhd")
      return putIn(caseFolder, ".mha", [&](const fs::path& to) {
        const fs::path& samples = fs::equivalent(header->files[0], file, ignored) ? header->files[1] : header->files[0];
        return joinHeaderAndSamples(file, samples, to, count);
      });
    return cannotTakeIn(file);
  });
}

Result<std::string> addSequence(const Sequence& images, const fs::path& caseFolder, Progress& progress) {
  return guardedCase(caseFolder, [&] {
    return putIn(caseFolder, kSequenceEnding, [&](const fs::path& to) -> Result<FileSum> {
      PartOfProgress writing(progress, 0.0, 0.9), reading(progress, 0.9, 1.0);
      if (auto written = writeSequence(images, to, writing); !written) return passOn(written.error());
      std::error_code ignored;
      ByteCount count(say<"Putting recorded images into the case">(), fs::file_size(to, ignored), reading);
      return sumInPieces(to, count);
    });
  });
}

Result<std::string> addVolume(const Volume& volume, const fs::path& caseFolder, Progress& progress) {
  return guardedCase(caseFolder, [&] {
    return putIn(caseFolder, ".mha", [&](const fs::path& to) -> Result<FileSum> {
      PartOfProgress writing(progress, 0.0, 0.9), reading(progress, 0.9, 1.0);
      if (auto written = writeVolume(volume, to, writing); !written) return passOn(written.error());
      std::error_code ignored;
      ByteCount count(say<"Putting a volume into the case">(), fs::file_size(to, ignored), reading);
      return sumInPieces(to, count);
    });
  });
}

}  // namespace ew
