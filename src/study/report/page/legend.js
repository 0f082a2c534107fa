// The colour bar of error maps and false colour.
"use strict";
{
  const css = (rgb) => `rgb(${rgb.map((x) => Math.round(255 * x)).join(" ")})`;
  const superscript = (n) => String(n).replace(/./g, (c) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[c] ?? "⁻");
  const decade = (n) => (n >= -2 && n <= 3 ? String(Number((10 ** n).toPrecision(1))) : `10${superscript(n)}`);

  const ticks = (values, low, high) =>
    values.map(([value, text]) =>
      ajar.element("span", { style: `left:${(100 * (value - low)) / (high - low)}%` }, text),
    );
  const bar = (background, marks) => [
    ajar.element("div", { class: "legend-bar", style: `background:${background}` }),
    ajar.element("div", { class: "legend-ticks" }, ...marks),
  ];

  const errorLegend = (display) => {
    const { title, formula } = ajar.errors[display.map];
    const { low, high } = ajar.errorRange(display);
    const stops = ajar.maps.ember.filter((_, i) => i % 15 === 0).map(css);
    const marks = [];
    for (let n = low; n <= high; ++n) marks.push([n, decade(n)]);
    const shift = (by) => () => ajar.set({ shift: ajar.clamp(ajar.state.shift + by, -12, 12) });
    return [
      ajar.element("p", {}, ajar.element("strong", {}, title), ` ${formula}`),
      ...bar(`linear-gradient(90deg, ${stops.join(", ")})`, ticks(marks, low, high)),
      ajar.element("p", { class: "legend-buttons" },
        ajar.element("button", { onclick: shift(-1), title: "Show smaller errors (,)" }, "÷10"),
        ajar.element("button", { onclick: shift(1), title: "Show larger errors (.)" }, "×10"),
        ajar.element("span", { class: "swatch", style: `background:${css(ajar.notFinite)}` }), " not finite"),
    ];
  };

  const zoneLegend = () => {
    const { zones, zoneStops } = ajar.maps;
    const share = 100 / zones.length;
    const bands = zones.map((rgb, i) => `${css(rgb)} ${i * share}% ${(i + 1) * share}%`);
    const marks = zones
      .map((_, i) => [i + 0.5, `${i > zoneStops ? "+" : ""}${i - zoneStops}`.replace("-", "−")])
      .filter((_, i) => i % 2 === 0);
    return [
      ajar.element("p", {}, ajar.element("strong", {}, "Luminance"), " in stops from middle grey (0.18)"),
      ...bar(`linear-gradient(90deg, ${bands.join(", ")})`, ticks(marks, 0, zones.length)),
    ];
  };

  ajar.showLegend = () => {
    const { map, tone } = ajar.state;
    const legend = ajar.find("legend");
    legend.hidden = map === "colour" && tone !== "zones";
    if (!legend.hidden) legend.replaceChildren(...(map === "colour" ? zoneLegend() : errorLegend(ajar.state)));
  };
}
