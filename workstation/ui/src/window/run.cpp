#include "ew/ui/run.h"

#include <QVTKOpenGLNativeWidget.h>

#include <QApplication>
#include <QDialog>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTimer>
#include <iostream>

#include "body/view3d.h"
#include "ew/body/body_canvas.h"
#include "ew/core/printable.h"
#include "ew/core/version.h"
#include "ew/ui/main_window.h"
#include "ew/widgets/apply_theme.h"
#include "jobs/jobs.h"
#include "jobs/message_bar.h"
#include "scan/session.h"
#include "window/frame/safe_application.h"
#include "window/language.h"

namespace ew::ui {
namespace {

constexpr int kScreenshotPatience_s = 600;  // a case is prepared on its first start

/// Waits until nothing loads and everything is drawn, saves the image of the window, and ends the program.
class Screenshot final : public QObject {
 public:
  Screenshot(MainWindow& window, QString file) : window_(window), file_(std::move(file)) {
    waited_.start();
    connect(&poll_, &QTimer::timeout, this, &Screenshot::look);
    poll_.start(50);
  }

 private:
  void giveUp(const QString& why) {
    poll_.stop();
    std::cerr << "echoweave: " << printableLine(why.toStdString()) << std::endl;
    QApplication::exit(1);
  }

  void look() {
    // An error ends the wait only when nothing is left that could still be shown: a broken plugin does not stop an image.
    if (window_.messages().isError() && !window_.isSettled() && !window_.jobs().isRunning()) return giveUp(window_.messages().text());
    if (waited_.elapsed() > qint64{kScreenshotPatience_s} * 1000) {
      return giveUp(MainWindow::tr("The window was not ready within %1 s; try a smaller volume.").arg(kScreenshotPatience_s));
    }
    if (const auto* dialog = window_.findChild<QDialog*>(QStringLiteral("importDialog")); dialog != nullptr && dialog->isVisible()) {
      answer(*dialog);
      return;
    }
    settled_ = window_.isSettled() ? settled_ + 1 : 0;
    if (settled_ < 20) return;  // a second of rest: the timed figures of the status line are there as well
    poll_.stop();
    window_.view3d().renderNow();
    if (!BodyCanvas::finishAll(window_)) return giveUp(View3D::whyNoBody());
    QApplication::processEvents();
    if (!window_.grab().save(file_, "PNG")) {
      return giveUp(MainWindow::tr("The image cannot be written to '%1'; choose a folder you may write to.").arg(file_));
    }
    QApplication::exit(0);
  }

  /// Nobody is there to answer what a sweep leaves open: its own suggestions are taken, once it has been read.
  void answer(const QDialog& dialog) {
    auto* make = dialog.findChild<QPushButton*>(QStringLiteral("makeVolume"));
    if (make->isEnabled()) return make->click();
    if (!window_.jobs().isRunning()) giveUp(dialog.findChild<QLabel*>(QStringLiteral("importNotes"))->text());
  }

  MainWindow& window_;
  QString file_;
  QTimer poll_;
  QElapsedTimer waited_;
  int settled_ = 0;
};

/// Anybody's page can start a lesson here; only the learner knows whether they wanted it.
bool wantsLesson(const std::string& launchedBy) {
  rememberSystemTheme();
  applyTheme(themeCalled(QSettings().value(QStringLiteral("theme"), QStringLiteral("dark")).toString()));
  QMessageBox question(QMessageBox::Question, QStringLiteral("EchoWeave"),
                       MainWindow::tr("%1 wants to start a lesson here. It will be told when you have worked through it, and your result.")
                           .arg(QString::fromStdString(launchedBy)));
  question.setObjectName(QStringLiteral("launchQuestion"));
  question.setTextFormat(Qt::PlainText);
  QPushButton* begin = question.addButton(MainWindow::tr("Begin the lesson"), QMessageBox::AcceptRole);
  question.setDefaultButton(question.addButton(MainWindow::tr("Not now"), QMessageBox::RejectRole));
  question.exec();
  return question.clickedButton() == begin;
}

}  // namespace

int runWorkstation(int argc, char** argv, const WindowOptions& options) {
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  SafeApplication app(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("EchoWeave"));
  QApplication::setApplicationName(QStringLiteral("EchoWeave"));
  QApplication::setApplicationVersion(QLatin1String(kVersion));
  const auto spoken = speak(app);
  if (!options.launchedBy.empty()) return wantsLesson(options.launchedBy) ? 0 : 1;

  MainWindow window;
  const bool isScreenshot = !options.screenshot.empty();
  if (!options.theme.empty()) {
    const QVariant left = QSettings().value(QStringLiteral("theme"));
    window.setDarkTheme(options.theme != "light");
    // A theme given for once is not the choice to remember.
    if (left.isValid()) {
      QSettings().setValue(QStringLiteral("theme"), left);
    } else {
      QSettings().remove(QStringLiteral("theme"));
    }
  }
  const bool isSized = options.size_px.x > 0 && options.size_px.y > 0;
  if (isSized || isScreenshot) window.setWindowState(Qt::WindowNoState);
  if (isSized) {
    window.setMinimumSize(0, 0);
    window.resize(options.size_px.x, options.size_px.y);
  } else if (isScreenshot) {
    window.resize(1600, 900);
  }
  window.show();
  app.attempt([&] { window.openPlugins(); });
  app.attempt([&] {
    if (options.startPage) {
      window.showStartPage();
    } else if (!options.lesson.empty()) {
      window.openLesson(QString::fromStdString(options.open), QString::fromStdString(options.lesson));
    } else if (!options.open.empty()) {
      window.open(QString::fromStdString(options.open));
    } else if (isScreenshot) {
      window.openDefaultCase();  // the same image whatever was open before
    } else {
      window.openWhereOneWas();
    }
  });
  app.attempt([&] {
    if (!isScreenshot) {
      window.prepareCases();
      QTimer::singleShot(0, &window, [&window] {
        window.offerKeptEdits();
        window.offerUnsavedWork();
      });
      QTimer::singleShot(0, &window, &MainWindow::offerTour);
    }
    if (options.workspace == "author") window.setWorkspace(Workspace::author);
  });
  if (!isScreenshot) return QApplication::exec();
  const Screenshot screenshot(window, QString::fromStdString(options.screenshot));
  return QApplication::exec();
}

}  // namespace ew::ui
