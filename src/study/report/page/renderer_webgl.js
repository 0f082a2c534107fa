// Draws pictures with WebGL 2: half-float textures, uploaded when first shown.
"use strict";
{
  /// Bytes of textures kept on the graphics card (counted as RGBA); the least recently drawn go first.
  const kLimit = 512 * 2 ** 20;

  const vertexSource = `#version 300 es
    void main() {
      vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
      gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
    }`;

  const fragmentSource = `#version 300 es
    precision highp float;
    precision highp int;
    precision highp sampler2D;
    uniform sampler2D image, reference, maps;
    uniform bool imageIsScalar, referenceIsScalar;
    uniform float height, zoom;      // of the canvas; device pixels per image pixel
    uniform vec2 offset;             // of the image's corner, device pixels
    uniform int error;               // 0: none, 1: absolute, 2: relative, 3: SMAPE
    uniform int tone;                // 0: sRGB, 1: filmic, 2: Reinhard, 3: zones
    uniform float scale, gamma, zoneStops;
    uniform vec2 range;              // decades at the ends of the map of errors
    uniform vec3 notFinite;
    out vec4 colour;

    vec3 fetch(sampler2D texture, bool isScalar, ivec2 pixel) {
      vec3 value = texelFetch(texture, pixel, 0).rgb;
      return isScalar ? value.rrr : value;
    }
    // Looks at the exponent: compilers may take comparisons of NaN away.
    bool finite(vec3 value) {
      return all(notEqual(floatBitsToUint(value) & 0x7f800000u, uvec3(0x7f800000u)));
    }
    vec3 errorOf(vec3 a, vec3 r) {
      vec3 difference = abs(a - r);
      vec3 e = difference;
      if (error == 2) e = difference * difference / (r * r + 0.01);
      if (error == 3) e = difference / max(abs(a) + abs(r), 1e-6);
      return vec3((e.r + e.g + e.b) / 3.0);
    }
    vec3 encoded(vec3 x) {
      return mix(1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, 12.92 * x, lessThanEqual(x, vec3(0.0031308)));
    }
    vec3 toneMapped(vec3 x) {
      if (tone == 3) {
        float stop = log2(max(dot(x, vec3(0.2126, 0.7152, 0.0722)), 1e-12) * scale / 0.18);
        int band = int(clamp(floor(stop + 0.5), -zoneStops, zoneStops) + zoneStops);
        return texelFetch(maps, ivec2(band, 1), 0).rgb;
      }
      x = max(x, 0.0) * scale;
      if (tone == 1) {
        x = min(0.6 * x, 1e6);
        x = (x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14);
      } else if (tone == 2) {
        x = x / (1.0 + x);
      }
      return pow(encoded(min(x, 1.0)), vec3(1.0 / gamma));
    }

    // The mean over what the device pixel covers of the image: nearest pixels with smooth edges when magnified, a box
    // when reduced.
    void main() {
      vec2 device = vec2(gl_FragCoord.x, height - gl_FragCoord.y);
      vec2 extent = vec2(textureSize(image, 0));
      vec2 begin = (device - 0.5 - offset) / zoom;
      vec2 end = (device + 0.5 - offset) / zoom;
      if (any(lessThanEqual(end, vec2(0.0))) || any(greaterThanEqual(begin, extent))) discard;
      begin = max(begin, vec2(0.0));
      end = min(end, extent);
      ivec2 first = ivec2(floor(begin));
      ivec2 last = min(ivec2(ceil(end)) - 1, ivec2(extent) - 1);
      ivec2 stride = max((last - first + 16) / 16, ivec2(1));
      vec3 sum = vec3(0.0);
      float weights = 0.0;
      bool bad = false;
      for (int y = first.y; y <= last.y; y += stride.y) {
        for (int x = first.x; x <= last.x; x += stride.x) {
          vec2 corner = vec2(x, y);
          vec2 covered = max(min(corner + 1.0, end) - max(corner, begin), vec2(0.0));
          float weight = covered.x * covered.y * zoom * zoom;
          if (weight < 1e-3 && weights > 0.0) continue;
          vec3 value = fetch(image, imageIsScalar, ivec2(x, y));
          if (error != 0) value = errorOf(value, fetch(reference, referenceIsScalar, ivec2(x, y)));
          bad = bad || !finite(value);
          sum += weight * value;
          weights += weight;
        }
      }
      vec3 mean = sum / weights;
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

  const makeProgram = (gl) => {
    const program = gl.createProgram();
    for (const [kind, source] of [
      [gl.VERTEX_SHADER, vertexSource],
      [gl.FRAGMENT_SHADER, fragmentSource],
    ]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
        throw new Error(gl.getShaderInfoLog(shader));
      }
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    return program;
  };

  const setNearest = (gl) => {
    for (const name of ["TEXTURE_MIN_FILTER", "TEXTURE_MAG_FILTER"]) gl.texParameteri(gl.TEXTURE_2D, gl[name], gl.NEAREST);
    for (const name of ["TEXTURE_WRAP_S", "TEXTURE_WRAP_T"]) gl.texParameteri(gl.TEXTURE_2D, gl[name], gl.CLAMP_TO_EDGE);
  };

  const makeMaps = (gl) => {
    const bytes = new Uint8Array(4 * 256 * 2);
    const rows = [ajar.maps.ember, ajar.maps.zones];
    rows.forEach((row, y) => row.forEach((rgb, x) => rgb.forEach((value, c) => {
      bytes[4 * (256 * y + x) + c] = Math.round(255 * value);
    })));
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    setNearest(gl);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 256, 2, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return texture;
  };

  const kErrors = ["colour", "absolute", "relative", "smape"];
  const kTones = ["srgb", "filmic", "reinhard", "zones"];

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
      program = makeProgram(gl);
      uniforms = new Proxy({}, {
        get: (cache, name) => (cache[name] ??= gl.getUniformLocation(program, name)),
      });
      maps = makeMaps(gl);
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
      setNearest(gl);
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
        gl.uniform1i(uniforms.tone, kTones.indexOf(display.tone));
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
