// SPDX-License-Identifier: MIT
// Parameters: what a user can set. Each is declared once, in a row below the struct whose member it
// sets; the command line, sweeps, reports, their schema and what identifies a run follow from it.
//
//   struct Options {
//     bool cull = true;
//     float threshold = 0.0f;
//   };
//   inline const Parameters<Options>& parameters() {
//     static const Parameters<Options> all{
//         {&Options::cull, {"cull", "--cull", kNoUnit, "Drop what faces away"}},
//         {&Options::threshold, {"threshold", "--threshold", "lanes / W", "Load from ..."},
//         0.0f, 1.0f},
//     };
//     return all;
//   }
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "simulator/base/choice.h"
#include "simulator/base/error.h"

namespace lanescope {

/// The value of a parameter: a switch, an integer, a number, or a word. Nothing stands for "does
/// not apply" or, before a configuration is resolved, for "as the scene has it".
using Value = std::variant<std::monostate, bool, std::uint64_t, float, std::string>;

inline constexpr std::string_view kNoUnit = "";

/// Whether tables state a parameter that is as by default.
enum class Stated { kIfSpecial, kAlways };

/// What a parameter is called, and what it is for.
struct ParameterWords {
  std::string_view name;    ///< In reports and sweeps, snake_case.
  std::string_view option;  ///< On the command line, with its dashes; parameters of one option are
                            ///< given together, with an `x` between them.
  std::string_view unit;    ///< Or kNoUnit.
  std::string_view help;    ///< A sentence without its full stop.
  /// Always, if figures that differ in it are not of the same thing.
  Stated stated = Stated::kIfSpecial;
};

/// A parameter as everyone but its owner sees it.
struct Parameter {
  enum class Kind { kSwitch, kInteger, kNumber, kChoice, kText };

  ParameterWords words;
  Kind kind = Kind::kText;
  /// Nothing if the default depends on the scene, or on whether the parameter applies to it.
  Value fallback;
  std::uint64_t low = 0;  ///< Of integers.
  std::uint64_t high = std::numeric_limits<std::uint64_t>::max();
  float least = std::numeric_limits<float>::lowest();  ///< Of numbers.
  float most = std::numeric_limits<float>::max();
  std::vector<std::uint64_t> allowed;     ///< The only integers, if not empty.
  std::vector<std::string_view> choices;  ///< The only words, of kChoice.

  std::string_view name() const { return words.name; }
  /// Whether a value of the right type may be had: `allowed_values` says which.
  bool allows(const Value& value) const;
  /// `an integer from 1 to 64`, `a number from 0 to 1`, `on or off`, `inline or precomputed`.
  std::string allowed_values() const;
};

/// A value that a parameter cannot have, perhaps only beside others.
class ParameterError : public InputError {
 public:
  /// `message` says what was found and what would be right.
  ParameterError(const ParameterWords& words, std::string message)
      : InputError(words.option, "{}", message), name_(words.name), message_(std::move(message)) {}
  const std::string& parameter() const { return name_; }
  /// Without the option, for those who know a better place.
  const std::string& message() const { return message_; }

 private:
  std::string name_;
  std::string message_;
};

/// Values by the names of their parameters, in an order.
class Arguments {
 public:
  struct Argument {
    std::string name;
    Value value;
    bool operator==(const Argument&) const = default;
  };

  /// The value of that name; nothing if there is none.
  const Value& operator[](std::string_view name) const;
  bool contains(std::string_view name) const;
  /// Adds a value at the end, or changes the one that is there.
  void set(std::string_view name, Value value);
  const std::vector<Argument>& all() const& { return all_; }
  /// Of a temporary: a loop over them keeps them.
  std::vector<Argument> all() && { return std::move(all_); }
  bool operator==(const Arguments&) const = default;

 private:
  std::vector<Argument> all_;
};

/// The text of a value as the command line takes it: `on`, `16`, `0.5`, `inline`; `none` for
/// nothing.
std::string value_text(const Value& value);

namespace detail {

template <class T>
struct OptionalOf {
  using type = T;
};
template <class T>
struct OptionalOf<std::optional<T>> {
  using type = T;
};

template <class T>
Value to_value(const T& member) {
  if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, float>)
    return member;
  else if constexpr (std::is_integral_v<T>)
    return static_cast<std::uint64_t>(member);
  else
    return std::string(member);
}

template <class T>
T from_value(const Value& value) {
  if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, float> ||
                std::is_same_v<T, std::string>)
    return std::get<T>(value);
  else
    return static_cast<T>(std::get<std::uint64_t>(value));
}

}  // namespace detail

