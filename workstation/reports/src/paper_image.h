#pragma once

#include <cairo.h>

#include <glm/glm.hpp>
#include <memory>

#include "ew/core/result.h"
#include "ew/reports/image_file.h"

namespace ew::reports {

/// A stored image for paper, without words that its file has about it. The samples of a JPEG go into the PDF as they are.
struct PaperImage {
  std::shared_ptr<cairo_surface_t> surface;
  glm::dvec2 size{0.0};  ///< pixels, > 0
};
/// @param name of its file, for the sentence @error badHeader (damaged, of no size, or of more than 64 million pixels)
[[nodiscard]] Result<PaperImage> paperImage(const ImageFile& file, const std::string& name);

}  // namespace ew::reports
