#include "app/shell/command_line.h"

#include <fmt/format.h>

#include <algorithm>

#include "viz/lesson.h"
#include "viz/text/spelling.h"

namespace isect::program {

namespace {

const CLI::App& chosen_of(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = const_cast<CLI::App&>(app).get_subcommands();
  return chosen.empty() ? app : *chosen.front();
}

std::vector<std::string> long_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

bool is_flag(const CLI::Option& option) { return option.get_items_expected_max() == 0; }

/// Returns how an option is written: "--out DIR|-".
std::string usage(const CLI::App& app, const std::string& name) {
  const CLI::Option* option = app.get_option_no_throw(name);
  if (!option) return name;
  const std::string& value = option->get_type_name();
  return value.empty() ? name : name + (is_flag(*option) ? value : " " + value);
}

/// Returns the message for an unknown option; the program's own options, such as --version, are suggested, too.
std::string unknown_option(const CLI::App& app, const CLI::App& sub, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  const std::vector<std::string> allowed = long_options(sub);
  std::vector<std::string> meant = long_options(app);
  meant.insert(meant.begin(), allowed.begin(), allowed.end());
  return fmt::format("option: \"{}\" is unknown{}", name,
                     spelling::instead(name, meant, "allowed: " + spelling::listed(allowed)));
}

std::string one_too_many(const CLI::App& sub, const std::string& word) {
  return fmt::format("{}: \"{}\" is one argument too many; `{} --help` says what it takes", sub.get_name(), word,
                     sub.get_name());
}

std::string has_no_value(const CLI::App& app, const std::string& name) {
  return fmt::format("{}: no value is given; write {}", name, usage(app, name));
}

/// Returns the message for a wrong number of values, of an option that CLI11 names first.
std::string mismatch(const CLI::App& sub, const std::string& name) {
  const CLI::Option* option = sub.get_option_no_throw(name);
  if (!option || option->count() < 2) return has_no_value(sub, name);
  if (option->get_positional()) return one_too_many(sub, option->results().at(1));
  return fmt::format("{}: given {} times (\"{}\"); give it once", name, option->count(),
                     fmt::join(option->results(), "\", \""));
}

std::string conversion(const CLI::App& sub, const std::string& text) {
  const std::string before = "Could not convert: ";  // "Could not convert: --seed = abc"
  const std::size_t equals = text.find(" = ");
  if (!text.starts_with(before) || equals == text.npos) return text;
  const std::string name = text.substr(before.size(), equals - before.size());
  return fmt::format("{}: \"{}\" is no whole number from 0 on; write {}", name, text.substr(equals + 3),
                     usage(sub, name));
}

}  // namespace

void check_values(const CLI::App& app, const std::vector<std::string>& arguments) {
  const std::vector<const CLI::App*> chosen =
      app.get_subcommands([&](const CLI::App* s) { return !arguments.empty() && s->get_name() == arguments.front(); });
  if (chosen.empty()) return;
  const CLI::App* sub = chosen.front();
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    if (word == "--") return;  // from here on no word is an option
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const CLI::Option* option = word.starts_with("--") ? sub->get_option_no_throw(name) : nullptr;
    if (!option) continue;
    if (is_flag(*option)) {
      if (equals != word.npos && option->get_type_name().empty())
        throw viz::BadInput(fmt::format("{}: \"{}\" is no value for it; it takes none", name, word.substr(equals + 1)));
      continue;
    }
    const bool alone = equals == word.npos && i + 1 < arguments.size();  // its value is the next word
    if (alone ? arguments[i + 1].starts_with("--") : equals + 1 == word.size())
      throw viz::BadInput(has_no_value(*sub, name));
    if (alone && arguments[i + 1].empty())
      throw viz::BadInput(fmt::format("{}: empty; write {}", name, usage(*sub, name)));
    if (equals == word.npos) ++i;  // its value
  }
}

std::string complaint(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& sub = chosen_of(app);
  const std::string text = error.what();
  const std::vector<std::string> extras = app.remaining(true);
  const auto option = std::ranges::find_if(extras, [](const std::string& word) { return word.starts_with("-"); });
  if (option != extras.end()) return unknown_option(app, sub, *option);
  if (!extras.empty()) return one_too_many(sub, extras[0]);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) return mismatch(sub, text.substr(0, text.find(": ")));
  if (dynamic_cast<const CLI::ConversionError*>(&error)) return conversion(sub, text);
  if (const std::size_t excludes = text.find(" excludes ");
      dynamic_cast<const CLI::ExcludesError*>(&error) && excludes != text.npos)
    return fmt::format("{0}: give either {0} or {1}, not both", text.substr(0, excludes), text.substr(excludes + 10));
  return text;
}

}  // namespace isect::program
