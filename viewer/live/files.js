// Import of dropped or chosen files, and saving of worlds.

import { el } from "../report/dom.js";
import { download } from "../report/save.js";
import { ask, askFile } from "./panels/dialogs.js";
import { choice } from "./panels/controls.js";

const CHUNK = 0x8000; // bytes that String.fromCharCode takes at once

/// Encodes bytes as base64.
export function base64Of(bytes) {
  let text = "";
  for (let at = 0; at < bytes.length; at += CHUNK)
    text += String.fromCharCode(...bytes.subarray(at, at + CHUNK));
  return btoa(text);
}

/// Guesses the role of files: URDF and MJCF are robots.
export const guessKind = (names) =>
  names.some((name) => /\.(urdf|xml|mjcf)$/i.test(name)) ? "hand" : "object";

/// Returns true if files state their units; most mesh formats do not.
const sayUnits = (names) => names.some((name) => /\.(toml|urdf|xml|mjcf)$/i.test(name));

/// Asks the user for the role of files. Returns a promise of { as: "object", "obstacle" or "hand", units? }, or null.
async function askKind(names) {
  const as = choice("As", () => {});
  as.set(["object", "obstacle", "hand"], guessKind(names));
  const units = choice("Units", () => {});
  units.set(["m", "cm", "mm", "in"], "m");
  const bare = !sayUnits(names);
  const words = el(
    "span",
    {},
    `Import ${names.length === 1 ? names[0] : `${names.length} files`}`,
    as,
    bare ? units : null,
  );
  if (!(await ask(words, "Import"))) return null;
  return { as: as.value(), ...(bare ? { units: units.value() } : {}) };
}

const promised = (work) => new Promise((done, failed) => work(done, failed));

/// Returns the files below an entry of a drop: { path within the drop, file }.
async function filesBelow(entry) {
  if (entry.isFile)
    return [{ path: entry.fullPath.replace(/^\//, ""), file: await promised((...f) => entry.file(...f)) }];
  const reader = entry.createReader();
  const found = [];
  for (;;) {
    // Read the entries in batches; an empty batch is the end.
    const some = await promised((...f) => reader.readEntries(...f));
    if (!some.length) return found;
    for (const one of some) found.push(...(await filesBelow(one)));
  }
}

const plainFiles = (files) =>
  [...files].map((file) => ({ path: file.webkitRelativePath || file.name, file }));

/// All files of a drop, folders included, as filesBelow(). Entries have to be taken before anything is waited for.
export async function droppedFiles({ items, files }) {
  const entries = [...(items ?? [])].map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
  if (!entries.length) return plainFiles(files);
  return (await Promise.all(entries.map(filesBelow))).flat();
}

async function importAll(app, files) {
  const names = files.map(({ path }) => path);
  if (files.length === 1 && /\.toml$/i.test(names[0])) {
    const text = await files[0].file.text();
    if (await app.mayLeave())
      await app.ask("world.load", { text, name: names[0].replace(/\.toml$/i, "") });
    return;
  }
  const wanted = await askKind(names);
  if (!wanted) return;
  const sent = await Promise.all(
    files.map(async ({ path, file }) => ({
      name: path,
      data: base64Of(new Uint8Array(await file.arrayBuffer())),
    })),
  );
  const made = await app.ask("world.import", { files: sent, ...wanted });
  if (!made) return;
  app.notices.tell(`${made.name} was imported.`);
}

/// Takes files that are dropped anywhere on the page; returns a function that lets a reader choose some.
export function takeFiles(app) {
  const input = el("input", { type: "file", multiple: true, hidden: true, id: "files" });
  document.body.append(input);
  const take = (files) =>
    files
      .then((all) => all.length && importAll(app, all))
      .catch((e) => app.notices.error(e.message));
  input.addEventListener("change", () => {
    take(Promise.resolve(plainFiles(input.files)));
    input.value = "";
  });
  const over = (on) => document.body.classList.toggle("dropping", on);
  addEventListener("dragover", (event) => {
    event.preventDefault();
    over(true);
  });
  addEventListener("dragleave", () => over(false));
  addEventListener("drop", (event) => {
    event.preventDefault();
    over(false);
    take(droppedFiles(event.dataTransfer));
  });
  return () => input.click();
}

/// Saves the world below the server's folder, or downloads it.
export async function saveWorld(app) {
  const world = app.store.state?.world ?? {};
  const before =
    world.file && !world.file.startsWith("/") ? world.file : `${world.name || "world"}.toml`;
  const wanted = await askFile(before);
  if (!wanted) return;
  if (wanted.where === "download") {
    const got = await app.ask("world.text");
    if (got) download(wanted.name.split("/").at(-1), got.toml, "application/toml");
    return;
  }
  if (await saveAs(app, wanted.name)) app.notices.tell(`Saved as ${wanted.name}.`);
}

/// Saves the world on the server; asks before another file is overwritten.
export async function saveAs(app, file, replace = (question) => ask(question, "Replace it")) {
  try {
    return await app.call("world.save", { file });
  } catch (error) {
    if (/is there already/.test(error.message))
      return (await replace(`${error.message.split(": 'overwrite'")[0]}.`))
        ? app.ask("world.save", { file, overwrite: true })
        : null;
    if (error.code !== "lost") app.notices.error(`world.save: ${error.message}`);
    return null;
  }
}
