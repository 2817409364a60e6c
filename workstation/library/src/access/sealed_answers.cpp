#include "ew/library/sealed_answers.h"

#include <sodium.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "access/seal_index.h"
#include "access/sealed_file.h"
#include "access/trainee_view.h"
#include "case/echo_files.h"
#include "case/frame_files.h"
#include "case/manifest.h"
#include "case/outgoing_case.h"
#include "case/revisions.h"
#include "ew/core/json_fields.h"
#include "ew/core/output_set.h"
#include "ew/io/json_files.h"
#include "ew/io/safe_file.h"
#include "ew/library/case_words.h"
#include "ew/library/content_name.h"
#include "ew/library/lesson_links.h"
#include "ew/library/new_case.h"
#include "ew/library/plain_image.h"
#include "files/guarded_case.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kLargestImage_bytes = 64u << 20;

/// Everything trainees may read, as one sum; what case.json says of answers.sealed is left out, for that is made afterwards.
Result<std::string> sumOfView(const fs::path& folder, Progress& progress) {
  auto manifest = readJsonFile(folder / kManifestName, verbatim(kManifestName), 64u << 20);
  if (!manifest) return passOn(manifest.error());
  manifest->erase("sealed");
  auto files = sumsOfCase(folder, progress);
  if (!files) return passOn(files.error());
  std::erase_if(*files, [](const FileSum& each) { return each.path == kManifestName || each.path == kSealedName; });
  const std::string whole = json{{"manifest", *manifest}, {"files", json(jsonOf(*files))}}.dump();
  Sha256 sum;
  sum.add(std::as_bytes(std::span(whole)));
  return sum.hex();
}

std::string randomId() {
  constexpr std::string_view kLetters = "abcdefghijkmnpqrstuvwxyz23456789";
  std::string id = "examination-";
  for (int n = 0; n < 10; ++n) id += kLetters[::randombytes_uniform(static_cast<std::uint32_t>(kLetters.size()))];
  return id;
}

/// An image without what is written in it, under a name that says nothing.
Result<std::string> addImage(const fs::path& file, const fs::path& root, std::size_t number) {
  const auto bytes = readTextFile(file, kLargestImage_bytes);
  if (!bytes) return passOn(bytes.error());
  std::string ending;
  const auto plain = plainImage(*bytes, ending);
  if (!plain) {
    Error problem = plain.error();
    problem.message = say<"The image \"%1\": %2">(file, std::move(problem.message));
    return passOn(std::move(problem));
  }
  const std::string name = "media/picture-" + std::to_string(number) + ending;
  std::error_code ignored;
  fs::create_directories((root / name).parent_path(), ignored);
  if (auto written = writeFileSafely(root / name, *plain); !written) return passOn(written.error());
  return name;
}

/// The way from a case to the folder that its trainees get.
class Making {
 public:
  Making(CaseToHandOn from, fs::path aside, const ExaminationOptions& options)
      : from_(std::move(from)), aside_(std::move(aside)), options_(options) {}

  Result<Examination> run(Progress& progress) {
    PartOfProgress volume(progress, 0.0, 0.7), summing(progress, 0.7, 0.8), sealing(progress, 0.8, 1.0);
    if (auto made = takeFields(); !made) return passOn(made.error());
    if (auto made = takeVolume(volume); !made) return passOn(made.error());
    if (auto made = takeImages(); !made) return passOn(made.error());
    if (auto made = takeWords(); !made) return passOn(made.error());
    view_.otherFields["parts"][std::string(kLessonsPart)] = jsonOf(lessons_.lessons);
    if (auto sealed = seal(summing, sealing); !sealed) return passOn(sealed.error());
    if (const auto opened = loadCase(aside_); !opened) return passOn(opened.error());
    made_.id = view_.id;
    made_.leftOut = lessons_.leftOut;
    for (const Lesson& lesson : lessons_.lessons) made_.steps += lesson.steps.size();
    return std::move(made_);
  }

 private:
  Result<void> takeFields() {
    const auto lessons = lessonsOf(from_.opened);
    if (!lessons) return passOn(lessons.error());
    auto view = traineeView(*lessons);
    if (!view) return passOn(view.error());
    lessons_ = std::move(*view);
    auto fields = traineeView(from_.opened, options_.id.empty() ? randomId() : options_.id);
    if (!fields) return passOn(fields.error());
    view_ = withRights(std::move(*fields), rightsOf(from_.opened));  // licences ask for it wherever the volume goes
    return {};
  }

