#include "case/case_images.h"

#include <QCoreApplication>
#include <QDialog>
#include <QGuiApplication>
#include <QIcon>
#include <QImageReader>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QVBoxLayout>

#include "ew/library/case.h"
#include "ew/widgets/flow_layout.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

constexpr int kSmall_px = 64;
constexpr double kShareOfScreen = 0.8;

QImage readWithin(const QString& file, const QSize& room) {
  QImageReader reader(file);
  const QSize size = reader.size();
  if (size.width() > room.width() || size.height() > room.height()) reader.setScaledSize(size.scaled(room, Qt::KeepAspectRatio));
  return reader.read();
}

void showLarge(QWidget* over, const QString& file, const QString& title) {
  auto* dialog = new QDialog(over->window());
  dialog->setObjectName(QStringLiteral("casePicture"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(title);
  auto* rows = new QVBoxLayout(dialog);
  rows->setContentsMargins(0, 0, 0, 0);
  auto* shown = new QLabel;
  shown->setAlignment(Qt::AlignCenter);
  shown->setPixmap(QPixmap::fromImage(readWithin(file, QGuiApplication::primaryScreen()->availableSize() * kShareOfScreen)));
  rows->addWidget(shown);
  dialog->show();
}

}  // namespace

QWidget* caseImages(const std::filesystem::path& folder, const std::vector<std::string>& files, const QString& title) {
  auto* row = new QWidget;
  auto* flow = new FlowLayout(8);
  row->setLayout(flow);
  for (const std::string& name : files) {
    const auto file = fileOfCase(folder, name, "previous_examinations");
    if (!file) continue;
    const QImage small = readWithin(wordsOf(*file), {kSmall_px, kSmall_px});
    if (small.isNull()) continue;
    auto* button = new QPushButton(QIcon(QPixmap::fromImage(small)), QString());
    button->setObjectName(QStringLiteral("caseInfoPicture"));
    button->setFlat(true);
    button->setIconSize(small.size());
    button->setFixedSize(small.size() + QSize(8, 8));
    button->setFocusPolicy(Qt::TabFocus);
    button->setToolTip(QCoreApplication::translate("ew::ui::CaseInfo", "Show this image large"));
    button->setAccessibleName(button->toolTip());
    QObject::connect(button, &QPushButton::clicked, row, [row, path = wordsOf(*file), title] { showLarge(row, path, title); });
    flow->addWidget(button);
  }
  return row;
}

}  // namespace ew::ui
