// A playlist's way through the pages in a browser: its page, and every place in order by key and by button, on and back, from
// elsewhere, after a reload. node hour.mjs FOLDER; prints what is wrong; exit status 1 if anything is.
import { readFileSync, readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";
import { rest } from "./live_page.mjs";

const folder = resolve(process.argv[2]);
const file = readdirSync(folder).find(name => /^hour-.*\.js$/.test(name)), name = file.slice(5, -3);
const told = readFileSync(join(folder, file), "utf8").split("\n").find(line => line.startsWith("var isect_hour = "));
const hour = JSON.parse(told.slice("var isect_hour = ".length, -1));
const places = hour.stops.flatMap((stop, i) => stop.places.map(place => ({ place, told: `${i + 1} of ${hour.stops.length}` })));
let checks = 0, wrong = 0;
function check(holds, what) {
  ++checks;
  if (!holds) ++wrong, console.log("wrong: " + what);
}
const shown = `(() => {
  const bar = document.querySelector("nav.hour"), high = e => e ? e.getBoundingClientRect().height : 0;
  const article = document.querySelector(".live article") ?? document.querySelector(".walk.shown > .steps > .shown");
  return { page: location.pathname.split("/").pop(), hash: location.hash, told: bar?.querySelector(".stop-number").textContent ?? "",
    away: bar?.classList.contains("away") ?? false, end: bar?.querySelectorAll("button")[1]?.disabled ?? false,
    asks: article?.classList.contains("ask") ?? false, header: high(document.querySelector("body > header")),
    wide: document.documentElement.scrollWidth - document.documentElement.clientWidth,
    whole: !article || article.querySelector(".picture") === null || location.hash === "#remember"
      || article.querySelector(".picture").getBoundingClientRect().bottom <= document.querySelector(".transport").getBoundingClientRect().top + 1 };
})()`;
const browser = await Browser.start();
/// What is shown once the address is the place's, or after ten seconds.
async function at(place) {
  let now = {};
  for (let i = 0; i < 500; ++i) {
    try { now = await browser.ask(shown); } catch { /* between two pages */ }
    if (now.page + now.hash === place.place && now.told === place.told) break;
    await rest(20);
  }
  await rest(60);  // the page follows its address
  return browser.ask(shown);
}
async function check_at(i, how) {
  const now = await at(places[i]), where = `place ${i + 1}, ${how}`;
  check(now.page + now.hash === places[i].place, `${where}: ${now.page}${now.hash} is shown, and not ${places[i].place}`);
  check(now.told === places[i].told && !now.away, `${where}: the bar tells ${now.told}${now.away ? ", away" : ""}, and not ${places[i].told}`);
  check(now.asks === places[i].place.endsWith("/question"), `${where}: a question is ${now.asks ? "" : "not "}asked`);
  check(now.end === (i === places.length - 1), `${where}: the end is ${now.end}`);
  check(now.header === 0 && now.wide <= 0, `${where}: the header is ${now.header} high, the page ${now.wide} too wide`);
  check(now.whole, `${where}: the picture is not whole`);
}
try {
  await browser.look({ width: 1366, height: 768 });
  await browser.open(pathToFileURL(join(folder, `hour-${name}.html`)).href);
  check(await browser.ask(`document.querySelectorAll("ol.stops li").length`) === hour.stops.length, "its page lacks stops");
  await browser.press("n");
  await check_at(0, "begun");
  for (let i = 1; i < places.length; ++i) {
    await browser.press(["PageDown", "n", "ArrowRight"][i % 3]);
    await check_at(i, "on by key");
  }
  await browser.press("PageDown");
  await check_at(places.length - 1, "on at the end");
  for (let i = places.length - 2; i >= 0; --i) {
    if (i % 2) await browser.press(["PageUp", "ArrowLeft"][i % 4 >> 1]);
    else await browser.ask(`document.querySelector("nav.hour button").click()`);
    await check_at(i, "back");
  }
  // Elsewhere on the page: the bar leads back to where one was. A reload shows the same; so does the playlist's page.
  await browser.ask(`document.querySelector(".transport .last").click()`);
  await rest(100);
  check((await browser.ask(shown)).away, "gone to the last step, the bar does not tell that this is elsewhere");
  await browser.press("PageDown");
  await check_at(0, "back from elsewhere");
  const later = Math.min(3, places.length - 1);
  for (let i = 1; i <= later; ++i) await browser.press("PageDown"), await check_at(i, "on again");
  const loaded = browser.event("Page.loadEventFired");
  await browser.send("Page.reload");
  await loaded;
  await check_at(later, "reloaded");
  await browser.open(pathToFileURL(join(folder, `hour-${name}.html`)).href);
  check(await browser.ask(`document.querySelector(".hour-begin a").textContent`) === "Go on at " + places[later].told, "its page does not offer to go on");
  await browser.press("n");
  await check_at(later, "gone on");

  // On a phone, upright and on its side.
  for (const [width, height] of [[390, 844], [844, 390]]) {
    await browser.look({ width, height });
    await browser.open(pathToFileURL(join(folder, `hour-${name}.html`)).href);
    check(await browser.ask(`document.documentElement.scrollWidth`) <= width, `its page is wider than ${width}`);
    await browser.ask(`[...document.querySelectorAll(".hour-begin a")].pop().click()`);
    for (let i = 0; i < Math.min(4, places.length); ++i) {
      await check_at(i, `${width} wide`);
      await browser.ask(`document.querySelectorAll("nav.hour button")[1].click()`);
    }
  }
  // Without scripts its links lead to the steps.
  await browser.look({ scripts: false });
  await browser.open(pathToFileURL(join(folder, `hour-${name}.html`)).href);
  check(await browser.ask(`document.querySelectorAll('ol.stops a[href*="#"]').length`) === hour.stops.length, "without scripts it lacks links");
  for (const message of browser.messages) check(false, "the console says: " + message);
} finally {
  await browser.stop();
}
console.log(`${checks} checks of a playlist of ${places.length} places, ${wrong} wrong`);
process.exit(wrong ? 1 : 0);
