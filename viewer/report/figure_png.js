// An SVG file as a picture of pixels.

const RATIO = 2; // pixels to each of CSS

/// A drawing that the browser has read.
async function loaded(text) {
  const href = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
  const image = new Image();
  image.src = href;
  try {
    await image.decode();
  } finally {
    URL.revokeObjectURL(href);
  }
  return image;
}

/// The text of an SVG file as a PNG file, a blob; twice as many pixels each way as the page has.
/// Fails if the browser cannot read the drawing.
export async function pngOf(text) {
  const image = await loaded(text);
  const canvas = document.createElement("canvas");
  canvas.width = Math.ceil(RATIO * image.naturalWidth);
  canvas.height = Math.ceil(RATIO * image.naturalHeight);
  canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((done, failed) =>
    canvas.toBlob((blob) => (blob ? done(blob) : failed(new Error("no picture"))), "image/png"),
  );
}
