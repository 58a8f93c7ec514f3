// A film of what a canvas shows, recorded by the browser as WebM.

const RATE = 30; // pictures a second
const BITS = 8e6; // a second

/// Whether the browser can record.
export const canRecord = () =>
  typeof MediaRecorder !== "undefined" && MediaRecorder.isTypeSupported("video/webm");

/// Begins to record copies of `canvas` on a colour; returns { frame(), stop() }: frame() takes what
/// the canvas shows, stop() promises the film as a blob.
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
  const ended = new Promise((done) =>
    recorder.addEventListener("stop", () => done(new Blob(parts, { type: "video/webm" }))),
  );
  recorder.start();
  return {
    frame,
    stop() {
      recorder.stop();
      return ended;
    },
  };
}
