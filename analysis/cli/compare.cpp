// SPDX-License-Identifier: MIT
// `lanescope compare`: what differs between two reports, with an exit status for scripts.
#include "analysis/comparison/compare.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <memory>

#include "analysis/base/json_text.h"
#include "analysis/cli/command.h"
#include "analysis/cli/output.h"
#include "analysis/cli/values.h"
#include "analysis/configuration/configuration_json.h"
#include "analysis/report/report_json.h"

namespace lanescope {
namespace {

constexpr int kSame = 0;
constexpr int kDifferent = 1;
constexpr int kMaxLimit = 1 << 20;

enum class Form { kText, kMarkdown, kJson };
constexpr std::array<Choice<Form>, 3> kForms{
    {{"text", Form::kText}, {"markdown", Form::kMarkdown}, {"json", Form::kJson}}};

struct Arguments {
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
  for (const Argument& element : parse_list({"--ignore", text}))
    ignored.insert(parse_name(element, "a parameter", parameter_names()));
  return ignored;
}

int run(const Arguments& arguments) {
  const CompareOptions options{parse_share({"--fail-over", arguments.fail_over}),
                               parse_ignored(arguments.ignore)};
  const int limit = parse_integer({"--limit", arguments.limit}, 0, kMaxLimit);
  const Form form = parse_choice({"--format", arguments.format}, kForms);
  if (arguments.reports.size() != 2) throw InputError("compare", "name two reports: old and new");
  Destination output(arguments.output);
  const NamedReport before{arguments.reports[0], read_report(arguments.reports[0])};
  const NamedReport after{arguments.reports[1], read_report(arguments.reports[1])};
  const Comparison comparison = compare(before, after, options);
  const ComparisonDocument document{before, after, options, comparison,
                                    static_cast<std::size_t>(limit)};
  output.write(form == Form::kJson ? json_text(document.json())
                                   : document.text(form == Form::kMarkdown));
  return comparison.same() ? kSame : kDifferent;
}

Action declare(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("reports", arguments->reports, "The old report and the new one")
      ->type_name("REPORT");
  const auto add = [&](const char* group, const char* option, std::string& text, const char* form,
                       const char* meaning) {
    CLI::Option* added = app.add_option(option, text, meaning)->type_name(form)->group(group);
    if (!text.empty()) added->default_str(text);
  };
  add("Comparison", "--ignore", arguments->ignore, "NAMES",
      "Compare runs that differ in these parameters, as seed,observe_every");
  add("Comparison", "--fail-over", arguments->fail_over, "SHARE",
      "Tolerate relative differences up to this, as 1% or 0.01; above 0, also other hashes");
  add("Output", "--limit", arguments->limit, "N", "Changes shown of each run; 0 for all");
  add("Output", "--format", arguments->format, "FORMAT", "text, markdown or json");
  add("Output", "-o,--output", arguments->output, "FILE", "Writes there; - for standard output");
  return [arguments] { return run(*arguments); };
}

}  // namespace

extern const Command c_compare{
    "compare",
    "Prints what differs between two reports; exit status 0 if nothing, 1 if something, 2 if they "
    "cannot be compared",
    "  lanescope compare a.json b.json\n"
    "  lanescope compare a.json b.json --fail-over 1%\n"
    "  lanescope compare a.json b.json --ignore seed --format json -o changes.json",
    declare};

}  // namespace lanescope
