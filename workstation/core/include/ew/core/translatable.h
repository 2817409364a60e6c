#pragma once

/// Marks an English text of a library that links no Qt as one that the window translates: `text` itself, nothing more. Whoever shows it
/// asks QCoreApplication::translate(context, text). Texts are collected with
/// `lupdate -tr-function-alias QT_TRANSLATE_NOOP+=EW_TRANSLATE_NOOP`.
/// @param context name of the translator's context, "ew::EffectInfo"
#define EW_TRANSLATE_NOOP(context, text) text
