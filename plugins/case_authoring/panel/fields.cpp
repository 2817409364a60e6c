#include "panel/fields.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>

#include "ew/widgets/fields.h"
#include "ew/widgets/theme.h"
#include "panel/images_field.h"

namespace ew::case_authoring {

QString sizeWords(std::uint64_t bytes) {
  std::uint64_t figure = bytes;
  while (figure >= 1024) figure /= 1024;
  return QLocale().formattedDataSize(static_cast<qint64>(bytes), figure < 10 && bytes >= 1024 ? 1 : 0);
}

ExaminationsField::ExaminationsField(Of what, QWidget* parent) : ListField(kGrid_px, parent), what_(what) {
  const bool isLaboratory = what_ == Of::laboratory;
  setObjectName(isLaboratory ? QStringLiteral("laboratory") : QStringLiteral("previous_examinations"));
  auto* add = new QPushButton(isLaboratory ? tr("Add laboratory values") : tr("Add an examination"));
  add->setObjectName(isLaboratory ? QStringLiteral("addLaboratory") : QStringLiteral("addExamination"));
  column().addWidget(add, 0, Qt::AlignLeft);
  connect(add, &QPushButton::clicked, this, [this] {
    replace([](std::vector<CaseExamination>& all) { all.emplace_back(); });
    const QString name = namePrefix(list().size() - 1) + QStringLiteral("when");
    if (auto* first = findChild<QLineEdit*>(name)) first->setFocus();
  });
}

void ExaminationsField::addRows(std::size_t number, QVBoxLayout& rows) {
  const CaseExamination& one = list()[number];
  const QString name = namePrefix(number);
  auto* head = new QHBoxLayout;
  head->setSpacing(kGrid_px);
  const auto line = [&](const char* key, std::string CaseExamination::*text, const QString& hint) {
    auto* edited = new WithHostUndo<QLineEdit>;
    edited->setObjectName(name + QLatin1String(key));
    edited->setPlaceholderText(hint);
    edited->setAccessibleName(hint);
    edited->setText(words(one.*text));
    connect(edited, &QLineEdit::textEdited, this, [this, number, text](const QString& typed) { editText(number, text, typed); });
    head->addWidget(edited, 1);
  };
  line("when", &CaseExamination::when, tr("when"));
  if (what_ == Of::examinations) line("kind", &CaseExamination::kind, tr("kind"));
  auto* away = new QPushButton(tr("Remove"));
  away->setObjectName(name + QStringLiteral("remove"));
  connect(away, &QPushButton::clicked, this, [this, number] { remove(number); });
  head->addWidget(away);
  rows.addLayout(head);
  auto* findings = new QPlainTextEdit;
  findings->setObjectName(name + QStringLiteral("findings"));
  findings->setPlaceholderText(tr("what it said"));
  findings->setAccessibleName(tr("what it said"));
  findings->setTabChangesFocus(true);
  findings->setUndoRedoEnabled(false);  // undo is the host's, for the whole case
  findings->setFixedHeight(8 * kGrid_px);
  findings->setPlainText(words(one.findings));
  connect(findings, &QPlainTextEdit::textChanged, this,
          [this, number, findings] { editText(number, &CaseExamination::findings, findings->toPlainText()); });
  rows.addWidget(findings);
  if (what_ == Of::examinations) addImagesOf(number, rows);
}

void ExaminationsField::addImagesOf(std::size_t number, QVBoxLayout& rows) {
  auto* shown = new ImagesField(namePrefix(number), folder_, list()[number].images);
  shown->onAdd = [this, number] {
    if (onImagesAsked) onImagesAsked(number);
  };
  shown->onRemove = [this, number](std::size_t image) {
    replace([=](std::vector<CaseExamination>& all) {
      auto& images = all[number].images;
      images.erase(images.begin() + static_cast<std::ptrdiff_t>(image));
    });
  };
  rows.addWidget(shown);
}

void ExaminationsField::setFolder(const std::filesystem::path& folder) {
  if (folder == folder_) return;
  folder_ = folder;
  remake();
}

void ExaminationsField::addImages(std::size_t number, const std::vector<std::string>& files) {
  if (number >= list().size() || files.empty()) return;
  replace([&](std::vector<CaseExamination>& all) {
    auto& images = all[number].images;
    for (const std::string& file : files)
      if (std::find(images.begin(), images.end(), file) == images.end()) images.push_back(file);
  });
}

QString ExaminationsField::namePrefix(std::size_t number) const {
  return (what_ == Of::laboratory ? QStringLiteral("laboratory_%1_") : QStringLiteral("examination_%1_")).arg(number);
}

void ExaminationsField::editText(std::size_t number, std::string CaseExamination::*text, const QString& typed) {
  edit(number, [&](CaseExamination& edited) { edited.*text = typed.toStdString(); });
}

}  // namespace ew::case_authoring
