"""What the browser at hand does with a fixed picture: the same program of WebGL everywhere, against which the live page is held."""

# Milliseconds from an empty canvas to the pixels of its first picture, and of one more: 64,000 triangles of a bumpy
# sphere, lit, in the middle of 1400 x 900.
BARE = """(async () => {
  const [across, around] = [200, 160];
  const corners = [], triangles = [];
  for (let i = 0; i <= across; ++i)
    for (let j = 0; j <= around; ++j) {
      const [u, v] = [(Math.PI * i) / across, (2 * Math.PI * j) / around];
      const r = 0.7 + 0.05 * Math.sin(8 * u) * Math.sin(6 * v);
      corners.push(r * Math.sin(u) * Math.cos(v), r * Math.sin(u) * Math.sin(v), r * Math.cos(u));
    }
  const at = (i, j) => i * (around + 1) + j;
  for (let i = 0; i < across; ++i)
    for (let j = 0; j < around; ++j)
      triangles.push(at(i, j), at(i + 1, j), at(i, j + 1), at(i, j + 1), at(i + 1, j), at(i + 1, j + 1));
  const begin = performance.now();
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [1400, 900];
  document.body.append(canvas);
  const gl = canvas.getContext("webgl2");
  const program = gl.createProgram();
  for (const [kind, text] of [
    [gl.VERTEX_SHADER, `#version 300 es
      in vec3 p; uniform float turn; out vec3 n;
      void main() { n = p; float c = cos(turn), s = sin(turn);
        gl_Position = vec4(c * p.x - s * p.y, p.z, 0.5 * (s * p.x + c * p.y), 1.0); }`],
    [gl.FRAGMENT_SHADER, `#version 300 es
      precision highp float; in vec3 n; out vec4 color;
      void main() { vec3 m = normalize(n); float light = 0.3 + 0.7 * max(0.0, dot(m, normalize(vec3(1.0, 2.0, 3.0))));
        color = vec4(light * vec3(0.8, 0.6, 0.5), 1.0); }`],
  ]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  gl.useProgram(program);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(corners), gl.STATIC_DRAW);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(triangles), gl.STATIC_DRAW);
  gl.enableVertexAttribArray(gl.getAttribLocation(program, "p"));
  gl.vertexAttribPointer(gl.getAttribLocation(program, "p"), 3, gl.FLOAT, false, 0, 0);
  gl.enable(gl.DEPTH_TEST);
  const draw = (turn) => {
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniform1f(gl.getUniformLocation(program, "turn"), turn);
    gl.drawElements(gl.TRIANGLES, triangles.length, gl.UNSIGNED_INT, 0);
    const pixel = new Uint8Array(4);
    gl.readPixels(700, 450, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel); // waits for the pixels
    return pixel[0];
  };
  if (gl.getError() || draw(0) === 0) throw new Error("the bare picture is empty");
  const first = performance.now() - begin;
  const times = [];
  for (let k = 1; k <= 11; ++k) {
    await new Promise(requestAnimationFrame);
    const from = performance.now();
    draw(0.1 * k);
    times.push(performance.now() - from);
  }
  canvas.remove();
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return [first, times.sort((a, b) => a - b)[5]];
})()"""


def bare_picture(browser):
    """First picture, median of later ones [ms]."""
    return browser.value(BARE)
