// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "analysis/formats/format.h"

namespace lanescope {
namespace {

/// A table with everything that a format has to deal with.
TableData sample() {
  TableData data;
  data.name = "sample";
  data.caption = "mean of a, b";
  data.setting = "msaa = 4, cull = on";
  data.title = "Table 1: sample";
  data.row_header = "Stage";
  data.columns = {"W = 8", "W = 16", "Words"};
  const Figure busy{0.834, 0.83, &kPercent};
  const Figure share{0.666, 0.68, &kShare};
  const Figure incomparable{0.5, 0.4, &kPercent, false};
  const Figure undefined{{}, 0.5, &kPercent};
  data.rows = {{"Heading_1", {}},
               {"Test", {Cell{busy, share, {}}, Cell{}, Cell{{}, {}, "50% | a_b"}}},
               {"Undefined", {Cell{undefined, {}, {}}, Cell{incomparable, {}, {}}, Cell{}}}};
  data.notes = {"A note, \"quoted\"."};
  return data;
}

std::string written(std::string_view format) { return find_format(format).write({sample()}); }

TEST(Formats, Text) {
  EXPECT_EQ(written("text"),
            "Table 1: sample\n"
            "Of: mean of a, b; msaa = 4, cull = on\n"
            "\n"
            "Stage             W = 8      paper    diff  W = 16          paper  Words\n"
            "------------------------------------------------------------------------\n"
            "Heading_1\n"
            "Test       83.4% (0.67) 83% (0.68) +0 (-1)                         50% | a_b\n"
            "Undefined           n/a        50%           50.0% not comparable\n"
            "\n"
            "A note, \"quoted\".\n");
}

TEST(Formats, Markdown) {
  EXPECT_EQ(written("markdown"),
            "### Table 1: sample\n"
            "\n"
            "Of: mean of a, b; msaa = 4, cull = on\n"
            "\n"
            "| Stage | W = 8 | paper | diff | W = 16 | paper | Words |\n"
            "| --- | ---: | ---: | ---: | ---: | ---: | --- |\n"
            "| **Heading\\_1** |  |  |  |  |  |  |\n"
            "| Test | 83.4% (0.67) | 83% (0.68) | +0 (-1) |  |  | 50% \\| a\\_b |\n"
            "| Undefined | n/a | 50% |  | 50.0% | not comparable |  |\n"
            "\n"
            "A note, \"quoted\".\n");
}

TEST(Formats, Csv) {
  const std::string begin = "sample,\"mean of a, b\",\"msaa = 4, cull = on\",Heading_1,";
  EXPECT_EQ(written("csv"),
            "table,scenes,setting,group,row,column,quantity,unit,ours,paper,difference,words\n" +
                begin + "Test,W = 8,figure,fraction,0.834,0.83,0.0040000000000000036,\n" + begin +
                "Test,W = 8,share,fraction,0.666,0.68,-0.014000000000000012,\n" + begin +
                "Test,Words,words,,,,,50% | a_b\n" + begin +
                "Undefined,W = 8,figure,fraction,,0.5,,\n" + begin +
                "Undefined,W = 16,figure,fraction,0.5,,,\n");
}

TEST(Formats, Latex) {
  EXPECT_EQ(written("latex"),
            "% Table 1: sample\n"
            "% Of: mean of a, b; msaa = 4, cull = on\n"
            "\\begin{tabular}{lrrrrrl}\n"
            "\\hline\n"
            "Stage & W = 8 & paper & diff & W = 16 & paper & Words \\\\\n"
            "\\hline\n"
            "\\multicolumn{7}{l}{\\textit{Heading\\_1}} \\\\\n"
            "Test & 83.4\\% (0.67) & 83\\% (0.68) & +0 (-1) &  &  & 50\\% | a\\_b \\\\\n"
            "Undefined & n/a & 50\\% &  & 50.0\\% & not comparable &  \\\\\n"
            "\\hline\n"
            "\\end{tabular}\n"
            "% A note, \"quoted\".\n");
}

TEST(Formats, SeparateTables) {
  const std::string one = find_format("text").write({sample()});
  EXPECT_EQ(find_format("text").write({sample(), sample()}), one + "\n\n" + one);
}

TEST(Figures, DifferencesAreOfNumbersRoundedAsThePaperRounds) {
  EXPECT_EQ(shown_difference({0.8351, 0.83, &kPercent}), "+1");
  EXPECT_EQ(shown_difference({0.8349, 0.83, &kPercent}), "+0");
  EXPECT_EQ(shown_difference({0.8249, 0.83, &kPercent}), "-1");
  EXPECT_EQ(shown_difference({61.9, 61.94, &kInstructions}), "+0%");
  EXPECT_EQ(shown_difference({68.134, 61.94, &kInstructions}), "+10%");
  EXPECT_EQ(shown_difference({1.24, 1.0, &kFactor}), "+0.2");
  EXPECT_EQ(shown_difference({0.666, 0.68, &kShare}), "-1");
  EXPECT_EQ(shown_difference({0.679, 0.68, &kShare}), "+0");
  EXPECT_EQ(shown_difference(Cell{Figure{0.86, 0.83, &kPercent}, Figure{0.2, 0.1, &kShare}, {}}),
            "+3 (+10)");
  EXPECT_EQ(shown_difference({0.001, 0.01, &kSmallPercent}), "");
  EXPECT_EQ(shown_paper({0.001, 0.01, &kSmallPercent}), "<1%");
}

TEST(Figures, ThatAreNotComparableShowNoNumberOfThePaper) {
  const Figure figure{0.86, 0.83, &kPercent, false};
  EXPECT_EQ(shown(figure), "86.0%");
  EXPECT_EQ(shown_paper(figure), "not comparable");
  EXPECT_EQ(shown_difference(figure), "");
  EXPECT_FALSE(rounded_difference(figure));
  EXPECT_EQ(shown_paper(Cell{figure, Figure{0.2, 0.1, &kShare, false}, {}}), "not comparable");
  EXPECT_EQ(shown_paper(Figure{0.86, {}, &kPercent, false}), "");
}

TEST(Figures, MissingNumbersShow) {
  EXPECT_EQ(shown(Figure{{}, {}, &kPercent}), "n/a");
  EXPECT_EQ(shown_paper({0.5, {}, &kPercent}), "");
  EXPECT_EQ(shown_difference({{}, 0.5, &kPercent}), "");
}

}  // namespace
}  // namespace lanescope
