// Whatever is done in whatever order, what a person made is there: in its file, in the program, or kept aside for the next start; and what
// is gone somebody agreed to. Lives of a program end by closing, with questions, or by a kill; each is a process of its own.
// EW_KEPT_WORK_ORDERS=200 runs so many orders of 300 actions; EW_KEPT_WORK_SEED=N begins with that one.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QCoreApplication>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <stdexcept>

#include "assessment/made_ratings.h"
#include "ew/assessment/rating.h"
#include "ew/library/attempt.h"
#include "ew/library/edit_autosave.h"
#include "ew/ui_test_door/case_document.h"
#include "ew/ui_test_door/unsaved_work.h"
#include "library/temporary_folder.h"
#include "logic/comment_history.h"
#include "logic/keeping_aside.h"

namespace ew::ui::kept_work_property_test {
namespace {

namespace fs = std::filesystem;
using case_authoring::KeepingAside;
using case_authoring::PaintingAutosave;
using nlohmann::json;
using review::CommentHistory;
using test::TemporaryFolder;

constexpr int kActions = 300;
constexpr const char* kReviewer = "Ada";

[[noreturn]] void broken(const std::string& what) { throw std::runtime_error(what); }
void expect(bool holds, const std::string& what) {
  if (!holds) broken(what);
}
template <class T>
T sure(Result<T> result) {
  if (!result) broken(result.error().sentence());
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}

/// What painting is told apart by: a number in its voxels.
Volume labelsOf(int number) {
  Volume labels;
  labels.grid.dims = {2, 2, 2};
  labels.grid.spacing_mm = {1.0, 1.0, 1.0};
  labels.echo.assign(8, 1);
  labels.echo[0] = static_cast<std::uint8_t>(number % 250);
  labels.echo[1] = static_cast<std::uint8_t>(number / 250);
  return labels;
}
int numberOf(const Volume& labels) { return labels.echo.at(0) + 250 * labels.echo.at(1); }

/// What must be there, beside the program: plain values that every life reads and writes.
struct Model {
  json at;
  explicit Model(json read) : at(std::move(read)) {}

  static json fresh() {
    return {{"next", 1},
            {"saved", {{"a", "0"}, {"b", "0"}}},  // titles of cases in their files
            {"left", json::array()},              // edits that killed programs left, {case, title}
            {"comments", {{"one", json::array()}, {"two", json::array()}}},
            {"drafts", {{"one", ""}, {"two", ""}}},
            {"painted", {{"a", 0}, {"b", 0}}},  // what a case has for good
            {"leftPaint", json::array()}};      // {case, number}, the latest last
  }
  std::string word() {
    at["next"] = at["next"].get<int>() + 1;
    return std::to_string(at["next"].get<int>());
  }
};

/// One life of the program: the real logic of the window and its plugins around one list of unsaved work.
class Program {
 public:
  Program(fs::path home, Model& model, std::mt19937& chance)
      : home_(std::move(home)), model_(model), chance_(chance), keptEdits_(home_ / "edits"), aside_(newAside()) {
    QObject::connect(&document_, &CaseDocument::changed, [this] {
      if (document_.hasUnsavedChanges())
        sure(keptEdits_.keep(*document_.current(), document_.asRead().value_or(Fingerprint{})));
      else
        keptEdits_.forget();
    });
    hold();
    open("a");
    review("one");
    offerLeft();
    check("at the start");
  }

  /// @return whether the program goes on
  bool act() {
    switch (upTo(20)) {
      case 0:
      case 1:
      case 2:
        editTitle();
        break;
      case 3:
        undoTitle();
        break;
      case 4:
        redoTitle();
        break;
      case 5:
        save();
        break;
      case 6:
      case 7:
        openOther();
        break;
      case 8:
      case 9:
        comment();
        break;
      case 10:
        if (comments_.undoName().size() > 0) comments_.undo();
        break;
      case 11:
        reviewOther();
        break;
      case 12:
      case 13:
        rate();
        break;
      case 14:
        pause();
        break;
      case 15:
      case 16:
        paint();
        break;
      case 17:
        runJob();
        break;
      case 18:
        keepPainting();
        break;
      default:
        return !mayEnd();
    }
    check("after an action");
    return true;
  }

