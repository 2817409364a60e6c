#include "ew/library/real_looking.h"

#include <algorithm>
#include <array>
#include <initializer_list>

#include "files/text_pieces.h"
#include "publishing/real_names.h"

namespace ew {
namespace {

using Kind = TextPiece::Kind;
using namespace std::string_view_literals;

bool isAnyOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

constexpr std::array kMonths = {"January"sv,     "February"sv,  "March"sv,   "April"sv,    "May"sv,      "June"sv,     "July"sv,
                                "August"sv,      "September"sv, "October"sv, "November"sv, "December"sv, "Januar"sv,   "Februar"sv,
                                "M\xC3\xA4rz"sv, "Mai"sv,       "Juni"sv,    "Juli"sv,     "Oktober"sv,  "Dezember"sv, "Jan"sv,
                                "Feb"sv,         "Mar"sv,       "Apr"sv,     "Jun"sv,      "Jul"sv,      "Aug"sv,      "Sep"sv,
                                "Sept"sv,        "Oct"sv,       "Okt"sv,     "Nov"sv,      "Dec"sv,      "Dez"sv};

/// What each rule finds: from one piece to another, and the warning.
struct Found {
  std::size_t first = 0;
  std::size_t last = 0;  // included
  Message (*text)(std::string) = nullptr;
};

Message dateText(std::string found) {
  return say<"'%1' looks like the date of a real examination; write how long ago it was.">(std::move(found));
}
Message birthText(std::string found) { return say<"'%1' looks like a date of birth; give an age instead.">(std::move(found)); }
Message phoneText(std::string found) { return say<"'%1' looks like a telephone number; leave it out.">(std::move(found)); }
Message numberText(std::string found) {
  return say<"'%1' looks like the number of a patient, an insurance or an examination; leave it out.">(std::move(found));
}
Message addressText(std::string found) { return say<"'%1' looks like an address; leave it out.">(std::move(found)); }
Message nameText(std::string found) {
  return say<"'%1' looks like the name of a real person; write an invented one, or none.">(std::move(found));
}
Message hospitalText(std::string found) { return say<"'%1' looks like a real hospital; write \"another hospital\".">(std::move(found)); }

/// Rules over the pieces of one text; each looks at what begins at piece n.
class Rules {
 public:
  explicit Rules(std::string_view text) : pieces_(piecesOf(text)) {}

  [[nodiscard]] const std::vector<TextPiece>& pieces() const { return pieces_; }

  [[nodiscard]] std::vector<Found> all() const {
    std::vector<Found> found;
    constexpr std::array rules = {&Rules::birth,  &Rules::dateOfNumbers, &Rules::dateOfWords, &Rules::keyedNumber,
                                  &Rules::phone,  &Rules::longNumber,    &Rules::mail,        &Rules::street,
                                  &Rules::titled, &Rules::named,         &Rules::hospital};
    for (std::size_t n = 0; n < pieces_.size(); ++n)
      for (const auto rule : rules)
        if (const std::size_t last = (this->*rule)(n, found); last != kNothing) {
          n = last;
          break;
        }
    return found;
  }

 private:
  static constexpr std::size_t kNothing = static_cast<std::size_t>(-1);

