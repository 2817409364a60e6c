#pragma once

#include <gdcmDataElement.h>
#include <gdcmJPEG2000Codec.h>
#include <gdcmJPEGCodec.h>
#include <gdcmJPEGLSCodec.h>
#include <gdcmSequenceOfFragments.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace ew::test {

/// One packed image of `samples` x 8 or 16 bit values, by GDCM's own writer of that codec.
template <class Codec>
std::string packedBy(const std::string& image, std::uint16_t columns, std::uint16_t rows, int samples, int bits, bool lossless = true) {
  Codec codec;
  const std::array<unsigned, 3> dims{columns, rows, 1};
  codec.SetNumberOfDimensions(2);
  codec.SetDimensions(dims.data());
  codec.SetPlanarConfiguration(0);
  codec.SetPhotometricInterpretation(
      gdcm::PhotometricInterpretation(samples == 3 ? gdcm::PhotometricInterpretation::RGB : gdcm::PhotometricInterpretation::MONOCHROME2));
  codec.SetPixelFormat(gdcm::PixelFormat(static_cast<unsigned short>(samples), static_cast<unsigned short>(bits > 8 ? 16 : 8),
                                         static_cast<unsigned short>(bits), static_cast<unsigned short>(bits - 1), 0));
  if constexpr (std::is_same_v<Codec, gdcm::JPEGCodec>) {
    codec.SetLossless(lossless);
    if (!lossless) codec.SetQuality(95);
  }
  gdcm::DataElement in(gdcm::Tag(0x7fe0, 0x0010)), out;
  in.SetByteValue(image.data(), gdcm::VL(static_cast<std::uint32_t>(image.size())));
  if (!codec.Code(in, out)) throw std::runtime_error("GDCM would not pack the image");
  const gdcm::SequenceOfFragments* const all = out.GetSequenceOfFragments();
  const gdcm::ByteValue* const bytes = all != nullptr ? all->GetFragment(0).GetByteValue() : out.GetByteValue();
  if (bytes == nullptr) throw std::runtime_error("GDCM packed nothing");
  return {bytes->GetPointer(), bytes->GetLength()};
}

}  // namespace ew::test
