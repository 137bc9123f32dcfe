#include "app/figures/theme_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/scene/source.h"
#include "viz/colour/theme_check.h"
#include "viz/colour/two_colours.h"
#include "viz/lesson.h"
#include "viz/text/spelling.h"

namespace isect::program {

namespace {

using scene::Json;
using scene::Path;

/// Returns a width to a thousandth of a point, so that figures carry few digits.
double to_thousandths(double width) { return std::round(1000 * width) / 1000; }

/// Whether a role gets its colour from the two colours of a theme.
bool is_derived(const std::string& role) {
  return std::ranges::any_of(viz::main_roles, [&](viz::Role main) { return role == viz::name_of(main); });
}

class ThemeReader {
 public:
  ThemeReader(const std::string& text, const std::string& name)
      : source_(text), name_(can_be_name(name) ? name : "own") {}

  ReadTheme read() {
    need_fields();
    const std::string name = json().contains("name") ? read_name() : name_;
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
  static constexpr std::size_t longest_name = 80;

  static bool can_be_name(const std::string& name) try {
    static_cast<void>(Json(name).dump());  // throws what is not UTF-8
    const auto is_control = [](unsigned char c) { return c < ' ' || c == 0x7f; };
    return name.find_first_not_of(' ') != name.npos && name.size() <= longest_name && !viz::is_theme_name(name) &&
           std::none_of(name.begin(), name.end(), is_control);
  } catch (const Json::exception&) {
    return false;
  }

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
    const std::string name = some_text("name", "a text");
    if (viz::is_theme_name(name)) source_.refuse({"name"}, fmt::format("\"{}\" is built in; give another name", name));
    if (!can_be_name(name)) source_.refuse({"name"}, fmt::format("give one line of at most {} bytes", longest_name));
    return name;
  }

  viz::ThemeName base() const {
    if (!json().contains("based on")) return viz::ThemeName::print;
    const std::vector<std::string> allowed = viz::theme_names();
    const std::string name = some_text("based on", "one of " + spelling::listed(allowed));
    if (!viz::is_theme_name(name))
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
    constexpr double least = 0.25, most = 2.5;  // so that each width is allowed
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
    std::vector<std::string> names;
    for (const viz::NamedLine& line : viz::named_lines()) names.emplace_back(line.name);
    source_.only(lines, {"lines"}, names);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!lines.contains(names[i])) continue;
      const Path path = {"lines", names[i]};
      const double width = source_.number(lines[names[i]], path);
      if (!(width >= viz::thinnest_line && width <= viz::widest_line))
        source_.refuse(path, fmt::format("{:g} is not allowed; give {:g} to {:g} points", width, viz::thinnest_line,
                                         viz::widest_line));
      read_.theme.lines[i] = to_thousandths(width);
    }
  }

  void derive(const std::string& field) {
    const Json& two = source_.list(json()[field], {field}, 2, 2, "colours, as in [\"#00549f\", \"#f6a800\"],");
    const viz::Colour asked[] = {colour(two[0], {field, "0"}), colour(two[1], {field, "1"})};
    const viz::ThemeCheck grounds = viz::check_theme(read_.theme);
    for (const viz::ThemeFault& fault : grounds.faults)  // on bad grounds no colour can be read
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
    const viz::ThemeCheck made = viz::check_theme(read_.theme);
    for (const viz::ThemeFault& fault : made.faults) {
      const Path path = {fault.of == viz::ThemeFault::Of::line ? "lines" : "roles", fault.name};
      read_.faults.push_back(fmt::format("{}: {}; {}", source_.place(path), fault.why, fault.cure));
    }
  }

  scene::Source source_;
  const std::string name_;
  ReadTheme read_;
};

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

std::string theme_text(const viz::OwnTheme& theme) { return theme_json(theme).dump(); }
std::string theme_text_by_lines(const viz::OwnTheme& theme) { return theme_json(theme).dump(2) + "\n"; }

}  // namespace isect::program
