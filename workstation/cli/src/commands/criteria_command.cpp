#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>

#include "ew/core/ending.h"
#include "ew/io/safe_file.h"
#include "ew/library/case.h"
#include "ew/measurement/criteria.h"
#include "ew/reports/message_catalogue.h"
#include "run/arguments.h"
#include "run/command.h"

namespace ew::cli {
namespace {

namespace fs = std::filesystem;
using namespace ew::measurement;

/// An input of the shipped criteria, and the option that gives it.
struct InputOption {
  const char* option;
  const char* input;
  const char* description;
};

constexpr std::array kInputOptions{
    InputOption{"--psv", "PSV", "Peak systolic velocity, of a stenosis its highest"},
    InputOption{"--edv", "EDV", "End-diastolic velocity at the same place"},
    InputOption{"--cca-psv", "CCA_PSV", "Peak systolic velocity of the common carotid artery"},
    InputOption{"--plaque", "PLAQUE", "Plaque of the carotid artery: none or seen"},
    InputOption{"--lumen", "LUMEN", "Lumen of the carotid artery in colour: open, trickle or none"},
    InputOption{"--aorta-psv", "AORTA_PSV", "Peak systolic velocity of the aorta beside the renal arteries"},
    InputOption{"--at", "AT", "Acceleration time within the kidney, in ms"},
    InputOption{"--ai", "AI", "Acceleration index within the kidney, in cm/s2"},
    InputOption{"--ri-difference", "RI_DIFFERENCE", "Difference of the resistive index between the kidneys"},
    InputOption{"--proximal-psv", "PROXIMAL_PSV", "Peak systolic velocity before a stenosis of the leg"},
    InputOption{"--flow", "FLOW", "Flow in the artery of the leg in colour: seen or none"},
    InputOption{"--pi", "PI", "Pulsatility index of the umbilical artery"},
    InputOption{"--end-flow", "END_FLOW", "Flow of the umbilical artery at the end of diastole: present, absent or reversed"}};
constexpr const char* kWeeks = "GA";

struct CriteriaArguments {
  std::map<std::string, std::string> given;  // by inputs
  std::string gestation;
  std::vector<std::string> others;  // NAME=VALUE
  std::string vessel;
  std::vector<std::string> names;
  std::string language = "en";
  std::string json;
};

Result<fs::path> criteriaFolder() {
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  return *resources / "criteria";
}

/// Shipped criteria by their names, or files of some.
Result<std::vector<Criteria>> criteriaNamed(const std::vector<std::string>& names, Run& run) {
  const auto folder = criteriaFolder();
  if (!folder) return passOn(folder.error());
  if (names.empty()) return readAllCriteria(*folder);
  std::vector<Criteria> all;
  for (const std::string& name : names) {
    const fs::path file = hasEnding(name, ".json") ? fs::path(name) : *folder / (name + ".json");
    std::error_code ignored;
    if (!hasEnding(name, ".json") && (name.find('/') != std::string::npos || !fs::exists(file, ignored)))
      return failure(ErrorCode::badUsage, say<"There are no criteria '%1'; 'echoweave criteria' lists those there are.">(name));
    if (auto kept = run.input(file); !kept) return passOn(kept.error());
    auto read = readCriteria(file);
    if (!read) return passOn(read.error());
    all.push_back(std::move(*read));
  }
  return all;
}

std::string optionOf(const std::string& input) {
  if (input == kWeeks) return "--gestation";
  const auto found = std::find_if(kInputOptions.begin(), kInputOptions.end(), [&](const InputOption& each) { return each.input == input; });
  return found == kInputOptions.end() ? "--value " + input : found->option;
}

Result<int> listCriteria(const std::vector<Criteria>& all, const CriteriaArguments& arguments, Run& run) {
  for (const Criteria& criteria : all) {
    run.out() << criteria.id << ": " << criteriaName(criteria.name, criteria.year, arguments.language) << ", "
              << criteria.vesselTitle.in(arguments.language) << " (" << criteria.vessel << ")\n  source: " << criteria.source
              << "\n  checked: " << criteria.status << "\n";
    for (const CriteriaInput& input : criteria.inputs) {
      std::string asked = input.unit == Unit::one ? "" : std::string(symbolOf(input.unit));
      for (const auto& [word, title] : input.choices) asked += (asked.empty() ? "" : "|") + word;
      run.out() << "  " << optionOf(input.name) << (asked.empty() ? "" : ", " + asked) << ": " << input.title.in(arguments.language)
                << "\n";
    }
    run.report.details["criteria"].push_back({{"id", criteria.id},
                                              {"version", criteria.version},
                                              {"name", criteria.name.english},
                                              {"year", criteria.year},
                                              {"vessel", criteria.vessel},
                                              {"source", criteria.source}});
  }
  return kDone;
}

/// What was given, by inputs, as text.
Result<std::map<std::string, std::string>> givenValues(const CriteriaArguments& arguments) {
  std::map<std::string, std::string> given;
  for (const auto& [input, text] : arguments.given)
    if (!text.empty()) given[input] = text;
  if (!arguments.gestation.empty()) given[kWeeks] = arguments.gestation;
  for (const std::string& other : arguments.others) {
    const auto equals = other.find('=');
    if (equals == std::string::npos || equals == 0)
      return failure(ErrorCode::badUsage, say<"--value %1 has no name; write it as in PSV=150.">(other));
    given[other.substr(0, equals)] = other.substr(equals + 1);
  }
  return given;
}

Result<CriteriaValue> valueIn(const std::string& text, const CriteriaInput& input) {
  if (!input.choices.empty()) return CriteriaValue{{}, text};
  if (input.unit == Unit::weeks)
    if (const auto weeks = gestationOf(text)) return CriteriaValue{{*weeks, 0.0, Unit::weeks}, {}};
  auto quantity = quantityOf(text);
  if (!quantity || (input.unit == Unit::weeks && quantity->unit == Unit::one))
    return failure(ErrorCode::badUsage, say<"%1 '%2' cannot be read; write it as in 150, 150+-10cm/s or, of a gestational age, 28w0d.">(
                                            optionOf(input.name), text));
  if (quantity->unit == Unit::one) quantity->unit = input.unit;
  return CriteriaValue{*quantity, {}};
}

/// Those that take every value that was given, of one vessel.
Result<std::vector<Criteria>> criteriaFor(std::vector<Criteria> all, const std::map<std::string, std::string>& given) {
  std::erase_if(all, [&](const Criteria& criteria) {
    return std::any_of(given.begin(), given.end(), [&](const auto& each) { return criteria.input(each.first) == nullptr; });
  });
  if (all.empty())
    return failure(ErrorCode::badUsage, say<"No criteria take all these values together; 'echoweave criteria' lists what each takes.">());
  std::set<std::string> vessels;
  std::string listed;
  for (const Criteria& criteria : all)
    if (vessels.insert(criteria.vessel).second) listed += (listed.empty() ? "" : ", ") + criteria.vessel;
  if (vessels.size() > 1)
    return failure(ErrorCode::badUsage, say<"These values fit criteria of several vessels; name one of %1 with --vessel.">(listed));
  return all;
}

Result<int> gradeValues(const CriteriaArguments& arguments, const std::vector<Criteria>& all,
                        const std::map<std::string, std::string>& given, Run& run) {
  const auto fitting = criteriaFor(all, given);
  if (!fitting) return passOn(fitting.error());
  if (!arguments.json.empty())
    if (auto announced = run.output(arguments.json, ".json"); !announced) return passOn(announced.error());
  std::vector<Grade> grades;
  for (const Criteria& criteria : *fitting) {
    CriteriaValues values;
    for (const auto& [name, text] : given) {
      auto value = valueIn(text, *criteria.input(name));
      if (!value) return passOn(value.error());
      values[name] = std::move(*value);
    }
    auto grade = gradeOf(criteria, values);
    if (!grade) return passOn(grade.error());
    grades.push_back(std::move(*grade));
  }
  nlohmann::ordered_json document = {{"format", 1}, {"notice", kTrainingOnly}, {"grades", nlohmann::ordered_json::array()}};
  for (const Grade& grade : grades) document["grades"].push_back(toJson(grade, arguments.language));
  for (const Message& each : differencesOf(grades, arguments.language)) document["differences"].push_back(each.english());
  run.report.details["graded"] = document;
  run.report.quality = {{"criteria", grades.size()},
                        {"graded", std::count_if(grades.begin(), grades.end(), [](const Grade& each) { return !each.word.empty(); })}};
  if (!arguments.json.empty()) {
    if (auto written = writeFileSafely(run.outputs.staged(arguments.json), document.dump(2) + "\n"); !written)
      return passOn(written.error());
    run.say("Wrote " + arguments.json + ".");
    return kDone;
  }
  const auto catalogue = MessageCatalogue::ofLanguage(arguments.language);
  if (!catalogue) return passOn(catalogue.error());
  run.out() << kTrainingOnly << "\n";
  for (const Grade& grade : grades)
    for (const Message& sentence : sentencesOf(grade, arguments.language)) run.out() << catalogue->words(sentence) << "\n";
  for (const Message& sentence : differencesOf(grades, arguments.language)) run.out() << catalogue->words(sentence) << "\n";
  return kDone;
}

Result<int> listOrGrade(const CriteriaArguments& arguments, Run& run) {
  auto all = criteriaNamed(arguments.names, run);
  if (!all) return passOn(all.error());
  std::erase_if(*all, [&](const Criteria& each) { return !arguments.vessel.empty() && each.vessel != arguments.vessel; });
  if (all->empty())
    return failure(ErrorCode::badUsage,
                   say<"There are no criteria of '%1'; 'echoweave criteria' lists the vessels in brackets.">(arguments.vessel));
  const auto given = givenValues(arguments);
  if (!given) return passOn(given.error());
  if (!given->empty()) return gradeValues(arguments, *all, *given, run);
  if (!arguments.json.empty()) return failure(ErrorCode::badUsage, say<"--json writes grades; give the values to grade, too.">());
  return listCriteria(*all, arguments, run);
}

}  // namespace

void addCriteria(CLI::App& root, Selection& selection) {
  auto arguments = std::make_shared<CriteriaArguments>();
  auto& app =
      addCommand(root, selection, "criteria", "List the criteria by which vessels are graded, or grade values by them, side by side",
                 {"criteria", "criteria --psv 150 --cca-psv 90", "criteria --vessel internal_carotid --psv 100 --plaque seen",
                  "criteria --criteria umbilical-pi --pi 1.4 --gestation 28w0d --end-flow present --json cord.json"},
                 [arguments](Run& run) { return listOrGrade(*arguments, run); });
  for (const InputOption& each : kInputOptions)
    app.add_option(each.option, arguments->given[each.input], each.description)->type_name("VALUE");
  app.add_option("--gestation", arguments->gestation, "Gestational age by dates: 28w0d or 28+0")->type_name("WEEKS");
  app.add_option("--value", arguments->others, "A value of criteria of one's own by its name, as often as there are: PSV=150+-10cm/s")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  app.add_option("--vessel", arguments->vessel, "Only criteria of this vessel")->type_name("VESSEL");
  app.add_option("--criteria", arguments->names, "Shipped criteria by name, or the .json file of some; as often as there are (all)")
      ->type_name("NAME|FILE.json")
      ->allow_extra_args(false);
  app.add_option("--language", arguments->language, "Of what is said: en or de (en)")
      ->check(CLI::IsMember({"en", "de"}))
      ->type_name("LANGUAGE");
  app.add_option("--json", arguments->json, "Write the grades as JSON")->type_name("OUT.json");
}

}  // namespace ew::cli
