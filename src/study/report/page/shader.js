// Parts of WebGL programs that show pictures: the report's, and the live viewer's in apps/viewer/page.
"use strict";
{
  const vertexSource = `#version 300 es
    void main() {
      vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
      gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
    }`;

  /// Values of the uniform `tone`: names of ajar.tones.
  ajar.shaderTones = ["srgb", "filmic", "reinhard", "zones"];

  /// Tone curves, and the mean of what a device pixel covers of an image. Programs define `valueAt`.
  ajar.shaderParts = `
    uniform sampler2D maps;          // of makeMapTexture
    uniform float zoom;              // device pixels per image pixel
    uniform vec2 offset;             // of the image's corner, device pixels
    uniform int tone;                // 0: sRGB, 1: filmic, 2: Reinhard, 3: zones
    uniform float scale, gamma, zoneStops;
    uniform vec3 notFinite;
    vec3 valueAt(ivec2 pixel);

    // Looks at the exponent: compilers may take comparisons of NaN away.
    bool finite(vec3 value) {
      return all(notEqual(floatBitsToUint(value) & 0x7f800000u, uvec3(0x7f800000u)));
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
    // when reduced. False outside the image; bad if some value is not finite.
    bool meanUnder(vec2 device, vec2 extent, out vec3 mean, out bool bad) {
      mean = vec3(0.0);
      bad = false;
      vec2 begin = (device - 0.5 - offset) / zoom;
      vec2 end = (device + 0.5 - offset) / zoom;
      if (any(lessThanEqual(end, vec2(0.0))) || any(greaterThanEqual(begin, extent))) return false;
      begin = max(begin, vec2(0.0));
      end = min(end, extent);
      ivec2 first = ivec2(floor(begin));
      ivec2 last = min(ivec2(ceil(end)) - 1, ivec2(extent) - 1);
      ivec2 stride = max((last - first + 16) / 16, ivec2(1));
      vec3 sum = vec3(0.0);
      float weights = 0.0;
      for (int y = first.y; y <= last.y; y += stride.y) {
        for (int x = first.x; x <= last.x; x += stride.x) {
          vec2 corner = vec2(x, y);
          vec2 covered = max(min(corner + 1.0, end) - max(corner, begin), vec2(0.0));
          float weight = covered.x * covered.y * zoom * zoom;
          if (weight < 1e-3 && weights > 0.0) continue;
          vec3 value = valueAt(ivec2(x, y));
          bad = bad || !finite(value);
          sum += weight * value;
          weights += weight;
        }
      }
      mean = sum / weights;
      return true;
    }`;

  ajar.makeProgram = (gl, fragmentSource) => {
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

  ajar.setNearest = (gl) => {
    for (const name of ["TEXTURE_MIN_FILTER", "TEXTURE_MAG_FILTER"]) gl.texParameteri(gl.TEXTURE_2D, gl[name], gl.NEAREST);
    for (const name of ["TEXTURE_WRAP_S", "TEXTURE_WRAP_T"]) gl.texParameteri(gl.TEXTURE_2D, gl[name], gl.CLAMP_TO_EDGE);
  };

  ajar.makeMapTexture = (gl) => {
    const bytes = new Uint8Array(4 * 256 * 2);
    const rows = [ajar.maps.ember, ajar.maps.zones];
    rows.forEach((row, y) => row.forEach((rgb, x) => rgb.forEach((value, c) => {
      bytes[4 * (256 * y + x) + c] = Math.round(255 * value);
    })));
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    ajar.setNearest(gl);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 256, 2, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return texture;
  };
}
