// One page with everything in it.

#include <fmt/format.h>

#include "app/checks/check_report.h"

namespace isect::program {

namespace {

std::string base64(const std::string& bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned word = 0;
    for (std::size_t j = i; j < i + 3; ++j)
      word = word << 8 | (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j) out += i + j <= bytes.size() ? digits[word >> (18 - 6 * j) & 63] : '=';
  }
  return out;
}

std::string picture(const std::string& title, const std::string& png) {
  const std::string content =
      png.empty() ? "<p class=\"none\">none</p>"
                  : fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", escaped(title), base64(png));
  return fmt::format("<figure><figcaption>{}</figcaption>{}</figure>\n", title, content);
}

std::string section(const Report& r, const Failure& f) {
  std::string html = fmt::format("<section>\n<h2>{}</h2>\n<p><b>{}</b>: {}</p>\n", escaped(where(f)), name_of(f.kind),
                                 escaped(f.what));
  if (!f.more.empty()) {
    html += "<details><summary>More differences</summary><ul>\n";
    for (const std::string& more : f.more) html += fmt::format("<li>{}</li>\n", escaped(more));
    html += "</ul></details>\n";
  }
  if (f.baseline.ends_with(".png"))
    html += "<div>\n" + picture("Accepted", f.accepted_png) + picture("New", f.fresh_png) +
            picture("Difference", f.difference_png) + "</div>\n";
  for (const std::string& line : details(f)) html += fmt::format("<p class=\"path\">{}</p>\n", escaped(line));
  if (const std::string command = accept_command(r, f); !command.empty())
    html += fmt::format("<p>To accept: <code>{}</code></p>\n", escaped(command));
  if (!f.accepted) return html + "</section>\n";
  return html + (f.kind == Failure::Kind::orphan ? "<p>Removed" : "<p>Accepted") + " in this run.</p>\n</section>\n";
}

constexpr std::string_view report_page = R"(<!DOCTYPE html>
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

bool begins_html_report(const std::string& bytes) {
  return bytes.starts_with(report_page.substr(0, report_page.find("<style>")));
}

std::string to_html(const Report& r) {
  std::string sections;
  for (const Failure& f : r.failures) sections += section(r, f);
  for (const std::string& file : r.left_alone)
    sections += fmt::format("<p>Left alone: {}.</p>\n", escaped(left_alone_text(file)));
  std::string head = escaped(summary(r));
  if (const std::string command = accept_command(r); !command.empty())
    head += fmt::format("</p>\n<p>To accept all of it: <code>{}</code>", escaped(command));
  return fmt::format(report_page, head, sections);
}

}  // namespace isect::program