  /// What a kill leaves.
  void die() {
    if (document_.hasUnsavedChanges()) model_.at["left"].push_back({{"case", open_}, {"title", title()}});
    for (const auto& [painter, number] : asides_)
      if (const auto kept = painter.lock(); (kept || painter.expired()) && number.second > 0) leavePaint(number.first, number.second);
  }

 private:
  int upTo(int count) { return static_cast<int>(std::uniform_int_distribution<>(0, count - 1)(chance_)); }
  [[nodiscard]] fs::path folderOf(const std::string& name) const { return home_ / name; }
  [[nodiscard]] std::string title() const { return document_.current()->title; }

  // --- the list, as the window makes it
  void hold() {
    const auto answer = [this](const char* name) {
      asked_.insert(name);
      return upTo(3);  // save, discard, cancel
    };
    unsaved_.add({"case",
                  {Loss::opening, Loss::closing},
                  [this] { return document_.hasUnsavedChanges(); },
                  [this, answer](Loss, const std::string&) {
                    const int said = answer("case");
                    if (said == 0) save();
                    return said != 2;
                  }});
    unsaved_.add({"comments",
                  {Loss::closing},
                  [this] { return !comments_.isSaved(); },
                  [this, answer](Loss, const std::string&) {
                    const int said = answer("comments");
                    if (said == 0) keepComments();
                    return said != 2;
                  }});
    unsaved_.add({"rating",
                  {Loss::closing},
                  [this] { return rating_ != model_.at["drafts"][attempt_].get<std::string>(); },
                  [this](Loss, const std::string&) {
                    keepDraft();  // without a question
                    return true;
                  }});
    unsaved_.add({"painting",
                  {Loss::closing},
                  [this] { return painting_ > 0; },
                  [answer](Loss, const std::string&) { return answer("painting") == 1; }});
  }

  /// Asks the list, and holds against it what is known beside it.
  bool maySomethingGo(Loss loss) {
    asked_.clear();
    std::set<std::string> wouldGo;
    if (clean_ != now_) wouldGo.insert("case");
    if (loss == Loss::closing && textsNow() != model_.at["comments"][attempt_]) wouldGo.insert("comments");
    if (loss == Loss::closing && painting_ > 0) wouldGo.insert("painting");
    if (!unsaved_.mayLose(loss, {})) return false;
    for (const std::string& name : wouldGo) expect(asked_.contains(name), name + " went without a question");
    return true;
  }

  // --- the case
  void open(const std::string& name) {
    leavePainting();
    auto read = sure(readCase(folderOf(name)));
    open_ = name;
    document_.open(std::move(read.opened), read.manifest);
    titles_ = {title()};
    now_ = 0;
    clean_ = 0;
    offerPainting();
  }
  void openOther() {
    if (!maySomethingGo(Loss::opening)) return;
    open(open_ == "a" ? "b" : "a");
  }
  void editTitle() {
    Case changed = *document_.current();
    const std::string next = model_.word();
    changed.title = next;
    sure(document_.edit(changed, "Change the title", {}));
    if (clean_ > now_) clean_ = -1;
    titles_.resize(static_cast<std::size_t>(now_) + 1);
    titles_.push_back(next);
    ++now_;
  }
  void undoTitle() {
    if (now_ == 0) return;
    document_.undo();
    --now_;
  }
  void redoTitle() {
    if (static_cast<std::size_t>(now_) + 1 >= titles_.size()) return;
    document_.redo();
    ++now_;
  }
  void save() {
    // Edits that were taken over began with an older file: the window asks, and is told to overwrite.
    sure(document_.save({}, {.changedOnDisk = document_.isChangedOnDisk()}));
    model_.at["saved"][open_] = titles_[static_cast<std::size_t>(now_)];
    clean_ = now_;
  }

