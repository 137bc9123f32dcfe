"use strict";
// The way of a playlist through the pages. An address with "?hour=NAME&stop=3" names the playlist, whose places
// hour-NAME.js holds, and the stop, from 1; what stands behind its # names the place there. A bar at the top tells both.
(() => {
  const beginning = document.querySelector("[data-hour]"), asked = new URLSearchParams(location.search);
  const hour_name = beginning ? beginning.dataset.hour : asked.get("hour") ?? "";
  if (!/^[a-z0-9-]+$/.test(hour_name)) return;
  const kept_as = "isect hour " + hour_name, root = document.documentElement;
  /// The address of a place from any page.
  const address_of = ({ page, stop, hash }) => `${page}?hour=${hour_name}&stop=${stop + 1}${hash}`;
  /// Whether a key is meant for what has the focus: a field; what is dragged by arrows; a sheet over the page.
  const taken = event => document.querySelector("dialog[open]") || (event.target instanceof Element &&
    event.target.closest(event.key.startsWith("Arrow") ? "input, textarea, select, .over" : "input, textarea, select"));
  const with_others = event => event.ctrlKey || event.altKey || event.metaKey;

  /// The playlist's own page: begins, or goes on where this reader stopped.
  if (beginning) {
    let first = beginning.querySelector("a");
    try {
      const { told, address } = JSON.parse(localStorage.getItem(kept_as));
      if (/^\d+ of \d+$/.test(told) && new RegExp(`^[a-z0-9-]+\\.html\\?hour=${hour_name}&stop=\\d+#[a-z0-9/-]+(\\?time=[0-9.e+-]+)?$`).test(address)) {
        const go_on = document.createElement("a");
        go_on.href = address, go_on.textContent = "Go on at " + told, first.before(go_on, " "), first = go_on;
      }
    } catch { /* nothing is kept, or nothing that can be read */ }
    addEventListener("keydown", event => {
      if (!["n", "ArrowRight"].includes(event.key) || with_others(event) || taken(event)) return;
      event.preventDefault(), first.click();
    });
    return;
  }

  const script = document.createElement("script");
  script.src = `hour-${hour_name}.js`, script.onload = () => window.isect_hour && begin(window.isect_hour);
  document.head.append(script);

  function begin(hour) {
    const own = location.pathname.slice(location.pathname.lastIndexOf("/") + 1);
    const places = hour.stops.flatMap((stop, i) => stop.places.map(place => {
      const [page, hash] = place.split("#");
      return { stop: i, page, hash: "#" + hash };
    }));
    /// What is on show, as an address tells it; a page keeps it in the entry of the history while it is not told there.
    const here = () => location.hash || (history.state?.shown ?? "");
    const place_in = stop => places.findIndex(place => place.stop === stop && place.page === own && place.hash === here());
    const stop_asked = Math.min(Math.max(1, Math.trunc(Number(asked.get("stop"))) || 1), hour.stops.length) - 1;
    let at = place_in(stop_asked), away = false;  // away: the reader has gone elsewhere; the bar leads back
    if (at < 0) at = places.findIndex(place => place.page === own && place.hash === here());  // the address kept the stop before
    if (at < 0) at = places.findIndex(place => place.stop === stop_asked), away = here() !== "";

    const bar = document.createElement("nav"), note = document.createElement("div");
    const list = document.createElement("a"), title = document.createElement("span");
    const button = (words, name, action) => {
      const made = isect_button(words, action);
      made.setAttribute("aria-label", name);
      return made;
    };
    const back = button("←", "Back in the playlist", () => step(-1)), next = button("Next →", "Next → in the playlist", () => step(1));
    bar.className = "hour", bar.setAttribute("aria-label", "Playlist");
    list.href = `hour-${hour_name}.html`, list.title = hour.title, list.className = "stop-number";
    title.className = "stop-name", note.className = "note", note.setAttribute("role", "status");
    bar.append(back, list, title, next, note);
    document.getElementById("main").before(bar), root.classList.add("in-hour");

    function show() {
      const stop = places[at].stop, told = `${stop + 1} of ${hour.stops.length}`;
      const high = bar.offsetHeight;
      list.textContent = told, title.innerHTML = hour.stops[stop].name;
      if (note.innerHTML !== hour.stops[stop].note) note.innerHTML = hour.stops[stop].note;
      bar.classList.toggle("away", away);
      back.disabled = at === 0 && !away, next.disabled = at === places.length - 1 && !away;
      back.title = next.title = away ? "Back to " + told : "";
      if (bar.offsetHeight !== high) dispatchEvent(new Event("resize"));  // the picture below has more room, or less
      try { localStorage.setItem(kept_as, JSON.stringify({ told, address: address_of(places[at]) })); } catch { /* nowhere to keep it */ }
    }
    /// On or back by a place; from elsewhere to the one that was left.
    function step(by) { go(away ? at : at + by); }
    function go(to) {
      const place = places[to];
      if (!place) return;
      if (place.page !== own) return void location.assign(address_of(place));
      at = to, away = false;
      try {
        history.replaceState(history.state, "", `?hour=${hour_name}&stop=${place.stop + 1}${location.hash}`);
      } catch { /* the address keeps the stop before */ }
      if (here() !== place.hash) location.replace(place.hash);
      show();
    }
    /// The reader may have gone anywhere, by the page's own controls.
    function follow() {
      const found = place_in(places[at].stop);
      away = found < 0;
      if (!away) at = found;
      show();
    }
    document.addEventListener("isect:step", () => setTimeout(follow));  // the address is told next
    const ways = { PageDown: 1, ArrowRight: 1, n: 1, N: 1, PageUp: -1, ArrowLeft: -1, p: -1, P: -1 };
    addEventListener("keydown", event => {
      const way = ways[event.key];
      if (!way || with_others(event) || taken(event) || root.classList.contains("reading")) return;
      event.preventDefault(), event.stopImmediatePropagation(), step(way);
    }, true);
    if (away) return show();
    go(at);
    if (places[at].page === own) dispatchEvent(new Event("hashchange"));  // the bar has moved what was in sight
  }
})();