/// A parameter and the member of Options that it sets. A member that is optional has its default
/// from the scene.
template <class Options>
class Binding {
 public:
  /// A switch, or words of any kind.
  template <class M>
  Binding(M Options::*member, const ParameterWords& words) : Binding(member, words, Plain{}) {
    using T = typename detail::OptionalOf<M>::type;
    static_assert(std::is_same_v<T, bool> || std::is_same_v<T, std::string>,
                  "say what integers, numbers or choices are allowed");
    parameter_.kind = std::is_same_v<T, bool> ? Parameter::Kind::kSwitch : Parameter::Kind::kText;
  }

  /// An integer from low to high.
  template <class M, std::integral Integer>
  Binding(M Options::*member, const ParameterWords& words, Integer low, Integer high)
      : Binding(member, words, Plain{}) {
    parameter_.kind = Parameter::Kind::kInteger;
    parameter_.low = static_cast<std::uint64_t>(low);
    parameter_.high = static_cast<std::uint64_t>(high);
  }

  /// A number from least to most.
  template <class M>
  Binding(M Options::*member, const ParameterWords& words, float least, float most)
      : Binding(member, words, Plain{}) {
    parameter_.kind = Parameter::Kind::kNumber;
    parameter_.least = least;
    parameter_.most = most;
  }

  /// One of a few integers.
  template <class M>
  Binding(M Options::*member, const ParameterWords& words, std::span<const int> allowed)
      : Binding(member, words, Plain{}) {
    parameter_.kind = Parameter::Kind::kInteger;
    parameter_.allowed.assign(allowed.begin(), allowed.end());
  }

  /// One of a few words. `choices` must outlive the binding.
  template <class M, std::size_t kCount, class T = typename detail::OptionalOf<M>::type>
  Binding(M Options::*member, const ParameterWords& words,
          const std::array<Choice<T>, kCount>& choices) {
    parameter_.words = words;
    parameter_.kind = Parameter::Kind::kChoice;
    for (const Choice<T>& choice : choices) parameter_.choices.push_back(choice.name);
    get_ = [member, &choices](const Options& options) -> Value {
      const M& value = options.*member;
      if constexpr (std::is_same_v<M, T>)
        return std::string(name_of(choices, value));
      else
        return value ? Value(std::string(name_of(choices, *value))) : Value();
    };
    set_ = [member, &choices](Options& options, const Value& value) {
      options.*member = *find_choice(choices, std::get<std::string>(value));
    };
    parameter_.fallback = get_(Options{});
  }

  const Parameter& parameter() const { return parameter_; }
  Value get(const Options& options) const { return get_(options); }
  void set(Options& options, const Value& value) const { set_(options, value); }

 private:
  struct Plain {};

  template <class M>
  Binding(M Options::*member, const ParameterWords& words, Plain) {
    using T = typename detail::OptionalOf<M>::type;
    parameter_.words = words;
    get_ = [member](const Options& options) -> Value {
      const M& value = options.*member;
      if constexpr (std::is_same_v<M, T>)
        return detail::to_value(value);
      else
        return value ? detail::to_value(*value) : Value();
    };
    set_ = [member](Options& options, const Value& value) {
      options.*member = detail::from_value<T>(value);
    };
    parameter_.fallback = get_(Options{});
  }

  Parameter parameter_;
  std::function<Value(const Options&)> get_;
  std::function<void(Options&, const Value&)> set_;
};

/// All parameters of a struct, in their order.
template <class Options>
using Parameters = std::vector<Binding<Options>>;

/// The options that the arguments ask for; members without an argument, or with nothing for one,
/// keep their defaults. Requires values that the parameters allow.
template <class Options>
Options decoded(const Parameters<Options>& parameters, const Arguments& arguments) {
  Options options;
  for (const Binding<Options>& binding : parameters) {
    const Value& value = arguments[binding.parameter().name()];
    if (!std::holds_alternative<std::monostate>(value)) binding.set(options, value);
  }
  return options;
}

/// The arguments that stand for options.
template <class Options>
Arguments encoded(const Parameters<Options>& parameters, const Options& options) {
  Arguments arguments;
  for (const Binding<Options>& binding : parameters)
    arguments.set(binding.parameter().name(), binding.get(options));
  return arguments;
}

/// The rows of several tables as one list.
template <class... Tables>
std::vector<Parameter> joined(const Tables&... tables) {
  std::vector<Parameter> all;
  const auto add = [&](const auto& table) {
    for (const auto& binding : table) all.push_back(binding.parameter());
  };
  (add(tables), ...);
  return all;
}

}  // namespace lanescope
