// Whatever a library tells a person has German words: every text of a message that any library or plugin of this program can make is
// walked, put into German with arguments at its places, and compared.
#include <QCoreApplication>
#include <QLocale>
#include <QTest>
#include <QTranslator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "ew/core/message.h"
#include "ew/library/schema.h"
#include "ew/widgets/words.h"

/// Outside of any namespace, as the macro demands.
static void initTranslations() { Q_INIT_RESOURCE(translations); }

namespace ew {
namespace {

/// Names and numbers alone are the same in both languages.
bool hasWords(const std::string& text) {
  int letters = 0;
  for (std::size_t n = 0; n < text.size(); ++n) {
    letters = std::isalpha(static_cast<unsigned char>(text[n])) != 0 ? letters + 1 : 0;
    if (letters > 3) return true;
  }
  return false;
}

std::set<char> placesIn(const std::string& text) {
  std::set<char> places;
  for (std::size_t n = 0; n + 1 < text.size(); ++n)
    if (text[n] == '%' && text[n + 1] >= '1' && text[n + 1] <= '9') places.insert(text[n + 1]);
  return places;
}

class GermanTest : public QObject {
  Q_OBJECT

  QTranslator german_;

 private Q_SLOTS:
  void initTestCase() {
    initTranslations();
    QVERIFY(german_.load(QStringLiteral(":/ew/translations/echoweave_de.qm")));
    QVERIFY(QCoreApplication::installTranslator(&german_));
  }

  void everyTextOfAMessageHasItsGermanWithTheSamePlaces() {
    for (const SchemaName schema : {SchemaName::caseManifest, SchemaName::pluginManifest})  // enters what they say of their fields
      QVERIFY(!schemaProblems(nlohmann::json::object(), schema, verbatim("x.json")).empty());
    std::set<std::string> texts;
    for (const MessageText* said = firstMessageText(); said != nullptr; said = said->next) texts.insert(said->text);
    QVERIFY2(texts.size() > 1200, qPrintable(QString::number(texts.size())));  // else libraries were not linked as a whole
    QStringList missing, otherPlaces, blanks;
    for (const std::string& text : texts) {
      const QString translated = german_.translate(kMessageContext, text.c_str());
      if (translated.isEmpty()) {
        if (hasWords(text)) missing << QString::fromStdString(text);
        continue;
      }
      if (placesIn(text) != placesIn(translated.toStdString())) otherPlaces << QString::fromStdString(text);
      if (text.ends_with('.') != translated.endsWith(QLatin1Char('.'))) blanks << QString::fromStdString(text);
    }
    QVERIFY2(missing.isEmpty(), qPrintable(QString::number(missing.size()) + QLatin1Char('\n') + missing.join(QLatin1Char('\n'))));
    QVERIFY2(otherPlaces.isEmpty(), qPrintable(otherPlaces.join(QLatin1Char('\n'))));
    QVERIFY2(blanks.isEmpty(), qPrintable(blanks.join(QLatin1Char('\n'))));
  }

  void decimalsHaveTheirComma() {
    const QLocale before;
    QLocale::setDefault(QLocale(QStringLiteral("de_DE")));
    const QString said = words(say<"%1: %2">(std::string("1.5.mha"), numeral("0.5")));
    QLocale::setDefault(before);
    QCOMPARE(said, QStringLiteral("1.5.mha: 0,5"));
  }
};

}  // namespace
}  // namespace ew

QTEST_GUILESS_MAIN(ew::GermanTest)
#include "german_test.moc"
