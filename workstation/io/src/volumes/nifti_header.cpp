#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "ew/core/figures.h"
#include "ew/core/file_errors.h"
#include "ew/core/numbers.h"
#include "files/header_fields.h"
#include "files/image_header.h"

namespace ew::detail {
namespace {
namespace fs = std::filesystem;

constexpr std::size_t kSize1 = 348;
constexpr std::size_t kSize2 = 540;

/// Numbers at fixed places of a binary header, in the file's byte order.
class Binary {
 public:
  Binary(std::span<const std::uint8_t> bytes, bool bigEndian)
      : bytes_(bytes), swap_(bigEndian != (std::endian::native == std::endian::big)) {}
  template <class T>
  [[nodiscard]] T at(std::size_t offset) const {
    std::array<std::uint8_t, sizeof(T)> copy;
    std::memcpy(copy.data(), bytes_.data() + offset, sizeof(T));
    if (swap_) std::reverse(copy.begin(), copy.end());
    return std::bit_cast<T>(copy);
  }

 private:
  std::span<const std::uint8_t> bytes_;
  bool swap_;
};

/// The parts of both versions that matter here, in one form.
struct Nifti {
  std::array<std::int64_t, 8> dim{};
  std::array<double, 8> pixdim{};
  int dataType = 0;
  double voxelOffset = 0.0;
  double slope = 0.0;
  double intercept = 0.0;
  int qformCode = 0;
  int sformCode = 0;
  std::array<double, 3> quaternion{};
  std::array<double, 3> offset{};
  std::array<std::array<double, 4>, 3> rows{};
  int units = 0;
  int intent = 0;
  double shownFrom = 0.0;  ///< cal_min
  double shownTo = 0.0;    ///< cal_max
  double timeOffset = 0.0;
};

/// Sizes and places are lengths that somebody gave in decimals.
Nifti parse1(const Binary& in) {
  Nifti nifti;
  for (std::size_t i = 0; i < 8; ++i) {
    nifti.dim[i] = in.at<std::int16_t>(40 + 2 * i);
    nifti.pixdim[i] = decimalOf(in.at<float>(76 + 4 * i));
  }
  nifti.dataType = in.at<std::int16_t>(70);
  nifti.voxelOffset = static_cast<double>(in.at<float>(108));
  nifti.slope = static_cast<double>(in.at<float>(112));
  nifti.intercept = static_cast<double>(in.at<float>(116));
  nifti.intent = in.at<std::int16_t>(68);
  nifti.shownTo = static_cast<double>(in.at<float>(124));
  nifti.shownFrom = static_cast<double>(in.at<float>(128));
  nifti.timeOffset = static_cast<double>(in.at<float>(136));
  nifti.units = in.at<std::uint8_t>(123);
  nifti.qformCode = in.at<std::int16_t>(252);
  nifti.sformCode = in.at<std::int16_t>(254);
  for (std::size_t i = 0; i < 3; ++i) {
    nifti.quaternion[i] = static_cast<double>(in.at<float>(256 + 4 * i));
    nifti.offset[i] = decimalOf(in.at<float>(268 + 4 * i));
    for (std::size_t j = 0; j < 4; ++j) nifti.rows[i][j] = decimalOf(in.at<float>(280 + 16 * i + 4 * j));
  }
  return nifti;
}

Nifti parse2(const Binary& in) {
  Nifti nifti;
  nifti.dataType = in.at<std::int16_t>(12);
  for (std::size_t i = 0; i < 8; ++i) {
    nifti.dim[i] = in.at<std::int64_t>(16 + 8 * i);
    nifti.pixdim[i] = in.at<double>(104 + 8 * i);
  }
  nifti.voxelOffset = static_cast<double>(in.at<std::int64_t>(168));
  nifti.slope = in.at<double>(176);
  nifti.intercept = in.at<double>(184);
  nifti.shownTo = in.at<double>(192);
  nifti.shownFrom = in.at<double>(200);
  nifti.timeOffset = in.at<double>(216);
  nifti.intent = in.at<std::int32_t>(504);
  nifti.qformCode = in.at<std::int32_t>(344);
  nifti.sformCode = in.at<std::int32_t>(348);
  for (std::size_t i = 0; i < 3; ++i) {
    nifti.quaternion[i] = in.at<double>(352 + 8 * i);
    nifti.offset[i] = in.at<double>(376 + 8 * i);
    for (std::size_t j = 0; j < 4; ++j) nifti.rows[i][j] = in.at<double>(400 + 32 * i + 8 * j);
  }
  nifti.units = in.at<std::int32_t>(500);
  return nifti;
}

Result<void> takeType(const Nifti& nifti, ImageHeader& header) {
  switch (nifti.dataType) {
    case 2:
      header.type = SampleType::u8;
      return {};
    case 4:
      header.type = SampleType::i16;
      return {};
    case 8:
      header.type = SampleType::i32;
      return {};
    case 16:
      header.type = SampleType::f32;
      return {};
    case 64:
      header.type = SampleType::f64;
      return {};
    case 128:
      header.type = SampleType::u8;
      header.channels = 3;
      return {};
    case 256:
      header.type = SampleType::i8;
      return {};
    case 512:
      header.type = SampleType::u16;
      return {};
    case 768:
      header.type = SampleType::u32;
      return {};
    case 1024:
      header.type = SampleType::i64;
      return {};
    case 1280:
      header.type = SampleType::u64;
      return {};
    case 2304:
      header.type = SampleType::u8;
      header.channels = 4;
      return {};
    default:
      return failure(ErrorCode::unsupported,
                     say<"%1 has samples of NIfTI data type %2, which is not read; convert it to whole or floating point numbers.">(
                         quoted(header.file), nifti.dataType),
                     {{"file", header.file.string()}, {"datatype", std::to_string(nifti.dataType)}});
  }
}

/// The code for the unit of length (NIFTI_UNITS): 0 for none stated, 1 to 3 for metres, millimetres and micrometres; others mean nothing.
int lengthCode(int units) { return units & 7; }

/// Millimetres per unit of length of the file.
double niftiUnit_mm(int units) {
  switch (lengthCode(units)) {
    case 1:
      return 1000.0;
    case 3:
      return 0.001;
    default:
      return 1.0;
  }
}

/// Rotation from the three stored parts of a unit quaternion; the first part follows from the others.
glm::dmat3 rotationOf(const std::array<double, 3>& q) {
  const double b = q[0];
  const double c = q[1];
  const double d = q[2];
  const double a = std::sqrt(std::max(0.0, 1.0 - b * b - c * c - d * d));
  glm::dmat3 r;
  r[0] = glm::dvec3(a * a + b * b - c * c - d * d, 2.0 * (b * c + a * d), 2.0 * (b * d - a * c));
  r[1] = glm::dvec3(2.0 * (b * c - a * d), a * a + c * c - b * b - d * d, 2.0 * (c * d + a * b));
  r[2] = glm::dvec3(2.0 * (b * d + a * c), 2.0 * (c * d - a * b), a * a + d * d - b * b - c * c);
  return r;
}

/// Steps along i, j, k (columns) and the place of the first voxel, in the file's right-anterior-superior units.
struct Placing {
  glm::dmat3 axes{1.0};
  glm::dvec3 origin{0.0};
};

Placing placingByAffine(const Nifti& nifti) {
  Placing placing;
  for (int row = 0; row < 3; ++row) {
    const auto& from = nifti.rows[static_cast<std::size_t>(row)];
    for (int axis = 0; axis < 3; ++axis) placing.axes[axis][row] = from[static_cast<std::size_t>(axis)];
    placing.origin[row] = from[3];
  }
  return placing;
}

Placing placingByQuaternion(const Nifti& nifti, const std::array<double, 3>& pixel) {
  Placing placing{rotationOf(nifti.quaternion), glm::dvec3(nifti.offset[0], nifti.offset[1], nifti.offset[2])};
  const double mirrored = nifti.pixdim[0] < 0.0 ? -1.0 : 1.0;
  for (int axis = 0; axis < 3; ++axis) placing.axes[axis] *= pixel[static_cast<std::size_t>(axis)] * (axis == 2 ? mirrored : 1.0);
  return placing;
}

/// The two descriptions of one place may say different things; whoever registered the file meant one of them.
void notePlacings(const Nifti& nifti, const std::array<double, 3>& pixel, double mm, std::vector<Message>& notes) {
  if (nifti.sformCode <= 0 || nifti.qformCode <= 0 || nifti.dim[0] < 3) return;
  const Placing affine = placingByAffine(nifti), quaternion = placingByQuaternion(nifti, pixel);
  // The corner that lies farthest from the first voxel shows the most; a hundredth of a voxel is rounding of the quaternion.
  double apart = 0.0, voxel = 1e300;
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 step(0.0);
    for (int axis = 0; axis < 3; ++axis)
      if ((corner >> axis & 1) != 0)
        step[axis] = static_cast<double>(std::max<std::int64_t>(nifti.dim[static_cast<std::size_t>(axis) + 1], 1) - 1);
    apart = std::max(apart, glm::length(affine.axes * step + affine.origin - quaternion.axes * step - quaternion.origin));
  }
  for (const double size : pixel) voxel = std::min(voxel, size);
  if (apart > std::max(0.01 * voxel, 1e-3))
    notes.push_back(say<"The file describes its place twice, and the two differ by up to %1 mm (sform and qform); the sform was used.">(
        textOf(std::round(apart * mm * 100.0) / 100.0)));
}

/// Voxel sizes may contradict the affine too; those of the quaternion's place are told by notePlacings().
void noteSizes(const Nifti& nifti, const std::array<double, 3>& pixel, const glm::dmat3& axes, double mm, std::vector<Message>& notes) {
  const bool compared = nifti.qformCode > 0 && nifti.dim[0] >= 3;
  std::array<std::string, 2> sizes;
  bool differ = false;
  for (int axis = 0; axis < std::min<std::int64_t>(nifti.dim[0], 3); ++axis) {
    const double used = glm::length(axes[axis]), stated = pixel[static_cast<std::size_t>(axis)];
    differ = differ || (stated > 0.0 && std::abs(used - stated) > 0.01 * used);
    sizes[0] += (axis > 0 ? " x " : "") + figureText(used * mm);
    sizes[1] += (axis > 0 ? " x " : "") + figureText(stated * mm);
  }
  const bool unset = pixel == std::array{1.0, 1.0, 1.0};  // what writers of an affine leave there
  if (differ && !compared && !unset)
    notes.push_back(
        say<"The file gives two voxel sizes: %1 mm by its sform, which was used, and %2 mm by its pixdim.">(sizes[0], sizes[1]));
}

Result<void> takeGeometry(const Nifti& nifti, ImageHeader& header) {
  const double mm = niftiUnit_mm(nifti.units);
  glm::dmat3 axes(1.0);  // columns: a step along i, j, k in the file's right-anterior-superior mm
  glm::dvec3 origin(0.0);
  std::array<double, 3> pixel{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool used = static_cast<std::int64_t>(axis) < nifti.dim[0];
    const double size = used ? std::abs(nifti.pixdim[axis + 1]) : 1.0;
    pixel[axis] = size;
    if (used && !std::isfinite(size)) return badField(header.file, verbatim("pixdim"), say<"not a number">(), say<"finite voxel sizes">());
  }
  notePlacings(nifti, pixel, mm, header.notes);
  // The affine is the fuller description, so it is asked first; the quaternion, then the bare voxel sizes stand in for it.
  if (nifti.sformCode > 0) {
    const Placing placing = placingByAffine(nifti);
    axes = placing.axes;
    origin = placing.origin;
    noteSizes(nifti, pixel, axes, mm, header.notes);
    for (int axis = static_cast<int>(std::max<std::int64_t>(nifti.dim[0], 0)); axis < 3; ++axis)
      if (!(glm::length(axes[axis]) > 0.0) && axis == 2) axes[2] = glm::normalize(glm::cross(axes[0], axes[1]));
  } else if (nifti.qformCode > 0) {
    const Placing placing = placingByQuaternion(nifti, pixel);
    axes = placing.axes;
    origin = placing.origin;
  } else {
    for (int axis = 0; axis < 3; ++axis) axes[axis][axis] = pixel[static_cast<std::size_t>(axis)];
    header.notes.push_back(say<"The file gives voxel sizes but no orientation; its axes were taken for right, anterior and superior.">());
  }
  const glm::dvec3 toLps(-1.0, -1.0, 1.0);
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 step_mm = axes[axis] * toLps * mm;
    const double length = glm::length(step_mm);
    if (!std::isfinite(length) || !(length > 0.0))
      return badField(header.file, say<"the voxel size along axis %1">(axis + 1), verbatim(textOf(length)), say<"a length above 0">());
    header.geometry.spacing_mm[axis] = length;
    header.geometry.directions[axis] = step_mm / length;
  }
  header.geometry.origin_mm = origin * toLps * mm;
  completeGeometry(header);
  if (const int code = lengthCode(nifti.units); code > 3) {
    header.spacingProblem = say<"%1 gives the unit of its sizes as the code %2, which means nothing in NIfTI; give the spacing in mm.">(
        quoted(header.file), code);
    header.hasGeometry = false;
  }
  std::array<bool, 3> stated{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    stated[axis] = static_cast<std::int64_t>(axis) < nifti.dim[0] ||
                   (nifti.sformCode > 0 && glm::length(placingByAffine(nifti).axes[static_cast<int>(axis)]) > 0.0);
  noteUnstatedSpacing(header, stated);
  // One millimetre in every direction and nothing moved is what converters write when they know no better, in either hand.
  const bool unitSpacing = header.geometry.spacing_mm == glm::dvec3(1.0);
  const bool alongAxes = glm::abs(header.geometry.directions[0]) == glm::dvec3(1, 0, 0) &&
                         glm::abs(header.geometry.directions[1]) == glm::dvec3(0, 1, 0) &&
                         glm::abs(header.geometry.directions[2]) == glm::dvec3(0, 0, 1);
  if (unitSpacing && alongAxes && header.geometry.origin_mm == glm::dvec3(0.0)) header.hasGeometry = false;
  return {};
}

constexpr std::array kNiftiFields{FieldTableRow{"cal_min cal_max", FieldTouches::levels}, FieldTableRow{"toffset", FieldTouches::time}};

/// The fifth axis holds the components of a vector or the like (the sixth and seventh what the file likes): no steps of time.
Result<void> checkComponents(const Nifti& nifti, const ImageHeader& header) {
  std::vector<std::uint64_t> lengths;
  for (std::size_t axis = 4; axis < header.sizes.size(); ++axis) lengths.push_back(std::max<std::uint64_t>(header.sizes[axis], 1));
  const auto components = productOf(lengths);  // empty: more than can be counted
  if (components && *components <= 1) return {};
  return failure(
      ErrorCode::unsupported,
      say<"%1 has %2 components per sample (axis 5 and above, intent %3), as vectors of a motion have; they are no echo level and no time "
          "steps: export the echo levels alone.">(quoted(header.file), countText(components), nifti.intent),
      {{"file", header.file.string()}, {"channels", countText(components).english()}});
}

tl::unexpected<Error> notNifti(const fs::path& file) {
  return failure(ErrorCode::badHeader, say<"%1 is not a NIfTI volume; check what kind of file it is.">(quoted(file)),
                 {{"file", file.string()}});
}

}  // namespace