  [[nodiscard]] bool isDigits(std::size_t n) const { return n < pieces_.size() && pieces_[n].kind == Kind::digits; }
  [[nodiscard]] bool isWord(std::size_t n) const { return n < pieces_.size() && pieces_[n].kind == Kind::word; }
  [[nodiscard]] bool isMark(std::size_t n, std::string_view mark) const {
    return n < pieces_.size() && pieces_[n].kind == Kind::mark && pieces_[n].is(mark);
  }
  [[nodiscard]] bool isName(std::size_t n) const { return isWord(n) && pieces_[n].text.size() > 2 && isCapitalised(pieces_[n].text); }
  [[nodiscard]] bool isYear(std::size_t n) const {
    return isDigits(n) && pieces_[n].text.size() == 4 && valueOf(pieces_[n]) >= 1900 && valueOf(pieces_[n]) <= 2100;
  }
  [[nodiscard]] bool isDay(std::size_t n) const {
    return isDigits(n) && pieces_[n].text.size() <= 2 && valueOf(pieces_[n]) >= 1 && valueOf(pieces_[n]) <= 31;
  }
  [[nodiscard]] bool isMonth(std::size_t n) const {
    return isWord(n) && std::find(kMonths.begin(), kMonths.end(), pieces_[n].text) != kMonths.end();
  }
  static std::size_t tell(std::vector<Found>& found, std::size_t first, std::size_t last, Message (*text)(std::string)) {
    found.push_back({first, last, text});
    return last;
  }

  /// 12.03.2019, 12/3/19, 2019-03-12: day, month and year in any order, with one kind of mark between them.
  [[nodiscard]] std::size_t lastOfNumberDate(std::size_t n) const {
    if (!isDigits(n) || !isDigits(n + 2) || !isDigits(n + 4) || pieces_[n + 1].text != pieces_[n + 3].text) return kNothing;
    const std::string_view mark = pieces_[n + 1].text;
    if (!isAnyOf(mark, {".", "/", "-"}) || pieces_[n + 1].isApart || pieces_[n + 3].isApart) return kNothing;
    if (mark != "." && (pieces_[n + 2].isApart || pieces_[n + 4].isApart)) return kNothing;
    const bool yearFirst = isYear(n) && isDay(n + 2) && isDay(n + 4);
    const bool yearLast =
        isDay(n) && isDay(n + 2) && (isYear(n + 4) || (pieces_[n + 4].text.size() == 2 && pieces_[n + 2].text.size() == 2));
    const long a = valueOf(pieces_[yearFirst ? n + 2 : n]), b = valueOf(pieces_[yearFirst ? n + 4 : n + 2]);
    return (yearFirst || yearLast) && std::min(a, b) <= 12 ? n + 4 : kNothing;
  }
  [[nodiscard]] std::size_t dateOfNumbers(std::size_t n, std::vector<Found>& found) const {
    if (const std::size_t last = lastOfNumberDate(n); last != kNothing) return tell(found, n, last, dateText);
    // "am 03.05.": a day without its year, which a decimal number never looks like after these words.
    if (isWord(n) && isAnyOf(inSmallLetters(pieces_[n].text), {"am", "vom", "seit", "bis", "zum"}) && isDay(n + 1) && isMark(n + 2, ".") &&
        isDay(n + 3) && isMark(n + 4, ".") && !pieces_[n + 3].isApart)
      return tell(found, n + 1, n + 4, dateText);
    // 20190312
    if (isDigits(n) && pieces_[n].text.size() == 8) {
      const long value = valueOf(pieces_[n]);
      if (value / 10000 >= 1900 && value / 10000 <= 2100 && value / 100 % 100 >= 1 && value / 100 % 100 <= 12 && value % 100 >= 1 &&
          value % 100 <= 31)
        return tell(found, n, n, dateText);
    }
    return kNothing;
  }

  [[nodiscard]] std::size_t lastOfWordDate(std::size_t n) const {
    if (isDay(n)) {  // "12 March", "3rd of May 2019", "12. März 2019"
      std::size_t at = n + 1;
      if (isMark(at, ".")) ++at;
      if (isWord(at) && isAnyOf(pieces_[at].text, {"st", "nd", "rd", "th"}) && !pieces_[at].isApart) ++at;
      if (isWord(at) && pieces_[at].is("of")) ++at;
      if (!isMonth(at)) return kNothing;
      const std::size_t year = isMark(at + 1, ".") || isMark(at + 1, ",") ? at + 2 : at + 1;
      return isYear(year) ? year : at;
    }
    if (!isMonth(n)) return kNothing;
    std::size_t at = isMark(n + 1, ".") ? n + 2 : n + 1;
    if (isYear(at)) return at;  // "March 2019"
    if (!isDay(at)) return kNothing;
    if (isWord(at + 1) && isAnyOf(pieces_[at + 1].text, {"st", "nd", "rd", "th"}) && !pieces_[at + 1].isApart) ++at;
    const std::size_t year = isMark(at + 1, ",") ? at + 2 : at + 1;  // "March 12, 2019"
    return isYear(year) ? year : at;
  }
  [[nodiscard]] std::size_t dateOfWords(std::size_t n, std::vector<Found>& found) const {
    const std::size_t last = lastOfWordDate(n);
    return last == kNothing ? kNothing : tell(found, n, last, dateText);
  }

