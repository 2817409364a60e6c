#include "ew/paper/paper_pages.h"

#include <pango/pangocairo.h>

#include <algorithm>

#include "ew/core/printable.h"

namespace ew {
namespace {

constexpr const char* kFamilies = "Inter, DejaVu Sans, sans-serif";
constexpr double kLineSpacing = 1.32, kBaseLine = 0.36;  // of a font's size; how far the base line is below the middle
constexpr double kLeft_mm = 16.0, kTop_mm = 12.0, kBottom_mm = 10.0;
constexpr double kHeadRoom_mm = 10.0, kFootRoom_mm = 9.0, kHeadRule_mm = 5.5;
constexpr double kRule_mm = 0.2;
constexpr PaperFont kEdgeFont{8.0};
constexpr Rgb kEdgeInk(0x4d, 0x56, 0x5f), kRuleInk(0xc9, 0xcf, 0xd6);

void release(void* object) { g_object_unref(object); }

void drawRule(cairo_t* pen, double y, double width) {
  setInk(pen, kRuleInk);
  cairo_set_line_width(pen, PaperPages::mm(kRule_mm));
  cairo_move_to(pen, 0.0, y);
  cairo_line_to(pen, width, y);
  cairo_stroke(pen);
}

/// Where a line's letters begin in its box.
glm::dvec2 beginOf(const PaperText& text, int line, const PaperFont& font, const glm::dvec2& at, double width, PaperPages::Side side) {
  const double shift = side == PaperPages::Side::right ? width - text.widthOf(line) : 0.0;
  return {at.x + shift, at.y + 0.5 * lineHeight(font) + kBaseLine * font.size_pt};
}

}  // namespace

double lineHeight(const PaperFont& font) { return kLineSpacing * font.size_pt; }

void setInk(cairo_t* pen, const Rgb& ink) { cairo_set_source_rgb(pen, ink.r / 255.0, ink.g / 255.0, ink.b / 255.0); }

struct PaperText::Layout {
  explicit Layout(PangoLayout* inPango) : pango(inPango) {}
  Layout(const Layout&) = delete;
  Layout& operator=(const Layout&) = delete;
  ~Layout() { release(pango); }
  PangoLayout* pango;
};

int PaperText::lines() const { return pango_layout_get_line_count(layout_->pango); }

double PaperText::width() const {
  double widest = 0.0;
  for (int line = 0; line < lines(); ++line) widest = std::max(widest, widthOf(line));
  return widest;
}

double PaperText::widthOf(int line) const {
  PangoRectangle box{};
  pango_layout_line_get_extents(pango_layout_get_line_readonly(layout_->pango, line), nullptr, &box);
  return static_cast<double>(box.width) / PANGO_SCALE;
}

void PaperText::show(cairo_t* pen, int line, const glm::dvec2& at) const {
  cairo_move_to(pen, at.x, at.y);
  pango_cairo_show_layout_line(pen, pango_layout_get_line_readonly(layout_->pango, line));
}

/// Fonts of one paper: a map of its own, because those that Pango shares belong to a thread.
struct PaperPages::Letters {
  explicit Letters(std::string_view language) : map(pango_cairo_font_map_new()), context(pango_font_map_create_context(map)) {
    // Letters keep their places at every size: what is measured here is what is printed.
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(context, options);
    cairo_font_options_destroy(options);
    pango_context_set_round_glyph_positions(context, FALSE);
    pango_context_set_language(context, pango_language_from_string(std::string(language).c_str()));
    for (PangoAttrList* each : {attributes, withEvenFigures})
      pango_attr_list_insert(each, pango_attr_insert_hyphens_new(FALSE));  // a broken name or key has no letter more
    pango_attr_list_insert(withEvenFigures, pango_attr_font_features_new("tnum=1"));
  }
  Letters(const Letters&) = delete;
  Letters& operator=(const Letters&) = delete;
  ~Letters() {
    pango_attr_list_unref(withEvenFigures);
    pango_attr_list_unref(attributes);
    release(context);
    release(map);
  }

