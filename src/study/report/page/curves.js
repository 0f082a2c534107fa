// Metrics over time or over the values of a parameter, log-log, with error bands and values under the cursor.
"use strict";
{
  const kWidth = 720;
  const kHeight = 420;
  const kMargin = { left: 66, right: 178, top: 16, bottom: 46 };
  const kDashes = ["", "7 4", "2 3", "9 3 2 3"];
  const superscript = (n) => String(n).replace(/./g, (c) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[c] ?? "⁻");

  /// A name has the same colour and dash on every chart; after all colours the dash changes.
  const styles = () => {
    const names = [...new Set(ajar.data.curves.map(({ name }) => name))];
    const count = 6; // of the palette: those that both backgrounds carry
    return new Map(names.map((name, i) => [name, { series: i % count, dash: kDashes[Math.floor(i / count) % kDashes.length] }]));
  };

  /// A piece of the curve, as it looks on the charts.
  const key = ({ series, dash }) =>
    ajar.element("svg", { class: `key series-${series}`, viewBox: "0 0 28 8", "aria-hidden": "true" },
      ajar.element("path", { class: "curve", d: "M0 4H28", "stroke-dasharray": dash || undefined }));

  const usable = ([at, mean]) => at > 0 && mean > 0 && Number.isFinite(at) && Number.isFinite(mean);

  /// {name, points: [{at, mean, low, high}]}, sorted, without what a logarithm cannot show.
  const prepare = (curve) => {
    const all = curve.points.map((point) => point.map(ajar.number));
    const points = all
      .filter(usable)
      .sort((a, b) => a[0] - b[0])
      .map(([at, mean, low, high]) => ({ at, mean, low, high: Number.isFinite(high) ? high : mean }));
    return { name: curve.name, points, dropped: all.length - points.length };
  };

  const range = (values) => {
    const logs = values.map(Math.log10);
    const low = Math.min(...logs);
    const high = Math.max(...logs);
    const pad = Math.max((high - low) * 0.04, 0.02);
    return { low: low - pad, high: high + pad };
  };

  const makeScales = (curves) => {
    const points = curves.flatMap((curve) => curve.points);
    const x = range(points.map(({ at }) => at));
    // A band may reach down to zero; it is then cut, a decade under the lowest mean.
    const floor = Math.min(...points.map(({ mean }) => mean)) / 10;
    const y = range(points.flatMap(({ mean, low, high }) => [mean, Math.max(high, mean), Math.max(low, floor) || mean]));
    const right = kWidth - kMargin.right;
    const bottom = kHeight - kMargin.bottom;
    return {
      x: (value) => kMargin.left + ((Math.log10(value) - x.low) / (x.high - x.low)) * (right - kMargin.left),
      y: (value) => bottom - ((ajar.clamp(Math.log10(Math.max(value, 1e-300)), y.low, y.high) - y.low) / (y.high - y.low)) * (bottom - kMargin.top),
      xRange: x,
      yRange: y,
    };
  };

  /// Four to ten multiples of 1, 2 or 5 times a power of ten.
  const evenTicks = (low, high) => {
    const rough = (high - low) / 4;
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = [5, 2, 1].find((factor) => rough / power >= factor) * power;
    const first = Math.ceil(low / step);
    return Array.from({ length: Math.max(0, Math.floor(high / step) - first + 1) }, (_, i) => (first + i) * step);
  };

  /// 1, 2, 5 of each decade; the fewer the more decades. Equal steps where even those would be few.
  const tickValues = ({ low, high }) => {
    if (high - low < 0.7) return evenTicks(10 ** low, 10 ** high);
    const factors = high - low > 3 ? [1] : [1, 2, 5];
    const values = [];
    for (let decade = Math.floor(low); decade <= high; ++decade) {
      for (const factor of factors) {
        const value = factor * 10 ** decade;
        if (Math.log10(value) >= low && Math.log10(value) <= high) values.push(value);
      }
    }
    return values;
  };
  const tickText = (value) => {
    const decade = Math.floor(Math.log10(value) + 1e-9);
    if (decade >= -3 && decade <= 4) return String(Number(value.toPrecision(4)));
    const factor = Number((value / 10 ** decade).toPrecision(4));
    return `${factor === 1 ? "" : `${factor}·`}10${superscript(decade)}`;
  };

  const axes = (scales, metric, over) => {
    const right = kWidth - kMargin.right;
    const bottom = kHeight - kMargin.bottom;
    const nodes = [];
    for (const value of tickValues(scales.xRange)) {
      const x = scales.x(value);
      nodes.push(ajar.element("line", { class: "grid", x1: x, x2: x, y1: kMargin.top, y2: bottom }),
        ajar.element("text", { x, y: bottom + 18, "text-anchor": "middle" }, tickText(value)));
    }
    for (const value of tickValues(scales.yRange)) {
      const y = scales.y(value);
      nodes.push(ajar.element("line", { class: "grid", x1: kMargin.left, x2: right, y1: y, y2: y }),
        ajar.element("text", { x: kMargin.left - 8, y: y + 4, "text-anchor": "end" }, tickText(value)));
    }
    nodes.push(
      ajar.element("path", { class: "axis", d: `M${kMargin.left} ${kMargin.top}V${bottom}H${right}` }),
      ajar.element("text", { class: "axis-title", x: (kMargin.left + right) / 2, y: kHeight - 6, "text-anchor": "middle" }, over),
      ajar.element("text", { class: "axis-title", x: 16, y: (kMargin.top + bottom) / 2, "text-anchor": "middle", transform: `rotate(-90 16 ${(kMargin.top + bottom) / 2})` }, metric));
    return nodes;
  };

  const line = (points, x, y) => points.map((point, i) => `${i === 0 ? "M" : "L"}${x(point).toFixed(1)} ${y(point).toFixed(1)}`).join("");

  const drawCurve = ({ name, points }, scales, style) => {
    const x = ({ at }) => scales.x(at);
    const upper = line(points, x, ({ high, mean }) => scales.y(Math.max(high, mean)));
    const lower = line([...points].reverse(), x, ({ low, mean }) => scales.y(Math.min(low || 1e-300, mean))).replace(/^M/, "L");
    return ajar.element("g", { class: `series series-${style.series}`, "data-name": name },
      ajar.element("path", { class: "band", d: `${upper}${lower}Z` }),
      ajar.element("path", { class: "curve", d: line(points, x, ({ mean }) => scales.y(mean)), "stroke-dasharray": style.dash || undefined }),
      ...points.map((point) => ajar.element("circle", { class: "dot", cx: x(point), cy: scales.y(point.mean), r: points.length > 40 ? 0 : 2.5 })));
  };

  /// Names at the ends of the curves, moved apart where they would overlap.
  const endLabels = (curves, scales, style) => {
    const labels = curves
      .filter(({ points }) => points.length > 0)
      .map((curve) => ({ curve, last: curve.points.at(-1) }))
      .map(({ curve, last }) => ({ name: curve.name, x: scales.x(last.at), y: scales.y(last.mean), place: scales.y(last.mean) }))
      .sort((a, b) => a.place - b.place);
    const bottom = kHeight - kMargin.bottom;
    labels.forEach((label, i) => {
      if (i > 0) label.place = Math.max(label.place, labels[i - 1].place + 15);
    });
    for (let i = labels.length - 1; i >= 0; --i) {
      labels[i].place = Math.min(labels[i].place, i === labels.length - 1 ? bottom : labels[i + 1].place - 15);
    }
    const right = kWidth - kMargin.right;
    const short = (name) => (name.length > 22 ? `${name.slice(0, 21)}…` : name);
    return labels.map(({ name, x, y, place }) =>
      ajar.element("g", { class: `series series-${style.get(name).series}`, "data-name": name },
        ajar.element("path", { class: "leader", d: `M${x + 4} ${y}L${right + 10} ${place}` }),
        ajar.element("text", { class: "end-label", x: right + 14, y: place + 4 }, short(name))));
  };

  const nearest = (points, at) =>
    points.reduce((best, point) => (Math.abs(Math.log(point.at / at)) < Math.abs(Math.log(best.at / at)) ? point : best), points[0]);

  const makeHover = (svg, curves, scales, style, readout, unit) => {
    const rule = ajar.element("line", { class: "rule", y1: kMargin.top, y2: kHeight - kMargin.bottom, visibility: "hidden" });
    svg.append(rule);
    const right = kWidth - kMargin.right;
    /// At a horizontal place of the chart.
    const show = (place) => {
      const share = (place - kMargin.left) / (right - kMargin.left);
      const at = 10 ** (scales.xRange.low + share * (scales.xRange.high - scales.xRange.low));
      for (const end of ["x1", "x2"]) rule.setAttribute(end, place);
      const shown = curves.filter(({ name, points }) => points.length > 0 && !svg.querySelector(`.off[data-name="${CSS.escape(name)}"]`));
      const values = shown.map(({ name, points }) => ({ name, point: nearest(points, at) })).sort((a, b) => a.point.mean - b.point.mean);
      readout.replaceChildren(...values.map(({ name, point }) =>
        ajar.element("tr", {},
          ajar.element("th", { scope: "row" }, key(style.get(name)), name),
          ajar.element("td", { class: "number" }, `${ajar.format(point.at, 3)}${unit}`),
          ajar.element("td", { class: "number" }, ajar.format(point.mean)),
          ajar.element("td", { class: "number" }, `${ajar.format(point.low, 3)} … ${ajar.format(point.high, 3)}`))));
    };
    svg.addEventListener("pointermove", (event) => {
      const box = svg.getBoundingClientRect();
      rule.setAttribute("visibility", "visible");
      show(ajar.clamp(((event.clientX - box.left) / box.width) * kWidth, kMargin.left, right));
    });
    const showEnd = () => {
      rule.setAttribute("visibility", "hidden");
      show(right);
    };
    svg.addEventListener("pointerleave", showEnd);
    return showEnd;
  };

  const makeSwitches = (svg, curves, style, changed) =>
    curves.map(({ name }) => {
      const toggle = (event) => {
        for (const node of svg.querySelectorAll(`[data-name="${CSS.escape(name)}"]`)) node.classList.toggle("off", !event.target.checked);
        changed();
      };
      return ajar.element("label", { class: "switch" },
        ajar.element("input", { type: "checkbox", checked: true, onchange: toggle }),
        key(style.get(name)), name);
    });

  const makeChart = ({ metric, over, description }, curves, style) => {
    const isTime = over === "seconds";
    const dropped = curves.reduce((sum, curve) => sum + curve.dropped, 0);
    const figure = ajar.element("figure", { class: "chart" },
      ajar.element("figcaption", {}, ajar.element("strong", {}, metric), description ? ` ${description}` : ""));
    if (curves.every(({ points }) => points.length === 0)) {
      figure.append(ajar.element("p", {}, "No point of these curves is positive and finite: nothing to draw."));
      return figure;
    }
    const scales = makeScales(curves);
    const svg = ajar.element("svg", { viewBox: `0 0 ${kWidth} ${kHeight}`, role: "img", "aria-label": `${metric} over ${over}, both logarithmic; values in the table below` });
    svg.append(...axes(scales, metric, over), ...curves.map((curve) => drawCurve(curve, scales, style.get(curve.name))), ...endLabels(curves, scales, style));
    const readout = ajar.element("tbody");
    const showEnd = makeHover(svg, curves, scales, style, readout, isTime ? " s" : "");
    figure.append(svg,
      ajar.element("div", { class: "switches" }, ...makeSwitches(svg, curves, style, showEnd)),
      ajar.element("div", { class: "scroll" }, ajar.element("table", { class: "data readout" },
        ajar.element("thead", {}, ajar.element("tr", {}, ...["Method", isTime ? "Time" : over, metric, "Band"].map((text, i) => ajar.element("th", { scope: "col", class: i > 0 ? "number" : undefined }, text)))),
        readout)));
    if (dropped > 0) figure.append(ajar.element("p", { class: "quiet" }, `${dropped} point${dropped === 1 ? " is" : "s are"} not drawn: zero, negative or not finite.`));
    showEnd();
    return figure;
  };

  /// One figure per parameter and metric; `ofTime` chooses those over time or the others.
  ajar.makeCharts = (ofTime) => {
    const style = styles();
    const charts = new Map();
    for (const curve of ajar.data.curves) {
      if ((curve.over === "seconds") !== ofTime) continue;
      const key = JSON.stringify([curve.over, curve.metric]);
      charts.set(key, [...(charts.get(key) ?? []), curve]);
    }
    return [...charts.values()].map((curves) => makeChart(curves[0], curves.map(prepare), style));
  };
}