  [[nodiscard]] std::size_t birth(std::size_t n, std::vector<Found>& found) const {
    if (!isWord(n) || !isAnyOf(inSmallLetters(pieces_[n].text), {"born", "dob", "geb", "geboren", "geburtsdatum", "birthday"}))
      return kNothing;
    std::size_t at = n + 1;
    while (at < std::min(n + 4, pieces_.size()) && !isDigits(at) && !isMonth(at)) ++at;
    if (const std::size_t last = lastOfNumberDate(at); last != kNothing) return tell(found, n, last, birthText);
    if (const std::size_t last = lastOfWordDate(at); last != kNothing) return tell(found, n, last, birthText);
    return isYear(at) ? tell(found, n, at, birthText) : kNothing;
  }

  /// "MRN: 12345", "Fallnummer 2019-4711", "Tel. 4711": a word that announces a number, and digits soon after it.
  [[nodiscard]] std::size_t keyedNumber(std::size_t n, std::vector<Found>& found) const {
    if (!isWord(n)) return kNothing;
    const std::string word = inSmallLetters(pieces_[n].text);
    const bool isPhone = isAnyOf(word, {"tel", "telefon", "telephone", "phone", "fax", "mobile", "handy", "mobil"});
    const bool isNumber = isAnyOf(word, {"mrn", "accession", "fallnummer", "patientennummer", "versichertennummer", "versicherungsnummer",
                                         "aktenzeichen", "auftragsnummer", "ssn", "nhs", "pid"}) ||
                          (isAnyOf(word, {"id", "number", "no", "nummer", "nr"}) && n > 0 && isWord(n - 1) &&
                           isAnyOf(inSmallLetters(pieces_[n - 1].text),
                                   {"patient", "insurance", "case", "record", "hospital", "study", "patienten", "fall", "versicherten"}));
    if (!isPhone && !isNumber) return kNothing;
    std::size_t at = n + 1;
    while (at < std::min(n + 4, pieces_.size()) && !isDigits(at)) ++at;
    if (!isDigits(at)) return kNothing;
    std::size_t last = at, digits = pieces_[at].text.size();
    while ((isDigits(last + 1) ||
            (isDigits(last + 2) && pieces_[last + 1].kind == Kind::mark && isAnyOf(pieces_[last + 1].text, {"-", "/", "."})))) {
      last += isDigits(last + 1) ? 1 : 2;
      digits += pieces_[last].text.size();
    }
    return digits >= 3 ? tell(found, n, last, isPhone ? phoneText : numberText) : kNothing;
  }

