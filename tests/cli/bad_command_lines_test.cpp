// SPDX-License-Identifier: MIT
// Mistakes on the command line end the program with status 2 and one line that says where, what was
// found and what would be right, before any work is done.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "analysis/tables/table.h"
#include "simulator/base/choice.h"
#include "tests/cli/program.h"

namespace lanescope {
namespace {

using testing::lanescope_program;
using testing::Outcome;

struct BadLine {
  std::string arguments;
  std::string complaint;
};

void PrintTo(const BadLine& line, std::ostream* out) { *out << "lanescope " << line.arguments; }

/// The complaint, with words in braces replaced by the names that the program lists.
std::string with_names(std::string complaint) {
  const auto replace = [&](std::string_view place, const auto& names) {
    const std::size_t begin = complaint.find(place);
    if (begin != complaint.npos) complaint.replace(begin, place.size(), list_or(names()));
  };
  replace("{commands}", [] { return testing::listed("commands"); });
  replace("{kernels}", [] { return testing::listed("kernels"); });
  replace("{studies}", [] { return testing::listed("studies"); });
  replace("{tables}", [] { return names_of(tables()); });
  replace("{tables of luong}", [] { return testing::listed("tables", "of the study luong"); });
  return complaint;
}

class BadCommandLines : public ::testing::TestWithParam<BadLine> {};

TEST_P(BadCommandLines, EndWithStatus2AndOneLine) {
  const Outcome outcome = lanescope_program(GetParam().arguments);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.errors, "lanescope: " + with_names(GetParam().complaint) + "\n");
  EXPECT_EQ(outcome.output, "");
}

const std::string kScenes = "ballroll, columnpivot, tigerjump, talking or teapot";
const std::string kLists =
    "kernels, workloads, scenes, instructions, parameters, tables, machines, studies or commands";

const std::vector<BadLine> kBadLines{
    // Commands and their arguments.
    {"", "command: none given; use {commands}"},
    {"runn", "command: 'runn' is not a command; use {commands}; did you mean 'run'?"},
    {"zzzzzz", "command: 'zzzzzz' is not a command; use {commands}"},
    {"runn run", "command: 'runn' is not a command; use {commands}; did you mean 'run'?"},
    {"--versoin", "--versoin: is not an option of lanescope; did you mean '--version'?"},
    {"run teapot", "run: unexpected argument 'teapot'"},
    {"run --widht 8", "--widht: is not an option of run; did you mean '--width'?"},
    {"run --widht=8", "--widht: is not an option of run; did you mean '--width'?"},
    {"run -q", "-q: is not an option of run"},
    {"run --width", "--width: needs a value"},
    {"run --width 8 --width 16", "--width: is given twice"},
    {"run --width ''", "--width: has an empty value"},
    {"run --scene ''", "--scene: has an empty value"},
    {"run --json= --scene x", "--json: has an empty value"},
    {"run --json=", "--json: has an empty value"},
    {"run --jsno= --scene x", "--jsno: is not an option of run; did you mean '--json'?"},
    {"run --json --scene x", "--json: needs a value; what follows is the option --scene"},
    {R"x(run "$(printf '\033[31m')")x", "run: unexpected argument '\\x1b[31m'"},
    {R"x(run "$(printf -- '--scene=tea\npot')")x",
     "--scene: 'tea\\npot' is not text in UTF-8 without control characters, as a report has it; "
     "rename the file"},
    {R"x(run --mesh "$(printf 'w\374rfel.obj')")x",
     "--mesh: 'w\\xfcrfel.obj' is not text in UTF-8 without control characters, as a report has "
     "it; rename the file"},
    {"list", "list: of what? Use " + kLists},
    {"list kernel", "list: 'kernel' is not a list; use " + kLists + "; did you mean 'kernels'?"},
    {"list kernels --reference", "--reference: there is one of instructions only; leave it out"},
    {"list kernels scenes", "list: unexpected argument 'scenes'"},
    // Studies.
    {"study luon", "study: 'luon' is not a study; use {studies}; did you mean 'luong'?"},
    {"study --out out", "--out: is not an option of study"},
    {"study luong teapot", "study luong: unexpected argument 'teapot'"},
    {"study luong tables", "study luong: unexpected argument 'tables'"},
    {"study luong --widht 8", "--widht: is not an option of study luong; did you mean '--width'?"},
    {"study luong --table overhaed --from r.json",
     "--table: 'overhaed' is not a table; use {tables of luong}; did you mean 'overhead'?"},
    {"study luong --from r.json --kernel repack", "--kernel excludes --from"},
    // Kernels.
    {"run --kernel repak",
     "--kernel: 'repak' is not a kernel; use {kernels}; did you mean 'repack'?"},
    {"run --kernel lockstep,,repack",
     "--kernel: 'lockstep,,repack' has an empty element; separate values by single commas"},
    {"run --kernel repack,repack", "--kernel: 'repack,repack' has 'repack' twice"},
    {"run --kernel rastmp --width 3", "--width: 3 is not a width of rastmp; it is scalar, use 1"},
    {"run --width 0", "--width: '0' is not an integer from 1 to 64"},
    {"run --width 65", "--width: '65' is not an integer from 1 to 64"},
    {"run --width 8,x", "--width: 'x' is not an integer from 1 to 64"},
    {"run --width 1:65", "--width: '65' is not an integer from 1 to 64"},
    {"run --width 1:", "--width: '' is not an integer from 1 to 64"},
    {"run --width 1:2:3", "--width: '2:3' is not an integer from 1 to 64"},
    {"run --width 8:4", "--width: 8:4 holds nothing; M:N is from M to N"},
    {"run --micropolygon triangle:quad", "--micropolygon: 'triangle:quad' is not triangle or quad"},
    {"run --seed 0:18446744073709551615",
     "--seed: 0:18446744073709551615 holds more than 100000 values"},
    {"run --seed 1:1000 --drain 1:1000",
     "parameters: have more than 100000 combinations; shorten their lists"},
    {"run --frame 0:500 --drain 1:500",
     "parameters: have more than 100000 combinations; shorten their lists"},
    // Options that nobody takes.
    {"run --kernel lockstep --stream-load-threshold 0.5",
     "--stream-load-threshold: lockstep does not take it; repack does"},
    {"run --kernel rastmp,lockstep --stream-load-threshold 0.5",
     "--stream-load-threshold: rastmp and lockstep do not take it; repack does"},
    {"render -o a.png --stream-load-threshold 0.5",
     "--stream-load-threshold: lockstep does not take it; repack does"},
    {"run --micropolygon hexagon", "--micropolygon: 'hexagon' is not triangle or quad"},
    {"run --micropolygon triangel",
     "--micropolygon: 'triangel' is not triangle or quad; did you mean 'triangle'?"},
    {"run --edges never", "--edges: 'never' is not inline or precomputed"},
    {"run --edges precompute",
     "--edges: 'precompute' is not inline or precomputed; did you mean 'precomputed'?"},
    {"run --stream-load-threshold 1.5",
     "--stream-load-threshold: '1.5' is not a number from 0 to 1"},
    {"run --stream-load-threshold nan",
     "--stream-load-threshold: 'nan' is not a number from 0 to 1"},
    {"run --stream-load-threshold 50%",
     "--stream-load-threshold: '50%' is not a number from 0 to 1"},
    {"run --cull yes", "--cull: 'yes' is not on or off"},
    {"run --mode trace", "--mode: 'trace' is not counting, checked or uncounted"},
    {"run --mode chekked",
     "--mode: 'chekked' is not counting, checked or uncounted; did you mean 'checked'?"},
    {"study luong --mode uncounted",
     "--mode: uncounted runs have no figures for tables; leave it out, or use `lanescope run`"},
    // Scenes.
    {"run --scene teapto", "--scene: 'teapto' is not a scene of micropolygons; use " + kScenes +
                               ", or name a mesh file (.obj); did you mean 'teapot'?"},
    {"run --scene teapot,teapot", "--scene: 'teapot,teapot' has 'teapot' twice"},
    {"run --scene teapot,all", "--scene: 'all' stands for several scenes; use it alone"},
    {"run --scene thesis,teapot", "--scene: 'thesis' stands for several scenes; use it alone"},
    {"run --frame 48 --scene ballroll", "--frame: 48 is not a frame of ballroll; use 0 to 47"},
    {"run --frame -1", "--frame: '-1' is not an integer from 0 to 1048576"},
    {"run --turn 400", "--turn: '400' is not a number from -360 to 360"},
    {"run --turn 1e99", "--turn: '1e99' is not a number from -360 to 360"},
    {"run --mesh a.obj --scene teapot", "--scene excludes --mesh"},
    {"run --mesh a.obj --frame 3", "--frame: does not apply to any scene of the command"},
    {"run --scene a.obj --frame 3", "--frame: does not apply to any scene of the command"},
    {"run --mesh a.ply", "--mesh: 'a.ply' is not a mesh file (.obj)"},
    {"run --mesh a.obj --patches flat", "--patches: 'flat' is not linear, pn or phong"},
    {"run --patches pn", "--patches: does not apply to any scene of the command"},
    {"run --mesh /nonexistent/a.obj",
     "/nonexistent/a.obj: cannot be opened: No such file or directory"},
    // Tessellation and sampling.
    {"run --resolution 100", "--resolution: '100' is not of the form WIDTHxHEIGHT, as 1728x1080"},
    {"run --resolution 96x60,100",
     "--resolution: '100' is not of the form WIDTHxHEIGHT, as 1728x1080"},
    {"run --resolution 100x", "--resolution: '' is not an integer from 1 to 16384"},
    {"run --resolution 0x60", "--resolution: '0' is not an integer from 1 to 16384"},
    {"run --resolution 99999x60", "--resolution: '99999' is not an integer from 1 to 16384"},
    {"run --resolution 96x60x3", "--resolution: '60x3' is not an integer from 1 to 16384"},
    {"run --resolution 16000x16000",
     "--resolution: 16000x16000 is outside 1x1 to 8192x8192 at 4 samples a pixel"},
    {"run --dice-area 0", "--dice-area: '0' is not a number from 0.01 to 10000"},
    {"run --dice-area 1px", "--dice-area: '1px' is not a number from 0.01 to 10000"},
    {"run --grid 129", "--grid: '129' is not an integer from 1 to 128"},
    {"run --grid 8.5", "--grid: '8.5' is not an integer from 1 to 128"},
    {"run --drain 0", "--drain: '0' is not an integer from 1 to 1048576"},
    {"run --msaa 5", "--msaa: '5' is not 1, 4, 9, 16 or 64"},
    {"run --msaa 1:4", "--msaa: '1:4' is not 1, 4, 9, 16 or 64"},
    {"run --jitter true", "--jitter: 'true' is not on or off"},
    {"run --seed -1", "--seed: '-1' is not an integer from 0 to 2^64 - 1"},
    {"run --seed 18446744073709551616",
     "--seed: '18446744073709551616' is not an integer from 0 to 2^64 - 1"},
    {"run --seed ' 1'", "--seed: ' 1' is not an integer from 0 to 2^64 - 1"},
    // Output.
    {"run --threads 0", "--threads: '0' is not an integer from 1 to 256"},
    {"run --threads two", "--threads: 'two' is not an integer from 1 to 256"},
    {"run --json /nonexistent/r.json",
     "/nonexistent/r.json: cannot be written: No such file or directory"},
    {"run --json /", "/: is not the name of a file"},
    {"render --scene teapot", "--output: is missing; name a PNG file"},
    {"render -o /nonexistent/a.png",
     "/nonexistent/a.png: cannot be written: No such file or directory"},
    {"render -o a.png --micropolygon triangle,quad",
     "render: draws one picture; give one scene, kernel and width, and one value of what else "
     "there "
     "is"},
    {"render -o a.png --resolution 96x60,48x30",
     "render: draws one picture; give one scene, kernel and width, and one value of what else "
     "there "
     "is"},
    {"tables --format pdf",
     "--format: 'pdf' is not a format; use text, markdown, csv, latex or json"},
    {"tables --format markdow",
     "--format: 'markdow' is not a format; use text, markdown, csv, latex or json; did you mean "
     "'markdown'?"},
    {"tables --table overhaed",
     "--table: 'overhaed' is not a table; use {tables of luong}; did you mean 'overhead'?"},
    {"tables --per-scene=maybe", "--per-scene: takes no value"},
    {"tables --format json --per-scene",
     "--format: json holds all tables of the mean; leave out --table and --per-scene"},
    {"tables --format json --table claims",
     "--format: json holds all tables of the mean; leave out --table and --per-scene"},
    {"tables --kernl repack", "--kernl: is not an option of tables; did you mean '--kernel'?"},
    {"tables --from /nonexistent/r.json",
     "/nonexistent/r.json: cannot be read: No such file or directory"},
    {"tables --from / ", "/: is a directory; a file is needed"},
    {"tables --from r.json --scene teapot", "--scene excludes --from"},
    {"tables --from r.json --msaa 16", "--msaa excludes --from"},
    {"show", "show: of what? Name a report"},
    {"show r.json --format json",
     "--format: 'json' is not a format; use text, markdown, csv or latex"},
    {"show r.json --table utilisation",
     "--table: 'utilisation' is not a table; use {tables}; did you mean 'utilization'?"},
    {"show /nonexistent/r.json", "/nonexistent/r.json: cannot be read: No such file or directory"},
    // Reports.
    {"compare", "compare: name two reports: old and new"},
    {"compare a.json", "compare: name two reports: old and new"},
    {"compare a.json b.json --fail-over -1",
     "--fail-over: '-1' is not a share of at least 0, as 0.01 or 1%"},
    {"compare a.json b.json --fail-over 1%%",
     "--fail-over: '1%%' is not a share of at least 0, as 0.01 or 1%"},
    {"compare a.json b.json --fail-over nan",
     "--fail-over: 'nan' is not a share of at least 0, as 0.01 or 1%"},
    {"compare a.json b.json --fail-over %",
     "--fail-over: '%' is not a share of at least 0, as 0.01 or 1%"},
    {"compare a.json b.json --limit -1", "--limit: '-1' is not an integer from 0 to 1048576"},
    {"compare a.json b.json --format csv", "--format: 'csv' is not text, markdown or json"},
    {"compare a.json b.json --ignore seed,seed", "--ignore: 'seed,seed' has 'seed' twice"},
    {"compare /nonexistent/a.json b.json",
     "/nonexistent/a.json: cannot be read: No such file or directory"},
    {"compare a.json b.json -o /nonexistent/c.txt",
     "/nonexistent/c.txt: cannot be written: No such file or directory"},
    {"csv", "csv: of what? Name one or more reports"},
    {"csv a.json --rows stage",
     "--rows: 'stage' is not instructions, stages or runs; did you mean 'stages'?"},
    {"csv /nonexistent/a.json", "/nonexistent/a.json: cannot be read: No such file or directory"},
    {"schema version", "schema: 'version' is not report or machine"},
    {"machines", "machines: of what? Name a report"},
    {"machines a.json --format jsn",
     "--format: 'jsn' is not a format; use text, markdown, csv, latex or json; did you mean "
     "'json'?"},
    {"machines a.json --machine avx2 --machine avx2",
     "--machine: two machines are named 'avx2'; each needs a name of its own"},
    {"machines a.json --machine /nonexistent/m.json",
     "/nonexistent/m.json: cannot be read: No such file or directory"},
    {"crossover --kernels lockstep --resolution 48x30 --width 8",
     "--kernels: 'lockstep' does not name two kernels, with a comma between them"},
    {"crossover --from /nonexistent/a.json",
     "/nonexistent/a.json: cannot be read: No such file or directory"},
    {"tables --out /dev/null/x", "/dev/null/x: cannot be created as a directory: Not a directory"},
};

INSTANTIATE_TEST_SUITE_P(Lines, BadCommandLines, ::testing::ValuesIn(kBadLines),
                         [](const auto& info) { return fmt::format("{}", info.index); });

}  // namespace
}  // namespace lanescope