  // --- what a killed program left
  void offerLeft() {
    auto expected = model_.at["left"];
    const auto left = keptEdits_.left();
    std::vector<json> there;
    for (const auto& each : left)
      there.push_back({{"case", each.caseFolder.filename().string()}, {"title", each.manifest.value("title", std::string())}});
    std::vector<json> wanted(expected.begin(), expected.end());
    std::sort(there.begin(), there.end());
    std::sort(wanted.begin(), wanted.end());
    expect(there == wanted, "edits that were left: " + json(there).dump() + " instead of " + json(wanted).dump());
    for (const auto& each : left) {
      const json entry = {{"case", each.caseFolder.filename().string()}, {"title", each.manifest.value("title", std::string())}};
      const int said = upTo(3);  // take over, discard, later
      if (said == 2 || (said == 0 && document_.hasUnsavedChanges())) continue;
      if (said == 0) {
        open(entry["case"]);
        sure(document_.restore(sure(caseFromManifest(each.manifest, each.caseFolder)), "Take over", each.asRead));
        if (title() != titles_.back()) {
          titles_.push_back(title());
          ++now_;
        }
        expect(title() == entry["title"], "what was taken over is " + title());
      }
      EditAutosave::remove(each);
      auto& all = model_.at["left"];
      all.erase(std::find(all.begin(), all.end(), entry));
    }
  }

  // --- comments and rating
  [[nodiscard]] std::string draftOf(const std::string& attempt) const {
    for (const auto& each : everyRating(folderOf(attempt)).ratings)
      if (!each.rating.finished && each.rating.rater == kReviewer) return each.rating.remark;
    return {};
  }
  void review(const std::string& attempt) {
    attempt_ = attempt;
    comments_ = sure(CommentHistory::open(folderOf(attempt), kReviewer));
    rating_ = draftOf(attempt);
  }
  /// As before anything else is reviewed.
  void keepReview() {
    keepComments();
    keepDraft();
  }
  void keepComments() {
    sure(comments_.save());
    model_.at["comments"][attempt_] = textsNow();
  }
  void keepDraft() {
    if (rating_ == model_.at["drafts"][attempt_].get<std::string>()) return;
    Rating draft = test::ratingOf(form_, kReviewer, {}, false);
    draft.remark = rating_;
    sure(keepRating(folderOf(attempt_), form_, draft));
    model_.at["drafts"][attempt_] = rating_;
  }
  void reviewOther() {
    keepReview();
    review(attempt_ == "one" ? "two" : "one");
    expect(rating_ == model_.at["drafts"][attempt_].get<std::string>(), "the draft of " + attempt_ + " is " + rating_);
  }
  void comment() {
    ReviewComment said;
    said.stepId = "find";
    said.text = model_.word();
    said.time_s = static_cast<double>(comments_.comments().size());
    comments_.add(said, "comment");
  }
  void rate() { rating_ = model_.word(); }
  void pause() { keepReview(); }
  [[nodiscard]] json textsNow() const { return textsOf(comments_.comments()); }
  static json textsOf(const std::vector<ReviewComment>& comments) {
    json texts = json::array();
    for (const ReviewComment& each : comments) texts.push_back(each.text);
    return texts;
  }