  /// Groups of digits with blanks, hyphens, slashes or brackets: +49 30 1234567, (030) 123 4567, 555-123-4567, 943 476 5919, 078-05-1120.
  [[nodiscard]] std::size_t phone(std::size_t n, std::vector<Found>& found) const {
    const bool isOpened = isMark(n, "(") || isMark(n, "+");
    const std::size_t first = isOpened ? n + 1 : n;
    if (!isDigits(first) || (isOpened && pieces_[first].isApart)) return kNothing;
    if (n > 0 && !isOpened && pieces_[n - 1].kind != Kind::word && !pieces_[n].isApart) return kNothing;
    std::vector<std::size_t> groups = {pieces_[first].text.size()};
    std::size_t last = first;
    while (true) {
      std::size_t next = last + 1;
      while (next < pieces_.size() && pieces_[next].kind == Kind::mark && isAnyOf(pieces_[next].text, {"-", "/", ")", "("}) &&
             next < last + 3)
        ++next;
      if (!isDigits(next)) break;
      last = next;
      groups.push_back(pieces_[last].text.size());
    }
    std::size_t digits = 0;
    for (const std::size_t each : groups) digits += each;
    const bool isDialled = isMark(n, "+") || isMark(n, "(") || pieces_[first].text.front() == '0';
    const bool isGrouped = groups == std::vector<std::size_t>{3, 3, 4} || groups == std::vector<std::size_t>{3, 2, 4};
    if ((isDialled && digits >= 8 && groups.size() >= 2 && pieces_[first].text.size() >= 2) || isGrouped)
      return tell(found, n, last, isGrouped && !isDialled && groups[1] == 2 ? numberText : phoneText);
    return kNothing;
  }

  /// Seven digits and more; six, unless a unit follows that says so many are in something.
  [[nodiscard]] std::size_t longNumber(std::size_t n, std::vector<Found>& found) const {
    if (!isDigits(n) || pieces_[n].text.size() < 6) return kNothing;
    if (n > 1 && isMark(n - 1, ".") && isDigits(n - 2) && !pieces_[n].isApart) return kNothing;  // decimals
    const bool hasUnit =
        isMark(n + 1, "/") || isMark(n + 1, "%") ||
        (isWord(n + 1) && isAnyOf(inSmallLetters(pieces_[n + 1].text), {"per", "pro", "je", "ng", "pg", "u", "iu", "ie", "hz", "mg"}));
    if (hasUnit && pieces_[n].text.size() < 8) return kNothing;
    return tell(found, n, n, numberText);
  }

  [[nodiscard]] std::size_t mail(std::size_t n, std::vector<Found>& found) const {
    if (isWord(n) && isAnyOf(pieces_[n].text, {"http", "https", "www"}) && (isMark(n + 1, ":") || isMark(n + 1, ".")) &&
        n + 2 < pieces_.size() && !pieces_[n + 2].isApart) {
      std::size_t last = n + 2;
      while (last + 1 < pieces_.size() && !pieces_[last + 1].isApart) ++last;
      return tell(found, n, last, addressText);
    }
    if (!isWord(n) && !isDigits(n)) return kNothing;
    std::size_t at = n;
    while (at + 1 < pieces_.size() && !pieces_[at + 1].isApart && !isMark(at + 1, "@") && at < n + 8) ++at;
    if (!isMark(at + 1, "@") || pieces_[at + 1].isApart || !isWord(at + 2) || pieces_[at + 2].isApart) return kNothing;
    std::size_t last = at + 2;
    while (last + 1 < pieces_.size() && !pieces_[last + 1].isApart) ++last;
    return tell(found, n, last, addressText);
  }

  [[nodiscard]] std::size_t street(std::size_t n, std::vector<Found>& found) const {
    if (isWord(n)) {
      const std::string word = inSmallLetters(pieces_[n].text);
      const bool isStreet = word.ends_with(
                                "stra\xC3\x9F"
                                "e") ||
                            word.ends_with("strasse");
      if (isStreet && isDigits(n + 1)) return tell(found, n, n + 1, addressText);
      if (word.ends_with("str") && word.size() > 4 && isCapitalised(pieces_[n].text) && isMark(n + 1, ".") && isDigits(n + 2))
        return tell(found, n, n + 2, addressText);
    }
    if (isDigits(n) && isName(n + 1) && isWord(n + 2) && isAnyOf(pieces_[n + 2].text, {"Street", "Road", "Avenue", "Lane", "Drive"}))
      return tell(found, n, n + 2, addressText);
    return kNothing;
  }

