// Every page at sizes from a phone to a large screen: the picture is whole where a page opens and after each step, and
// its letters are nowhere smaller than on a phone. node sizes.mjs FOLDER; prints what is wrong; exit status 1 if
// anything is.
import { readFileSync, readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";

const folder = resolve(process.argv[2]), phone = "390x844";
const sizes = [phone, "844x390", "1024x768", "1093x614", "1366x768", "2560x1440"];
const pages = readdirSync(folder).filter(name => name.endsWith(".html")).sort()
  .filter(name => readFileSync(join(folder, name), "utf8").includes('<section class="walk'));
// On a phone with every fifth setting, and with the first one at another size, which changes from page to page.
// ISECT_LONG=1: at every size, with every setting on a phone and on a low screen.
const every = process.env.ISECT_LONG === "1", thorough = every ? [phone, "1093x614"] : [phone];
const text = 9, least = 7;  // units of a picture's letters; px of a picture taller than wide, on a low screen

/// Steps through a setting and tells of each station where its picture lies on the screen.
const stations = `(() => {
  const all = [], next = document.querySelector(".transport .next");
  for (let i = 0; i < 100; ++i) {
    const article = document.querySelector(".live article") ?? document.querySelector(".walk.shown > .steps > .shown");
    const picture = article.querySelector(".picture"), bar = document.querySelector(".transport").getBoundingClientRect();
    if (picture) {
      const box = picture.getBoundingClientRect(), view = picture.viewBox.baseVal;
      all.push({ at: location.hash, top: box.top, left: box.left, right: box.right, bottom: box.bottom, bar: bar.top,
        scale: Math.min(box.width / view.width, box.height / view.height), tall: view.height > view.width });
    }
    if (next.disabled) break;
    next.click();
  }
  return all;
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
      await browser.ask(`new Promise(done => {
        const look = () => document.documentElement.dataset.live ? done() : setTimeout(look, 10);
        document.body.dataset.live ? look() : done();
      })`);
      check(await browser.ask("scrollY") === 0, `${page}, ${size}: it opens scrolled`);
      const settings = await browser.ask(`[...document.querySelectorAll("nav.settings a")].map(a => a.hash)`);
      const some = settings.filter((_, i) => i === 0 || (thorough.includes(size) && (every || i % 5 === 0)));
      for (const setting of some) {
        if (setting !== settings[0]) {
          await browser.ask(`document.querySelector('nav.settings a[href="${setting}"]').click()`);
          await browser.ask(`new Promise(done => setTimeout(done, 20))`);
        }
        for (const now of await browser.ask(stations)) {
          const what = `${page}${now.at}, ${size}`, least_scale = on_phone.get(now.at) ?? 0;
          if (size === phone) on_phone.set(now.at, now.scale);
          check(now.top >= 0 && now.bottom <= now.bar + 0.5 && now.left >= 0 && now.right <= width,
            `${what}: the picture lies from ${now.top.toFixed(0)} to ${now.bottom.toFixed(0)}, the bar begins at ${now.bar.toFixed(0)}`);
          const low = now.tall && height < 640;
          check(low ? now.scale * text >= least : now.scale >= least_scale - 0.002,
            `${what}: letters of ${(text * now.scale).toFixed(1)} px, on a phone ${(text * least_scale).toFixed(1)}`);
          const kind = low ? size + ", taller than wide" : size;
          smallest[kind] = Math.min(smallest[kind] ?? Infinity, text * now.scale);
        }
      }
    }
  }
} finally {
  await browser.stop();
}
for (const [size, px] of Object.entries(smallest)) console.log(`${size}: letters of ${px.toFixed(1)} px or more`);
console.log(`${checks} checks of ${pages.length} pages in ${((Date.now() - beginning) / 1000).toFixed(0)} s, ${wrong} wrong`);
process.exit(wrong === 0 && pages.length > 0 ? 0 : 1);
