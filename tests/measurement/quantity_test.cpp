#include "ew/measurement/quantity.h"

#include <gtest/gtest.h>

namespace ew::measurement::quantity_test {
namespace {

TEST(Quantity, IsConvertedExactlyWhereDecimalsAllow) {
  EXPECT_EQ(converted(82.0, Unit::mm, Unit::cm), 8.2);
  EXPECT_EQ(converted(8.2, Unit::cm, Unit::mm), 82.0);
  EXPECT_EQ(converted(1.0, Unit::weeks, Unit::days), 7.0);
  EXPECT_EQ(converted(0.25, Unit::one, Unit::percent), 25.0);
  EXPECT_EQ(converted(250.0, Unit::ms, Unit::s), 0.25);
  EXPECT_FALSE(areComparable(Unit::mm, Unit::mm2));
  EXPECT_FALSE(areComparable(Unit::ml, Unit::g));
}

TEST(Quantity, ShowsAsManyDecimalsAsItsUncertaintyDeserves) {
  EXPECT_EQ(shown({82.04, 0.93, Unit::mm}), "82.04 ± 0.93 mm");
  EXPECT_EQ(shown({1938.92, 143.0, Unit::g}), "1939 ± 143 g");
  EXPECT_EQ(shown({82.04, 0.0, Unit::mm}), "82.0 mm");
  EXPECT_EQ(shown({0.5, 0.0, Unit::one}), "0.500");
  EXPECT_EQ(shown({-0.0001, 0.0, Unit::mm}), "0.0 mm");
}

TEST(Quantities, AreReadWithTheSignsOfTheirUnitsAndInTheLanguagesPoint) {
  const auto text = [](const Quantity& quantity) { return quantityText(quantity).english(); };
  EXPECT_EQ(text({82.04, 0.9, Unit::mm}), "82.04 ± 0.90 mm");
  EXPECT_EQ(text({2510.0, 40.0, Unit::mm2}), "25.10 ± 0.40 cm²");
  EXPECT_EQ(text({45.0, 0.0, Unit::degree}), "45.0°");
  EXPECT_EQ(text({312.0, 0.0, Unit::cmPerS2}), "312 cm/s²");
  EXPECT_EQ(text({32.0 + 1.0 / 7.0, 0.0, Unit::weeks}), "32w1d");
  EXPECT_EQ(text({32.0, 5.2 / 7.0, Unit::weeks}), "32w0d ± 5 d");
  EXPECT_EQ(text({32.0, 0.01 / 7.0, Unit::weeks}), "32w0d ± 0.1 d");
  EXPECT_TRUE(quantityText({82.0, 0.0, Unit::mm}).isNumeral());
}

TEST(Units, HaveTheirSymbolsAndOtherSpellings) {
  for (const Unit unit : {Unit::one, Unit::percent, Unit::mm, Unit::cm2, Unit::ml, Unit::degree, Unit::perMinute, Unit::mmPerS,
                          Unit::cmPerS, Unit::cmPerS2, Unit::mlPerMinute, Unit::mmHg, Unit::weeks})
    EXPECT_EQ(unitOf(symbolOf(unit)), unit) << symbolOf(unit);
  EXPECT_EQ(unitOf("cm3"), Unit::ml);
  EXPECT_EQ(unitOf("bpm"), Unit::perMinute);
  EXPECT_EQ(unitOf("cm/s²"), Unit::cmPerS2);
  EXPECT_FALSE(areComparable(Unit::cmPerS, Unit::cmPerS2));
  EXPECT_FALSE(unitOf("inch"));
}

TEST(Quantities, AreReadAsCommandsHaveThem) {
  EXPECT_EQ(quantityOf("82mm"), (Quantity{82.0, 0.0, Unit::mm}));
  EXPECT_EQ(quantityOf("8.2 +- 0.1 cm"), (Quantity{8.2, 0.1, Unit::cm}));
  EXPECT_EQ(quantityOf("-10±2cm/s"), (Quantity{-10.0, 2.0, Unit::cmPerS}));
  EXPECT_EQ(quantityOf("300cm/s2"), (Quantity{300.0, 0.0, Unit::cmPerS2}));
  EXPECT_EQ(quantityOf("0.7"), (Quantity{0.7, 0.0, Unit::one}));
  for (const char* wrong : {"", "mm", "82 inch", "82+-mm", "82+--1mm", "about 82mm", "nan"}) EXPECT_FALSE(quantityOf(wrong)) << wrong;
}

TEST(GestationalAge, IsReadAndWrittenAsClinicsDo) {
  EXPECT_DOUBLE_EQ(*gestationOf("32w1d"), 32.0 + 1.0 / 7.0);
  EXPECT_DOUBLE_EQ(*gestationOf("32+1"), 32.0 + 1.0 / 7.0);
  EXPECT_DOUBLE_EQ(*gestationOf("32 + 1"), 32.0 + 1.0 / 7.0);
  EXPECT_DOUBLE_EQ(*gestationOf("0+6"), 6.0 / 7.0);
  EXPECT_DOUBLE_EQ(*gestationOf("32w"), 32.0);
  EXPECT_DOUBLE_EQ(*gestationOf("32.5w"), 32.5);
  for (const char* wrong : {"",     "32",   "w",   "32w7d", "32w-1d", "-2w",   "32w1", "46w",  "32.5w1d", "32 w",
                            "nanw", "32+7", "32+", "+1",    "32+-1",  "32++1", "-2+1", "46+0", "32+1w",   "32.5+1"})
    EXPECT_FALSE(gestationOf(wrong)) << wrong;
  for (int days = 0; days < 300; ++days) EXPECT_EQ(gestationText(*gestationOf(gestationText(days / 7.0))), gestationText(days / 7.0));
  EXPECT_EQ(gestationText(32.0 + 1.0 / 7.0), "32w1d");
}

}  // namespace
}  // namespace ew::measurement::quantity_test
