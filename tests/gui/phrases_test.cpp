// What the libraries say is said in the window's language: every sentence of an error that the stitching panel can meet, and every step
// that a job's card can name, is registered with the translator, and the German window has words for it.
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>
#include <QTranslator>
#include <set>
#include <string>
#include <vector>

#include "panel/phrases.h"

/// Outside of any namespace, as the macro demands.
static void initTranslations() { Q_INIT_RESOURCE(translations); }

namespace ew::stitching {
namespace {

QString textOf(const QString& file) {
  QFile opened(file);
  return opened.open(QIODevice::ReadOnly) ? QString::fromUtf8(opened.readAll()) : QString();
}

/// The arguments of every call of `name`: split at commas that stand in no bracket and no string.
std::vector<QStringList> callsOf(const QString& source, const QString& name) {
  std::vector<QStringList> calls;
  for (int at = source.indexOf(name + QLatin1Char('(')); at >= 0; at = source.indexOf(name + QLatin1Char('('), at + 1)) {
    QStringList arguments{QString()};
    int depth = 0;
    bool inString = false;
    for (int n = at + name.size(); n < source.size(); ++n) {
      const QChar c = source[n];
      if (inString) {
        arguments.last() += c;
        if (c == QLatin1Char('\\'))
          arguments.last() += source[++n];
        else if (c == QLatin1Char('"'))
          inString = false;
        continue;
      }
      if (c == QLatin1Char('"')) inString = true;
      const bool closes = c == QLatin1Char(')') || c == QLatin1Char('}');
      if (closes && --depth == 0) break;
      if (c == QLatin1Char(',') && depth == 1)
        arguments << QString();
      else if (depth > 0)
        arguments.last() += c;
      if (c == QLatin1Char('(') || c == QLatin1Char('{')) ++depth;
    }
    calls.push_back(arguments);
  }
  return calls;
}

/// The sentence that an expression makes, with a number wherever it puts something in. Empty: it makes none by itself.
std::string sampleOf(QString expression) {
  static const QRegularExpression wrapped(QStringLiteral("std::string\\((\"(?:[^\"\\\\]|\\\\.)*\")\\)"));
  expression.replace(wrapped, QStringLiteral("\\1"));
  QString said;
  int depth = 0;
  bool any = false, counted = false;
  for (int n = 0; n < expression.size(); ++n) {
    const QChar c = expression[n];
    if (c == QLatin1Char('(')) ++depth;
    if (c == QLatin1Char(')')) --depth;
    if (depth == 0 && c == QLatin1Char('"')) {
      any = true;
      counted = false;
      for (++n; expression[n] != QLatin1Char('"'); ++n) {
        if (expression[n] == QLatin1Char('\\')) ++n;
        said += expression[n];
      }
    } else if (!c.isSpace() && c != QLatin1Char('+') && !counted) {
      said += QLatin1Char('7');
      counted = true;
    }
  }
  return any ? said.toStdString() : std::string();
}

QStringList sourcesIn(const QString& folder) {
  QStringList files;
  for (QDirIterator at(QStringLiteral(EW_SOURCE_DIR "/") + folder, {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                       QDirIterator::Subdirectories);
       at.hasNext();)
    files << at.next();
  return files;
}

std::set<QString> placesIn(const QString& text) {
  static const QRegularExpression place(QStringLiteral("%[1-9]"));
  std::set<QString> found;
  for (auto at = place.globalMatch(text); at.hasNext();) found.insert(at.next().captured());
  return found;
}

class PhrasesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everySentenceOfTheLibrariesIsRegistered() {
    QStringList files = sourcesIn(QStringLiteral("plugins/stitching/logic")) + sourcesIn(QStringLiteral("workstation/stitching/src")) +
                        sourcesIn(QStringLiteral("workstation/registration/src"));
    files << QStringLiteral("workstation/io/src/content_key.cpp") << QStringLiteral("workstation/io/src/step_store.cpp");
    int found = 0;
    QStringList missing;
    for (const QString& file : files) {
      // The panel never calls the two-dimensional methods; usage is the command line's.
      if (file.contains(QLatin1String("elastic2d")) || file.contains(QLatin1String("tangent_slices")) ||
          file.endsWith(QLatin1String("command.cpp")))
        continue;
      for (const QStringList& call : callsOf(textOf(file), QStringLiteral("failure"))) {
        if (call.size() < 2 || call[0].contains(QLatin1String("cancelled"))) continue;  // nobody is told what he asked for
        const std::string sample = sampleOf(call[1]);
        if (sample.empty()) continue;
        ++found;
        if (!isPhrase(sample)) missing << file + QStringLiteral(": ") + QString::fromStdString(sample);
      }
    }
    // What is said about whom, before what a library said.
    static const QRegularExpression before(QStringLiteral("sentence = ([^;]*)\\+ problem\\.sentence;"));
    int about = 0;
    for (const QString& file : files) {
      const QString source = textOf(file);
      for (auto at = before.globalMatch(source); at.hasNext(); ++about) {
        const std::string sample = sampleOf(at.next().captured(1)) + "7";
        if (!isPhrase(sample)) missing << file + QStringLiteral(": ") + QString::fromStdString(sample);
      }
    }
    QVERIFY2(missing.isEmpty(), qPrintable(missing.join(QLatin1Char('\n'))));
    QVERIFY2(about > 3, qPrintable(QString::number(about)));
    QVERIFY2(found > 50, qPrintable(QString::number(found)));  // else the sources were not understood
  }

  void everyStepIsRegistered() {
    int found = 0;
    QStringList missing;
    for (const char* folder : {"plugins/stitching", "workstation/stitching/src", "workstation/registration/src"})
      for (const QString& file : sourcesIn(QLatin1String(folder))) {
        const QString source = textOf(file);
        std::vector<QString> steps;
        for (const QStringList& call : callsOf(source, QStringLiteral(".report"))) steps.push_back(call[0]);
        for (const QStringList& call : callsOf(source, QStringLiteral("forEachTask")))
          if (call.size() > 3) steps.push_back(call[3]);
        for (const QString& step : steps) {
          const std::string sample = sampleOf(step);
          if (sample.empty()) continue;
          ++found;
          if (!isPhrase(sample)) missing << file + QStringLiteral(": ") + QString::fromStdString(sample);
        }
      }
    QVERIFY2(missing.isEmpty(), qPrintable(missing.join(QLatin1Char('\n'))));
    QVERIFY2(found > 20, qPrintable(QString::number(found)));
  }

  void theGermanWindowHasWordsForEachAndKeepsWhatStandsInThem() {
    initTranslations();
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/ew/translations/echoweave_de.qm")));
    for (const QString& phrase : phrases()) {
      const QString words = german.translate("ew::stitching::Phrases", phrase.toUtf8());
      QVERIFY2(!words.isEmpty(), qPrintable(phrase));
      QVERIFY2(placesIn(words) == placesIn(phrase), qPrintable(words));
    }
    QCOMPARE(phraseOf("Registering right %1 lateral and midline"), QStringLiteral("Registering right %1 lateral and midline"));
    QCoreApplication::installTranslator(&german);
    // Names are kept, also such that look like a place to put something in.
    QCOMPARE(phraseOf("Registering right %1 lateral and midline"), QStringLiteral("right %1 lateral und midline werden zugeordnet"));
    // A sentence in a sentence, and a word in one.
    QCOMPARE(phraseOf("Volume 'a' cannot be stitched. The volume's origin is not finite; check the file's offset."),
             QStringLiteral(
                 "Das Volumen „a“ kann nicht verbunden werden. Der Ursprung des Volumens ist nicht endlich; prüfen Sie den Versatz in "
                 "der Datei."));
    QCOMPARE(phraseOf("The confidence of the moving volume has values outside 0 to 1."),
             QStringLiteral("Die Verlässlichkeit des bewegten Volumens hat Werte außerhalb von 0 bis 1."));
    QCOMPARE(phraseOf("Nobody registered this."), QStringLiteral("Nobody registered this."));
    QCoreApplication::removeTranslator(&german);
  }
};

}  // namespace
}  // namespace ew::stitching

QTEST_GUILESS_MAIN(ew::stitching::PhrasesTest)
#include "phrases_test.moc"
