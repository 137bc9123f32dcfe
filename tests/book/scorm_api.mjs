// A learning platform's SCORM 1.2 API, as strict as the standard allows: it counts as wrong what is called too early, too
// late or twice, what has no such name, and each value that is out of its range. As text it runs in a page, too.

/// `data`: what was set so far, by element; `student` and `entry` as a platform tells them.
export function scorm_api(data = {}, { student = "s-1", entry = "ab-initio" } = {}) {
  const wrong = [], calls = [];
  let state = "before", error = "0", committed = { ...data };
  const readable = { "cmi.core.student_id": student, "cmi.core.entry": entry, "cmi.core.lesson_status": data["cmi.core.lesson_status"] ?? "not attempted",
    "cmi.core.lesson_location": data["cmi.core.lesson_location"] ?? "", "cmi.suspend_data": data["cmi.suspend_data"] ?? "" };
  const share = value => /^-?\d+(\.\d+)?$/.test(value) && Number(value) >= 0 && Number(value) <= 100;
  const fits = {
    "cmi.core.lesson_status": value => ["passed", "completed", "failed", "incomplete", "browsed"].includes(value),
    "cmi.core.lesson_location": value => value.length <= 255,
    "cmi.core.score.raw": share, "cmi.core.score.min": share, "cmi.core.score.max": share,
    "cmi.core.session_time": value => /^\d{2,4}:[0-5]\d:[0-5]\d(\.\d{1,2})?$/.test(value),
    "cmi.core.exit": value => ["", "time-out", "suspend", "logout"].includes(value),
    "cmi.suspend_data": value => value.length <= 4096
  };
  const fail = (code, what) => (error = code, wrong.push(what), "false");
  const running = what => state === "open" || fail("301", `${what} ${state === "before" ? "before LMSInitialize" : "after LMSFinish"}`) !== "false";
  const api = {
    LMSInitialize(empty) {
      calls.push("LMSInitialize");
      if (empty !== "") return fail("201", `LMSInitialize(${empty})`);
      if (state !== "before") return fail("101", "LMSInitialize twice");
      return state = "open", error = "0", "true";
    },
    LMSGetValue(name) {
      calls.push(`LMSGetValue ${name}`);
      if (!running(`LMSGetValue ${name}`)) return "";
      if (name in readable) return error = "0", name in data ? data[name] : readable[name];
      return fail("401", `LMSGetValue ${name}: there is no such element, or it is only written`), "";
    },
    LMSSetValue(name, value) {
      calls.push(`LMSSetValue ${name}`);
      if (!running(`LMSSetValue ${name}`)) return "false";
      if (!(name in fits)) return fail("401", `LMSSetValue ${name}: there is no such element, or it is only read`);
      if (typeof value !== "string" || !fits[name](value)) return fail("405", `LMSSetValue ${name}: ${JSON.stringify(value)}`);
      return data[name] = value, error = "0", "true";
    },
    LMSCommit(empty) {
      calls.push("LMSCommit");
      if (!running("LMSCommit")) return "false";
      if (empty !== "") return fail("201", `LMSCommit(${empty})`);
      return committed = { ...data }, error = "0", "true";
    },
    LMSFinish(empty) {
      calls.push("LMSFinish");
      if (!running("LMSFinish")) return "false";
      if (empty !== "") return fail("201", `LMSFinish(${empty})`);
      return state = "ended", committed = { ...data }, error = "0", "true";
    },
    LMSGetLastError: () => error, LMSGetErrorString: () => "", LMSGetDiagnostic: () => ""
  };
  return { api, data, calls, wrong, committed: () => committed, state: () => state };
}
