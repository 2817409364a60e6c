#include "import/import_fields.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>

#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"

namespace ew::ui {
namespace {

constexpr int kValueWidth_px = 260;  // what is said of frames and memory, in a line or two

}  // namespace

QLabel* valueLabel(const char* name) {
  auto* label = new QLabel(QStringLiteral("–"));
  label->setObjectName(QLatin1String(name));
  label->setWordWrap(true);
  label->setMinimumWidth(scaled(kValueWidth_px));
  return label;
}

QLabel* smallText(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(QString::fromLatin1(name));
  label->setWordWrap(true);
  setLook(label, Look::small);
  return label;
}

QComboBox* narrowChoice() {
  auto* box = new QComboBox;
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(18);
  return box;
}

QDoubleSpinBox* numberBox(const char* name, double lowest, double highest, double step, int decimals, const QString& suffix) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(QLatin1String(name));
  box->setRange(lowest, highest);
  box->setSingleStep(step);
  box->setDecimals(decimals);
  box->setSuffix(suffix);
  return box;
}

QHBoxLayout* inOneRow(std::initializer_list<QWidget*> widgets) {
  auto* row = new QHBoxLayout;
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  for (QWidget* widget : widgets) row->addWidget(widget, dynamic_cast<QLineEdit*>(widget) != nullptr ? 1 : 0);
  return row;
}

QStringList filesIn(const QString& text) {
  QStringList files;
  for (const QString& one : text.split(QLatin1Char(';'), Qt::SkipEmptyParts))
    if (!one.trimmed().isEmpty()) files << one.trimmed();
  return files;
}

}  // namespace ew::ui
