// Drives a headless Chromium over its debugging pipe: no port, no package.

import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const FLAGS = [
  "--headless",
  "--no-sandbox",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--use-gl=angle",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--remote-debugging-pipe",
];

/// Splits the stream into messages, which end with a zero byte.
function onMessages(stream, handle) {
  let rest = "";
  stream.setEncoding("utf8").on("data", (text) => {
    const parts = (rest + text).split("\0");
    rest = parts.pop();
    parts.forEach((part) => handle(JSON.parse(part)));
  });
}

/// Starts the browser with one page; returns send(method, parameters), events (all seen so far) and
/// close().
export async function startBrowser(command = process.env.CHROMIUM ?? "chromium") {
  const profile = mkdtempSync(join(tmpdir(), "thenar-page-"));
  const child = spawn(command, [...FLAGS, `--user-data-dir=${profile}`, "about:blank"], {
    stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"],
  });
  const waiting = new Map();
  const events = [];
  let next = 1;
  let sessionId;
  onMessages(child.stdio[4], (message) => {
    const call = waiting.get(message.id);
    if (!call) return events.push(message);
    waiting.delete(message.id);
    if (message.error) call.reject(new Error(message.error.message));
    else call.resolve(message.result);
  });
  const send = (method, params = {}) =>
    new Promise((resolve, reject) => {
      waiting.set(next, { resolve, reject });
      child.stdio[3].write(JSON.stringify({ id: next++, method, params, sessionId }) + "\0");
    });
  const { targetInfos } = await send("Target.getTargets");
  const page = targetInfos.find(({ type }) => type === "page");
  ({ sessionId } = await send("Target.attachToTarget", { targetId: page.targetId, flatten: true }));
  const close = async () => {
    const ended = new Promise((resolve) => child.once("exit", resolve));
    sessionId = undefined;
    send("Browser.close").catch(() => {});
    await ended;
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  };
  return { send, events, close };
}
