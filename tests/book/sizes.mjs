// Every page at sizes from a phone to a large screen: the picture is whole where a page opens and after each step, its
// letters are nowhere smaller than on a phone, and it is on no window smaller than on one that is less wide and less high.
// Beside it stand the values, the line that runs and the first choice, all above the bar; what is pressed stays where it is.
// On a phone all that is asked comes first, where a question and the picture have no room together.
// node sizes.mjs FOLDER; prints what is wrong; exit status 1 if anything is.
import { readFileSync, readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";
import { loaded } from "./live_page.mjs";

const folder = resolve(process.argv[2]), phone = "390x844";
const sizes = [phone, "844x390", "1024x768", "1093x614", "1366x768", "1920x1080", "2560x1440"];
const pages = readdirSync(folder).filter(name => name.endsWith(".html")).sort()
  .filter(name => readFileSync(join(folder, name), "utf8").includes('<section class="walk'));
// On a phone with every fifth setting, and with the first one at another size, which changes from page to page.
// ISECT_LONG=1: at every size, with every setting on a phone and on a low screen.
const every = process.env.ISECT_LONG === "1", thorough = every ? [phone, "1093x614"] : [phone];
const text = 9, least = 7;  // units of a picture's letters; px of a picture taller than wide, on a low screen

/// Steps through a setting and tells of each station where its parts lie on the screen. `hidden`: what of its values, its
/// verdict, its line and its choices (beside the picture: the first choice) is not above the bar, or scrolled away in its
/// own box; on a low screen the first new values count. `desk`: they stand beside the picture.
const stations = `(() => {
  const all = [], next = document.querySelector(".transport .next");
  document.querySelector(".transport .first").click();  // a scene opens at its first answer
  const seen = element => element && element.getBoundingClientRect().height > 0;
  const place = element => seen(element) ? [element.getBoundingClientRect().left, element.getBoundingClientRect().top].map(Math.round).join() : "";
  for (let i = 0; i < 100; ++i) {
    const article = document.querySelector(".live article") ?? document.querySelector(".walk.shown > .steps > .shown"), steps = article.parentElement;
    const picture = article.querySelector(".picture"), bar = document.querySelector(".transport").getBoundingClientRect();
    const desk = getComputedStyle(steps).display === "grid", asks = article.classList.contains("ask"), hidden = [];
    const inside = (element, box, high = Infinity) => {
      const here = element.getBoundingClientRect(), room = desk && box ? box.getBoundingClientRect() : { top: 0, bottom: bar.top };
      if (here.top < Math.max(0, room.top) - 1 || Math.min(here.bottom, here.top + high) > Math.min(room.bottom, bar.top) + 1)
        hidden.push(element.textContent.trim().slice(0, 30) + " from " + Math.round(here.top) + " to " + Math.round(here.bottom));
    };
    const words = article.querySelector(".words"), numbers = article.querySelector(".numbers"), line = steps.querySelector("ol.code .current");
    const choices = [...words.querySelectorAll(".choices li, .typed input")].filter(seen);
    (desk ? choices.slice(0, 1) : choices).forEach(choice => inside(choice, words));
    const low = innerHeight < 640, rows = [...article.querySelectorAll(low ? ".values tr.fresh" : ".values tr")].filter(seen);
    if (desk) rows.slice(0, low ? 4 : rows.length).forEach(row => inside(row, numbers));
    if (desk) [...words.querySelectorAll(":scope > .verdict")].forEach(verdict => inside(verdict, words));
    if (desk && seen(line)) inside(line, line.closest(".steps > *"), 36);
    const pressed = [...document.querySelectorAll(".transport button, .live .tools button, .live .workshop > details > summary")]
      .filter(element => desk ? !element.closest(".own-scene") : element.closest(".transport")).map(place).join(" ") + (desk ? " " + scrollY : "");
    if (picture) {
      const box = picture.getBoundingClientRect(), view = picture.viewBox.baseVal;
      all.push({ at: location.hash, top: box.top, left: box.left, right: box.right, bottom: box.bottom, bar: bar.top, high: bar.height,
        scale: Math.min(box.width / view.width, box.height / view.height), tall: view.height > view.width, desk, hidden, pressed,
        lower: asks ? Math.max(...[...words.querySelectorAll(".choices li, .typed")].filter(seen).map(e => e.getBoundingClientRect().bottom)) : 0 });
    }
    if (next.disabled) break;
    next.click();
  }
  return all;
})()`;
const scale = `(() => {
  dispatchEvent(new Event("resize"));  // the browser's own comes with the next frame
  const picture = (document.querySelector(".live article") ?? document.querySelector(".walk.shown > .steps > .shown")).querySelector(".picture");
  const box = picture.getBoundingClientRect(), view = picture.viewBox.baseVal;
  return Math.min(box.width / view.width, box.height / view.height);
})()`;

let checks = 0, wrong = 0;
function check(holds, what) {
  ++checks;
  if (!holds) ++wrong, console.log("wrong: " + what);
}
const browser = await Browser.start(), beginning = Date.now(), smallest = {};
try {
  for (const [at, page] of pages.entries()) {
    const on_phone = new Map();
    for (const size of every ? sizes : [phone, sizes[1 + at % (sizes.length - 1)]]) {
      const [width, height] = size.split("x").map(Number);
      await browser.look({ width, height });
      await browser.open("about:blank");
      await browser.open(pathToFileURL(join(folder, page)).href);
      await browser.ask(loaded);
      check(await browser.ask("scrollY") === 0, `${page}, ${size}: it opens scrolled`);
      const settings = await browser.ask(`[...document.querySelectorAll("nav.settings a")].map(a => a.hash)`);
      const some = settings.filter((_, i) => i === 0 || (thorough.includes(size) && (every || i % 5 === 0)));
      for (const setting of some) {
        if (setting !== settings[0]) {
          await browser.ask(`document.querySelector('nav.settings a[href="${setting}"]').click()`);
          await browser.ask(`new Promise(done => setTimeout(done, 20))`);
        }
        let pressed = "";
        for (const now of await browser.ask(stations)) {
          const what = `${page}${now.at}, ${size}`, least_scale = on_phone.get(now.at) ?? 0;
          if (size === phone) on_phone.set(now.at, now.scale);
          // On a phone, where a question and the picture don't fit together, all that is asked comes first.
          const asked_first = !now.desk && now.lower - now.top > now.bar - 8;
          check(asked_first || (now.top >= 0 && now.bottom <= now.bar + 0.5),
            `${what}: the picture lies from ${now.top.toFixed(0)} to ${now.bottom.toFixed(0)}, the bar begins at ${now.bar.toFixed(0)}`);
          check(now.left >= 0 && now.right <= width, `${what}: the picture lies from ${now.left.toFixed(0)} to ${now.right.toFixed(0)} across`);
          check(now.hidden.length === 0, `${what}: out of sight: ${now.hidden.join("; ")}`);
          check(now.high <= 64, `${what}: the bar is ${now.high.toFixed(0)} px high`);
          check(pressed === "" || now.pressed === pressed, `${what}: what is pressed has moved from ${pressed} to ${now.pressed}`);
          pressed = now.pressed;
          const low = now.tall && height < 640;
          check(low ? now.scale * text >= least : now.scale >= least_scale - 0.002,
            `${what}: letters of ${(text * now.scale).toFixed(1)} px, on a phone ${(text * least_scale).toFixed(1)}`);
          const kind = low ? size + ", taller than wide" : size;
          smallest[kind] = Math.min(smallest[kind] ?? Infinity, text * now.scale);
        }
      }
    }
    // The same picture in all windows, of every second page: the other half are the live book's, or this one's.
    const grown = [], lives = await browser.ask(`"live" in document.body.dataset`);
    for (const size of every || at % 2 === Number(lives) ? sizes : []) {
      const [width, height] = size.split("x").map(Number);
      await browser.look({ width, height });
      const now = { size, width, height, scale: await browser.ask(scale) };
      for (const less of grown)
        if (less.width <= width && less.height <= height)
          check(now.scale >= less.scale - 0.005, `${page}: its picture is ${now.scale.toFixed(3)} at ${size}, ${less.scale.toFixed(3)} at ${less.size}`);
      grown.push(now);
    }
  }
} finally {
  await browser.stop();
}
for (const [size, px] of Object.entries(smallest)) console.log(`${size}: letters of ${px.toFixed(1)} px or more`);
console.log(`${checks} checks of ${pages.length} pages in ${((Date.now() - beginning) / 1000).toFixed(0)} s, ${wrong} wrong`);
process.exit(wrong === 0 && pages.length > 0 ? 0 : 1);