  // --- painting, kept aside in jobs that end in any order
  std::shared_ptr<KeepingAside> newAside() {
    auto made = std::make_shared<KeepingAside>(home_ / "paint",
                                               [this](auto work, auto done) { jobs_.push_back([=] { done(work(noProgress())); }); });
    return made;
  }
  void paint() {
    painting_ = std::stoi(model_.word());
    keepAside();
  }
  void keepAside() {
    const int number = painting_;
    const std::weak_ptr<KeepingAside> painter = aside_;
    const std::string of = open_;
    aside_->keep({labelsOf(number), folderOf(of), ""}, [this, painter, of, number](const Result<void>& outcome) {
      expect(outcome.has_value(), "painting could not be kept aside");
      remember(painter, of, number);
    });
  }
  void remember(const std::weak_ptr<KeepingAside>& painter, const std::string& of, int number) {
    // What is kept next is later, by the clock of the file system too, which tells the latest of what was left.
    const fs::path clock = home_ / "clock";
    const auto touched = [&clock] {
      test::writeText(clock, "x");
      return fs::last_write_time(clock);
    };
    for (const auto now = touched(); touched() == now;) {
    }
    for (auto& [each, kept] : asides_)
      if (!each.owner_before(painter) && !painter.owner_before(each)) {
        kept = {of, number};
        return;
      }
    asides_.push_back({painter, {of, number}});
  }
  void runJob() {
    if (jobs_.empty()) return;
    const auto at = static_cast<std::size_t>(upTo(static_cast<int>(jobs_.size())));
    const auto job = jobs_[at];
    jobs_.erase(jobs_.begin() + static_cast<std::ptrdiff_t>(at));
    job();
    settle();
  }
  /// What was left on purpose belongs to the next program once its last job has ended.
  void settle() {
    for (auto& [painter, kept] : asides_) {
      const auto alive = painter.lock();
      const bool isPresent = alive == aside_;
      if (isPresent || (alive && alive->isBusy()) || kept.second == 0) continue;
      leavePaint(kept.first, std::exchange(kept.second, 0));
    }
  }
  void leavePaint(const std::string& of, int number) { model_.at["leftPaint"].push_back({{"case", of}, {"number", number}}); }
  void keepPainting() {
    if (painting_ == 0) return;
    model_.at["painted"][open_] = std::exchange(painting_, 0);
    forgetAside();
  }
  void forgetAside() {
    aside_->forget();
    while (aside_->isBusy()) runJob();
    for (auto& [painter, kept] : asides_)
      if (painter.lock() == aside_) kept.second = 0;
  }
  /// Another case comes: what is not kept in this one is left for whoever opens it again.
  void leavePainting() {
    if (painting_ > 0) {
      keepAside();
      aside_->leave();
      painting_ = 0;
    } else {
      forgetAside();
    }
    while (!jobs_.empty()) runJob();  // the order is any
    aside_ = newAside();
    settle();
  }
  void offerPainting() {
    auto& all = model_.at["leftPaint"];
    json::iterator latest = all.end();
    for (auto at = all.begin(); at != all.end(); ++at)
      if ((*at)["case"] == open_) latest = at;
    const auto left = aside_->kept().leftFor(folderOf(open_));
    expect(left.has_value() == (latest != all.end()), "painting left in " + open_ + ": " + (left ? "some" : "none") + ", of " + all.dump());
    if (!left) return;
    const int number = numberOf(sure(PaintingAutosave::read(*left, noProgress())));
    expect(number == (*latest)["number"].get<int>(), "painting left is " + std::to_string(number) + ", not the latest of " + all.dump());
    const int said = upTo(3);
    if (said == 2) return;
    if (said == 0) {
      painting_ = number;
      keepAside();
      while (!jobs_.empty()) runJob();
    }
    PaintingAutosave::remove(*left);
    all.erase(latest);
  }

  // --- the end
  bool mayEnd() {
    if (!maySomethingGo(Loss::closing)) return false;
    // The user has decided about everything.
    keptEdits_.forget();
    forgetAside();
    while (!jobs_.empty()) runJob();
    return true;
  }

  void check(const std::string& when) {
    for (const char* name : {"a", "b"}) {
      const std::string saved = sure(loadCase(folderOf(name))).title;
      expect(saved == model_.at["saved"][name], when + ": case " + name + " is saved as " + saved);
    }
    expect(title() == titles_[static_cast<std::size_t>(now_)], when + ": the open case is " + title());
    expect(document_.hasUnsavedChanges() == (clean_ != now_), when + ": unsaved is not what it should be");
    const auto held = unsaved_.heldAgainst(Loss::closing);
    const auto holds = [&held](const char* name) { return std::find(held.begin(), held.end(), name) != held.end(); };
    for (const char* attempt : {"one", "two"}) {
      const auto read = sure(readComments(folderOf(attempt), kReviewer));
      expect(textsOf(read.comments) == model_.at["comments"][attempt], when + ": comments kept are " + textsOf(read.comments).dump());
      expect(draftOf(attempt) == model_.at["drafts"][attempt].get<std::string>(), when + ": the draft kept is " + draftOf(attempt));
    }
    expect(holds("comments") == (textsNow() != model_.at["comments"][attempt_]), when + ": comments that are not saved are not held");
    expect(holds("case") == (clean_ != now_), when + ": an edited case is not held");
    expect(holds("painting") == (painting_ > 0), when + ": painting is not held");
  }

