import type { Frame } from "./frame";
import { kChannels, kMaps, type Display } from "./display";
import type { Place } from "./view";

const kFragmentSource = `#version 300 es
  precision highp float;
  precision highp int;
  precision highp sampler2D;
  ${ajar.shaderParts}
  uniform sampler2D image;
  uniform bool isScalar;
  uniform float height;            // of the canvas
  uniform int map;                 // 0: tone curve, 1: heat, 2: heat of decades, 3: labels
  uniform int channel;             // 0: all, 1 to 3: one, 4: luminance
  uniform vec2 range;              // values at the ends of the heat
  out vec4 colour;

  vec3 colourOfLabel(float number) {
    if (number < 0.5) return vec3(0.08);
    float hue = fract(0.618034 * number);
    float light = 0.45 + 0.2 * fract(0.381966 * number + 0.25);
    return light + 0.35 * cos(6.2831853 * (hue + vec3(0.0, 0.333, 0.667)));
  }
  vec3 valueAt(ivec2 pixel) {
    vec3 value = texelFetch(image, pixel, 0).rgb;
    if (isScalar) value = value.rrr;
    if (channel == 4) value = vec3(dot(value, vec3(0.2126, 0.7152, 0.0722)));
    else if (channel > 0) value = vec3(value[channel - 1]);
    return map == 3 ? colourOfLabel(value.r) : value;
  }
  vec3 heatOf(vec3 value) {
    float x = dot(value, vec3(1.0 / 3.0));
    vec2 ends = range;
    if (map == 2) {
      ends = log(max(range, 1e-12));
      x = log(max(x, 1e-12));
    }
    float t = clamp((x - ends.x) / max(ends.y - ends.x, 1e-20), 0.0, 1.0);
    return texelFetch(maps, ivec2(floor(t * 255.0 + 0.5), 0), 0).rgb;
  }

  void main() {
    vec3 mean;
    bool bad;
    vec2 device = vec2(gl_FragCoord.x, height - gl_FragCoord.y);
    if (!meanUnder(device, vec2(textureSize(image, 0)), mean, bad)) discard;
    if (bad) colour = vec4(notFinite, 1.0);
    else if (map == 3) colour = vec4(mean, 1.0);
    else if (map == 0) colour = vec4(toneMapped(mean), 1.0);
    else colour = vec4(heatOf(mean), 1.0);
  }`;

type Uniforms = Record<string, WebGLUniformLocation | null>;

interface Slot {
  frame: Frame | null;
  texture: WebGLTexture | null;
  /// of the texture's storage
  key: string;
}

/// Frames in textures of half floats, drawn with WebGL 2. Slot 0 has the present frame, slot 1 the one that was kept.
export class Renderer {
  private readonly gl: WebGL2RenderingContext;
  private readonly slots: [Slot, Slot] = [emptySlot(), emptySlot()];
  private uniforms: Uniforms = {};

