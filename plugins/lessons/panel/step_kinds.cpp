#include "panel/step_kinds.h"

#include <QCoreApplication>
#include <array>
#include <variant>

#include "ew/library/lesson.h"

namespace ew::lessons {
namespace {

struct StepKinds {
  Q_DECLARE_TR_FUNCTIONS(ew::lessons::StepKinds)
};

struct KindWords {
  std::string_view word;
  const char* title;
  const char* tip;
};
constexpr std::array<KindWords, std::variant_size_v<LessonTask>> kKindWords = {{
    {"read", QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "Read"),
     QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "A text to read, perhaps with an image")},
    {"watch", QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "Watch the expert"),
     QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "Your own scan is played and rests at its marks")},
    {"plane", QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "Set a plane"),
     QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "A target plane of the case is to be set")},
    {"sweep", QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "Sweep through"),
     QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "A structure is to be seen from end to end")},
    {"measure", QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "Measure"),
     QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "A measurement that the case expects is to be taken")},
    {"point", QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "Point at it"),
     QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "A point or a structure is to be clicked in the image")},
    {"settings", QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "Set the machine"),
     QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "Transducer and settings are to be right")},
    {"answer", QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "Answer"),
     QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "A question with answers to choose from, or a number")},
    {"free", QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "Scan freely"),
     QT_TRANSLATE_NOOP("ew::lessons::StepKinds", "The trainee scans at will; what is to be shown is ticked off")},
}};

const KindWords& wordsOfKind(std::string_view word) {
  for (const KindWords& kind : kKindWords)
    if (kind.word == word) return kind;
  return kKindWords.front();
}

}  // namespace

QString kindTitle(std::string_view taskWord) { return StepKinds::tr(wordsOfKind(taskWord).title); }
QString kindTip(std::string_view taskWord) { return StepKinds::tr(wordsOfKind(taskWord).tip); }

const std::vector<std::string_view>& kindWords() {
  static const std::vector<std::string_view> words = [] {
    std::vector<std::string_view> made;
    for (const KindWords& kind : kKindWords) made.push_back(kind.word);
    return made;
  }();
  return words;
}

}  // namespace ew::lessons
