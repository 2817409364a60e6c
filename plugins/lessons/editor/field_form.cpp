#include "editor/field_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFontMetrics>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ew/widgets/fields.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::lessons {

namespace {

void tell(QLabel* problem, const Result<void>& done) { setProblem(problem, done ? QString() : words(done.error())); }

}  // namespace

FieldForm::FieldForm(QWidget* parent) : QWidget(parent) {
  rows_ = new QFormLayout(this);
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(kGrid_px);
  rows_->setRowWrapPolicy(QFormLayout::WrapLongRows);
  rows_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

void FieldForm::showValues() {
  for (const auto& each : shows_) each();
  for (QLabel* each : problems_) setProblem(each, {});
}

void FieldForm::addHeading(const QString& text) { rows_->addRow(headingLabel(text)); }

QLabel* FieldForm::addRemark(const QString& text) {
  auto* remark = quietLabel(text);
  rows_->addRow(remark);
  return remark;
}

void FieldForm::addWidget(QWidget* widget) { rows_->addRow(widget); }

QLabel* FieldForm::addRow(const QString& label, QWidget* editor) {
  auto* cell = new QWidget;
  auto* column = new QVBoxLayout(cell);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px / 2);
  column->addWidget(editor);
  auto* problem = problemLabel();
  problem->setObjectName(editor->objectName() + QStringLiteral("_problem"));
  column->addWidget(problem);
  problems_.push_back(problem);
  if (label.isEmpty()) {
    rows_->addRow(cell);
    return problem;
  }
  auto* name = quietLabel(label);
  name->setWordWrap(false);
  name->setMinimumWidth(9 * kGrid_px);
  name->setBuddy(editor);
  rows_->addRow(name, cell);
  editor->setAccessibleName(label);
  return problem;
}

void FieldForm::addLine(const char* name, const QString& label, const TextAccess& access) {
  auto* line = new WithHostUndo<QLineEdit>;
  line->setObjectName(QLatin1String(name));
  QLabel* problem = addRow(label, line);
  QObject::connect(line, &QLineEdit::textEdited, line, [set = access.set, problem](const QString& text) { tell(problem, set(text)); });
  add([line, get = access.get] {
    const QString now = get();
    if (line->text() == now) return;
    line->setText(now);
    line->setCursorPosition(0);  // a long text shows its beginning
  });
}

void FieldForm::addText(const char* name, const QString& label, const TextAccess& access, int lines, const QString& placeholder) {
  auto* text = new QPlainTextEdit;
  text->setObjectName(QLatin1String(name));
  text->setTabChangesFocus(true);
  text->setUndoRedoEnabled(false);  // undo is the host's, for the whole case
  text->setPlaceholderText(placeholder);
  text->setFixedHeight(lines * QFontMetrics(text->font()).lineSpacing() + 2 * kGrid_px);
  QLabel* problem = addRow(label, text);
  QObject::connect(text, &QPlainTextEdit::textChanged, text,
                   [text, set = access.set, problem] { tell(problem, set(text->toPlainText())); });
  add([text, get = access.get] {
    const QString now = get();
    if (text->toPlainText() == now) return;
    const QSignalBlocker quiet(text);
    text->setPlainText(now);
  });
}

void FieldForm::addFlag(const char* name, const QString& label, const Access<bool>& access, const QString& tip) {
  auto* box = new QCheckBox(label);
  box->setObjectName(QLatin1String(name));
  box->setToolTip(tip);
  QLabel* problem = addRow({}, box);
  QObject::connect(box, &QCheckBox::toggled, box, [set = access.set, problem](bool on) { tell(problem, set(on)); });
  add([box, get = access.get] {
    const QSignalBlocker quiet(box);
    box->setChecked(get());
  });
}

void FieldForm::addNumber(const char* name, const QString& label, const NumberRange& range, const Access<std::optional<double>>& access) {
  const bool mayBeNone = !range.noneText.isEmpty();
  const double lowest = mayBeNone ? range.lowest - range.step : range.lowest;
  auto* field = new NumberField(lowest, range.highest, range.decimals, range.unit);
  field->setObjectName(QLatin1String(name));
  field->setSingleStep(range.step);
  if (mayBeNone) field->setSpecialValueText(range.noneText);
  QLabel* problem = addRow(label, field);
  const auto valueOf = [mayBeNone, lowest](double shown) { return mayBeNone && shown <= lowest ? std::nullopt : std::optional(shown); };
  QObject::connect(field, QOverload<double>::of(&QDoubleSpinBox::valueChanged), field,
                   [set = access.set, problem, valueOf, least = range.lowest](double shown) {
                     const auto value = valueOf(shown);
                     tell(problem, set(value ? std::optional(std::max(least, *value)) : value));
                   });
  add([field, get = access.get, lowest] {
    const QSignalBlocker quiet(field);
    field->setValue(get().value_or(lowest));
  });
}

void FieldForm::addChoice(const char* name, const QString& label, std::function<Options()> options, const Access<std::string>& access) {
  auto* choice = new WheelWithFocus<QComboBox>;
  choice->setObjectName(QLatin1String(name));
  choice->setFocusPolicy(Qt::StrongFocus);
  choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);  // a long name must not widen the column
  choice->setMinimumContentsLength(8);
  QLabel* problem = addRow(label, choice);
  QObject::connect(choice, QOverload<int>::of(&QComboBox::activated), choice,
                   [choice, set = access.set, problem](int) { tell(problem, set(choice->currentData().toString().toStdString())); });
  add([choice, options = std::move(options), get = access.get] {
    const QSignalBlocker quiet(choice);
    choice->clear();
    for (const auto& [value, shown] : options()) choice->addItem(shown, words(value));
    const QString now = words(get());
    if (choice->findData(now) < 0 && !now.isEmpty())
      choice->addItem(QCoreApplication::translate("ew::lessons::FieldForm", "%1 (not there any more)").arg(now), now);
    choice->setCurrentIndex(choice->findData(now));
    choice->setToolTip(choice->currentText());
  });
}

}  // namespace ew::lessons
