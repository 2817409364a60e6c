#include "dicom/packed_module.h"

#include <gdcmDataElement.h>
#include <gdcmJPEG2000Codec.h>
#include <gdcmJPEGCodec.h>
#include <gdcmJPEGLSCodec.h>
#include <gdcmSequenceOfFragments.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace {

template <class Decoder>
bool decoded(Decoder& decoder, const EwPackedImage& image, std::span<const unsigned char> stream, std::span<unsigned char> samples) {
  const auto bits = static_cast<unsigned short>(image.bitsStored);
  const std::array<unsigned, 3> dims{image.width_px, image.height_px, 1};
  decoder.SetNumberOfDimensions(2);
  decoder.SetDimensions(dims.data());
  decoder.SetPlanarConfiguration(0);
  decoder.SetPhotometricInterpretation(gdcm::PhotometricInterpretation(
      image.components == 3 ? gdcm::PhotometricInterpretation::YBR_FULL : gdcm::PhotometricInterpretation::MONOCHROME2));
  decoder.SetPixelFormat(gdcm::PixelFormat(static_cast<unsigned short>(image.components), static_cast<unsigned short>(image.bitsAllocated),
                                           bits, static_cast<unsigned short>(bits - 1), image.isSigned));
  decoder.SetNeedOverlayCleanup(false);
  const gdcm::SmartPointer<gdcm::SequenceOfFragments> fragments = new gdcm::SequenceOfFragments;
  gdcm::Fragment fragment;
  // Codecs look a little beyond the last marker: zeros there keep them inside.
  std::vector<char> padded(stream.begin(), stream.end());
  padded.resize((stream.size() + 17) & ~std::size_t{1}, '\0');
  fragment.SetByteValue(padded.data(), gdcm::VL(static_cast<std::uint32_t>(padded.size())));
  fragments->AddFragment(fragment);
  gdcm::DataElement in(gdcm::Tag(0x7fe0, 0x0010)), out;
  in.SetValue(*fragments);
  if (!decoder.Decode(in, out)) return false;
  const gdcm::ByteValue* const value = out.GetByteValue();
  if (value == nullptr) return false;
  // Values have an even length; a byte more is padding.
  if (value->GetLength() < samples.size() || value->GetLength() > samples.size() + 1) return false;
  const auto* const bytes = reinterpret_cast<const unsigned char*>(value->GetPointer());
  std::copy_n(bytes, samples.size(), samples.begin());
  return true;
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) EwUnpack ewUnpack;

bool ewUnpack(const EwPackedImage* image, const unsigned char* stream, std::size_t bytes, unsigned char* samples, std::size_t wanted) {
  const std::span in(stream, bytes);
  const std::span out(samples, wanted);
  try {
    switch (image->codec) {
      case ewPackedJpeg: {
        gdcm::JPEGCodec decoder;
        return decoded(decoder, *image, in, out);
      }
      case ewPackedJpegLs: {
        gdcm::JPEGLSCodec decoder;
        return decoded(decoder, *image, in, out);
      }
      case ewPackedJpeg2000: {
        gdcm::JPEG2000Codec decoder;
        return decoded(decoder, *image, in, out);
      }
      default:
        return false;
    }
  } catch (...) {
    return false;  // GDCM and CharLS throw on damaged streams
  }
}
}
