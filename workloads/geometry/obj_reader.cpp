// SPDX-License-Identifier: MIT
#include "workloads/geometry/obj_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "simulator/base/error.h"
#include "workloads/geometry/file_signature.h"
#include "workloads/geometry/obj_words.h"

namespace lanescope {
namespace {

/// What is done with a statement.
enum class Use {
  kPosition,
  kNormal,
  kFace,
  kNames,    ///< Left out; it is of names.
  kValues,   ///< Left out; it is of numbers.
  kSkip,     ///< Left out, and counted: it is something to see.
  kUnknown,  ///< Likewise; it may be a name or a number.
};

struct Keyword {
  std::string_view word;
  Use use;
};

constexpr Keyword kKeywords[] = {
    {"v", Use::kPosition},      {"vn", Use::kNormal},    {"f", Use::kFace},
    {"fo", Use::kFace},         {"vt", Use::kValues},    {"vp", Use::kValues},
    {"g", Use::kNames},         {"o", Use::kNames},      {"s", Use::kNames},
    {"mg", Use::kNames},        {"usemtl", Use::kNames}, {"mtllib", Use::kNames},
    {"usemap", Use::kNames},    {"maplib", Use::kNames}, {"shadow_obj", Use::kNames},
    {"trace_obj", Use::kNames}, {"bevel", Use::kNames},  {"c_interp", Use::kNames},
    {"d_interp", Use::kNames},  {"lod", Use::kNames},    {"p", Use::kSkip},
    {"l", Use::kSkip},          {"curv", Use::kSkip},    {"curv2", Use::kSkip},
    {"surf", Use::kSkip},       {"bzp", Use::kSkip},     {"bsp", Use::kSkip},
    {"cdc", Use::kSkip},        {"cdp", Use::kSkip},     {"parm", Use::kValues},
    {"trim", Use::kValues},     {"hole", Use::kValues},  {"scrv", Use::kValues},
    {"sp", Use::kValues},       {"end", Use::kValues},   {"con", Use::kValues},
    {"deg", Use::kValues},      {"bmat", Use::kValues},  {"step", Use::kValues},
    {"cstype", Use::kValues},   {"ctech", Use::kValues}, {"stech", Use::kValues},
    {"res", Use::kValues},      {"call", Use::kUnknown}, {"csh", Use::kUnknown},
};

Use use_of(std::string_view word) {
  const auto found = std::find_if(std::begin(kKeywords), std::end(kKeywords),
                                  [word](const Keyword& k) { return k.word == word; });
  return found == std::end(kKeywords) ? Use::kUnknown : found->use;
}

std::string suggestion(std::string_view word) {
  constexpr std::size_t kShortest = 2, kLongest = 16;  // Others are like all or none of them.
  if (word.size() < kShortest || word.size() > kLongest) return {};
  std::vector<std::string> words;
  for (const Keyword& k : kKeywords) words.emplace_back(k.word);
  return did_you_mean(word, words);
}

/// Cutting a face that is not convex takes time in proportion to the square of its corners.
constexpr std::size_t kMostCorners = 100000;

/// How often something was found, and where first.
struct Finding {
  std::string_view one, many;
  std::size_t count = 0;
  std::size_t line = 0;
  std::string first{};  ///< The first of them, if that tells more.

  void add(std::size_t line_here) {
    if (count++ == 0) line = line_here;
  }
};

/// Those that have found something, in words; empty if there are none.
std::string text_of(std::initializer_list<const Finding*> findings) {
  std::string text;
  for (const Finding* t : findings) {
    if (t->count == 0) continue;
    text += fmt::format("{}{} {} (first in line {}{})", text.empty() ? "" : "; ", t->count,
                        t->count == 1 ? t->one : t->many, t->line,
                        t->first.empty() ? "" : fmt::format(", '{}'", t->first));
  }
  return text;
}

/// Parses the whole of a word; too large numbers are the largest.
std::optional<std::int64_t> parse_index(std::string_view word) {
  if (word.starts_with('+') && !word.substr(1).starts_with('-')) word.remove_prefix(1);
  std::int64_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc::invalid_argument || stop != end) return {};
  if (error == std::errc::result_out_of_range) return word.starts_with('-') ? INT64_MIN : INT64_MAX;
  return value;
}

/// The unit vector along `n`; zero if it is zero or not finite.
Vec3 direction(const Point3& n) {
  const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
  if (!(largest > 0.0) || !std::isfinite(n.x + n.y + n.z)) return {};
  const Point3 scaled{n.x / largest, n.y / largest, n.z / largest};
  const Point3 unit = scaled * (1.0 / std::sqrt(dot(scaled, scaled)));
  return {static_cast<float>(unit.x), static_cast<float>(unit.y), static_cast<float>(unit.z)};
}

class Reader {
 public:
  Reader(std::string_view text, std::string_view path) : text_(text), path_(path), words_(text) {}

