// SPDX-License-Identifier: MIT
// Every command that reads reports refuses what is none, with one line that names the file, status
// 2, and nothing written.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "tests/cli/working_directory.h"

namespace lanescope {
namespace {

using Json = nlohmann::ordered_json;

/// A way to spoil the text of a report, and what the complaint about it has in it.
struct Spoiled {
  std::string name;
  std::function<std::string(std::string)> spoil;
  std::string complaint;
};

std::function<std::string(std::string)> changed(const std::function<void(Json&)>& change) {
  return [change](const std::string& text) {
    Json json = Json::parse(text);
    change(json);
    return json.dump();
  };
}

const std::vector<Spoiled>& spoiled() {
  static const std::vector<Spoiled> all{
      {"truncated", [](const std::string& text) { return text.substr(0, text.size() / 2); },
       "bad.json:"},
      {"empty", [](const std::string&) { return std::string(); }, "bad.json:"},
      {"unknown key", changed([](Json& json) { json["runs"][0]["extra"] = 1; }),
       "bad.json:/runs/0: unknown member 'extra'"},
      {"wrong type", changed([](Json& json) { json["runs"][0]["parameters"]["frame"] = "1"; }),
       "bad.json:/runs/0/parameters/frame: \"1\" is not an integer"},
      {"newer version", changed([](Json& json) { json["schema"]["version"] = 99; }),
       "bad.json:/schema/version: version 99 is newer than 3"},
      {"version 1", changed([](Json& json) { json["schema"]["version"] = 1; }),
       "bad.json:/schema/version: version 1 is older than 3"},
      {"version 2", changed([](Json& json) { json["schema"]["version"] = 2; }),
       "bad.json:/schema/version: version 2 is older than 3, the only one that this program reads; "
       "make the report again, as with `lanescope run --kernel repack --width 8 --scene teapot "
       "--resolution 48x30`\n"},
      {"missing key", changed([](Json& json) { json["runs"][0].erase("stages"); }),
       "bad.json:/runs/0: the member 'stages' is missing"},
  };
  return all;
}

class BadReports : public testing::InEmptyDirectory {
 protected:
  BadReports() {
    run("run --scene teapot --resolution 48x30 --kernel repack --width 8 --json good.json");
  }

  /// Expects one line about the mistake and that no file has come into being.
  void refuses(const std::string& arguments, const std::string& complaint) {
    const auto before = entries();
    const auto outcome = run(arguments, 2);
    EXPECT_EQ(outcome.output, "") << arguments;
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    EXPECT_EQ(outcome.errors.rfind("lanescope: " + complaint, 0), 0u) << arguments << "\n"
                                                                      << outcome.errors;
    EXPECT_EQ(entries(), before) << arguments;
  }

  /// The commands that read `file`.
  static std::vector<std::string> readers(const std::string& file) {
    return {"tables --from " + file,
            "study luong --from " + file,
            "show " + file,
            "annotate --from " + file,
            "report " + file + " -o page.html",
            "csv " + file + " -o rows.csv",
            "compare good.json " + file + " -o changes.txt",
            "compare " + file + " good.json",
            "merge good.json " + file + " -o merged.json"};
  }
};

TEST_F(BadReports, AreRefusedByEveryCommand) {
  for (const Spoiled& way : spoiled()) {
    SCOPED_TRACE(way.name);
    write("bad.json", way.spoil(file("good.json")));
    for (const std::string& command : readers("bad.json")) refuses(command, way.complaint);
  }
}

TEST_F(BadReports, AMissingFileIsNamed) {
  for (const std::string& command : readers("none.json"))
    refuses(command, "none.json: cannot be read: No such file or directory");
}

TEST_F(BadReports, AnUnwritableOutputIsFoundBeforeTheWork) {
  const std::string place = "no-such-directory/file";
  for (const std::string command :
       {"run --scene teapot --resolution 48x30 --json ", "report good.json -o ",
        "csv good.json -o ", "compare good.json good.json -o ", "merge good.json -o ",
        "render --scene teapot --resolution 48x30 -o ",
        "trace --scene teapot --resolution 96x60 --png ",
        "trace --scene teapot --resolution 96x60 --listing "})
    refuses(command + place, place + ": cannot be written: No such file or directory");
}

}  // namespace
}  // namespace lanescope
