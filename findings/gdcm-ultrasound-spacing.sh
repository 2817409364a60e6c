#!/usr/bin/env bash
# GDCM 3.0.21 (Debian python3-gdcm 3.0.21-1): for ultrasound, Image::GetSpacing()
# returns PhysicalDeltaX/Y of the FIRST ultrasound region as they stand. It reads
# neither the units beside them nor what kind of region it is. So a B-mode cine in
# centimetres comes out ten times too small next to a CT of the same pixel size, and
# a cine whose first region is a Doppler trace gets seconds and (negative) cm/s as
# "spacing", although a calibrated B-mode region follows.
# Surprised: whoever measures ultrasound with the millimetres that GetSpacing() gives
# for CT or MR. Expected: millimetres (cm x 10, only from a spatial region), or the
# value 1 that gdcmImage.h announces for "spacing not specified".
# Source: DICOM PS3.3 C.8.5.5, US Region Calibration Module: Physical Units X/Y
# Direction (0018,6024/6026) say what the deltas mean (3 = cm, 4 = s, 7 = cm/s).
set -euo pipefail

packages=(python3-gdcm=3.0.21-1 libgdcm3.0=3.0.21-1 python3-pydicom=2.3.1-1)
# What GDCM is linked with, in whatever version the release has now.
linked=('libsocket++1' libcharls2 libopenjp2-7 libjson-c5)

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

apt=(apt-get -qq -o APT::Sandbox::User=root)
if ! "${apt[@]}" download "${packages[@]}" "${linked[@]}" >/dev/null 2>&1; then
  # No package lists here yet, or old ones: fetch them into the temporary folder.
  mkdir -p lists/partial cache/archives/partial
  apt+=(-o "Dir::State::Lists=$work/lists" -o "Dir::Cache=$work/cache")
  "${apt[@]}" update
  "${apt[@]}" download "${packages[@]}" "${linked[@]}" >/dev/null
fi
for deb in *.deb; do dpkg -x "$deb" root; done
version=$(dpkg-deb -f python3-gdcm_*.deb Version)
[ "$version" = 3.0.21-1 ] || { echo "This is GDCM $version, another one." >&2; exit 1; }

cat > spacing.py <<'PYTHON'
import sys

import gdcm
from pydicom.dataset import Dataset, FileDataset, FileMetaDataset
from pydicom.uid import ExplicitVRLittleEndian, generate_uid

CT, US_CINE = "1.2.840.10008.5.1.4.1.1.2", "1.2.840.10008.5.1.4.1.1.3.1"
ROWS, COLUMNS = 48, 64


def region(kind, data, top, bottom, unit_x, unit_y, delta_x, delta_y):
    item = Dataset()
    item.RegionSpatialFormat, item.RegionDataType, item.RegionFlags = kind, data, 0
    item.RegionLocationMinX0, item.RegionLocationMaxX1 = 0, COLUMNS - 1
    item.RegionLocationMinY0, item.RegionLocationMaxY1 = top, bottom
    item.PhysicalUnitsXDirection, item.PhysicalUnitsYDirection = unit_x, unit_y
    item.PhysicalDeltaX, item.PhysicalDeltaY = delta_x, delta_y
    return item


def spacing(name, sop_class, frames, **attributes):
    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID = sop_class
    meta.MediaStorageSOPInstanceUID = generate_uid()
    meta.TransferSyntaxUID = ExplicitVRLittleEndian
    image = FileDataset(name, {}, file_meta=meta, preamble=bytes(128))
    image.is_little_endian, image.is_implicit_VR = True, False
    image.SOPClassUID = sop_class
    image.SOPInstanceUID = meta.MediaStorageSOPInstanceUID
    image.StudyInstanceUID, image.SeriesInstanceUID = generate_uid(), generate_uid()
    image.PatientName, image.PatientID = "Phantom", "1"
    image.SamplesPerPixel, image.PhotometricInterpretation = 1, "MONOCHROME2"
    image.Rows, image.Columns = ROWS, COLUMNS
    image.BitsAllocated, image.BitsStored, image.HighBit = 8, 8, 7
    image.PixelRepresentation = 0
    for key, value in attributes.items():
        setattr(image, key, value)
    image.PixelData = bytes(ROWS * COLUMNS * frames)
    image.save_as(name, write_like_original=False)
    reader = gdcm.ImageReader()
    reader.SetFileName(name)
    if not reader.Read():
        sys.exit(f"GDCM could not read {name}")
    found = tuple(round(reader.GetImage().GetSpacing(axis), 6) for axis in (0, 1))
    print(f"  {name:12} GetSpacing() = {found}")
    return found


print("GDCM", gdcm.Version.GetVersion())
if gdcm.Version.GetVersion() != "3.0.21":
    sys.exit("This is not the version the finding is about.")

b_mode = region(1, 1, 0, 47, 3, 3, 0.05, 0.05)         # 0.05 cm = 0.5 mm a pixel
doppler = region(3, 3, 0, 19, 4, 7, 0.004, -0.2)       # seconds across, cm/s upwards
b_mode_below = region(1, 1, 20, 47, 3, 3, 0.05, 0.05)
cine = dict(Modality="US", NumberOfFrames=2, FrameTime="40", FrameIncrementPointer=0x00181063)

print("Three pictures with pixels of 0.5 mm x 0.5 mm:")
mm = spacing("ct.dcm", CT, 1, Modality="CT", PixelSpacing=["0.5", "0.5"],
             ImagePositionPatient=["0", "0", "0"], ImageOrientationPatient=list("100010"))
cm = spacing("b-mode.dcm", US_CINE, 2, SequenceOfUltrasoundRegions=[b_mode], **cine)
duplex = spacing("duplex.dcm", US_CINE, 2,
                 SequenceOfUltrasoundRegions=[doppler, b_mode_below], **cine)

if (mm, cm, duplex) != ((0.5, 0.5), (0.05, 0.05), (0.004, -0.2)):
    sys.exit("Changed: GDCM no longer hands out the first region's bare deltas as spacing.")
print("As described: 0.5 is millimetres, 0.05 is centimetres, (0.004, -0.2) is s and cm/s.")
PYTHON

# Debian builds the module for its own interpreter, which need not be first in PATH.
LD_LIBRARY_PATH="$work/root/usr/lib/x86_64-linux-gnu" \
  PYTHONPATH="$work/root/usr/lib/python3/dist-packages" /usr/bin/python3 spacing.py
