#include "ew/paper/pdf_file.h"

#include <cairo-pdf.h>

#include <array>
#include <cstdio>

#include "ew/paper/paper_size.h"

namespace ew {
namespace {

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

PdfFile::PdfFile(const glm::dvec2& size_mm, const PdfAbout& about)
    : surface_(cairo_pdf_surface_create_for_stream(append, bytes_.get(), kPointsPerMm * size_mm.x, kPointsPerMm * size_mm.y)),
      pen_(cairo_create(surface_.get())) {
  if (!about.title.empty()) cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_TITLE, about.title.c_str());
  cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_CREATOR, "EchoWeave");
  // Without a word of ours cairo would write the time of the clock.
  cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_CREATE_DATE, about.made.empty() ? nullptr : about.made.c_str());
}

void PdfFile::setPageSize(const glm::dvec2& size_mm) {
  cairo_pdf_surface_set_size(surface_.get(), kPointsPerMm * size_mm.x, kPointsPerMm * size_mm.y);
}

void PdfFile::endPage() { cairo_show_page(pen_.get()); }

int PdfFile::addOutline(int parent, const std::string& text, int page, double y_pt) {
  std::array<char, 64> place{};
  std::snprintf(place.data(), place.size(), "page=%d pos=[0 %d]", page, static_cast<int>(y_pt));
  return cairo_pdf_surface_add_outline(surface_.get(), parent, text.c_str(), place.data(), CAIRO_PDF_OUTLINE_FLAG_OPEN);
}

Result<std::string> PdfFile::finish() {
  cairo_surface_finish(surface_.get());
  for (const cairo_status_t status : {cairo_status(pen_.get()), cairo_surface_status(surface_.get())})
    if (status != CAIRO_STATUS_SUCCESS && status != CAIRO_STATUS_SURFACE_FINISHED)
      return failure(ErrorCode::internal,
                     say<"The PDF could not be drawn (%1); please report it.">(verbatim(cairo_status_to_string(status))));
  return std::move(*bytes_);
}

}  // namespace ew
