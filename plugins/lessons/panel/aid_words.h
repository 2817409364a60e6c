#pragma once

#include <QCoreApplication>
#include <QString>

#include "ew/library/lesson.h"

namespace ew::lessons {

/// What the aids of a step are called.
struct AidWords {
  bool LessonAids::*aid;
  const char* name;  ///< of the widget
  const char* text;
};
inline constexpr AidWords kAidWords[] = {
    {&LessonAids::translucentSkin, "aid_translucent_skin", QT_TRANSLATE_NOOP("ew::lessons::StepPage", "Translucent skin")},
    {&LessonAids::organs, "aid_organs", QT_TRANSLATE_NOOP("ew::lessons::StepPage", "Organs in the body")},
    {&LessonAids::volumeBox, "aid_volume_box", QT_TRANSLATE_NOOP("ew::lessons::StepPage", "What was recorded")},
    {&LessonAids::ownPath, "aid_own_path", QT_TRANSLATE_NOOP("ew::lessons::StepPage", "My path")},
    {&LessonAids::expertProbe, "aid_expert_probe", QT_TRANSLATE_NOOP("ew::lessons::StepPage", "The expert's plane")},
    {&LessonAids::outline, "aid_outline", QT_TRANSLATE_NOOP("ew::lessons::StepPage", "Outline in the image")},
    {&LessonAids::compass, "aid_compass", QT_TRANSLATE_NOOP("ew::lessons::StepPage", "Next movement")},
};
inline QString aidText(const AidWords& aid) { return QCoreApplication::translate("ew::lessons::StepPage", aid.text); }

}  // namespace ew::lessons