  fs::path home_;
  Model& model_;
  std::mt19937& chance_;
  UnsavedWork unsaved_;
  std::set<std::string> asked_;
  CaseDocument document_;
  EditAutosave keptEdits_;
  std::string open_;
  std::vector<std::string> titles_;
  int now_ = 0, clean_ = 0;
  CommentHistory comments_;
  std::string attempt_, rating_;
  RatingForm form_ = test::smallForm();
  std::vector<std::function<void()>> jobs_;
  std::vector<std::pair<std::weak_ptr<KeepingAside>, std::pair<std::string, int>>> asides_;  ///< what each has kept
  std::shared_ptr<KeepingAside> aside_;
  int painting_ = 0;
};

void makeWorld(const fs::path& home) {
  for (const char* name : {"a", "b"})
    test::writeText(home / name / "case.json", json{{"format", 1},
                                                    {"id", std::string("case-") + name},
                                                    {"title", "0"},
                                                    {"region", "upper abdomen"},
                                                    {"patient", {{"name", "Test Person"}, {"sex", "female"}, {"age_years", 40}}},
                                                    {"history", "None."},
                                                    {"indication", "To be looked at."},
                                                    {"diagnosis", "Healthy."},
                                                    {"volume", json::object()}}
                                                   .dump());
  for (const char* name : {"one", "two"}) {
    Attempt attempt;
    attempt.id = name;
    attempt.caseId = "case-a";
    attempt.lessonId = "lesson";
    attempt.person = "Trainee";
    attempt.startedAt = test::kRatedAt;
    fs::rename(AttemptFolder::begin(home / "library", attempt)->folder(), home / name);
  }
  test::writeText(home / "model.json", Model::fresh().dump());
}

/// One life, in a process of its own. @return actions done; the world is as it left it
int live(const fs::path& home, unsigned seed, int most) {
  const pid_t child = ::fork();
  if (child == 0) {
    int count = 0;
    char name[] = "kept_work";
    char* names[] = {name, nullptr};
    int one = 1;
    const QCoreApplication application(one, names);
    try {
      std::mt19937 chance(seed);
      Model model(json::parse(test::textOf(home / "model.json")));
      const int killAfter = std::uniform_int_distribution<>(5, 60)(chance);
      auto* program = new Program(home, model, chance);  // a kill runs no destructor
      bool goesOn = true;
      while (goesOn && count < most && count < killAfter) {
        goesOn = program->act();
        ++count;
      }
      if (goesOn)
        program->die();
      else
        delete program;
      model.at["count"] = count;
      test::writeText(home / "model.json", model.at.dump());
      ::_exit(7);
    } catch (const std::exception& problem) {
      test::writeText(home / "broken.txt",
                      "action " + std::to_string(count) + " of the life with seed " + std::to_string(seed) + ": " + problem.what());
      ::_exit(1);
    }
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 7) << test::textOf(home / "broken.txt");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 7) return -1;
  return std::max(1, json::parse(test::textOf(home / "model.json"))["count"].get<int>());
}

unsigned numberFrom(const char* variable, unsigned otherwise) {
  const char* text = std::getenv(variable);
  return text != nullptr ? static_cast<unsigned>(std::atoi(text)) : otherwise;
}

TEST(KeptWork, IsThereOrWasGivenUpWhateverTheOrder) {
  const unsigned first = numberFrom("EW_KEPT_WORK_SEED", 1), orders = numberFrom("EW_KEPT_WORK_ORDERS", 2);
  for (unsigned order = first; order < first + orders; ++order) {
    const TemporaryFolder home;
    makeWorld(home.path());
    for (int done = 0, life = 0; done < kActions; ++life) {
      const int more = live(home.path(), 1000 * order + static_cast<unsigned>(life), kActions - done);
      ASSERT_GT(more, 0) << "order " << order << ", after " << done << " actions";
      done += more;
    }
  }
}

}  // namespace
}  // namespace ew::ui::kept_work_property_test
