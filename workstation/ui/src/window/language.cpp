#include "window/language.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <algorithm>
#include <cstring>

/// The translations are wanted before the first window; outside of any namespace, as the macro demands.
static void initTranslations() { Q_INIT_RESOURCE(translations); }

namespace ew::ui {
namespace {

constexpr QChar kReadFromTheRight(0x200f), kEmbedded(0x202b), kEndOfEmbedding(0x202c);  // U+200F decides where a paragraph begins

/// Keeps the translator and has the program speak it, when it holds any words.
void speakIt(QApplication& app, std::vector<std::unique_ptr<QTranslator>>& spoken, std::unique_ptr<QTranslator> words, bool isLoaded) {
  if (!isLoaded) return;
  app.installTranslator(words.get());
  spoken.push_back(std::move(words));
}

}  // namespace

QString pseudoWords(const QString& source) {
  if (source.trimmed().isEmpty()) return source;
  const QString longer(std::max(1, source.size() / 3), QLatin1Char('~'));
  return QString(kReadFromTheRight) + kEmbedded + QLatin1Char('[') + source + QLatin1Char(' ') + longer + QLatin1Char(']') +
         kEndOfEmbedding;
}

QString PseudoTranslator::translate(const char* context, const char* source, const char*, int n) const {
  if (source == nullptr) return {};
  if (std::strcmp(source, "QT_LAYOUT_DIRECTION") == 0) return QStringLiteral("RTL");
  if (context != nullptr && std::strcmp(context, "QShortcut") == 0) return {};
  return pseudoWords(QString::fromUtf8(source).replace(QStringLiteral("%n"), QString::number(n)));
}

std::vector<std::unique_ptr<QTranslator>> speak(QApplication& app) {
  initTranslations();
  std::vector<std::unique_ptr<QTranslator>> spoken;
  const QString once = qEnvironmentVariable("ECHOWEAVE_LANGUAGE");
  const QString chosen = once.isEmpty() ? QSettings().value(QStringLiteral("language")).toString() : once;
  if (chosen == kPseudoLanguage) {
    QLocale::setDefault(QLocale::c());
    speakIt(app, spoken, std::make_unique<PseudoTranslator>(), true);
    QApplication::setLayoutDirection(Qt::RightToLeft);
    return spoken;
  }
  const QLocale locale = chosen.isEmpty() ? QLocale::system() : QLocale(chosen);
  QLocale::setDefault(locale);  // so that 3.5 is written as the words around it are
  auto ours = std::make_unique<QTranslator>(), qts = std::make_unique<QTranslator>();
  // Without words of its own a language reads English, which has a catalogue for what goes with a number.
  const bool hasOurs = ours->load(locale, QStringLiteral("echoweave"), QStringLiteral("_"), QStringLiteral(":/ew/translations")) ||
                       ours->load(QStringLiteral(":/ew/translations/echoweave_en.qm"));
  const bool hasQts =
      qts->load(locale, QStringLiteral("qtbase"), QStringLiteral("_"), QLibraryInfo::location(QLibraryInfo::TranslationsPath));
  speakIt(app, spoken, std::move(ours), hasOurs);
  speakIt(app, spoken, std::move(qts), hasQts);
  return spoken;
}

}  // namespace ew::ui