  /// Raises an Error where WebGL 2 is missing. `redraw` is called when a lost context is back.
  constructor(private readonly canvas: HTMLCanvasElement, redraw: () => void) {
    const gl = canvas.getContext("webgl2", { alpha: true, antialias: false, depth: false });
    if (!gl) throw new Error("This browser has no WebGL 2, which shows the picture.");
    this.gl = gl;
    this.start();
    canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => {
      this.start();
      for (const slot of this.slots) {
        const { frame } = slot;
        Object.assign(slot, emptySlot());
        if (frame) this.upload(slot, frame);
      }
      redraw();
    });
  }

  hold(index: 0 | 1, frame: Frame | null): void {
    const slot = this.slots[index];
    if (slot.frame === frame) return;
    if (frame) {
      this.upload(slot, frame);
    } else {
      this.gl.deleteTexture(slot.texture);
      Object.assign(slot, emptySlot());
    }
  }

  clear(): void {
    const { gl, canvas } = this;
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.scissor(0, 0, canvas.width, canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
  }

  /// Draws columns [left, right) of the canvas. `place` is of the image; the frame lies in it.
  draw(index: 0 | 1, place: Place, display: Display, range: readonly [number, number], left: number, right: number): void {
    const { gl, canvas, uniforms } = this;
    const { frame, texture } = this.slots[index];
    if (!frame || right <= left) return;
    const top = Math.max(0, Math.round(place.top + frame.y * place.zoom));
    const bottom = Math.min(canvas.height, Math.round(place.top + (frame.y + frame.height) * place.zoom));
    const begin = Math.max(left, Math.round(place.left + frame.x * place.zoom));
    const end = Math.min(right, Math.round(place.left + (frame.x + frame.width) * place.zoom));
    if (bottom <= top || end <= begin) return;
    // Coarse pixels at the edge reach beyond the picture.
    gl.scissor(begin, canvas.height - bottom, end - begin, bottom - top);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.uniform1i(uniforms.isScalar!, frame.channels === 1 ? 1 : 0);
    gl.uniform1f(uniforms.height!, canvas.height);
    gl.uniform1f(uniforms.zoom!, place.zoom * frame.step);
    gl.uniform2f(uniforms.offset!, place.left + frame.x * place.zoom, place.top + frame.y * place.zoom);
    const map = display.mapOf(frame.layer, frame.channels);
    gl.uniform1i(uniforms.map!, Object.keys(kMaps).indexOf(map));
    gl.uniform1i(uniforms.channel!, frame.channels === 1 ? 0 : Object.keys(kChannels).indexOf(display.channel));
    gl.uniform1i(uniforms.tone!, ajar.shaderTones.indexOf(display.tone));
    gl.uniform1f(uniforms.scale!, 2 ** display.exposure);
    gl.uniform1f(uniforms.gamma!, 1);
    gl.uniform2f(uniforms.range!, ...range);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /// Bytes of a pixel of the canvas. To be called right after drawing, before the browser takes the picture.
  read(x: number, y: number): number[] {
    const bytes = new Uint8Array(4);
    this.gl.readPixels(x, this.canvas.height - 1 - y, 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, bytes);
    return [...bytes];
  }

  private start(): void {
    const { gl } = this;
    const program = ajar.makeProgram(gl, kFragmentSource);
    const names = ["image", "maps", "isScalar", "height", "zoom", "offset", "map", "channel", "tone", "scale", "gamma", "range",
      "zoneStops", "notFinite"];
    this.uniforms = Object.fromEntries(names.map((name) => [name, gl.getUniformLocation(program, name)]));
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 2);
    gl.useProgram(program);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, ajar.makeMapTexture(gl));
    gl.uniform1i(this.uniforms.image!, 0);
    gl.uniform1i(this.uniforms.maps!, 1);
    gl.uniform1f(this.uniforms.zoneStops!, ajar.maps.zoneStops);
    gl.uniform3fv(this.uniforms.notFinite!, [...ajar.notFinite]);
    gl.enable(gl.SCISSOR_TEST);
  }

  /// Halfs go to the texture as they are. Storage is made anew only for another size.
  private upload(slot: Slot, frame: Frame): void {
    const { gl } = this;
    const { columns, rows, channels, halfs } = frame;
    const format = channels === 3 ? gl.RGB : gl.RED;
    const key = `${columns} ${rows} ${channels}`;
    gl.activeTexture(gl.TEXTURE0);
    slot.texture ??= gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, slot.texture);
    if (slot.key === key) {
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, columns, rows, format, gl.HALF_FLOAT, halfs);
    } else {
      ajar.setNearest(gl);
      const stored = channels === 3 ? gl.RGB16F : gl.R16F;
      gl.texImage2D(gl.TEXTURE_2D, 0, stored, columns, rows, 0, format, gl.HALF_FLOAT, halfs);
    }
    slot.key = key;
    slot.frame = frame;
  }
}

function emptySlot(): Slot {
  return { frame: null, texture: null, key: "" };
}
