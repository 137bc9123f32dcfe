#include "app/figures/theme_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

#include "app/scene/source.h"
#include "app/shell/named_file.h"
#include "viz/colour/theme_check.h"
#include "viz/colour/two_colours.h"
#include "viz/lesson.h"
#include "viz/text/spelling.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;
using scene::Json;
using scene::Path;

/// Returns a width to a thousandth of a point, so that figures carry few digits.
double to_thousandths(double width) { return std::round(1000 * width) / 1000; }

/// Whether a role gets its colour from the two colours of a theme.
bool is_derived(const std::string& role) {
  return std::ranges::any_of(viz::main_roles, [&](viz::Role main) { return role == viz::name_of(main); });
}

bool is_built_in(const std::string& name) {
  const std::vector<std::string> all = viz::theme_names();
  return std::ranges::find(all, name) != all.end();
}

class ThemeReader {
 public:
  ThemeReader(const std::string& text, const std::string& name) : source_(text) { read_.theme.name = name; }

  ReadTheme read() {
    need_fields();
    const std::string name = json().contains("name") ? read_name() : read_.theme.name;
    read_.theme = viz::values_of(base());
    read_.theme.name = name;
    if (json().contains("hatch")) read_hatch();
    if (json().contains("font")) read_.theme.font = some_text("font", "a family, as `fc-list : family` lists them");
    if (json().contains("roles")) read_roles();
    if (json().contains("lines")) read_lines();
    if (const char* field = field_of_two(); json().contains(field)) derive(field);
    check();
    return std::move(read_);
  }

 private:
  const Json& json() const { return source_.json(); }
  const char* field_of_two() const { return json().contains("colours") ? "colours" : "colors"; }

  void need_fields() const {
    if (json().is_object()) {
      if (json().contains("colors") && json().contains("colours"))
        source_.refuse({"colours"}, "\"colors\" is the same; give one of them");
      for (const std::string& role : viz::colour_names())
        if (json().contains(role)) source_.refuse({role}, "a role stands in \"roles\": {\"" + role + "\": ...}");
    }
    source_.only(json(), {}, {"name", "based on", "colors", "roles", "lines", "hatch", "font"}, {"colours"});
  }

  std::string some_text(const std::string& field, const std::string& wanted) const {
    const Json& value = json()[field];
    if (!value.is_string() || value.get<std::string>().find_first_not_of(' ') == std::string::npos)
      source_.refuse({field}, fmt::format("{} is not allowed; give {}", value.dump(), wanted));
    return value;
  }

  std::string read_name() const {
    constexpr std::size_t longest = 80;
    const std::string name = some_text("name", "a text");
    const auto is_control = [](unsigned char c) { return c < ' ' || c == 0x7f; };
    if (name.size() > longest || std::ranges::any_of(name, is_control))
      source_.refuse({"name"}, fmt::format("give a text of one line, of at most {} bytes", longest));
    if (is_built_in(name)) source_.refuse({"name"}, fmt::format("\"{}\" is built in; give another name", name));
    return name;
  }

  viz::ThemeName base() const {
    if (!json().contains("based on")) return viz::ThemeName::print;
    const std::vector<std::string> allowed = viz::theme_names();
    const std::string name = some_text("based on", "one of " + spelling::listed(allowed));
    if (!is_built_in(name))
      source_.refuse({"based on"},
                     fmt::format("\"{}\" is not built in{}", name,
                                 spelling::instead(name, allowed, "allowed: " + spelling::listed(allowed))));
    return viz::theme_named(name);
  }

  void read_hatch() {
    if (!json()["hatch"].is_boolean()) source_.refuse({"hatch"}, "true or false is expected");
    read_.theme.hatch = json()["hatch"];
  }

  viz::Colour colour(const Json& value, const Path& path) const {
    const std::string text = value.is_string() ? value.get<std::string>() : std::string();
    const auto is_digit = [](char c) {
      return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
    };
    const bool has_digits = text.starts_with('#') && std::all_of(text.begin() + 1, text.end(), is_digit);
    std::string digits = has_digits ? text.substr(1) : std::string();
    if (digits.size() == 3) digits = {digits[0], digits[0], digits[1], digits[1], digits[2], digits[2]};
    if (digits.size() != 6)
      source_.refuse(path, fmt::format("{} is no colour; write \"#rrggbb\", such as \"#00549f\"", value.dump()));
    return viz::hex(static_cast<unsigned>(std::stoul(digits, nullptr, 16)));
  }

  void read_roles() {
    const std::vector<std::string> names = viz::colour_names();
    source_.only(json()["roles"], {"roles"}, names);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (const auto given = json()["roles"].find(names[i]); given != json()["roles"].end()) {
        if (json().contains(field_of_two()) && is_derived(names[i]))
          source_.refuse({"roles", names[i]}, fmt::format("\"{}\" gives it; leave one of the two out", field_of_two()));
        read_.theme.colours[i] = colour(*given, {"roles", names[i]});
      }
  }

