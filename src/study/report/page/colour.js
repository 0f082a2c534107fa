// Tone curves and colour maps, for the shader in renderer_webgl.js and for shade.js alike.
"use strict";
{
  const linearFromOklab = (lightness, a, b) => {
    // Source: Ottosson 2020, "A perceptual color space for image processing".
    const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
    const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
    const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
    return [
      4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
      -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
      -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
    ];
  };
  const encode = (x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);
  ajar.srgbFromLinear = encode;

  /// The most saturated colour up to `chroma` that sRGB can show.
  const inGamut = (lightness, chroma, hue) => {
    for (let c = chroma; ; c -= 0.004) {
      const rgb = linearFromOklab(lightness, c * Math.cos(hue), c * Math.sin(hue));
      if (c <= 0 || rgb.every((x) => x >= -1e-4 && x <= 1.0001)) return rgb.map((x) => encode(ajar.clamp(x, 0, 1)));
    }
  };

  /// 256 display colours from dark violet over red to pale yellow. Equal steps are equal steps of OKLab lightness, so
  /// that it reads the same in grey and to the colour-blind.
  const ember = Array.from({ length: 256 }, (_, i) => {
    const t = i / 255;
    const hue = ((285 + 185 * t) * Math.PI) / 180;
    return inGamut(0.16 + 0.81 * t, 0.2 * Math.sin(Math.PI * (0.12 + 0.8 * t)), hue);
  });

  /// Bands of one stop around middle grey, −6 … +6: cold below, grey in the middle, warm above, lighter and lighter.
  const kStops = 6;
  const zones = Array.from({ length: 2 * kStops + 1 }, (_, i) => {
    const stop = i - kStops;
    const hue = ((stop < 0 ? 300 - 22 * (stop + kStops) : 120 - 16 * stop) * Math.PI) / 180;
    return inGamut(0.22 + (0.74 * i) / (2 * kStops), stop === 0 ? 0 : 0.16, hue);
  });

  ajar.maps = { ember, zones, zoneStops: kStops };

  /// Curves on a linear value ≥ 0, by the name used in the URL; the results are linear.
  ajar.tones = {
    srgb: { title: "sRGB", apply: (x) => Math.min(x, 1) },
    // As `filmic_curve` in image/tone_map.h (Narkowicz 2016, "ACES filmic tone mapping curve").
    filmic: {
      title: "Filmic",
      apply: (linear) => {
        const x = Math.min(0.6 * linear, 1e6);
        return Math.min((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 1);
      },
    },
    // Reinhard et al. 2002, eq. 3, per channel.
    reinhard: { title: "Reinhard", apply: (x) => (x === Infinity ? 1 : x / (1 + x)) },
    zones: { title: "False colour", apply: null },
  };

  /// Errors of a value a against the reference r; a pixel has the mean over its channels.
  ajar.errors = {
    absolute: { title: "Absolute error", formula: "|a − r|", low: -3, high: 1, of: (a, r) => Math.abs(a - r) },
    relative: {
      title: "Relative squared",
      formula: "(a − r)² / (r² + 0.01)",
      low: -4,
      high: 1,
      of: (a, r) => ((a - r) * (a - r)) / (r * r + 0.01),
    },
    smape: {
      title: "SMAPE",
      formula: "|a − r| / (|a| + |r|)",
      low: -3,
      high: 0,
      of: (a, r) => Math.abs(a - r) / Math.max(Math.abs(a) + Math.abs(r), 1e-6),
    },
  };
  /// Values that are not finite show like this in every mode.
  ajar.notFinite = [1, 0, 1];
}
