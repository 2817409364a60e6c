#include "publishing/real_names.h"

#include <algorithm>
#include <array>

#include "ew/library/real_looking.h"
#include "files/text_pieces.h"

namespace ew {
namespace {

using namespace std::string_view_literals;

// In small letters; sorted.
constexpr std::array kGivenNames = {
    "alexander"sv, "andreas"sv,   "angela"sv,    "anna"sv,        "anne"sv,      "anthony"sv, "barbara"sv,  "birgit"sv,  "brian"sv,
    "carol"sv,     "charles"sv,   "christian"sv, "christopher"sv, "claudia"sv,   "daniel"sv,  "david"sv,    "deborah"sv, "dennis"sv,
    "donald"sv,    "elisabeth"sv, "elizabeth"sv, "emily"sv,       "emma"sv,      "erika"sv,   "eva"sv,      "frank"sv,   "gabriele"sv,
    "george"sv,    "gerhard"sv,   "hans"sv,      "heike"sv,       "heinz"sv,     "helga"sv,   "helmut"sv,   "ingrid"sv,  "jack"sv,
    "james"sv,     "jan"sv,       "jane"sv,      "jennifer"sv,    "jessica"sv,   "joachim"sv, "johannes"sv, "john"sv,    "joseph"sv,
    "julia"sv,     "karen"sv,     "karin"sv,     "karl"sv,        "katharina"sv, "kevin"sv,   "klaus"sv,    "laura"sv,   "linda"sv,
    "lisa"sv,      "lukas"sv,     "manfred"sv,   "margaret"sv,    "maria"sv,     "mark"sv,    "markus"sv,   "martin"sv,  "mary"sv,
    "matthias"sv,  "max"sv,       "michael"sv,   "monika"sv,      "nancy"sv,     "nicole"sv,  "patricia"sv, "paul"sv,    "peter"sv,
    "petra"sv,     "renate"sv,    "richard"sv,   "robert"sv,      "sabine"sv,    "sandra"sv,  "sarah"sv,    "sophie"sv,  "stefan"sv,
    "stefanie"sv,  "steven"sv,    "susan"sv,     "susanne"sv,     "thomas"sv,    "ursula"sv,  "uwe"sv,      "werner"sv,  "william"sv,
    "wolfgang"sv};
constexpr std::array kFamilyNames = {"allen"sv,
                                     "anderson"sv,
                                     "bauer"sv,
                                     "becker"sv,
                                     "brown"sv,
                                     "clark"sv,
                                     "davies"sv,
                                     "davis"sv,
                                     "doe"sv,
                                     "evans"sv,
                                     "fischer"sv,
                                     "fuchs"sv,
                                     "garcia"sv,
                                     "hall"sv,
                                     "harris"sv,
                                     "hartmann"sv,
                                     "hoffmann"sv,
                                     "hofmann"sv,
                                     "jackson"sv,
                                     "johnson"sv,
                                     "jones"sv,
                                     "kaiser"sv,
                                     "klein"sv,
                                     "koch"sv,
                                     "koenig"sv,
                                     "krause"sv,
                                     "kr\xC3\xBCger"sv,
                                     "lang"sv,
                                     "lange"sv,
                                     "lehmann"sv,
                                     "lewis"sv,
                                     "maier"sv,
                                     "martinez"sv,
                                     "mayer"sv,
                                     "meier"sv,
                                     "meyer"sv,
                                     "miller"sv,
                                     "moore"sv,
                                     "m\xC3\xBCller"sv,
                                     "mueller"sv,
                                     "mustermann"sv,
                                     "neumann"sv,
                                     "peters"sv,
                                     "richter"sv,
                                     "roberts"sv,
                                     "robinson"sv,
                                     "sch\xC3\xA4"
                                     "fer"sv,
                                     "schmid"sv,
                                     "schmidt"sv,
                                     "schmitt"sv,
                                     "schneider"sv,
                                     "schr\xC3\xB6"
                                     "der"sv,
                                     "schulz"sv,
                                     "schulze"sv,
                                     "schwarz"sv,
                                     "smith"sv,
                                     "taylor"sv,
                                     "thompson"sv,
                                     "wagner"sv,
                                     "walker"sv,
                                     "weber"sv,
                                     "werner"sv,
                                     "white"sv,
                                     "williams"sv,
                                     "wilson"sv,
                                     "wolf"sv,
                                     "wright"sv,
                                     "zimmermann"sv};

template <std::size_t N>
bool isAmong(const std::array<std::string_view, N>& names, std::string_view word) {
  return std::find(names.begin(), names.end(), inSmallLetters(word)) != names.end();
}

// Syllables of nobody's names, made up for this program.
constexpr std::array kGivenStarts = {"El"sv,  "Mav"sv, "Tha"sv, "Or"sv,  "Lin"sv, "Ves"sv,
                                     "Cae"sv, "Dor"sv, "Fen"sv, "Ily"sv, "Jor"sv, "Ny"sv};
constexpr std::array kFemaleEnds = {"wena"sv, "isa"sv, "ora"sv, "ella"sv, "ina"sv, "etta"sv, "iri"sv, "aly"sv};
constexpr std::array kMaleEnds = {"wen"sv, "ick"sv, "orn"sv, "ell"sv, "in"sv, "et"sv, "mar"sv, "das"sv};
constexpr std::array kFamilyStarts = {"Tarn"sv, "Wex"sv,  "Quill"sv, "Osp"sv, "Vell"sv,  "Drim"sv,
                                      "Yarl"sv, "Zenn"sv, "Phar"sv,  "Umb"sv, "Gliss"sv, "Kessel"sv};
constexpr std::array kEnglishEnds = {"more"sv, "wick"sv, "sby"sv, "combe"sv, "dale"sv, "thorpe"sv, "hurst"sv, "mere"sv};
constexpr std::array kGermanEnds = {"brink"sv, "moor"sv, "stett"sv, "rode"sv, "inger"sv, "hauser"sv, "loh"sv, "wang"sv};

/// SplitMix64 (Steele, Lea, Flood, OOPSLA 2014).
std::uint64_t mixed(std::uint64_t& state) {
  state += 0x9E3779B97F4A7C15ull;
  std::uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

template <std::size_t N>
std::string oneOf(const std::array<std::string_view, N>& all, std::uint64_t& state) {
  return std::string(all[mixed(state) % N]);
}

}  // namespace

bool isCommonGivenName(std::string_view word) { return isAmong(kGivenNames, word); }
bool isCommonFamilyName(std::string_view word) { return isAmong(kFamilyNames, word); }

std::string inventedName(std::uint64_t seed, std::string_view language, std::string_view sex) {
  std::uint64_t state = seed;
  const bool isFemale = sex == "female" || (sex != "male" && mixed(state) % 2 == 0);
  const std::string given = oneOf(kGivenStarts, state) + (isFemale ? oneOf(kFemaleEnds, state) : oneOf(kMaleEnds, state));
  const std::string start = oneOf(kFamilyStarts, state);
  return given + " " + start + (language.starts_with("de") ? oneOf(kGermanEnds, state) : oneOf(kEnglishEnds, state));
}

}  // namespace ew
