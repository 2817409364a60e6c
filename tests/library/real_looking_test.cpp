#include "ew/library/real_looking.h"

#include <gtest/gtest.h>

#include <set>

#include "ew/library/case.h"

namespace ew::test::real_looking_test {
namespace {

TEST(RealLooking, FindsWhatComesFromRecords) {
  const char* const real[] = {
      // dates
      "Ultrasound of 12.03.2019 without findings.", "Ultrasound of 12/3/2019.", "Seen on 2019-03-12.", "Operated 3-12-2019.",
      "Last seen 01.02.18.", "Admitted 12. 3. 2019.", "Exam 20190312 was normal.", "Examined on 12 March 2019.",
      "On March 12, 2019 she fell.", "Since March 2019 pain.", "On the 3rd of May he noticed it.", "Seit 12. März Schmerzen.",
      "Am 3. Mai 2020 gestürzt.", "Kontrolle vom 14. Dezember.", "Befund vom 03.05. liegt vor.", "On 5 Oct 2020 again.",
      "Sono Okt 2021 unauffällig.",
      // births
      "Born 1956 in a village.", "Patient, born 12.03.1956.", "DOB: 1956-03-12", "geb. 1956", "geboren am 3. Mai 1956",
      "Geburtsdatum 12.03.56",
      // telephone
      "Call +49 30 1234567 for the report.", "Phone (030) 123 4567.", "030/1234567", "0171 2345678", "Tel. 47110", "Telefon: 030-47 11 12",
      "555-123-4567", "Fax 12345", "Mobile 07700 900123",
      // numbers
      "MRN: 123456", "MRN 12345", "Accession 2019-4711", "Patient ID 47110815", "Fallnummer 201912", "Patientennummer: 4711",
      "Versichertennummer A123456789", "insurance number 998877", "The file is 4711081512.", "NHS 943 476 5919", "078-05-1120",
      "Auftragsnummer 55512", "Case no 4711", "A123456789", "123456 was her number",
      // addresses
      "Write to anna.weber@example.org.", "j.smith@mail.com", "see www.hospital-example.org/report", "https://example.org/x",
      "lives in Hauptstraße 12", "Bahnhofstr. 5", "12 Baker Street", "221 Abbey Road, second floor",
      // names
      "Referred by Dr. Weber.", "Dr Smith saw her.", "Prof. Dr. med. Sonnenberg was asked.", "Mrs Brown is 46.", "Mr. Jones",
      "Frau Schmidt klagt über Schmerzen.", "Herr Dr. Kraus", "Überweisung durch Herrn Maier", "John Smith, 46", "Smith, John",
      "Peter Müller kommt zur Kontrolle.", "MUSTERMANN^MAX", "Thomas Schneider",
      // hospitals
      "Examined at St Mary Hospital.", "Seen in the Riverside Clinic.", "im Klinikum Großhadern", "Krankenhaus St. Josef", "Charité",
      "Universitätsklinikum Musterstadt", "Leeds General Infirmary"};
  EXPECT_GE(std::size(real), 60u);
  for (const char* text : real) {
    const auto found = realLookingIn(text, "history");
    ASSERT_FALSE(found.empty()) << text;
    EXPECT_EQ(found.front().field, "history");
    EXPECT_NE(std::string(text).find(found.front().found), std::string::npos) << text;
    EXPECT_NE(found.front().text.english().find(found.front().found), std::string::npos);
  }
}

TEST(RealLooking, LeavesWhatCasesSayAlone) {
  const char* const invented[] = {"Three attacks within four months.",
                                  "Two years ago an ultrasound without findings.",
                                  "Gall stone of 12 mm, mobile.",
                                  "Gall bladder 80 x 30 mm.",
                                  "Blood pressure 120/80.",
                                  "Bilirubin 12 umol/l, lipase 45 U/l.",
                                  "CRP 3.5 mg/l (normal below 5.0).",
                                  "Platelets 150000/ul.",
                                  "Leucocytes 7.8 per nl.",
                                  "GFR 60 ml/min/1.73 m2",
                                  "at 3.5 MHz, 60 dB",
                                  "Segments 4/5 and 8.",
                                  "Segment 4a/4b",
                                  "Grade 2 of 5.",
                                  "Version 1.2",
                                  "1.5 x 2.0 x 2.5 cm",
                                  "from 0 to 15 cm",
                                  "Doppler angle 60 degrees",
                                  "in week 20 + 3",
                                  "20+3 weeks",
                                  "A 46 year old woman.",
                                  "Frau Mitte 40 mit Schmerzen.",
                                  "Eine Frau Anfang 30.",
                                  "Die Frau. Sie klagt.",
                                  "Der Herr klagt.",
                                  "Morison's pouch",
                                  "Murphy's sign is positive.",
                                  "Doppler shows flow.",
                                  "Douglas space is empty.",
                                  "The hospital is far.",
                                  "another hospital",
                                  "In a hospital nearby.",
                                  "Hospital stay of three days.",
                                  "Im Krankenhaus war alles gut.",
                                  "Eine Klinik hat sie untersucht.",
                                  "the doctor asks",
                                  "Dr. said so",
                                  "It may be 3 mm.",
                                  "In May it got worse.",
                                  "Im März schlimmer.",
                                  "march on",
                                  "Schritt 3. Dann weiter.",
                                  "Step 2. Then tilt.",
                                  "Measure 12.5. Then freeze.",
                                  "12 to 18 cm",
                                  "2 of 3",
                                  "5 - 10 mm",
                                  "10/12 mm",
                                  "1/2",
                                  "3-4 times",
                                  "0.5 mm, 0.7 mm, 0.9 mm",
                                  "10 20 30 40",
                                  "100 %",
                                  "99.9 %",
                                  "The year 2019 was hard.",
                                  "since 2019",
                                  "Hepatic veins: right, middle, left.",
                                  "Anna is her dog.",
                                  "Edda Lindqvist",
                                  "Gallengang 4 mm weit",
                                  "Weg 8 mm",
                                  "Straßen nach 3 Tagen",
                                  "Right of 5 lobes",
                                  "e.g. 10 mm",
                                  "a@ b",
                                  "Probe 1: convex",
                                  "Beta-hCG 25000 IU/l",
                                  "AFP 1234567 IU/l"};
  EXPECT_GE(std::size(invented), 60u);
  for (const char* text : invented) {
    const auto found = realLookingIn(text, "history");
    EXPECT_TRUE(found.empty()) << text << ": " << found.front().found;
  }
}

TEST(RealLooking, SaysNothingOfTheShippedCases) {
  const auto folder = shippedCasesFolder();
  ASSERT_TRUE(folder);
  for (const Case& each : listCases(*folder).cases)
    for (const RealLooking& found : realLooking(each)) ADD_FAILURE() << each.id << ", " << found.field << ": " << found.text;
}

TEST(RealLooking, LooksThroughEveryTextOfACase) {
  Case opened;
  opened.patient.name = "John Smith";
  opened.previousExaminations = {{"12.03.2019", "ultrasound", "by Dr. Weber"}};
  opened.laboratory = {{"last week", "MRN 12345"}};
  opened.findings = {"Seen on 2019-03-12."};
  std::vector<std::string> fields;
  for (const RealLooking& each : realLooking(opened)) fields.push_back(each.field);
  EXPECT_EQ(fields, (std::vector<std::string>{"patient.name", "previous_examinations[0].when", "previous_examinations[0].findings",
                                              "laboratory[0].findings", "findings"}));
}

TEST(InventedName, IsTheSameForASeedAndNobodys) {
  EXPECT_EQ(inventedName(7, "en", "female"), inventedName(7, "en", "female"));
  std::set<std::string> names;
  for (const char* language : {"en", "de"})
    for (const char* sex : {"female", "male", "other", ""})
      for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const std::string name = inventedName(seed, language, sex);
        EXPECT_TRUE(realLookingIn(name, "patient.name").empty()) << name;
        EXPECT_EQ(std::count(name.begin(), name.end(), ' '), 1) << name;
        names.insert(name);
      }
  EXPECT_GT(names.size(), 1000u);
}

}  // namespace
}  // namespace ew::test::real_looking_test
