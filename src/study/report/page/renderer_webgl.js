// Draws pictures with WebGL 2: half-float textures, uploaded when first shown.
"use strict";
{
  /// Bytes of textures kept on the graphics card (counted as RGBA); the least recently drawn go first.
  const kLimit = 512 * 2 ** 20;

  const fragmentSource = `#version 300 es
    precision highp float;
    precision highp int;
    precision highp sampler2D;
    ${ajar.shaderParts}
    uniform sampler2D image, reference;
    uniform bool imageIsScalar, referenceIsScalar;
    uniform float height;            // of the canvas
    uniform int error;               // 0: none, 1: absolute, 2: relative, 3: SMAPE
    uniform vec2 range;              // decades at the ends of the map of errors
    out vec4 colour;

    vec3 fetch(sampler2D texture, bool isScalar, ivec2 pixel) {
      vec3 value = texelFetch(texture, pixel, 0).rgb;
      return isScalar ? value.rrr : value;
    }
    vec3 errorOf(vec3 a, vec3 r) {
      vec3 difference = abs(a - r);
      vec3 e = difference;
      if (error == 2) e = difference * difference / (r * r + 0.01);
      if (error == 3) e = difference / max(abs(a) + abs(r), 1e-6);
      return vec3((e.r + e.g + e.b) / 3.0);
    }
    vec3 valueAt(ivec2 pixel) {
      vec3 value = fetch(image, imageIsScalar, pixel);
      return error == 0 ? value : errorOf(value, fetch(reference, referenceIsScalar, pixel));
    }

    void main() {
      vec3 mean;
      bool bad;
      vec2 device = vec2(gl_FragCoord.x, height - gl_FragCoord.y);
      if (!meanUnder(device, vec2(textureSize(image, 0)), mean, bad)) discard;
      if (bad) {
        colour = vec4(notFinite, 1.0);
      } else if (error != 0) {
        float decade = log2(max(mean.r, 1e-12)) / log2(10.0);
        float t = clamp((decade - range.x) / (range.y - range.x), 0.0, 1.0);
        colour = vec4(texelFetch(maps, ivec2(floor(t * 255.0 + 0.5), 0), 0).rgb, 1.0);
      } else {
        colour = vec4(toneMapped(mean), 1.0);
      }
    }`;

  const kErrors = ["colour", "absolute", "relative", "smape"];

  /// Whether the processor does it, by the names that such drivers give themselves.
  const isSoftware = (gl) => {
    const names = gl.getExtension("WEBGL_debug_renderer_info");
    const name = gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
    return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
  };

  /// A renderer on the canvas, or null where WebGL 2 is missing, too small for the images, or, unless it is `forced`, done
  /// by the processor: the other renderer is faster then.
  ajar.makeWebGlRenderer = (canvas, largestSide, forced) => {
    const gl = canvas.getContext("webgl2", { alpha: true, antialias: false, depth: false, premultipliedAlpha: true });
    if (!gl || gl.getParameter(gl.MAX_TEXTURE_SIZE) < largestSide) return null;
    if (!forced && isSoftware(gl)) return null;

    let program, uniforms, maps, textures, bytes;
    const start = () => {
      program = ajar.makeProgram(gl, fragmentSource);
      uniforms = new Proxy({}, {
        get: (cache, name) => (cache[name] ??= gl.getUniformLocation(program, name)),
      });
      maps = ajar.makeMapTexture(gl);
      textures = new Map(); // file → {texture, bytes}, least recently drawn first
      bytes = 0;
      gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
      gl.useProgram(program);
      ["image", "reference", "maps"].forEach((name, unit) => gl.uniform1i(uniforms[name], unit));
      gl.uniform1f(uniforms.zoneStops, ajar.maps.zoneStops);
      gl.uniform3fv(uniforms.notFinite, ajar.notFinite);
      gl.enable(gl.SCISSOR_TEST);
    };
    start();
    canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => {
      start();
      ajar.redraw();
    });

    const upload = (entry) => {
      const texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, texture);
      ajar.setNearest(gl);
      const isColour = entry.channels === 3;
      gl.texImage2D(gl.TEXTURE_2D, 0, isColour ? gl.RGB16F : gl.R16F, entry.width, entry.height, 0,
        isColour ? gl.RGB : gl.RED, gl.HALF_FLOAT, entry.pixels);
      return { texture, bytes: (isColour ? 8 : 2) * entry.width * entry.height };
    };
    const textureOf = (entry) => {
      let kept = textures.get(entry.file);
      if (kept) {
        textures.delete(entry.file);
      } else {
        kept = upload(entry);
        bytes += kept.bytes;
      }
      textures.set(entry.file, kept);
      return kept.texture;
    };
    const dropOldest = () => {
      for (const [file, old] of textures) {
        if (bytes <= kLimit) return;
        gl.deleteTexture(old.texture);
        textures.delete(file);
        bytes -= old.bytes;
      }
    };
    const bind = (unit, texture) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
    };

    return {
      name: "WebGL",
      clear() {
        gl.viewport(0, 0, canvas.width, canvas.height);
        gl.scissor(0, 0, canvas.width, canvas.height);
        gl.clearColor(0, 0, 0, 0);
        gl.clear(gl.COLOR_BUFFER_BIT);
      },
      /// Draws columns [left, right) of the canvas.
      draw(entry, reference, view, display, left, right) {
        gl.activeTexture(gl.TEXTURE0);
        const texture = textureOf(entry);
        const other = reference ? textureOf(reference) : texture;
        bind(0, texture);
        bind(1, other);
        bind(2, maps);
        gl.scissor(left, 0, Math.max(right - left, 0), canvas.height);
        gl.uniform1i(uniforms.imageIsScalar, entry.channels === 1 ? 1 : 0);
        gl.uniform1i(uniforms.referenceIsScalar, reference?.channels === 1 ? 1 : 0);
        gl.uniform1f(uniforms.height, canvas.height);
        gl.uniform1f(uniforms.zoom, view.zoom);
        gl.uniform2f(uniforms.offset, view.left, view.top);
        gl.uniform1i(uniforms.error, kErrors.indexOf(display.map));
        gl.uniform1i(uniforms.tone, ajar.shaderTones.indexOf(display.tone));
        gl.uniform1f(uniforms.scale, 2 ** display.exposure);
        gl.uniform1f(uniforms.gamma, display.gamma);
        if (display.map !== "colour") {
          const { low, high } = ajar.errorRange(display);
          gl.uniform2f(uniforms.range, low, high);
        }
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        dropOldest();
      },
      /// Waits until everything is drawn: for measuring.
      finish() {
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      },
    };
  };
}