  [[nodiscard]] PangoLayout* laidOut(const std::string& text, const PaperFont& font) const {
    PangoLayout* layout = pango_layout_new(context);
    PangoFontDescription* description = descriptionOf(font);
    pango_layout_set_font_description(layout, description);
    pango_font_description_free(description);
    pango_layout_set_attributes(layout, font.hasEvenFigures ? withEvenFigures : attributes);
    const std::string clean = printable(text);
    pango_layout_set_text(layout, clean.c_str(), static_cast<int>(clean.size()));
    return layout;
  }
  [[nodiscard]] static PangoFontDescription* descriptionOf(const PaperFont& font) {
    PangoFontDescription* description = pango_font_description_from_string(kFamilies);
    pango_font_description_set_absolute_size(description, font.size_pt * PANGO_SCALE);
    pango_font_description_set_weight(description, font.isBold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
    return description;
  }
  [[nodiscard]] bool exist() const {
    PangoFontDescription* description = descriptionOf({});
    PangoFont* font = pango_context_load_font(context, description);
    pango_font_description_free(description);
    if (font == nullptr) return false;
    release(font);
    return true;
  }

  PangoFontMap* map;
  PangoContext* context;
  PangoAttrList* attributes = pango_attr_list_new();
  PangoAttrList* withEvenFigures = pango_attr_list_new();
};

Result<PaperPages> PaperPages::begin(PaperSize paper, PaperEdges edges, std::string_view language) {
  auto letters = std::make_unique<Letters>(language);
  if (!letters->exist())
    return failure(ErrorCode::unsupported,
                   say<"There is no font on this computer, so nothing can be printed; install one, fonts-dejavu-core for instance.">());
  return PaperPages(paper, std::move(edges), std::move(letters));
}

PaperPages::PaperPages(PaperSize paper, PaperEdges edges, std::unique_ptr<Letters> letters)
    : paper_(paper), edges_(std::move(edges)), letters_(std::move(letters)) {
  const glm::dvec2 size_mm = sizeOf(paper);
  width_ = mm(size_mm.x - 2.0 * kLeft_mm);
  top_ = y_ = mm(kHeadRoom_mm);
  bottom_ = mm(size_mm.y - kTop_mm - kBottom_mm - kFootRoom_mm);
}

PaperPages::PaperPages(PaperPages&&) noexcept = default;
PaperPages::~PaperPages() = default;

void PaperPages::makeRoom(double height) {
  if (height > roomLeft() && !isFresh()) nextPage();
}

void PaperPages::nextPage() {
  pages_.emplace_back();
  y_ = top_;
}

PaperText PaperPages::text(const std::string& text, const PaperFont& font, double width) const {
  PangoLayout* layout = letters_->laidOut(text, font);
  pango_layout_set_width(layout, std::max(1, static_cast<int>(width * PANGO_SCALE)));
  pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
  return PaperText(std::make_shared<const PaperText::Layout>(layout));
}

PaperText PaperPages::text(const std::string& text, const PaperFont& font) const {
  return PaperText(std::make_shared<const PaperText::Layout>(letters_->laidOut(text, font)));
}

void PaperPages::line(const PaperText& text, int line, const PaperFont& font, const Rgb& ink, const glm::dvec2& at, double width,
                      Side side) {
  draw([text, line, ink, begin = beginOf(text, line, font, at, width, side)](cairo_t* pen) {
    setInk(pen, ink);
    text.show(pen, line, begin);
  });
}

void PaperPages::rule(double y) {
  draw([y, width = width_](cairo_t* pen) { drawRule(pen, y, width); });
}

void PaperPages::draw(std::function<void(cairo_t*)> drawing) { pages_.back().push_back(std::move(drawing)); }

void PaperPages::heading(int level, const std::string& text) { entries_.push_back({level, pages(), y_, printableLine(text)}); }

std::vector<PaperPages::Drawing> PaperPages::edgesOf(int page) const {
  std::vector<Drawing> drawn;
  const auto put = [&](PangoLayout* layout, double y, double width, Side side) {
    const PaperText text(std::make_shared<const PaperText::Layout>(layout));
    drawn.emplace_back([text, begin = beginOf(text, 0, kEdgeFont, {0.0, y}, width, side)](cairo_t* pen) {
      setInk(pen, kEdgeInk);
      text.show(pen, 0, begin);
    });
    return text.widthOf(0);
  };
  const auto cut = [&](const std::string& text, double width) {
    PangoLayout* layout = letters_->laidOut(printableLine(text), kEdgeFont);
    pango_layout_set_width(layout, std::max(1, static_cast<int>(width * PANGO_SCALE)));
    pango_layout_set_ellipsize(layout, PANGO_ELLIPSIZE_END);
    return layout;
  };
  const std::string number = edges_.number ? edges_.number(page, pages()) : std::string();
  const double taken = put(letters_->laidOut(number, kEdgeFont), 0.0, width_, Side::right);
  put(cut(edges_.title, width_ - taken - mm(6.0)), 0.0, width_, Side::left);
  put(cut(edges_.foot, width_), bottom_ + mm(4.0), width_, Side::left);
  drawn.emplace_back([width = width_](cairo_t* pen) { drawRule(pen, mm(kHeadRule_mm), width); });
  return drawn;
}

void PaperPages::addOutline(PdfFile& pdf) const {
  std::vector<std::pair<int, int>> above;  // levels and numbers of the entries that the next one may stand below
  for (const Entry& entry : entries_) {
    while (!above.empty() && above.back().first >= entry.level) above.pop_back();
    const int number = pdf.addOutline(above.empty() ? 0 : above.back().second, entry.text, entry.page, mm(kTop_mm) + entry.y);
    above.emplace_back(entry.level, number);
  }
}

Result<std::string> PaperPages::pdf(const PdfAbout& about) const {
  PdfFile file(sizeOf(paper_), {printableLine(about.title), about.made});
  cairo_t* pen = file.pen();
  for (int page = 1; page <= pages(); ++page) {
    std::vector<Drawing> drawings = edgesOf(page);
    const auto& content = pages_[static_cast<std::size_t>(page) - 1];
    drawings.insert(drawings.end(), content.begin(), content.end());
    for (const Drawing& drawing : drawings) {
      cairo_save(pen);
      cairo_translate(pen, mm(kLeft_mm), mm(kTop_mm));
      drawing(pen);
      cairo_restore(pen);
    }
    file.endPage();
  }
  addOutline(file);
  return file.finish();
}

}  // namespace ew
