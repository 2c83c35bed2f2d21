// A page from disk in headless Chromium, driven through its DevTools pipe (NUL-separated
// JSON on file descriptors 3 and 4): no package needed but node and chromium.
"use strict";
const { spawn } = require("child_process");
const fs = require("fs");
const os = require("os");
const path = require("path");

class Browser {
  // `flags` as --disable-3d-apis.
  constructor(flags = []) {
    this.profile = fs.mkdtempSync(path.join(os.tmpdir(), "cydonia-chromium-"));
    this.child = spawn("chromium",
      ["--headless=new", "--no-sandbox", "--disable-gpu-sandbox", "--use-angle=swiftshader",
       "--enable-unsafe-swiftshader", "--no-first-run", "--disable-background-networking", "--hide-scrollbars",
       "--mute-audio", `--user-data-dir=${this.profile}`, "--remote-debugging-pipe", ...flags, "about:blank"],
      { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"], detached: true });
    this.waiting = new Map();
    this.listeners = [];
    this.id = 0;
    let text = "";
    this.child.stdio[4].setEncoding("utf8");
    this.child.stdio[4].on("data", (part) => {
      text += part;
      for (let end = text.indexOf("\0"); end >= 0; end = text.indexOf("\0")) {
        this.take(JSON.parse(text.slice(0, end)));
        text = text.slice(end + 1);
      }
    });
    this.child.on("exit", () => {
      for (const { fail } of this.waiting.values()) fail(new Error("chromium ended"));
    });
  }

  take(message) {
    const asked = this.waiting.get(message.id);
    if (!asked) return this.listeners.forEach((listener) => listener(message));
    this.waiting.delete(message.id);
    if (message.error) asked.fail(new Error(JSON.stringify(message.error)));
    else asked.done(message.result);
  }

  ask(method, params = {}, sessionId = undefined) {
    const id = ++this.id;
    this.child.stdio[3].write(JSON.stringify({ id, method, params, sessionId }) + "\0");
    return new Promise((done, fail) => this.waiting.set(id, { done, fail }));
  }

  // Opens `file` so wide; `scheme` is light or dark.
  async open(file, { width = 1280, height = 900, scheme = "light", scale = 1, mobile = false } = {}) {
    const { targetId } = await this.ask("Target.createTarget", { url: "about:blank" });
    const { sessionId } = await this.ask("Target.attachToTarget", { targetId, flatten: true });
    const page = new Page(this, sessionId);
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await page.ask(`${domain}.enable`);
    await page.ask("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: scale, mobile });
    await page.ask("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: scheme }] });
    await page.ask("Page.navigate", { url: "file://" + path.resolve(file) });
    await page.until(`document.readyState === "complete" &&
      (!document.getElementById("land") || document.documentElement.dataset.ready)`);
    return page;
  }

  close() {
    try { process.kill(-this.child.pid, "SIGKILL"); } catch (gone) {}
    fs.rmSync(this.profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 100 });
  }
}

class Page {
  constructor(browser, session) {
    this.browser = browser;
    this.session = session;
    this.errors = [];    // of the console, and what was thrown
    this.requests = [];  // all but data: and the page itself
    browser.listeners.push((message) => {
      if (message.sessionId !== session) return;
      const { method, params } = message;
      if (method === "Runtime.exceptionThrown")
        this.errors.push(params.exceptionDetails.exception?.description || params.exceptionDetails.text);
      if (method === "Runtime.consoleAPICalled" && ["error", "warning", "assert"].includes(params.type))
        this.errors.push(params.args.map((arg) => arg.value ?? arg.description).join(" "));
      if (method === "Log.entryAdded" && params.entry.level === "error") this.errors.push(params.entry.text);
      if (method === "Network.requestWillBeSent" && !params.request.url.startsWith("data:") && params.type !== "Document")
        this.requests.push(params.request.url);
    });
  }

  ask(method, params) { return this.browser.ask(method, params, this.session); }

  // The value of an expression; of a promise, what it gives.
  async value(expression) {
    const { result, exceptionDetails } = await this.ask("Runtime.evaluate",
      { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description || exceptionDetails.text);
    return result.value;
  }

  async until(expression, seconds = 30) {
    for (const end = Date.now() + 1000 * seconds; Date.now() < end;) {
      if (await this.value(`Boolean(${expression})`)) return;
      await new Promise((done) => setTimeout(done, 20));
    }
    throw new Error(`never: ${expression}`);
  }

  // After what was asked for is drawn.
  drawn() {
    return this.value("new Promise(r => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(r))))");
  }

  // Of an element, or of what is in the window.
  async screenshot(file, selector = "") {
    const clip = selector ? await this.value(`(() => {
      const box = document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect();
      return { x: box.x + scrollX, y: box.y + scrollY, width: box.width, height: box.height, scale: 1 };
    })()`) : undefined;
    const { data } = await this.ask("Page.captureScreenshot",
      { format: "png", clip, captureBeyondViewport: Boolean(clip) });
    fs.writeFileSync(file, Buffer.from(data, "base64"));
    return data;
  }
}

module.exports = { Browser };