  Result<void> takeVolume(Progress& progress) {
    PartOfProgress loading(progress, 0.0, 0.6), writing(progress, 0.6, 0.8), echoing(progress, 0.8, 1.0);
    // Tissue that moves is written along the axes of its own frame, and placed as the case is. A recording is placed now: its file is
    // called by its content, and the author's name for it stays behind.
    Case own = from_.opened;
    if (!own.volume.recipe.empty() || !echoFilesOf(own).empty()) std::swap(own.volume.fileToWorld, view_.volume.fileToWorld);
    auto echo = loadCaseVolume(own, loading, options_.preparation);
    if (!echo) return passOn(echo.error());
    made_.notes = std::move(echo->notes);
    PlainTissues tissues = plainTissues(sceneWithTissues(from_.opened.scene, echo->tissues));
    view_.scene = std::move(tissues.scene);
    if (!echo->labels || !tissues.needsLabels) view_.scene.tissues.clear();
    if (auto added = add(echo->volume, view_.volume.file, writing); !added) return added;
    if (!own.volume.frames.empty())
      if (auto added = addFrames(own); !added) return added;
    if (echo->labels && tissues.needsLabels) {
      for (std::uint8_t& label : echo->labels->echo) label = tissues.newLabel[label];
      if (auto added = add(*echo->labels, view_.volume.labels, noProgress()); !added) return added;
    }
    if (!echo->tissue) return {};
    TissueMaps& maps = *echo->tissue;
    if (auto added = add({maps.grid, std::move(maps.level), {}}, view_.volume.level, noProgress()); !added) return added;
    if (maps.isRecorded) return {};
    return addEchoes(view_, aside_, plainSurfaces(std::move(maps)), echo->motion.get(), echo->flow.get(), echoing);
  }

  /// Placed as the volume is. What the file says beside the images and their places stays behind.
  Result<void> addFrames(const Case& own) {
    auto images = readFrames(own, noProgress());
    if (!images) return passOn(images.error());
    images->otherFields.clear();
    for (SequenceFrame& each : images->frames) {
      each.time_s.reset();
      each.otherFields.clear();
      for (FrameTransform& place : each.transforms) place.matrix = own.volume.fileToWorld.matrix * place.matrix;
    }
    auto added = addSequence(*images, aside_, noProgress());
    if (!added) return passOn(added.error());
    view_.volume.frames = std::move(*added);
    return {};
  }

  Result<void> add(const Volume& volume, std::string& name, Progress& progress) const {
    auto added = addVolume(volume, aside_, progress);
    if (!added) return passOn(added.error());
    name = std::move(*added);
    return {};
  }

  Result<void> takeImages() {
    std::size_t number = 0;
    for (std::size_t n = 0; n < view_.previousExaminations.size(); ++n)
      for (const std::string& image : from_.opened.previousExaminations[n].images) {
        const auto file = fileOfCase(from_.opened.folder, image, "previous_examinations");
        if (!file) return passOn(file.error());
        auto added = addImage(*file, aside_, ++number);
        if (!added) return passOn(added.error());
        view_.previousExaminations[n].images.push_back(std::move(*added));
      }
    const std::string part = "parts/" + std::string(kLessonsPart);
    std::map<std::string, std::string> names;
    for (const std::string& image : lessons_.images) {
      const auto file = fileOfCase(from_.opened.folder, part + "/" + image, "parts.lessons");
      if (!file) return passOn(file.error());
      auto added = addImage(*file, aside_ / part, names.size() + 1);
      if (!added) return passOn(added.error());
      names[image] = std::move(*added);
    }
    for (Lesson& lesson : lessons_.lessons)
      for (LessonStep& step : lesson.steps)
        if (auto* read = std::get_if<ReadingTask>(&step.task); read != nullptr && !read->image.empty()) read->image = names[read->image];
    return {};
  }

  /// Translations of the texts that trainees read, and of no other.
  Result<void> takeWords() {
    const std::vector<std::string> texts = textsOf(view_, lessons_.lessons);
    std::error_code problem;
    for (fs::directory_iterator at(from_.opened.folder / "words", problem), end; !problem && at != end; at.increment(problem)) {
      const std::string language = at->path().stem().string();
      if (at->path().extension() != ".json" || language.starts_with('.')) continue;
      const auto words = readCaseWords(at->path());
      if (!words) return passOn(words.error());
      for (const std::string& text : texts)
        if (words->has(text))
          if (auto kept = setCaseWord(aside_, language, text, words->of(text)); !kept) return kept;
    }
    return {};
  }

  Result<void> seal(Progress& summing, Progress& sealing) {
    view_.sealed = SealReference{.file = kSealedName, .sha256 = std::string(64, '0')};
    // Its file has to be there for the case to be one; it is replaced at once.
    if (auto written = writeFileSafely(aside_ / kSealedName, std::string_view("")); !written) return written;
    if (auto saved = saveCase(view_, aside_); !saved) return saved;
    const auto view = sumOfView(aside_, summing);
    if (!view) return passOn(view.error());
    const auto there = sumsOfCase(aside_);
    if (!there) return passOn(there.error());
    const SealIndex index = indexOf(from_, view_.id, lessons_, *there);
    std::error_code ignored;
    fs::remove(aside_ / kSealedName, ignored);
    ByteCount count(say<"Sealing the answers">(), bytesToSeal(index), sealing);
    auto sealed = sealFile(aside_ / kSealedName, view_.id, *view, options_.instructors,
                           [&](const TakePiece& put) { return writeSealed(index, from_.opened.folder, count, put); });
    if (!sealed) return sealed;
    const auto sum = sha256Of(aside_ / kSealedName);
    if (!sum) return passOn(sum.error());
    view_.sealed->sha256 = made_.sealedSha256 = *sum;
    return saveCase(view_, aside_);
  }

