#include "save_place.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>

namespace ew::ui::save_place_test {
namespace {

const QStringList kImages{QStringLiteral(".png"), QStringLiteral(".mha"), QStringLiteral(".dcm")};
const QStringList kScans{QStringLiteral(".seq.mha"), QStringLiteral(".mha")};
const QDateTime kWhen(QDate(2026, 11, 30), QTime(14, 5));

std::string cleaned(const char* text) { return nameForFiles(QString::fromUtf8(text)).toStdString(); }
std::string dated(const char* proposal, const QStringList& endings) {
  return datedName(QString::fromUtf8(proposal), endings, kWhen).toStdString();
}

TEST(NameForFiles, LeavesOutWhatAFileSystemRefuses) {
  EXPECT_EQ(cleaned("Upper abdomen: pain after meals"), "Upper abdomen pain after meals");
  EXPECT_EQ(cleaned("a/b\\c*d?e\"f<g>h|i"), "a b c d e f g h i");
  EXPECT_EQ(cleaned("one\ntwo\tthree\x01"), "one two three");
  EXPECT_EQ(cleaned("Überblick, 2. Teil"), "Überblick, 2. Teil");
}

TEST(NameForFiles, IsNeitherHiddenNorADeviceNorEndsWithADot) {
  EXPECT_EQ(cleaned("../../secret"), "secret");
  EXPECT_EQ(cleaned("...liver..."), "liver");
  EXPECT_EQ(cleaned("con"), "_con");
  EXPECT_EQ(cleaned("LPT1.png"), "_LPT1.png");
  EXPECT_EQ(cleaned("console"), "console");
  EXPECT_EQ(cleaned("???"), "");
}

TEST(NameForFiles, IsCutBetweenCharacters) {
  EXPECT_EQ(nameForFiles(QString(400, QLatin1Char('a'))).size(), 160);
  const QString heart = QString::fromUtf8("\xf0\x9f\xab\x80");  // four bytes, two halves
  const QString cut = nameForFiles(heart.repeated(100));
  EXPECT_EQ(cut, heart.repeated(40));
}

TEST(DatedName, HasDayAndTimeBeforeItsEnding) {
  EXPECT_EQ(dated("normal-upper-abdomen-liver.png", kImages), "normal-upper-abdomen-liver 2026-11-30 14.05.png");
  EXPECT_EQ(dated("Liver / kidney: right.seq.mha", kScans), "Liver kidney right 2026-11-30 14.05.seq.mha");
  EXPECT_EQ(dated("Aorta 3.5 cm.PNG", kImages), "Aorta 3.5 cm 2026-11-30 14.05.PNG");
  EXPECT_EQ(dated("sheet.odt", kImages), "sheet 2026-11-30 14.05.odt");
  EXPECT_EQ(dated(".png", kImages), "2026-11-30 14.05.png");
}

TEST(FolderForSaving, IsTheOneOfThatKindThatWasUsedLast) {
  const QTemporaryDir root;
  QSettings settings(root.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
  for (const char* each : {"images", "scans"}) ASSERT_TRUE(QDir(root.path()).mkdir(QLatin1String(each)));
  keepFolderForSaving(kImages, root.filePath(QStringLiteral("images/one.png")), settings);
  keepFolderForSaving(kScans, root.filePath(QStringLiteral("scans/one.seq.mha")), settings);
  EXPECT_EQ(folderForSaving(kImages, settings), root.filePath(QStringLiteral("images")));
  EXPECT_EQ(folderForSaving(kScans, settings), root.filePath(QStringLiteral("scans")));
}

TEST(FolderForSaving, IsAFolderOfTheUsersBeforeAndWhereTheLastOneIsGone) {
  const QTemporaryDir root;
  QSettings settings(root.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
  const QString first = folderForSaving(kImages, settings);
  EXPECT_TRUE(QFileInfo(first).isAbsolute());
  keepFolderForSaving(kImages, root.filePath(QStringLiteral("gone/one.png")), settings);
  EXPECT_EQ(folderForSaving(kImages, settings), first);
}

}  // namespace
}  // namespace ew::ui::save_place_test
