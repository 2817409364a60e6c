#include "ew/io/volume_series.h"

#include "files/image_header.h"
#include "files/volume_extent.h"

namespace ew {
using namespace detail;

Result<VolumeSeries> readVolumeSeries(const std::filesystem::path& file) {
  const auto header = readImageHeader(file);
  if (!header) return passOn(header.error());
  std::vector<Message> ignored;
  const auto extent = volumeExtentOf(*header, ignored);
  if (!extent) return passOn(extent.error());
  return VolumeSeries{extent->volumes, extent->grid, header->hasGeometry && header->spacingProblem.empty(), header->spacingProblem};
}

}  // namespace ew
