#!/usr/bin/env bash
# VTK 9.1.0 (Debian python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1) meets ITK 5.2.1:
# vtkNrrdReader reads only the first slice of a colour, vector or list volume that ITK
# wrote, without an error or a warning. It takes the header line "space: left-posterior-
# superior" for a number of axes, 3, and so cuts the four "sizes" in the next line to
# three. ITK and Teem both write "space" before "sizes". With these two lines swapped,
# which changes nothing in what the file says, VTK reads every slice.
# Surprised: whoever hands a colour 3D ultrasound volume, a deformation field or a list
# of volumes from ITK or Teem to VTK. Expected: the same slices in either order.
# Source: NRRD format definition (Teem): "dimension" is the number of axes and has to
# come before "sizes"; "space" is about the world the axes lie in, not their number.
# Needs a C++ compiler for the few lines that let ITK write the file.
set -euo pipefail

vtk=9.1.0+really9.1.0+dfsg2-5+deb12u1
itk=5.2.1-5+deb12u1
packages=("python3-vtk9=$vtk" "libvtk9.1=$vtk"
  "libinsighttoolkit5-dev=$itk" "libinsighttoolkit5.2=$itk")
# What VTK's image readers are linked with, in whatever version the release has now.
linked=(libtbb12 libtiff6 libjpeg62-turbo libpng16-16 libwebp7 libdeflate0 liblerc4 libjbig0)

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

download() { "$@" download "${packages[@]}" "${linked[@]}" >/dev/null; }
quiet=(apt-get -qq -o APT::Sandbox::User=root)
if ! download "${quiet[@]}" 2>/dev/null; then
  # Without usable package lists on the machine, use new ones in this folder.
  mkdir -p lists/partial cache/archives/partial
  own=("${quiet[@]}" -o "Dir::State::Lists=$work/lists" -o "Dir::Cache=$work/cache")
  "${own[@]}" update
  download "${own[@]}"
fi
for deb in *.deb; do dpkg -x "$deb" root; done
versions="$(dpkg-deb -f python3-vtk9_*.deb Version) $(dpkg-deb -f libinsighttoolkit5.2_*.deb Version)"
[ "$versions" = "$vtk $itk" ] || { echo "Other versions: $versions" >&2; exit 1; }

cat > write.cxx <<'CXX'
#include <itkNrrdImageIO.h>
#include <itkVersion.h>

#include <iostream>
#include <vector>

int main() {
  const unsigned size[] = {16, 12, 6};
  std::vector<unsigned char> rgb(16 * 12 * 6 * 3);
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = i / (16 * 12 * 3);  // its slice
  auto io = itk::NrrdImageIO::New();
  io->SetNumberOfDimensions(3);
  for (unsigned axis = 0; axis < 3; ++axis) {
    io->SetDimensions(axis, size[axis]);
    io->SetSpacing(axis, 0.5);
    io->SetOrigin(axis, 0);
    std::vector<double> direction(3);
    direction[axis] = 1;
    io->SetDirection(axis, direction);
  }
  io->SetComponentType(itk::CommonEnums::IOComponent::UCHAR);
  io->SetPixelType(itk::CommonEnums::IOPixel::RGB);
  io->SetNumberOfComponents(3);
  io->SetFileName("colour.nrrd");
  io->Write(rgb.data());

  auto back = itk::NrrdImageIO::New();
  back->SetFileName("colour.nrrd");
  back->ReadImageInformation();
  std::cout << "ITK " << itk::Version::GetITKVersion() << " reads its file:        "
            << back->GetDimensions(0) << " x " << back->GetDimensions(1) << " x "
            << back->GetDimensions(2) << ", " << back->GetNumberOfComponents()
            << " components" << std::endl;
  return back->GetNumberOfDimensions() == 3 && back->GetDimensions(2) == 6 ? 0 : 1;
}
CXX
export LD_LIBRARY_PATH="$work/root/usr/lib:$work/root/usr/lib/x86_64-linux-gnu"
libraries=()
for name in ITKIONRRD ITKIOImageBase ITKCommon; do
  libraries+=("root/usr/lib/lib$name-5.2.so.1")
done
g++ -std=c++17 -w -I root/usr/include/ITK-5.2 write.cxx "${libraries[@]}" \
  -Wl,-rpath-link,root/usr/lib -o write
./write || { echo "Changed: ITK does not read its own file back." >&2; exit 1; }

cat > read.py <<'PYTHON'
import sys

from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkIOImage import vtkNrrdReader  # of "import vtk" it would be the MPI one


def read(name):
    reader = vtkNrrdReader()
    reader.SetFileName(name)
    reader.Update()
    image = reader.GetOutput()
    return image.GetDimensions(), image.GetNumberOfScalarComponents(), reader.GetErrorCode()


written = open("colour.nrrd", "rb").read()
space, sizes = b"space: left-posterior-superior\n", b"sizes: 3 16 12 6\n"
if space + sizes not in written:
    sys.exit("Changed: ITK no longer writes the space right before the sizes.")
open("swapped.nrrd", "wb").write(written.replace(space + sizes, sizes + space))
version = vtkVersion.GetVTKVersion()
as_written, swapped = read("colour.nrrd"), read("swapped.nrrd")
for label, (size, components, error) in (("ITK's file", as_written), ("lines swapped", swapped)):
    print(f"VTK {version} reads {label + ':':15} {' x '.join(map(str, size))},",
          f"{components} components, error code {error}")
if (as_written, swapped) != (((16, 12, 1), 3, 0), ((16, 12, 6), 3, 0)):
    sys.exit("Changed: VTK does not lose the slices, or not in this way.")
print("As described: five of six slices are gone, and only the order of two lines decides.")
PYTHON
PYTHONPATH="$work/root/usr/lib/python3/dist-packages" /usr/bin/python3 read.py