Result<ImageHeader> readNiftiHeader(const fs::path& file) {
  std::array<std::uint8_t, kSize2> bytes{};
  // gzread passes files through that are not compressed, so one way serves .nii and .nii.gz.
  errno = 0;
  gzFile in = gzopen(file.c_str(), "rb");
  if (in == nullptr) return notOpened(file, errno);
  const int got = gzread(in, bytes.data(), static_cast<unsigned>(bytes.size()));
  const bool compressed = gzdirect(in) == 0;
  gzclose(in);
  if (got < static_cast<int>(kSize1))
    return failure(
        ErrorCode::truncated,
        say<"%1 is too short: a NIfTI header has at least 348 bytes, the file has %2; get the file again.">(quoted(file), std::max(got, 0)),
        {{"file", file.string()}});
  const auto sizeIs = [&](bool bigEndian) { return Binary(bytes, bigEndian).at<std::int32_t>(0); };
  ImageHeader header;
  header.file = file;
  header.dataFile = file;
  header.packing = compressed ? Packing::deflated : Packing::raw;
  header.bigEndian = sizeIs(true) == static_cast<int>(kSize1) || sizeIs(true) == static_cast<int>(kSize2);
  const int size = sizeIs(header.bigEndian);
  Nifti nifti;
  const auto* const text = reinterpret_cast<const char*>(bytes.data());
  if (size == static_cast<int>(kSize1)) {
    if (std::string_view(text + 344, 3) == "ni1")
      return failure(ErrorCode::unsupported,
                     say<"%1 is the header of a two-file NIfTI (.hdr + .img); convert it to a single .nii.">(quoted(file)),
                     {{"file", file.string()}});
    if (std::string_view(text + 344, 3) != "n+1") return notNifti(file);
    nifti = parse1(Binary(bytes, header.bigEndian));
  } else if (size == static_cast<int>(kSize2) && got == static_cast<int>(kSize2) && std::string_view(text + 4, 3) == "n+2") {
    nifti = parse2(Binary(bytes, header.bigEndian));
  } else {
    return notNifti(file);
  }
  if (nifti.dim[0] < 1 || nifti.dim[0] > 7)
    return badField(file, verbatim("dim[0]"), verbatim(std::to_string(nifti.dim[0])), say<"a number of axes from 1 to 7">());
  for (std::int64_t axis = 1; axis <= nifti.dim[0]; ++axis) {
    const std::int64_t length = nifti.dim[static_cast<std::size_t>(axis)];
    if (length < 0)
      return badField(file, verbatim("dim[" + std::to_string(axis) + "]"), verbatim(std::to_string(length)), say<"a length above 0">());
    header.sizes.push_back(static_cast<std::uint64_t>(length));
  }
  if (auto taken = takeType(nifti, header); !taken) return passOn(taken.error());
  if (auto usable = checkComponents(nifti, header); !usable) return passOn(usable.error());
  // Some writers leave the place of the samples at 0 and mean "right behind the header".
  const double smallest = size == static_cast<int>(kSize1) ? 352.0 : 544.0;
  if (nifti.voxelOffset == 0.0) nifti.voxelOffset = smallest;
  if (!std::isfinite(nifti.voxelOffset) || nifti.voxelOffset < smallest || nifti.voxelOffset > 1e15)
    return badField(file, verbatim("vox_offset"), verbatim(textOf(nifti.voxelOffset)), say<"at least %1">(static_cast<int>(smallest)));
  (compressed ? header.skipUnpacked : header.dataOffset) = static_cast<std::uint64_t>(nifti.voxelOffset);
  if (nifti.slope != 0.0 && std::isfinite(nifti.slope) && std::isfinite(nifti.intercept)) {
    header.slope = nifti.slope;
    header.intercept = nifti.intercept;
  }
  if (auto taken = takeGeometry(nifti, header); !taken) return passOn(taken.error());
  HeaderFields fields(kNiftiFields);
  if (nifti.shownTo > nifti.shownFrom) fields.meet("cal_min cal_max", textOf(nifti.shownFrom) + " " + textOf(nifti.shownTo));
  if (nifti.timeOffset != 0.0 && std::isfinite(nifti.timeOffset)) fields.meet("toffset", textOf(nifti.timeOffset));
  for (Message& note : fields.unused()) header.notes.push_back(std::move(note));
  return header;
}

}  // namespace ew::detail
