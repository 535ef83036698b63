// SPDX-License-Identifier: MIT
// What is around the program: closed streams, full disks, pipes, signals, limits, terminals, names.
#include <fcntl.h>
#include <fmt/format.h>
#include <pty.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <thread>

#include "analysis/report/report_json.h"
#include "tests/cli/working_directory.h"

namespace lanescope {
namespace {

namespace fs = std::filesystem;
using testing::Outcome;

const std::string kSmall = " --scene teapot --resolution 64x40 --kernel repack --width 8";
/// More than a second of work, so that there is progress to show.
#ifdef __SANITIZE_ADDRESS__
const std::string kLong = " --scene thesis --resolution 240x150 --threads 1";
#else
const std::string kLong = " --scene thesis --resolution 640x400 --threads 1";
#endif
const std::string kListing = " --scene tigerjump --width 8 --batches 0:200000 --listing ";

class Surroundings : public testing::InEmptyDirectory {
 protected:
  /// Runs a line of bash, in which $L is the program.
  Outcome bash(const std::string& line) const {
    write("line.sh", "L='" LANESCOPE_BINARY "'\n" + line + "\n");
    Outcome outcome = testing::shell("bash line.sh", directory());
    fs::remove(directory() / "line.sh");
    return outcome;
  }
  std::size_t runs_in(const std::string& name) const {
    return read_report(directory() / name).runs.size();
  }
};

TEST_F(Surroundings, WhatCannotBePrintedIsAnErrorOfOneLine) {
  const std::string full =
      "lanescope: standard output: cannot be written: No space left on device\n";
  for (const char* arguments : {"--help", "--version", "run --help", "list kernels", "schema"}) {
    const Outcome outcome = bash(fmt::format("$L {} >/dev/full", arguments));
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_EQ(outcome.errors, full) << arguments;
  }
}

TEST_F(Surroundings, NoFileTakesThePlaceOfAClosedStream) {
  const Outcome no_output = bash("$L run" + kSmall + " --json r.json >&-");
  EXPECT_EQ(no_output.status, 2);
  EXPECT_EQ(no_output.errors,
            "lanescope: standard output: cannot be written: Bad file descriptor\n");
  EXPECT_EQ(runs_in("r.json"), 1u);
  EXPECT_EQ(bash("$L csv r.json -o r.csv <&- >&- 2>&-").status, 0);
  EXPECT_EQ(file("r.csv").rfind("report,run,", 0), 0u);
  EXPECT_EQ(bash("$L run" + kLong + " --json s.json >/dev/null 2>&-").status, 0);
  EXPECT_GT(runs_in("s.json"), 1u);
}

TEST_F(Surroundings, ALimitOnFilesIsAnErrorAndLeavesNothing) {
  run("run" + kSmall + " --json r.json");
  const Outcome page = bash("ulimit -f 8; $L report r.json -o r.html");
  EXPECT_EQ(page.status, 2);
  EXPECT_EQ(page.errors, "lanescope: r.html: cannot be written: File too large\n");
  EXPECT_EQ(entries(), std::set<std::string>{"r.json"});
}

TEST_F(Surroundings, TablesArePrintedThoughTheReportCannotBeWritten) {
  const Outcome outcome =
      bash("(ulimit -f 8; exec $L run" + kSmall + " --json r.json) | cat; exit ${PIPESTATUS[0]}");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.output, run("run" + kSmall).output);
  EXPECT_EQ(outcome.errors, "lanescope: r.json: cannot be written: File too large\n");
  EXPECT_EQ(entries(), std::set<std::string>{});
}

TEST_F(Surroundings, PipesAndStandardOutputTakeReports) {
  ASSERT_EQ(::mkfifo((directory() / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(
      bash("cat pipe >named.json & $L run" + kSmall + " --json pipe; s=$?; wait; exit $s").status,
      0);
  EXPECT_TRUE(fs::is_fifo(directory() / "pipe"));
  EXPECT_EQ(
      bash("$L run" + kSmall + " --json >(cat >sub.json); s=$?; wait; sleep 1; exit $s").status, 0);
  write("out.json", bash("$L run" + kSmall + " --json /dev/stdout").output);
  write("through.json", bash("$L run" + kSmall + " --json /dev/stdout | cat").output);
  for (const char* name : {"named.json", "sub.json", "out.json", "through.json"})
    EXPECT_EQ(runs_in(name), 1u) << name;
}

TEST_F(Surroundings, AClosedPipeEndsTheProgramQuietly) {
  const Outcome outcome = bash(
      "$L trace --scene teapot --width 8 --batches 0:2000 --chrome u.json --listing - | head -1; "
      "exit ${PIPESTATUS[0]}");
  EXPECT_EQ(outcome.status, 128 + SIGPIPE);
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1);
  EXPECT_EQ(outcome.errors, "");
  EXPECT_EQ(entries(), std::set<std::string>{});
}

TEST_F(Surroundings, SignalsLeaveNothingBehind) {
  // Not in the background, where a shell ignores SIGINT.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU}) {
    const Outcome outcome = bash(fmt::format(
        "ulimit -c 0; (until [ -s l.txt.tmp-* ]; do sleep 0.01; done; "
        "n=$(echo l.txt.tmp-*); kill -{} ${{n#l.txt.tmp-}}) & $L trace{}l.txt --chrome c.json",
        signal, kListing));
    EXPECT_EQ(outcome.status, 128 + signal);
    EXPECT_NE(outcome.errors.find("lanescope: trace: interrupted\n"), std::string::npos)
        << outcome.errors;
    EXPECT_EQ(entries(), std::set<std::string>{});
  }
}

TEST_F(Surroundings, SignalsThatAreIgnoredStayIgnored) {
  const Outcome outcome = bash("trap '' HUP PIPE; $L trace" + kListing +
                               "l.txt & until [ -s l.txt.tmp-$! ]; do sleep 0.01; done; "
                               "kill -HUP $!; sleep 0.1; kill -0 $! && kill -TERM $!; wait $!");
  EXPECT_EQ(outcome.status, 128 + SIGTERM);
  EXPECT_EQ(entries(), std::set<std::string>{});
  const Outcome pipe =
      bash("trap '' PIPE; $L trace" + kListing + "- | head -1 >/dev/null; exit ${PIPESTATUS[0]}");
  EXPECT_EQ(pipe.status, 2);
  EXPECT_EQ(pipe.errors, "lanescope: standard output: cannot be written: Broken pipe\n");
}

TEST_F(Surroundings, NamesAreData) {
  write("=1+1.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  run("run --mesh =1+1.obj --resolution 64x40 --kernel repack --width 8 --json r.json");
  EXPECT_NE(run("csv r.json --rows runs").output.find(",'=1+1.obj,"), std::string::npos);
  bash("mv r.json $'w\\xfc.json'");
  EXPECT_EQ(bash("$L merge $'w\\xfc.json' -o merged.json").status, 0);
  EXPECT_EQ(read_report(directory() / "merged.json").command, "lanescope merge $'w\\xfc.json'");
  EXPECT_EQ(bash("$L report $'w\\xfc.json' -o page.html").status, 0);
  EXPECT_EQ(bash("$L compare $'w\\xfc.json' merged.json --format json").status, 0);
  EXPECT_EQ(bash("$L csv $'no\\x1b\\nw\\xfc.json'").errors,
            "lanescope: no\\x1b\\nw\\xfc.json: cannot be read: No such file or directory\n");
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_F(Surroundings, WhatCannotBeHadIsSaidInOneLine) {
  const Outcome memory =
      bash("ulimit -v 1000000; $L run --resolution 2048x2048 --msaa 64 --threads 1 --json r.json");
  EXPECT_EQ(memory.status, 2);
  EXPECT_NE(
      memory.errors.find("lanescope: outputs (frames) take 2.1 GB of memory\nlanescope: memory: "
                         "outputs (frames) take 2.1 GB, and "),
      std::string::npos)
      << memory.errors;
  EXPECT_EQ(std::count(memory.errors.begin(), memory.errors.end(), '\n'), 2);
  const Outcome threads = bash("ulimit -v 1000000; $L run" + kSmall + " --threads 256");
  EXPECT_EQ(threads.status, 0);
  EXPECT_EQ(threads.errors.rfind("lanescope: --threads: only ", 0), 0u) << threads.errors;
  EXPECT_EQ(threads.output, run("run" + kSmall).output);
}
#endif

/// What a run of over a second shows on a terminal of that kind and width.
std::string shown_on_terminal(const char* kind, unsigned short columns) {
  const winsize size{24, columns, 0, 0};
  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, &size);
  if (child == 0) {
    ::setenv("TERM", kind, 1);
    ::execl("/bin/sh", "sh", "-c", ("'" LANESCOPE_BINARY "' run" + kLong + " >/dev/null").c_str(),
            nullptr);
    ::_exit(1);
  }
  std::string shown;
  char buffer[256];
  for (ssize_t count; (count = ::read(terminal, buffer, sizeof buffer)) > 0;)
    shown.append(buffer, static_cast<std::size_t>(count));
  int ended = 0;
  ::waitpid(child, &ended, 0);
  ::close(terminal);
  EXPECT_TRUE(WIFEXITED(ended) && WEXITSTATUS(ended) == 0) << shown;
  return shown;
}

TEST(Terminals, GetProgressThatTheyCanShow) {
  EXPECT_EQ(shown_on_terminal("dumb", 80).find('\033'), std::string::npos);
  std::string narrow = shown_on_terminal("xterm", 20);
  EXPECT_NE(narrow.find("\r\033[K"), std::string::npos) << "shows no progress";
  for (std::size_t at; (at = narrow.find("\033[K")) != narrow.npos;) narrow.replace(at, 3, "\n");
  std::size_t longest = 0, length = 0;
  for (const char c : narrow) {
    length = c == '\r' || c == '\n' ? 0 : length + 1;
    longest = std::max(longest, length);
  }
  EXPECT_LT(longest, 20u) << narrow;
}

}  // namespace
}  // namespace lanescope
