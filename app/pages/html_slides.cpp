#include <fmt/format.h>

#include "app/pages/html.h"
#include "app/pages/slides.h"
#include "viz/lang/message.h"

namespace isect::program {

namespace {

std::string section(const Slide& s) {
  const char* tag = s.first ? "h1" : "h2";
  std::string body = html(s.left);
  if (!s.right.empty())
    body = "<div class=\"columns\"><div>\n" + body + "</div><div>\n" + html(s.right) + "</div></div>\n";
  const std::string note =
      s.note.empty() ? "" : "<aside class=\"note\">\n" + html({Prose{s.note, viz::tr("Note")}}) + "</aside>\n";
  return fmt::format("<section>\n<{0}>{1}</{0}>\n", tag, html_text(s.title)) + body + html(s.below) + note +
         "</section>\n";
}

constexpr const char* slides_style =
    "<style>\nhtml { font: 3vmin/1.35 sans-serif; color: #111; background: #fff; }\n"
    "body { margin: 0; }\n"
    "section { box-sizing: border-box; min-height: 100vh; padding: 4vmin 6vmin; break-after: page; }\n"
    "h1 { font-size: 3em; margin: 25vh 0 0.5em; } h2 { font-size: 1.6em; margin: 0 0 0.6em; }\n"
    "p { margin: 0.5em 0; } figure { margin: 0; }\n"
    "img { display: block; margin: auto; width: 100%; max-height: 66vh; }\n"
    ".columns { display: grid; grid-template-columns: 3fr 2fr; gap: 4vmin; align-items: start; }\n"
    "ol.code { font: 0.8em/1.4 monospace; margin: 0; padding-left: 2.5em; } ol.code li { white-space: pre-wrap; "
    "padding-left: 2em; text-indent: -2em; }\n"
    "ol.code .current { background: #ffef9e; font-weight: bold; }\n"
    "ol.choices { list-style: lower-alpha; }\n"
    ".note { border-top: 1px solid #999; color: #444; margin-top: 1em; }\n"
    ".stepping:not(.noted) .note { display: none; }\n"
    ".stepping section { display: none; } .stepping section.shown { display: block; }\n"
    ".stepping .later:not(.shown) { visibility: hidden; }\n"
    "#place { position: fixed; right: 2vmin; bottom: 1vmin; font-size: 0.7em; color: #666; }\n"
    "@media print { .stepping section { display: block; } .stepping .later { visibility: visible !important; }\n"
    "  #place { display: none; } }\n</style>\n";

/// Returns the style that makes slides dark, also in print: their pictures are.
std::string dark_style(const SlideLook& look) {
  if (!look.is_dark()) return {};
  return fmt::format(
      "<style>\nhtml {{ color: #{0}; background: #{1}; print-color-adjust: exact; }}\n"
      "ol.code .current {{ background: #{2}; }}\n.note, #place {{ color: #{0}; }}\n</style>\n",
      look.text, look.ground, look.lit);
}

/// Without this script all slides stand one below the other, including answers.
constexpr const char* slides_script = R"script(<div id="place" aria-live="polite"></div>
<script>
const slides = [...document.querySelectorAll("section")], place = document.getElementById("place");
let now = 0;
function show(slide, whole) {
  now = Math.max(0, Math.min(slides.length - 1, slide));
  slides.forEach((s, i) => s.classList.toggle("shown", i === now));
  slides[now].querySelectorAll(".later").forEach(l => l.classList.toggle("shown", whole));
  place.textContent = `${now + 1} / ${slides.length}`;
  history.replaceState(null, "", "#" + (now + 1));
}
function next() {
  const later = slides[now].querySelector(".later:not(.shown)");
  if (later) later.classList.add("shown"); else if (now + 1 < slides.length) show(now + 1, false);
}
function back() { if (now > 0) show(now - 1, true); }
function from_address() { show(Number(location.hash.slice(1)) - 1 || 0, false); }
const keys = { ArrowRight: next, ArrowDown: next, PageDown: next, " ": next, Enter: next, ArrowLeft: back, ArrowUp: back,
               PageUp: back, Backspace: back, Home: () => show(0, false), End: () => show(slides.length - 1, true),
               n: () => document.body.classList.toggle("noted") };
addEventListener("keydown", e => {
  if (e.ctrlKey || e.altKey || e.metaKey || !keys[e.key]) return;
  e.preventDefault();
  keys[e.key]();
});
addEventListener("click", e => { if (!getSelection().toString()) (e.clientX < innerWidth / 4 ? back : next)(); });
addEventListener("hashchange", from_address);
document.body.classList.add("stepping");
from_address();
</script>
)script";

}  // namespace

std::string html_slides(const std::string& title, const std::vector<Slide>& slides, const SlideLook& look) {
  std::string sections;
  for (const Slide& slide : slides) sections += section(slide);
  return html_page(viz::plain(title), slides_style + dark_style(look), sections + slides_script);
}

}  // namespace isect::program
