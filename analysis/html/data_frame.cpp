// SPDX-License-Identifier: MIT
#include "analysis/html/data_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "simulator/base/error.h"

namespace lanescope {
namespace {

using Json = DataFrame::Json;

Json rounded(const Json& value) {
  if (!value.is_number_float()) return value;
  return std::strtod(fmt::format("{:.5g}", value.get<double>()).c_str(), nullptr);
}

}  // namespace

DataFrame::DataFrame(std::vector<DataColumn> columns) : columns_(std::move(columns)) {}

void DataFrame::add(std::vector<Json> row) {
  LANESCOPE_CHECK(row.size() == columns_.size(), "{} of {}", row.size(), columns_.size());
  std::transform(row.begin(), row.end(), row.begin(), rounded);
  rows_.push_back(std::move(row));
}

void DataFrame::append(const DataFrame& other) {
  LANESCOPE_CHECK(columns_ == other.columns_, "{} columns", other.columns_.size());
  rows_.insert(rows_.end(), other.rows_.begin(), other.rows_.end());
}

Json DataFrame::to_json() const {
  Json columns = Json::array();
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const DataColumn& column = columns_[c];
    Json values = Json::array();
    std::map<std::string, std::size_t> places;
    std::vector<std::string> words;
    for (const std::vector<Json>& row : rows_) {
      if (!row[c].is_string()) {
        values.push_back(row[c]);
        continue;
      }
      const auto [place, is_new] = places.emplace(row[c].get<std::string>(), words.size());
      if (is_new) words.push_back(place->first);
      values.push_back(place->second);
    }
    columns.push_back({{"name", column.name},
                       {"title", column.title},
                       {"format", column.format},
                       {"words", words},
                       {"values", std::move(values)}});
  }
  return {{"rows", rows_.size()}, {"columns", std::move(columns)}};
}

}  // namespace lanescope
