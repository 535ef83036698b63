// SPDX-License-Identifier: MIT
#include "analysis/base/printable.h"

#include <gtest/gtest.h>

#include "analysis/base/csv_text.h"
#include "analysis/base/markdown_text.h"
#include "analysis/base/memory.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

TEST(Printable, TextStaysAsItIs) {
  for (const char* text :
       {"", "teapot.obj", "w\xc3\xbcrfel", "\xe2\x86\x92 \xf0\x9f\x98\x80", "a\\n"}) {
    EXPECT_TRUE(is_printable(text)) << text;
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, ControlsAndOtherBytesAreEscaped) {
  const std::pair<const char*, const char*> cases[] = {
      {"a\nb\tc\r", "a\\nb\\tc\\r"},
      {"\x1b[31mred\x7f", "\\x1b[31mred\\x7f"},
      {"w\xfcrfel", "w\\xfcrfel"},
      {"\xc2\x85", "\\xc2\\x85"},           // A control character of two bytes.
      {"\xc0\xaf", "\\xc0\\xaf"},           // Longer than need be.
      {"\xed\xa0\x80", "\\xed\\xa0\\x80"},  // Half of a pair.
      {"\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80"},
      {"cut \xe2\x86", "cut \\xe2\\x86"},
  };
  for (const auto& [text, shown] : cases) {
    EXPECT_FALSE(is_printable(text)) << shown;
    EXPECT_EQ(printable(text), shown);
  }
}

TEST(CsvText, WhatASpreadsheetWouldComputeIsText) {
  EXPECT_EQ(csv_field("=1+1.obj"), "'=1+1.obj");
  EXPECT_EQ(csv_field("@sum"), "'@sum");
  EXPECT_EQ(csv_field("-1+cmd"), "'-1+cmd");
  EXPECT_EQ(csv_field("+a,b"), "\"'+a,b\"");
  for (const char* field : {"", "-", "-0.5", "-1e-09", "+3", "teapot", "a=b", "\"x\""})
    EXPECT_FALSE(csv_field(field).starts_with('\'')) << field;
}

TEST(MarkdownText, HasNoMarks) {
  EXPECT_EQ(markdown_text("a b-c (d) = 5%"), "a b-c (d) = 5%");
  EXPECT_EQ(markdown_text("<img src=x>|_*`[a](b)\\"), "\\<img src=x>\\|\\_\\*\\`\\[a](b)\\\\");
}

TEST(Memory, IsKnownAndRefusedBeyond) {
  const std::uint64_t available = available_memory_bytes();
  EXPECT_GT(available, std::uint64_t{1} << 20);
  EXPECT_NO_THROW(require_memory(1));
  EXPECT_THROW(require_memory(~std::uint64_t{0}), InputError);
  EXPECT_EQ(memory_text(2'147'483'648), "2.1 GB");
  EXPECT_EQ(memory_text(24'000'000), "24 MB");
}

}  // namespace
}  // namespace lanescope
