#include "io/picture/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/valve/number_text.h"

namespace coapt {
namespace {

TEST(Text, NumbersHaveTheirPlacesAndNoMinusZero) {
  EXPECT_EQ(fixed(12.345, 1), "12.3");
  EXPECT_EQ(fixed(-2.5, 2), "-2.50");
  EXPECT_EQ(fixed(-0.01, 1), "0.0");
  EXPECT_EQ(fixed(1e300, 0).size(), 301u);
  EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN(), 1), "n/a");
  EXPECT_EQ(fixed(-std::numeric_limits<double>::infinity(), 1), "n/a");
}

TEST(Text, OneIsNotMany) {
  EXPECT_EQ(counted(1, "plan"), "1 plan");
  EXPECT_EQ(counted(0, "plan"), "0 plans");
}

TEST(Text, BrokenUtf8IsReplacedAndWholeUtf8Kept) {
  const std::string replaced = "\xEF\xBF\xBD";
  EXPECT_EQ(printable("mm² – 二尖瓣 🫀"), "mm² – 二尖瓣 🫀");
  EXPECT_EQ(printable("a\xFF"
                      "b"),
            "a" + replaced + "b");
  EXPECT_EQ(printable("cut \xE4\xBA"), "cut " + replaced + replaced);
  EXPECT_EQ(printable("\xC0\xAF"), replaced + replaced) << "overlong";
  EXPECT_EQ(printable("\xED\xA0\x80"), replaced + replaced + replaced) << "surrogate";
  EXPECT_EQ(printable("\xF4\x90\x80\x80").size(), 12u) << "beyond U+10FFFF";
  EXPECT_EQ(printable(std::string("a\nb\0c", 5)), "a b c");
  EXPECT_EQ(printable("\x1B[2J\xC2\x9B"
                      "31m\x7F"),
            " [2J 31m ")
      << "C0, C1, DEL";
  EXPECT_EQ(printable("\xC2\xA0\xE2\x80\xAE"
                      "x\xE2\x81\xA6y\xE2\x80\x9C"),
            "\xC2\xA0 x y\xE2\x80\x9C")
      << "direction";
}

TEST(Text, LinesEndWhereTheyDid) {
  EXPECT_EQ(printable_lines("a\x1B\r\n\nb\n"), "a  \n\nb\n");
  EXPECT_EQ(printable_lines("a\nb\x7F"), "a\nb ");
  EXPECT_EQ(printable_lines(""), "");
}

TEST(Text, HtmlIsEscaped) {
  EXPECT_EQ(escape_html("<a href=\"x\" id='y'>&</a>"),
            "&lt;a href=&quot;x&quot; id=&#39;y&#39;&gt;&amp;&lt;/a&gt;");
}

TEST(Text, CountsAreGroupedByThousands) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(45'678'901), "45,678,901");
  EXPECT_EQ(grouped(-123456), "-123,456");
}

TEST(Text, SharesAreFinerNearNothingAndAll) {
  EXPECT_EQ(percent(0.0), "0 %");
  EXPECT_EQ(percent(0.005), "0.5 %");
  EXPECT_EQ(percent(0.62), "62 %");
  EXPECT_EQ(percent(0.992), "99.2 %");
  EXPECT_EQ(percent(1.0), "100 %");
  EXPECT_EQ(percent(std::numeric_limits<double>::quiet_NaN()), "n/a");
}

TEST(Text, ProbabilitiesAreNeverCertain) {
  EXPECT_EQ(probability_text(0.62), "62 %");
  EXPECT_EQ(probability_text(0.9741), "97.4 %");
  EXPECT_EQ(probability_text(0.99967), "> 99.9 %");
  EXPECT_EQ(probability_text(1.0), "> 99.9 %");
  EXPECT_EQ(probability_text(0.0), "< 0.1 %");
  EXPECT_EQ(probability_words(1.0), "more than 99.9 %");
}

TEST(Text, AnErrorSaysHowManyDigitsAreKnown) {
  EXPECT_EQ(with_error(45.678, 2.13), "45.7 ± 2.1");
  EXPECT_EQ(with_error(45.678, 5.2), "46 ± 5");
  EXPECT_EQ(with_error(45.678, 0.97), "45.7 ± 1.0");
  EXPECT_EQ(with_error(45.678, 0.354), "45.68 ± 0.35");
  EXPECT_EQ(with_error(45.678, 0.36), "45.7 ± 0.4");
  EXPECT_EQ(with_error(45.678, 12.4), "46 ± 12");
  EXPECT_EQ(with_error(-0.01, 0.5), "0.0 ± 0.5");
  EXPECT_EQ(with_error(1.25, 0.0), "1.2 ± 0.0");
  EXPECT_EQ(with_error(45.678, 2.13, "mm²"), "45.7 ± 2.1 mm²");
  EXPECT_EQ(with_error(45.678, std::nan("")), "45.7");
  EXPECT_EQ(known_digits(45.678, 5.2), "46");
  EXPECT_EQ(with_error(std::nan(""), 1.0, "mm²"), "n/a");
}

}  // namespace
}  // namespace coapt
