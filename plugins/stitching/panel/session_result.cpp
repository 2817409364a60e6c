#include "panel/stitch_session.h"

#include <QPointer>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "ew/sdk/panel.h"
#include "logic/places.h"
#include "panel/phrases.h"
#include "panel/session_parts.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using sdk::words;

}  // namespace

void StitchSession::showResult() {
  if (result_) host_.volumes().show(*result_, tr("Stitched volume").toStdString());
}

void StitchSession::saveResult(const fs::path& folder) {
  if (!result_) {
    Q_EMIT problem(tr("There is no stitched volume yet; run 'Seams and blend' first."));
    return;
  }
  const QPointer<StitchSession> here(this);
  host_.jobs().start(
      tr("Saving the stitched volume").toStdString(),
      [folder, parts = resultFiles_](Progress& whole) -> Result<void> {
        ProgressInWords progress(whole);
        std::error_code failed;
        fs::create_directories(folder, failed);
        for (std::size_t n = 0; n < parts.size(); ++n) {
          if (parts[n].empty()) continue;
          if (progress.cancelRequested()) return failure(ErrorCode::cancelled, "Saving was cancelled.");
          const fs::path target = folder / parts[n].filename();
          const fs::path aside = target.string() + ".part";
          fs::copy_file(parts[n], aside, fs::copy_options::overwrite_existing, failed);
          if (!failed) fs::rename(aside, target, failed);
          if (failed)
            return failure(ErrorCode::notWritable, "'" + target.string() + "' could not be written (" + failed.message() +
                                                       "); choose another folder or make room.");
          progress.report("Copying", static_cast<double>(n + 1) / static_cast<double>(parts.size()));
        }
        return {};
      },
      [here, folder](const Result<void>& outcome) {
        StitchSession* session = here.data();
        if (session == nullptr) return;
        if (!outcome) return session->say(outcome.error());
        Q_EMIT session->said(tr("Saved in %1: volume.mha, coverage.mha, source.mha and provenance.json.").arg(words(folder.string())));
      });
}

void StitchSession::handToCase() {
  if (!result_) {
    Q_EMIT problem(tr("There is no stitched volume yet; run 'Seams and blend' first."));
    return;
  }
  auto& cases = host_.cases();
  if (!cases.current() || cases.currentFolder().empty()) {
    Q_EMIT problem(tr("No case is open that could take the volume; open one (Ctrl+O) or save the volume as a file."));
    return;
  }
  const fs::path caseFolder = cases.currentFolder();
  // Volumes are never written over: an older attempt or another case may still speak of them.
  std::error_code ignored;
  std::string name = "stitched";
  for (int n = 2; fs::exists(caseFolder / "volumes" / (name + ".mha"), ignored); ++n) name = "stitched-" + std::to_string(n);
  const auto read = result_;
  const QPointer<StitchSession> here(this);
  auto& volumes = host_.volumes();
  host_.jobs().start(
      tr("Handing the volume to the case").toStdString(),
      [read, &volumes, caseFolder, name](Progress& whole) -> Result<void> {
        ProgressInWords progress(whole);
        std::error_code unmade;
        fs::create_directories(caseFolder / "volumes", unmade);
        PartOfProgress second(progress, 0.0, 0.6);
        if (auto written = volumes.write(*read, caseFolder / "volumes" / (name + ".mha"), second); !written) return written;
        if (read->coverage.empty()) return {};
        PartOfProgress third(progress, 0.6, 1.0);
        return volumes.writeCoverage(*read, caseFolder / "volumes" / (name + "-coverage.mha"), third);
      },
      [here, read, caseFolder, name](const Result<void>& outcome) {
        StitchSession* session = here.data();
        if (session == nullptr) return;
        if (!outcome) return session->say(outcome.error());
        auto& open = session->host_.cases();
        if (!open.current() || open.currentFolder() != caseFolder) {
          Q_EMIT session->problem(tr("Another case was opened meanwhile; the volume lies in %1 and no case was changed.")
                                      .arg(words((caseFolder / "volumes").string())));
          return;
        }
        nlohmann::json manifest = *open.current();
        nlohmann::json place = nlohmann::json::object();
        if (manifest.contains("volume") && manifest["volume"].is_object() && manifest["volume"].contains("file") &&
            manifest["volume"].contains("file_to_world"))
          place["file_to_world"] = manifest["volume"]["file_to_world"];
        place["file"] = "volumes/" + name + ".mha";
        manifest["volume"] = std::move(place);
        const bool wasSaved = !open.hasUnsavedChanges();
        if (auto edited = open.edit(manifest, tr("take over the stitched volume").toStdString(), {}); !edited)
          return session->say(edited.error());
        QString sentence = tr("The case now uses volumes/%1.mha.").arg(words(name));
        if (wasSaved) {
          if (auto saved = open.save(); !saved) return session->say(saved.error());
        } else {
          sentence += QLatin1Char(' ') + tr("It had unsaved changes before; save the case to keep them all.");
        }
        session->host_.volumes().show(*read, tr("Stitched volume").toStdString());
        Q_EMIT session->said(sentence);
      });
}

}  // namespace ew::stitching
