// From pixels to display colours on the processor: for insets, swatches, and where there is no WebGL. The shader in
// renderer_webgl.js computes the same.
"use strict";
{
  const channel = (entry, index, c) => ajar.halfs[entry.pixels[entry.channels === 3 ? 3 * index + c : index]];

  /// [r, g, b], scene-linear.
  ajar.valueAt = (entry, index) => [channel(entry, index, 0), channel(entry, index, 1), channel(entry, index, 2)];

  /// Mean error over the channels, by the name of ajar.errors.
  ajar.errorAt = (entry, reference, index, name) => {
    const of = ajar.errors[name].of;
    let sum = 0;
    for (let c = 0; c < 3; ++c) sum += of(channel(entry, index, c), channel(reference, index, c));
    return sum / 3;
  };

  const luminance = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

  const colourOfValue = (value, display) => {
    if (!value.every(Number.isFinite)) return ajar.notFinite;
    const scale = 2 ** display.exposure;
    if (display.tone === "zones") {
      const stop = Math.log2((Math.max(luminance(value), 1e-12) * scale) / 0.18);
      const { zones, zoneStops } = ajar.maps;
      return zones[ajar.clamp(Math.round(stop), -zoneStops, zoneStops) + zoneStops];
    }
    const curve = ajar.tones[display.tone].apply;
    return value.map((x) => ajar.srgbFromLinear(curve(Math.max(x, 0) * scale)) ** (1 / display.gamma));
  };

  const colourOfError = (error, display) => {
    if (!Number.isFinite(error)) return ajar.notFinite;
    const { low, high } = ajar.errorRange(display);
    const t = (Math.log10(Math.max(error, 1e-12)) - low) / (high - low);
    return ajar.maps.ember[Math.round(ajar.clamp(t, 0, 1) * 255)];
  };

  /// Decades at the ends of the colour map.
  ajar.errorRange = ({ map, shift }) => ({ low: ajar.errors[map].low + shift, high: ajar.errors[map].high + shift });

  /// Display colour, three numbers in [0, 1], of a pixel. `display`: exposure, gamma, tone, map, shift of ajar.state.
  /// The reference may be missing if no error is shown.
  ajar.shade = (entry, reference, index, display) =>
    display.map === "colour"
      ? colourOfValue(ajar.valueAt(entry, index), display)
      : colourOfError(ajar.errorAt(entry, reference, index, display.map), display);

  // Display byte of each half, for curves that treat channels alone; 256 marks what is not finite.
  let table = { key: "", bytes: null };
  const curveTable = (display) => {
    const key = `${display.tone} ${display.exposure} ${display.gamma}`;
    if (table.key !== key) {
      const bytes = Uint16Array.from(ajar.halfs, (x) =>
        Number.isFinite(x) ? Math.round(255 * colourOfValue([x, x, x], display)[0]) : 256,
      );
      table = { key, bytes };
    }
    return table.bytes;
  };

  const shadeFast = (entry, first, width, height, display, out) => {
    const bytes = curveTable(display);
    const { pixels, channels } = entry;
    const second = channels === 3 ? 1 : 0;
    for (let y = 0, o = 0; y < height; ++y) {
      for (let x = 0, i = (first + y * entry.width) * channels; x < width; ++x, i += channels, o += 4) {
        const r = bytes[pixels[i]];
        const g = bytes[pixels[i + second]];
        const b = bytes[pixels[i + 2 * second]];
        const bad = (r | g | b) & 256;
        out[o] = bad ? 255 : r;
        out[o + 1] = bad ? 0 : g;
        out[o + 2] = bad ? 255 : b;
        out[o + 3] = 255;
      }
    }
  };

  /// ImageData of a block that lies inside the image.
  ajar.shadeBlock = (entry, reference, x, y, width, height, display) => {
    const data = new ImageData(width, height);
    const first = y * entry.width + x;
    if (display.map === "colour" && display.tone !== "zones") {
      shadeFast(entry, first, width, height, display, data.data);
      return data;
    }
    for (let row = 0, o = 0; row < height; ++row) {
      for (let column = 0; column < width; ++column, o += 4) {
        const colour = ajar.shade(entry, reference, first + row * entry.width + column, display);
        for (let c = 0; c < 3; ++c) data.data[o + c] = Math.round(255 * colour[c]);
        data.data[o + 3] = 255;
      }
    }
    return data;
  };
}
