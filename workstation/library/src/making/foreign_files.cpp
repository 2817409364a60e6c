#include "making/foreign_files.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/file_errors.h"

namespace ew {
namespace {
namespace fs = std::filesystem;
using namespace std::string_view_literals;

using Sentence = Message (*)();

/// Files of one kind that other programs write and no reader here takes.
struct ForeignKind {
  std::vector<std::string_view> endings;  ///< in small letters
  std::vector<std::string_view> starts;   ///< first bytes that say so whatever the ending
  Sentence isWhat;
  Sentence doWhat;
};

Message exported() { return say<"export the volume from the program that wrote it as .mha, .nii or DICOM">(); }

/// The one list of kinds that are known and not read. Endings are asked first: several kinds are written in one container.
const std::vector<ForeignKind>& foreignKinds() {
  static const std::vector<ForeignKind> kinds{
      {{".mgh", ".mgz"}, {}, [] { return say<"a volume of FreeSurfer">(); }, [] { return say<"convert it to .nii.gz (mri_convert)">(); }},
      {{".imf"}, {}, [] { return say<"a file of the ImFusion Suite">(); }, exported},
      {{".mnc"},
       {"CDF\x01"sv, "CDF\x02"sv},
       [] { return say<"a volume of MINC or netCDF">(); },
       [] { return say<"convert it to .nii (mnc2nii)">(); }},
      {{".vtk", ".vti", ".vtp", ".vtu", ".vtr", ".vts"},
       {"# vtk DataFile"sv, "<VTKFile"sv},
       [] { return say<"a file of VTK">(); },
       exported},
      {{".mrb", ".mrml"}, {}, [] { return say<"a scene of 3D Slicer">(); }, [] { return say<"save the volume in it as .nrrd">(); }},
      {{".gipl"}, {}, [] { return say<"a volume in GIPL">(); }, exported},
      {{".mat"}, {"MATLAB 5.0"sv}, [] { return say<"a file of MATLAB">(); }, exported},
      {{".npy", ".npz"}, {"\x93NUMPY"sv}, [] { return say<"an array of NumPy">(); }, exported},
      {{".h5", ".hdf5", ".uff"}, {"\x89HDF\r\n"sv}, [] { return say<"an HDF5 file">(); }, exported},
      {{}, {"!INTERFILE"sv}, [] { return say<"a header of Interfile">(); }, exported},
      {{}, {"NRRD000"sv}, [] { return say<"a NRRD file under another ending">(); }, [] { return say<"let its name end in .nrrd">(); }},
      {{},
       {"\x5C\x01\0\0"sv, "\0\0\x01\x5C"sv, "\x1C\x02\0\0n+2"sv},
       [] { return say<"a NIfTI volume under another ending">(); },
       [] { return say<"let its name end in .nii">(); }},
      {{}, {"\x89PNG\r\n"sv}, [] { return say<"a PNG image under another ending">(); }, [] { return say<"let its name end in .png">(); }},
      {{}, {"\xFF\xD8\xFF"sv}, [] { return say<"a JPEG image under another ending">(); }, [] { return say<"let its name end in .jpg">(); }},
      {{},
       {"ObjectType ="sv},
       [] { return say<"a MetaImage under another ending">(); },
       [] { return say<"let its name end in .mha or .mhd">(); }},
      {{".bmp", ".gif", ".webp", ".heic", ".jp2", ".ppm"},
       {"GIF8"sv},
       [] { return say<"an image">(); },
       [] { return say<"save it as .png">(); }},
      {{".stl", ".obj", ".ply", ".glb"},
       {},
       [] { return say<"a surface, no volume">(); },
       [] { return say<"choose the volume that it was made from">(); }},
      {{".pdf"}, {"%PDF-"sv}, [] { return say<"a PDF document">(); }, [] { return say<"save the images in it as .png">(); }},
      {{".docx", ".xlsx", ".pptx", ".odt", ".ods", ".odp"},
       {},
       [] { return say<"a document of an office program">(); },
       [] { return say<"save the images in it as .png">(); }},
      {{".zip", ".gz", ".tgz", ".bz2", ".xz", ".7z", ".rar", ".tar"},
       {"PK\x03\x04"sv, "\x1F\x8B"sv, "7z\xBC\xAF"sv, "Rar!"sv, "BZh"sv,
        "\xFD"
        "7zXZ"sv},
       [] { return say<"a packed file">(); },
       [] { return say<"unpack it and choose the file in it">(); }},
  };
  return kinds;
}

std::string smallLetters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

const ForeignKind* kindByName(const fs::path& file) {
  const std::string ending = smallLetters(file.extension().string());
  for (const ForeignKind& kind : foreignKinds())
    if (std::find(kind.endings.begin(), kind.endings.end(), ending) != kind.endings.end()) return &kind;
  return nullptr;
}

const ForeignKind* kindByStart(std::string_view beginning) {
  for (const ForeignKind& kind : foreignKinds())
    if (std::any_of(kind.starts.begin(), kind.starts.end(), [&](std::string_view start) { return beginning.starts_with(start); }))
      return &kind;
  return nullptr;
}

/// Bytes of the letter of UTF-8 that begins at `at`, the last of which may lie beyond the end; 0: none begins there.
std::size_t lettersBytes(std::string_view text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  if (first < 0x80) return first == '\t' || first == '\n' || first == '\r' || first == '\f' || (first >= 0x20 && first != 0x7F) ? 1 : 0;
  const std::size_t count = first >= 0xC2 && first < 0xE0 ? 2 : first >= 0xE0 && first < 0xF0 ? 3 : first >= 0xF0 && first < 0xF5 ? 4 : 0;
  for (std::size_t n = 1; n < count && at + n < text.size(); ++n)
    if ((static_cast<unsigned char>(text[at + n]) & 0xC0u) != 0x80u) return 0;
  return count;
}

/// Letters alone, in lines: samples of a volume may happen to be letters, but none of them a line break.
bool isText(std::string_view beginning) {
  if (beginning.find_first_of("\r\n") == std::string_view::npos) return false;
  for (std::size_t at = 0; at < beginning.size();) {
    const std::size_t bytes = lettersBytes(beginning, at);
    if (bytes == 0) return false;
    at += bytes;
  }
  return true;
}

}  // namespace

std::optional<Error> whyNoSamples(const fs::path& file) {
  constexpr std::size_t looked = 64u << 10;
  constexpr std::size_t fewest = 8;  // two samples along each axis
  const auto refused = [&](ErrorCode code, Message message) { return Error{code, std::move(message), {{"file", file.string()}}}; };
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) return notOpened(file, errno).value();
  std::string beginning(looked, '\0');
  in.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  if (beginning.empty()) return refused(ErrorCode::truncated, say<"'%1' is empty; get the file again.">(file.filename()));
  const ForeignKind* kind = kindByName(file);
  if (kind == nullptr) kind = kindByStart(beginning);
  if (kind != nullptr)
    return refused(ErrorCode::unsupported, say<"'%1' is %2, which is not read; %3.">(file.filename(), kind->isWhat(), kind->doWhat()));
  if (isText(beginning))
    return refused(
        ErrorCode::unsupported,
        say<"'%1' is a text file, in which there are no images; choose the file that holds the images or the volume.">(file.filename()));
  if (beginning.size() < fewest)
    return refused(ErrorCode::unsupported,
                   say<"'%1' is too small for a volume (%2 B); choose the file that holds the images or the volume.">(file.filename(),
                                                                                                                      beginning.size()));
  return std::nullopt;
}

}  // namespace ew