  [[nodiscard]] std::size_t titled(std::size_t n, std::vector<Found>& found) const {
    if (!isWord(n) ||
        !isAnyOf(pieces_[n].text, {"Dr", "Prof", "Professor", "Doctor", "Doktor", "Mr", "Mrs", "Ms", "Herr", "Herrn", "Frau"}))
      return kNothing;
    std::size_t at = n + 1;
    while (at < pieces_.size() && (isMark(at, ".") || (isWord(at) && isAnyOf(pieces_[at].text, {"Dr", "med", "Prof"})))) ++at;
    if (!isName(at) || isAnyOf(pieces_[at].text, {"Mitte", "Anfang", "Ende", "Doktor", "Professor", "Doppler"}) || isMonth(at))
      return kNothing;
    // "Die Frau. Sie ...": a sentence that ends.
    if (isAnyOf(pieces_[n].text, {"Herr", "Herrn", "Frau", "Doctor", "Doktor", "Professor"}) && isMark(n + 1, ".")) return kNothing;
    return tell(found, n, at, nameText);
  }

  /// "John Smith", "Smith, John", "SMITH^JOHN".
  [[nodiscard]] std::size_t named(std::size_t n, std::vector<Found>& found) const {
    if (!isWord(n)) return kNothing;
    if (isMark(n + 1, "^") && isWord(n + 2) && !pieces_[n + 1].isApart) return tell(found, n, n + 2, nameText);
    if (!isCapitalised(pieces_[n].text)) return kNothing;
    const std::size_t second = isMark(n + 1, ",") ? n + 2 : n + 1;
    if (!isName(second)) return kNothing;
    const std::string_view a = pieces_[n].text, b = pieces_[second].text;
    const bool inOrder = second == n + 1 && isCommonGivenName(a) && isCommonFamilyName(b);
    const bool isTurned = second == n + 2 && isCommonFamilyName(a) && isCommonGivenName(b);
    return inOrder || isTurned ? tell(found, n, second, nameText) : kNothing;
  }

  [[nodiscard]] std::size_t hospital(std::size_t n, std::vector<Found>& found) const {
    if (!isWord(n) || !isCapitalised(pieces_[n].text)) return kNothing;
    const std::string word = inSmallLetters(pieces_[n].text);
    if (word.ends_with("klinikum") || word == "krankenhaus" || word == "klinik" || word == "charit\xC3\xA9") {
      if (word.starts_with("charit")) return tell(found, n, n, hospitalText);
      const std::size_t at = isWord(n + 1) && isAnyOf(pieces_[n + 1].text, {"St", "Sankt"}) ? (isMark(n + 2, ".") ? n + 3 : n + 2) : n + 1;
      if (isName(at) && pieces_[at].isApart) return tell(found, n, at, hospitalText);
    }
    const bool isPlain =
        isAnyOf(pieces_[n].text, {"The", "A", "In", "At", "Our", "Their", "This", "From", "To", "Another", "Other", "Any"});
    std::size_t at = n + 1;
    if (isMark(at, "'")) at += 2;
    while (isName(at) && at < n + 4 && !isAnyOf(pieces_[at].text, {"Hospital", "Clinic", "Infirmary"})) ++at;
    if (!isPlain && pieces_[n].text.size() > 1 && isWord(at) && at > n && isAnyOf(pieces_[at].text, {"Hospital", "Clinic", "Infirmary"}))
      return tell(found, n, at, hospitalText);
    return kNothing;
  }

  std::vector<TextPiece> pieces_;
};

}  // namespace

std::vector<RealLooking> realLookingIn(std::string_view text, const std::string& field) {
  const Rules rules(text);
  std::vector<RealLooking> all;
  for (const Found& each : rules.all()) {
    const std::size_t begin = rules.pieces()[each.first].at;
    std::string found(text.substr(begin, rules.pieces()[each.last].end() - begin));
    Message warning = each.text(found);
    all.push_back({field, std::move(found), std::move(warning)});
  }
  return all;
}

}  // namespace ew