  PolygonMesh read(const std::function<void(double)>& progress) {
    constexpr int kStatementsBetween = 1 << 14;
    for (int i = 1; words_.next_statement(); ++i) {
      statement(words_.word());
      if (progress && i % kStatementsBetween == 0)
        progress(static_cast<double>(words_.offset()) / static_cast<double>(text_.size()));
    }
    require_faces();
    check_vertices();
    drop_unusable_normals();
    tell();
    return std::move(mesh_);
  }

 private:
  enum Values { kAny, kFinite };

  template <class... Args>
  [[noreturn]] void fail_at(std::size_t line, fmt::format_string<Args...> format,
                            Args&&... args) const {
    throw InputError(fmt::format("{}:{}", path_, line), format, std::forward<Args>(args)...);
  }
  template <class... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) const {
    fail_at(words_.line(), format, std::forward<Args>(args)...);
  }

  void statement(std::string_view keyword) {
    switch (use_of(keyword)) {
      case Use::kPosition:
        mesh_.positions.push_back(coordinates("vertex", "v x y z", kFinite));
        return;
      case Use::kNormal:
        mesh_.normals.push_back(direction(coordinates("normal", "vn x y z", kAny)));
        return;
      case Use::kFace:
        face();
        return;
      case Use::kNames:
        words_.skip_names();
        return;
      case Use::kValues:
        words_.skip_words();
        return;
      case Use::kSkip:
        not_polygons_.add(words_.line());
        words_.skip_words();
        return;
      case Use::kUnknown:
        unknown(keyword);
        return;
    }
  }

  void unknown(std::string_view keyword) {
    // Not a word: a line that was broken, or no OBJ file.
    const char letter = static_cast<char>(keyword[0] | 0x20);
    if (letter < 'a' || letter > 'z') refuse(words_.line(), keyword);
    if (unknown_.count == 0) unknown_.first = shown(keyword);
    unknown_.add(words_.line());
    words_.skip_names();
  }

  [[noreturn]] void refuse(std::size_t line, std::string_view keyword) const {
    fail_at(line, "'{}' is not a statement of an OBJ file{}", shown(keyword), suggestion(keyword));
  }

  /// Three numbers; more of them are weights and colours.
  Point3 coordinates(std::string_view what, std::string_view form, Values allowed) {
    std::array<double, 3> values{};
    std::size_t count = 0;
    for (std::string_view word = words_.word(); !word.empty(); word = words_.word()) {
      const std::optional<double> value = obj_number(word);
      if (!value) fail("'{}' is not a number; use '{}'", shown(word), form);
      if (count++ >= values.size()) continue;
      if (allowed == kFinite && !std::isfinite(*value))
        fail("'{}' is {}; use finite coordinates", shown(word),
             std::isnan(*value) ? "not a number" : "infinite");
      values[count - 1] = *value;
    }
    if (count < values.size()) fail("a {} of {} coordinates; use '{}'", what, count, form);
    return {values[0], values[1], values[2]};
  }

  void face() {
    std::vector<PolygonMesh::Corner>& corners = mesh_.corners;
    const std::size_t begin = corners.size();
    for (std::string_view word = words_.word(); !word.empty(); word = words_.word()) {
      const PolygonMesh::Corner next = corner(word);
      if (corners.size() == begin + kMostCorners)
        fail("a face of more than {} corners; cut it into several", kMostCorners);
      if (corners.size() == begin || corners.back().vertex != next.vertex) corners.push_back(next);
    }
    while (corners.size() > begin + 1 && corners.back().vertex == corners[begin].vertex)
      corners.pop_back();
    if (corners.size() < begin + 3) {
      short_faces_.add(words_.line());
      corners.resize(begin);
      return;
    }
    mesh_.face_ends.push_back(corners.size());
    face_lines_.push_back(words_.line());
  }

  /// A corner is vertex, vertex/texture, vertex//normal or vertex/texture/normal.
  PolygonMesh::Corner corner(std::string_view word) {
    PolygonMesh::Corner result;
    std::string_view rest = word;
    for (int part = 0; part < 3; ++part) {
      const std::size_t slash = rest.find('/');
      const std::string_view text = rest.substr(0, slash);
      const std::optional<std::int64_t> index = parse_index(text);
      if (!index && (part == 0 || !text.empty()))
        fail("'{}' is not a corner of a face; use v, v/t, v//n or v/t/n", shown(word));
      if (part == 0) result.vertex = vertex(*index, word);
      if (part == 1 && index == 0) zero_textures_.add(words_.line());
      if (part == 2 && index) result.normal = normal(*index);
      if (slash == std::string_view::npos) return result;
      rest.remove_prefix(slash + 1);
    }
    fail("'{}' is not a corner of a face; use v, v/t, v//n or v/t/n", shown(word));
  }

