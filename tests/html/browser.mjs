// SPDX-License-Identifier: MIT
// A headless Chromium, driven over its DevTools protocol through a pipe: nothing but Node needed.
import {spawn} from "node:child_process";
import {mkdtempSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";

const kFlags = [
  "--headless", "--remote-debugging-pipe", "--no-sandbox", "--disable-gpu", "--disable-quic",
  "--no-first-run", "--disable-background-networking", "--disable-component-update",
  "--disable-sync", "--disable-extensions", "--disable-dev-shm-usage",
  // Whatever a page might ask for, no name resolves.
  "--host-resolver-rules=MAP * ~NOTFOUND",
];

export class Browser {
  #process;
  #profile = mkdtempSync(join(tmpdir(), "lanescope-chromium-"));
  #waiting = new Map();
  #listeners = [];
  #received = "";
  #next = 0;

  constructor(program) {
    this.#process = spawn(program, [...kFlags, `--user-data-dir=${this.#profile}`], {
      stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"],
    });
    this.#process.stdio[4].setEncoding("utf8").on("data", (text) => this.#receive(text));
    this.#process.on("error", (error) => this.#fail(error));
    this.#process.on("exit", (status) => this.#fail(new Error(`${program} ended with ${status}`)));
  }

  // Sends a command and resolves to its result.
  send(method, params = {}, sessionId = undefined) {
    const id = ++this.#next;
    this.#process.stdio[3].write(JSON.stringify({id, method, params, sessionId}) + "\0");
    return new Promise((resolve, reject) => this.#waiting.set(id, {resolve, reject, method}));
  }

  // Calls f({method, params, sessionId}) for each event.
  onEvent(f) {
    this.#listeners.push(f);
  }

  // An empty page; send() and evaluate() of it.
  async newPage() {
    const {targetId} = await this.send("Target.createTarget", {url: "about:blank"});
    const {sessionId} = await this.send("Target.attachToTarget", {targetId, flatten: true});
    const send = (method, params) => this.send(method, params, sessionId);
    const evaluate = async (expression) => {
      const answer = await send("Runtime.evaluate",
                                {expression, awaitPromise: true, returnByValue: true});
      if (answer.exceptionDetails)
        throw new Error(answer.exceptionDetails.exception?.description ?? expression);
      return answer.result.value;
    };
    return {sessionId, send, evaluate};
  }

  async close() {
    const ended = new Promise((resolve) => this.#process.once("exit", resolve));
    this.#process.removeAllListeners("exit");
    this.#process.once("exit", () => {});
    const exit = new Promise((resolve) => this.#process.once("exit", resolve));
    await Promise.race([this.send("Browser.close"), exit]).catch(() => {});
    await Promise.race([ended, exit]);
    rmSync(this.#profile, {recursive: true, force: true, maxRetries: 5});
  }

  #receive(text) {
    const messages = (this.#received + text).split("\0");
    this.#received = messages.pop();
    for (const message of messages.map((json) => JSON.parse(json))) {
      if (message.id === undefined) {
        for (const listener of this.#listeners) listener(message);
        continue;
      }
      const {resolve, reject, method} = this.#waiting.get(message.id);
      this.#waiting.delete(message.id);
      if (message.error) reject(new Error(`${method}: ${message.error.message}`));
      else resolve(message.result);
    }
  }

  #fail(error) {
    for (const {reject} of this.#waiting.values()) reject(error);
    this.#waiting.clear();
  }
}
