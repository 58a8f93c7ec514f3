// A film of what a canvas shows, recorded by the browser as WebM.

const RATE = 30; // pictures a second
const BITS = 8e6; // a second

/// Whether the browser can record.
export const canRecord = () =>
  typeof MediaRecorder !== "undefined" && MediaRecorder.isTypeSupported("video/webm");

/// Begins to record copies of `canvas` on a colour; returns { frame(), stop(), film }: frame() takes
/// what the canvas shows, `film` promises a blob once stop() was called, and fails where the browser
/// ends the recording with an error.
export function record(canvas, color) {
  const copy = document.createElement("canvas");
  copy.width = canvas.width;
  copy.height = canvas.height;
  const context = copy.getContext("2d");
  const frame = () => {
    context.fillStyle = color;
    context.fillRect(0, 0, copy.width, copy.height);
    context.drawImage(canvas, 0, 0, copy.width, copy.height);
  };
  frame();
  const options = { mimeType: "video/webm", videoBitsPerSecond: BITS };
  const recorder = new MediaRecorder(copy.captureStream(RATE), options);
  const parts = [];
  recorder.addEventListener("dataavailable", ({ data }) => parts.push(data));
  const film = new Promise((done, failed) => {
    recorder.addEventListener("error", ({ error }) => failed(error ?? new Error("no film")));
    recorder.addEventListener("stop", () => done(new Blob(parts, { type: "video/webm" })));
  });
  film.catch(() => {}); // told to whoever waits for it
  recorder.start();
  const stop = () => {
    if (recorder.state !== "inactive") recorder.stop();
  };
  return { frame, stop, film };
}
