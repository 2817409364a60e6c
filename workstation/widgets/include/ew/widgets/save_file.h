#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <vector>

#include "ew/core/output_set.h"
#include "ew/core/result.h"

class QWidget;

namespace ew {

/// Where something is saved.
struct SaveFile {
  QString title;        ///< of the dialog
  QString proposal;     ///< a name, which may hold a title as it is; with its folder when it has one. Without, the question begins where
                        ///< this kind of file was saved last
  QString filter;       ///< "MetaImage (*.mha *.mhd)"
  QStringList endings;  ///< that can be written (".mha"), in any case of letters; a name that ends with none of them gets that of the
                        ///< chosen filter, or the first
  /// The names that saving under a complete name writes, each with the files it stands for (filesNamedBy). Empty: that name alone.
  std::function<QStringList(const QString& file)> written = {};
  /// Why a file that is there must never be replaced; empty: the user is asked. None: always asked.
  std::function<QString(const QString& existing)> whyKept = {};
  std::vector<std::filesystem::path> madeFrom = {};  ///< files or folders that are never replaced either
  bool isDated = false;                              ///< day and time join the proposal, so that the next one is another (dated)
};

/// The same with day and time in its name; the proposal is then a name alone.
[[nodiscard]] SaveFile dated(SaveFile asked);

/// What everything on show in a window was made from, so that no question in it or in one of its dialogs lets that be replaced. A child of
/// the window, which owns it.
class DisplaySources final : public QObject {
 public:
  using Ask = std::function<std::vector<std::filesystem::path>()>;
  DisplaySources(QWidget& window, Ask ask);
  /// Of the window that a widget belongs to, and of those around that.
  [[nodiscard]] static std::vector<std::filesystem::path> around(const QWidget* widget);

 private:
  Ask ask_;
};

/// Asks for a name, completes it, and then asks by the files that will really be written whether what is there may be replaced. The one
/// place of the program that asks where to save; plugins come here by sdk::Window::askSaveFile.
/// @return the complete name; empty: the user does not want to save
[[nodiscard]] QString askSaveFile(QWidget* parent, const SaveFile& asked);

/// Writes files aside and puts them in place together when all are there; what was there before stays until then.
/// @param write writes each of `files` to the place that the set names for it
/// @error as OutputSet::announce, `write` and OutputSet::commit, in the names of `files`
[[nodiscard]] Result<void> saveTogether(const std::vector<std::filesystem::path>& files,
                                        const std::function<Result<void>(const OutputSet& outputs)>& write);

}  // namespace ew
