#!/usr/bin/env bash
# VTK 9.1.0 (Debian python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1): after reading a
# MetaImage file (.mha, .mhd) that has no DistanceUnits line, and VTK's own writer and
# ITK write none unless told to, vtkMetaImageReader's GetDistanceUnits() says "um". A
# reader that has read nothing yet says "mm".
# Surprised: whoever trusts the answer to label a ruler or to scale ElementSpacing: a
# probe picture of 40 mm becomes 0.04 mm, while files that do say mm are right.
# Expected: no claim, or the "mm" the reader began with. MetaIO, which VTK wraps, knows a
# value for it: MET_DISTANCE_UNITS_UNKNOWN, named "?" in metaTypes.h beside um, mm, cm.
set -euo pipefail

wanted=9.1.0+really9.1.0+dfsg2-5+deb12u1

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

fetch() {
  # First the two packages in question, then what they are linked with, as it is now.
  apt-get -qq -o APT::Sandbox::User=root "$@" download \
    "python3-vtk9=$wanted" "libvtk9.1=$wanted" \
    libtbb12 libtiff6 libjpeg62-turbo libpng16-16 libwebp7 libdeflate0 liblerc4 libjbig0 \
    >/dev/null
}
lists=(-o "Dir::State::Lists=$work/lists" -o "Dir::Cache=$work/cache")
if ! fetch 2>/dev/null; then
  mkdir -p lists/partial cache/archives/partial
  apt-get -qq -o APT::Sandbox::User=root "${lists[@]}" update
  fetch "${lists[@]}"
fi
for deb in *.deb; do dpkg -x "$deb" root; done
found=$(dpkg-deb -f python3-vtk9_*.deb Version)
if [ "$found" != "$wanted" ]; then
  echo "This is VTK $found, not the version the finding is about." >&2
  exit 1
fi

cat > units.py <<'PYTHON'
import sys

from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkMetaImageReader, vtkMetaImageWriter


def write_with_vtk(name):
    image = vtkImageData()
    image.SetDimensions(4, 3, 2)
    image.SetSpacing(0.2, 0.2, 0.5)
    image.AllocateScalars(VTK_UNSIGNED_CHAR, 1)
    image.GetPointData().GetScalars().Fill(7)
    writer = vtkMetaImageWriter()
    writer.SetInputData(image)
    writer.SetFileName(name)
    writer.SetCompression(False)
    writer.Write()


def write_by_hand(name, *lines):
    header = ["ObjectType = Image", "NDims = 3", "BinaryData = True",
              "BinaryDataByteOrderMSB = False", *lines, "ElementSpacing = 0.2 0.2 0.5",
              "DimSize = 4 3 2", "ElementType = MET_UCHAR", "ElementDataFile = LOCAL"]
    with open(name, "wb") as file:
        file.write("\n".join(header).encode() + b"\n" + bytes(24))


def units(name):
    reader = vtkMetaImageReader()
    reader.SetFileName(name)
    reader.Update()
    if reader.GetErrorCode() or reader.GetOutput().GetDimensions() != (4, 3, 2):
        sys.exit(f"VTK did not read {name}.")
    return reader.GetDistanceUnits()


write_with_vtk("own.mha")
if b"DistanceUnits" in open("own.mha", "rb").read():
    sys.exit("Changed: VTK's own writer now states the units.")
write_by_hand("none.mha")
write_by_hand("mm.mha", "DistanceUnits = mm")
write_by_hand("cm.mha", "DistanceUnits = cm")

answers = {
    "before any file": vtkMetaImageReader().GetDistanceUnits(),
    "written by VTK, no units": units("own.mha"),
    "by hand, no units": units("none.mha"),
    "DistanceUnits = mm": units("mm.mha"),
    "DistanceUnits = cm": units("cm.mha"),
}
print("VTK", vtkVersion.GetVTKVersion())
for what, answer in answers.items():
    print(f"  {what:26} GetDistanceUnits() = {answer}")
if list(answers.values()) != ["mm", "um", "um", "mm", "cm"]:
    sys.exit("Changed: VTK answers differently about files without units.")
print("As described: silence about units is read as micrometres.")
PYTHON
LD_LIBRARY_PATH="$work/root/usr/lib/x86_64-linux-gnu" \
  PYTHONPATH="$work/root/usr/lib/python3/dist-packages" /usr/bin/python3 units.py