  /// Reads the widths of some lines, or one factor for all.
  void read_lines() {
    constexpr double least = 0.25, most = 4;
    const Json& lines = json()["lines"];
    if (lines.is_number()) {
      const double factor = source_.number(lines, {"lines"});
      if (!(factor >= least && factor <= most))
        source_.refuse({"lines"},
                       fmt::format("{:g} times as wide is not allowed; give {:g} to {:g}", factor, least, most));
      for (double& width : read_.theme.lines) width = to_thousandths(factor * width);
      return;
    }
    if (!lines.is_object())
      source_.refuse({"lines"}, "widths in points are expected, as in {\"ray\": 1}, or a factor for all lines");
    constexpr double thinnest = 0.1, widest = 6;
    std::vector<std::string> names;
    for (const viz::NamedLine& line : viz::named_lines()) names.emplace_back(line.name);
    source_.only(lines, {"lines"}, names);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!lines.contains(names[i])) continue;
      const Path path = {"lines", names[i]};
      const double width = source_.number(lines[names[i]], path);
      if (!(width >= thinnest && width <= widest))
        source_.refuse(path, fmt::format("{:g} is not allowed; give {:g} to {:g} points", width, thinnest, widest));
      read_.theme.lines[i] = to_thousandths(width);
    }
  }

  void derive(const std::string& field) {
    const Json& two = source_.list(json()[field], {field}, 2, 2, "colours, as in [\"#00549f\", \"#f6a800\"],");
    const viz::Colour asked[] = {colour(two[0], {field, "0"}), colour(two[1], {field, "1"})};
    for (const viz::ThemeFault& fault : viz::check_theme(read_.theme).faults)  // on bad grounds no colour can be read
      if (fault.name == "background" || fault.name == "panel") return;
    try {
      viz::derive_from(read_.theme, asked[0], asked[1]);
    } catch (const viz::BadInput& e) {
      source_.refuse({field}, e.what());
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const viz::Colour& now = read_.theme.colours[i];
      read_.notes.push_back(fmt::format("{}: {}{}", viz::colour_names()[i], viz::hex_of(now),
                                        now == asked[i] ? ", as given" : ", for " + viz::hex_of(asked[i])));
    }
  }

  void check() {
    for (const viz::ThemeFault& fault : viz::check_theme(read_.theme).faults) {
      const Path path = {fault.of == viz::ThemeFault::Of::line ? "lines" : "roles", fault.name};
      read_.faults.push_back(fmt::format("{}: {}; {}", source_.place(path), fault.why, fault.cure));
    }
  }

  scene::Source source_;
  ReadTheme read_;
};

/// Throws viz::BadInput if the theme has a fault; `where` begins the message.
const viz::OwnTheme& need_readable(const ReadTheme& read, const std::string& where) {
  if (read.faults.empty()) return read.theme;
  const std::size_t more = read.faults.size() - 1;
  throw viz::BadInput(fmt::format("{}{}{}", where, read.faults.front(),
                                  more == 0 ? "" : fmt::format("; and {} more, which `isect theme` lists", more)));
}

Json theme_json(const viz::OwnTheme& theme) {
  Json json = {{"name", theme.name}, {"based on", viz::name_of(theme.based_on)}};
  const std::vector<std::string> names = viz::colour_names();
  for (std::size_t i = 0; i < names.size(); ++i) json["roles"][names[i]] = viz::hex_of(theme.colours[i]);
  for (std::size_t i = 0; i < theme.lines.size(); ++i) json["lines"][viz::named_lines()[i].name] = theme.lines[i];
  json["hatch"] = theme.hatch;
  if (!theme.font.empty()) json["font"] = theme.font;
  return json;
}

}  // namespace

ReadTheme read_theme(const std::string& text, const std::string& name) { return ThemeReader(text, name).read(); }

const ReadTheme& read_theme_file(const std::string& path) {
  static std::map<std::string, ReadTheme> read;
  if (const auto known = read.find(path); known != read.end()) return known->second;
  const std::string text = read_named_file(path), stem = fs::path(path).stem().string();
  try {
    static_cast<void>(Json(stem).dump());
  } catch (const Json::exception&) {
    throw viz::BadInput(fmt::format("theme: {}: the file's name is not UTF-8; rename it", path));
  }
  try {
    return read.emplace(path, read_theme(text, is_built_in(stem) ? "my " + stem : stem)).first->second;
  } catch (const viz::BadInput& e) {
    throw viz::BadInput(fmt::format("theme: {}: {}", path, e.what()));
  }
}

bool is_theme_file(const std::string& word) {
  std::error_code absent;
  return word.ends_with(".json") || word.find('/') != word.npos ||
         (word.find('.') != word.npos && fs::is_regular_file(word, absent));
}

viz::ThemeChoice theme_choice(const std::string& word) {
  if (word.starts_with('{')) {
    try {
      return viz::ThemeChoice(need_readable(read_theme(word, "own"), ""));
    } catch (const viz::BadInput& e) {
      throw viz::BadInput(fmt::format("theme: its text: {}", e.what()));
    }
  }
  if (!is_theme_file(word)) return viz::theme_named(word);
  return viz::ThemeChoice(need_readable(read_theme_file(word), fmt::format("theme: {}: ", word)));
}

std::string theme_text(const viz::OwnTheme& theme) { return theme_json(theme).dump(); }
std::string theme_text_by_lines(const viz::OwnTheme& theme) { return theme_json(theme).dump(2) + "\n"; }

}  // namespace isect::program
