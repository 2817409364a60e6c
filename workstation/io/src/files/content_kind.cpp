#include "files/content_kind.h"

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "files/image_header.h"

namespace ew::detail {
namespace {
namespace fs = std::filesystem;
using namespace std::string_view_literals;

/// A kind of file that says by its first bytes what it is, whatever its name.
struct ContentKind {
  bool (*begins)(std::string_view bytes);
  Message (*isWhat)();
  std::vector<std::string_view> endings;  ///< in small letters; the first is the one to give
};

bool isNifti(std::string_view bytes) {
  const std::string_view size = bytes.substr(0, 4);
  if (bytes.size() >= 348 && (size == "\x5C\x01\0\0"sv || size == "\0\0\x01\x5C"sv)) return bytes.substr(344, 3) == "n+1";
  return (size == "\x1C\x02\0\0"sv || size == "\0\0\x02\x1C"sv) && bytes.substr(4, 3) == "n+2";
}

bool isAt(std::string_view bytes, std::size_t at, std::string_view mark) {
  return bytes.size() >= at && bytes.substr(at).starts_with(mark);
}

bool isTransportStream(std::string_view bytes) { return bytes.starts_with('\x47') && isAt(bytes, 188, "\x47") && isAt(bytes, 376, "\x47"); }
bool isMpeg(std::string_view bytes) { return bytes.starts_with("\0\0\1\xBA"sv) || bytes.starts_with("\0\0\1\xB3"sv); }
bool isQuickTime(std::string_view bytes) {
  return isAt(bytes, 4, "moov") || isAt(bytes, 4, "mdat") || isAt(bytes, 4, "wide") || isAt(bytes, 4, "ftypqt");
}

const std::vector<ContentKind>& contentKinds() {
  static const std::vector<ContentKind> kinds{
      {[](std::string_view bytes) { return bytes.starts_with("ObjectType ="); }, [] { return say<"a MetaImage">(); }, {".mha", ".mhd"}},
      {[](std::string_view bytes) { return bytes.starts_with("NRRD000"); }, [] { return say<"a NRRD file">(); }, {".nrrd", ".nhdr"}},
      {isNifti, [] { return say<"a NIfTI volume">(); }, {".nii", ".nii.gz"}},
      {[](std::string_view bytes) { return bytes.starts_with("\x1F\x8B"); },
       [] { return say<"a packed file (gzip)">(); },
       {".nii.gz", ".nii"}},
      {[](std::string_view bytes) { return isAt(bytes, 128, "DICM"); }, [] { return say<"a DICOM file">(); }, {".dcm"}},
      {[](std::string_view bytes) { return bytes.starts_with("\x89PNG\r\n"); }, [] { return say<"a PNG image">(); }, {".png"}},
      {[](std::string_view bytes) { return bytes.starts_with("\xFF\xD8\xFF"); }, [] { return say<"a JPEG image">(); }, {".jpg", ".jpeg"}},
      {[](std::string_view bytes) { return bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv) || bytes.starts_with("II+\0"sv); },
       [] { return say<"a TIFF">(); },
       {".tif"}},
      {[](std::string_view bytes) { return bytes.starts_with("RIFF") && isAt(bytes, 8, "AVI "); },
       [] { return say<"a film">(); },
       {".avi"}},
      {isQuickTime, [] { return say<"a film">(); }, {".mov"}},
      {[](std::string_view bytes) { return isAt(bytes, 4, "ftyp"); }, [] { return say<"a film">(); }, {".mp4"}},
      {isMpeg, [] { return say<"a film">(); }, {".mpg"}},
      {[](std::string_view bytes) { return bytes.starts_with("\x30\x26\xB2\x75\x8E\x66\xCF\x11"); },
       [] { return say<"a film">(); },
       {".wmv"}},
      {isTransportStream, [] { return say<"a film">(); }, {".ts"}},
      {[](std::string_view bytes) { return bytes.starts_with("\x1A\x45\xDF\xA3"); }, [] { return say<"a film">(); }, {".mkv"}},
      {[](std::string_view bytes) { return bytes.starts_with("KRETZFILE"); }, [] { return say<"a Kretz volume">(); }, {".vol"}},
  };
  return kinds;
}

bool endsIn(const std::string& name, const std::vector<std::string_view>& endings) {
  return std::any_of(endings.begin(), endings.end(), [&](std::string_view ending) { return name.ends_with(ending); });
}

}  // namespace

Result<void> checkContent(const fs::path& file) {
  const std::string name = lowerCase(file.filename().string());
  if (!endsIn(name, {".mha", ".mhd", ".nrrd", ".nhdr", ".nii", ".nii.gz", ".png", ".jpg", ".jpeg", ".pgm"})) return {};
  std::ifstream in(file, std::ios::binary);
  if (!in) return {};            // whoever reads it says why
  std::string bytes(384, '\0');  // to the third packet of a transport stream
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  const auto refused = [&](Message sentence) { return failure(ErrorCode::badHeader, std::move(sentence), {{"file", file.string()}}); };
  if (bytes.empty() && !in.bad() && !endsIn(name, {".nii", ".nii.gz"}))  // the reader of those says how many bytes it needs
    return refused(say<"%1 is empty; get the file again.">(quoted(file)));
  for (const ContentKind& kind : contentKinds()) {
    if (!kind.begins(bytes)) continue;
    if (endsIn(name, kind.endings)) return {};
    return refused(
        say<"%1 is %2 under another ending; let its name end in %3.">(quoted(file), kind.isWhat(), std::string(kind.endings.front())));
  }
  return {};
}

}  // namespace ew::detail
