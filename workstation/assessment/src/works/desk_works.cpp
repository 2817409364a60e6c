#include <algorithm>
#include <set>

#include "works/step_works.h"

namespace ew {
namespace {

StepResult scored(double score) {
  StepResult result;
  result.score = score;
  return result;
}

class ReadingWork final : public StepWork {
 public:
  [[nodiscard]] StepResult judge(const StepAnswer&) const override { return scored(1.0); }
};

class WatchWork final : public StepWork {
 public:
  [[nodiscard]] std::optional<Message> missing(const Handed& handed) const override {
    if (handed.watched) return std::nullopt;
    return say<"The expert's scan has not been shown to its end yet.">();
  }
  [[nodiscard]] StepAnswer answerOf(const Handed& handed) const override { return WatchAnswer{handed.watched}; }
  [[nodiscard]] StepResult judge(const StepAnswer& given) const override {
    const auto* answer = std::get_if<WatchAnswer>(&given);
    return scored(answer != nullptr && answer->watched ? 1.0 : 0.0);
  }
};

class SettingsWork final : public StepWork {
 public:
  explicit SettingsWork(SettingsTask task) : task_(std::move(task)) {}

  [[nodiscard]] std::vector<LiveFigure> live() const override {
    std::vector<LiveFigure> figures;
    if (!last()) return figures;
    if (!task_.probes.empty()) figures.push_back({say<"Transducer">(), hasProbe()});
    for (const SettingBand& band : task_.bands) figures.push_back({nameOf(band.setting), isWithin(band)});
    return figures;
  }
  [[nodiscard]] std::optional<Message> missing(const Handed&) const override {
    if (last()) return std::nullopt;
    return noImage();
  }
  [[nodiscard]] StepResult judge(const StepAnswer&) const override {
    StepResult result;
    if (!last()) return result;
    int right = 0, all = 0;
    const auto count = [&](bool good, Message goodText, Message badText) {
      ++all;
      right += good ? 1 : 0;
      result.remarks.push_back({good, good ? std::move(goodText) : std::move(badText)});
    };
    if (!task_.probes.empty())
      count(hasProbe(), say<"The transducer suits the examination.">(), say<"Another transducer suits this examination better.">());
    for (const SettingBand& band : task_.bands) {
      const double value = settingOf(*last(), band.setting).value_or(0.0);
      result.figures.push_back({band.setting, value, band.setting.ends_with("_mm") ? "mm" : "dB"});
      count(isWithin(band), say<"%1 is right.">(nameOf(band.setting)),
            value < band.lowest ? say<"%1 is too low.">(nameOf(band.setting)) : say<"%1 is too high.">(nameOf(band.setting)));
    }
    result.score = all > 0 ? static_cast<double>(right) / all : 1.0;
    return result;
  }

 private:
  static Message nameOf(const std::string& setting) {
    if (setting == "depth_mm") return say<"Depth">();
    if (setting == "gain_db") return say<"Gain">();
    if (setting == "dynamic_range_db") return say<"Dynamic range">();
    return say<"Focus">();
  }
  [[nodiscard]] bool hasProbe() const {
    return std::find(task_.probes.begin(), task_.probes.end(), last()->probe.id) != task_.probes.end();
  }
  [[nodiscard]] bool isWithin(const SettingBand& band) const {
    const auto value = settingOf(*last(), band.setting);
    return value && isWithinRange(*value, band.lowest, band.highest);
  }
  SettingsTask task_;
};

class AnswerWork final : public StepWork {
 public:
  explicit AnswerWork(AnswerTask task) : task_(std::move(task)) {}

  [[nodiscard]] std::optional<Message> missing(const Handed& handed) const override {
    if (task_.options.empty() ? handed.number.has_value() : !handed.chosen.empty()) return std::nullopt;
    return task_.options.empty() ? say<"No number was entered yet.">() : say<"No answer was chosen yet.">();
  }
  [[nodiscard]] StepAnswer answerOf(const Handed& handed) const override {
    if (!task_.options.empty()) return OptionsAnswer{handed.chosen};
    if (handed.number) return NumberAnswer{*handed.number};
    return {};
  }
  [[nodiscard]] StepResult judge(const StepAnswer& answer) const override {
    if (task_.options.empty()) return judgeNumber(answer);
    StepResult result;
    // Every right answer counts, and every wrong one takes one away: choosing all earns nothing.
    std::set<std::size_t> chosenOnes;
    if (const auto* given = std::get_if<OptionsAnswer>(&answer)) chosenOnes.insert(given->chosen.begin(), given->chosen.end());
    int right = 0, wrong = 0, all = 0;
    for (std::size_t n = 0; n < task_.options.size(); ++n) {
      const AnswerOption& option = task_.options[n];
      const bool chosen = chosenOnes.contains(n);
      all += option.right ? 1 : 0;
      right += option.right && chosen ? 1 : 0;
      wrong += !option.right && chosen ? 1 : 0;
      if (chosen && !option.why.empty()) result.remarks.push_back({option.right, verbatim(option.why)});
      if (!chosen && option.right) result.remarks.push_back({false, say<"Right would have been: %1">(verbatim(option.text))});
    }
    result.score = all > 0 ? std::max(0.0, static_cast<double>(right - wrong) / all) : 0.0;
    return result;
  }

 private:
  [[nodiscard]] StepResult judgeNumber(const StepAnswer& answer) const {
    StepResult result;
    const auto* given = std::get_if<NumberAnswer>(&answer);
    if (!task_.number || given == nullptr) return result;
    const double number = given->number, error = number - *task_.number;
    result.figures = {{"error", error, task_.unit}};
    const bool good = isWithinTolerance(number, *task_.number, task_.tolerance);
    result.score = good ? 1.0 : 0.0;
    result.remarks.push_back({good, good ? say<"That is right.">() : say<"It is %1 %2.">(roundedText(*task_.number, 2), task_.unit)});
    return result;
  }
  AnswerTask task_;
};

}  // namespace

Work readWork() { return std::make_unique<ReadingWork>(); }

Work watchWork() { return std::make_unique<WatchWork>(); }

Work settingsWork(const SettingsTask& task) { return std::make_unique<SettingsWork>(task); }

Work answerWork(const AnswerTask& task) { return std::make_unique<AnswerWork>(task); }

}  // namespace ew
