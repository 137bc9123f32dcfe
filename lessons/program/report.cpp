#include "lessons/program/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lessons/program/terminal.h"
#include "viz/place.h"

namespace isect::program {

namespace {

using Json = nlohmann::ordered_json;
using Kind = Failure::Kind;

bool open(const Failure& f) { return !f.accepted; }
std::size_t open_failures(const Report& r) {
  return static_cast<std::size_t>(std::ranges::count_if(r.failures, open));
}

/// "ray-sphere tangent, step 3 (foot)"
std::string where(const Failure& f) {
  std::string text = f.lesson + " " + f.preset;
  if (f.step >= 0) text += fmt::format(", step {}{}", f.step + 1, f.slug.empty() ? "" : " (" + f.slug + ")");
  return text;
}

std::string counted(std::size_t n, const std::string& what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

std::string summary(const Report& r) {
  const std::string looked = counted(r.pictures, "picture") + " of " + counted(r.presets, "preset");
  const std::size_t accepted = r.failures.size() - open_failures(r);
  std::string text =
      open_failures(r) == 0 ? "ok: " + looked : counted(open_failures(r), "failure") + " in " + looked;
  if (accepted > 0) text += fmt::format("; {} accepted", accepted);
  return text;
}

std::string text_of(const Report& r, const Failure& f) {
  if (f.accepted) return fmt::format("{} {}: {}\n", inked(Ink::good, "accepted"), where(f), f.baseline);
  if (f.kind == Kind::missing)
    return fmt::format("{} {}: {}\n", inked(Ink::bad, "MISSING"), where(f), f.baseline);
  std::string text =
      fmt::format("{} {}: {}: {}\n", inked(Ink::bad, "FAILED"), where(f), name_of(f.kind), f.what);
  constexpr std::size_t enough = 4;
  for (std::size_t i = 0; i < std::min(enough, f.more.size()); ++i)
    text += fmt::format("    {}\n", f.more[i]);
  if (f.more.size() > enough) text += fmt::format("    and {} more\n", f.more.size() - enough);
  text += fmt::format("    baseline    {}\n", f.baseline);
  if (!f.fresh.empty()) text += fmt::format("    new         {}\n", f.fresh);
  if (!f.difference.empty()) text += fmt::format("    difference  {}\n", f.difference);
  if (const std::string command = accept_command(r, f); !command.empty())
    text += fmt::format("    accept      {}\n", command);
  return text;
}

}  // namespace

int status(const Report& r) {
  const auto missing = [](const Failure& f) { return f.kind == Kind::missing; };
  std::vector<Failure> left;
  std::ranges::copy_if(r.failures, std::back_inserter(left), open);
  if (left.empty()) return done;
  return std::ranges::all_of(left, missing) ? baseline_missing : check_failed;
}

std::string accept_command(const Report& r, const Failure& f) {
  if (f.kind == Kind::blank) return {};
  const bool known = std::ranges::find(r.lessons, f.lesson) != r.lessons.end();
  const std::string lesson = known && r.program == "isect" ? " " + f.lesson : "";
  const std::string option = r.presets_too ? " --dir " : " --snapshots ";
  const std::string folder = r.folder == "snapshots" && !r.presets_too ? "" : option + r.folder;
  return fmt::format("{} check{}{} --update={}", r.program, lesson, folder,
                     f.kind == Kind::missing ? "missing" : "failed");
}

std::string to_text(const Report& r) {
  std::string text;
  for (const Failure& f : r.failures) text += text_of(r, f);
  const auto is_missing = [](const Failure& f) { return f.kind == Kind::missing && !f.accepted; };
  if (const auto f = std::ranges::find_if(r.failures, is_missing); f != r.failures.end())
    text += fmt::format("accept what is missing: {}\n", accept_command(r, *f));
  return text + summary(r) + "\n";
}

std::string to_json(const Report& r) {
  Json failures = Json::array();
  for (const Failure& f : r.failures) {
    Json object = {{"kind", name_of(f.kind)}, {"lesson", f.lesson}, {"preset", f.preset}};
    if (f.step >= 0) object.update({{"step", f.step + 1}, {"slug", f.slug}});
    object.update({{"what", f.what}, {"baseline", f.baseline}});
    if (!f.more.empty()) object["more"] = f.more;
    if (f.kind == Kind::picture)
      object.update({{"pixels_over_8", f.pixels.over_8}, {"pixels_over_1", f.pixels.over_1}});
    if (!f.fresh.empty()) object["new"] = f.fresh;
    if (!f.difference.empty()) object["difference"] = f.difference;
    object["accepted"] = f.accepted;
    if (const std::string command = accept_command(r, f); !f.accepted && !command.empty())
      object["accept"] = command;
    failures.push_back(object);
  }
  const Json result = {{"passed", open_failures(r) == 0},
                       {"version", viz::version()},
                       {"lessons", r.lessons},
                       {"presets", r.presets},
                       {"pictures", r.pictures},
                       {"failures", failures}};
  return result.dump(2) + "\n";
}

namespace {

std::string base64(const std::string& bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned word = 0;
    for (std::size_t j = i; j < i + 3; ++j)
      word = word << 8 | (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j)
      out += i + j <= bytes.size() ? digits[word >> (18 - 6 * j) & 63] : '=';
  }
  return out;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '&'   ? "&amp;"
           : c == '<' ? "&lt;"
           : c == '>' ? "&gt;"
           : c == '"' ? "&quot;"
                      : std::string(1, c);
  return out;
}

std::string picture(const std::string& title, const std::string& path) {
  std::string content = "<p class=\"none\">none</p>";
  try {
    if (!path.empty())
      content = fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", escaped(title),
                            base64(viz::read_file(path)));
  } catch (const viz::FileError&) {
    // A missing baseline is part of what is reported.
  }
  return fmt::format("<figure><figcaption>{}</figcaption>{}</figure>\n", title, content);
}

std::string section(const Report& r, const Failure& f) {
  std::string html = fmt::format("<section>\n<h2>{}</h2>\n<p><b>{}</b>: {}</p>\n", escaped(where(f)),
                                 name_of(f.kind), escaped(f.what));
  if (!f.more.empty()) {
    html += "<details><summary>More differences</summary><ul>\n";
    for (const std::string& more : f.more) html += fmt::format("<li>{}</li>\n", escaped(more));
    html += "</ul></details>\n";
  }
  if (f.baseline.ends_with(".png"))
    html += "<div>\n" + picture("Accepted", f.baseline) + picture("New", f.fresh) +
            picture("Difference", f.difference) + "</div>\n";
  const std::string command = f.accepted ? "" : accept_command(r, f);
  html += fmt::format("<p class=\"path\">{}</p>\n", escaped(f.baseline));
  if (!command.empty()) html += fmt::format("<p>To accept: <code>{}</code></p>\n", escaped(command));
  return html + (f.accepted ? "<p>Accepted in this run.</p>\n" : "") + "</section>\n";
}

constexpr std::string_view page = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>isect check</title>
<style>
:root {{ color-scheme: light dark; }}
body {{ font: 15px/1.5 "DejaVu Sans", sans-serif; margin: 2em auto; max-width: 90em; padding: 0 1em; }}
section {{ border-top: 1px solid #8888; padding: .5em 0 1em; }}
h2 {{ font-size: 1.1em; }}
div {{ display: grid; grid-template-columns: repeat(3, 1fr); gap: 8px; }}
figure {{ margin: 0; }}
img {{ width: 100%; }}
.none, .path, figcaption {{ color: #707880; }}
code {{ background: #8882; padding: .1em .4em; border-radius: 4px; }}
</style>
</head>
<body>
<h1>isect check</h1>
<p>{}</p>
{}</body>
</html>
)";

}  // namespace

std::string to_html(const Report& r) {
  std::string sections;
  for (const Failure& f : r.failures) sections += section(r, f);
  return fmt::format(page, escaped(summary(r)), sections);
}

}  // namespace isect::program
