// SPDX-License-Identifier: MIT
// `lanescope compare`: what differs between two reports, with an exit status for scripts.
#include "analysis/comparison/compare.h"

#include <charconv>
#include <memory>

#include "analysis/base/json_text.h"
#include "analysis/cli/input.h"
#include "analysis/cli/options.h"
#include "analysis/cli/output.h"
#include "analysis/cli/values.h"

namespace lanescope {
namespace {

constexpr int kSame = 0;
constexpr int kDifferent = 1;
constexpr int kMaxLimit = 1 << 20;

enum class Form { kText, kMarkdown, kJson };
constexpr std::array<Choice<Form>, 3> kForms{
    {{"text", Form::kText}, {"markdown", Form::kMarkdown}, {"json", Form::kJson}}};

struct Given {
  std::vector<std::string> reports;
  std::string ignore;
  std::string fail_over = "0";
  std::string limit = "20";
  std::string format = "text";
  std::string output = "-";
};

/// `1%` or `0.01`.
double parse_share(const Argument& argument) {
  std::string_view number = argument.text;
  const bool percent = number.ends_with('%');
  if (percent) number.remove_suffix(1);
  double value = 0.0;
  const auto result = std::from_chars(number.data(), number.data() + number.size(), value);
  if (number.empty() || result.ec != std::errc() || result.ptr != number.data() + number.size() ||
      !(value >= 0.0 && value <= 1e6))
    argument.fail("a share of at least 0, as 0.01 or 1%");
  return percent ? value / 100.0 : value;
}

std::set<std::string> parse_ignored(const std::string& text) {
  std::set<std::string> ignored;
  if (text.empty()) return ignored;
  for (const Argument& element : parse_list({"--ignore", text})) ignored.emplace(element.text);
  return ignored;
}

int run(const Given& given) {
  const CompareOptions options{parse_share({"--fail-over", given.fail_over}),
                               parse_ignored(given.ignore)};
  const int limit = parse_integer({"--limit", given.limit}, 0, kMaxLimit);
  const Form form = parse_choice({"--format", given.format}, kForms);
  if (given.reports.size() != 2) throw InputError("compare", "name two reports: old and new");
  Destination output(given.output);
  const std::vector<NamedReport> reports = read_reports(given.reports);
  const NamedReport& before = reports[0];
  const NamedReport& after = reports[1];
  const Comparison comparison = compare(before, after, options);
  const ComparisonDocument document{before, after, options, comparison,
                                    static_cast<std::size_t>(limit)};
  output.write(form == Form::kJson ? json_text(document.json())
                                   : document.text(form == Form::kMarkdown));
  return comparison.same() ? kSame : kDifferent;
}

Action declare(CommandOptions& options) {
  const auto given = std::make_shared<Given>();
  options.add_arguments({"reports", "REPORT", "The old report and the new one"}, given->reports);
  options.add(
      "Comparison",
      {"--ignore", "NAMES", "Compare runs that differ in these parameters, as observe_every,mode"},
      given->ignore);
  options.add(
      "Comparison",
      {"--fail-over", "SHARE",
       "Tolerate relative differences up to this, as 1% or 0.01; above 0, also other hashes"},
      given->fail_over);
  options.add_output({"--limit", "N", "Changes shown of each run; 0 for all"}, given->limit);
  options.add_output({"--format", "FORMAT", "text, markdown or json"}, given->format);
  options.add_output({"-o,--output", "FILE", "Writes there; - for standard output"}, given->output);
  return [given] { return run(*given); };
}

}  // namespace

extern const Command c_compare{
    "compare",
    "Prints what differs between two reports; exit status 0 if nothing, 1 if something, 2 if they "
    "cannot be compared",
    "  lanescope compare a.json b.json\n"
    "  lanescope compare a.json b.json --fail-over 1%\n"
    "  lanescope compare a.json b.json --ignore observe_every --format json -o changes.json",
    declare};

}  // namespace lanescope