  CaseToHandOn from_;
  fs::path aside_;
  const ExaminationOptions& options_;
  Case view_;
  LessonsView lessons_;
  Examination made_;
};

Result<void> checkOptions(const ExaminationOptions& options) {
  if (options.instructors.empty())
    return failure(
        ErrorCode::badUsage,
        say<"Say for whom the answers are sealed, with a public key from 'echoweave key show'; without one nobody could judge the "
            "examination.">());
  if (!options.id.empty() && !isCaseId(options.id))
    return failure(ErrorCode::badUsage,
                   say<"'%1' cannot be the id of an examination; take letters, digits, '-', '_' and '.', at most 100.">(options.id));
  return {};
}

/// The examination as it stands in its folder, when both of its halves are what they say.
Result<Case> checkedExamination(const fs::path& folder, Progress& progress) {
  auto opened = loadCase(folder);
  if (!opened) return opened;
  if (!opened->sealed)
    return failure(ErrorCode::unsupported, say<"The case '%1' is no examination: its answers are not sealed.">(opened->id),
                   {{"case", opened->id}});
  const auto header = readSealedFileHeader(opened->folder / kSealedName);
  if (!header) return passOn(header.error());
  const auto sum = sha256Of(opened->folder / kSealedName, progress);
  if (!sum) return passOn(sum.error());
  const auto view = sumOfView(opened->folder, progress);
  if (!view) return passOn(view.error());
  if (*sum != opened->sealed->sha256 || header->caseId != opened->id || header->view != *view)
    return failure(
        ErrorCode::badField,
        say<"The examination '%1' and its sealed answers do not belong together, or one of them was changed; use the bundle as it "
            "was exported.">(opened->id),
        {{"case", opened->id}});
  return opened;
}

}  // namespace

Result<Examination> makeExamination(const fs::path& caseFolder, const fs::path& folder, const ExaminationOptions& options,
                                    Progress& progress) {
  return guardedCase(caseFolder, [&]() -> Result<Examination> {
    if (auto good = checkOptions(options); !good) return passOn(good.error());
    PartOfProgress summing(progress, 0.0, 0.1), making(progress, 0.1, 1.0);
    auto from = caseToHandOn(caseFolder, summing);
    if (!from) return passOn(from.error());
    if (from->opened.sealed)
      return failure(ErrorCode::unsupported, say<"The case '%1' is an examination already; hand on its bundle as it is.">(from->opened.id),
                     {{"case", from->opened.id}});
    OutputSet outputs;
    if (auto announced = outputs.announceNewFolder(folder); !announced) return passOn(announced.error());
    auto made = Making(std::move(*from), outputs.staged(folder), options).run(making);
    if (!made) return passOn(outputs.inGivenNames(made.error()));
    if (auto committed = outputs.commit(); !committed) return passOn(committed.error());
    return made;
  });
}

Result<OpenExamination> openExamination(const fs::path& examinationFolder, const SecretKey& key, const fs::path& folder,
                                        Progress& progress) {
  return guardedCase(examinationFolder, [&]() -> Result<OpenExamination> {
    PartOfProgress checking(progress, 0.0, 0.3), opening(progress, 0.3, 1.0);
    const auto examination = checkedExamination(examinationFolder, checking);
    if (!examination) return passOn(examination.error());
    OutputSet outputs;
    if (auto announced = outputs.announceNewFolder(folder); !announced) return passOn(announced.error());
    std::error_code ignored;
    ByteCount count(say<"Opening the sealed answers">(), fs::file_size(examination->folder / kSealedName, ignored), opening);
    ContentUnpacker content(examination->folder, outputs.staged(folder), count);
    auto read = openSealedFile(examination->folder / kSealedName, key, count, [&](auto piece) { return content.take(piece); });
    if (read) read = content.finish();
    if (!read) return passOn(outputs.inGivenNames(read.error()));
    if (const auto whole = loadCase(outputs.staged(folder)); !whole) return passOn(outputs.inGivenNames(whole.error()));
    if (auto committed = outputs.commit(); !committed) return passOn(committed.error());
    const SealIndex& index = content.index();
    return OpenExamination{folder, index.caseId, examination->id, examination->sealed->sha256, index.lessons};
  });
}

}  // namespace ew
