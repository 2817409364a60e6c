#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ew/library/index.h"
#include "temporary_folder.h"

namespace ew::test {

/// The manifest of a case whose title names the finding.
inline nlohmann::json gallStone() {
  return {{"format", 2},
          {"id", "gall-stone"},
          {"title", "Solitary gall stone"},
          {"title_for_trainees", "Pain after meals"},
          {"region", "upper abdomen"},
          {"indication", "Übelkeit and colic"},
          {"history", "Fasting since yesterday."},
          {"diagnosis", "Cholecystolithiasis"},
          {"findings", {"One stone with an acoustic shadow"}},
          {"differential", {"Polyp"}},
          {"difficulty", 3},
          {"tags", {"biliary", "emergency"}},
          {"volume", {{"file", "volume.mha"}}},
          {"parts",
           {{"lessons",
             {{"format", 1},
              {"lessons",
               {{{"id", "look"},
                 {"title", "A first look"},
                 {"aim", "Name the liver"},
                 {"level", 2},
                 {"minutes", 15},
                 {"steps", {{{"id", "a"}}, {{"id", "b"}}}}},
                {{"id", "measure"}, {"title", "Measuring"}, {"level", 4}, {"steps", nlohmann::json::array()}}}}}}}}};
}

inline nlohmann::json plainCase(const std::string& id, const std::string& title) {
  return {{"format", 2}, {"id", id}, {"title", title}, {"volume", {{"file", "volume.mha"}}}};
}

inline void writeManifest(const std::filesystem::path& folder, const nlohmann::json& manifest) {
  writeText(folder / "case.json", manifest.dump(2));
}

/// Titles that are found, in their order.
inline std::vector<std::string> titles(LibraryIndex& index, const CaseQuery& query) {
  const auto page = search(index, query, 0, 100000);
  std::vector<std::string> all;
  if (!page) return {page.error().sentence()};
  for (const CaseRow& row : page->rows) all.push_back(row.title);
  return all;
}
inline std::vector<std::string> titles(LibraryIndex& index, const std::string& words, bool forTrainees = true) {
  CaseQuery query;
  query.words = words;
  query.forTrainees = forTrainees;
  return titles(index, query);
}

}  // namespace ew::test
