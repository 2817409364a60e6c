#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "ew/library/index.h"
#include "index_library.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

/// All that an index says, without the numbers, which are its own.
struct Said {
  std::vector<CaseRow> forTrainees, forAuthors, found;
  CaseChoices choices;
  std::vector<CaseProblem> problems;
  bool operator==(const Said&) const = default;
};

Said saidBy(LibraryIndex& index) {
  const auto rowsOf = [&](bool forTrainees, const std::string& words) {
    CaseQuery query;
    query.words = words;
    query.forTrainees = forTrainees;
    auto rows = search(index, query, 0, 100000)->rows;
    for (CaseRow& row : rows) row.number = 0;
    // Cases of one title come in the order of their numbers.
    std::stable_sort(rows.begin(), rows.end(), [](const CaseRow& a, const CaseRow& b) { return a.folder < b.folder; });
    return rows;
  };
  return {rowsOf(true, ""), rowsOf(false, ""), rowsOf(false, "liv"), *index.choices(), *index.problems()};
}

nlohmann::json anyManifest() {
  nlohmann::json manifest = test::plainCase("case-" + std::to_string(*rc::gen::inRange(0, 5)),
                                            *rc::gen::element<std::string>("Liver", "Livid", "Kidney", "Ärger", "x"));
  if (*rc::gen::arbitrary<bool>()) manifest["title_for_trainees"] = *rc::gen::element<std::string>("Pain", "Living well");
  if (*rc::gen::arbitrary<bool>()) manifest["region"] = *rc::gen::element<std::string>("neck", "abdomen");
  if (*rc::gen::arbitrary<bool>()) manifest["difficulty"] = *rc::gen::inRange(0, 7);
  if (*rc::gen::arbitrary<bool>())
    manifest["tags"] = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>("a", "b", "liver"));
  if (*rc::gen::arbitrary<bool>())
    manifest["parts"]["lessons"]["lessons"] = {
        {{"id", "l"}, {"title", *rc::gen::element<std::string>("Liver lesson", "Other")}, {"level", *rc::gen::inRange(1, 6)}}};
  return manifest;
}

/// Adds, changes, breaks or removes a case somewhere.
void changeSomething(const fs::path& library) {
  const std::string name = std::to_string(*rc::gen::inRange(0, 6));
  const std::string place = *rc::gen::element<std::string>("shipped/", "own/", "published/a/", "published/b/");
  const fs::path folder = library / (place + name);
  switch (*rc::gen::inRange(0, 5)) {
    case 0:
      fs::remove_all(folder);
      break;
    case 1:
      test::writeText(folder / "case.json", "{ broken");
      break;
    default:
      test::writeManifest(folder, anyManifest());
  }
}

RC_GTEST_PROP(LibraryIndexProperty, RefreshingStepByStepIsReadingAllAnew, ()) {
  const test::TemporaryFolder folder;
  const std::vector<LibraryRoot> roots = {
      {folder / "shipped", LibraryKind::shipped}, {folder / "own", LibraryKind::own}, {folder / "published", LibraryKind::published}};
  auto kept = openIndex(folder / "kept.index");
  RC_ASSERT(kept.has_value());
  const int rounds = *rc::gen::inRange(1, 6);
  for (int round = 0; round < rounds; ++round) {
    const int changes = *rc::gen::inRange(0, 8);
    for (int n = 0; n < changes; ++n) changeSomething(folder.path());
    RC_ASSERT((*kept)->refresh(roots, noProgress()).has_value());
    if (*rc::gen::arbitrary<bool>()) {  // another start of the program
      kept->reset();
      kept = openIndex(folder / "kept.index");
    }
    auto anew = openIndex({});
    RC_ASSERT((*anew)->refresh(roots, noProgress()).has_value());
    RC_ASSERT(saidBy(**kept) == saidBy(**anew));
  }
}

}  // namespace
}  // namespace ew
