"use strict";
// A lesson's page in a SCORM 1.2 package tells the learning platform around it how far its reader is. Only a page whose body
// has data-scorm does so, and only where a window around it, or the one that opened it, has the platform's API.

/// The API; null: there is none. A window of another origin is passed over.
function isect_scorm_api(from) {
  const api_of = at => { try { return at.API ?? null; } catch { return null; } };
  function within(start) {
    for (let at = start, windows = 0; at && windows < 50; ++windows) {
      const api = api_of(at);
      if (api || !at.parent || at.parent === at) return api;
      at = at.parent;
    }
    return null;
  }
  const opener_of = at => { try { return at?.opener ?? null; } catch { return null; } };
  return within(from) ?? within(opener_of(from)) ?? within(opener_of(from.top));
}

/// A time in milliseconds as SCORM writes it: "00:12:05.25", at most four digits of hours.
function isect_scorm_time(milliseconds) {
  const hundredths = Math.min(Math.max(0, Math.floor(milliseconds / 10)), 9999 * 360000 + 359999);
  const two = number => String(number).padStart(2, "0"), seconds = Math.floor(hundredths / 100);
  return `${two(Math.floor(seconds / 3600))}:${two(Math.floor(seconds / 60) % 60)}:${two(seconds % 60)}.${two(hundredths % 100)}`;
}

/// The talk with the API, from LMSInitialize to LMSFinish; before and after it nothing is called. What the API refuses, and
/// what it throws, stays untold: the page goes on.
function isect_scorm_session(api, now = Date.now) {
  const told = new Map(), beginning = now();
  let open = false, status = "";
  function call(name, ...values) {
    try { return String(api[name](...values)); } catch { return ""; }
  }
  const get = name => { const value = call("LMSGetValue", name); return value === "undefined" || value === "null" ? "" : value; };
  /// Sets an element, unless it has that value.
  function set(name, value) {
    if (told.get(name) !== value && call("LMSSetValue", name, value) === "true") told.set(name, value);
  }
  const commit = () => void (open && (set("cmi.core.session_time", isect_scorm_time(now() - beginning)), call("LMSCommit", "")));
  return {
    /// What the platform has kept; null: it does not begin.
    begin() {
      if (call("LMSInitialize", "") !== "true") return null;
      open = true, status = get("cmi.core.lesson_status");
      if (["", "not attempted"].includes(status)) set("cmi.core.lesson_status", status = "incomplete");
      return { student: get("cmi.core.student_id"), entry: get("cmi.core.entry"), place: get("cmi.core.lesson_location"),
        kept: get("cmi.suspend_data") };
    },
    /// `of`: how many questions there are; `kept`: a text of at most 4096 characters, or it is not kept.
    tell({ right, of, finished, place, kept }) {
      if (!open) return;
      if (of > 0) {
        set("cmi.core.score.min", "0"), set("cmi.core.score.max", "100");
        set("cmi.core.score.raw", String(Math.round(10000 * right / of) / 100));
      }
      if (finished && !["completed", "passed"].includes(status)) set("cmi.core.lesson_status", status = "completed");
      if (place.length <= 255) set("cmi.core.lesson_location", place);
      if (kept.length <= 4096) set("cmi.suspend_data", kept);
    },
    commit,
    /// The reader may come back to what is kept.
    end() {
      if (!open) return;
      set("cmi.core.exit", "suspend"), commit(), call("LMSFinish", "");
      open = false;
    }
  };
}

// What happens on the page is told. Its score is the share of the lesson's questions that were answered right the last time.
(() => {
  const { lesson, scorm } = document.body.dataset, api = scorm === undefined ? null : isect_scorm_api(window);
  if (!lesson || !api) return;
  const names = scorm.split(" ").filter(Boolean), session = isect_scorm_session(api), before = session.begin();
  if (!before) return;

  // One browser may serve several readers, each with answers of their own. A new attempt begins with none.
  for (const kept of [isect_answers, isect_way]) kept.place += `, ${before.student}`;
  const of_lesson = record => Object.fromEntries(names.filter(name => Object.hasOwn(record.lessons[lesson] ?? {}, name))
    .map(name => [name, record.lessons[lesson][name]]));
  const record_of = record => ({ version: 1, answers: record.answers, lessons: { [lesson]: of_lesson(record) }, reviews: {} });
  let kept = null;
  try { kept = record_of(isect_record_from(before.kept)); } catch { /* there is none */ }
  if (kept) isect_answers.change(record => isect_merge_record(record, kept));
  else if (before.entry !== "resume") {
    isect_answers.change(record => void delete record.lessons[lesson]);
    isect_way.change(way => void (delete way.lessons[lesson], way.last = null));
  }
  // Where the reader was, unless the address names a place.
  if (location.hash === "" && /^[a-z0-9-]+(\/\d+(\/question)?)?$/.test(before.place))
    try { history.replaceState(null, "", "#" + before.place); } catch { /* the page begins at its first step */ }

  function tell() {
    const way = isect_way.read(), record = isect_answers.read(), own = of_lesson(record);
    session.tell({
      right: names.filter(name => own[name]?.right).length, of: names.length, finished: way.lessons[lesson]?.finished ?? false,
      place: way.last?.lesson === lesson ? way.last.place : "", kept: JSON.stringify(record_of(record))
    });
  }
  // progress.js has heard these before.
  document.addEventListener("isect:step", ({ detail }) => (tell(), detail.end && session.commit()));
  document.addEventListener("isect:answer", () => (tell(), session.commit()));
  document.addEventListener("visibilitychange", () => document.visibilityState === "hidden" && session.commit());
  addEventListener("pagehide", () => session.end());
})();