  /// An index into positions, perhaps into those that come later.
  std::uint32_t vertex(std::int64_t index, std::string_view word) const {
    const auto count = static_cast<std::int64_t>(mesh_.positions.size());
    if (index == 0) fail("index 0 in '{}'; vertices are counted from 1", shown(word));
    if (index < -count) fail("vertex {} counts back past the first of {} vertices", index, count);
    if (index > PolygonMesh::kNone)
      fail("vertex {} of a face; a mesh has at most {} vertices", index, PolygonMesh::kNone);
    return static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
  }

  /// An index into normals, perhaps into those that come later.
  std::uint32_t normal(std::int64_t index) {
    const auto count = static_cast<std::int64_t>(mesh_.normals.size());
    if (index == 0) zero_normals_.add(words_.line());
    if (index < -count || index > PolygonMesh::kNone) missing_normals_.add(words_.line());
    if (index == 0 || index < -count || index > PolygonMesh::kNone) return PolygonMesh::kNone;
    return static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
  }

  void require_faces() const {
    if (!mesh_.face_ends.empty()) return;
    if (unknown_.count > 0) refuse(unknown_.line, unknown_.first);
    const std::string skipped =
        skipped_text().empty() ? "" : fmt::format("; skipped {}", skipped_text());
    if (mesh_.positions.empty())
      throw InputError(path_, "has no vertices; a mesh needs lines 'v x y z'{}", skipped);
    throw InputError(path_, "has no faces; a mesh needs lines 'f a b c'{}", skipped);
  }

  /// Calls use(corner, line) for every corner.
  template <class Visit>
  void for_corners(Visit visit) {
    std::size_t i = 0;
    for (std::size_t face = 0; face < mesh_.face_ends.size(); ++face)
      for (; i < mesh_.face_ends[face]; ++i) visit(mesh_.corners[i], face_lines_[face]);
  }

  void check_vertices() {
    const std::size_t count = mesh_.positions.size();
    for_corners([&](const PolygonMesh::Corner& corner, std::size_t line) {
      if (corner.vertex >= count)
        fail_at(line, "vertex {} of a face, but the file has {} vertices",
                std::uint64_t{corner.vertex} + 1, count);
    });
  }

  void drop_unusable_normals() {
    for_corners([&](PolygonMesh::Corner& corner, std::size_t line) {
      if (corner.normal == PolygonMesh::kNone) return;
      const bool missing = corner.normal >= mesh_.normals.size();
      if (!missing && dot(mesh_.normals[corner.normal], mesh_.normals[corner.normal]) > 0.0f)
        return;
      (missing ? missing_normals_ : no_directions_).add(line);
      corner.normal = PolygonMesh::kNone;
    });
  }

  std::string skipped_text() const {
    return text_of({&short_faces_, &not_polygons_, &unknown_, &zero_textures_});
  }

  void tell() {
    if (const std::string text = skipped_text(); !text.empty())
      mesh_.notes.push_back(fmt::format("{}: skipped {}", path_, text));
    if (const std::string text = text_of({&zero_normals_, &missing_normals_, &no_directions_});
        !text.empty())
      mesh_.notes.push_back(
          fmt::format("{}: corners without a usable normal have the average of the faces there: {}",
                      path_, text));
  }

  std::string_view text_;
  std::string_view path_;
  ObjWords words_;
  PolygonMesh mesh_;
  std::vector<std::size_t> face_lines_;
  Finding short_faces_{"face of fewer than 3 different corners",
                       "faces of fewer than 3 different corners"};
  Finding not_polygons_{"point, line, curve or surface", "points, lines, curves or surfaces"};
  Finding unknown_{"other statement", "other statements"};
  Finding zero_textures_{"texture index 0", "texture indices 0"};
  Finding zero_normals_{"index 0", "indices 0"};
  Finding missing_normals_{"index of a normal that the file does not hold",
                           "indices of normals that the file does not hold"};
  Finding no_directions_{"normal that is zero or not finite",
                         "normals that are zero or not finite"};
};

/// Fillers at the end of a text: of blocks, and of files of old systems.
std::string_view without_end_marks(std::string_view text) {
  constexpr std::string_view kEndMarks("\0\x1a", 2);
  return text.substr(0, text.find_last_not_of(kEndMarks) + 1);
}

}  // namespace

PolygonMesh read_obj(std::string_view text, std::string_view path,
                     const std::function<void(double)>& progress) {
  text = without_end_marks(text);
  if (text.empty()) throw InputError(path, "is empty; use a Wavefront OBJ file");
  if (const std::string_view kind = unreadable_kind(text); !kind.empty())
    throw InputError(path, "{}", kind);
  return Reader(text, path).read(progress);
}

}  // namespace lanescope
