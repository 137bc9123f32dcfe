"use strict";
// The lessons' own code: a small script, and WebAssembly. A server sends that as it is, and a browser compiles it while it comes.
// A page from disk can fetch nothing: it takes the same, packed, from one more script, as does any page where the fetch fails.
const isect_code = {
  /// Adds a script: a file beside the page, or "#id", one within it.
  script(from) {
    return new Promise((resolve, reject) => {
      const made = document.createElement("script"), inside = document.getElementById(from.slice(1));
      made.onload = resolve, made.onerror = reject;
      if (from.startsWith("#")) made.textContent = inside.textContent;
      else made.src = from;
      document.head.append(made);
      if (from.startsWith("#")) resolve();
    });
  },
  /// Resolves when the page has been painted and nothing else is to do.
  idle() {
    return new Promise(done => window.requestIdleCallback ? requestIdleCallback(done, { timeout: 1000 }) : setTimeout(done, 50));
  },
  async fetched(address) {
    const response = await fetch(address), told = response.headers.get("content-type") ?? "";
    if (!response.ok) throw new Error(address + ": " + response.status);
    if (WebAssembly.compileStreaming && told.startsWith("application/wasm")) return WebAssembly.compileStreaming(response);
    return WebAssembly.compile(await response.arrayBuffer());
  },
  async unpacked(from) {
    if (from) await this.script(from);
    const text = atob(isect_module.packed), packed = new Uint8Array(text.length);
    for (let i = 0; i < packed.length; ++i) packed[i] = text.charCodeAt(i);
    isect_module.packed = "";
    const bytes = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return WebAssembly.compile(await new Response(bytes).arrayBuffer());
  },
  /// Resolves with a function from request to answer. `address`: of the script, as for script().
  async ready(address) {
    const inside = address.startsWith("#"), named = ending => address.replace(/\.js$/, ending);
    const served = !inside && location.protocol.startsWith("http") ? this.fetched(named(".wasm")).catch(() => null) : null;
    if (!served) await this.idle();
    await this.script(address);
    const compiled = await served ?? await this.unpacked(inside ? "" : named("-packed.js"));
    await this.idle();
    const code = await new Promise((resolve, reject) => isect_module({
      instantiateWasm(imports, done) {
        WebAssembly.instantiate(compiled, imports).then(instance => done(instance, compiled)).catch(reject);
        return {};
      }
    }).then(resolve, reject));
    const answer = asked => code.ccall("isect_answer", "string", ["string"], [asked]);
    return asked => JSON.parse(answer(JSON.stringify(asked)));
  }
};
