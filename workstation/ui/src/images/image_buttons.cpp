#include "images/image_buttons.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVariant>

#include "ew/widgets/look.h"
#include "images/image_grid.h"
#include "keys/key_tips.h"

namespace ew::ui {
namespace {

constexpr std::array<int, 3> kCounts = {1, 2, 4};

}  // namespace

ImageButtons::ImageButtons(ImageGrid& grid, QWidget* parent) : QWidget(parent), grid_(grid) {
  setObjectName(QStringLiteral("pictureButtons"));
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(0, 4, 0, 0);
  line->setSpacing(1);
  severalOnly_ = new QWidget;
  auto* several = new QHBoxLayout(severalOnly_);
  several->setContentsMargins(7, 0, 0, 0);
  several->setSpacing(3);
  const auto add = [](QHBoxLayout* to, const char* name, const QString& text, const QString& tip) {
    auto* button = new QPushButton(text);
    button->setObjectName(QLatin1String(name));
    button->setAccessibleName(tip);  // before the tip, which fills in both
    button->setToolTip(tip);
    button->setFocusPolicy(Qt::TabFocus);
    to->addWidget(button, 1);
    return button;
  };
  counts_ = {
      add(line, "onePicture", QStringLiteral("1"), tipWithKeys(tr("One image (%1: the next number of images)"), "pictures.count")),
      add(line, "twoPictures", QStringLiteral("2"),
          tipWithKeys(tr("Two images beside each other (%1: the next number of images)"), "pictures.count")),
      add(line, "fourPictures", QStringLiteral("4"), tipWithKeys(tr("Four images (%1: the next number of images)"), "pictures.count"))};
  for (std::size_t n = 0; n < counts_.size(); ++n) {
    counts_[n]->setCheckable(true);
    setLook(counts_[n], n == 0 ? Look::firstOf : n + 1 == counts_.size() ? Look::lastOf : Look::segment);
    connect(counts_[n], &QPushButton::clicked, this, [this, n] {
      grid_.setCount(kCounts[n]);
      showAll();  // a button checks itself, whatever came of it
    });
  }
  line->addWidget(severalOnly_, 2);
  next_ = add(several, "nextPicture", tr("L/R", "the next of several images"),
              tipWithKeys(tr("Next image: a running scan goes on in it, a frozen one is kept (%1)"), "pictures.next"));
  setLook(next_, Look::compact);
  connect(next_, &QPushButton::clicked, this, [this] { grid_.takeNext(); });
  scale_ = add(several, "sameScale", tr("1 : 1", "all images at the same scale"), tr("All images at the scale of the one that shows most"));
  setLook(scale_, Look::compact);
  scale_->setCheckable(true);
  connect(scale_, &QPushButton::clicked, this, [this](bool same) { grid_.setSameScale(same); });
  connect(&grid_, &ImageGrid::changed, this, &ImageButtons::showAll);
  showAll();
}

void ImageButtons::showAll() {
  for (std::size_t n = 0; n < counts_.size(); ++n) counts_[n]->setChecked(grid_.count() == kCounts[n]);
  severalOnly_->setVisible(grid_.count() > 1);
  scale_->setChecked(grid_.hasSameScale());
}

}  // namespace ew::ui
